//! Units of length: a model in millimetres becomes one in metres.

use std::str::FromStr;

use glam::DVec3;

use crate::model::{Model, Shape};

/// Units with their lengths in metres. Inch, foot and yard: international yard and pound agreement, 1959.
const UNITS: [(&str, f64); 7] =
    [("mm", 1e-3), ("cm", 1e-2), ("dm", 1e-1), ("m", 1.0), ("in", 0.0254), ("ft", 0.3048), ("yd", 0.9144)];

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Its length in metres.
    metres: f64,
}

impl FromStr for Unit {
    type Err = String;

    /// A unit by its name.
    fn from_str(name: &str) -> Result<Self, String> {
        let known = UNITS.iter().find(|(unit, _)| *unit == name);
        known.map(|(_, metres)| Unit { metres: *metres }).ok_or_else(|| {
            let names: Vec<&str> = UNITS.iter().map(|(unit, _)| *unit).collect();
            format!("expected a unit of length: {}", names.join(", "))
        })
    }
}

impl Unit {
    /// The names of all units.
    pub fn names() -> impl Iterator<Item = &'static str> {
        UNITS.iter().map(|(unit, _)| *unit)
    }

    /// Turns a model in this unit into one in metres. Reflectances and exitances stay what they are.
    pub fn to_metres(self, model: &mut Model) {
        if self.metres == 1.0 {
            return;
        }
        model.surfaces.iter_mut().for_each(|surface| scale(&mut surface.shape, self.metres));
        if let Some(camera) = &mut model.camera {
            camera.eye *= self.metres;
            camera.target *= self.metres;
        }
    }
}

/// Makes a shape larger about the origin.
fn scale(shape: &mut Shape, factor: f64) {
    let all = |points: &mut [DVec3]| points.iter_mut().for_each(|point| *point *= factor);
    match shape {
        Shape::Polygon { outline, holes } => {
            all(outline);
            holes.iter_mut().for_each(|hole| all(hole));
        }
        Shape::Quad(corners) => all(corners),
        Shape::Disk { center, radius, inner, .. } => {
            *center *= factor;
            *radius *= factor;
            *inner *= factor;
        }
        Shape::Cylinder { base, axis, radius, .. } => {
            *base *= factor;
            *axis *= factor;
            *radius *= factor;
        }
        Shape::Cone { base, axis, radii, .. } => {
            *base *= factor;
            *axis *= factor;
            radii.iter_mut().for_each(|radius| *radius *= factor);
        }
        Shape::Sphere { center, radius, .. } => {
            *center *= factor;
            *radius *= factor;
        }
        Shape::Torus { center, major, minor, .. } => {
            *center *= factor;
            *major *= factor;
            *minor *= factor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_change_and_directions_stay() {
        let mut disk = Shape::Disk { center: DVec3::X, normal: DVec3::Z, radius: 2.0, inner: 1.0 };
        scale(&mut disk, 0.5);
        assert_eq!(disk, Shape::Disk { center: 0.5 * DVec3::X, normal: DVec3::Z, radius: 1.0, inner: 0.5 });
        let mut cone = Shape::Cone { base: DVec3::X, axis: DVec3::Z, radii: [1.0, 0.0], inward: true };
        scale(&mut cone, 2.0);
        let large =
            Shape::Cone { base: 2.0 * DVec3::X, axis: 2.0 * DVec3::Z, radii: [2.0, 0.0], inward: true };
        assert_eq!(cone, large);
    }

    #[test]
    fn units_are_known_by_name() {
        assert_eq!("mm".parse(), Ok(Unit { metres: 1e-3 }));
        assert!("furlong".parse::<Unit>().is_err());
    }
}
