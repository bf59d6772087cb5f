//! Gaps: borders that nearly meet another sheet.

use std::collections::{BTreeMap, BTreeSet};

use radiosity_geom::{Adjacency, DVec3};
use radiosity_scene::Scene;

use crate::inspection::{
    contact::SurfaceContact,
    sheet::Sheets,
    sheet_border::{Meeting, SheetBorder},
    warning::{Warning, place},
};

/// Borders that nearly reach another sheet, once per pair, at the widest gap; not for surfaces that cross.
pub(super) fn gaps(
    scene: &Scene,
    sheets: &Sheets,
    borders: &[SheetBorder],
    contacts: &[SurfaceContact],
) -> Vec<Warning> {
    let crossing = contacts.iter().filter(|contact| matches!(contact.touch, Adjacency::Crossing { .. }));
    let crossing: BTreeSet<[usize; 2]> = crossing.map(|contact| contact.surfaces).collect();
    let cross = |pair: [usize; 2]| crossing.contains(&pair.map(|k| sheets.list[k].surface));
    let mut widest: Vec<([usize; 2], f64, DVec3)> = Vec::new();
    let mut known = BTreeMap::new();
    for (pair, distance, point) in borders.iter().filter_map(widest_gap).filter(|(pair, ..)| !cross(*pair)) {
        let index = *known.entry(pair).or_insert(widest.len());
        match widest.get_mut(index) {
            Some(found) if found.1 < distance => *found = (pair, distance, point),
            Some(_) => {}
            None => widest.push((pair, distance, point)),
        }
    }
    let warning = |([own, other], distance, point): ([usize; 2], f64, DVec3)| {
        let [own, other] = [own, other].map(|k| &sheets.list[k].name);
        let place = place(point + scene.middle);
        let message =
            format!("leaves a gap of {distance:.2e} to {other:?} near {place}: move their borders together");
        Warning::about("gap", own, message)
    };
    widest.into_iter().map(warning).collect()
}

/// The widest gap of a border if it has one along at least half of it, with its two sheets and place.
fn widest_gap(border: &SheetBorder) -> Option<([usize; 2], f64, DVec3)> {
    let gap = |(point, meeting): &(DVec3, Meeting)| match *meeting {
        Meeting::Gap { sheet, distance } => {
            Some(([border.sheet.min(sheet), border.sheet.max(sheet)], distance, *point))
        }
        _ => None,
    };
    let found: Vec<_> = border.places.iter().filter_map(gap).collect();
    if 2 * found.len() < border.places.len() {
        return None;
    }
    found.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))
}
