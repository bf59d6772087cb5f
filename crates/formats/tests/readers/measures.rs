//! Measures of models: areas and fronts of shapes, names, notes.

use std::f64::consts::PI;

use glam::DVec3;
use radiosity_formats::model::{Model, Shape, Surface};

/// ½ Σ xᵢ × xᵢ₊₁: along the front's normal, as long as the area (Newell).
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

/// Area of a shape; of a quad that of its two triangles.
pub(crate) fn area(shape: &Shape) -> f64 {
    match shape {
        Shape::Polygon { outline, holes } => {
            vector(outline).length() - holes.iter().map(|hole| vector(hole).length()).sum::<f64>()
        }
        Shape::Quad([a, b, c, d]) => vector(&[*a, *b, *c]).length() + vector(&[*a, *c, *d]).length(),
        Shape::Disk { radius, inner, .. } => PI * (radius * radius - inner * inner),
        Shape::Cylinder { axis, radius, .. } => 2.0 * PI * radius * axis.length(),
        Shape::Cone { axis, radii: [a, b], .. } => PI * (a + b) * (a - b).hypot(axis.length()),
        Shape::Sphere { radius, .. } => 4.0 * PI * radius * radius,
        Shape::Torus { major, minor, .. } => 4.0 * PI * PI * major * minor,
    }
}

/// The surface of a name.
pub(crate) fn named<'a>(model: &'a Model, name: &str) -> &'a Surface {
    let found = model.surfaces.iter().find(|surface| surface.name == name);
    found.unwrap_or_else(|| panic!("{name} in {:?}", names(model)))
}

/// The names of the surfaces.
pub(crate) fn names(model: &Model) -> Vec<&str> {
    model.surfaces.iter().map(|surface| surface.name.as_str()).collect()
}

/// The texts of the notes.
pub(crate) fn notes(model: &Model) -> Vec<&str> {
    model.notes.iter().map(|note| note.text.as_str()).collect()
}

/// Asserts six squares of area 1 around the middle of a unit cube, fronts outside or inside.
#[track_caller]
pub(crate) fn assert_cube(model: &Model, middle: DVec3, outside: bool) {
    assert_eq!(model.surfaces.len(), 6, "{:?}", model.surfaces);
    let sign = if outside { 1.0 } else { -1.0 };
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
