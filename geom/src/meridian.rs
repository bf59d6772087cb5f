//! Straight meridians: surfaces that a segment sweeps as it turns about an axis all the way round.
//!
//! The segment runs in the half-plane of (r, z), r ≥ 0 the distance from the axis and z the height along it. A
//! cylinder, a cone, a disk and a ring have such a meridian, and with them every part between two parallels.

use glam::{DVec2, DVec3};

use crate::{Motion, ROUNDING};

/// The meridian of a surface of revolution that goes all the way round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meridian {
    /// Place of height 0 on the axis.
    pub origin: DVec3,
    /// Unit vector along the axis.
    pub axis: DVec3,
    /// The ends (r, z), at the parameters v = −1 and v = 1, between which places are linear in v.
    pub ends: [DVec2; 2],
    /// Unit normal of the front, its parts away from the axis and along it.
    pub normal: DVec2,
}

impl Meridian {
    /// The segment between `ends`, whose front is the outside where it runs upward.
    pub(crate) fn new(origin: DVec3, axis: DVec3, ends: [DVec2; 2]) -> Self {
        let along = (ends[1] - ends[0]).normalize();
        Self { origin, axis, ends, normal: DVec2::new(along.y, -along.x) }
    }

    /// The meridian with front and back exchanged.
    pub(crate) fn flipped(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    /// The meridian after a motion.
    pub(crate) fn moved(self, motion: &Motion) -> Self {
        Self {
            origin: motion.point(self.origin),
            axis: motion.direction(self.axis),
            ends: self.ends.map(|end| motion.scale() * end),
            normal: self.normal,
        }
    }

    /// The part over a range of v.
    pub fn part(self, range: [f64; 2]) -> Self {
        let [first, last] = self.ends;
        Self { ends: range.map(|v| first.lerp(last, 0.5 * (1.0 + v))), ..self }
    }

    /// The meridian with heights from the origin and along the axis of `other`; None where the axes differ
    /// by more than rounding.
    pub fn beside(self, other: &Self) -> Option<Self> {
        let sign = self.axis.dot(other.axis).signum();
        let between = self.origin - other.origin;
        let height = between.dot(other.axis);
        let size = self.size().max(other.size()).max(height.abs());
        let is_coaxial = self.axis.cross(other.axis).length() <= ROUNDING
            && (between - height * other.axis).length() <= ROUNDING * size;
        let turned = |end: DVec2| DVec2::new(end.x, height + sign * end.y);
        is_coaxial.then(|| Self {
            origin: other.origin,
            axis: other.axis,
            ends: self.ends.map(turned),
            normal: DVec2::new(self.normal.x, sign * self.normal.y),
        })
    }

    /// Least and largest distance from the axis.
    pub fn radii(&self) -> [f64; 2] {
        let [first, last] = self.ends.map(|end| end.x);
        [first.min(last), first.max(last)]
    }

    /// Lowest and highest place along the axis.
    pub fn heights(&self) -> [f64; 2] {
        let [first, last] = self.ends.map(|end| end.y);
        [first.min(last), first.max(last)]
    }

    /// Largest distance of its ends from the origin (length).
    pub fn size(&self) -> f64 {
        self.ends[0].length().max(self.ends[1].length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Cone, Cylinder, Disk, FULL_TURN};
    use crate::{DQuat, Flipped, Placed, Surface};

    fn shapes() -> Vec<Box<dyn Surface>> {
        let axis = DVec3::new(1.0, 2.0, 2.0);
        let cone = Cone::new(DVec3::ONE, axis, 1.0, 0.25, FULL_TURN).unwrap();
        let tube = Cylinder::new(DVec3::ONE, axis, 0.5, FULL_TURN).unwrap();
        let ring = Disk::new(DVec3::ONE, axis, 2.0, 0.5, FULL_TURN).unwrap();
        vec![Box::new(cone), Box::new(tube), Box::new(ring)]
    }

    /// Places and normals of the surface lie on the turned meridian, flipped, moved and seen along the reverse
    /// axis too.
    #[test]
    fn surfaces_are_their_turned_meridians() {
        let motion = Motion::rigid(DQuat::from_axis_angle(DVec3::Y, 0.7), DVec3::new(3.0, -1.0, 2.0));
        for (base, same) in shapes().into_iter().zip(shapes()) {
            let moved: Box<dyn Surface> = Box::new(Placed::new(Box::new(Flipped::new(same)), motion));
            for surface in [base, moved] {
                let own = surface.meridian().expect("it is swept by a segment");
                let other = Meridian { origin: own.origin + 0.3 * own.axis, axis: -own.axis, ..own };
                for seen in [own, own.beside(&other).expect("they are coaxial")] {
                    for v in [-1.0, -0.2, 0.9] {
                        let jet = surface.jet(0.4, v);
                        let [place, _] = seen.part([v, 1.0]).ends;
                        let local = jet.position - seen.origin;
                        let height = local.dot(seen.axis);
                        let away = local - height * seen.axis;
                        let normal = DVec2::new(jet.normal.dot(away.normalize()), jet.normal.dot(seen.axis));
                        assert!((DVec2::new(away.length(), height) - place).length() < 1e-14);
                        assert!((normal - seen.normal).length() < 1e-14);
                    }
                }
            }
        }
    }

    #[test]
    fn half_turns_have_none_and_axes_apart_are_told() {
        let half = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, [0.0, 3.0]).unwrap();
        assert_eq!(half.meridian(), None);
        let at = |x: f64| {
            let tube = Cylinder::new(DVec3::new(x, 0.0, 0.0), DVec3::Z, 1.0, FULL_TURN).unwrap();
            tube.meridian().expect("it goes round")
        };
        assert!(at(1e-9).beside(&at(0.0)).is_none() && at(1e-14).beside(&at(0.0)).is_some());
    }
}
