//! Which of two surfaces in the same place is kept.
//!
//! The emitter, or else the first. Two one-sided faces back to back are the two sides of one sheet: of one
//! material they become one two-sided surface, of two materials the one is named the back of the other, which
//! `radiosity` lets be.

use std::collections::HashSet;

use radiosity_fit::sides::{are_sides_of_one, back_of};
use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Sides};
use crate::repair::edit::Edit;
use crate::repair::record::{RepairKind, Repairs};

/// Surfaces of which some go or change because of copies.
pub(super) struct Copies {
    gone: Vec<bool>,
    both: Vec<bool>,
    /// Whether each surface becomes the back of another one.
    is_back: Vec<bool>,
    backs: Vec<NewBack>,
    names: HashSet<String>,
    repairs: Repairs,
}

/// A surface that becomes the back of another one.
struct NewBack {
    surface: usize,
    /// Its new name.
    name: String,
}

impl Copies {
    pub(super) fn of(model: &Model) -> Self {
        let names = model.surfaces.iter().map(|surface| surface.name.clone()).collect();
        let none = || vec![false; model.surfaces.len()];
        let repairs = Repairs::default();
        Copies { gone: none(), both: none(), is_back: none(), backs: vec![], names, repairs }
    }

    /// Whether a surface is still one of its own: neither removed nor the back of another one.
    pub(super) fn is_there(&self, surface: usize) -> bool {
        !self.gone[surface] && !self.is_back[surface]
    }

    /// Whether one side only of a surface reflects and emits.
    pub(super) fn is_one_sided(&self, model: &Model, surface: usize) -> bool {
        model.surfaces[surface].sides != Sides::Both && !self.both[surface]
    }

    /// Settles two surfaces in the same place, the first by index first, with the same front or opposite
    /// ones. Front and back of one sheet stay.
    pub(super) fn settle(&mut self, model: &Model, first: usize, second: usize, is_alike: bool) {
        let [one, other] = [first, second].map(|index| &model.surfaces[index]);
        if !is_alike && are_sides_of_one([&one.name, &other.name]) {
            return;
        }
        let names = vec![one.name.clone(), other.name.clone()];
        let pair = NoteText::default().naming_all(&names);
        let is_sheet = !is_alike && self.is_one_sided(model, first) && self.is_one_sided(model, second);
        let back = back_of(&one.name);
        let text = if is_sheet && one.material == other.material {
            self.both[first] = true;
            self.gone[second] = true;
            let [kept, gone] = [&names[0], &names[1]];
            pair.then(" are the sides of one sheet; ")
                .naming(kept)
                .then(" was made two-sided, and ")
                .naming(gone)
                .then(" removed")
        } else if is_sheet && self.names.insert(back.clone()) {
            let text =
                pair.then(" are the sides of one sheet; ").naming(&names[1]).then(" is now ").naming(&back);
            self.is_back[second] = true;
            self.backs.push(NewBack { surface: second, name: back });
            text
        } else {
            let is_second = model.emits(second) && !model.emits(first);
            let gone = if is_second { first } else { second };
            self.gone[gone] = true;
            pair.then(" coincide; ").naming(&model.surfaces[gone].name).then(" was removed")
        };
        self.repairs.say(RepairKind::Coincident, names, Some(one), text);
    }

    /// Makes the changes and tells them.
    pub(super) fn make(self, model: &mut Model, repairs: &mut Repairs) {
        repairs.list.extend(self.repairs.list);
        for (surface, both) in model.surfaces.iter_mut().zip(&self.both) {
            surface.sides = if *both { Sides::Both } else { surface.sides };
        }
        for NewBack { surface, name } in self.backs {
            model.surfaces[surface].name = name;
        }
        let mut edit = Edit::default();
        let gone = self.gone.iter().enumerate().filter(|(_, gone)| **gone);
        gone.for_each(|(index, _)| edit.replace(index, Vec::new()));
        edit.apply(model, repairs);
    }
}
