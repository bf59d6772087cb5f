//! Irradiance at a point outside a surface of revolution of even exitance: the wall of a cylinder or a cone,
//! a disk or a ring, or a part of one between two half-planes through the axis.
//!
//! The part of such a wall that x sees lies between the two generators whose tangent planes hold x. With r
//! and z the distance of x from the axis and its height, and n_r ρ + n_z ζ = k on the meridian (ρ, ζ), x sees
//! the generators at the angles
//!
//! ```text
//! |ψ| < acos t ,     t = (k − n_z z)/(n_r r) ,
//! ```
//!
//! from its own half-plane, and the outline is two generators with an arc of the circle at either end
//! ([`crate::irradiance::outline`]); of a wall that x sees all around, both circles.

use std::f64::consts::{PI, TAU};

use radiosity_geom::{DVec2, DVec3, Meridian, ROUNDING, Rect, Surface};

use crate::irradiance::outline::{Arc, Piece, within};

/// A part of a surface of revolution, of which no part hides another one from points before it.
#[derive(Clone, Copy, Debug)]
pub struct Swept {
    meridian: Meridian,
    /// Unit vectors across the axis, the first to where the part starts.
    axes: [DVec3; 2],
    /// The angle that it covers, up to a turn.
    width: f64,
}

impl Swept {
    /// The part of a surface over a range of its parameters; None of others than walls with the front
    /// outside, disks and rings.
    pub fn of(surface: &dyn Surface, rect: &Rect) -> Option<Self> {
        let meridian = surface.meridian()?.part(rect.v);
        if meridian.normal.x < 0.0 {
            return None;
        }
        let across = |u: f64| {
            let local = surface.jet(u, 0.5 * (rect.v[0] + rect.v[1])).position - meridian.origin;
            (local - local.dot(meridian.axis) * meridian.axis).normalize()
        };
        let [low, high] = rect.u;
        // Whether angles about the axis grow with u.
        let grows = meridian.axis.dot(across(low).cross(across(low + 0.1 * (high - low)))) > 0.0;
        let toward = across(if grows { low } else { high });
        Some(Self { meridian, axes: [toward, meridian.axis.cross(toward)], width: 0.5 * (high - low) * TAU })
    }

    /// Irradiance at `x` with the unit normal `n` from all of its front, without blockers. Points on the wall
    /// are those of its other side.
    pub fn irradiance(&self, x: DVec3, n: DVec3) -> f64 {
        let place = self.place(x);
        let (height, least) = (self.height(&place), self.rounding(&place));
        if height > least { self.seen_from(x, n, &place, height) } else { 0.0 }
    }

    /// As [`Self::irradiance`], where points on the wall are those of a surface before it that touches it.
    pub(crate) fn irradiance_of_touching(&self, x: DVec3, n: DVec3) -> f64 {
        let place = self.place(x);
        let (height, least) = (self.height(&place), self.rounding(&place));
        if height >= -least { self.seen_from(x, n, &place, height.max(least)) } else { 0.0 }
    }

    /// Whether a point lies before the wall, or its plane or cone, by more than rounding.
    pub fn is_before(&self, x: DVec3) -> bool {
        let place = self.place(x);
        self.height(&place) > self.rounding(&place)
    }

    fn place(&self, x: DVec3) -> Place {
        let local = x - self.meridian.origin;
        let across = DVec2::from_array(self.axes.map(|own| local.dot(own)));
        Place { across, level: DVec2::new(across.length(), local.dot(self.meridian.axis)) }
    }

    /// Height over the line of the meridian.
    fn height(&self, place: &Place) -> f64 {
        self.meridian.normal.dot(place.level - self.meridian.ends[0])
    }

    /// Rounding of such a height.
    fn rounding(&self, place: &Place) -> f64 {
        ROUNDING * self.meridian.size().max(place.level.length())
    }

    /// Irradiance at a point so high over the line of the meridian.
    fn seen_from(&self, x: DVec3, n: DVec3, Place { across, level }: &Place, height: f64) -> f64 {
        let swing = self.meridian.normal.x * level.x;
        let over = height - swing;
        let half = match swing {
            _ if over >= swing => PI,
            _ if over > -swing => (-over / swing).acos(),
            _ => return 0.0,
        };
        let view = View { swept: self, from: self.meridian.origin - x, n };
        let middle = across.y.atan2(across.x);
        let ranges =
            if half >= PI { vec![[0.0, self.width]] } else { self.seen([middle - half, middle + half]) };
        ranges.into_iter().map(|range| view.part(range)).sum::<f64>().abs()
    }

    /// The parts of a range of angles that it covers.
    fn seen(&self, [low, high]: [f64; 2]) -> Vec<[f64; 2]> {
        let part = |turn: i32| {
            let start = TAU * f64::from(turn);
            [low.max(start), high.min(start + self.width)]
        };
        (-1..=1).map(part).filter(|[from, to]| from < to).collect()
    }
}

/// A point by its vector across the axis, and by its distance from the axis and its height along it.
struct Place {
    across: DVec2,
    level: DVec2,
}

/// A part as seen from a point.
struct View<'a> {
    swept: &'a Swept,
    /// From the point to the origin of the meridian.
    from: DVec3,
    n: DVec3,
}

impl View<'_> {
    /// n·E of what lies between two angles.
    fn part(&self, range @ [first, last]: [f64; 2]) -> f64 {
        let [bottom, top] = self.swept.meridian.ends;
        let is_round = last - first >= TAU;
        let [bottom, top] = [self.arc(bottom, range), self.arc(top, [last, first])];
        match is_round {
            true => [bottom, top].into_iter().flatten().map(|arc| within(self.n, &[arc])).sum(),
            false => {
                let right = self.generator(last);
                let [low, high] = self.generator(first);
                let pieces = [bottom, Some(Piece::Segment(right)), top, Some(Piece::Segment([high, low]))];
                within(self.n, &pieces.into_iter().flatten().collect::<Vec<_>>())
            }
        }
    }

    /// The arc at an end of the meridian; None at a tip.
    fn arc(&self, end: DVec2, angles: [f64; 2]) -> Option<Piece> {
        let center = self.from + end.y * self.swept.meridian.axis;
        let axes = self.swept.axes.map(|axis| end.x * axis);
        (end.x > 0.0).then_some(Piece::Arc(Arc { center, axes, angles }))
    }

    /// From the first end of the meridian to the second.
    fn generator(&self, angle: f64) -> [DVec3; 2] {
        let (sin, cos) = angle.sin_cos();
        let [toward, across] = self.swept.axes;
        let away = cos * toward + sin * across;
        self.swept.meridian.ends.map(|end| self.from + end.y * self.swept.meridian.axis + end.x * away)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::shapes::{Cone, Cylinder, Disk, FULL_TURN};

    use super::*;

    /// ∫ max(0, n·d) max(0, −m·d)/(π|d|⁴) dA over a range of parameters, by midpoints.
    fn by_midpoints(surface: &dyn Surface, rect: &Rect, x: DVec3, n: DVec3) -> f64 {
        const STEPS: usize = 500;
        let place = |[low, high]: [f64; 2], k: usize| low + (high - low) * (k as f64 + 0.5) / STEPS as f64;
        let [width, height] = [rect.u, rect.v].map(|[low, high]| (high - low) / STEPS as f64);
        let at = |i: usize, j: usize| {
            let y = surface.jet(place(rect.u, i), place(rect.v, j));
            let d = y.position - x;
            let cosines = n.dot(d).max(0.0) * (-y.normal.dot(d)).max(0.0);
            width * height * y.area * cosines / (PI * d.length_squared().powi(2))
        };
        (0..STEPS * STEPS).map(|k| at(k / STEPS, k % STEPS)).sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        /// Cylinders, cones with a tip and without, disks and rings, whole and in parts, seen whole and past
        /// horizons.
        #[test]
        fn what_is_seen_of_a_wall_is_its_integral(
            kind in 0..5u8, u in -1.0..0.8f64, part in 0.1..1.0f64, x in prop::array::uniform3(-2.0..2.0f64),
            n in prop::array::uniform3(-1.0..1.0f64), is_whole: bool,
        ) {
            let axis = DVec3::new(0.3, -0.4, 1.2);
            let surface: Box<dyn Surface> = match kind {
                0 => Box::new(Cylinder::new(DVec3::ZERO, axis, 0.5, FULL_TURN).unwrap()),
                1 => Box::new(Cone::new(DVec3::ZERO, axis, 0.8, 0.3, FULL_TURN).unwrap()),
                2 => Box::new(Cone::new(DVec3::ZERO, axis, 0.0, 0.7, FULL_TURN).unwrap()),
                3 => Box::new(Disk::new(DVec3::ZERO, axis, 1.0, 0.0, FULL_TURN).unwrap()),
                _ => Box::new(Disk::new(DVec3::ZERO, axis, 1.0, 0.4, FULL_TURN).unwrap()),
            };
            let [x, n] = [x, n].map(DVec3::from_array);
            prop_assume!(n.length() > 0.1 && surface.project(x).distance > 0.2);
            // Not within the thing.
            prop_assume!(surface.solid().is_none_or(|solid| solid.excess(x) > 0.0) || kind > 2);
            let rect = if is_whole { Rect::FULL } else { Rect { u: [u, u + part * (1.0 - u)], v: [-0.7, 0.9] } };
            let found = Swept::of(&*surface, &rect).unwrap().irradiance(x, n.normalize());
            let right = by_midpoints(&*surface, &rect, x, n.normalize());
            prop_assert!((found - right).abs() < 1e-4, "{found} {right}");
        }
    }

    #[test]
    fn the_other_side_of_a_wall_sees_nothing_of_it() {
        let cone = Cone::new(DVec3::ONE, DVec3::new(0.3, -0.4, 1.2), 0.8, 0.3, FULL_TURN).unwrap();
        let swept = Swept::of(&cone, &Rect::FULL).unwrap();
        for (u, v) in [(0.1, 0.2), (-0.7, 0.9), (0.5, -1.0)] {
            let own = cone.jet(u, v);
            assert_eq!(swept.irradiance(own.position, -own.normal), 0.0);
        }
    }

    /// Right before a wall it fills the half of the view that it does of a plane, and before a small gap all
    /// of it.
    #[test]
    fn points_before_a_wall_see_their_share_of_it() {
        let tube = Cylinder::new(-5.0 * DVec3::Z, 10.0 * DVec3::Z, 1.0, FULL_TURN).unwrap();
        let swept = Swept::of(&tube, &Rect::FULL).unwrap();
        for gap in [1e-2, 1e-4, 1e-6, 1e-8] {
            let x = (1.0 + gap) * DVec3::X;
            let [toward, aside] = [-DVec3::X, DVec3::Z].map(|n| swept.irradiance(x, n));
            // An infinite tube fills R/d of the view toward it; its ends are five radii away.
            assert!((toward - 1.0 / (1.0 + gap)).abs() < 2.0 * gap * gap + 1e-12, "{gap:e}: {toward}");
            assert!((aside - 0.5).abs() < 1.5 * gap.sqrt(), "{gap:e}: {aside}");
        }
    }

    #[test]
    fn insides_and_parts_of_turns_have_none() {
        let half = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, [0.0, 3.0]).unwrap();
        let inside = radiosity_geom::Flipped::new(Box::new(
            Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).unwrap(),
        ));
        assert!(Swept::of(&half, &Rect::FULL).is_none() && Swept::of(&inside, &Rect::FULL).is_none());
    }
}
