//! Warnings about a scene, in words.

use radiosity_geom::DVec3;
use radiosity_scene::Scene;
use serde::Serialize;

/// Something that is allowed, but seldom meant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Warning {
    /// Stable name of the kind of warning, e.g. `gap`.
    pub code: &'static str,
    /// The fault and its cure, in words.
    pub message: String,
    /// The surface it belongs to, if it is one.
    pub surface: Option<String>,
}

impl Warning {
    /// Whether it is of something that only some uses of a scene need: view factors need neither light nor a
    /// camera.
    pub fn is_of_something_missing(&self) -> bool {
        matches!(self.code, "no-emitter" | "no-camera" | "no-material")
    }

    /// A warning about the surface `name`.
    pub(super) fn about(code: &'static str, name: &str, message: String) -> Self {
        Warning { code, message: format!("surface {name:?} {message}"), surface: Some(name.to_owned()) }
    }

    /// A warning about the luminaire `name`.
    pub(super) fn of_luminaire(code: &'static str, name: &str, message: &str) -> Self {
        Warning { code, message: format!("luminaire {name:?} {message}"), surface: None }
    }

    /// A warning about the scene.
    pub(super) fn general(code: &'static str, message: &str) -> Self {
        Warning { code, message: message.to_owned(), surface: None }
    }
}

/// A cure by keys of scene files, which most files of other programs do not have.
pub(super) fn by_keys(scene: &Scene, cure: &str) -> String {
    match scene.imported() {
        None => cure.to_owned(),
        Some(_) => format!("{cure}, in the scene converted to .toml"),
    }
}

/// A point to four digits.
pub(super) fn place(point: DVec3) -> String {
    let digits = (3.0 - point.abs().max_element().max(1e-9).log10().floor()).max(0.0);
    let scale = 10_f64.powf(digits);
    let [x, y, z] = (point * scale).to_array().map(|x| x.round() / scale + 0.0);
    format!("({x}, {y}, {z})")
}
