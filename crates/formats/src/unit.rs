//! Units of length: a model in millimetres becomes one in metres.

use std::str::FromStr;

use glam::DVec3;

use crate::model::{Model, Shape};

/// Units with their lengths in metres, as quotients of whole numbers. Inch, foot and yard: international yard
/// and pound agreement, 1959.
const UNITS: [(&str, [f64; 2]); 7] = [
    ("mm", [1.0, 1e3]),
    ("cm", [1.0, 1e2]),
    ("dm", [1.0, 1e1]),
    ("m", [1.0, 1.0]),
    ("in", [254.0, 1e4]),
    ("ft", [3048.0, 1e4]),
    ("yd", [9144.0, 1e4]),
];

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// Length of the unit in metres: numerator and denominator. A thousandth has no binary digits, dividing
    /// by 1000 rounds once: 9 mm are 0.009 m.
    metres: [f64; 2],
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
    /// Turns a model in this unit into one in metres. Reflectances and exitances stay what they are.
    pub fn to_metres(self, model: &mut Model) {
        if self.metres == [1.0; 2] {
            return;
        }
        model.surfaces.iter_mut().for_each(|surface| surface.shape = self.scaled(&surface.shape));
        if let Some(camera) = &mut model.camera {
            [camera.eye, camera.target] = [camera.eye, camera.target].map(|x| self.point(x));
        }
    }

    /// A shape with its lengths in metres; directions stay.
    fn scaled(self, shape: &Shape) -> Shape {
        shape.map(|x| self.point(x), |x| self.point(x), |direction| direction, |length| self.length(length))
    }

    fn point(self, point: DVec3) -> DVec3 {
        let [numerator, denominator] = self.metres;
        point * numerator / denominator
    }

    fn length(self, length: f64) -> f64 {
        let [numerator, denominator] = self.metres;
        length * numerator / denominator
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_change_and_directions_stay() {
        let disk = Shape::Disk { center: DVec3::X, normal: DVec3::Z, radius: 2.0, inner: 1.0 };
        let small = Unit { metres: [1.0, 2.0] }.scaled(&disk);
        assert_eq!(small, Shape::Disk { center: 0.5 * DVec3::X, normal: DVec3::Z, radius: 1.0, inner: 0.5 });
        let cone = Shape::Cone { base: DVec3::X, axis: DVec3::Z, radii: [1.0, 0.0], inward: true };
        let cone = Unit { metres: [2.0, 1.0] }.scaled(&cone);
        let large =
            Shape::Cone { base: 2.0 * DVec3::X, axis: 2.0 * DVec3::Z, radii: [2.0, 0.0], inward: true };
        assert_eq!(cone, large);
    }

    #[test]
    fn whole_numbers_become_the_decimals_that_they_mean() {
        for (name, decimals) in [("mm", 3), ("cm", 2), ("dm", 1)] {
            let unit: Unit = name.parse().expect("a unit");
            for k in 0..20_000_u32 {
                let length = unit.length(f64::from(k));
                let whole = 10_u32.pow(decimals);
                let text = format!("{}.{:0width$}", k / whole, k % whole, width = decimals as usize);
                assert_eq!(length, text.parse::<f64>().expect("a number"), "{k} {name}");
            }
        }
        assert_eq!("in".parse::<Unit>().expect("a unit").length(1.0), 0.0254);
    }

    #[test]
    fn units_are_known_by_name() {
        assert_eq!("mm".parse(), Ok(Unit { metres: [1.0, 1e3] }));
        assert!("furlong".parse::<Unit>().is_err());
    }
}
