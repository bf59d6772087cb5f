//! Whether a surface lies within a convex solid.
//!
//! The distance e from the boundary ([`ConvexSolid::excess`]) is convex, so that of a polygon the corners
//! decide, and grows over a distance by no more than that, so that most of a curved surface that lies well
//! within is known by a few points. Of the rest e is known at a grid of points. Three of them in a line, a
//! step apart, bend by
//!
//! ```text
//! d = 2 e₀ − e₊ − e₋ ,      and between them e rises by (e₊ − e₋)²/(8 d) ≤ d/2
//! ```
//!
//! over the middle one, as far as e is the parabola through them. Where d could lift e over the tolerance,
//! and is itself above it, the top is climbed to by parabolas of ever shorter steps, along both parameters in
//! turn.

use std::collections::{BTreeSet, HashMap};

use radiosity_geom::{Aabb, ConvexSolid, DVec3, Rect, Surface};

/// Points along each parameter of a curved surface: eleven degrees apart on a full turn.
const POINTS: usize = 33;

/// Steps from which the top is looked for: halved each time, the last is 10⁻⁷ of the parameter, and what it
/// misses of e some 10⁻¹⁴.
const STEPS: usize = 20;

/// Whether no point of `shape` is farther outside of `solid` than `tolerance` (length).
pub(super) fn lies_within(shape: &dyn Surface, solid: &ConvexSolid, tolerance: f64) -> bool {
    let is_low = |point: &DVec3| solid.excess(*point) <= tolerance;
    match shape.region() {
        Some(region) => region.outer().iter().all(is_low),
        None => {
            is_low(&shape.jet(0.0, 0.0).position)
                && (shape.hull(&Rect::FULL).iter().all(is_low)
                    || Excess { shape, solid, tolerance }.stays_low())
        }
    }
}

/// The parameter of a point of the grid.
fn place(k: usize) -> f64 {
    2.0 * k as f64 / (POINTS - 1) as f64 - 1.0
}

/// The distance of a curved surface from the boundary.
struct Excess<'a> {
    shape: &'a dyn Surface,
    solid: &'a ConvexSolid,
    tolerance: f64,
}

impl Excess<'_> {
    fn at(&self, [u, v]: [f64; 2]) -> f64 {
        self.solid.excess(self.shape.jet(u, v).position)
    }

    /// Whether no point is higher than the tolerance.
    fn stays_low(&self) -> bool {
        let mut open = Vec::new();
        if !self.stays_low_in([0, 0], POINTS - 1, &mut open) {
            return false;
        }
        let mut known = HashMap::new();
        let mut height = |at: [usize; 2]| *known.entry(at).or_insert_with(|| self.at(at.map(place)));
        let corners = open.iter().flat_map(|[k, l]| [[*k, *l], [k + 1, *l], [*k, l + 1], [k + 1, l + 1]]);
        let places: BTreeSet<[usize; 2]> = corners.collect();
        places.into_iter().all(|at| {
            height(at) <= self.tolerance
                && (!(0..2).any(|axis| self.may_rise(at, axis, &mut height))
                    || self.top_near(at.map(place)) <= self.tolerance)
        })
    }

    /// Whether nothing is seen to be higher than the tolerance in the square of cells from `corner` on; cells
    /// of the grid that may hold such a point are added to `open`. Over a distance the height grows by no
    /// more than that.
    fn stays_low_in(&self, corner: [usize; 2], size: usize, open: &mut Vec<[usize; 2]>) -> bool {
        if size == 1 {
            open.push(corner);
            return true;
        }
        let [u, v] = corner.map(|k| [place(k), place(k + size)]);
        let rect = Rect { u, v };
        let [u, v] = rect.center();
        let middle = self.shape.jet(u, v).position;
        let Aabb { min, max } = self.shape.bounds(&rect);
        let height = self.solid.excess(middle);
        if height > self.tolerance {
            return false;
        }
        if height + (middle - min).max(max - middle).length() <= self.tolerance {
            return true;
        }
        let half = size / 2;
        let quarters = [[0, 0], [half, 0], [0, half], [half, half]];
        quarters.iter().all(|[k, l]| self.stays_low_in([corner[0] + k, corner[1] + l], half, open))
    }

    /// Whether the parabola along an axis through three places, the middle one `at`, may rise over the
    /// tolerance.
    fn may_rise(&self, at: [usize; 2], axis: usize, height: &mut impl FnMut([usize; 2]) -> f64) -> bool {
        let middle = at[axis];
        if middle == 0 || middle == POINTS - 1 {
            return false;
        }
        let mut three = [middle - 1, middle, middle + 1].map(|index| {
            let mut beside = at;
            beside[axis] = index;
            height(beside)
        });
        let bend = 2.0 * three[1] - three[0] - three[2];
        three.sort_by(f64::total_cmp);
        bend > self.tolerance && three[2] + bend > self.tolerance
    }

    /// The height of the top near a place.
    fn top_near(&self, mut place: [f64; 2]) -> f64 {
        let mut highest = self.at(place);
        let mut step = 2.0 / (POINTS - 1) as f64;
        for _ in 0..STEPS {
            for axis in [0, 1] {
                let moved = |by: f64| {
                    let mut moved = place;
                    moved[axis] = (moved[axis] + by).clamp(-1.0, 1.0);
                    moved
                };
                let [below, above] = [-step, step].map(|by| self.at(moved(by)));
                let bend = 2.0 * highest - below - above;
                let vertex = if bend > 0.0 { 0.5 * step * (above - below) / bend } else { 0.0 };
                let tries = [-step, vertex.clamp(-step, step), step].map(moved);
                for tried in tries {
                    let height = self.at(tried);
                    if height > highest {
                        (highest, place) = (height, tried);
                    }
                }
            }
            step *= 0.5;
        }
        highest
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::Outline;
    use radiosity_geom::shapes::{Disk, FULL_TURN, Sphere};

    use super::*;

    const TUBE: ConvexSolid = ConvexSolid::Turned {
        origin: DVec3::ZERO,
        axis: DVec3::Z,
        outline: Outline::Line { radius: 1.0, slope: 0.0 },
    };

    /// A disc of radius r tilted by t about x reaches r from the axis along x, r cos t along y; shifted by
    /// (a, b) it reaches farthest where |(a + r cos φ, b + r cos t sin φ)| is greatest.
    fn reach([a, b]: [f64; 2], radius: f64, tilt: f64) -> f64 {
        let at = |k: u32| {
            let (sin, cos) = (f64::from(k) * 1e-4 * std::f64::consts::TAU).sin_cos();
            (a + radius * cos).hypot(b + radius * tilt.cos() * sin)
        };
        (0..10_000).map(at).fold(0.0, f64::max)
    }

    proptest! {
        #[test]
        fn discs_that_reach_out_of_a_tube_are_found(
            a in -0.3..0.3, b in -0.3..0.3, radius in 0.5..1.1, tilt in 0.0..1.5, beyond in -1.0..1.0,
        ) {
            // Scaled so that it reaches out by up to a millionth, or stays within by as much.
            let beyond = 1e-6 * beyond;
            prop_assume!(f64::abs(beyond) > 2e-7);
            let scale = (1.0 + beyond) / reach([a, b], radius, tilt);
            let normal = DVec3::new(0.0, f64::sin(tilt), f64::cos(tilt));
            let center = scale * DVec3::new(a, b, 0.3);
            let disc = Disk::new(center, normal, scale * radius, 0.0, FULL_TURN).expect("a disc");
            prop_assert_eq!(lies_within(&disc, &TUBE, 1e-9), beyond < 0.0);
        }
    }

    #[test]
    fn what_touches_all_around_is_within() {
        let lid = Disk::new(DVec3::new(0.0, 0.0, 2.0), DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a disc");
        assert!(lies_within(&lid, &TUBE, 1e-9));
        let ball =
            |radius| Sphere::new(DVec3::Z, radius, DVec3::X, [-radius, radius], FULL_TURN).expect("a ball");
        assert!(lies_within(&ball(1.0), &TUBE, 1e-9) && !lies_within(&ball(1.0 + 1e-6), &TUBE, 1e-9));
        let around = ConvexSolid::Ball { center: DVec3::Z, radius: 1.0 };
        assert!(lies_within(&ball(1.0), &around, 1e-9) && !lies_within(&lid, &around, 1e-9));
    }
}
