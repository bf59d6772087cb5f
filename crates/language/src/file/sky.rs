//! The sky, and glass, as typed.

use radiosity_geom::DVec3;
use radiosity_scene::{
    SkyModel,
    place::{At, Span},
};
use serde_json::json;

use crate::{
    fields::{real, whole, word},
    file::per_band::{AMOUNTS, PerBand},
    keys::{DefaultValue, KeyTable, ValueKind, keys},
    kinds::{REAL, VECTOR},
    terms,
};

const MODELS: [(&str, SkyModel); 3] =
    [("uniform", SkyModel::Uniform), ("overcast", SkyModel::Overcast), ("clear", SkyModel::Clear)];

keys! {
    /// `[sky]`.
    SkyFile("The sky behind openings") {
        model: SkyModel = ValueKind::new(
            |node| word(node, &MODELS, |name| format!("there is no sky {name:?}"), "models of the sky"),
            || terms::words(&MODELS.map(|(name, _)| name)),
        ).example(": uniform, overcast or clear"), "How bright the sky is where";
        illuminance: PerBand = AMOUNTS.example(", of level ground under the sky, in lx"),
            "Of level ground under the sky, the sun left out";
        ground: f64 =
            ValueKind::number(real, || json!({ "minimum": 0, "exclusiveMaximum": 1 }))
                .or(DefaultValue::Number(0.2)),
            "Reflectance of the ground";
        up: DVec3 = VECTOR.or(DefaultValue::Numbers(&[0.0, 0.0, 1.0])), "Where the zenith is";
        north: DVec3 = VECTOR.or(DefaultValue::Numbers(&[0.0, 1.0, 0.0])), "Where north is";
        sun: Option<SunFile> = ValueKind::new(SunFile::read, SunFile::schema), "";
        ..span: Span;
    }
}

keys! {
    /// `sun = { … }`.
    SunFile("Where the sun is, and how bright") {
        elevation: At<f64> =
            ValueKind::number(real, || json!({ "exclusiveMinimum": 0, "maximum": 90 }))
                .example(", in degrees"),
            "Above the horizon, degrees";
        azimuth: f64 = REAL.example(", in degrees"), "From north over east, degrees";
        illuminance: PerBand = AMOUNTS.or(DefaultValue::Number(0.0)), "Across its beam";
        ..span: Span;
    }
}

keys! {
    /// `glass = { … }`.
    GlassFile("Glass in an opening to the sky") {
        panes: u32 = ValueKind::new(|node| Ok(whole(node)?.value), || terms::whole(1, 4, "")).or(DefaultValue::Number(1.0)),
            "Panes";
        index: f64 = ValueKind::number(real, || json!({ "minimum": 1, "maximum": 3 })).or(DefaultValue::Number(1.52)),
            "Index of refraction";
        transmittance: Option<f64> =
            ValueKind::number(real, || json!({ "exclusiveMinimum": 0, "maximum": 1 })),
            "Part of the light along the normal that is let through";
    }
}
