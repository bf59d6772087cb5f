//! Welding: corners and planes that agree to the rounding of the input are made equal when a scene is read.
//!
//! Models come in single precision or with few decimals: corners that are meant to be one differ,
//! quadrilaterals are not quite planar, bodies hover over floors or reach into them slightly. The rules of
//! transport distinguish touching from apart, so corners within the tolerance of the input are moved
//! together:
//!
//! 1. corners nearer to each other than the tolerance become one (`corners`);
//! 2. a corner within tolerance of a flat sheet belongs to its plane, and sheets whose corners all do share a
//!    plane (`planes`);
//! 3. all corners move as little as possible, in the sense of least squares, until each lies in its planes
//!    (`flatten`).
//!
//! Flat sheets that lie wholly in front of each other, however close, are left as they are: the rules hold
//! for every gap, and the sign of the gap says which is in front. Corners that agree to rounding do not move,
//! so clean scenes keep their bits.
//!
//! The tolerance is that of the two sheets in question (`tolerance`), or the length that the user gave.

mod forest;
mod tolerance;
mod sheet;
mod apart;
mod layers;
mod corners;
mod planes;
mod flatten;

use std::{collections::HashSet, fmt, sync::Arc};

use radiosity_geom::{DVec3, Surface};
use serde::Serialize;

use corners::Corners;
use planes::Planes;
use sheet::Sheets;

/// Corners that were moved when a scene was read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Welded {
    /// Number of moved corners, each counted once however many surfaces share it.
    pub corners: usize,
    /// Length of the largest move (scene length).
    pub largest: f64,
}

impl fmt::Display for Welded {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let corners = if self.corners == 1 { "corner" } else { "corners" };
        write!(out, "{} {corners} moved, by {:.1e} at the most", self.corners, self.largest)
    }
}

/// Moves the corners of `shapes` as the module says. Their coordinates were rounded before `middle` was
/// subtracted; `asked` is a tolerance (scene length) instead of that of the input.
pub fn weld(shapes: &mut [&mut Arc<dyn Surface>], middle: DVec3, asked: Option<f64>) -> Welded {
    let sheets = Sheets::of(shapes, middle, asked);
    let apart = apart::pairs(&sheets);
    let corners = Corners::merged(&sheets, &apart);
    let planes = Planes::of(&sheets, &corners, &apart);
    let places = flatten::flattened(&corners, &planes, sheets.reach());
    let moved = rebuilt(shapes, &corners, &places);
    let mut welded = Welded::default();
    let mut known = HashSet::new();
    for (shape, moved) in shapes.iter_mut().zip(moved) {
        let Some(moved) = moved else { continue };
        for (from, to) in shape.corners().into_iter().zip(moved.corners()).filter(|(from, to)| from != to) {
            welded.corners += usize::from(known.insert(corners.node(from)));
            welded.largest = welded.largest.max(from.distance(to));
        }
        **shape = moved;
    }
    welded
}

/// The shapes with moved corners; None for unchanged ones. Corners of a shape that would collapse stay, in
/// all shapes.
fn rebuilt(
    shapes: &[&mut Arc<dyn Surface>],
    corners: &Corners,
    places: &[DVec3],
) -> Vec<Option<Arc<dyn Surface>>> {
    let mut held: HashSet<usize> = HashSet::new();
    loop {
        let place = |x: DVec3| match corners.node(x) {
            Some(node) if !held.contains(&node) => places[node],
            _ => x,
        };
        let rebuilt = |shape: &&mut Arc<dyn Surface>| {
            let is_moved = shape.corners().iter().any(|x| place(*x) != *x);
            is_moved.then(|| shape.with_corners(&place)).flatten().transpose()
        };
        let results: Vec<_> = shapes.iter().map(rebuilt).collect();
        let failed = shapes
            .iter()
            .zip(&results)
            .filter(|(_, result)| result.is_err())
            .map(|(shape, _)| shape.corners());
        let stay: Vec<usize> = failed.flatten().filter_map(|x| corners.node(x)).collect();
        if stay.is_empty() {
            return results.into_iter().map(|result| result.ok().flatten().map(Arc::from)).collect();
        }
        held.extend(stay);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use proptest::prelude::*;
    use proptest::test_runner::{Config, RngSeed};
    use radiosity_geom::{Motion, shapes::Polygon};

    use super::*;

    /// The outlines of a body as surfaces, welded to the tolerance that is asked for; what was moved.
    fn welded(outlines: &[Vec<DVec3>], asked: Option<f64>) -> (Vec<Vec<DVec3>>, Welded) {
        let polygon = |outline: &Vec<DVec3>| -> Arc<dyn Surface> {
            Arc::new(Polygon::new(outline.clone(), Vec::new()).expect("a polygon"))
        };
        let mut shapes: Vec<Arc<dyn Surface>> = outlines.iter().map(polygon).collect();
        let welded = weld(&mut shapes.iter_mut().collect::<Vec<_>>(), DVec3::ZERO, asked);
        (shapes.iter().map(|shape| shape.corners()).collect(), welded)
    }

    /// A box of 3 × 2 × 1 on a floor, without its bottom, all of it put elsewhere.
    fn box_on_floor(place: impl Fn(DVec3) -> DVec3) -> Vec<Vec<DVec3>> {
        let [x, y, z] = [3.0 * DVec3::X, 2.0 * DVec3::Y, DVec3::Z];
        let faces = [
            vec![-x - y, 2.0 * x - y, 2.0 * x + 2.0 * y, 2.0 * y - x],
            vec![z, z + x, z + x + y, z + y],
            vec![DVec3::ZERO, x, x + z, z],
            vec![x, x + y, x + y + z, x + z],
            vec![x + y, y, y + z, x + y + z],
            vec![y, DVec3::ZERO, z, y + z],
        ];
        faces.into_iter().map(|face| face.into_iter().map(&place).collect()).collect()
    }

    /// The largest height of a corner over the plane of its outline.
    fn unevenness(outlines: &[Vec<DVec3>]) -> f64 {
        let heights = outlines.iter().flat_map(|outline| {
            let normal = (outline[2] - outline[0]).cross(outline[3] - outline[1]).normalize();
            outline.iter().map(move |x| (*x - outline[0]).dot(normal).abs())
        });
        heights.fold(0.0, f64::max)
    }

    fn turn() -> Motion {
        Motion::new(DVec3::new(0.3, -0.2, 0.7), DVec3::new(1.0, 2.0, -0.5), 0.8, 1.0).expect("a motion")
    }

    fn single(x: DVec3) -> DVec3 {
        DVec3::from_array(x.to_array().map(|x| f64::from(x as f32)))
    }

    #[test]
    fn clean_bodies_keep_their_bits() {
        for place in [|x| x, |x| turn().point(x)] {
            let typed = box_on_floor(place);
            let (found, moved) = welded(&typed, None);
            assert_eq!((found, moved), (typed, Welded::default()));
        }
    }

    #[test]
    fn no_tolerance_moves_nothing() {
        let typed = box_on_floor(|x| single(turn().point(x)));
        let (found, moved) = welded(&typed, Some(0.0));
        assert_eq!((found, moved), (typed, Welded::default()));
    }

    #[test]
    fn a_corner_moves_back_by_no_more_than_it_was_moved() {
        let off = 1e-7;
        let outlines =
            box_on_floor(|x| if x == DVec3::new(3.0, 2.0, 1.0) { x + off * DVec3::ONE } else { x });
        assert!(unevenness(&outlines) > 0.1 * off);
        let (found, moved) = welded(&outlines, None);
        assert!(unevenness(&found) < 1e-14);
        // Moving that corner alone back would do: the sum of squares of all moves is no larger.
        let squares: HashMap<[u64; 3], f64> = outlines
            .iter()
            .flatten()
            .zip(found.iter().flatten())
            .map(|(from, to)| (from.to_array().map(f64::to_bits), from.distance_squared(*to)))
            .collect();
        let sum: f64 = squares.values().sum();
        assert!(sum <= 3.0 * off * off * (1.0 + 1e-6), "{sum:e} {moved:?}");
    }

    #[test]
    fn plates_on_each_other_keep_their_order_where_the_outer_ones_are_side_by_side() {
        let plate = |x: f64, z: f64| {
            let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            corners.map(|[along, across]| DVec3::new(x + along, across, z)).to_vec()
        };
        for heights in [[0.0, 4e-8, 8e-8], [8e-8, 4e-8, 0.0]] {
            let typed: Vec<Vec<DVec3>> =
                [0.0, 0.5, 1.001].into_iter().zip(heights).map(|(x, z)| plate(x, z)).collect();
            let (found, moved) = welded(&typed, None);
            assert_eq!((found, moved), (typed, Welded::default()));
        }
        // Without the one between them the outer ones share a plane.
        let (_, moved) = welded(&[plate(0.0, 0.0), plate(1.001, 8e-8)], None);
        assert_eq!(moved.corners, 8);
    }

    #[test]
    fn what_hovers_within_its_tolerance_stands_and_what_is_visibly_apart_does_not() {
        let lifted = |gap: f64| {
            let mut outlines = box_on_floor(|x| x);
            outlines[1..].iter_mut().flatten().for_each(|x| x.z += gap);
            outlines
        };
        let foot = |outlines: &[Vec<DVec3>]| outlines[2][0].z - outlines[0][0].z;
        assert!(foot(&welded(&lifted(1e-7), None).0).abs() < 1e-15);
        assert!((foot(&welded(&lifted(1e-4), None).0) - 1e-4).abs() < 1e-15);
        assert!(foot(&welded(&lifted(1e-4), Some(1e-3)).0).abs() < 1e-15);
    }

    #[test]
    fn sheets_wholly_before_each_other_stay_apart() {
        let plate = |z: f64| {
            vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]
                .into_iter()
                .map(move |x| x + z * DVec3::Z)
                .collect()
        };
        let typed: Vec<Vec<DVec3>> = vec![plate(0.0), plate(1e-7)];
        assert_eq!(welded(&typed, None).1, Welded::default());
        // Plates nearer than the least gap are welded.
        let near: Vec<Vec<DVec3>> = vec![plate(0.0), plate(1e-9)];
        assert_eq!(welded(&near, None).0[0][0], welded(&near, None).0[1][0]);
    }

    proptest! {
        #![proptest_config(Config { rng_seed: RngSeed::Fixed(7), failure_persistence: None, ..Config::default() })]

        /// Rounded to single precision and welded, all outlines are flat and stand on the floor.
        #[test]
        fn rounded_bodies_become_flat(axis in prop::array::uniform3(-1.0..1.0f64), angle in 0.0..6.0f64, scale in 1e-3..1e3f64) {
            let axis = DVec3::from_array(axis);
            prop_assume!(axis.length() > 0.1);
            let motion = Motion::new(DVec3::ZERO, axis, angle, scale).expect("a motion");
            let (found, moved) = welded(&box_on_floor(|x| single(motion.point(x))), None);
            let size = 10.0 * scale;
            prop_assert!(unevenness(&found) < 1e-14 * size, "{}", unevenness(&found));
            prop_assert!(moved.largest < 1e-6 * size);
            let normal = (found[0][1] - found[0][0]).cross(found[0][2] - found[0][0]).normalize();
            for foot in [&found[2][0], &found[2][1], &found[4][0], &found[4][1]] {
                prop_assert!((*foot - found[0][0]).dot(normal).abs() < 1e-14 * size);
            }
        }
    }
}
