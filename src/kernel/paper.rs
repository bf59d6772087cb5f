//! The rules of 1993: blocks as H. R. Zatz computed them ("Galerkin radiosity", SIGGRAPH 93), for comparison.
//!
//! Both patches are charted by [−1, 1]², the receiver by (s, t), the emitter by (u, v), and carry
//! T_k = p_a(s) p_b(t), a + b ≤ N, orthonormal in the parameters, not with respect to area. With reflectance left
//! out,
//!
//! ```text
//! K^kl = ∬ T_k(s, t) ∬ κ A_j(u, v) T_l(u, v) du dv ds dt ,     B_i^k = Σ_l K^kl B_j^l ,     A_j = |x_u × x_v| .
//! ```
//!
//! **Legendre** (eq. 26) sums this over n Gauss–Legendre points in each of the four parameters. The text says n = N + 1;
//! the numbers it quotes fit n = N + 2. Across a common edge κ has a double pole, and no n helps.
//!
//! **Hybrid** (section 4.2, eq. 27), for patches with a whole edge in common: the receiver's functions are R_k,
//! orthonormal for a weight W that vanishes doubly at the edge, and afterwards converted to T_m without loss, since
//! each R_k is a polynomial. Let the edge lie at t = −1 and v = −1; p_n^(α,β) is orthonormal for (1 − x)^α (1 + x)^β.
//!
//! ```text
//! K_J^kl = ∬ R_k W ∬ κ A_j T_l du dv ds dt ,     K^ml = Σ_k K_J^kl ∬ T_m R_k ds dt .
//!
//!            W                    R                        points of the receiver, of the emitter
//! H1         (1 − s²)² (1 + t)²   p_p^(2,2)(s) p_q^(0,2)(t)   Jacobi × Jacobi, Legendre × Legendre
//! H2         (1 + t)²             p_p(s) p_q^(0,2)(t)         Legendre × Jacobi twice, the emitter's weights over (1 + v)²
//! H3         (1 + t)²             p_p(s) p_q^(0,2)(t)         Legendre × Jacobi, Legendre × Legendre
//! literal    as H2, but nothing divided out: it computes ∬ κ A_j T_l (1 + v)² du dv instead
//! ```
//!
//! The paper does not say which of these it used. Of its two numbers for perpendicular squares, 1.4 % at N = 4 and
//! at N = 5, H1 gives both with n = N + 2 (1.415, 1.430) and H2 with n = N + 3 (1.373, 1.371); taken literally eq. 27 gives
//! 38.7 % at any N, the mean of |E_w − E|/E with E_w the irradiance of an emitter (1 + v)² bright. None of them converges:
//! the weight moves points away from the edge, but the pole stays. An edge at +1 exchanges α and β, one along t
//! exchanges the parameters; pairs without a whole common edge use Legendre.
//!
//! K is not symmetric, even between parallelograms, whose K^00 is the form factor F_ij: receiver and emitter are
//! treated differently, so that each ordered pair is integrated by itself. Blocks G, with respect to area, follow by the
//! bases' triangular transforms ([`Chart`]); between parallelograms G = √(A_i/A_j) K.

mod axis;
mod border;
mod chart;
mod party;
mod sum;

use radiosity_core::{basis::total, convert};

use axis::Axis;
use border::Border;
pub use chart::{Chart, NoChart};
pub use party::Party;
pub use sum::Sees;
use sum::Sum;

/// Points per direction above the order that reproduce the paper's numbers.
pub const EXTRA_POINTS: usize = 2;

/// Which of the paper's rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rules {
    /// Gauss–Legendre points for every pair (eq. 26).
    Legendre,
    /// Gauss–Jacobi points for pairs with a common edge (eq. 27), Gauss–Legendre for all others.
    Hybrid(Reading),
}

/// How eq. 27 is read; see the [module](self).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Weight (1 − s²)² (1 + t)², Gauss–Legendre points on the emitter: nearest to the paper's numbers.
    H1,
    /// Weight (1 + t)², Gauss–Jacobi points on the emitter with the weight divided out: nearest to the paper's text.
    H2,
    /// Weight (1 + t)², Gauss–Legendre points on the emitter.
    H3,
    /// As printed, the emitter's weight not divided out: wrong, whatever the number of points.
    Literal,
}

/// K between two patches and what it cost.
#[derive(Clone, Debug)]
pub struct Transfer {
    /// K^kl, row-major, the receiver's (N + 1)(N + 2)/2 functions by the emitter's, in the order of
    /// [`total`].
    pub values: Vec<f64>,
    /// Whether the patches have a whole edge in common.
    pub edge: bool,
    /// Kernel evaluations.
    pub samples: u64,
    /// Segments handed to the visibility test.
    pub rays: u64,
}

/// K^kl from `emitter` to `receiver`; `sees`, where given, tells whether nothing stands between two points.
///
/// # Panics
/// If a party has no points.
pub fn transfer(receiver: Party, emitter: Party, rules: Rules, sees: Option<Sees>) -> Transfer {
    let borders = border::common(receiver.patch, emitter.patch);
    let (rows, columns) = match (rules, borders) {
        (Rules::Hybrid(reading), Some([near, far])) => {
            (receiver_axes(receiver, reading, near), emitter_axes(emitter, reading, far))
        }
        _ => (plain(receiver), plain(emitter)),
    };
    let mut sum = Sum::new([receiver, emitter], sees);
    sum.add(&rows, &columns);
    let mut values = sum.values;
    to_legendre(&mut values, receiver.order, [rows[0].weight, rows[1].weight]);
    Transfer { values, edge: borders.is_some(), samples: sum.samples, rays: sum.rays }
}

fn plain(party: Party) -> [Axis; 2] {
    let axis = Axis::new(party.order, party.points, [0, 0]);
    [axis.clone(), axis]
}

fn receiver_axes(party: Party, reading: Reading, border: Border) -> [Axis; 2] {
    let along = match reading {
        Reading::H1 => [2, 2],
        Reading::H2 | Reading::H3 | Reading::Literal => [0, 0],
    };
    let across = Axis::new(party.order, party.points, border.double_zero());
    border.placed(Axis::new(party.order, party.points, along), across)
}

fn emitter_axes(party: Party, reading: Reading, border: Border) -> [Axis; 2] {
    let along = Axis::new(party.order, party.points, [0, 0]);
    let moved = || Axis::with_legendre(party.order, party.points, border.double_zero());
    let across = match reading {
        Reading::H1 | Reading::H3 => along.clone(),
        Reading::H2 => moved().divided(border.double_zero()),
        Reading::Literal => moved(),
    };
    border.placed(along, across)
}

/// Rows of K_J in the functions of two weights → rows of K in Legendre functions, column by column.
///
/// Conversion never raises a degree, so each direction is done by itself within the total degree.
fn to_legendre(values: &mut [f64], order: usize, [first, second]: [[u8; 2]; 2]) {
    let columns = values.len() / total::count(order);
    let mut line = vec![0.0; order + 1];
    let mut convert = |[a, b]: [u8; 2], other: usize, index: &dyn Fn(usize) -> usize| {
        if [a, b] == [0, 0] {
            return;
        }
        let line = &mut line[..=order - other];
        for l in 0..columns {
            line.iter_mut().enumerate().for_each(|(p, x)| *x = values[index(p) * columns + l]);
            convert::to_legendre(a, b, line);
            line.iter().enumerate().for_each(|(p, x)| values[index(p) * columns + l] = *x);
        }
    };
    for other in 0..=order {
        convert(first, other, &|p| total::index(p, other));
    }
    for other in 0..=order {
        convert(second, other, &|q| total::index(other, q));
    }
}
