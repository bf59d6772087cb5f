//! Mitsuba 3 scenes, `.xml` (W. Jakob et al., *Mitsuba 3*, documentation, "Scene XML file format" and "Plugin
//! reference").
//!
//! * Texts: `<default>` gives parameters values, `$name` takes them; `<include>` and `<path>` are followed,
//!   relative to the scene. `<ref id>` may stand before what it names. Names of Mitsuba 0 (`toWorld`) are
//!   read in files of its version. Entities of a file's own (`<!DOCTYPE …>`) are refused.
//! * Shapes: `rectangle`, `cube`, `disk`, `cylinder`, `sphere`; `obj` and `ply` with coplanar faces
//!   [merged](crate::merge); `shapegroup` by `instance`. Others are left out and noted. Transforms that make
//!   round shapes others are refused. What a transform mirrors keeps its front.
//! * Bsdfs: `diffuse` is on the front, `twosided` on both sides; of `plastic` and `principled` the diffuse
//!   part is taken; those that nothing diffuse is known of are black. Shapes of bsdf `null` are left out.
//!   Each is noted.
//! * Colours: linear red, green and blue; `#rrggbb` is decoded as sRGB. Of a spectrum the means over thirds
//!   of the visible range are taken, of a checkerboard the mean; other textures reflect one half.
//! * Emitters: of type `area`; the exitance is π × radiance. Others are left out.
//! * Sensors: the first perspective camera; all of `fov_axis` and `focal_length`.
//!
//! Other elements of the file are noted, unless they only concern the way in which Mitsuba makes its picture.

mod element;
mod parameters;
mod tree;
mod transforms;
mod placed;
mod ids;
mod spectra;
mod colours;
mod bsdfs;
mod meshes;
mod emitters;
mod shapes;
mod sensor;
mod leftovers;
mod scene;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::decoded;

use crate::model::Model;
use radiosity_photometry::files::Files;

/// Reads the scene `file`; `files` finds its meshes and what it includes.
///
/// # Errors
/// The first element that cannot be followed, of whichever file.
pub fn read(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let text = decoded(bytes).map_err(|located| located.in_file(file))?;
    scene::model(&tree::read(file, &text, files)?, files)
}
