//! The rules of 1993: blocks as H. R. Zatz computed them ("Galerkin radiosity", SIGGRAPH 93), for comparison.
//!
//! Both patches are charted by [−1, 1]², the receiver by (s, t), the emitter by (u, v). Without reflectance,
//! the light that arrives from a function φ_l of the emitter is
//!
//! ```text
//! H_l(s, t) = ∬ κ A_j(u, v) φ_l(u, v) du dv ,     A_j = |x_u × x_v| .
//! ```
//!
//! **Legendre** (eq. 26) sums this over n Gauss–Legendre points in each of the four parameters. The text says
//! n = N + 1; the numbers it quotes fit n = N + 2. Across a common edge κ has a double pole, and no n helps.
//!
//! **Hybrid** (section 4.2, eq. 27), for patches with a whole edge in common: the receiver's functions are
//! R_k, polynomials of degree N that are orthonormal for a weight W that vanishes doubly at the edge,
//!
//! ```text
//! h_l = Σ_k R_k ∬ R_k W H_l ds dt ,
//! ```
//!
//! and h_l is converted to the stored functions without loss, since each R_k is a polynomial. In other words
//! h_l is the polynomial of degree N nearest to H_l for the weight W, as which it is found here: by least
//! squares at the points of the rule. Let the edge lie at t = −1 and v = −1:
//!
//! ```text
//!            W                    points of the receiver, of the emitter
//! H1         (1 − s²)² (1 + t)²   Jacobi × Jacobi, Legendre × Legendre
//! H2         (1 + t)²             Legendre × Jacobi twice, emitter's weights over (1 + v)²
//! H3         (1 + t)²             Legendre × Jacobi, Legendre × Legendre
//! literal    as H2, but nothing divided out: it computes ∬ κ A_j φ_l (1 + v)² du dv instead
//! ```
//!
//! The paper does not say which of these it used. Of its two numbers for perpendicular squares, 1.4 % at
//! N = 4 and at N = 5, H1 gives both with n = N + 2 (1.415, 1.430) and H2 with n = N + 3 (1.373, 1.371).
//! Taken literally, eq. 27 gives 38.7 % at any N: the mean of |E_w − E|/E with E_w the irradiance from an
//! emitter of radiosity (1 + v)². None of them converges: the weight moves points away from the edge, but the
//! pole stays. Pairs without a common edge use Legendre.
//!
//! **Pieces.** An element is covered by parallelograms and triangles, or is one rectangle of the parameters
//! of a curved surface. Each piece is charted by itself, a triangle with t = 1 collapsed to a corner, and
//! what it receives is projected on the element's functions, with respect to area. Weights of a triangle are
//! times its area element. On a curved receiver the paper projects in the parameters, so that even exact
//! integrals give another G than projection with respect to area.
//!
//! **T-contacts** (sections 4.2 and 9): where one flat piece ends on another, or only a part of two edges
//! meets, both are cut, for this pair, along the line of contact and at its ends, until they have whole edges
//! in common (`contact`). The paper cuts the surfaces themselves; here the functions stay those of the
//! whole. Contacts along curves are ignored unless they are whole sides of both.
//!
//! G is not symmetric: receiver and emitter are treated differently, so each ordered pair is integrated by
//! itself.

mod rules;
mod axis;
mod piece;
mod contact;
mod side;
mod sum;
mod transfer;
mod assembly;

pub use assembly::assemble;
pub(crate) use piece::Piece;
pub use rules::{HybridReading, PaperRules};
pub(crate) use side::Side;

#[cfg(test)]
mod tests;
