//! Flat sheets that lie before or behind each other, within their tolerance but apart.
//!
//! A box that hovers over a floor, a picture before a wall, two plates: their gap has a sign in all corners, and light
//! depends on it. The rules of transport hold for every gap but the [least](gap::least), so such sheets are
//! not welded, but for gaps within the rounding of their coordinates.

use std::collections::HashSet;

use crate::scene::{coincident::common_area, gap};

use super::sheet::Sheets;

/// Thickness of the slab that two sheets must lie in to count as parallel, in tolerances: several sheets of one body are judged
/// by tolerances of their own, and all of them are to be apart or none.
const SLAB: f64 = 100.0;

/// Share of the smaller area that two sheets must have in common, seen along their normal, to lie before each other.
const SHARED: f64 = 1e-6;

/// Pairs of sheets that are apart, both ways round.
pub(super) type Apart = HashSet<(usize, usize)>;

/// All such pairs.
pub(super) fn pairs(sheets: &Sheets) -> Apart {
    let mut apart = Apart::new();
    for (own, sheet) in sheets.list.iter().enumerate() {
        let Some(region) = &sheet.region else { continue };
        for other in sheets.near(sheet.bounds()).into_iter().filter(|other| *other != own) {
            let Some(over) = &sheets.list[other].region else { continue };
            let tolerance = sheet.tolerance.with(&sheets.list[other].tolerance);
            let [low, high] = sheets.list[other].heights_over(region);
            let uncertain = sheet.tolerance.uncertainty(&sheets.list[other].tolerance);
            let told = gap::least(region.extent(), over.extent()).max(uncertain);
            let is_near = low.abs().max(high.abs()) <= SLAB * tolerance;
            if is_near
                && (low > told || high < -told)
                && common_area(region, over) > SHARED * region.area().min(over.area())
            {
                apart.extend([(own, other), (other, own)]);
            }
        }
    }
    apart
}
