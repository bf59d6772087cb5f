//! What was done to a scene of another program when it was read.

use std::fmt;

use radiosity_formats::{format::Format, model::Note, place::Place, repair::Repair};
use serde::{Serialize, Serializer, ser::SerializeStruct};

/// What was done to a scene of another program when it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The file, as it was named.
    pub file: String,
    /// Its format.
    pub format: Format,
    /// What a file of materials changed.
    pub replaced: Vec<String>,
    /// What was left out.
    pub notes: Vec<Note>,
    /// What was repaired.
    pub repairs: Vec<Repair>,
}

impl Imported {
    /// What was done, in lines.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        let at = |place: Option<Place>| Located { file: &self.file, place };
        let note = move |note: &Note| {
            let times = if note.count > 1 { format!(" ({} times)", note.count) } else { String::new() };
            format!("{}: {}{times}", at(note.place), note.text)
        };
        let repair = move |repair: &Repair| format!("{}: {}", at(repair.place), repair.text);
        let notes = self.notes.iter().map(note);
        self.replaced.iter().cloned().chain(notes).chain(self.repairs.iter().map(repair))
    }
}

impl Serialize for Imported {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Imported", 3)?;
        fields.serialize_field("file", &self.file)?;
        fields.serialize_field("format", self.format.name())?;
        fields.serialize_field("remarks", &self.lines().collect::<Vec<_>>())?;
        fields.end()
    }
}

/// A file and a line or byte of it: `room.mgf:12`.
pub(super) struct Located<'a> {
    pub file: &'a str,
    pub place: Option<Place>,
}

impl fmt::Display for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some(Place::Line(line)) => write!(f, "{}:{line}", self.file),
            Some(Place::Byte(byte)) => write!(f, "{}: byte {byte}", self.file),
            None => write!(f, "{}", self.file),
        }
    }
}
