//! PLY, the polygon file format (G. Turk, *The PLY Polygon File Format*, 1994), as text and binary of both
//! byte orders.
//!
//! Of `vertex` elements x, y and z are read, of `face` elements and of `tristrips` the list `vertex_indices` or
//! `vertex_index`; corners run counter-clockwise seen from the front. Faces keep all their corners; coplanar ones are
//! [merged](crate::merge). There are no materials and no units: colours are left out, other elements and
//! properties are skipped.

mod header;
mod numbers;
mod elements;

use crate::mesh::Mesh;
use crate::model::Model;
use elements::Elements;
use header::{Encoding, Header};
use numbers::{Bits, Words};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::files::Files;

/// Parts that a file without faces lacks, for messages.
pub(crate) const FACES: &str = "faces with a list vertex_indices";

/// Reads a PLY of the name `file`. It names no other files.
///
/// # Errors
/// A header that is not understood, counts beyond what is there, corners that no vertex is listed for, no
/// faces.
pub fn read(file: &str, bytes: &[u8], _files: &dyn Files) -> Result<Model, Refusal> {
    mesh(bytes, false).and_then(|mesh| mesh.finish(FACES)).map_err(|refusal| refusal.in_file(file))
}

/// The mesh of a PLY, whose faces are flat for whoever reads it, or may be smooth.
pub(crate) fn mesh(bytes: &[u8], is_faceted: bool) -> Result<Mesh, Refusal> {
    let header = Header::of(bytes)?;
    let mut mesh = Mesh::faceted(is_faceted);
    mesh.model.bands = vec!["grey".to_owned()];
    let mut properties = header.elements.iter().flat_map(|element| &element.properties);
    mesh.has_normals = properties.any(|property| property.name == "nx");
    let mut elements = Elements::default();
    match header.encoding {
        Encoding::Text => {
            let text = String::from_utf8_lossy(&bytes[header.body..]);
            elements.read(&header, &mut Words::of(&text, header.lines), &mut mesh)?;
        }
        Encoding::Little | Encoding::Big => {
            let is_big = header.encoding == Encoding::Big;
            elements.read(&header, &mut Bits::of(bytes, header.body, is_big), &mut mesh)?;
        }
    }
    elements.add_faces(&mut mesh)?;
    Ok(mesh)
}
