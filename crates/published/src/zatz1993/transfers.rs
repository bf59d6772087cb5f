//! The rules of 1993: blocks as H. R. Zatz computed them ("Galerkin radiosity", SIGGRAPH 93), for comparison.
//!
//! Both patches are charted by [−1, 1]², the receiver by (s, t), the emitter by (u, v), and carry
//! T_k = p_a(s) p_b(t), a + b ≤ N, orthonormal in the parameters, not with respect to area. Without
//! reflectance,
//!
//! ```text
//! K^kl = ∬ T_k(s, t) ∬ κ A_j(u, v) T_l(u, v) du dv ds dt ,     B_i^k = Σ_l K^kl B_j^l ,     A_j = |x_u × x_v| .
//! ```
//!
//! **Legendre** (eq. 26) sums this over n Gauss–Legendre points in each of the four parameters. The text says
//! n = N + 1; the numbers it quotes fit n = N + 2. Across a common edge κ has a double pole, and no n helps.
//!
//! **Hybrid** (section 4.2, eq. 27), for patches with a whole edge in common: the receiver's functions are
//! R_k, orthonormal for a weight W that vanishes doubly at the edge, and are converted to T_m without loss
//! afterwards, since each R_k is a polynomial. Let the edge lie at t = −1 and v = −1; p_n^(α,β) is
//! orthonormal for (1 − x)^α (1 + x)^β.
//!
//! ```text
//! K_J^kl = ∬ R_k W ∬ κ A_j T_l du dv ds dt ,     K^ml = Σ_k K_J^kl ∬ T_m R_k ds dt .
//!
//!            W                    R                        points of the receiver, of the emitter
//! H1         (1 − s²)² (1 + t)²   p_p^(2,2)(s) p_q^(0,2)(t)   Jacobi × Jacobi, Legendre × Legendre
//! H2         (1 + t)²             p_p(s) p_q^(0,2)(t)         Legendre × Jacobi twice, emitter's weights over (1 + v)²
//! H3         (1 + t)²             p_p(s) p_q^(0,2)(t)         Legendre × Jacobi, Legendre × Legendre
//! literal    as H2, but nothing divided out: it computes ∬ κ A_j T_l (1 + v)² du dv instead
//! ```
//!
//! The paper does not say which of these it used. Of its two numbers for perpendicular squares, 1.4 % at
//! N = 4 and at N = 5, H1 gives both with n = N + 2 (1.415, 1.430) and H2 with n = N + 3 (1.373, 1.371).
//! Taken literally, eq. 27 gives 38.7 % at any N: the mean of |E_w − E|/E with E_w the irradiance from an
//! emitter of radiosity (1 + v)². None of them converges: the weight moves points away from the edge, but the
//! pole stays. An edge at +1 exchanges α and β, one along t exchanges the parameters; pairs without a whole
//! common edge use Legendre.
//!
//! K is not symmetric, even between parallelograms, whose K^00 is the form factor F_ij: receiver and emitter
//! are treated differently, so each ordered pair is integrated by itself. The blocks G, with respect to area,
//! follow from the bases' triangular transforms (`Chart`); between parallelograms G = √(A_i/A_j) K.

mod axis;
mod border;
mod charted_element;
mod chart;
mod sum;
mod transfer;
mod assembly;

pub use assembly::assemble;
pub use chart::NoChart;
pub use charted_element::ChartedElement;
pub use sum::Sees;
pub use transfer::{HybridReading, PaperRules, Transfer, transfer};

/// Points per direction above the order that reproduce the numbers of the paper (header).
pub const EXTRA_POINTS: usize = 2;
