//! The unit cube, and checks that tests of all formats share: fronts, areas, notes, refusals.

use std::collections::HashMap;
use std::io;

use glam::DVec3;
use radiosity_formats::files::Files;
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

/// Asserts that the model is the unit cube, with fronts outside or inside.
pub(crate) fn assert_cube(model: &Model, outside: bool) {
    assert_eq!(model.surfaces.len(), 6, "{:?}", model.surfaces);
    let mut sum = DVec3::ZERO;
    for surface in &model.surfaces {
        let region = region(surface);
        assert!((region.area() - 1.0).abs() < 1e-12, "{}", surface.name);
        assert_eq!(region.outer().len(), 4);
        let middle = region.outer().iter().copied().sum::<DVec3>() / 4.0;
        let outwards = (middle - DVec3::splat(0.5)).dot(region.normal());
        assert!((outwards - if outside { 0.5 } else { -0.5 }).abs() < 1e-12, "{}", surface.name);
        sum += middle;
    }
    assert!(sum.distance(DVec3::splat(3.0)) < 1e-12, "the sides are six different ones");
}

/// Asserts that a refusal says this, and that its cure holds these words.
pub(crate) fn assert_refusal(result: Result<Model, Refusal>, said: &str, cure: &str) {
    let refusal = result.expect_err(said);
    assert_eq!(refusal.to_string(), said);
    assert!(refusal.cure.contains(cure), "'{}' lacks '{cure}'", refusal.cure);
}

/// The texts of the notes.
pub(crate) fn notes(model: &Model) -> Vec<&str> {
    model.notes.iter().map(|note| note.text.as_str()).collect()
}

/// The names of the surfaces.
pub(crate) fn names(model: &Model) -> Vec<&str> {
    model.surfaces.iter().map(|surface| surface.name.as_str()).collect()
}

/// Files in memory by name.
pub(crate) struct InMemory(pub(crate) HashMap<String, Vec<u8>>);

impl InMemory {
    pub(crate) fn of(files: &[(&str, &[u8])]) -> Self {
        InMemory(files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect())
    }
}

impl Files for InMemory {
    fn bytes(&self, name: &str) -> io::Result<Vec<u8>> {
        self.0.get(name).cloned().ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "no such file"))
    }
}
