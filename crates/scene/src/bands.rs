//! The names of bands.

use crate::{error::Fault, names::UniqueNames, place::Line};

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
        0 => {
            let expected = "at least one name".to_owned();
            Err((0, Fault::WrongCount { what: "the list of bands", expected, found: 0 }))
        }
        _ => Ok(()),
    }
}
