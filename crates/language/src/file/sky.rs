//! The sky, and glass, as typed.

use radiosity_geom::DVec3;
use radiosity_scene::{
    Fault, SkyModel,
    error::Located,
    place::{At, Span},
    tree::Node,
};

use crate::{
    fields::{Fields, number, point, text, whole},
    file::per_band::{PerBand, per_band},
};

/// `[sky]`.
#[derive(Debug)]
pub(crate) struct SkyFile {
    pub span: Span,
    pub model: SkyModel,
    pub illuminance: PerBand,
    pub ground: Option<At<f64>>,
    pub up: Option<DVec3>,
    pub north: Option<DVec3>,
    pub sun: Option<SunFile>,
}

/// `sun = { … }`.
#[derive(Debug)]
pub(crate) struct SunFile {
    pub span: Span,
    pub elevation: At<f64>,
    pub azimuth: f64,
    pub illuminance: Option<PerBand>,
}

/// `glass = { … }`.
#[derive(Debug)]
pub(crate) struct GlassFile {
    pub span: Span,
    pub panes: Option<u32>,
    pub index: Option<f64>,
    pub transmittance: Option<f64>,
}

pub(crate) fn read_sky(node: &Node) -> Result<SkyFile, Located> {
    let fields = Fields::new(node, &["model", "illuminance", "ground", "up", "north", "sun"])?;
    Ok(SkyFile {
        span: fields.span().clone(),
        model: fields.require("model", model)?,
        illuminance: fields.require("illuminance", per_band)?,
        ground: fields.optional("ground", number)?,
        up: fields.optional("up", point)?,
        north: fields.optional("north", point)?,
        sun: fields.optional("sun", read_sun)?,
    })
}

fn model(node: &Node) -> Result<SkyModel, Located> {
    let name = text(node)?;
    let models =
        [("uniform", SkyModel::Uniform), ("overcast", SkyModel::Overcast), ("clear", SkyModel::Clear)];
    let found = models.iter().find(|(own, _)| *own == name.value);
    found.map(|(_, model)| *model).ok_or_else(|| {
        let known: Vec<String> = models.iter().map(|(own, _)| (*own).to_owned()).collect();
        let cause = format!("there is no sky {:?}", name.value);
        Located::at(&name.span, Fault::unknown(cause, &name.value, known, "models of the sky"))
    })
}

fn read_sun(node: &Node) -> Result<SunFile, Located> {
    let fields = Fields::new(node, &["elevation", "azimuth", "illuminance"])?;
    Ok(SunFile {
        span: fields.span().clone(),
        elevation: fields.require("elevation", number)?,
        azimuth: fields.require("azimuth", number)?.value,
        illuminance: fields.optional("illuminance", per_band)?,
    })
}

pub(crate) fn read_glass(node: &Node) -> Result<GlassFile, Located> {
    let fields = Fields::new(node, &["panes", "index", "transmittance"])?;
    Ok(GlassFile {
        span: fields.span().clone(),
        panes: fields.optional("panes", whole)?.map(|panes| panes.value),
        index: fields.optional("index", number)?.map(|index| index.value),
        transmittance: fields.optional("transmittance", number)?.map(|own| own.value),
    })
}
