//! How far elements are from where they were seen first.

use std::collections::HashMap;
use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::Patch;

/// Relative difference of coordinates, and of values of functions, that is rounding. Chosen: coordinates of moved things were
/// rounded two or three times, and what follows from them is amplified by the functions.
const ROUNDED: f64 = 1e-14;
const ROUNDED_VALUES: f64 = 1e-10;

/// Where the elements were seen first.
#[derive(Debug, Default)]
pub(super) struct Places {
    seen: HashMap<usize, Seen>,
}

#[derive(Debug)]
struct Seen {
    element: Arc<Element>,
    turn: u32,
}

/// Where an element is.
#[derive(Debug)]
pub(super) struct Place {
    /// The element as it was seen first.
    pub reference: Arc<Element>,
    /// How often it was seen anew because it was not only translated.
    pub turn: u32,
    /// Its displacement since (scene length).
    pub shift: DVec3,
}

impl Places {
    /// Where the element number `index` is.
    pub(super) fn of(&mut self, index: usize, element: &Element) -> Place {
        let anew = |turn: u32| Seen { element: Arc::new(element.clone()), turn };
        let seen = self.seen.entry(index).or_insert_with(|| anew(0));
        let shift = translation(&seen.element, element).unwrap_or_else(|| {
            *seen = anew(seen.turn + 1);
            DVec3::ZERO
        });
        Place { reference: Arc::clone(&seen.element), turn: seen.turn, shift }
    }
}

/// The displacement that makes one flat element the other, with its functions; None if there is none.
fn translation(from: &Element, to: &Element) -> Option<DVec3> {
    let [own, other] = [corners(from)?, corners(to)?];
    let shift = *other.first()? - *own.first()?;
    let size = own.iter().chain(&other).fold(0.0, |most: f64, x| most.max(x.length()));
    let is_moved = |(a, b): (&DVec3, &DVec3)| (b - a - shift).length() <= ROUNDED * size;
    let is_alike = |(a, b): (&DVec3, &DVec3)| {
        let [own, other] = [values(from, *a), values(to, *b)];
        let most = own.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        own.len() == other.len()
            && own.iter().zip(&other).all(|(x, y)| (x - y).abs() <= ROUNDED_VALUES * most)
    };
    let (_, before) = from.plane?;
    let (_, now) = to.plane?;
    let is_turned = (before - now).length() > ROUNDED;
    let all = || own.iter().zip(&other);
    let is_same = own.len() == other.len() && !is_turned && all().all(is_moved) && all().all(is_alike);
    is_same.then_some(shift)
}

/// The corners of all patches; None if one is curved.
fn corners(element: &Element) -> Option<Vec<DVec3>> {
    let flat = element.patches.iter().all(Patch::is_flat);
    flat.then(|| element.patches.iter().flat_map(Patch::corners).collect())
}

/// φ_k at a point of the plane.
fn values(element: &Element, x: DVec3) -> Vec<f64> {
    let raw = element.raw_values(x, [0.0; 2]);
    let rows = element.basis.transform().chunks_exact(raw.len());
    rows.map(|row| row.iter().zip(&raw).map(|(t, r)| t * r).sum()).collect()
}
