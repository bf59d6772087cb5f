//! The triangle (−1, −1), (1, −1), (−1, 1): Dubiner's basis and its collapsed Gauss rule.
//!
//! With a = 2 (1 + s)/(1 − t) − 1, which maps the triangle to the square,
//!
//! ```text
//! ψ_ij(s, t) = √((i + ½)(i + j + 1)) · Q_i(s, t) · P_j^(2i+1,0)(t),   Q_i = ((1 − t)/2)ⁱ P_i(a),   i + j ≤ N
//! ```
//!
//! is orthonormal: ∬ ψ_ij ψ_kl ds dt = δ. Q_i is a polynomial whose recurrence has no singularity at the
//! vertex t = 1:
//!
//! ```text
//! (i + 1) Q_{i+1} = (2i + 1) z Q_i − i c² Q_{i−1},   z = (1 + 2s + t)/2,   c = (1 − t)/2
//! ```
//!
//! P_j^(α,0) with α = 2i + 1 and e = 2j + α:
//!
//! ```text
//! 2 (j + 1)(j + α + 1) e P_{j+1} = (e + 1)(α² + e (e + 2) t) P_j − 2 j (j + α)(e + 2) P_{j−1}
//! ```
//!
//! Order: as in the square, k = d (d + 1)/2 + j with d = i + j ([`total::index`]).
//!
//! Reference: M. Dubiner, "Spectral methods on triangles and other domains", J. Sci. Comput. 6 (1991).

use super::total;
use crate::gauss::Rule;
use crate::jacobi::Weight;
use crate::legendre::end;
use crate::math::sqrt;

/// One number per lane.
type Lane<const W: usize> = [f64; W];

/// Writes ψ_k(s, t), k = 0 … [`total::count`]`(order)` − 1.
///
/// # Panics
/// If `out.len() != total::count(order)`.
pub fn values(order: usize, s: f64, t: f64, out: &mut [f64]) {
    tile(order, &[s], &[t], out.as_chunks_mut().0);
}

/// Writes ψ_k, ∂ψ_k/∂s and ∂ψ_k/∂t at (s, t).
///
/// # Panics
/// If a slice does not have [`total::count`]`(order)` entries.
pub fn gradients(order: usize, s: f64, t: f64, out: &mut [f64], by_s: &mut [f64], by_t: &mut [f64]) {
    check(order, out.len());
    check(order, by_s.len());
    check(order, by_t.len());
    let t = [t];
    let mut across = Across::new(&[s], &t);
    for i in 0..=order {
        let mut along = Along::new(i, &t);
        for j in 0..=order - i {
            let (k, norm) = (total::index(i, j), norm(i, j));
            let ([p], [dp]) = (along.value, along.slope);
            out[k] = norm * across.value[0] * p;
            by_s[k] = norm * across.by_s[0] * p;
            by_t[k] = norm * (across.by_t[0] * p + across.value[0] * dp);
            along.advance();
        }
        across.advance();
    }
}

/// `out[k][l]` = `ψ_k(s[l], t[l])`, W = 8 or 16 points side by side.
///
/// # Panics
/// If `out.len() != total::count(order)`.
#[inline]
pub fn tile<const W: usize>(order: usize, s: &[f64; W], t: &[f64; W], out: &mut [[f64; W]]) {
    check(order, out.len());
    let mut across = Across::new(s, t);
    for i in 0..=order {
        let mut along = Along::new(i, t);
        for j in 0..=order - i {
            let norm = norm(i, j);
            let row = &mut out[total::index(i, j)];
            for (l, value) in row.iter_mut().enumerate() {
                *value = norm * across.value[l] * along.value[l];
            }
            along.advance();
        }
        across.advance();
    }
}

fn check(order: usize, length: usize) {
    assert_eq!(length, total::count(order), "one entry per function of total degree ≤ {order}");
}

/// √((i + ½)(i + j + 1)).
fn norm(i: usize, j: usize) -> f64 {
    end(i) * sqrt((i + j + 1) as f64)
}

/// Q_i with its gradient, on the way along i.
struct Across<const W: usize> {
    i: usize,
    z: Lane<W>,
    c: Lane<W>,
    value: Lane<W>,
    by_s: Lane<W>,
    by_t: Lane<W>,
    before: [Lane<W>; 3],
}

impl<const W: usize> Across<W> {
    fn new(s: &Lane<W>, t: &Lane<W>) -> Across<W> {
        let (mut z, mut c) = ([0.0; W], [0.0; W]);
        for l in 0..W {
            z[l] = 0.5 * (1.0 + 2.0 * s[l] + t[l]);
            c[l] = 0.5 * (1.0 - t[l]);
        }
        let zero = [0.0; W];
        Across { i: 0, z, c, value: [1.0; W], by_s: zero, by_t: zero, before: [zero; 3] }
    }

    #[inline]
    fn advance(&mut self) {
        let i = self.i as f64;
        let (f, g) = ((2.0 * i + 1.0) / (i + 1.0), i / (i + 1.0));
        let (last, before) = ([self.value, self.by_s, self.by_t], self.before);
        for l in 0..W {
            let (z, c) = (f * self.z[l], g * self.c[l]);
            let [q, qs, qt] = [last[0][l], last[1][l], last[2][l]];
            let [r, rs, rt] = [before[0][l], before[1][l], before[2][l]];
            self.value[l] = z * q - c * self.c[l] * r;
            self.by_s[l] = f * q + z * qs - c * self.c[l] * rs;
            self.by_t[l] = 0.5 * f * q + z * qt + c * (r - self.c[l] * rt);
        }
        self.before = last;
        self.i += 1;
    }
}

/// P_j^(2i+1,0)(t) with its derivative, on the way along j.
struct Along<'a, const W: usize> {
    alpha: f64,
    j: usize,
    t: &'a Lane<W>,
    value: Lane<W>,
    slope: Lane<W>,
    before: [Lane<W>; 2],
}

impl<'a, const W: usize> Along<'a, W> {
    fn new(i: usize, t: &'a Lane<W>) -> Along<'a, W> {
        let zero = [0.0; W];
        Along { alpha: (2 * i + 1) as f64, j: 0, t, value: [1.0; W], slope: zero, before: [zero; 2] }
    }

    #[inline]
    fn advance(&mut self) {
        let (j, alpha) = (self.j as f64, self.alpha);
        let e = 2.0 * j + alpha;
        let below = 1.0 / (2.0 * (j + 1.0) * (j + alpha + 1.0) * e);
        let rise = (e + 1.0) * e * (e + 2.0) * below;
        let rest = (e + 1.0) * alpha * alpha * below;
        let back = 2.0 * j * (j + alpha) * (e + 2.0) * below;
        let (last, before) = ([self.value, self.slope], self.before);
        for l in 0..W {
            let factor = rise * self.t[l] + rest;
            self.value[l] = factor * last[0][l] - back * before[0][l];
            self.slope[l] = rise * last[0][l] + (factor * last[1][l] - back * before[1][l]);
        }
        self.before = last;
        self.j += 1;
    }
}

/// The N² points of the collapsed Gauss rule: Legendre in a, Jacobi (1, 0) in t.
///
/// Exact on the triangle to total degree 2N − 1; the weights are positive, of sum 2, the area.
///
/// ```
/// use radiosity_core::basis::triangle::Collapsed;
///
/// const RULE: Collapsed<3> = Collapsed::new();
/// // ∬ s² ds dt = 2/3.
/// let moment: f64 = RULE.points().map(|point| point.weight * point.s * point.s).sum();
/// assert!((moment - 2.0 / 3.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Collapsed<const N: usize> {
    across: Rule<N>,
    along: Rule<N>,
}

impl<const N: usize> Collapsed<N> {
    /// The rule of N × N points.
    pub const fn new() -> Collapsed<N> {
        Collapsed { across: Rule::legendre(), along: Rule::jacobi(Weight::integer(1, 0)) }
    }

    /// Every point.
    pub fn points(&self) -> impl Iterator<Item = WeightedPoint> {
        let along = self.along.nodes.iter().zip(&self.along.weights);
        along.flat_map(|(&t, &w)| {
            let across = self.across.nodes.iter().zip(&self.across.weights);
            across.map(move |(&a, &v)| collapse((a, v), (t, w)))
        })
    }
}

impl<const N: usize> Default for Collapsed<N> {
    fn default() -> Self {
        Collapsed::new()
    }
}

/// A point of a rule on the triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedPoint {
    /// First coordinate.
    pub s: f64,
    /// Second coordinate.
    pub t: f64,
    /// Weight; those of a rule sum to the area 2.
    pub weight: f64,
}

/// Node and weight of a Legendre rule, node and weight of a Jacobi (1, 0) rule → their point on the triangle.
pub const fn collapse(across: (f64, f64), along: (f64, f64)) -> WeightedPoint {
    let (t, c) = (along.0, 0.5 * (1.0 - along.0));
    WeightedPoint { s: (1.0 + across.0) * c - 1.0, t, weight: 0.5 * across.1 * along.1 }
}
