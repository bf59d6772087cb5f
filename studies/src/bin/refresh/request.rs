//! The words of the command line.

use radiosity_test_support::documents::comparison::Extent;
use radiosity_test_support::documents::steps::{Kind, Step};

/// Whether places are written or compared.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Mode {
    /// All that is printed is written.
    Write,
    /// It is compared.
    Check,
    /// Parts that take little time are.
    CheckParts,
}

/// All that is asked for.
pub(crate) struct Request {
    pub(crate) mode: Mode,
    /// A part of the commands that are run, or their end where `$` follows.
    part: String,
}

impl Request {
    pub(crate) fn of(words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut request = Self { mode: Mode::Write, part: String::new() };
        for word in words {
            match word.as_str() {
                "--check" if request.mode == Mode::Write => request.mode = Mode::Check,
                "--parts" if request.mode == Mode::Check => request.mode = Mode::CheckParts,
                _ if word.starts_with("--") || !request.part.is_empty() => {
                    return Err(format!("'{word}' is unknown: say [--check [--parts]] [PART OF A COMMAND]"));
                }
                _ => request.part = word,
            }
        }
        Ok(request)
    }

    /// The step as it is done, if it is wanted.
    pub(crate) fn wanted(&self, step: Step) -> Option<Step> {
        let is_once = matches!(&step.kind, Kind::Output(place) if place.is_once);
        let is_wanted = match self.part.strip_suffix('$') {
            Some(end) => step.command.ends_with(end),
            None => step.command.contains(&self.part) && !(is_once && self.part.is_empty()),
        };
        match (self.mode, step) {
            (Mode::CheckParts, Step { kind: Kind::Output(place), .. }) => {
                let command = place.part.clone().filter(|_| is_wanted)?;
                Some(Step { command, kind: Kind::Output(place) })
            }
            (Mode::Check, step @ Step { kind: Kind::Output(_), .. }) | (Mode::Write, step) if is_wanted => {
                Some(step)
            }
            _ => None,
        }
    }

    pub(crate) fn extent(&self) -> Extent {
        if self.mode == Mode::CheckParts { Extent::Part } else { Extent::Whole }
    }
}
