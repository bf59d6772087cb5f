//! The names of bands.

use crate::{fault::Fault, names::UniqueNames, place::Line};

/// Checks the names of bands, each given with its line in a file; an error has the index of the name.
pub fn check_bands<'a>(
    names: impl IntoIterator<Item = (&'a str, Option<Line>)>,
) -> Result<(), (usize, Fault)> {
    let mut unique = UniqueNames::default();
    let mut count = 0;
    for (name, line) in names {
        unique.add(name, line).map_err(|fault| (count, fault))?;
        count += 1;
    }
    match count {
        0 => Err((0, Fault::wrong_count("the list of bands", "at least one name", 0))),
        _ => Ok(()),
    }
}
