//! Surfaces and their placement as typed.

use radiosity_geom::{DVec3, Motion};
use radiosity_scene::{
    Condition,
    error::{Located, surface_title},
    place::{At, Span},
    ranges::{check_order, check_parts},
    tree::{Node, entry},
};

use crate::{
    fields::{Fields, counted, exactly, list, point, real, table, text, truth},
    file::{
        per_band::{PerBand, per_band},
        sky::{GlassFile, read_glass},
        thermal::{CONDITION_KEYS, read_condition},
    },
    shape::{ShapeFile, keys},
};

/// `[[surfaces]]`.
#[derive(Debug)]
pub(crate) struct SurfaceFile {
    pub name: At<String>,
    pub span: Span,
    pub material: Option<At<String>>,
    pub back_material: Option<At<String>>,
    pub group: Option<At<String>>,
    pub flux: Option<PerBand>,
    /// Span of `opening` or `glass`; none where the surface is no opening to the sky.
    pub opening: Option<Span>,
    pub glass: Option<GlassFile>,
    pub condition: Option<Condition>,
    pub shape: ShapeFile,
    pub motion: Motion,
    pub order: Option<usize>,
    pub subdivide: Option<[usize; 2]>,
    pub two_sided: bool,
    pub flip: bool,
}

/// The list of surfaces; `prefix` stands before the names of those that are given none.
pub(crate) fn read_surfaces(node: &Node, prefix: &str) -> Result<Vec<SurfaceFile>, Located> {
    let read = |(index, node)| {
        let name = format!("{prefix}surface-{}", index + 1);
        read_surface(node, &name)
            .map_err(|error| error.within(|| surface_title(&given(node).unwrap_or(name))))
    };
    list(node)?.iter().enumerate().map(read).collect()
}

/// The name in a table that may be wrong otherwise.
fn given(node: &Node) -> Option<String> {
    let name = text(entry(table(node).ok()?, "name")?).ok()?;
    Some(name.value)
}

const SURFACE_KEYS: [&str; 12] = [
    "name",
    "material",
    "back_material",
    "group",
    "flux",
    "opening",
    "glass",
    "order",
    "subdivide",
    "two_sided",
    "flip",
    "transform",
];

/// A surface, called `unnamed` if it is given no name.
fn read_surface(node: &Node, unnamed: &str) -> Result<SurfaceFile, Located> {
    let known: Vec<&'static str> = SURFACE_KEYS.into_iter().chain(CONDITION_KEYS).chain(keys()).collect();
    let fields = Fields::new(node, &known)?;
    Ok(SurfaceFile {
        name: fields.optional("name", text)?.unwrap_or_else(|| At::new(unnamed.to_owned(), fields.span())),
        span: fields.span().clone(),
        material: fields.optional("material", text)?,
        back_material: fields.optional("back_material", text)?,
        group: fields.optional("group", text)?,
        flux: fields.optional("flux", per_band)?,
        opening: read_opening(&fields)?,
        glass: fields.optional("glass", read_glass)?,
        condition: read_condition(&fields)?,
        shape: ShapeFile::read(&fields)?,
        motion: fields.optional("transform", read_motion)?.unwrap_or(Motion::IDENTITY),
        order: fields.optional("order", order)?,
        subdivide: fields.optional("subdivide", |node| exactly(node, "subdivide", "numbers", parts))?,
        two_sided: fields.optional("two_sided", truth)?.unwrap_or(false),
        flip: fields.optional("flip", truth)?.unwrap_or(false),
    })
}

/// Span of `opening = true`, or of `glass`, which fills an opening.
fn read_opening(fields: &Fields<'_>) -> Result<Option<Span>, Located> {
    match fields.get("opening") {
        Some(node) => Ok(truth(node)?.then(|| node.span.clone())),
        None => Ok(fields.get("glass").map(|node| node.span.clone())),
    }
}

fn order(node: &Node) -> Result<usize, Located> {
    counted(node, check_order)
}

fn parts(node: &Node) -> Result<usize, Located> {
    counted(node, check_parts)
}

/// Transform of a shape or of an instance: `translate`, `rotate` and `scale`.
pub(crate) fn read_motion(node: &Node) -> Result<Motion, Located> {
    let fields = Fields::new(node, &["translate", "rotate", "scale"])?;
    let translate = fields.optional("translate", point)?.unwrap_or(DVec3::ZERO);
    let rotate =
        fields.optional("rotate", |node| exactly(node, "rotate", "numbers, an axis and degrees", real))?;
    let [x, y, z, degrees] = rotate.unwrap_or([0.0; 4]);
    let scale = fields.optional("scale", real)?.unwrap_or(1.0);
    Motion::new(translate, DVec3::new(x, y, z), degrees.to_radians(), scale).map_err(|error| {
        let span = fields.get(error.field()).map_or(&node.span, |field| &field.span);
        Located::at(span, error.into())
    })
}
