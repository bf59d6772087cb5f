//! Number of Gauss points per direction that the chart of a curved patch needs.
//!
//! All integrands contain the patch's area element A, normals n and positions x. The least n is taken whose
//! rule agrees with that of 32 points on the vector area and the first moments
//!
//! ```text
//! ∫ A n ds ,   ∫ A (x − C) ds     and the same along t
//! ```
//!
//! over the middle line and both borders in either direction, C the patch's middle. An affine chart adds
//! none.

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::tolerances::ROUNDING_OF_SUMS;

/// Points of the rule to compare with, which counts as exact.
const FINE: usize = 32;
/// Most points returned: a rule with as many as [`FINE`] would agree with it whatever its error.
const MOST: usize = 28;

/// Points along s and along t in addition to those for the polynomials, for relative accuracy `eps`.
pub fn points(patch: &Patch, eps: f64) -> [usize; 2] {
    if patch.is_flat() {
        return if patch.is_parallelogram() { [0, 0] } else { [1, 1] };
    }
    let center = patch.node(0.5, 0.5).position;
    let lines = [0.0, 0.5, 1.0];
    let along = lines.map(|t| line(&|s| patch.node(s, t), center, eps));
    let across = lines.map(|s| line(&|t| patch.node(s, t), center, eps));
    [along, across].map(|counts| counts.into_iter().max().unwrap_or(0))
}

/// The least number of points on one line, up to a third too many.
fn line(node: &dyn Fn(f64) -> Node, center: DVec3, eps: f64) -> usize {
    let sums = |n: usize| {
        UnitRule::of(n).iter().fold([DVec3::ZERO; 2], |[areas, moments], (s, w)| {
            let x = node(s);
            [areas + w * x.area * x.normal, moments + w * x.area * (x.position - center)]
        })
    };
    let exact = sums(FINE);
    let reach = UnitRule::of(3).nodes.iter().map(|s| node(*s)).map(|x| x.area * x.position.distance(center));
    let scales = [exact[0].length(), exact[1].length().max(reach.fold(0.0, f64::max))];
    let right = |n: usize| {
        let found = sums(n);
        (0..2).all(|k| found[k].distance(exact[k]) <= eps.max(ROUNDING_OF_SUMS) * scales[k])
    };
    let mut n = 1;
    while n < MOST && !right(n) {
        n += 1 + n / 3;
    }
    n.min(MOST)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_geom::Rect;
    use radiosity_geom::shapes::{Cylinder, SpherePatch};

    use super::*;

    #[test]
    fn a_tube_takes_points_around_it_only() {
        let tube = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, [0.0, 1.5]).expect("a tube");
        let patch = Patch::curved(Arc::new(tube), &Rect::FULL);
        let [around, upward] = points(&patch, 1e-12);
        assert!((5..=8).contains(&around), "{around}");
        assert!(upward <= 2, "{upward}");
    }

    /// The solid angle of a face of the cube is 4π/6, whatever the chart.
    #[test]
    fn the_points_found_give_the_area_of_a_sixth_of_a_sphere() {
        let [face, ..] = SpherePatch::cube(DVec3::ZERO, 1.0).expect("a sphere");
        let patch = Patch::curved(Arc::new(face), &Rect::FULL);
        for eps in [1e-4, 1e-8, 1e-12] {
            let [m, n] = points(&patch, eps).map(UnitRule::of);
            let area: f64 = m
                .iter()
                .flat_map(|s| n.iter().map(move |t| (s, t)))
                .map(|(s, t)| s.1 * t.1 * patch.node(s.0, t.0).area)
                .sum();
            assert!((area / (4.0 * std::f64::consts::PI / 6.0) - 1.0).abs() <= 3.0 * eps, "{eps:e}: {area}");
        }
    }
}
