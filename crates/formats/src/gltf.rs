//! glTF 2.0 (Khronos Group, *glTF 2.0 Specification*, 2.0.1): `.gltf` with buffers in the text or beside it,
//! and `.glb`.
//!
//! The nodes of the scene place meshes (section 3.5); axes stay as they are: y up, metres. Triangles, strips
//! and fans become faces (3.7.2.1); coplanar triangles of a node and a material are [merged](crate::merge).
//! Fronts are turned where a node mirrors its mesh (3.7.4). The first perspective camera is kept.
//!
//! Of a material (3.9) the base colour, less the metallic part, is the reflectance; π times the emissive
//! factor, times its strength (`KHR_materials_emissive_strength`), is the exitance. Where a texture tells
//! what is metallic, nothing is; the mean of one that colours what reflects is taken for one half, and what
//! one of emission makes shine is dark. What a radiosity scene does not have is left out and noted.

mod container;
mod json;
mod extension_set;
mod scheme;
mod extensions;
mod buffers;
mod accessor;
mod material;
mod triangles;
mod nodes;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::text::short;

use crate::mesh::Mesh;
use crate::model::Model;
use accessor::Accessors;
use json::Json;
use nodes::Nodes;
use radiosity_photometry::files::Files;
use scheme::Root;

/// Reads a glTF or GLB of the name `file` and the buffers that it names.
///
/// # Errors
/// Text that is not JSON, members that are missing or of the wrong kind, indices and ranges beyond what is
/// there, buffers that cannot be read, required extensions that are not known, no triangles.
pub fn read(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let read = mesh(bytes, files).and_then(|mesh| mesh.finish("triangles in its scene"));
    read.map_err(|refusal| refusal.in_file(file))
}

fn mesh(bytes: &[u8], files: &dyn Files) -> Result<Mesh, Refusal> {
    let parts = container::parts(bytes)?;
    let json = Json::new(&parts);
    let root: Root = json.parse(json.text(), "the file")?;
    check(&root, &json)?;
    let buffers = buffers::all(&root, &json, parts.binary, files)?;
    let mut mesh = Mesh::default();
    mesh.model.bands = ["r", "g", "b"].map(str::to_owned).to_vec();
    let finishes = material::add_all(&json, &root, &mut mesh.model)?;
    if !root.animations.is_empty() {
        mesh.model.note("animations are left out", None);
    }
    if root.scenes.len() > 1 {
        mesh.model.note("scenes of the file other than one are left out", None);
    }
    for name in root.extensions_used.iter().filter(|name| extensions::is_unknown(name)) {
        mesh.model.note(extensions::left_out(name), None);
    }
    extensions::note(&root.extensions, &root, json.place(json.text()), &mut mesh.model);
    extensions::note_all(&json, &root, &mut mesh.model);
    let accessors = Accessors::new(&json, &root, &buffers);
    Nodes::new(&json, &root, accessors, finishes, &mut mesh).add_scene()?;
    Ok(mesh)
}

/// Whether the version and the required extensions are known.
fn check(root: &Root, json: &Json) -> Result<(), Refusal> {
    let place = json.place(json.text());
    if !root.asset.version.starts_with("2.") {
        return refuse_at(
            place,
            format!("the version is '{}'", short(&root.asset.version)),
            "export the model as glTF 2.0",
        );
    }
    match root.extensions_required.iter().find(|name| !extensions::is_harmless(name)) {
        Some(name) => refuse_at(
            place,
            format!("the extension {} is required", short(name)),
            "export the model without it, without compression",
        ),
        None => Ok(()),
    }
}
