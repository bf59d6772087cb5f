//! A scene as it is typed: keys, kinds and counts are right, every value knows its place, nothing else is checked.

use radiosity_geom::{DVec3, Motion};

use crate::scene::{
    error::{Fault, Located, material_title, plane_title, surface_title},
    fields::{Fields, exactly, list, number, point, real, table, text, truth, whole},
    names::check_text,
    ranges::{check_fov, check_order, check_parts, check_pixels},
    shape::{ShapeFile, keys},
    source::{At, Span},
    tree::{Node, Value, entry},
};

/// A scene file.
#[derive(Debug)]
pub(super) struct SceneFile {
    pub title: Option<String>,
    pub bands: Option<At<Vec<At<String>>>>,
    pub unit: Option<At<String>>,
    pub camera: Option<CameraFile>,
    pub planes: Vec<PlaneFile>,
    pub materials: Vec<MaterialFile>,
    pub surfaces: Vec<SurfaceFile>,
}

/// `[camera]`.
#[derive(Debug)]
pub(super) struct CameraFile {
    pub span: Span,
    pub eye: DVec3,
    pub target: DVec3,
    pub up: Option<DVec3>,
    pub fov: Option<f64>,
    pub width: Option<u32>,
    pub height: Option<u32>,
}

/// `[planes.NAME]`.
#[derive(Debug)]
pub(super) struct PlaneFile {
    pub name: String,
    pub origin: DVec3,
    pub edges: At<[DVec3; 2]>,
    pub spacing: At<[f64; 2]>,
}

/// `[materials.NAME]`.
#[derive(Debug)]
pub(super) struct MaterialFile {
    pub name: At<String>,
    pub reflectance: PerBand,
    pub emission: Option<PerBand>,
    pub group: Option<At<String>>,
}

/// One number for all bands, or a list with one per band.
#[derive(Debug)]
pub(super) enum PerBand {
    All(At<f64>),
    Each(At<Vec<At<f64>>>),
}

/// `[[surfaces]]`.
#[derive(Debug)]
pub(super) struct SurfaceFile {
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

impl PerBand {
    /// Where it stands.
    pub(super) fn span(&self) -> &Span {
        match self {
            PerBand::All(number) => &number.span,
            PerBand::Each(list) => &list.span,
        }
    }

    fn is_one_number(&self) -> bool {
        matches!(self, PerBand::All(_))
    }
}

/// The key of the table of variables, which are evaluated before the rest is read.
pub(super) const VARIABLES: &str = "variables";

const SCENE_KEYS: [&str; 8] =
    ["title", "bands", "unit", VARIABLES, "camera", "planes", "materials", "surfaces"];

impl SceneFile {
    /// Whether every reflectance, emission and flux is a single number.
    pub(super) fn is_grey(&self) -> bool {
        let materials = self.materials.iter();
        let per_band = materials.flat_map(|own| [Some(&own.reflectance), own.emission.as_ref()]);
        let fluxes = self.surfaces.iter().map(|surface| surface.flux.as_ref());
        per_band.chain(fluxes).flatten().all(PerBand::is_one_number)
    }

    /// Reads the tree of a whole scene.
    pub(super) fn read(tree: &Node) -> Result<Self, Located> {
        let fields = Fields::new(tree, &SCENE_KEYS)?;
        let surfaces =
            fields.optional("surfaces", |node| list(node).map(<[Node]>::to_vec))?.unwrap_or_default();
        Ok(SceneFile {
            title: fields.optional("title", text)?.map(|title| title.value),
            bands: fields.optional("bands", read_bands)?,
            unit: fields.optional("unit", text)?,
            camera: fields
                .optional("camera", |node| read_camera(node).map_err(|e| e.within(|| "camera".into())))?,
            planes: fields.optional("planes", read_planes)?.unwrap_or_default(),
            materials: fields.optional("materials", read_materials)?.unwrap_or_default(),
            surfaces: surfaces.iter().enumerate().map(read_named_surface).collect::<Result<_, _>>()?,
        })
    }
}

fn read_bands(node: &Node) -> Result<At<Vec<At<String>>>, Located> {
    let names = list(node)?.iter().map(text).collect::<Result<_, _>>()?;
    Ok(At::new(names, &node.span))
}

fn read_camera(node: &Node) -> Result<CameraFile, Located> {
    let fields = Fields::new(node, &["eye", "target", "up", "fov", "width", "height"])?;
    Ok(CameraFile {
        span: fields.span().clone(),
        eye: fields.require("eye", point)?,
        target: fields.require("target", point)?,
        up: fields.optional("up", point)?,
        fov: fields.optional("fov", |node| {
            let fov = number(node)?;
            check_fov(fov.value).map_err(|fault| Located::at(&fov.span, fault))?;
            Ok(fov.value)
        })?,
        width: fields.optional("width", pixels)?,
        height: fields.optional("height", pixels)?,
    })
}

fn pixels(node: &Node) -> Result<u32, Located> {
    counted(node, check_pixels).map(|pixels| pixels as u32)
}

fn read_planes(node: &Node) -> Result<Vec<PlaneFile>, Located> {
    let read = |(name, node): &(At<String>, Node)| {
        check_text(&name.value).map_err(|fault| Located::at(&name.span, fault))?;
        read_plane(&name.value, node).map_err(|error| error.within(|| plane_title(&name.value)))
    };
    table(node)?.iter().map(read).collect()
}

fn read_plane(name: &str, node: &Node) -> Result<PlaneFile, Located> {
    let fields = Fields::new(node, &["origin", "edges", "spacing"])?;
    Ok(PlaneFile {
        name: name.to_owned(),
        origin: fields.require("origin", point)?,
        edges: fields
            .require("edges", |node| Ok(At::new(exactly(node, "edges", "vectors", point)?, &node.span)))?,
        spacing: fields.require("spacing", |node| Ok(At::new(spacing(node)?, &node.span)))?,
    })
}

/// One length for both edges, or one along each.
fn spacing(node: &Node) -> Result<[f64; 2], Located> {
    match &node.value {
        Value::List(_) => exactly(node, "spacing", "numbers, one along each edge", real),
        _ => Ok([real(node)?; 2]),
    }
}

fn read_materials(node: &Node) -> Result<Vec<MaterialFile>, Located> {
    let read = |(name, node): &(At<String>, Node)| {
        read_material(name, node).map_err(|error| error.within(|| material_title(&name.value)))
    };
    table(node)?.iter().map(read).collect()
}

fn read_material(name: &At<String>, node: &Node) -> Result<MaterialFile, Located> {
    let fields = Fields::new(node, &["reflectance", "emission", "group"])?;
    Ok(MaterialFile {
        name: name.clone(),
        reflectance: fields.require("reflectance", per_band)?,
        emission: fields.optional("emission", per_band)?,
        group: fields.optional("group", text)?,
    })
}

fn per_band(node: &Node) -> Result<PerBand, Located> {
    match &node.value {
        Value::List(items) => {
            let values = items.iter().map(number).collect::<Result<_, _>>()?;
            Ok(PerBand::Each(At::new(values, &node.span)))
        }
        _ => Ok(PerBand::All(number(node)?)),
    }
}

/// The name of the surface at `index` (from 0) if it is given none.
pub(super) fn default_name(index: usize) -> String {
    format!("surface-{}", index + 1)
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

fn read_motion(node: &Node) -> Result<Motion, Located> {
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

/// A whole number that passes `check`.
fn counted(node: &Node, check: fn(usize) -> Result<(), Fault>) -> Result<usize, Located> {
    let count = whole(node)?;
    let value = count.value as usize;
    check(value).map_err(|fault| Located::at(&count.span, fault))?;
    Ok(value)
}
