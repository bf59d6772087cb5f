//! Meshes: faces of objects, as OBJ, STL, PLY and glTF list them, become a model of named surfaces.

use glam::DVec3;
use radiosity_fit::outline::WARPED;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;

use crate::colour;
use crate::face_normals::FaceNormals;
use crate::merge;
use crate::model::{Model, Shape, Sides, Surface};
use crate::names::UniqueNames;
use crate::opposed_faces::OpposedFaces;
use crate::tolerances::{GREATEST, MOST_SURFACES, MOST_VERTICES};

/// Note on smoothing of faces that meet at an angle.
const SMOOTHED: &str = "smoothing groups are left out: faces are flat";

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
    /// Whether faces are flat for whoever reads them, so that no normal of theirs is lost.
    is_faceted: bool,
    opposed: OpposedFaces,
    names: Vec<Option<String>>,
    objects: Vec<usize>,
    corners: usize,
}

impl Mesh {
    /// A mesh without faces, whose normals at vertices count, or do not.
    pub(crate) fn faceted(is_faceted: bool) -> Self {
        Self { is_faceted, ..Self::default() }
    }

    /// A new object and its index; without a name its faces are called by their kinds.
    pub fn object(&mut self, name: Option<&str>) -> usize {
        self.names.push(name.map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned));
        self.names.len() - 1
    }

    /// Notes normals of a face of these sides that are not its own.
    pub(crate) fn note_normals(&mut self, normals: &FaceNormals, sides: Sides, place: FilePlace) {
        if self.is_faceted {
            return;
        }
        let note = |text: &'static str| Note { text: text.into(), file: None, place: Some(place), count: 1 };
        self.opposed.note_normals(normals, sides, note, &mut self.model.notes);
    }

    /// Notes that faces at a line are smooth where they meet others.
    pub(crate) fn note_smoothed(&mut self, line: usize) {
        if !self.is_faceted {
            self.model.note(SMOOTHED, Some(FilePlace::Line(line)));
        }
    }

    /// Notes that a normal of the face of these corners is that of its back, unless the back is a face, too.
    pub(crate) fn note_opposed(&mut self, corners: &[DVec3], text: &'static str, place: FilePlace) {
        self.opposed.add(corners, Note { text: text.into(), file: None, place: Some(place), count: 1 });
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
        std::mem::take(&mut self.opposed).note(&mut self.model);
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
