//! Shapes turned about an axis: `disk`, `cylinder`, `cone`, `sphere`, `torus`, `revolution`.
//!
//! Angles are in degrees here and in radians in the geometry.

use std::f64::consts::TAU;

use radiosity_formats::model::Shape;
use radiosity_geom::{
    DVec3, Motion,
    shapes::{Cone, Cylinder, Disk, Revolution, Sphere, Torus},
};
use serde_json::json;

use crate::{
    fields::{Reader, angles, exactly, real},
    keys::{DefaultValue, ValueKind, WithDefault, keys},
    kinds::{POINT, POSITIVE, VECTOR},
    shape::{
        form::{Built, Form, Modelled, moved},
        spline::CURVE,
    },
    terms,
};

const MIDDLE: &str = "The middle";
const END: &str = "The middle of one end";
const TO_END: &str = "From the base to the other end";
const AXIS: &str = "Direction and, where it has one, height of the axis";
const TURN: &str = "From and to about the axis, degrees, at most once round";

/// A range of angles in radians; all the way round if it is not given.
const ANGLE: WithDefault<[f64; 2]> = turn(|node| angles(node, "angle"));
const TUBE_ANGLE: WithDefault<[f64; 2]> = turn(|node| angles(node, "tube_angle"));

const fn turn(read: Reader<[f64; 2]>) -> WithDefault<[f64; 2]> {
    ValueKind::new(read, || terms::exactly(2, "number", "")).or(DefaultValue::Numbers(&[0.0, 360.0]))
}

/// A radius that may be 0.
const RADIUS_OR_NONE: ValueKind<f64> =
    ValueKind::number(real, || json!({ "minimum": 0 })).example(", a length");

keys! {
    DiskFile("A disk, a ring or a sector") {
        center: DVec3 = POINT, MIDDLE;
        normal: DVec3 = VECTOR, "Direction of the front";
        radius: f64 = POSITIVE, "Radius";
        inner_radius: f64 = RADIUS_OR_NONE.or(DefaultValue::Number(0.0)), "Radius of a round hole in the middle";
        angle: [f64; 2] = ANGLE, TURN;
    }
}

keys! {
    CylinderFile("The side of a cylinder, its front outside") {
        base: DVec3 = POINT, END;
        axis: DVec3 = VECTOR, TO_END;
        radius: f64 = POSITIVE, "Radius";
        angle: [f64; 2] = ANGLE, TURN;
    }
}

keys! {
    ConeFile("The side of a cone or a part of it, its front outside") {
        base: DVec3 = POINT, END;
        axis: DVec3 = VECTOR, TO_END;
        radius1: f64 = RADIUS_OR_NONE, "Radius at the base; not both are 0";
        radius2: f64 = RADIUS_OR_NONE, "Radius at the other end; not both are 0";
        angle: [f64; 2] = ANGLE, TURN;
    }
}

keys! {
    SphereFile("A sphere or a zone of it, its front outside") {
        center: DVec3 = POINT, MIDDLE;
        radius: f64 = POSITIVE, "Radius";
        axis: DVec3 = VECTOR.or(DefaultValue::Numbers(&[0.0, 0.0, 1.0])), AXIS;
        z: Option<[f64; 2]> = ValueKind::new(
            |node| exactly(node, "z", "heights, lowest first", real),
            || terms::exactly(2, "number", ""),
        ), "Lowest and highest height along the axis, from the middle";
        angle: [f64; 2] = ANGLE, TURN;
    }
}

keys! {
    TorusFile("A torus or a part of it, its front outside") {
        center: DVec3 = POINT, MIDDLE;
        axis: DVec3 = VECTOR, AXIS;
        major: f64 = POSITIVE, "Radius of the circle along which the tube runs";
        minor: f64 = POSITIVE, "Radius of the tube";
        angle: [f64; 2] = ANGLE, TURN;
        tube_angle: [f64; 2] = TUBE_ANGLE, TURN;
    }
}

keys! {
    RevolutionFile("A curve turned about an axis") {
        curve: [DVec3; 4] = CURVE, "Control points of a cubic Bézier curve";
        center: DVec3 = POINT, "A point of the axis";
        axis: DVec3 = VECTOR, AXIS;
        angle: [f64; 2] = ANGLE, TURN;
    }
}

/// Angles nearer to a full turn than this are one, radians: degrees leave some roundings. With a larger value
/// narrow slits that were meant would close.
const WHOLE: f64 = 1e-12;

/// Whether all these ranges are full turns.
fn are_whole(angles: &[[f64; 2]]) -> bool {
    angles.iter().all(|[from, to]| ((to - from).abs() - TAU).abs() < WHOLE)
}

/// The shape of a model, unless angles cut it, of which a model has no notion.
fn whole(angles: &[[f64; 2]], shape: Shape) -> Modelled {
    Ok(are_whole(angles).then(|| vec![shape]))
}

impl Form for DiskFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        moved(Disk::new(self.center, self.normal, self.radius, self.inner_radius, self.angle)?, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let center = motion.point(self.center);
        let [radius, inner] = [self.radius, self.inner_radius].map(|radius| motion.scale() * radius);
        whole(&[self.angle], Shape::Disk { center, normal: motion.direction(self.normal), radius, inner })
    }
}

impl Form for CylinderFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        moved(Cylinder::new(self.base, self.axis, self.radius, self.angle)?, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let (base, axis) = (motion.point(self.base), motion.vector(self.axis));
        let radius = motion.scale() * self.radius;
        whole(&[self.angle], Shape::Cylinder { base, axis, radius, inward: false })
    }
}

impl Form for ConeFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        moved(Cone::new(self.base, self.axis, self.radius1, self.radius2, self.angle)?, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let (base, axis) = (motion.point(self.base), motion.vector(self.axis));
        let radii = [self.radius1, self.radius2].map(|radius| motion.scale() * radius);
        whole(&[self.angle], Shape::Cone { base, axis, radii, inward: false })
    }
}

impl Form for SphereFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let z = self.z.unwrap_or([-self.radius, self.radius]);
        moved(Sphere::new(self.center, self.radius, self.axis, z, self.angle)?, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let [low, high] = self.z.unwrap_or([-self.radius, self.radius]);
        if low > -self.radius || high < self.radius {
            return Ok(None);
        }
        let (center, radius) = (motion.point(self.center), motion.scale() * self.radius);
        whole(&[self.angle], Shape::Sphere { center, radius, inward: false })
    }
}

impl Form for TorusFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let TorusFile { center, axis, major, minor, angle, tube_angle } = *self;
        moved(Torus::new(center, axis, major, minor, angle, tube_angle)?, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let (center, axis) = (motion.point(self.center), motion.direction(self.axis));
        let [major, minor] = [self.major, self.minor].map(|radius| motion.scale() * radius);
        whole(&[self.angle, self.tube_angle], Shape::Torus { center, axis, major, minor, inward: false })
    }
}

impl Form for RevolutionFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        moved(Revolution::new(self.curve, self.center, self.axis, self.angle)?, motion)
    }
}
