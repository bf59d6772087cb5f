//! Wavefront OBJ with MTL (Wavefront Technologies, *Advanced Visualizer*, appendices B1 *Object Files* and B2
//! *MTL Material Format*).
//!
//! Faces (`f`) keep all their corners; those of an object (`o`, `g`: the latest one names it) that are
//! coplanar and of one material are [merged](crate::merge). Four corners off their plane make a bilinear
//! patch. Fronts are the sides from which corners run counter-clockwise. Normals, texture coordinates and
//! smoothing are ignored; points, lines and free-form curves and surfaces are left out and noted.
//!
//! Of materials `Kd` is the reflectance; without it a material is black. `Ke` is read as radiance, so the
//! exitance is π Ke. Textures, specular reflection and transparency are left out and noted: the mean of
//! `map_Kd` is taken for one half, what `map_Ke` makes shine is dark. A material that no MTL file describes,
//! as where the file is missing, reflects one half, which is noted: a side file may say better.

mod statements;
mod mtl;
mod faces;
mod bridge;
pub mod write;

use std::collections::{HashMap, HashSet};
use std::f64::consts::PI;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::{Files, Unread};
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::decoded;
use radiosity_photometry::text::short;

use crate::colour::UNKNOWN;
use crate::mesh::Mesh;
use crate::model::{Material, Model};
use crate::tolerances::MOST_BYTES_OF_TEXT;
use faces::{Faces, Library, MaterialUse};
use mtl::Mtl;
use statements::statements;

/// Parts that a file without faces lacks, for messages.
pub(crate) const FACES: &str = "faces (f)";

/// Reads an OBJ of the name `file` and the material files that it names.
///
/// # Errors
/// Statements that OBJ and MTL do not have, numbers that are none, corners that no vertex is listed for, no
/// faces.
pub fn read(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let read = || {
        let faces = faces(bytes)?;
        let mut mesh = Mesh::default();
        mesh.model.bands = ["r", "g", "b"].map(str::to_owned).to_vec();
        let known = libraries(&faces.libraries, files, &mut mesh.model)?;
        for MaterialUse { name, line } in &faces.materials {
            add_material(&mut mesh.model, name, known.get(name), *line)?;
        }
        note_unused(&known, &faces.materials, &mut mesh.model);
        faces.add_to(&mut mesh)?;
        mesh.finish(FACES)
    };
    read().map_err(|refusal: Refusal| refusal.in_file(file))
}

/// The mesh of an OBJ without its materials, whose faces are flat for whoever reads it, or may be smooth.
pub(crate) fn shapes(bytes: &[u8], is_faceted: bool) -> Result<Mesh, Refusal> {
    let mut mesh = Mesh::faceted(is_faceted);
    faces(bytes)?.without_materials().add_to(&mut mesh)?;
    Ok(mesh)
}

fn faces(bytes: &[u8]) -> Result<Faces, Refusal> {
    let text = decoded(bytes)?;
    let mut faces = Faces::default();
    for (line, statement) in statements(&text) {
        let taken = faces.statement(&statement, line);
        taken.map_err(|refusal| refusal.at(FilePlace::Line(line)))?;
    }
    Ok(faces)
}

/// The materials of all material files by name; of several of one name the first. Files that cannot be read
/// are noted.
fn libraries(
    libraries: &[Library],
    files: &dyn Files,
    model: &mut Model,
) -> Result<HashMap<String, Mtl>, Refusal> {
    let (mut known, mut read) = (HashMap::new(), HashSet::new());
    let mut size = 0;
    let mut missing: Vec<(NoteText, usize)> = Vec::new();
    for Library { names, line } in libraries {
        for (name, bytes) in bytes(names, &read, files) {
            read.insert(name.clone());
            let bytes = match bytes {
                Ok(bytes) => bytes,
                Err(Unread::Outside) => {
                    let refusal = Unread::Outside.refusal(&format!("the mtllib '{}'", short(&name)), "");
                    return Err(refusal.at(FilePlace::Line(*line)));
                }
                Err(error) => {
                    let text = NoteText::from("the material file ")
                        .quoting(format!("'{}'", short(&name)))
                        .then(format!(" cannot be read: {error}"));
                    missing.push((text, *line));
                    continue;
                }
            };
            size += bytes.len();
            if size > MOST_BYTES_OF_TEXT {
                return refuse_at(
                    FilePlace::Line(*line),
                    format!("the material files are longer than {MOST_BYTES_OF_TEXT} bytes"),
                    "name only those that the model needs",
                );
            }
            let text = decoded(&bytes).map_err(|refusal| refusal.in_file(&name))?;
            mtl::read(&text, &name, &mut known).map_err(|refusal| refusal.in_file(&name))?;
        }
    }
    let count = missing.len();
    if let Some((first, line)) = missing.into_iter().next() {
        let more = if count > 1 { format!(", nor can {} more", count - 1) } else { String::new() };
        model.note(first.then(more), Some(FilePlace::Line(line)));
    }
    Ok(known)
}

/// The files that a statement names and that are not yet read: one whose name has blanks, or several.
fn bytes(names: &str, read: &HashSet<String>, files: &dyn Files) -> Vec<(String, Result<Vec<u8>, Unread>)> {
    if read.contains(names) {
        return Vec::new();
    }
    let whole = files.bytes(names);
    if !matches!(whole, Err(Unread::Failed(_))) {
        return vec![(names.to_owned(), whole)];
    }
    let each = names.split_whitespace().filter(|name| !read.contains(*name));
    each.map(|name| (name.to_owned(), files.bytes(name))).collect()
}

/// Adds the material of a name, as a material file describes it or not.
///
/// # Errors
/// A colour of it that is none.
fn add_material(model: &mut Model, name: &str, mtl: Option<&Mtl>, line: usize) -> Result<(), Refusal> {
    let place = Some(FilePlace::Line(line));
    let (reflectance, emission) = match mtl {
        Some(Mtl { fault: Some(fault), .. }) => return Err(fault.clone()),
        Some(mtl) => {
            mtl.left_out.iter().for_each(|note| note.clone().put(&mut model.notes));
            (mtl.reflectance(), mtl.radiance().map(|value| PI * value))
        }
        None => {
            let text = format!("materials that no file describes reflect {UNKNOWN}");
            model.note(NoteText::own(text), place);
            ([UNKNOWN; 3], [0.0; 3])
        }
    };
    model.materials.push(Material {
        name: name.to_owned(),
        reflectance: reflectance.to_vec(),
        emission: emission.to_vec(),
    });
    Ok(())
}

/// Notes materials with faulty colours that no face has.
fn note_unused(known: &HashMap<String, Mtl>, used: &[MaterialUse], model: &mut Model) {
    let is_used = |name: &String| used.iter().any(|own| own.name == *name);
    let mut faulty: Vec<(&String, &Refusal)> =
        known.iter().filter_map(|(name, mtl)| Some((name, mtl.fault.as_ref()?))).collect();
    faulty.retain(|(name, _)| !is_used(name));
    faulty.sort_by_key(|(name, _)| *name);
    for (name, fault) in faulty {
        let text = NoteText::from("the material ")
            .quoting(format!("'{}'", short(name)))
            .then(", which no face has, is left out: one of its colours cannot be followed");
        Note::add_in(&mut model.notes, text, Some(&fault.file.as_str().into()), fault.place);
    }
}
