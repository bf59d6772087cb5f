//! Surfaces and their placement as typed.

use radiosity_geom::{DVec3, Motion};

use crate::scene::{
    error::{Fault, Located, surface_title},
    fields::{Fields, counted, exactly, list, point, real, table, text, truth},
    file::per_band::{PerBand, per_band},
    ranges::{check_order, check_parts},
    shape::{ShapeFile, keys},
    source::{At, Span},
    tree::{Node, entry},
};

/// `[[surfaces]]`.
#[derive(Debug)]
pub(in crate::scene) struct SurfaceFile {
    pub name: Option<At<String>>,
    pub span: Span,
    pub material: Option<At<String>>,
    pub group: Option<At<String>>,
    pub flux: Option<PerBand>,
    pub shape: ShapeFile,
    pub motion: Motion,
    pub order: Option<usize>,
    pub subdivide: Option<[usize; 2]>,
    pub two_sided: bool,
    pub flip: bool,
}

/// The name of the surface at `index` (from 0) if it is given none.
pub(in crate::scene) fn default_name(index: usize) -> String {
    format!("surface-{}", index + 1)
}

/// The list of surfaces.
pub(in crate::scene) fn read_surfaces(node: &Node) -> Result<Vec<SurfaceFile>, Located> {
    list(node)?.iter().enumerate().map(read_named_surface).collect()
}

fn read_named_surface((index, node): (usize, &Node)) -> Result<SurfaceFile, Located> {
    read_surface(node).map_err(|error| {
        error.within(|| match table(node).ok().and_then(|entries| entry(entries, "name")).map(text) {
            Some(Ok(name)) => surface_title(&name.value),
            _ => surface_title(&default_name(index)),
        })
    })
}

const SURFACE_KEYS: [&str; 9] =
    ["name", "material", "group", "flux", "order", "subdivide", "two_sided", "flip", "transform"];

fn read_surface(node: &Node) -> Result<SurfaceFile, Located> {
    let known: Vec<&'static str> = SURFACE_KEYS.into_iter().chain(keys()).collect();
    let fields = Fields::new(node, &known)?;
    Ok(SurfaceFile {
        name: fields.optional("name", text)?,
        span: fields.span().clone(),
        material: fields.optional("material", text)?,
        group: fields.optional("group", text)?,
        flux: fields.optional("flux", per_band)?,
        shape: ShapeFile::read(&fields)?,
        motion: fields.optional("transform", read_motion)?.unwrap_or(Motion::IDENTITY),
        order: fields.optional("order", order)?,
        subdivide: fields.optional("subdivide", |node| exactly(node, "subdivide", "numbers", parts))?,
        two_sided: fields.optional("two_sided", truth)?.unwrap_or(false),
        flip: fields.optional("flip", truth)?.unwrap_or(false),
    })
}

fn order(node: &Node) -> Result<usize, Located> {
    counted(node, check_order)
}

fn parts(node: &Node) -> Result<usize, Located> {
    counted(node, check_parts)
}

/// Where a shape or an instance is put.
pub(in crate::scene) fn read_motion(node: &Node) -> Result<Motion, Located> {
    let fields = Fields::new(node, &["translate", "rotate", "scale"])?;
    let translate = fields.optional("translate", point)?.unwrap_or(DVec3::ZERO);
    let rotate =
        fields.optional("rotate", |node| exactly(node, "rotate", "numbers, an axis and degrees", real))?;
    let [x, y, z, degrees] = rotate.unwrap_or([0.0; 4]);
    let scale = fields.optional("scale", real)?.unwrap_or(1.0);
    Motion::new(translate, DVec3::new(x, y, z), degrees.to_radians(), scale).map_err(|error| {
        let span = fields.get(error.field()).map_or(&node.span, |field| &field.span);
        Located::at(span, Fault::Shape(error))
    })
}
