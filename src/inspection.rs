//! What is in a scene, what touches what, and what looks wrong: before anything is computed.
//!
//! The geometry is looked at in sampled places, so that hundreds of surfaces take little time; a scene without light or
//! materials can be inspected too.

pub mod contact;
mod front;
mod rim;
mod sheet;
pub mod shell;
pub mod warning;

pub use contact::{Contact, Touch};
pub use shell::{Fronts, Shell};
pub use warning::Warning;

use radiosity_geom::DVec3;

use crate::scene::{Scene, SceneSurface};
use rim::{Meeting, Rim};
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
        warnings.extend(contacts.iter().filter_map(|contact| intrusion(scene, contact)));
        warnings.extend(gaps(&sheets, &rims));
        warnings.extend(front::turned(&sheets, &groups));
        warnings.extend(front::inside_out(&sheets, &shells, scene.camera.as_ref()));
        warnings.extend(front::blind(&sheets));
        let areas = scene.surfaces.iter().map(|surface| surface.shape.area()).collect();
        Inspection { areas, contacts, shells, warnings }
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

/// Surfaces that pass through each other or share area.
fn intrusion(scene: &Scene, contact: &Contact) -> Option<Warning> {
    let [own, other] = contact.surfaces.map(|index| &scene.surfaces[index].name);
    match contact.touch {
        Touch::Crossing { at } => {
            let place = place(at);
            let message = format!("passes through {other:?} near {place}: end one where it meets the other");
            Some(Warning::about("crossing", own, message))
        }
        Touch::Overlap => {
            let message = format!("lies partly in {other:?}: move them apart, or remove one");
            Some(Warning::about("overlap", own, message))
        }
        Touch::Edge | Touch::Tee | Touch::Vertex => None,
    }
}

/// Borders that nearly reach another sheet, once for each pair, where the gap is widest.
fn gaps(sheets: &Sheets, rims: &[Rim]) -> Vec<Warning> {
    let mut widest: Vec<([usize; 2], f64, DVec3)> = Vec::new();
    for (pair, distance, point) in rims.iter().filter_map(widest_gap) {
        match widest.iter_mut().find(|(known, ..)| *known == pair) {
            Some(found) if found.1 < distance => *found = (pair, distance, point),
            Some(_) => {}
            None => widest.push((pair, distance, point)),
        }
    }
    let warning = |([own, other], distance, point): ([usize; 2], f64, DVec3)| {
        let [own, other] = [own, other].map(|k| &sheets.list[k].name);
        let place = place(point);
        let message =
            format!("leaves a gap of {distance:.2e} to {other:?} near {place}: move their borders together");
        Warning::about("gap", own, message)
    };
    widest.into_iter().map(warning).collect()
}

/// The widest gap of a border that has one along half of it, with its two sheets and its place.
fn widest_gap(rim: &Rim) -> Option<([usize; 2], f64, DVec3)> {
    let gap = |(point, meeting): &(DVec3, Meeting)| match *meeting {
        Meeting::Gap { sheet, distance } => {
            Some(([rim.sheet.min(sheet), rim.sheet.max(sheet)], distance, *point))
        }
        _ => None,
    };
    let found: Vec<_> = rim.places.iter().filter_map(gap).collect();
    if 2 * found.len() < rim.places.len() {
        return None;
    }
    found.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))
}

/// A point to four digits.
fn place(point: DVec3) -> String {
    let digits = (3.0 - point.abs().max_element().max(1e-9).log10().floor()).max(0.0);
    let scale = 10_f64.powf(digits);
    let [x, y, z] = (point * scale).to_array().map(|x| x.round() / scale + 0.0);
    format!("({x}, {y}, {z})")
}
