//! Flat sheets that lie in front of or behind each other, within their tolerance but apart.
//!
//! A box that hovers over a floor, a picture before a wall, two plates: their gap has the same sign in all
//! corners, and light depends on it. The rules of transport hold for every gap but the [least](gap::least),
//! so such sheets are not welded, except for gaps within the rounding of their coordinates.

use std::collections::HashSet;

use super::sheet::Sheets;
use crate::tolerances::SHARED_AREA;
use crate::{coincident::common_area, gap};

/// Thickness, in tolerances, of the slab that must contain two parallel sheets. Sheets of one body have
/// different tolerances, but all or none of them have to be apart: a hundred bears that they differ as much.
/// With a larger value more pairs are looked at; with a smaller one a sheet of a body may be welded to what
/// the others stay apart from.
const SLAB: f64 = 100.0;

/// Pairs of sheets that are apart, in both orders.
pub(super) type Apart = HashSet<(usize, usize)>;

/// All pairs of sheets that are apart.
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
                && common_area(region, over) > SHARED_AREA * region.area().min(over.area())
            {
                apart.extend([(own, other), (other, own)]);
            }
        }
    }
    apart
}
