//! STL, text and binary: triangles of solids (3D Systems, *StereoLithography Interface Specification*, 1989).
//!
//! Corners run counter-clockwise seen from the front; coplanar triangles of a solid are
//! [merged](crate::merge). Stated normals only confirm the order of the corners and are left out. Solids of
//! texts give their names to surfaces. There are no materials and no units.
//!
//! Some binary files begin with `solid` as texts do: what is as long as its number of triangles says is
//! binary.

mod bits;
mod text;

use crate::mesh::Mesh;
use crate::model::Model;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::files::Files;

/// Reads an STL of the name `file`. It names no other files.
///
/// # Errors
/// A file that ends early, keywords in wrong places, numbers that are none, no facets.
pub fn read(file: &str, bytes: &[u8], _files: &dyn Files) -> Result<Model, Refusal> {
    let mut mesh = Mesh::default();
    mesh.model.bands = vec!["grey".to_owned()];
    let read = match bits::is_binary(bytes) {
        true => bits::read(bytes, &mut mesh),
        false => text::read(bytes, &mut mesh),
    };
    read.and_then(|()| mesh.finish("facets")).map_err(|refusal| refusal.in_file(file))
}
