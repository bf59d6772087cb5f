//! Rules of constant length, computed by the compiler or at run time.

use super::jacobi::jacobi;
use super::legendre::legendre;
use crate::jacobi::Weight;

/// N nodes, ascending in (−1, 1), and their weights, positive.
///
/// The constructors are `const`: a rule bound to a `const` costs nothing at run time, and holds the same bits
/// as the one made at run time. N = 0 does not compile.
///
/// ```
/// use radiosity_core::{gauss::Rule, jacobi::Weight};
///
/// // ∫₋₁¹ f(x) √(1 − x) dx to degree 9, without a Γ function or a square root at run time.
/// const HALF: Result<Weight, radiosity_core::jacobi::WeightError> = Weight::new(0.5, 0.0);
/// const RULE: Rule<5> = match HALF {
///     Ok(weight) => Rule::jacobi(weight),
///     Err(_) => panic!(),
/// };
/// let integral = RULE.sum(|_| 1.0);
/// assert!((integral - 32.0f64.sqrt() / 3.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule<const N: usize> {
    /// The nodes, ascending.
    pub nodes: [f64; N],
    /// The weights, in the order of the nodes.
    pub weights: [f64; N],
}

impl<const N: usize> Rule<N> {
    const EMPTY: Rule<N> = {
        assert!(N > 0, "a Gauss rule has at least one node");
        Rule { nodes: [0.0; N], weights: [0.0; N] }
    };

    /// The Gauss–Legendre rule, as [`legendre`] writes it.
    pub const fn legendre() -> Rule<N> {
        let mut rule = Self::EMPTY;
        assert!(legendre(&mut rule.nodes, &mut rule.weights).is_ok());
        rule
    }

    /// The Gauss rule of the weight (1 − x)^α (1 + x)^β, as [`jacobi`](super::jacobi()) writes it.
    ///
    /// # Panics
    /// If an exponent is too near −1 for N points ([`RuleError::NearEnd`](super::RuleError::NearEnd)).
    pub const fn jacobi(weight: Weight) -> Rule<N> {
        let mut rule = Self::EMPTY;
        assert!(jacobi(weight, &mut rule.nodes, &mut rule.weights).is_ok());
        rule
    }

    /// Σ wᵢ f(xᵢ).
    pub fn sum(&self, mut f: impl FnMut(f64) -> f64) -> f64 {
        self.nodes.iter().zip(&self.weights).map(|(&x, &w)| w * f(x)).sum()
    }
}

/// The Gauss–Legendre rule of N points on [−1, 1], computed by the compiler.
pub struct Legendre<const N: usize>;

impl<const N: usize> Legendre<N> {
    /// Nodes and weights.
    pub const RULE: Rule<N> = Rule::legendre();

    /// The nodes, ascending in (−1, 1).
    pub const NODES: [f64; N] = Self::RULE.nodes;

    /// The weights, positive, of sum 2.
    pub const WEIGHTS: [f64; N] = Self::RULE.weights;
}

/// The N-point Gauss rule of the weight (1 − x)^A (1 + x)^B on [−1, 1], computed by the compiler.
///
/// Real exponents, which cannot be const parameters, go through [`Rule::jacobi`].
pub struct Jacobi<const A: u8, const B: u8, const N: usize>;

impl<const A: u8, const B: u8, const N: usize> Jacobi<A, B, N> {
    /// Nodes and weights.
    pub const RULE: Rule<N> = Rule::jacobi(Weight::integer(A, B));

    /// The nodes, ascending in (−1, 1).
    pub const NODES: [f64; N] = Self::RULE.nodes;

    /// The weights, positive, of sum 2^(A+B+1) A! B! / (A + B + 1)!.
    pub const WEIGHTS: [f64; N] = Self::RULE.weights;
}
