//! Meshes: shapes in files of their own.

use std::collections::HashMap;
use std::rc::Rc;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::element::Element;
use crate::model::Shape;
use crate::{obj, ply};
use radiosity_photometry::files::Files;

/// A mesh: its faces, coplanar ones merged, and what was said of it.
#[derive(Debug)]
pub(super) struct Mesh {
    /// Faces of the mesh, coplanar ones merged.
    pub(super) faces: Vec<Shape>,
    /// Whether the file states normals at vertices.
    pub(super) has_normals: bool,
    /// Notes of the reader on parts of the file that were left out.
    pub(super) remarks: Vec<NoteText>,
}

/// The meshes that were read.
pub(super) struct Meshes<'a> {
    files: &'a dyn Files,
    known: HashMap<MeshKey, Rc<Mesh>>,
}

/// By what a mesh is found: its path, and whether its faces are flat whatever its normals.
#[derive(PartialEq, Eq, Hash)]
struct MeshKey {
    path: String,
    is_flat: bool,
}

impl<'a> Meshes<'a> {
    /// Meshes of which none was read yet.
    pub(super) fn new(files: &'a dyn Files) -> Self {
        Meshes { files, known: HashMap::new() }
    }

    /// The mesh of a shape of type `obj` or `ply`, of flat faces whatever its normals, or of what these tell.
    ///
    /// # Errors
    /// A file that is not named, cannot be read, or is not of its format.
    pub(super) fn of(&mut self, shape: &Element, is_flat: bool) -> Result<Rc<Mesh>, Refusal> {
        let Some(path) = shape.string("filename")? else {
            return Err(shape
                .refusal("the shape names no file", "write <string name=\"filename\" value=\"…\"/> in it"));
        };
        let key = MeshKey { path: path.to_owned(), is_flat };
        if let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        let bytes = self.files.bytes(path).map_err(|error| {
            let what = format!("the mesh '{}'", short(path));
            shape.at(error.refusal(&what, "put it beside the scene, or take the shape out"))
        })?;
        let read = match shape.kind() {
            // Mitsuba follows no materials.
            "obj" => {
                obj::shapes(&bytes, is_flat).and_then(|mesh| Ok((mesh.has_normals, mesh.finish(obj::FACES)?)))
            }
            _ => ply::mesh(&bytes, is_flat).and_then(|mesh| Ok((mesh.has_normals, mesh.finish(ply::FACES)?))),
        };
        let (has_normals, model) = read.map_err(|refusal| refusal.in_file(path))?;
        // Merging has no place; what has one was left out.
        let remarks = model.notes.iter().filter(|note| note.place.is_some()).map(|note| note.text.clone());
        let faces = model.surfaces.into_iter().map(|surface| surface.shape).collect();
        let mesh = Rc::new(Mesh { faces, has_normals, remarks: remarks.collect() });
        self.known.insert(key, mesh.clone());
        Ok(mesh)
    }
}

/// The name of a file without its folder and its ending.
pub(super) fn stem(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stems_have_neither_folder_nor_ending() {
        assert_eq!(["a/b.c.ply", "a\\b", "b.obj"].map(stem), ["b.c", "b", "b"]);
    }
}
