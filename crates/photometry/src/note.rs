//! What reading left out or changed.

use crate::place::Place;

/// Something that was left out or changed by reading: "specular reflection is left out".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// What, without a full stop.
    pub text: String,
    /// Where it occurred first.
    pub place: Option<Place>,
    /// How often.
    pub count: usize,
}

impl Note {
    /// Adds something at `place` to `notes`; what is among them is only counted.
    pub fn add(notes: &mut Vec<Note>, text: impl Into<String>, place: Option<Place>) {
        let text = text.into();
        match notes.iter_mut().find(|note| note.text == text) {
            Some(note) => note.count += 1,
            None => notes.push(Note { text, place, count: 1 }),
        }
    }
}
