//! Meshes: faces of objects, as OBJ, STL, PLY and glTF list them, become a model of named surfaces.

use glam::DVec3;
use radiosity_fit::outline::WARPED;
use radiosity_geom::area_vector;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;

use crate::colour;
use crate::merge;
use crate::model::{Model, Shape, Sides, Surface};
use crate::names::UniqueNames;
use crate::tolerances::{GREATEST, MOST_SURFACES, MOST_VERTICES};

/// Note on normals of vertices that are not those of the faces there.
pub(crate) const ROUNDED: &str = "normals of vertices are left out: faces are flat";

/// Note on normals of vertices that point to the backs of the faces there.
pub(crate) const OPPOSED: &str = "normals of vertices that point to the back of their face are left out: the order of corners tells the front";

/// Note on smoothing of faces that meet at an angle.
pub(crate) const SMOOTHED: &str = "smoothing groups are left out: faces are flat";

/// Sine of the angle between the normal of a vertex and that of a face from which on they differ. Chosen: half a
/// degree, beyond what normals written with two digits err by.
const ROUNDED_FROM: f64 = 1e-2;

/// Whether two normals of length 1 differ, which point to one side.
pub(crate) fn is_bent(one: DVec3, other: DVec3) -> bool {
    one.cross(other).length() > ROUNDED_FROM || one.dot(other) < 0.0
}

/// Note on normals at the corners of a face that are not those of the face: light that is interpolated between them
/// makes flat faces look round, and where they point to the back the front is another one.
pub(crate) fn remark_on_normals(
    corners: &[DVec3],
    normals: impl IntoIterator<Item = DVec3>,
) -> Option<&'static str> {
    let own = area_vector(corners).try_normalize()?;
    let mut bent =
        normals.into_iter().filter_map(DVec3::try_normalize).filter(|normal| is_bent(*normal, own));
    let first = bent.next()?;
    let is_opposed = first.dot(own) < 0.0 && bent.all(|normal| normal.dot(own) < 0.0);
    Some(if is_opposed { OPPOSED } else { ROUNDED })
}

/// Object, material and sides of faces.
#[derive(Clone, Copy, Debug)]
pub struct Coat {
    /// Index of the object, of [`Mesh::object`].
    pub object: usize,
    /// Index of the material in the model.
    pub material: Option<usize>,
    /// Sides of the faces that reflect and emit.
    pub sides: Sides,
}

/// A model that grows by faces.
#[derive(Debug, Default)]
pub struct Mesh {
    /// The model: materials, notes and the camera are added to it directly.
    pub(crate) model: Model,
    /// Whether the file states normals at vertices.
    pub(crate) has_normals: bool,
    names: Vec<Option<String>>,
    objects: Vec<usize>,
    corners: usize,
}

impl Mesh {
    /// A new object and its index; without a name its faces are called by their kinds.
    pub fn object(&mut self, name: Option<&str>) -> usize {
        self.names.push(name.map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned));
        self.names.len() - 1
    }

    /// Notes normals at the corners of a face that are not those of the face.
    pub(crate) fn note_rounding(
        &mut self,
        corners: &[DVec3],
        normals: impl IntoIterator<Item = DVec3>,
        place: FilePlace,
    ) {
        if let Some(remark) = remark_on_normals(corners, normals) {
            self.model.note(remark, Some(place));
        }
    }

    /// Adds a face with its corners counter-clockwise about its front. Four corners off their plane make a
    /// quad.
    ///
    /// # Errors
    /// Fewer than three corners, coordinates beyond measure, too many faces.
    pub fn face(&mut self, corners: Vec<DVec3>, coat: Coat, place: FilePlace) -> Result<(), Refusal> {
        if corners.len() < 3 {
            return refuse(
                format!("a face has {} corners, 3 are the least", corners.len()),
                "take the face out, or give it three corners",
            );
        }
        if !corners.iter().all(|corner| corner.is_finite() && corner.abs().max_element() <= GREATEST) {
            return refuse(
                format!("a coordinate is beyond {GREATEST:e}"),
                "correct it, or scale the model down",
            );
        }
        self.corners += corners.len();
        if self.objects.len() >= MOST_SURFACES || self.corners > MOST_VERTICES {
            return refuse(
                format!("more than {MOST_SURFACES} faces or {MOST_VERTICES} corners"),
                "split the model",
            );
        }
        let shape = Shape::face(corners);
        if matches!(shape, Shape::Quad(_)) {
            self.model.note(WARPED, Some(place));
        }
        let Coat { object, material, sides } = coat;
        self.objects.push(object);
        self.model.surfaces.push(Surface {
            name: String::new(),
            material,
            shape,
            sides,
            file: None,
            place: Some(place),
        });
        Ok(())
    }

    /// The model: coplanar faces of an object merged, surfaces named by their objects, colours settled.
    ///
    /// # Errors
    /// No faces; `what` names what the file lacks: "faces (f)".
    pub fn finish(mut self, what: &str) -> Result<Model, Refusal> {
        if self.model.surfaces.is_empty() {
            return refuse(
                format!("the file holds no {what}"),
                "save the model with polygons, or name its format",
            );
        }
        merge::coplanar(&mut self.model, &mut self.objects);
        self.name();
        colour::settle(&mut self.model);
        Ok(self.model)
    }

    /// Names: the object's if it has one surface, else with a number behind it.
    fn name(&mut self) {
        let mut counts = vec![0_usize; self.names.len()];
        for object in &self.objects {
            counts[*object] += 1;
        }
        let mut names = UniqueNames::default();
        let mut numbers = vec![0_usize; self.names.len()];
        for (index, (surface, object)) in self.model.surfaces.iter_mut().zip(&self.objects).enumerate() {
            numbers[*object] += 1;
            let wanted = match &self.names[*object] {
                Some(name) if counts[*object] == 1 => name.clone(),
                Some(name) => format!("{name}-{}", numbers[*object]),
                None => format!("{}-{}", surface.shape.kind(), index + 1),
            };
            surface.name = names.take(&wanted);
        }
    }
}
