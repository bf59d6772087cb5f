//! The variational functional whose minimum is the solution.
//!
//!   I(x) = ½ xᵀ A x − bᵀ x
//!
//! For symmetric positive definite A its only minimum is at A x* = b, where
//!
//!   I(x*) = −½ bᵀ x* ,   I(x) − I(x*) = ½ (x − x*)ᵀ A (x − x*) :
//!
//! half the square of the error in the norm of energy. Conjugate gradients lower it in every step, and a
//! solution from a larger space has a lower one (Ritz). Reference: L. Szirmay-Kalos, *Application of
//! variational calculus in the radiosity method*, Periodica Polytechnica El. Eng. 40 (1996), 123–138.

use crate::operator::Operator;
use crate::vector::dot;

/// I(x) = ½ xᵀ A x − bᵀ x; one product with A. `b` and `x` have as many entries as A has rows.
///
/// ```
/// use radiosity_solvers::{Dense, Partition, functional};
///
/// let a = Dense::new(Partition::points(2), vec![2.0, 1.0, 1.0, 2.0], true)?;
/// // The solution of A x = (3, 3) is (1, 1), where the functional is −½ · 6.
/// assert_eq!(functional(&a, &[3.0, 3.0], &[1.0, 1.0]), -3.0);
/// assert!(functional(&a, &[3.0, 3.0], &[1.1, 0.9]) > -3.0);
/// # Ok::<(), radiosity_solvers::SolveError>(())
/// ```
pub fn functional(a: &dyn Operator, b: &[f64], x: &[f64]) -> f64 {
    let mut image = vec![0.0; x.len()];
    a.apply(x, &mut image);
    0.5 * dot(x, &image) - dot(b, x)
}
