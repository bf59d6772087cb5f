//! Frusta, the convex solids between two coaxial circles, and their outlines: cans, cones, their stumps, disks.
//!
//! From x outside, with r and z its distance from the axis and its height, the wall n_r ρ + n_z ζ = k is seen
//! over the angles
//!
//! ```text
//! |ψ| < acos t ,     t = (k − n_z z)/(n_r r) ,
//! ```
//!
//! from x's own half-plane. A place of either circle is on the outline where x sees one of wall and lid there;
//! the generators at ±acos t join both. Where x sees all of the wall, or none, the outline is a circle.
//!
//! From x on the frustum's side of a plane all that lies beyond the plane within the cone over the outline is
//! hidden.
//!
//! The wall of a can hides all that the can does where a lid closes one end of it: what passes the open end
//! meets the lid.

use core::f64::consts::{PI, TAU};

use radiosity_geom::{COINCIDENT, DVec2, DVec3, Meridian, Plane, ROUNDING};

use crate::blocker_edges::BlockerEdge;
use crate::round_outline::{Rim, RoundOutline};

/// Sides of the prism that stands for a frustum, and the distance of its corners from the axis, in radii: the
/// middles of its sides lie at 0.97.
const SIDES: usize = 8;
const BEYOND_WALL: f64 = 1.05;

/// A convex solid between two coaxial circles.
#[derive(Clone, Debug)]
pub struct Frustum {
    origin: DVec3,
    /// Unit vectors: two across the axis, and the one along it.
    axes: [DVec3; 3],
    /// Distance from the axis and height of both circles, the lower one first.
    ends: [DVec2; 2],
    /// The surface that closes an end of a wall, if one has to.
    lid: Option<usize>,
}

impl Frustum {
    /// The solid that a surface with this meridian closes, by itself or with one of `others` as its lid; None
    /// for rings, and for walls that are open at both ends.
    pub fn of(meridian: &Meridian, others: impl Iterator<Item = (usize, Meridian)>) -> Option<Self> {
        let rounding = ROUNDING * meridian.size();
        let [low, high] = meridian.heights();
        let [least, most] = meridian.radii();
        let frustum = |ends: [DVec2; 2], lid: Option<usize>| {
            let (first, second) = meridian.axis.any_orthonormal_pair();
            Self { origin: meridian.origin, axes: [first, second, meridian.axis], ends, lid }
        };
        if high - low <= rounding {
            return (least <= rounding).then(|| frustum([DVec2::new(most, low); 2], None));
        }
        let mut ends = meridian.ends;
        ends.sort_by(|a, b| a.y.total_cmp(&b.y));
        if least <= rounding {
            return Some(frustum(ends, None));
        }
        let is_lid = |lid: &Meridian| {
            let [[bottom, top], [inner, outer]] = [lid.heights(), lid.radii()];
            let touching = COINCIDENT * meridian.size();
            let closes = |end: &DVec2| (bottom - end.y).abs() <= touching && outer >= end.x - touching;
            top - bottom <= touching && inner <= touching && ends.iter().any(closes)
        };
        let mut lids = others.filter_map(|(own, other)| Some((own, other.beside(meridian)?)));
        let lid = lids.find(|(_, other)| is_lid(other))?.0;
        Some(frustum(ends, Some(lid)))
    }

    /// The surface that closes an end of it, if one has to.
    pub fn lid(&self) -> Option<usize> {
        self.lid
    }

    /// Least and largest height over a plane.
    pub fn heights(&self, plane: &Plane) -> [f64; 2] {
        let along = plane.normal.dot(self.axes[2]);
        let across = plane.normal.cross(self.axes[2]).length();
        let middle = |end: &DVec2| plane.height(self.origin) + end.y * along;
        let low = self.ends.iter().map(|end| middle(end) - end.x * across).fold(f64::INFINITY, f64::min);
        let high = self.ends.iter().map(|end| middle(end) + end.x * across).fold(f64::NEG_INFINITY, f64::max);
        [low, high]
    }

    /// The planes of its ends, facing outward.
    pub(super) fn lids(&self) -> [Plane; 2] {
        let [low, high] = self.ends.map(|end| self.origin + end.y * self.axes[2]);
        [Plane { point: low, normal: -self.axes[2] }, Plane { point: high, normal: self.axes[2] }]
    }

    /// Whether one of its lids lies in a plane.
    pub fn stands_on(&self, plane: &Plane) -> bool {
        let touching = COINCIDENT * self.size();
        let height = |end: &DVec2| plane.height(self.origin + end.y * self.axes[2]).abs();
        let is_level = |end: &DVec2| {
            end.x * plane.normal.cross(self.axes[2]).length() + height(end) <= touching && end.x > touching
        };
        self.ends.iter().any(is_level)
    }

    /// Whether it has no height.
    fn is_disk(&self) -> bool {
        self.ends[0] == self.ends[1]
    }

    /// Largest distance between places on it, about (length).
    pub fn size(&self) -> f64 {
        let [low, high] = self.ends;
        (high.y - low.y).hypot(2.0 * low.x.max(high.x))
    }

    /// Its outline from `eye`; None where `eye` is not outside.
    pub fn outline(&self, eye: DVec3) -> Option<RoundOutline> {
        let [x, y, z] = self.local(eye);
        let place = DVec2::new(x.hypot(y), z);
        let touching = COINCIDENT * place.distance(self.ends[0]);
        let sees_lid = [self.ends[0].y - z > touching, z - self.ends[1].y > touching];
        let circle = |end: usize| {
            let Rim { center, axes, .. } = self.rim(eye, end, [0.0; 2]);
            RoundOutline::circle(center, axes)
        };
        if self.is_disk() {
            return sees_lid.contains(&true).then(|| circle(0));
        }
        let half = self.seen_half(place);
        if half == 0.0 {
            return sees_lid.iter().position(|sees| *sees).map(circle);
        }
        if half == PI {
            return sees_lid.iter().position(|sees| !sees).map(circle);
        }
        let [first, last] = [y.atan2(x) - half, y.atan2(x) + half];
        let lower = if sees_lid[0] { last - TAU } else { last };
        let upper = if sees_lid[1] { first + TAU } else { first };
        let rims = [self.rim(eye, 0, [first, lower]), self.rim(eye, 1, [last, upper])];
        Some(RoundOutline { rims: rims.into() })
    }

    fn local(&self, x: DVec3) -> [f64; 3] {
        self.axes.map(|axis| (x - self.origin).dot(axis))
    }

    /// An arc of one of its circles; of a tip the place alone.
    fn rim(&self, eye: DVec3, end: usize, angles: [f64; 2]) -> Rim {
        let DVec2 { x: radius, y: height } = self.ends[end];
        let [first, second, along] = self.axes;
        let is_tip = radius <= ROUNDING * self.size();
        let angles = if is_tip { [0.0; 2] } else { angles };
        Rim {
            center: self.origin + height * along - eye,
            axes: [first, second].map(|axis| radius * axis),
            angles,
        }
    }

    /// Whether a line from `eye` on in a direction meets it.
    pub fn is_met(&self, eye: DVec3, direction: DVec3) -> bool {
        let [x, y, z] = self.local(eye);
        let [dx, dy, dz] = self.axes.map(|axis| direction.dot(axis));
        let [low, high] = self.ends;
        let mut range = [low.y, high.y].map(|height| (height - z) / dz);
        range.sort_by(f64::total_cmp);
        let [first, last] = [range[0].max(0.0), range[1]];
        if dz == 0.0 && !(low.y..=high.y).contains(&z) || dz != 0.0 && last < first {
            return false;
        }
        // Square of the distance from the axis, less that of the wall there.
        let slope = if self.is_disk() { 0.0 } else { (high.x - low.x) / (high.y - low.y) };
        let (radius, widening) = (low.x + slope * (z - low.y), slope * dz);
        let square = dx * dx + dy * dy - widening * widening;
        let half = x * dx + y * dy - radius * widening;
        let at = |t: f64| x * x + y * y - radius * radius + t * (2.0 * half + t * square);
        let lowest = if square > 0.0 { Some(-half / square) } else { None };
        if dz == 0.0 {
            return lowest.is_some_and(|t| t > 0.0 && at(t) <= 0.0);
        }
        let lowest = lowest.map_or(first, |t| t.clamp(first, last));
        at(lowest) <= 0.0 || at(first) <= 0.0 || at(last) <= 0.0
    }

    /// The angle up to which a point sees the wall on either side of its own half-plane.
    fn seen_half(&self, place: DVec2) -> f64 {
        let [low, high] = self.ends;
        let along = (high - low).try_normalize().unwrap_or(DVec2::Y);
        let normal = DVec2::new(along.y, -along.x);
        let (level, swing) = (normal.dot(low) - normal.y * place.y, normal.x * place.x);
        match swing {
            _ if level >= swing => 0.0,
            _ if level <= -swing => PI,
            _ => (level / swing).acos(),
        }
    }

    /// Polygons that stand for its border: those of a prism.
    pub fn faces(&self) -> impl Iterator<Item = Vec<DVec3>> + '_ {
        let lids = (0..2).map(|end| (0..SIDES).map(|k| self.corner(end, k)).collect());
        let walls = (0..SIDES)
            .map(|k| [(0, k), (0, k + 1), (1, k + 1), (1, k)].map(|(end, k)| self.corner(end, k)).to_vec());
        lids.chain(walls)
    }

    /// Edges that stand for its outline from any side: those of that prism.
    pub(super) fn edges(&self) -> Vec<BlockerEdge> {
        let rims = (0..2).flat_map(|end| (0..SIDES).map(move |k| [(end, k), (end, k + 1)]));
        let generators = (0..SIDES).map(|k| [(0, k), (1, k)]);
        let ends = rims.chain(generators).map(|edge| edge.map(|(end, k)| self.corner(end, k)));
        ends.filter(|[a, b]| a.distance(*b) > COINCIDENT * self.size()).map(BlockerEdge::alone).collect()
    }

    fn corner(&self, end: usize, place: usize) -> DVec3 {
        let (sin, cos) = (TAU * place as f64 / SIDES as f64).sin_cos();
        let DVec2 { x: radius, y: height } = self.ends[end];
        self.origin + height * self.axes[2] + BEYOND_WALL * radius * (cos * self.axes[0] + sin * self.axes[1])
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::Surface;
    use radiosity_geom::shapes::{Cone, Disk, FULL_TURN};

    use super::*;

    const CENTER: DVec3 = DVec3::new(0.3, -0.2, 0.5);

    /// The frustum between circles of these radii, one disk where it has no height, about a middle at `CENTER`.
    fn frustum(axis: DVec3, [low, high]: [f64; 2], height: f64) -> Frustum {
        let meridian = match height {
            0.0 => Disk::new(CENTER, axis, low, 0.0, FULL_TURN).expect("a disk").meridian(),
            _ => {
                let along = height * axis.normalize();
                Cone::new(CENTER - 0.5 * along, along, low, high, FULL_TURN).expect("a cone").meridian()
            }
        };
        let meridian = meridian.expect("it goes all the way round");
        let lid = Disk::new(CENTER + 0.5 * height * axis.normalize(), axis, high.max(0.1), 0.0, FULL_TURN);
        let lid = lid.expect("a disk").meridian().expect("it is whole");
        Frustum::of(&meridian, std::iter::once((1, lid))).expect("it is closed")
    }

    fn vector() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array)
    }

    proptest! {
        /// Lines that meet a frustum lie in the pyramid of its outline's kites, but for those near the border.
        #[test]
        fn pyramids_hold_what_is_met(
            axis in vector(),
            low in 0.05..0.6f64,
            share in prop::sample::select(vec![0.0f64, 0.3, 1.0, 1.7]),
            height in prop::sample::select(vec![0.0f64, 0.02, 0.4]),
            x in vector(),
            beside in any::<bool>(),
            targets in prop::collection::vec(vector(), 20),
        ) {
            prop_assume!(axis.length() > 0.1);
            let scaled = |scale: f64| frustum(axis, [scale * low, scale * share * low], scale * height);
            // From beside a disk its near and its far half are seen as two arcs.
            let x = if beside { 2.0 * x + CENTER } else { x + CENTER + 1.5 * axis.normalize() };
            prop_assume!(x.distance(CENTER) > 1.2 * low.max(share * low) + height);
            let Some(pyramid) = scaled(1.0).outline(x).and_then(|outline| outline.pyramid(x, 128)) else {
                return Ok(());
            };
            for target in targets {
                let direction = CENTER + low * target - x;
                let is_hidden = pyramid.hides(x + direction);
                prop_assert!(is_hidden || !scaled(0.99).is_met(x, direction), "{direction} is lost");
                prop_assert!(!is_hidden || scaled(1.01).is_met(x, direction), "{direction} is won");
            }
        }
    }
}
