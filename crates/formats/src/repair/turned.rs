//! Fronts that point the wrong way.

use radiosity_photometry::note_text::NoteText;

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
        let text = NoteText::default().naming_all(&names);
        let beside = |text: NoteText| {
            let other = &model.surfaces[found.beside].name;
            text.then(format!(" {show} where ")).naming(other).then(" beside has its back")
        };
        let text = match found.why {
            TurnReason::Neighbours => beside(text),
            TurnReason::Halves => beside(text).then(", of equal areas"),
            TurnReason::Inwards => text.then(format!(" enclose nothing and {show} inwards")),
            TurnReason::Outwards => text.then(format!(" enclose everything and {show} outwards")),
        };
        let is_fixed = fixes && found.why != TurnReason::Halves;
        let (kind, done) = match is_fixed {
            true => (RepairKind::Fronts, "turned over"),
            false => (RepairKind::DoubtfulFronts, "left so"),
        };
        let first = found.surfaces.first().map(|surface| &model.surfaces[*surface]);
        repairs.say(kind, names, first, text.then(format!("; {were} {done}")));
        if is_fixed {
            found.surfaces.iter().for_each(|surface| model.surfaces[*surface].shape.turn_over());
        }
    }
}
