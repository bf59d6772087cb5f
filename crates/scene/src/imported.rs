//! Records of imports: changes to a scene of another program when it was read.

use serde::{Serialize, Serializer, ser::SerializeStruct};

/// Record of the import of a scene of another program, in lines that begin with the file and the place.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The file, as it was named.
    pub file: String,
    /// The name of its format.
    pub format: &'static str,
    /// Changes by a file of materials, one a line.
    pub replaced: Vec<String>,
    /// Parts that were left out, one a line.
    pub notes: Vec<String>,
    /// Repairs to the file, one a line.
    pub repairs: Vec<String>,
}

impl Imported {
    /// All lines of the record: changes of materials, parts left out, repairs.
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
