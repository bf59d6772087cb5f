//! Names of bands, materials, planes and surfaces: none is blank, each can be printed, and each is given once.

use std::collections::BTreeMap;

use radiosity_work::printable::is_printable;

use crate::{fault::Fault, place::Line};

/// Refuses a blank text.
pub fn check_text(text: &str) -> Result<(), Fault> {
    if text.trim().is_empty() { Err(Fault::empty_text()) } else { Ok(()) }
}

/// Refuses a blank name, and one that would command a terminal or forge lines of a table.
pub fn check_name(name: &str) -> Result<(), Fault> {
    check_text(name)?;
    if name.chars().all(is_printable) { Ok(()) } else { Err(Fault::unprintable(name)) }
}

/// Names seen so far, each with its line where it stands in a file.
#[derive(Default)]
pub struct UniqueNames(BTreeMap<String, Option<Line>>);

impl UniqueNames {
    /// Adds a name; refuses one that was added before.
    pub fn add(&mut self, name: &str, line: Option<Line>) -> Result<(), Fault> {
        check_name(name)?;
        match self.0.insert(name.to_owned(), line) {
            None => Ok(()),
            Some(first) => Err(Fault::duplicate_name(name, first.as_ref())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::FaultKind;

    #[test]
    fn names_are_on_one_line_and_command_no_terminal() {
        for name in ["Tür 'Süd'", "光", "a \"b\" \\"] {
            assert!(check_name(name).is_ok(), "{name}");
        }
        for name in ["", " ", "a\nb", "a\u{1b}[2J", "a\u{202e}b"] {
            let kind = check_name(name).map_err(|fault| fault.kind);
            assert_eq!(kind, Err(FaultKind::BadText), "{name:?}");
        }
    }
}
