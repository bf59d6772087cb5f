//! Reflectances that no material has.

use std::collections::HashMap;

use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Surface};
use crate::repair::record::{RepairKind, Repairs};

/// The largest reflectance: what reflects all light never comes to rest, and no paint does. An arbitrary
/// choice: nearer to 1, light takes more than a thousand reflections to fall to 1/e.
const MOST: f64 = 0.999;

/// Brings reflectances into 0 ≤ ρ < 1.
pub(super) fn mend(model: &mut Model, repairs: &mut Repairs) {
    let bands = &model.bands;
    let mut users: HashMap<usize, Vec<&Surface>> = HashMap::new();
    for surface in &model.surfaces {
        surface.material.into_iter().for_each(|index| users.entry(index).or_default().push(surface));
    }
    for (index, material) in model.materials.iter_mut().enumerate() {
        let mut parts: Option<NoteText> = None;
        for (band, value) in material.reflectance.iter_mut().enumerate() {
            let allowed = if *value >= 1.0 { MOST } else { value.max(0.0) };
            if *value < 0.0 || *value >= 1.0 {
                let before = parts.map_or_else(NoteText::default, |parts| parts.then(", "));
                let part = before.then(value.to_string());
                let part = match bands.get(band) {
                    Some(name) if bands.len() > 1 => part.then(" in band ").naming(name),
                    _ => part,
                };
                parts = Some(part.then(format!(" became {allowed}")));
                *value = allowed;
            }
        }
        if let Some(parts) = parts {
            let users = users.get(&index).map_or(&[][..], Vec::as_slice);
            let names = users.iter().map(|surface| surface.name.clone()).collect();
            let text =
                NoteText::from("reflectance of material ").naming(&material.name).then(": ").followed(&parts);
            repairs.say(RepairKind::Reflectance, names, users.first().copied(), text);
        }
    }
}
