//! A scene as it is typed: keys, kinds and counts are right, every value knows its place, nothing else is
//! checked.

mod per_band;
mod pattern;
mod thermal;
mod sky;
mod surface;
mod luminaire;
mod part;
mod motion;

use radiosity_geom::DVec3;
use radiosity_scene::{
    Thermal,
    animation::{check_frames, check_rate},
    error::{Located, material_title, plane_title},
    names::check_text,
    place::{At, Span},
    ranges::{check_fov, check_pixels},
    tree::Node,
};

use crate::{
    fields::{Fields, counted, exactly, list, number, point, real, table, text},
    include::INCLUDE,
    variables::VARIABLES,
};
use motion::read_motions;
use part::{read_content, read_parts};
use pattern::amount;
use per_band::per_band;
use sky::read_sky;
use thermal::{CONDITION_KEYS, emissivity, read_condition};

pub(super) use luminaire::{DistributionFile, ExtentFile, LuminaireFile, StrengthFile};
pub(super) use motion::{MOTION, MotionFile, RotateFile, TranslateFile, TurnsFile};
pub(super) use part::{ContentFile, CopyRow, InstanceFile, PartFile};
pub(super) use pattern::{Amount, EachBand, Encoding, PatternFile, PatternKind};
pub(super) use per_band::PerBand;
pub(super) use sky::{GlassFile, SkyFile, SunFile};
pub(super) use surface::SurfaceFile;

/// A scene file as typed.
#[derive(Debug, Default)]
pub(super) struct SceneFile {
    pub title: Option<String>,
    pub bands: Option<At<Vec<At<String>>>>,
    pub unit: Option<At<String>>,
    pub camera: Option<CameraFile>,
    pub sky: Option<SkyFile>,
    pub planes: Vec<PlaneFile>,
    pub materials: Vec<MaterialFile>,
    pub parts: Vec<PartFile>,
    pub content: ContentFile,
    pub frames: FramesFile,
    pub motions: Vec<MotionFile>,
}

/// `frames` and `fps`.
#[derive(Debug, Default)]
pub(super) struct FramesFile {
    pub count: Option<At<usize>>,
    pub rate: Option<At<f64>>,
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
    pub name: At<String>,
    pub origin: DVec3,
    pub edges: At<[DVec3; 2]>,
    pub spacing: At<[f64; 2]>,
}

/// `[materials.NAME]`.
#[derive(Debug)]
pub(super) struct MaterialFile {
    pub name: At<String>,
    /// Diffuse reflectance; none where an emissivity is given instead.
    pub reflectance: Option<Amount>,
    pub emission: Option<Amount>,
    pub transmittance: Option<PerBand>,
    pub thermal: Thermal,
    pub group: Option<At<String>>,
}

const MATERIAL_KEYS: [&str; 5] = ["reflectance", "emission", "transmittance", "emissivity", "group"];

const SCENE_KEYS: [&str; 16] = [
    INCLUDE,
    "title",
    "bands",
    "unit",
    "frames",
    "fps",
    VARIABLES,
    "camera",
    "sky",
    "planes",
    "materials",
    "parts",
    "surfaces",
    "luminaires",
    "instances",
    MOTION,
];

impl SceneFile {
    /// Whether every reflectance, transmittance, emission, flux and intensity is a single number, or a
    /// pattern alike in all bands.
    pub(super) fn is_grey(&self) -> bool {
        let amounts = self.materials.iter().flat_map(|own| [own.reflectance.as_ref(), own.emission.as_ref()]);
        let amounts = amounts.flatten();
        let transmittances = self.materials.iter().map(|own| own.transmittance.as_ref());
        let contents = self.parts.iter().map(|part| &part.content).chain([&self.content]);
        let fluxes = contents.flat_map(|content| {
            let luminaires = content.luminaires.iter().map(|own| own.strength.as_ref());
            let luminaires = luminaires.map(|strength| strength.map(StrengthFile::numbers));
            content.surfaces.iter().map(|surface| surface.flux.as_ref()).chain(luminaires)
        });
        let skies = self.sky.iter().flat_map(|sky| {
            [Some(&sky.illuminance), sky.sun.as_ref().and_then(|sun| sun.illuminance.as_ref())]
        });
        let mut numbers = transmittances.chain(fluxes).chain(skies).flatten();
        numbers.all(PerBand::is_one_number) && amounts.into_iter().all(Amount::is_one_for_all)
    }

    /// Reads the tree of a file; `prefix` stands before the names of surfaces and instances that are given
    /// none.
    pub(super) fn read(tree: &Node, prefix: &str) -> Result<Self, Located> {
        let fields = Fields::new(tree, &SCENE_KEYS)?;
        Ok(SceneFile {
            title: fields.optional("title", text)?.map(|title| title.value),
            bands: fields.optional("bands", read_bands)?,
            unit: fields.optional("unit", text)?,
            camera: fields
                .optional("camera", |node| read_camera(node).map_err(|e| e.within(|| "camera".into())))?,
            sky: fields.optional("sky", |node| read_sky(node).map_err(|e| e.within(|| "sky".into())))?,
            planes: fields.optional("planes", read_planes)?.unwrap_or_default(),
            materials: fields.optional("materials", read_materials)?.unwrap_or_default(),
            parts: fields.optional("parts", read_parts)?.unwrap_or_default(),
            content: read_content(&fields, prefix)?,
            frames: FramesFile {
                count: fields
                    .optional("frames", |node| Ok(At::new(counted(node, check_frames)?, &node.span)))?,
                rate: fields.optional("fps", rate)?,
            },
            motions: fields.get(MOTION).map_or(Ok(Vec::new()), |node| read_motions(node, prefix))?,
        })
    }
}

/// Frames in a unit of time.
fn rate(node: &Node) -> Result<At<f64>, Located> {
    let rate = number(node)?;
    check_rate(rate.value).map_err(|fault| Located::at(&rate.span, fault))?;
    Ok(rate)
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
        read_plane(name, node).map_err(|error| error.within(|| plane_title(&name.value)))
    };
    table(node)?.iter().map(read).collect()
}

fn read_plane(name: &At<String>, node: &Node) -> Result<PlaneFile, Located> {
    let fields = Fields::new(node, &["origin", "edges", "spacing"])?;
    Ok(PlaneFile {
        name: name.clone(),
        origin: fields.require("origin", point)?,
        edges: fields
            .require("edges", |node| Ok(At::new(exactly(node, "edges", "vectors", point)?, &node.span)))?,
        spacing: fields.require("spacing", |node| Ok(At::new(spacing(node)?, &node.span)))?,
    })
}

/// One length for both edges, or one along each.
fn spacing(node: &Node) -> Result<[f64; 2], Located> {
    match node.items() {
        Some(_) => exactly(node, "spacing", "numbers, one along each edge", real),
        None => Ok([real(node)?; 2]),
    }
}

fn read_materials(node: &Node) -> Result<Vec<MaterialFile>, Located> {
    let read = |(name, node): &(At<String>, Node)| {
        read_material(name, node).map_err(|error| error.within(|| material_title(&name.value)))
    };
    table(node)?.iter().map(read).collect()
}

fn read_material(name: &At<String>, node: &Node) -> Result<MaterialFile, Located> {
    let known: Vec<&'static str> = MATERIAL_KEYS.into_iter().chain(CONDITION_KEYS).collect();
    let fields = Fields::new(node, &known)?;
    let thermal = Thermal {
        emissivity: fields.optional("emissivity", emissivity)?,
        condition: read_condition(&fields)?,
    };
    Ok(MaterialFile {
        name: name.clone(),
        reflectance: match thermal.emissivity {
            Some(_) => fields.optional("reflectance", amount)?,
            None => Some(fields.require("reflectance", amount)?),
        },
        thermal,
        emission: fields.optional("emission", amount)?,
        transmittance: fields.optional("transmittance", per_band)?,
        group: fields.optional("group", text)?,
    })
}
