//! A surface of a scene.

use std::sync::Arc;

use radiosity_geom::Surface;

use crate::scene::{material::Material, source::Place};

/// A shape with a name, a material and wishes for its elements. Only its front emits and receives; its back blocks.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SceneSurface {
    /// Unique in the scene; the back of a two-sided surface is `name:back`.
    pub name: String,
    /// The shape key of the file, e.g. `quad`; `surface` if it was built in code.
    pub kind: &'static str,
    /// The shape, already flipped if the file says so.
    pub shape: Arc<dyn Surface>,
    /// Its material; black if the file names none.
    pub material: Material,
    /// The material's name in the file, if one is given.
    pub material_name: Option<String>,
    /// Order of the basis here, at most [`MAX_ORDER`](crate::scene::MAX_ORDER), instead of the order asked for.
    pub order: Option<usize>,
    /// Elements along u and v, each at least 1, instead of the subdivision asked for.
    pub subdivide: Option<[usize; 2]>,
    /// Where the surface stands in the file; none if it was built in code.
    pub place: Option<Place>,
}
