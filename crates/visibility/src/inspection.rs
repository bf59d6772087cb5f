//! Inspection of a scene before anything is computed: its contents, contacts, and what looks wrong.
//!
//! The geometry is sampled, so that hundreds of surfaces take little time; neither light nor materials are
//! needed.

mod sheet;
mod sheet_border;
mod shell;
mod enclosure;
mod regions;
mod warning;
mod contact;
mod front;
mod gap;
mod luminaires;
mod leap;
mod passage;
mod outside;

use std::collections::HashSet;

use radiosity_scene::{Scene, SceneSurface};
use rayon::prelude::*;

pub use contact::SurfaceContact;
pub use luminaires::NearPoint;
pub use outside::{BEFORE_OPENINGS, before_openings};
pub use passage::{Passage, passages};
pub use regions::Regions;
pub use shell::{Fronts, Shell};
pub use warning::Warning;
use warning::by_keys;

use crate::footprints::{Footprint, footprints};
use sheet::Sheets;

/// Larger reflectances draw a warning: in a closed room an error of ρ grows by 1/(1 − ρ) ≥ 20. Chosen.
const BRIGHT: f64 = 0.95;

/// The findings about a scene.
#[derive(Clone, Debug)]
pub struct Inspection {
    /// Area of each surface (scene length²).
    pub areas: Vec<f64>,
    /// Surfaces that touch; here and below without the backs of two-sided surfaces.
    pub contacts: Vec<SurfaceContact>,
    /// Parts of planar surfaces on which bodies stand: they neither send nor receive light.
    pub footprints: Vec<Footprint>,
    /// Closed surfaces.
    pub shells: Vec<Shell>,
    /// Surfaces that pass through others where something moves.
    pub passages: Vec<Passage>,
    /// Luminaires that err as points.
    pub near_points: Vec<NearPoint>,
    /// Warnings of what looks wrong, each with the cure.
    pub warnings: Vec<Warning>,
}

impl Inspection {
    /// Inspects `scene`.
    pub fn of(scene: &Scene) -> Self {
        let sheets = Sheets::of(scene);
        let lying: HashSet<&str> = scene.fitted.lying.iter().map(|own| own.surface.as_str()).collect();
        let contacts = contact::contacts(&sheets);
        let borders = sheet_border::borders(&sheets);
        let groups = shell::groups(&sheets, &borders);
        let shells: Vec<Shell> = groups.iter().filter_map(|group| shell::shell(&sheets, group)).collect();
        let mut warnings = light(scene);
        warnings.extend(scene.surfaces.iter().filter_map(material));
        warnings.extend(luminaires::odd(scene));
        warnings.extend(contacts.iter().filter_map(|found| contact::intrusion(scene, &lying, found)));
        warnings.extend(gap::gaps(scene, &sheets, &borders, &contacts));
        warnings.extend(front::turned(scene, &sheets, &groups));
        warnings.extend(front::inside_out(scene, &sheets, &shells));
        warnings.extend(front::blind(scene, &sheets, &groups, &shells, &lying));
        warnings.extend(before_openings(scene));
        let frames = scene.frames().checked_sub(1).map(|last| [0, last]);
        let passages = frames.map_or_else(Vec::new, |frames| passage::among(scene, &sheets, frames));
        warnings.extend(passages.iter().map(Passage::warning));
        let areas = scene.surfaces.par_iter().map(|surface| surface.shape.area()).collect();
        let near_points = luminaires::near_points(scene);
        Inspection { areas, contacts, footprints: footprints(scene), shells, passages, near_points, warnings }
    }
}

fn light(scene: &Scene) -> Vec<Warning> {
    let dark = "give a material an emission above 0, or add luminaires, or a sky and an opening to it";
    let dark = || format!("nothing emits light: {}", by_keys(scene, dark));
    let unseen = || {
        let cure = by_keys(scene, "add a [camera] with eye and target");
        format!("there is no camera: pictures show a view that is chosen; {cure}")
    };
    let dark = (!scene.emits()).then(|| Warning::general("no-emitter", &dark()));
    let unseen = scene.camera.is_none().then(|| Warning::general("no-camera", &unseen()));
    dark.into_iter().chain(unseen).collect()
}

fn material(surface: &SceneSurface) -> Option<Warning> {
    let material = &surface.material;
    let most = |band: usize| {
        let pattern = material.reflectance_pattern.as_ref();
        pattern.map_or(material.reflectance[band], |own| own.range(band)[1]) + material.transmittance[band]
    };
    let bright = (0..material.reflectance.len()).map(most).fold(0.0, f64::max);
    if surface.material_name.is_none() {
        let message = "has no material, it counts as black".to_owned();
        Some(Warning::about("no-material", &surface.name, message))
    } else if bright > BRIGHT {
        let message = format!("reflects {bright}, few real materials exceed {BRIGHT}");
        Some(Warning::about("bright", &surface.name, message))
    } else {
        None
    }
}
