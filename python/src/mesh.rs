//! Faces of meshes → named polygons, coplanar neighbours merged as readers of mesh files merge them.

use numpy::ndarray::arr2;
use numpy::{PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use radiosity::formats::mesh::{Coat, Mesh};
use radiosity::formats::model::{Model, Shape, Sides, Surface};
use radiosity::geom::DVec3;

use crate::arrays::points;
use crate::error::Trouble;
use crate::work::work;

/// A surface: its name, the index of its label, and its rings (k, 3), of which the first is the outline and
/// the others are holes; or the four corners of a bilinear patch, where the last is true.
type NamedRings<'py> = (String, usize, Vec<Bound<'py, PyArray2<f64>>>, bool);

/// The polygons that faces make, each label an object of its own.
///
/// Face i has the corners `corners[ends[i − 1] .. ends[i]]`, indices of `vertices` (v, 3), counter-clockwise
/// seen from its front, and the label `labels[i]`, an index of `names`.
#[pyfunction]
pub(crate) fn mesh_polygons<'py>(
    py: Python<'py>,
    vertices: PyReadonlyArray2<'_, f64>,
    corners: PyReadonlyArray1<'_, i64>,
    ends: PyReadonlyArray1<'_, i64>,
    labels: PyReadonlyArray1<'_, i64>,
    names: Vec<String>,
) -> PyResult<Vec<NamedRings<'py>>> {
    let vertices = points("vertices", &vertices)?;
    let faces = Faces { corners: corners.as_slice()?, ends: ends.as_slice()?, labels: labels.as_slice()? };
    let model = work(py, None, |_| model(&vertices, &faces, &names))?;
    Ok(rings(py, model))
}

/// Faces with their coplanar neighbours merged.
fn model(vertices: &[DVec3], faces: &Faces<'_>, names: &[String]) -> Result<Model, Trouble> {
    let mut mesh = Mesh::default();
    let objects: Vec<usize> = names.iter().map(|name| mesh.object(Some(name))).collect();
    // The material stands for the label: it stays with a face while faces are merged.
    for (index, (face, label)) in faces.iter().enumerate() {
        let refused = |message: String, cure: &str| Trouble::new(format!("faces[{index}]: {message}"), cure);
        let object = usize::try_from(label).ok().and_then(|label| objects.get(label)).copied();
        let object = object
            .ok_or_else(|| refused(format!("the label {label} has no name"), "give a name for each label"))?;
        let corners = face.and_then(|face| face.iter().map(|corner| vertex(vertices, *corner)).collect());
        let corners: Vec<DVec3> = corners.ok_or_else(|| {
            let message = format!("a corner is none of the {} vertices", vertices.len());
            refused(message, "give indices of rows of `vertices`, counted from 0")
        })?;
        let coat = Coat { object, material: Some(object), sides: Sides::Front };
        let place = radiosity::photometry::file_place::FilePlace::Line(index);
        mesh.face(corners, coat, place).map_err(|fault| refused(fault.cause, &fault.cure))?;
    }
    mesh.finish("faces").map_err(|fault| Trouble::new(fault.cause, fault.cure))
}

/// Faces as lists of corners, one behind the other.
struct Faces<'a> {
    corners: &'a [i64],
    ends: &'a [i64],
    labels: &'a [i64],
}

impl<'a> Faces<'a> {
    /// The corners of each face, if they are there, and its label.
    fn iter(&self) -> impl Iterator<Item = (Option<&'a [i64]>, i64)> {
        let mut start = 0;
        let corners = self.corners;
        self.ends.iter().zip(self.labels).map(move |(end, label)| {
            let end = usize::try_from(*end).unwrap_or(usize::MAX);
            let face = corners.get(start..end);
            start = end;
            (face, *label)
        })
    }
}

fn vertex(vertices: &[DVec3], index: i64) -> Option<DVec3> {
    usize::try_from(index).ok().and_then(|index| vertices.get(index)).copied()
}

fn rings(py: Python<'_>, model: Model) -> Vec<NamedRings<'_>> {
    let array = |ring: Vec<DVec3>| {
        let rows: Vec<[f64; 3]> = ring.into_iter().map(DVec3::into).collect();
        PyArray2::from_owned_array(py, arr2(&rows))
    };
    let surfaces = model.surfaces.into_iter().filter_map(|Surface { name, material, shape, .. }| {
        let (rings, is_patch) = match shape {
            Shape::Polygon { outline, holes } => ([vec![outline], holes].concat(), false),
            Shape::Quad(corners) => (vec![corners.to_vec()], true),
            // Faces make no others.
            _ => return None,
        };
        let rings = rings.into_iter().map(array).collect();
        Some((name, material?, rings, is_patch))
    });
    surfaces.collect()
}
