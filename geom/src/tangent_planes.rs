//! The tangent planes of a bicubic patch, and how far points lie beyond one of them.
//!
//! With A(s, t) and w(s, t) the numerator and the denominator of the patch (w = 1 of a polynomial one) the
//! height of a point y over the tangent plane, times w³ |X_s × X_t|, is
//!
//! ```text
//! h(y) = n·y + c ,     n = w A_s × A_t + w_s A_t × A + w_t A × A_s ,     c = −det(A_s, A_t, A) ,
//! ```
//!
//! polynomials of degree 8 in s and in t. Their Bernstein coefficients bound them; where that is not tight,
//! the patch is halved.

use glam::{DVec3, DVec4};

use crate::bernstein::{evaluate, split};
use crate::{Aabb, Motion};

/// Coefficients of degree 8 in s and in t.
type Net<T> = [[T; DEGREES]; DEGREES];
/// Degrees 0 … 8.
const DEGREES: usize = 9;

/// Halvings of the patch for one point, at the most: 0.2 ms. A point of the patch takes some forty.
const MOST_HALVINGS: usize = 400;

/// Part of the patch's size to which the farthest plane is found. With a larger value what touches could not
/// be told from what does not ([`COINCIDENT`](crate::COINCIDENT)).
const TO: f64 = 1e-10;

/// Part of the greatest height to which it is found. With a smaller value points far off take longer.
const ROUGHLY: f64 = 0.1;

/// The tangent planes of a bicubic patch, seen from the side that it bends to.
#[derive(Clone, Debug)]
pub struct TangentPlanes {
    /// Middle of the patch, from which the planes are reckoned.
    origin: DVec3,
    /// n and c, such that h is below 0 beyond a plane, and no n longer than 1: over a distance h grows by no
    /// more than that.
    planes: Net<DVec4>,
    /// Diagonal of the box around the control points (length).
    size: f64,
}

impl TangentPlanes {
    /// The planes of the patch with numerators and denominators `weighted`.
    pub(crate) fn new(weighted: &[[DVec4; 4]; 4]) -> Self {
        let bounds = Aabb::around(weighted.as_flattened().iter().map(|p| p.truncate() / p.w));
        let origin = bounds.center();
        let local = weighted.map(|row| row.map(|p| (p.truncate() - p.w * origin).extend(p.w)));
        let planes = products(&local);
        let lengths = planes.as_flattened().iter().map(|plane| plane.truncate().length());
        let longest = lengths.fold(f64::MIN_POSITIVE, f64::max);
        let middle = value(&planes, 0.5, 0.5);
        let ends = [local[0][0], local[0][3], local[3][0], local[3][3]];
        let above: f64 = ends.iter().map(|p| middle.dot((p.truncate() / p.w).extend(1.0))).sum();
        let scale = 1.0_f64.copysign(above) / longest;
        Self { origin, planes: planes.map(|row| row.map(|plane| scale * plane)), size: bounds.diagonal() }
    }

    /// Distance of a point beyond one of the planes at the most, times the area element of the patch there
    /// over a bound of it (length). Infinite where that takes too long to find.
    pub(crate) fn excess(&self, point: DVec3) -> f64 {
        let place = (point - self.origin).extend(1.0);
        highest(self.planes.map(|row| row.map(|plane| -plane.dot(place))), TO * self.size)
    }

    /// The planes after a motion.
    pub(crate) fn moved(&self, motion: &Motion) -> Self {
        let turned = |plane: DVec4| motion.direction(plane.truncate()).extend(motion.scale() * plane.w);
        Self {
            origin: motion.point(self.origin),
            planes: self.planes.map(|row| row.map(turned)),
            size: motion.scale() * self.size,
        }
    }
}

/// n and c in Bernstein form.
fn products(net: &[[DVec4; 4]; 4]) -> Net<DVec4> {
    let mut planes = [[DVec4::ZERO; DEGREES]; DEGREES];
    let grid = |rows: usize, columns: usize| (0..rows).flat_map(move |i| (0..columns).map(move |j| [i, j]));
    for [i, j] in grid(3, 4) {
        let by_s = net[i + 1][j] - net[i][j];
        for [k, l] in grid(4, 3) {
            let by_t = net[k][l + 1] - net[k][l];
            let across = by_s.truncate().cross(by_t.truncate());
            for [m, n] in grid(4, 4) {
                let own = net[m][n];
                let a = own.truncate();
                let tilted = by_s.w * by_t.truncate().cross(a) + by_t.w * a.cross(by_s.truncate());
                let plane = (own.w * across + tilted).extend(-across.dot(a));
                let shares = [share([2, 3, 3], [i, k, m]), share([3, 2, 3], [j, l, n])];
                planes[i + k + m][j + l + n] += 9.0 * shares[0] * shares[1] * plane;
            }
        }
    }
    planes
}

/// Share of a product of three Bernstein polynomials in the one of degree 8.
fn share(degrees: [usize; 3], indices: [usize; 3]) -> f64 {
    let product: f64 = [0, 1, 2].map(|k| choose(degrees[k], indices[k])).iter().product();
    product / choose(8, indices.iter().sum())
}

fn choose(n: usize, k: usize) -> f64 {
    (0..k).map(|i| (n - i) as f64 / (i + 1) as f64).product()
}

fn value(net: &Net<DVec4>, s: f64, t: f64) -> DVec4 {
    evaluate(&net.map(|row| evaluate(&row, t).0), s).0
}

/// The greatest value on [0, 1]², to `gap` or [`ROUGHLY`].
fn highest(net: Net<f64>, gap: f64) -> f64 {
    let mut best = f64::NEG_INFINITY;
    let mut parts = vec![net];
    let mut halvings = 0;
    while let Some(part) = parts.pop() {
        let ends = [part[0][0], part[0][8], part[8][0], part[8][8]];
        best = ends.into_iter().fold(best, f64::max);
        let top = top_of(&part);
        if top <= best + gap.max(ROUGHLY * best.abs()) {
            continue;
        }
        halvings += 1;
        if halvings > MOST_HALVINGS {
            return f64::INFINITY;
        }
        let [first, second] = halves(&part);
        let first_is_higher = top_of(&first) > top_of(&second);
        parts.extend(if first_is_higher { [second, first] } else { [first, second] });
    }
    best
}

/// The greatest coefficient: no value is greater.
fn top_of(net: &Net<f64>) -> f64 {
    net.as_flattened().iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// The two halves along the parameter along which neighbouring coefficients differ most.
fn halves(net: &Net<f64>) -> [Net<f64>; 2] {
    let turned: Net<f64> = transposed(net);
    let step = |net: &Net<f64>| {
        net.iter().flat_map(|row| row.windows(2)).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
    };
    let halved = |net: &Net<f64>| {
        let rows = net.map(|row| split(&row, 0.5));
        [0, 1].map(|half| rows.map(|row| row[half]))
    };
    if step(net) >= step(&turned) { halved(net) } else { halved(&turned).map(|half| transposed(&half)) }
}

fn transposed(net: &Net<f64>) -> Net<f64> {
    std::array::from_fn(|k| std::array::from_fn(|l| net[l][k]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Surface;
    use crate::shapes::{Bezier, Rational};
    use proptest::prelude::*;

    /// A shallow vault over the unit square, of random weights and heights.
    fn vault(heights: [f64; 16], weights: [f64; 16]) -> ([[DVec3; 4]; 4], [[f64; 4]; 4]) {
        let at = |i: usize, j: usize| {
            let [x, y] = [i, j].map(|k| k as f64 / 3.0);
            let bulge = if (1..3).contains(&i) || (1..3).contains(&j) { 0.3 } else { 0.0 };
            DVec3::new(x, y, 1.0 + bulge + 0.1 * heights[4 * i + j])
        };
        let points = std::array::from_fn(|i| std::array::from_fn(|j| at(i, j)));
        (points, std::array::from_fn(|i| std::array::from_fn(|j| weights[4 * i + j])))
    }

    proptest! {
        /// Against the heights over the tangent planes at a grid of points.
        #[test]
        fn the_farthest_plane_is_found(
            heights in prop::array::uniform16(-1.0..1.0), weights in prop::array::uniform16(0.5..2.0),
            place in prop::array::uniform3(-0.5..1.5),
        ) {
            let (points, weights) = vault(heights, weights);
            let weighted = |i: usize, j: usize| (weights[i][j] * points[i][j]).extend(weights[i][j]);
            let net = std::array::from_fn(|i| std::array::from_fn(|j| weighted(i, j)));
            let planes = TangentPlanes::new(&net);
            let patch = Rational::new(points, weights).expect("a patch");
            let y = DVec3::from_array(place);
            let at = |k: usize| k as f64 / 20.0 - 1.0;
            let jets = || (0..41 * 41).map(|k| [at(k / 41), at(k % 41)]);
            let weight = |[u, v]: [f64; 2]| {
                let [s, t] = [u, v].map(|w| 0.5 * (1.0 + w));
                evaluate(&net.map(|row| evaluate(&row, t).0), s).0.w.powi(3)
            };
            let area = |at: [f64; 2]| weight(at) * patch.jet(at[0], at[1]).area;
            let lengths = products(&net).as_flattened().iter().map(|n| 0.25 * n.truncate().length()).collect::<Vec<_>>();
            let largest = lengths.into_iter().fold(0.0, f64::max);
            let beyond = |at: [f64; 2]| {
                let jet = patch.jet(at[0], at[1]);
                (y - jet.position).dot(jet.normal) * area(at) / largest
            };
            // The patch bends to below: its front, upwards, is outside.
            let most = jets().map(beyond).fold(f64::NEG_INFINITY, f64::max);
            let found = planes.excess(y);
            prop_assert!((found - most).abs() <= ROUGHLY * found.abs() + 0.01, "{} {}", found, most);
            let motion = Motion::new(DVec3::new(3.0, -1.0, 2.0), DVec3::ONE, 0.7, 2.0).expect("a motion");
            let moved = planes.moved(&motion).excess(motion.point(y));
            prop_assert!((moved - 2.0 * found).abs() <= 1e-12 + ROUGHLY * moved.abs());
        }
    }

    #[test]
    fn points_of_a_vault_lie_beyond_none_of_its_planes() {
        let (points, _) = vault([0.0; 16], [1.0; 16]);
        let patch = Bezier::new(points).expect("a patch");
        let planes = TangentPlanes::new(&points.map(|row| row.map(|p| p.extend(1.0))));
        for (u, v) in [(-1.0, -1.0), (0.0, 0.3), (1.0, 0.1), (0.77, -0.31)] {
            let jet = patch.jet(u, v);
            let excess = planes.excess(jet.position);
            assert!((-2e-10..1e-9).contains(&excess), "{excess}");
            let outside = planes.excess(jet.position + 1e-6 * jet.normal);
            assert!(outside > 1e-7 && outside < 1.01e-6, "{outside}");
        }
    }
}
