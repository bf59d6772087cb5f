//! Shapes turned about an axis: `disk`, `cylinder`, `cone`, `sphere`, `torus`, `revolution`.
//!
//! Angles are in degrees here and in radians in the geometry.

use std::f64::consts::TAU;

use radiosity_formats::model::Shape;
use radiosity_geom::{
    DVec3, Motion,
    shapes::{Cone, Cylinder, Disk, FULL_TURN, Revolution, Sphere, Torus},
};
use radiosity_scene::{error::Located, tree::Node};

use crate::{
    fields::{Fields, angles, exactly, point, real},
    shape::form::{Built, Form, Modelled, moved},
};

#[derive(Debug)]
struct DiskFile {
    center: DVec3,
    normal: DVec3,
    radius: f64,
    inner_radius: f64,
    angle: [f64; 2],
}

#[derive(Debug)]
struct CylinderFile {
    base: DVec3,
    axis: DVec3,
    radius: f64,
    angle: [f64; 2],
}

#[derive(Debug)]
struct ConeFile {
    base: DVec3,
    axis: DVec3,
    radius1: f64,
    radius2: f64,
    angle: [f64; 2],
}

#[derive(Debug)]
struct SphereFile {
    center: DVec3,
    radius: f64,
    axis: DVec3,
    z: Option<[f64; 2]>,
    angle: [f64; 2],
}

#[derive(Debug)]
struct TorusFile {
    center: DVec3,
    axis: DVec3,
    major: f64,
    minor: f64,
    angle: [f64; 2],
    tube_angle: [f64; 2],
}

#[derive(Debug)]
struct RevolutionFile {
    curve: [DVec3; 4],
    center: DVec3,
    axis: DVec3,
    angle: [f64; 2],
}

pub(super) fn disk(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["center", "normal", "radius", "inner_radius", "angle"])?;
    Ok(Box::new(DiskFile {
        center: fields.require("center", point)?,
        normal: fields.require("normal", point)?,
        radius: fields.require("radius", real)?,
        inner_radius: fields.optional("inner_radius", real)?.unwrap_or(0.0),
        angle: turn(&fields, "angle")?,
    }))
}

pub(super) fn cylinder(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["base", "axis", "radius", "angle"])?;
    Ok(Box::new(CylinderFile {
        base: fields.require("base", point)?,
        axis: fields.require("axis", point)?,
        radius: fields.require("radius", real)?,
        angle: turn(&fields, "angle")?,
    }))
}

pub(super) fn cone(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["base", "axis", "radius1", "radius2", "angle"])?;
    Ok(Box::new(ConeFile {
        base: fields.require("base", point)?,
        axis: fields.require("axis", point)?,
        radius1: fields.require("radius1", real)?,
        radius2: fields.require("radius2", real)?,
        angle: turn(&fields, "angle")?,
    }))
}

pub(super) fn sphere(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["center", "radius", "axis", "z", "angle"])?;
    Ok(Box::new(SphereFile {
        center: fields.require("center", point)?,
        radius: fields.require("radius", real)?,
        axis: fields.optional("axis", point)?.unwrap_or(DVec3::Z),
        z: fields.optional("z", |node| exactly(node, "z", "heights, lowest first", real))?,
        angle: turn(&fields, "angle")?,
    }))
}

pub(super) fn torus(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["center", "axis", "major", "minor", "angle", "tube_angle"])?;
    Ok(Box::new(TorusFile {
        center: fields.require("center", point)?,
        axis: fields.require("axis", point)?,
        major: fields.require("major", real)?,
        minor: fields.require("minor", real)?,
        angle: turn(&fields, "angle")?,
        tube_angle: turn(&fields, "tube_angle")?,
    }))
}

pub(super) fn revolution(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["curve", "center", "axis", "angle"])?;
    Ok(Box::new(RevolutionFile {
        curve: fields.require("curve", |node| exactly(node, "a curve", "control points", point))?,
        center: fields.require("center", point)?,
        axis: fields.require("axis", point)?,
        angle: turn(&fields, "angle")?,
    }))
}

/// A range of angles in radians; all the way round if it is not given.
fn turn(fields: &Fields<'_>, key: &'static str) -> Result<[f64; 2], Located> {
    fields.get(key).map_or(Ok(FULL_TURN), |node| angles(node, key))
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
