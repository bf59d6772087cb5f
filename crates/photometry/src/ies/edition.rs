//! The editions of LM-63.

use crate::error::{Refusal, refuse};
use crate::text::short;

/// An edition of LM-63, by its year.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Edition {
    Of1986,
    Of1991,
    Of1995,
    Of2002,
    Of2019,
}

impl Edition {
    /// The edition that a first line states; none where it is a label or a keyword.
    ///
    /// # Errors
    /// A line that states one that is not known.
    pub(super) fn of(line: &str) -> Result<Option<Edition>, Refusal> {
        let line = line.trim().to_ascii_uppercase();
        let year = match line.split_once("LM-63-") {
            Some(("IESNA:" | "IES:" | "ANSI/IES:" | "ANSI/IESNA:", year)) => year,
            _ => match line.strip_prefix("IESNA") {
                Some(year) if year.len() == 2 => year,
                _ => return Ok(None),
            },
        };
        match year {
            "86" | "1986" => Ok(Some(Edition::Of1986)),
            "91" | "1991" => Ok(Some(Edition::Of1991)),
            "95" | "1995" => Ok(Some(Edition::Of1995)),
            "02" | "2002" => Ok(Some(Edition::Of2002)),
            "19" | "2019" => Ok(Some(Edition::Of2019)),
            _ => refuse(
                format!("the edition of LM-63 is '{}'", short(year)),
                "write IESNA:LM-63-2002 or the edition that the numbers follow: 1986, 1991, 1995, 2002 or 2019",
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_lines_tell_the_edition() {
        for (line, edition) in [
            ("IESNA91", Some(Edition::Of1991)),
            ("IESNA:LM-63-1995 ", Some(Edition::Of1995)),
            ("iesna:lm-63-2002", Some(Edition::Of2002)),
            ("IES:LM-63-2019", Some(Edition::Of2019)),
            ("[TEST] 12", None),
            ("IESNA luminaire no. 12", None),
        ] {
            assert_eq!(Edition::of(line), Ok(edition), "{line}");
        }
        assert!(Edition::of("IESNA:LM-63-2050").is_err());
    }
}
