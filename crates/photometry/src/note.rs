//! Notes: parts of a file that reading left out or changed.

use std::sync::Arc;

use crate::file_place::FilePlace;
use crate::note_text::NoteText;

/// Note on a part that was left out or changed by reading: "specular reflection is left out".
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Note {
    /// Text of the note, without a full stop.
    pub text: NoteText,
    /// The included file in which the first occurrence is; none for the file that was read.
    pub file: Option<Arc<str>>,
    /// Place of the first occurrence, if it is known.
    pub place: Option<FilePlace>,
    /// Number of occurrences, at least 1.
    pub count: usize,
}

/// Most kinds of notes, more than a person reads; further ones are one kind, so that a file cannot fill the
/// memory with them.
const MOST: usize = 100;

impl Note {
    /// Adds a note at `place` to `notes`; one whose text is among them already is only counted.
    pub fn add(notes: &mut Vec<Note>, text: impl Into<NoteText>, place: Option<FilePlace>) {
        Self::add_in(notes, text, None, place);
    }

    /// Adds a note at `place` of an included file, or of the file that is read, as [`Note::add`] does.
    pub fn add_in(
        notes: &mut Vec<Note>,
        text: impl Into<NoteText>,
        file: Option<&Arc<str>>,
        place: Option<FilePlace>,
    ) {
        Note { text: text.into(), file: file.cloned(), place, count: 1 }.put(notes);
    }

    /// Puts this note among others, as [`Note::add`] does.
    pub fn put(mut self, notes: &mut Vec<Note>) {
        if notes.len() >= MOST && notes.iter().all(|note| note.text != self.text) {
            self.text = "other things that are not known are left out".into();
        }
        match notes.iter_mut().find(|note| note.text == self.text) {
            Some(note) => note.count += self.count,
            None => notes.push(self),
        }
    }
}
