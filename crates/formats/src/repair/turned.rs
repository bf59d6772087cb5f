//! Fronts that point the wrong way.

use radiosity_work::listed::quoted;

use crate::fronts::{TurnReason, turned};
use crate::model::Model;
use crate::repair::record::{RepairKind, Repairs};

/// Turns over what shows its front the wrong way, if `fixes`; else only says so.
pub(super) fn mend(model: &mut Model, fixes: bool, repairs: &mut Repairs) {
    for found in turned(model) {
        let names: Vec<String> =
            found.surfaces.iter().map(|surface| model.surfaces[*surface].name.clone()).collect();
        let count = names.len();
        let [show, were] =
            if count == 1 { ["shows its front", "it was"] } else { ["show their fronts", "they were"] };
        let what = match found.why {
            TurnReason::Neighbours => {
                let beside = &model.surfaces[found.beside].name;
                format!("{} {show} where {beside:?} beside has its back", quoted(&names))
            }
            TurnReason::Halves => {
                let beside = &model.surfaces[found.beside].name;
                format!("{} {show} where {beside:?} beside has its back, of equal areas", quoted(&names))
            }
            TurnReason::Inwards => format!("{} enclose nothing and {show} inwards", quoted(&names)),
            TurnReason::Outwards => format!("{} enclose everything and {show} outwards", quoted(&names)),
        };
        let is_fixed = fixes && found.why != TurnReason::Halves;
        let (kind, done) = match is_fixed {
            true => (RepairKind::Fronts, "turned over"),
            false => (RepairKind::DoubtfulFronts, "left so"),
        };
        let first = found.surfaces.first().map(|surface| &model.surfaces[*surface]);
        repairs.say(kind, names, first, format!("{what}; {were} {done}"));
        if is_fixed {
            found.surfaces.iter().for_each(|surface| model.surfaces[*surface].shape.turn_over());
        }
    }
}
