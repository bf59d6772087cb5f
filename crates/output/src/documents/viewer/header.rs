//! The header of a page as JSON: scene, surfaces, camera and colours, to which its packed numbers belong.

use std::io;

use radiosity_scene::Camera;
use radiosity_solve::solved::Solved;
use serde::Serialize;

use super::first_view_settings::{FirstViewColours, FirstViewSettings};
use crate::drawings::scale::Scale;
use crate::pictures::tessellation::Triangulation;
use radiosity_reading::exposure::Exposure;
use radiosity_reading::pictures::lightmap::{Lightmap, LightmapPart};
use radiosity_reading::quantity::Quantity;

/// Colours of the scale that are written; the page interpolates between.
const COLOURS: u32 = 256;

#[derive(Serialize)]
pub(super) struct Header<'a> {
    title: &'a str,
    unit: &'a str,
    bands: &'a [String],
    /// Factors on three bands that make them red, green and blue.
    balance: [f64; 3],
    /// Name of the irradiance in this unit.
    irradiance: &'a str,
    parts: Vec<PartHeader<'a>>,
    /// Irradiance (unit of exitance) per unit of the stored light.
    scale: f32,
    /// Vector to be added to all coordinates that are shown (scene length).
    middle: [f64; 3],
    camera: View,
    /// Points of a pixel at which it is sampled, in pixels from its upper left corner.
    points: &'a [[f64; 2]],
    /// Exposure that is chosen for the first view, and the one asked for.
    automatic: f64,
    exposure: Option<f64>,
    quantity: &'a str,
    colours: Option<ColoursHeader>,
    /// sRGB codes of the scale, from its low end.
    gradient: Vec<[u8; 3]>,
    surfaces: Vec<SurfaceHeader<'a>>,
}

#[derive(Serialize)]
struct PartHeader<'a> {
    group: Option<&'a str>,
    factor: f64,
}

#[derive(Serialize)]
struct View {
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    fov: f64,
    width: u32,
    height: u32,
}

#[derive(Serialize)]
struct ColoursHeader {
    band: Option<usize>,
    range: Option<[f64; 2]>,
    log: bool,
}

#[derive(Serialize)]
struct SurfaceHeader<'a> {
    name: &'a str,
    /// The part that its own emission belongs to; none where it emits nothing.
    part: Option<usize>,
    reflectance: &'a [f64],
    /// Exitance per band (W m⁻²), at the factor 1 of its part.
    emission: Vec<f64>,
    /// Texels along u and along v.
    texels: [usize; 2],
    corners: usize,
    triangles: usize,
}

impl<'a> Header<'a> {
    pub(super) fn new(
        solved: &'a Solved,
        lightmap: &'a Lightmap,
        triangles: &[Triangulation],
        start: &'a FirstViewSettings,
        automatic: Exposure,
        balance: [f64; 3],
        scale: f32,
    ) -> Self {
        let scene = &solved.scene;
        let gradient = Scale::sequential([0.0, f64::from(COLOURS - 1)]);
        let colours = start.false_colours.map(|FirstViewColours { band, range, log }| ColoursHeader {
            band,
            range,
            log,
        });
        let parts = lightmap.parts().iter();
        Self {
            title: scene.title.as_deref().unwrap_or(&scene.name),
            unit: &scene.unit,
            bands: &scene.bands,
            balance,
            irradiance: Quantity::Irradiance.name(&scene.unit),
            parts: parts
                .map(|part| PartHeader { group: part.group.as_deref(), factor: part.factor })
                .collect(),
            scale,
            middle: scene.middle.to_array(),
            camera: View::of(&start.camera),
            points: start.grid.points(),
            automatic: automatic.factor(),
            exposure: start.exposure,
            quantity: match start.shown {
                Quantity::Radiosity => "radiosity",
                Quantity::Irradiance => "irradiance",
            },
            colours,
            gradient: (0..COLOURS).map(|k| gradient.colour(f64::from(k))).collect(),
            surfaces: (0..scene.surfaces.len())
                .map(|surface| SurfaceHeader::new(solved, lightmap, &triangles[surface], surface))
                .collect(),
        }
    }

    /// The JSON, safe within HTML.
    pub(super) fn json(&self) -> io::Result<String> {
        Ok(serde_json::to_string(self)?.replace('<', "\\u003c"))
    }
}

impl View {
    fn of(camera: &Camera) -> Self {
        let Camera { eye, target, up, fov, width, height } = camera.clone();
        Self { eye: eye.to_array(), target: target.to_array(), up: up.to_array(), fov, width, height }
    }
}

impl<'a> SurfaceHeader<'a> {
    fn new(solved: &'a Solved, lightmap: &Lightmap, triangles: &Triangulation, index: usize) -> Self {
        let surface = &solved.scene.surfaces[index];
        let group = surface.group.as_ref().map(|group| group.name.as_str());
        let is_own = |part: &LightmapPart| part.group.as_deref() == group;
        let part = lightmap.parts().iter().position(is_own);
        let bands = 0..solved.scene.bands.len();
        // Where the light of groups is not kept apart, their factors cannot be changed.
        let emission = match part {
            Some(_) => surface.material.emission.clone(),
            None => bands.map(|band| surface.exitance(band)).collect(),
        };
        Self {
            name: &surface.name,
            part,
            reflectance: &surface.material.reflectance,
            emission,
            texels: lightmap.surfaces()[index].size(),
            corners: triangles.positions.len(),
            triangles: triangles.triangles.len(),
        }
    }
}
