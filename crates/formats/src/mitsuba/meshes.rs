//! Meshes: shapes in files of their own.

use std::collections::HashMap;
use std::rc::Rc;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::short;

use super::element::Element;
use crate::files::Files;
use crate::model::Shape;
use crate::{obj, ply};

/// A mesh: its faces, coplanar ones merged, and what was said of it.
#[derive(Debug)]
pub(super) struct Mesh {
    /// Faces of the mesh, coplanar ones merged.
    pub(super) faces: Vec<Shape>,
    /// Whether the file states normals at vertices.
    pub(super) has_normals: bool,
    /// Notes of the reader on parts of the file that were left out.
    pub(super) remarks: Vec<String>,
}

/// The meshes that were read, by their paths.
pub(super) struct Meshes<'a> {
    files: &'a dyn Files,
    known: HashMap<String, Rc<Mesh>>,
}

impl<'a> Meshes<'a> {
    /// Meshes of which none was read yet.
    pub(super) fn new(files: &'a dyn Files) -> Self {
        Meshes { files, known: HashMap::new() }
    }

    /// The mesh of a shape of type `obj` or `ply`.
    ///
    /// # Errors
    /// A file that is not named, cannot be read, or is not of its format.
    pub(super) fn of(&mut self, shape: &Element) -> Result<Rc<Mesh>, Refusal> {
        let Some(path) = shape.string("filename")? else {
            return Err(shape
                .refusal("the shape names no file", "write <string name=\"filename\" value=\"…\"/> in it"));
        };
        if let Some(known) = self.known.get(path) {
            return Ok(known.clone());
        }
        let bytes = self.files.bytes(path).map_err(|error| {
            shape.at(Refusal::new(
                format!("the mesh '{}' cannot be read: {error}", short(path)),
                "put it beside the scene, or take the shape out",
            ))
        })?;
        let has_normals = has_normals(shape.kind(), &bytes);
        let model = match shape.kind() {
            "obj" => obj::read(path, &without_materials(bytes), self.files)?,
            _ => ply::read(path, &bytes, self.files)?,
        };
        // Merging has no place; what has one was left out.
        let remarks = model.notes.iter().filter(|note| note.place.is_some()).map(|note| note.text.clone());
        let faces = model.surfaces.into_iter().map(|surface| surface.shape).collect();
        let mesh = Rc::new(Mesh { faces, has_normals, remarks: remarks.collect() });
        self.known.insert(path.to_owned(), mesh.clone());
        Ok(mesh)
    }
}

/// Whether the bytes of an OBJ (`vn`) or a PLY (`property … nx`) state normals at vertices.
fn has_normals(kind: &str, bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii);
    match kind {
        "obj" => {
            lines.any(|line| line.starts_with(b"vn") && line.get(2).is_some_and(u8::is_ascii_whitespace))
        }
        _ => lines
            .take_while(|line| *line != b"end_header")
            .any(|line| line.starts_with(b"property") && line.ends_with(b" nx")),
    }
}

/// An OBJ with the lines of materials made comments: Mitsuba follows none.
fn without_materials(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut start = 0;
    while start < bytes.len() {
        let end =
            bytes[start..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |end| start + end + 1);
        let line = &bytes[start..end];
        let blanks = line.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let word = &line[blanks..];
        if ["usemtl", "mtllib"]
            .iter()
            .any(|own| word.get(..6).is_some_and(|word| word.eq_ignore_ascii_case(own.as_bytes())))
        {
            bytes[start + blanks] = b'#';
        }
        start = end;
    }
    bytes
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
    fn lines_of_materials_become_comments() {
        let text = b"mtllib a.mtl\nv 0 0 0\n  usemtl b\r\nusemtlx\nv";
        assert_eq!(without_materials(text.to_vec()), b"#tllib a.mtl\nv 0 0 0\n  #semtl b\r\n#semtlx\nv");
        assert_eq!(["a/b.c.ply", "a\\b", "b.obj"].map(stem), ["b.c", "b", "b"]);
    }
}
