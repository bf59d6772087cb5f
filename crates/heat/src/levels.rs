//! Whether temperatures set the level of all parts of a scene.
//!
//! In a part of a scene whose surfaces exchange heat with one another alone, all of known flux, any constant
//! may be added to σ T⁴: there is no balance, or there are many. Where all are adiabatic, nothing flows at any
//! level, and none of the others takes part: the flows of the rest are as without them.

use std::collections::BTreeMap;

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_scene::Scene;
use radiosity_solve::{Model, Options};

use super::error::HeatError;
use super::roles::{Role, Roles, named};

/// Share of its heat that a part has to lose to count as open, over the accuracy of the blocks: what it seems
/// to lose by their errors alone is less. With a smaller value a closed part would pass, and its temperature
/// be anything.
const OPEN: f64 = 10.0;

/// Makes surfaces idle that neither gain nor lose heat and whose part has neither a temperature nor an opening.
///
/// # Errors
/// Such a part in which heat is given.
pub(super) fn settle(
    scene: &Scene,
    roles: &mut Roles,
    model: &Model,
    options: &Options,
) -> Result<(), HeatError> {
    let open = OPEN * options.eps.max(options.shadow_eps).max(model.blocks().statistics.accuracy_reached);
    let list = model.elements().list();
    let parts = parts(roles, model, scene.surfaces.len());
    let ones = model.elements().constant();
    let received = model.blocks().apply(&ones);
    let starts = model.elements().starts();
    let kept =
        |index: usize, element: &Element| dot(&element.constant, &received[starts[index]..starts[index + 1]]);
    let mut sums: BTreeMap<usize, Part> = BTreeMap::new();
    for (index, element) in list.iter().enumerate() {
        let part = sums.entry(parts[element.surface]).or_default();
        part.area += element.area;
        part.kept += kept(index, element);
        part.has_temperature |= matches!(roles.list[element.surface], Role::Temperature { .. });
        part.is_given |= !roles.is_adiabatic(element.surface);
    }
    let floats = |part: &Part| !part.has_temperature && part.kept > (1.0 - open) * part.area;
    sums.retain(|_, part| floats(part));
    match sums.iter().find(|(_, part)| part.is_given) {
        None => {
            roles.idle(|surface| sums.contains_key(&parts[surface]));
            Ok(())
        }
        Some((floating, _)) => {
            Err(HeatError::NoLevel { surfaces: named(scene, |surface, _| parts[surface] == *floating) })
        }
    }
}

/// Sums over the elements of a part.
#[derive(Default)]
struct Part {
    area: f64,
    /// Power that reaches other elements of the part where all emit 1.
    kept: f64,
    has_temperature: bool,
    /// Whether a temperature or a flux other than 0 is given.
    is_given: bool,
}

/// For each surface the first surface of its part: surfaces that exchange heat, and sides of one shield.
fn parts(roles: &Roles, model: &Model, surfaces: usize) -> Vec<usize> {
    let list = model.elements().list();
    let stored = model.blocks().first_entries().into_iter();
    let seen = stored.map(|first| [list[first.row].surface, list[first.column].surface]);
    let pairs = seen.chain(roles.shields.iter().map(|shield| shield.sides));
    let mut parents: Vec<usize> = (0..surfaces).collect();
    for pair in pairs {
        let [a, b] = pair.map(|surface| root(&mut parents, surface));
        parents[a.max(b)] = a.min(b);
    }
    (0..surfaces).map(|surface| root(&mut parents, surface)).collect()
}

fn root(parents: &mut [usize], mut surface: usize) -> usize {
    while parents[surface] != surface {
        parents[surface] = parents[parents[surface]];
        surface = parents[surface];
    }
    surface
}
