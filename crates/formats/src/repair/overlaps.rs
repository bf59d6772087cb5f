//! Flat faces that lie partly on one another.
//!
//! Of two faces with the same front the smaller lies on the larger, and the covered part of the larger is cut
//! out; of two that show each other their fronts the covered part of the smaller, which no
//! light reaches. Emitters are not cut by what does not emit. `radiosity` itself sets apart pictures wholly
//! on their walls, plates of which both sides count, and faces of bodies that stand on others: these stay.

use std::collections::BTreeMap;

use radiosity_fit::overlay::{Part, enclosed, without};
use radiosity_fit::sides::are_sides_of_one;
use radiosity_geom::{SAME_AREA, layer_order};
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape, Sides};
use crate::repair::edit::{Edit, Told};
use crate::repair::record::{RepairKind, Repairs};
use crate::repair::sheets::{Sheet, Sheets};

/// Most rounds: what is left of a face that was cut may lie partly on others in turn. Stacks of more faces
/// that cover each other in part keep some overlap.
const ROUNDS: usize = 8;

/// Cuts what lies on others out of flat faces.
pub(super) fn mend(model: &mut Model, asked: Option<f64>, repairs: &mut Repairs) {
    let mut changed: Option<Vec<bool>> = None;
    for _ in 0..ROUNDS {
        let indices = round(model, changed.as_deref(), asked, repairs);
        if indices.is_empty() {
            return;
        }
        let mut marks = vec![false; model.surfaces.len()];
        indices.into_iter().for_each(|index| marks[index] = true);
        changed = Some(marks);
    }
}

/// Cuts every face once by all that lie on it; the indices of what is left of those that were cut.
fn round(
    model: &mut Model,
    changed: Option<&[bool]>,
    asked: Option<f64>,
    repairs: &mut Repairs,
) -> Vec<usize> {
    let sheets = Sheets::of(model);
    let mut cuts: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let is_new = |index: usize| changed.is_none_or(|marks| marks[sheets.list[index].surface]);
    for index in (0..sheets.list.len()).filter(|index| is_new(*index)) {
        // Of two new ones the earlier finds the later.
        for other in sheets.beside(index).filter(|other| *other > index || !is_new(*other)) {
            let pair = [index.min(other), index.max(other)];
            if let Some([cut, by]) = (Pair { model, sheets: &sheets, pair }).cut() {
                cuts.entry(cut).or_default().push(by);
            }
        }
    }
    let mut edit = Edit::default();
    for (cut, by) in cuts {
        let sheet = &sheets.list[cut];
        let name_of = |other: &usize| model.surfaces[sheets.list[*other].surface].name.clone();
        let others: Vec<String> = by.iter().map(name_of).collect();
        let verb = if others.len() == 1 { "shares" } else { "share" };
        let by_others =
            NoteText::default().naming_all(&others).then(format!(" {verb} a part of the place of "));
        let text = move |name: &str, names: &[String]| {
            let text = by_others.clone().naming(name);
            let cut = |text: NoteText| text.then("; that part of ").naming(name).then(" was cut out");
            let text = match names {
                [] => text.then("; nothing of ").naming(name).then(" was left"),
                [_] => cut(text),
                names => cut(text).then(", which left ").naming_all(names),
            };
            (RepairKind::Overlap, text)
        };
        let shapes = rest(sheet, by.iter().map(|other| &sheets.list[*other]), asked);
        edit.tell(sheet.surface, shapes, Told { others, text: Box::new(text) });
    }
    edit.apply(model, repairs)
}

/// Parts of a face outside other faces of its plane.
fn rest<'a>(sheet: &Sheet, others: impl Iterator<Item = &'a Sheet>, asked: Option<f64>) -> Vec<Shape> {
    let parts = |sheet_of: &Sheet| -> Vec<Part> {
        let outline = enclosed(&sheet.plane, &[&sheet_of.outline], asked);
        let holes: Vec<Part> =
            sheet_of.holes.iter().flat_map(|hole| enclosed(&sheet.plane, &[hole], asked)).collect();
        if holes.is_empty() { outline } else { without(&sheet.plane, &outline, &holes, asked) }
    };
    let cut: Vec<Part> = others.flat_map(parts).collect();
    let own = Part { outline: sheet.outline.to_vec(), holes: Vec::new() };
    let left = match sheet.holes[..] {
        [] => without(&sheet.plane, &[own], &cut, asked),
        _ => without(&sheet.plane, &parts(sheet), &cut, asked),
    };
    left.into_iter().map(|part| Shape::Polygon { outline: part.outline, holes: part.holes }).collect()
}

/// Two faces in one plane.
struct Pair<'a> {
    model: &'a Model,
    sheets: &'a Sheets,
    pair: [usize; 2],
}

impl Pair<'_> {
    /// The face that has to be cut, and the one that cuts it; None if nothing has to be.
    fn cut(&self) -> Option<[usize; 2]> {
        let [first, second] = self.pair.map(|index| &self.sheets.list[index]);
        let is_sheet =
            are_sides_of_one([first, second].map(|sheet| self.model.surfaces[sheet.surface].name.as_str()));
        if first.is_round || second.is_round || is_sheet {
            return None;
        }
        let common = first.common_area(second);
        if common <= 0.0 {
            return None;
        }
        // Of equal ones the later lies on the earlier.
        let [small, large] = match layer_order(second.area, first.area).is_ge() {
            true => [self.pair[1], self.pair[0]],
            false => self.pair,
        };
        let [sheet, on] = [small, large].map(|index| &self.sheets.list[index]);
        if self.is_two_sided(sheet) {
            return None;
        }
        let is_within = common > (1.0 - SAME_AREA) * sheet.area;
        let is_alike = sheet.is_alike(on) || self.is_two_sided(on);
        if is_alike {
            let is_lamp_covered = self.model.emits(on.surface) && !self.model.emits(sheet.surface);
            let cut = if is_lamp_covered { [small, large] } else { [large, small] };
            return (!is_within).then_some(cut);
        }
        // Back to back, or a body that stands there.
        let is_body = self.sheets.body(sheet) != 0.0 || is_within && self.sheets.body(on) < 0.0;
        let cut = if self.model.emits(sheet.surface) { [large, small] } else { [small, large] };
        (!is_body).then_some(cut)
    }

    fn is_two_sided(&self, sheet: &Sheet) -> bool {
        self.model.surfaces[sheet.surface].sides == Sides::Both
    }
}
