//! Building a model: surfaces are named and checked, materials told apart by name and values.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use glam::DVec3;
use radiosity_fit::outline::WARPED;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use crate::colour::settle;
use crate::face_normals::FaceNormals;
use crate::model::{Mantle, Material, Model, Shape, Sides, Surface};
use crate::names::UniqueNames;
use crate::opposed_faces::OpposedFaces;
use crate::tolerances::{GREATEST, MOST_SURFACES, MOST_VERTICES};

/// A material before it has its index.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coat {
    /// Name of the material, not yet made unique.
    pub name: String,
    /// Diffuse reflectance of red, green and blue.
    pub reflectance: [f64; 3],
    /// Exitance of red, green and blue.
    pub emission: [f64; 3],
    /// The sides that surfaces of it have.
    pub sides: Sides,
}

impl Default for Coat {
    /// Black on both sides, without a name.
    fn default() -> Self {
        Coat { name: String::new(), reflectance: [0.0; 3], emission: [0.0; 3], sides: Sides::Both }
    }
}

/// A model of red, green and blue that grows.
#[derive(Debug, Default)]
pub(crate) struct ModelBuilder {
    model: Model,
    names: UniqueNames,
    material_names: UniqueNames,
    materials: HashMap<(String, [u64; 6]), usize>,
    vertices: usize,
    /// The included file that is read; none for the main one.
    file: Option<Arc<str>>,
    /// Notes on materials that surfaces have.
    told: HashSet<Note>,
    /// Faces whose normals at vertices point to their backs.
    opposed: OpposedFaces,
}

impl ModelBuilder {
    /// Notes something in a line; what was noted before is only counted.
    pub(crate) fn note(&mut self, text: impl Into<NoteText>, line: usize) {
        Note::add_in(&mut self.model.notes, text, self.file.as_ref(), Some(FilePlace::Line(line)));
    }

    /// A note on something in a line, which is told where a surface has it.
    pub(crate) fn note_of(&self, text: &'static str, line: usize) -> Note {
        Note { text: text.into(), file: self.file.clone(), place: Some(FilePlace::Line(line)), count: 1 }
    }

    /// Notes what of the material of a surface is left out, each thing once.
    pub(crate) fn note_coat<'a>(&mut self, left_out: impl IntoIterator<Item = &'a Note>) {
        for note in left_out {
            if !self.told.contains(note) {
                self.told.insert(note.clone());
                note.clone().put(&mut self.model.notes);
            }
        }
    }

    /// Notes normals at the vertices of a face in a line, which has these sides, that are not those of the face.
    pub(crate) fn note_normals(&mut self, normals: &FaceNormals, sides: Sides, line: usize) {
        let Self { opposed, file, model, .. } = self;
        let place = Some(FilePlace::Line(line));
        let note = |text: &'static str| Note { text: text.into(), file: file.clone(), place, count: 1 };
        opposed.note_normals(normals, sides, note, &mut model.notes);
    }

    /// Puts what follows into this included file, or into the main one.
    pub(crate) fn stand_in(&mut self, file: Option<&str>) {
        self.file = file.map(Arc::from);
    }

    /// States the unit of exitance.
    pub(crate) fn unit(&mut self, unit: &str) {
        self.model.unit = Some(unit.to_owned());
    }

    /// Adds a surface of a line. Without a name it is called by its kind and number.
    ///
    /// # Errors
    /// Too many surfaces, and shapes that are too large or that have no extent.
    pub(crate) fn surface(
        &mut self,
        name: Option<&str>,
        shape: Shape,
        coat: &Coat,
        line: usize,
    ) -> Result<(), Refusal> {
        if matches!(shape, Shape::Quad(_)) {
            self.note(WARPED, line);
        }
        self.check(&shape, coat)?;
        let wanted = match name {
            Some(name) => name.to_owned(),
            None => format!("{}-{}", shape.kind(), self.model.surfaces.len() + 1),
        };
        let (name, material) = (self.names.take(&wanted), self.material(coat));
        self.model.surfaces.push(Surface {
            name,
            material: Some(material),
            shape,
            sides: coat.sides,
            file: self.file.clone(),
            place: Some(FilePlace::Line(line)),
        });
        Ok(())
    }

    /// Refuses too many surfaces, numbers beyond measure and shapes without extent.
    fn check(&mut self, shape: &Shape, coat: &Coat) -> Result<(), Refusal> {
        let (points, numbers) = shape.numbers();
        self.vertices += points.len();
        if self.model.surfaces.len() >= MOST_SURFACES || self.vertices > MOST_VERTICES {
            return refuse(
                format!("more than {MOST_SURFACES} surfaces or {MOST_VERTICES} vertices"),
                "split the scene",
            );
        }
        let mut numbers = points.iter().flat_map(|point| point.to_array()).chain(numbers);
        // Not a number is not within either.
        if !numbers.all(|number| number.abs() <= GREATEST) {
            return refuse(
                format!("a coordinate or a radius is beyond {GREATEST:e} after transforms"),
                "scale the scene down",
            );
        }
        check_size(shape)?;
        if !coat.reflectance.iter().chain(&coat.emission).all(|value| *value <= GREATEST) {
            return refuse(
                format!("the material '{}' has a value beyond {GREATEST:e}", short(&coat.name)),
                "correct its reflectance or its emission",
            );
        }
        Ok(())
    }

    /// The material of these values under this name; of the same name and other values it is another.
    fn material(&mut self, coat: &Coat) -> usize {
        let ([r, g, b], [er, eg, eb]) = (coat.reflectance, coat.emission);
        let key = (coat.name.clone(), [r, g, b, er, eg, eb].map(f64::to_bits));
        let next = self.model.materials.len();
        let index = *self.materials.entry(key).or_insert(next);
        if index == next {
            self.model.materials.push(Material {
                name: self.material_names.take(&coat.name),
                reflectance: coat.reflectance.to_vec(),
                emission: coat.emission.to_vec(),
            });
        }
        index
    }

    /// The model, in one band if it is grey.
    pub(crate) fn finish(mut self) -> Model {
        std::mem::take(&mut self.opposed).note(&mut self.model);
        self.model.bands = ["r", "g", "b"].map(str::to_owned).to_vec();
        settle(&mut self.model);
        self.model
    }
}

/// Refuses curved shapes without a radius or an axis. Flat shapes without an area are left to repair.
fn check_size(shape: &Shape) -> Result<(), Refusal> {
    let (axis, radius) = match *shape {
        Shape::Disk { normal, radius, inner, .. } => (normal, radius - inner),
        Shape::Sphere { radius, .. } => (DVec3::ONE, radius),
        Shape::Torus { axis, major, minor, .. } => (axis, major.min(minor)),
        _ => match shape.mantle() {
            Some(Mantle { axis, radii, .. }) => (axis, radii[0].max(radii[1])),
            None => return Ok(()),
        },
    };
    let kind = shape.kind();
    if radius <= 0.0 {
        return refuse(format!("a {kind} has no radius"), "give it one, or take it out");
    }
    if axis == DVec3::ZERO {
        return refuse(format!("a {kind} has no axis"), "part its ends, or take it out");
    }
    Ok(())
}
