//! The unit cube, regions of polygons, and refusals.

use radiosity_formats::model::{Model, Shape, Surface};
use radiosity_geom::PlanarRegion;
use radiosity_photometry::error::Refusal;

/// Corners of the unit cube; the number's bits are x, y and z.
pub(crate) fn corner(number: usize) -> [f64; 3] {
    [0, 1, 2].map(|bit| ((number >> bit) & 1) as f64)
}

/// Sides of the unit cube, counter-clockwise from outside.
pub(crate) const SIDES: [[usize; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// The twelve triangles of the unit cube.
pub(crate) fn triangles() -> Vec<[usize; 3]> {
    SIDES.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect()
}

/// A polygon's region, which checks that it is sound.
pub(crate) fn region(surface: &Surface) -> PlanarRegion {
    match &surface.shape {
        Shape::Polygon { outline, holes } => PlanarRegion::new(outline.clone(), holes.clone())
            .unwrap_or_else(|error| panic!("{}: {error}", surface.name)),
        other => panic!("{} is {other:?}", surface.name),
    }
}

/// Asserts that a refusal says this, and that its cure holds these words.
pub(crate) fn assert_refusal(result: Result<Model, Refusal>, said: &str, cure: &str) {
    let refusal = result.expect_err(said);
    assert_eq!(refusal.to_string(), said);
    assert!(refusal.cure.contains(cure), "'{}' lacks '{cure}'", refusal.cure);
}
