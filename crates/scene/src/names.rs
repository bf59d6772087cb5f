//! Names of bands, materials, planes and surfaces: none is blank, and each is given once.

use std::collections::BTreeMap;

use crate::{fault::Fault, place::Line};

/// Refuses a blank text.
pub fn check_text(text: &str) -> Result<(), Fault> {
    if text.trim().is_empty() { Err(Fault::empty_text()) } else { Ok(()) }
}

/// Names seen so far, each with its line where it stands in a file.
#[derive(Default)]
pub struct UniqueNames(BTreeMap<String, Option<Line>>);

impl UniqueNames {
    /// Adds a name; refuses one that was added before.
    pub fn add(&mut self, name: &str, line: Option<Line>) -> Result<(), Fault> {
        check_text(name)?;
        match self.0.insert(name.to_owned(), line) {
            None => Ok(()),
            Some(first) => Err(Fault::duplicate_name(name, first.as_ref())),
        }
    }
}
