//! The largest value of a polynomial on [−1, 1]², with a proven bound.
//!
//! On a rectangle a polynomial of degrees n, m lies between the least and the largest of its coefficients
//! b_jk in Bernstein's basis, and those at the corners are its values there. A rectangle whose largest
//! coefficient is no larger than a value that is taken somewhere else cannot hold the maximum; all others are
//! halved (de Casteljau).
//!
//! The coefficients come from polar forms: that of u^i on [−1, 1] at degree n is, for j arguments 1 and n − j
//! arguments −1,
//!
//! ```text
//! K_i(j) = Σ_k (−1)^(i−k) C(j, k) C(n − j, i − k) / C(n, i) ,      |K_i(j)| ≤ 1 ,     b_jk = Σ c_il K_i(j) K_l(k) ,
//! ```
//!
//! so that rounding stays near Σ |c| times the precision of numbers. References: G. Farin, *Curves and
//! Surfaces for CAGD*, 5th edition (2002), chapters 4 and 5; R. Moore, *Methods and Applications of Interval
//! Analysis* (1979), section 6.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::polynomial::{Polynomial, Term};

/// Distance of the bound from a value that is taken, over Σ |c|, at which the search ends: the bound is as
/// much above the largest value at the most. With a smaller value a line of maxima takes all rectangles there
/// are.
const NEAR: f64 = 1e-9;

/// Most rectangles that are looked at: along a line of maxima 2¹⁷ of them came within 2.3·10⁻⁹ only. The bound
/// stays right, and is less sharp.
const MOST: usize = 1 << 18;

/// The largest value of a polynomial on [−1, 1]²: found and bounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Maximum {
    /// The largest value that was found.
    pub value: f64,
    /// Parameters (u, v) at which it is taken.
    pub at: [f64; 2],
    /// Upper bound of all values, proven.
    pub bound: f64,
}

/// The largest value of a polynomial of degrees up to 20 on [−1, 1]².
pub(super) fn maximum(polynomial: &Polynomial) -> Maximum {
    let size: f64 = polynomial.terms().iter().map(|term| term.factor.abs()).sum();
    let whole = Piece::whole(polynomial.terms());
    let mut best = Maximum { value: f64::NEG_INFINITY, at: [0.0; 2], bound: f64::NEG_INFINITY };
    whole.raise(&mut best);
    let mut pieces = BinaryHeap::from([whole]);
    let mut visited = 0;
    while let Some(piece) = pieces.pop() {
        best.bound = piece.most;
        if piece.most <= best.value + NEAR * size || visited > MOST {
            break;
        }
        visited += 2;
        for half in piece.halves() {
            half.raise(&mut best);
            pieces.push(half);
        }
    }
    Maximum { bound: best.bound.max(best.value), ..best }
}

/// A polynomial on a rectangle of parameters, in Bernstein's basis.
struct Piece {
    /// Degrees along u and along v.
    degrees: [usize; 2],
    /// Coefficients b_jk at j + (n + 1) k.
    coefficients: Vec<f64>,
    /// Corners [[u0, v0], [u1, v1]] of the rectangle.
    corners: [[f64; 2]; 2],
    /// The largest coefficient.
    most: f64,
    /// The axis along which it is halved next.
    axis: usize,
}

impl Piece {
    fn whole(terms: &[Term]) -> Self {
        let degree = |power: fn(&Term) -> u32| terms.iter().map(power).max().unwrap_or(0) as usize;
        let [n, m] = [degree(|term| term.u), degree(|term| term.v)];
        let mut coefficients = vec![0.0; (n + 1) * (m + 1)];
        for (index, coefficient) in coefficients.iter_mut().enumerate() {
            let [j, k] = [index % (n + 1), index / (n + 1)];
            let value =
                |term: &Term| term.factor * polar(n, term.u as usize, j) * polar(m, term.v as usize, k);
            *coefficient = terms.iter().map(value).sum();
        }
        Self::of([n, m], coefficients, [[-1.0; 2], [1.0; 2]], if n == 0 { 1 } else { 0 })
    }

    fn of(degrees: [usize; 2], coefficients: Vec<f64>, corners: [[f64; 2]; 2], axis: usize) -> Self {
        let most = coefficients.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { degrees, coefficients, corners, most, axis }
    }

    /// Takes the largest of the values at the corners for `best`, where it is larger.
    fn raise(&self, best: &mut Maximum) {
        let [n, m] = self.degrees;
        for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let value = self.coefficients[a * n + b * m * (n + 1)];
            if value > best.value {
                (best.value, best.at) = (value, [self.corners[a][0], self.corners[b][1]]);
            }
        }
    }

    fn halves(self) -> [Self; 2] {
        let (axis, [n, _]) = (self.axis, self.degrees);
        let degree = self.degrees[axis];
        let (lines, step, next) = match axis {
            0 => (self.degrees[1] + 1, 1, n + 1),
            _ => (n + 1, n + 1, 1),
        };
        let (mut low, mut high) = (self.coefficients.clone(), self.coefficients);
        for line in 0..lines {
            let at = |k: usize| line * next + k * step;
            // The upper half is made in place; its first number of each round belongs to the lower half.
            for round in 0..=degree {
                low[at(round)] = high[at(0)];
                for k in 0..degree - round {
                    high[at(k)] = 0.5 * (high[at(k)] + high[at(k + 1)]);
                }
            }
        }
        let [start, end] = self.corners;
        let middle = 0.5 * (start[axis] + end[axis]);
        let with = |mut corner: [f64; 2]| {
            corner[axis] = middle;
            corner
        };
        let other = if self.degrees[1 - axis] == 0 { axis } else { 1 - axis };
        [
            Self::of(self.degrees, low, [start, with(end)], other),
            Self::of(self.degrees, high, [with(start), end], other),
        ]
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Piece {}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Piece {
    fn cmp(&self, other: &Self) -> Ordering {
        self.most.total_cmp(&other.most)
    }
}

/// Polar form K_i(j) at degree n; the sums are whole numbers below 2⁵³ up to n = 20.
fn polar(n: usize, i: usize, j: usize) -> f64 {
    let sign = |k: usize| if (i - k).is_multiple_of(2) { 1.0 } else { -1.0 };
    let term = |k: usize| sign(k) * choose(j, k) * choose(n - j, i - k);
    (0..=i.min(j)).map(term).sum::<f64>() / choose(n, i)
}

/// Binomial coefficient C(n, k).
fn choose(n: usize, k: usize) -> f64 {
    if k > n { 0.0 } else { (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64) }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(terms: &[(u32, u32, f64)]) -> Polynomial {
        Polynomial::new(terms.iter().map(|&(u, v, factor)| Term { u, v, factor }))
    }

    #[test]
    fn maxima_known_in_closed_form_are_found() {
        for (terms, value) in [
            (&[(0, 0, 0.25)][..], 0.25),
            (&[(1, 0, 1.0), (0, 1, 1.0)], 2.0),
            // 1 − u² − v²
            (&[(0, 0, 1.0), (2, 0, -1.0), (0, 2, -1.0)], 1.0),
            // −(u − v − 0.3)², 0 along a line
            (&[(2, 0, -1.0), (0, 2, -1.0), (1, 1, 2.0), (1, 0, 0.6), (0, 1, -0.6), (0, 0, -0.09)], 0.0),
            // T₁₂, whose extremes are ±1
            (
                &[
                    (12, 0, 2048.0),
                    (10, 0, -6144.0),
                    (8, 0, 6912.0),
                    (6, 0, -3584.0),
                    (4, 0, 840.0),
                    (2, 0, -72.0),
                    (0, 0, 1.0),
                ],
                1.0,
            ),
            (&[], 0.0),
        ] {
            let polynomial = of(terms);
            let found = maximum(&polynomial);
            let size: f64 = terms.iter().map(|term| term.2.abs()).sum();
            let near = 2e-9 * size;
            assert!(
                (found.value - value).abs() <= near && found.bound >= value - 1e-12 * size,
                "{terms:?}: {found:?}"
            );
            assert!(found.bound - found.value <= near, "{terms:?}: {found:?}");
            assert!((polynomial.at(found.at) - found.value).abs() <= 1e-12 * size);
        }
    }

    proptest! {
        #[test]
        fn nothing_is_larger_than_the_bound(
            terms in prop::collection::vec((0u32..=7, 0u32..=5, -1.0..1.0f64), 1..6),
            places in prop::collection::vec((-1.0..=1.0f64, -1.0..=1.0f64), 200),
        ) {
            let polynomial = of(&terms);
            let found = maximum(&polynomial);
            for (u, v) in places {
                prop_assert!(polynomial.at([u, v]) <= found.bound + 1e-13);
            }
        }
    }
}
