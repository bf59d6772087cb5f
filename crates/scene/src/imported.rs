//! What was done to a scene of another program when it was read.

use serde::{Serialize, Serializer, ser::SerializeStruct};

/// What was done to a scene of another program when it was read, in lines that begin with the file and the place.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The file, as it was named.
    pub file: String,
    /// The name of its format.
    pub format: &'static str,
    /// What a file of materials changed.
    pub replaced: Vec<String>,
    /// What was left out.
    pub notes: Vec<String>,
    /// What was repaired.
    pub repairs: Vec<String>,
}

impl Imported {
    /// What was done, in lines.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        self.replaced.iter().chain(&self.notes).chain(&self.repairs).cloned()
    }
}

impl Serialize for Imported {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Imported", 3)?;
        fields.serialize_field("file", &self.file)?;
        fields.serialize_field("format", self.format)?;
        fields.serialize_field("remarks", &self.lines().collect::<Vec<_>>())?;
        fields.end()
    }
}
