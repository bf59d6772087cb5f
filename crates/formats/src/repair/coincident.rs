//! Flat faces in the same place: one plane, one region, whatever vertex they begin with and whichever way
//! they run.
//!
//! Two bodies that touch have faces in the same place too, their fronts opposite: these are sound,
//! `radiosity` sets them apart by the bodies behind them.

use radiosity_fit::outline::tolerance;
use radiosity_geom::SAME_AREA;

use crate::model::Model;
use crate::repair::copies::Copies;
use crate::repair::record::Repairs;
use crate::repair::sheets::{Sheet, Sheets};

/// Keeps one of flat faces in the same place.
pub(super) fn mend(model: &mut Model, repairs: &mut Repairs) {
    let sheets = Sheets::of(model);
    let mut copies = Copies::of(model);
    for (index, own) in sheets.list.iter().enumerate() {
        if own.is_round || !copies.is_there(own.surface) {
            continue;
        }
        for other in sheets.later(index) {
            let other = &sheets.list[other];
            if !copies.is_there(own.surface) {
                break;
            }
            if copies.is_there(other.surface)
                && is_copy(own, other)
                && !is_of_bodies(model, [own, other], &sheets, &copies)
            {
                copies.settle(model, own.surface, other.surface, own.is_alike(other));
            }
        }
    }
    copies.make(model, repairs);
}

fn is_copy(own: &Sheet, other: &Sheet) -> bool {
    let (own_box, other_box) = (own.bounds, other.bounds);
    let near = (SAME_AREA * own.extent).max(tolerance(&own.outline, None));
    !other.is_round
        && (own.area - other.area).abs() <= SAME_AREA * own.area
        && own_box.min.distance(other_box.min).max(own_box.max.distance(other_box.max)) <= near
        && own.common_area(other) >= (1.0 - SAME_AREA) * own.area
}

/// Whether two faces show opposite fronts and belong to bodies.
fn is_of_bodies(model: &Model, [own, other]: [&Sheet; 2], sheets: &Sheets, copies: &Copies) -> bool {
    let is_opposed = !own.is_alike(other);
    let is_one_sided = [own, other].iter().all(|sheet| copies.is_one_sided(model, sheet.surface));
    is_opposed && is_one_sided && (sheets.body(own) != 0.0 || sheets.body(other) != 0.0)
}
