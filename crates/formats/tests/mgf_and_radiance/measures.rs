//! Measures of tests: areas and fronts of shapes; files in memory.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::io;

use glam::DVec3;
use radiosity_formats::files::Files;
use radiosity_formats::model::{Model, Shape, Surface};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::place::Place;

/// Files by their names.
#[derive(Default)]
pub(crate) struct Memory(pub(crate) HashMap<&'static str, &'static str>);

impl Files for Memory {
    fn bytes(&self, name: &str) -> io::Result<Vec<u8>> {
        self.0.get(name).map(|text| text.as_bytes().to_vec()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// Twice the area of an outline times its normal (Newell).
pub(crate) fn doubled(outline: &[DVec3]) -> DVec3 {
    (0..outline.len()).map(|k| outline[k].cross(outline[(k + 1) % outline.len()])).sum()
}

/// Area of a shape; of a quad that of its two triangles.
pub(crate) fn area(shape: &Shape) -> f64 {
    match shape {
        Shape::Polygon { outline, holes } => {
            0.5 * (doubled(outline).length() - holes.iter().map(|hole| doubled(hole).length()).sum::<f64>())
        }
        Shape::Quad([a, b, c, d]) => {
            0.5 * (doubled(&[*a, *b, *c]).length() + doubled(&[*a, *c, *d]).length())
        }
        Shape::Disk { radius, inner, .. } => PI * (radius * radius - inner * inner),
        Shape::Cylinder { axis, radius, .. } => 2.0 * PI * radius * axis.length(),
        Shape::Cone { axis, radii: [a, b], .. } => PI * (a + b) * (a - b).hypot(axis.length()),
        Shape::Sphere { radius, .. } => 4.0 * PI * radius * radius,
        Shape::Torus { major, minor, .. } => 4.0 * PI * PI * major * minor,
    }
}

/// The surface of a name.
pub(crate) fn named<'a>(model: &'a Model, name: &str) -> &'a Surface {
    let names: Vec<&str> = model.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    model
        .surfaces
        .iter()
        .find(|surface| surface.name == name)
        .unwrap_or_else(|| panic!("{name} in {names:?}"))
}

/// Six squares of area 1 around the middle of the unit cube, whose fronts look outwards.
pub(crate) fn assert_unit_cube(model: &Model) {
    assert_eq!(model.surfaces.len(), 6);
    let mut normals = Vec::new();
    for surface in &model.surfaces {
        let Shape::Polygon { outline, holes } = &surface.shape else { panic!("{surface:?}") };
        assert!(holes.is_empty() && outline.len() == 4);
        assert!((area(&surface.shape) - 1.0).abs() < 1e-15);
        let normal = 0.5 * doubled(outline);
        let middle = outline.iter().sum::<DVec3>() / 4.0;
        assert!((middle - 0.5 - 0.5 * normal).length() < 1e-15, "{surface:?}");
        normals.push(normal);
    }
    assert!(normals.iter().sum::<DVec3>().length() < 1e-15);
}

/// Asserts that a refusal names file and line and says cause and cure with these words.
pub(crate) fn assert_refused(
    found: Result<Model, Refusal>,
    file: &str,
    line: usize,
    [cause, cure]: [&str; 2],
) {
    let refusal = found.expect_err(cause);
    assert_eq!((refusal.file.as_str(), refusal.place), (file, Some(Place::Line(line))), "{refusal:?}");
    assert!(refusal.cause.contains(cause), "{cause}: {refusal:?}");
    assert!(refusal.cure.contains(cure) && !refusal.cure.is_empty(), "{cure}: {refusal:?}");
}

/// The texts of a model's notes.
pub(crate) fn notes(model: &Model) -> Vec<&str> {
    model.notes.iter().map(|note| note.text.as_str()).collect()
}
