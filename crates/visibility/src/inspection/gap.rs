//! Gaps: borders that nearly meet another sheet.

use std::collections::{BTreeMap, BTreeSet};

use radiosity_geom::{Adjacency, DVec3};
use radiosity_scene::Scene;

use crate::inspection::{
    contact::SurfaceContact,
    sheet::Sheets,
    sheet_border::{BorderSample, Meeting, SheetBorder},
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
    let mut widest: Vec<Gap> = Vec::new();
    let mut known = BTreeMap::new();
    for gap in borders.iter().filter_map(widest_gap).filter(|gap| !cross(gap.sheets)) {
        let index = *known.entry(gap.sheets).or_insert(widest.len());
        match widest.get_mut(index) {
            Some(found) if found.distance < gap.distance => *found = gap,
            Some(_) => {}
            None => widest.push(gap),
        }
    }
    let warning = |Gap { sheets: [own, other], distance, point }: Gap| {
        let [own, other] = [own, other].map(|k| &sheets.list[k].name);
        let place = place(point + scene.middle);
        let message =
            format!("leaves a gap of {distance:.2e} to {other:?} near {place}: move their borders together");
        Warning::about("gap", own, message)
    };
    widest.into_iter().map(warning).collect()
}

/// A gap between two sheets.
#[derive(Clone, Copy)]
struct Gap {
    /// Indices of the sheets, ascending.
    sheets: [usize; 2],
    /// Its width (scene length).
    distance: f64,
    /// Where it is so wide.
    point: DVec3,
}

/// The widest gap of a border if it has one along at least half of it.
fn widest_gap(border: &SheetBorder) -> Option<Gap> {
    let gap = |BorderSample { point, meeting }: &BorderSample| match *meeting {
        Meeting::Gap { sheet, distance } => {
            let sheets = [border.sheet.min(sheet), border.sheet.max(sheet)];
            Some(Gap { sheets, distance, point: *point })
        }
        _ => None,
    };
    let found: Vec<_> = border.places.iter().filter_map(gap).collect();
    if 2 * found.len() < border.places.len() {
        return None;
    }
    found.into_iter().max_by(|a, b| a.distance.total_cmp(&b.distance))
}
