//! Remarks: what was left out or changed, each kind said once, and not too many kinds.

use std::collections::HashMap;

use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;

use super::element::Element;

/// Most kinds of remarks, more than a person reads; further ones are one kind, so that a scene cannot fill
/// the memory with them.
const MOST: usize = 100;

/// Remarks of a reader, each kind once with the number of its occurrences.
#[derive(Debug, Default)]
pub(super) struct Remarks {
    notes: Vec<Note>,
    known: HashMap<String, usize>,
}

impl Remarks {
    /// Remarks something about an element; what was remarked before is only counted.
    pub(super) fn add(&mut self, text: impl Into<String>, element: &Element) {
        let text = text.into();
        let is_room = self.notes.len() < MOST || self.known.contains_key(&text);
        let text = if is_room { text } else { "other things that are not known are left out".to_owned() };
        let next = self.notes.len();
        let index = *self.known.entry(text.clone()).or_insert(next);
        match self.notes.get_mut(index) {
            Some(note) => note.count += 1,
            None => self.notes.push(Note { text, place: Some(FilePlace::Line(element.line)), count: 1 }),
        }
    }

    /// The notes, in the order of what they were first remarked about.
    pub(super) fn notes(self) -> Vec<Note> {
        self.notes
    }
}
