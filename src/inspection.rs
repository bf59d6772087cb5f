//! What is in a scene, what touches what, and what looks wrong: before anything is computed.
//!
//! The geometry is looked at in sampled places, so that hundreds of surfaces take little time; a scene without light or
//! materials can be inspected too.

mod sheet;
mod rim;
pub mod shell;
pub mod warning;
pub mod contact;
mod front;
mod gap;

pub use contact::Contact;
pub use shell::{Fronts, Shell};
pub use warning::Warning;

use crate::footings::{Footing, footings};
use crate::scene::{Scene, SceneSurface};
use rayon::prelude::*;
use sheet::Sheets;

/// Reflectances above this make light bounce so often that a small error in them is a large one in the result.
const BRIGHT: f64 = 0.95;

/// The findings about a scene.
#[derive(Clone, Debug)]
pub struct Inspection {
    /// Area of each surface (scene length²).
    pub areas: Vec<f64>,
    /// Surfaces that touch; the back of a two-sided surface is left out, here and below.
    pub contacts: Vec<Contact>,
    /// Parts of planar surfaces that others stand on: they neither send nor receive.
    pub footings: Vec<Footing>,
    /// Closed surfaces.
    pub shells: Vec<Shell>,
    /// What looks wrong.
    pub warnings: Vec<Warning>,
}

impl Inspection {
    /// Looks at `scene`.
    pub fn of(scene: &Scene) -> Self {
        let sheets = Sheets::of(scene);
        let contacts = contact::contacts(&sheets);
        let rims = rim::rims(&sheets);
        let groups = shell::groups(&sheets, &rims);
        let shells: Vec<Shell> = groups.iter().filter_map(|group| shell::shell(&sheets, group)).collect();
        let mut warnings = light(scene);
        warnings.extend(scene.surfaces.iter().filter_map(material));
        warnings.extend(contacts.iter().filter_map(|found| contact::intrusion(scene, found)));
        warnings.extend(gap::gaps(scene, &sheets, &rims, &contacts));
        warnings.extend(front::turned(&sheets, &groups));
        warnings.extend(front::inside_out(&sheets, &shells, scene.camera.as_ref()));
        warnings.extend(front::blind(&sheets));
        let areas = scene.surfaces.par_iter().map(|surface| surface.shape.area()).collect();
        Inspection { areas, contacts, footings: footings(scene), shells, warnings }
    }
}

fn light(scene: &Scene) -> Vec<Warning> {
    let emits = scene.surfaces.iter().any(|surface| surface.material.emits());
    let dark = "no surface emits light: give a material an emission above 0";
    let unseen = "there is no camera for a picture: add a [camera] with eye and target";
    let dark = (!emits).then(|| Warning::general("no-emitter", dark));
    let unseen = scene.camera.is_none().then(|| Warning::general("no-camera", unseen));
    dark.into_iter().chain(unseen).collect()
}

fn material(surface: &SceneSurface) -> Option<Warning> {
    let bright = surface.material.reflectance.iter().copied().fold(0.0, f64::max);
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
