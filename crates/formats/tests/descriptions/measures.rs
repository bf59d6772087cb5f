//! Areas and normals of polygons, and files in memory.

use std::collections::HashMap;
use std::io;

use glam::DVec3;
use radiosity_formats::files::Files;
use radiosity_formats::model::{Model, Shape, Surface};

/// ½ Σ xᵢ × xᵢ₊₁: along the front's normal, as long as the area.
pub(crate) fn vector(outline: &[DVec3]) -> DVec3 {
    outline.iter().zip(outline.iter().cycle().skip(1)).map(|(a, b)| a.cross(*b)).sum::<DVec3>() / 2.0
}

/// The vector of a polygon with its holes taken off.
pub(crate) fn polygon(surface: &Surface) -> DVec3 {
    let Shape::Polygon { outline, holes } = &surface.shape else {
        panic!("{} is no polygon: {:?}", surface.name, surface.shape)
    };
    let whole = vector(outline);
    let length = holes.iter().map(|hole| vector(hole).length()).sum::<f64>();
    whole * (1.0 - length / whole.length())
}

pub(crate) fn named<'a>(model: &'a Model, name: &str) -> &'a Surface {
    model
        .surfaces
        .iter()
        .find(|surface| surface.name == name)
        .unwrap_or_else(|| panic!("no {name}: {model:?}"))
}

/// Six unit squares around the middle of a unit cube; `sign` tells whether they face it (−1) or turn away (1).
pub(crate) fn is_unit_cube(model: &Model, middle: DVec3, sign: f64) {
    assert_eq!(model.surfaces.len(), 6);
    let mut fronts: Vec<[i64; 3]> = Vec::new();
    for surface in &model.surfaces {
        let vector = polygon(surface);
        assert!((vector.length() - 1.0).abs() < 1e-12, "{surface:?}");
        let Shape::Polygon { outline, holes } = &surface.shape else { unreachable!() };
        assert!(outline.len() == 4 && holes.is_empty());
        let from_middle = outline.iter().sum::<DVec3>() / 4.0 - middle;
        assert!((from_middle - 0.5 * sign * vector).length() < 1e-12, "{surface:?}");
        fronts.push(vector.to_array().map(|x| x.round() as i64));
    }
    fronts.sort_unstable();
    fronts.dedup();
    assert_eq!(fronts.len(), 6);
}

/// Files by name.
#[derive(Default)]
pub(crate) struct Memory(pub(crate) HashMap<&'static str, Vec<u8>>);

impl Files for Memory {
    fn bytes(&self, name: &str) -> io::Result<Vec<u8>> {
        self.0.get(name).cloned().ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "there is none"))
    }
}
