//! Promises that readers keep whatever they are given.

use glam::DVec3;
use radiosity_formats::model::{Model, Shape};
use radiosity_photometry::error::Refusal;

/// All numbers of a shape, and what else tells it from others.
pub(crate) fn parts(shape: &Shape) -> (Vec<DVec3>, Vec<f64>, Vec<usize>) {
    match shape {
        Shape::Polygon { outline, holes } => (
            outline.iter().chain(holes.iter().flatten()).copied().collect(),
            vec![],
            std::iter::once(outline.len()).chain(holes.iter().map(Vec::len)).collect(),
        ),
        Shape::Quad(corners) => (corners.to_vec(), vec![], vec![]),
        Shape::Disk { center, normal, radius, inner } => {
            (vec![*center, *normal], vec![*radius, *inner], vec![])
        }
        Shape::Cylinder { base, axis, radius, inward } => {
            (vec![*base, *axis], vec![*radius], vec![usize::from(*inward)])
        }
        Shape::Cone { base, axis, radii, inward } => {
            (vec![*base, *axis], radii.to_vec(), vec![usize::from(*inward)])
        }
        Shape::Sphere { center, radius, inward } => {
            (vec![*center], vec![*radius], vec![usize::from(*inward)])
        }
        Shape::Torus { center, axis, major, minor, inward } => {
            (vec![*center, *axis], vec![*major, *minor], vec![usize::from(*inward)])
        }
    }
}

/// Asserts that a refusal says cause and file, and that numbers of a model are numbers, materials are there
/// and have a value for each band, and polygons have corners.
#[track_caller]
pub(crate) fn assert_promised(found: &Result<Model, Refusal>) {
    let model = match found {
        Ok(model) => model,
        Err(refusal) => {
            assert!(!refusal.cause.is_empty() && !refusal.file.is_empty(), "{refusal:?}");
            assert!(refusal.cause.len() < 500 && !refusal.cure.is_empty(), "{refusal:?}");
            return;
        }
    };
    let count = model.bands.len();
    assert!(count == 1 || count == 3, "{:?}", model.bands);
    for material in &model.materials {
        assert!(material.reflectance.len() == count && material.emission.len() == count, "{material:?}");
        let mut values = material.reflectance.iter().chain(&material.emission);
        assert!(values.all(|value| value.is_finite() && *value >= 0.0), "{material:?}");
    }
    for surface in &model.surfaces {
        assert!(surface.material.is_none_or(|index| index < model.materials.len()), "{surface:?}");
        assert!(!surface.name.trim().is_empty(), "{surface:?}");
        let (points, numbers, counts) = parts(&surface.shape);
        assert!(points.iter().all(|x| x.is_finite()) && numbers.iter().all(|x| x.is_finite()), "{surface:?}");
        let is_polygon = matches!(surface.shape, Shape::Polygon { .. });
        assert!(!is_polygon || counts.iter().all(|count| *count >= 3), "{surface:?}");
    }
    assert!(model.camera.is_none_or(|camera| camera.eye.is_finite() && camera.target.is_finite()));
}
