//! Headers, the lines before the numbers: edition, labels or keywords, `TILT=`.

use super::edition::Edition;
use crate::error::{Refusal, refuse, refuse_at};
use crate::file_place::FilePlace;
use crate::text::short;

/// The header of a file, and where its numbers begin.
#[derive(Debug)]
pub(super) struct Header<'a> {
    pub(super) edition: Edition,
    /// Keywords without brackets and what stands behind them; plain labels have the keyword `LABEL`.
    pub(super) keywords: Vec<(String, String)>,
    /// Whether the numbers begin with factors by tilt.
    pub(super) has_tilt_factors: bool,
    /// The text behind the line `TILT=`.
    pub(super) data: &'a str,
    /// Number of the line `TILT=`, from 1.
    pub(super) line: usize,
}

const LABEL: &str = "LABEL";

impl<'a> Header<'a> {
    /// Reads up to the line `TILT=`.
    ///
    /// # Errors
    /// A text without this line, or one that names a file there; an unknown edition.
    pub(super) fn of(text: &'a str) -> Result<Self, Refusal> {
        let (mut edition, mut keywords) = (Edition::Of1986, Vec::new());
        let (mut rest, mut line) = (text, 0);
        while !rest.is_empty() {
            let (current, data) = rest.split_once('\n').unwrap_or((rest, ""));
            (rest, line) = (data, line + 1);
            let place = FilePlace::Line(line);
            if let Some(tilt) = tilt(current) {
                let has_tilt_factors = includes(tilt).map_err(|fault| fault.at(place))?;
                return Ok(Self { edition, keywords, has_tilt_factors, data, line });
            }
            match Edition::of(current).map_err(|fault| fault.at(place))? {
                Some(stated) if keywords.is_empty() => edition = stated,
                _ => keyword(current.trim(), &mut keywords),
            }
        }
        refuse_at(
            FilePlace::Line(line.max(1)),
            "the text ends before a line TILT=",
            "write TILT=NONE before the numbers; if this is an EULUMDAT file, name it .ldt",
        )
    }

    /// Name of the luminaire for people: its description, its catalogue number or the first label.
    pub(super) fn name(&self) -> String {
        let of = |wanted: &str| {
            let found = self.keywords.iter().find(|(keyword, text)| keyword == wanted && !text.is_empty());
            found.map(|(_, text)| text.clone())
        };
        of("LUMINAIRE").or_else(|| of("LUMCAT")).or_else(|| of(LABEL)).unwrap_or_default()
    }
}

/// Text behind `TILT=` in a line; none in other lines.
fn tilt(line: &str) -> Option<&str> {
    let line = line.trim();
    let (word, tilt) = line.split_once('=')?;
    word.trim().eq_ignore_ascii_case("TILT").then(|| tilt.trim())
}

fn includes(tilt: &str) -> Result<bool, Refusal> {
    match tilt.to_ascii_uppercase().as_str() {
        "NONE" => Ok(false),
        "INCLUDE" => Ok(true),
        _ => refuse(
            format!("TILT= names the file '{}'", short(tilt)),
            "write TILT=INCLUDE and the contents of this file behind it, or TILT=NONE where the lamp burns as measured",
        ),
    }
}

fn keyword(line: &str, keywords: &mut Vec<(String, String)>) {
    let bracketed = line.strip_prefix('[').and_then(|rest| rest.split_once(']'));
    match (bracketed, keywords.last_mut()) {
        (Some((word, text)), Some((_, before))) if word.eq_ignore_ascii_case("MORE") => {
            before.push(' ');
            before.push_str(text.trim());
        }
        (Some((word, text)), _) => {
            keywords.push((word.trim().to_ascii_uppercase(), text.trim().to_owned()));
        }
        (None, _) if line.is_empty() => {}
        (None, _) => keywords.push((LABEL.to_owned(), line.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_go_on_in_more_and_labels_stand_alone() {
        let header =
            Header::of("IESNA91\r\n[LUMCAT] A-1\r\n[OTHER] one\r\n[MORE] two\r\nTILT=NONE\r\n1 2\r\n");
        let header = header.expect("it is right");
        assert_eq!(header.name(), "A-1");
        assert_eq!(header.keywords[1], ("OTHER".to_owned(), "one two".to_owned()));
        assert_eq!((header.edition, header.line, header.data), (Edition::Of1991, 5, "1 2\r\n"));
        let header = Header::of("\nA lamp\nof 1987\nTilt = include\n1").expect("it is right");
        assert_eq!((header.name().as_str(), header.edition), ("A lamp", Edition::Of1986));
        assert!(header.has_tilt_factors);
        for (text, cure) in [("IESNA91\n1 2 3", "TILT=NONE"), ("TILT=LAMP.TLT\n1", "TILT=INCLUDE")] {
            assert!(Header::of(text).expect_err(text).cure.contains(cure));
        }
    }
}
