//! Zeros of planar maps f: [0, 1]² → ℝ² in Bernstein form, f(s, t) = Σ fᵢⱼ Bᵢ(s) Bⱼ(t).
//!
//! A rectangle of parameters is tested after a linear change of coordinates of the plane that turns the mean
//! derivative of f into the identity. Then (1) where the coefficients lie on one side of an axis there
//! is no zero (they bound f); (2) where the coefficients of the derivative differ from the identity by at
//! most κ < 1 in the maximum norm, f is one-to-one and its only zero lies within κ/(1 − κ) |g| of the
//! centre's Newton estimate, g = f(½, ½); for κ ≤ 0.3 Newton's method reaches it; (3) else the rectangle is
//! halved across its longer side. Where the mean derivative is nearly singular (silhouettes, collapsed edges)
//! test (1) is repeated with the axes turned along the image's long side, where the bounds are tight. So
//! every zero is bracketed until it is proved single or its rectangle has shrunk to a point of the image.
//!
//! Compare Bézier clipping (Nishita, Sederberg, Kakimoto, *Ray tracing trimmed rational surface patches*,
//! 1990), which shrinks the rectangle by the hull instead of proving uniqueness.

use crate::bernstein::{combine, split, weights};
use glam::{DMat2, DVec2};

/// Below this deviation of the derivative from its mean, Newton's method takes over (header, test 2).
pub(crate) const NEARLY_LINEAR: f64 = 0.3;
/// Images smaller than this multiple of the whole are points, since rounding decides where they are: some
/// thousand roundings, as products of derivatives lose some digits. With a smaller value halving goes on
/// among rounding errors; with a larger value zeros are told less precisely.
const POINT: f64 = 1e-13;
/// Most rectangles of a search; only an edge-on sheet, which vanishes along a curve, comes near. An arbitrary
/// bound of the time that one ray takes: what is left then is not visited.
const BUDGET: usize = 4000;

/// Visits the zeros of the map with the coefficients `net[i][j]`, s along i, as (s, t); stops when `visit`
/// returns true. Zeros up to `outside` beyond [0, 1]² are visited too; one zero may be visited more than
/// once.
pub(crate) fn zeros<const M: usize, const N: usize>(
    net: &[[DVec2; N]; M],
    outside: f64,
    visit: impl FnMut(f64, f64) -> bool,
) {
    let extent = net.as_flattened().iter().map(|f| f.distance(net[0][0])).fold(0.0, f64::max);
    let mut search = Search { net, extent, outside, budget: BUDGET, visit };
    search.look(net, Cell { s: 0.0, t: 0.0, width: 1.0, height: 1.0 });
}

/// A rectangle of parameters: lowest s and t, width along s, height along t.
#[derive(Clone, Copy)]
struct Cell {
    s: f64,
    t: f64,
    width: f64,
    height: f64,
}

struct Search<'a, F, const M: usize, const N: usize> {
    net: &'a [[DVec2; N]; M],
    extent: f64,
    outside: f64,
    budget: usize,
    visit: F,
}

impl<F: FnMut(f64, f64) -> bool, const M: usize, const N: usize> Search<'_, F, M, N> {
    /// Searches one cell, where the map has the coefficients `part`; true to stop.
    fn look(&mut self, part: &[[DVec2; N]; M], cell: Cell) -> bool {
        if self.budget == 0 {
            return true;
        }
        self.budget -= 1;
        let mean = mean_derivative(part);
        let slack = DVec2::new(4.0 * self.outside / cell.width, 4.0 * self.outside / cell.height);
        let lengths = mean.x_axis.length() * mean.y_axis.length();
        let spans = mean.determinant().abs() / lengths.max(f64::MIN_POSITIVE);
        if spans > 1e-12 {
            let straight = transform(part, &mean.inverse());
            if misses(&straight, slack) {
                return false;
            }
            let bend = deviation(&straight);
            if bend <= NEARLY_LINEAR {
                return self.settle(&straight, bend, slack, cell);
            }
        }
        let apart = spans <= 0.1 && misses(&turned(part, &mean), DVec2::splat(POINT * self.extent));
        !apart && self.halve(part, cell)
    }

    /// The only zero of a nearly linear cell, if it lies in it.
    fn settle(&mut self, straight: &[[DVec2; N]; M], bend: f64, slack: DVec2, cell: Cell) -> bool {
        let center = value(straight, 0.5, 0.5).0;
        let reach = bend / (1.0 - bend) * center.abs().max_element();
        let estimate = DVec2::splat(0.5) - center;
        let beyond = (estimate - DVec2::splat(0.5)).abs() - DVec2::splat(0.5 + reach);
        if beyond.cmpgt(slack).any() {
            return false;
        }
        let margin = DVec2::splat(self.outside);
        let low = DVec2::new(cell.s, cell.t) - margin;
        let high = DVec2::new(cell.s + cell.width, cell.t + cell.height) + margin;
        let start = DVec2::new(cell.s + estimate.x * cell.width, cell.t + estimate.y * cell.height);
        let zero = self.newton(start.clamp(low, high), low, high);
        zero.is_some_and(|at| (self.visit)(at.x, at.y))
    }

    /// Newton's method on the whole map, kept within the cell; `None` where the zero is beyond the cell's
    /// border.
    fn newton(&self, mut at: DVec2, low: DVec2, high: DVec2) -> Option<DVec2> {
        for _ in 0..12 {
            let (f, derivative) = value(self.net, at.x, at.y);
            let step = derivative.inverse() * f;
            let next = at - step;
            at = next.clamp(low, high);
            // The next step would be of the order of the square of this one.
            if step.abs().max_element() <= 1e-8 {
                return (next.distance(at) <= self.outside).then_some(next);
            }
        }
        None
    }

    fn halve(&mut self, part: &[[DVec2; N]; M], cell: Cell) -> bool {
        let along_s =
            part.windows(2).flat_map(|w| w[0].iter().zip(&w[1])).map(|(a, b)| a.distance_squared(*b));
        let along_t = part.iter().flat_map(|row| row.windows(2)).map(|w| w[0].distance_squared(w[1]));
        let (long, high) = (along_s.fold(0.0, f64::max), along_t.fold(0.0, f64::max));
        let limit = POINT * self.extent;
        if long.max(high) <= limit * limit || cell.width.min(cell.height) < 1e-14 {
            return (self.visit)(cell.s + 0.5 * cell.width, cell.t + 0.5 * cell.height);
        }
        if long >= high {
            let [low, up] = split_s(part);
            let width = 0.5 * cell.width;
            self.look(&low, Cell { width, ..cell })
                || self.look(&up, Cell { s: cell.s + width, width, ..cell })
        } else {
            let [low, up] = split_t(part);
            let height = 0.5 * cell.height;
            self.look(&low, Cell { height, ..cell })
                || self.look(&up, Cell { t: cell.t + height, height, ..cell })
        }
    }
}

/// Means of ∂f/∂s and ∂f/∂t over the cell's borders, as columns.
fn mean_derivative<const M: usize, const N: usize>(part: &[[DVec2; N]; M]) -> DMat2 {
    let sum = |row: &[DVec2; N]| row.iter().sum::<DVec2>();
    let ds = (sum(&part[M - 1]) - sum(&part[0])) / N as f64;
    let dt = part.iter().map(|row| row[N - 1] - row[0]).sum::<DVec2>() / M as f64;
    DMat2::from_cols(ds, dt)
}

/// The map with its axes turned along the longer of the mean derivatives and across it.
fn turned<const M: usize, const N: usize>(part: &[[DVec2; N]; M], mean: &DMat2) -> [[DVec2; N]; M] {
    let long = if mean.x_axis.length() > mean.y_axis.length() { mean.x_axis } else { mean.y_axis };
    let axis = long.try_normalize().unwrap_or(DVec2::X);
    transform(part, &DMat2::from_cols(DVec2::new(axis.x, -axis.y), DVec2::new(axis.y, axis.x)))
}

fn transform<const M: usize, const N: usize>(part: &[[DVec2; N]; M], by: &DMat2) -> [[DVec2; N]; M] {
    let mut turned = *part;
    // In place: mapped arrays are moved about, which costs as much as the products.
    turned.as_flattened_mut().iter_mut().for_each(|f| *f = *by * *f);
    turned
}

/// Whether the coefficients, and so the map, keep away from 0 by more than `slack` along an axis.
fn misses<const M: usize, const N: usize>(part: &[[DVec2; N]; M], slack: DVec2) -> bool {
    let all = part.as_flattened();
    let (low, high) = all.iter().fold((all[0], all[0]), |(low, high), f| (low.min(*f), high.max(*f)));
    low.cmpgt(slack).any() || high.cmplt(-slack).any()
}

/// Largest deviation of the derivative from the identity, in the maximum norm.
fn deviation<const M: usize, const N: usize>(part: &[[DVec2; N]; M]) -> f64 {
    let (mut by_s, mut by_t) = (DVec2::ZERO, DVec2::ZERO);
    for w in part.windows(2) {
        for (a, b) in w[0].iter().zip(&w[1]) {
            by_s = by_s.max(((*b - *a) * (M - 1) as f64 - DVec2::X).abs());
        }
    }
    for w in part.iter().flat_map(|row| row.windows(2)) {
        by_t = by_t.max(((w[1] - w[0]) * (N - 1) as f64 - DVec2::Y).abs());
    }
    (by_s + by_t).max_element()
}

/// Value and derivative (columns by s and by t) of the map.
fn value<const M: usize, const N: usize>(net: &[[DVec2; N]; M], s: f64, t: f64) -> (DVec2, DMat2) {
    let (ws, wt) = (weights(s), weights(t));
    let (mut values, mut slopes) = ([DVec2::ZERO; M], [DVec2::ZERO; M]);
    for (row, (value, slope)) in net.iter().zip(values.iter_mut().zip(&mut slopes)) {
        (*value, *slope) = combine(row, &wt, t);
    }
    let (f, by_s) = combine(&values, &ws, s);
    let (by_t, _) = combine(&slopes, &ws, s);
    (f, DMat2::from_cols(by_s, by_t))
}

fn split_s<const M: usize, const N: usize>(part: &[[DVec2; N]; M]) -> [[[DVec2; N]; M]; 2] {
    let mut halves = [*part; 2];
    for j in 0..N {
        let [low, high] = split(&part.each_ref().map(|row| row[j]), 0.5);
        for i in 0..M {
            (halves[0][i][j], halves[1][i][j]) = (low[i], high[i]);
        }
    }
    halves
}

fn split_t<const M: usize, const N: usize>(part: &[[DVec2; N]; M]) -> [[[DVec2; N]; M]; 2] {
    let halves = part.each_ref().map(|row| split(row, 0.5));
    [halves.map(|h| h[0]), halves.map(|h| h[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all<const M: usize, const N: usize>(net: &[[DVec2; N]; M]) -> Vec<DVec2> {
        let mut found: Vec<DVec2> = Vec::new();
        zeros(net, 5e-10, |s, t| {
            found.push(DVec2::new(s, t));
            false
        });
        found
    }

    #[test]
    fn four_zeros_of_two_parabolas() {
        // f = ((s − ¼)(s − ¾), (t − ⅓)(t − ⅔)) in Bernstein form.
        let p = crate::bernstein::from_powers([3.0 / 16.0, -1.0, 1.0]);
        let q = crate::bernstein::from_powers([2.0 / 9.0, -1.0, 1.0]);
        let found = all(&p.map(|p| q.map(|q| DVec2::new(p, q))));
        for s in [0.25, 0.75] {
            for t in [1.0 / 3.0, 2.0 / 3.0] {
                assert!(
                    found.iter().any(|at| at.distance(DVec2::new(s, t)) < 1e-14),
                    "{s} {t} not in {found:?}"
                );
            }
        }
        assert!(found.iter().all(|at| at.distance(DVec2::new(at.x.round(), at.y.round())) > 0.2));
    }

    #[test]
    fn a_zero_on_the_border_is_found_from_both_sides() {
        for shift in [0.0, 1e-10, -1e-10] {
            let net = [0.0, 1.0].map(|s| [0.0, 1.0].map(|t| DVec2::new(s + shift, t - 0.5)));
            assert!(all(&net).iter().any(|at| (at.y - 0.5).abs() < 1e-15), "shift {shift}");
        }
    }

    #[test]
    fn a_double_zero_is_found_and_a_near_miss_is_not() {
        let p = crate::bernstein::from_powers([0.25, -1.0, 1.0]);
        let net = |lift: f64| p.map(|p| [-0.3, 0.7].map(|t| DVec2::new(p + lift, t + p)));
        assert!(all(&net(0.0)).iter().any(|at| at.distance(DVec2::new(0.5, 0.3)) < 1e-6));
        assert!(all(&net(1e-6)).is_empty());
    }
}
