//! The marks of a document, and the commands above them.

use std::ops::Range;

use crate::documents::stamp::{Stamp, is_stamp};

const OUTPUT: &str = "<!-- output";
const SHOWN: &str = "shown";
const ONCE: &str = "once";
const PART: &str = "; a part: ";
const RUN: &str = "<!-- run -->";
const DRAWN: &str = "<!-- drawn -->";
const FILE: &str = "<!-- file ";
const CLOSED: &str = " -->";
const END: &str = "<!-- end -->";

/// A mark, and what it asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The nearest command above it.
    pub command: String,
    /// Its kind, with what that needs.
    pub kind: Kind,
}

/// Kinds of marks, by what they ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// The command is run for the files it writes.
    Run,
    /// It is run where pages are written.
    Drawn,
    /// The reader writes a file.
    File {
        /// Its name.
        name: String,
        /// Its text.
        text: String,
    },
    /// Its output stands here.
    Output(Place),
}

/// Where the output of a command stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The text that stands there, without its stamp.
    pub there: String,
    /// A command that prints a part of it soon.
    pub part: Option<String>,
    /// Whether it is made only where its command is named: it takes long, or what it needs is not here.
    pub is_once: bool,
    is_shown: bool,
    /// Lines between the marks.
    lines: Range<usize>,
}

/// The steps of a document, in order.
///
/// # Errors
/// A mark without an end, or without a command above it.
pub fn steps(text: &str) -> Result<Vec<Step>, String> {
    let lines: Vec<&str> = text.lines().collect();
    let (mut steps, mut command) = (Vec::new(), None);
    for (k, line) in lines.iter().enumerate() {
        command = last_command(line).or(command);
        let mark = line.trim();
        let fault = |what: &str| format!("line {}: {mark} has no {what}", k + 1);
        let kind = if let Some(words) = mark.strip_prefix(OUTPUT) {
            Kind::Output(place(&lines, k + 1, words).ok_or_else(|| fault("end"))?)
        } else if let Some(name) = mark.strip_prefix(FILE).and_then(|rest| rest.strip_suffix(CLOSED)) {
            Kind::File { name: name.to_owned(), text: block(&lines[k..]) }
        } else if mark == RUN {
            Kind::Run
        } else if mark == DRAWN {
            Kind::Drawn
        } else {
            continue;
        };
        let command = match kind {
            Kind::File { .. } => command.clone().unwrap_or_default(),
            _ => command.clone().ok_or_else(|| fault("command above it"))?,
        };
        steps.push(Step { command, kind });
    }
    Ok(steps)
}

/// The place behind a mark with these words.
fn place(lines: &[&str], first: usize, words: &str) -> Option<Place> {
    // An end behind another mark belongs to that.
    let is_mark = |line: &&str| line.trim() == END || line.trim().starts_with(OUTPUT);
    let last = first + lines[first..].iter().position(is_mark)?;
    if lines[last].trim() != END {
        return None;
    }
    let words = words.strip_suffix(CLOSED)?;
    let (words, part) = words.split_once(PART).map_or((words, None), |(words, part)| (words, Some(part)));
    let says = |word: &str| words.split([',', ' ']).any(|own| own == word);
    let there: Vec<&str> = lines[first..last].iter().filter(|line| !is_stamp(line)).copied().collect();
    Some(Place {
        there: there.join("\n"),
        part: part.map(str::to_owned),
        is_once: says(ONCE),
        is_shown: says(SHOWN),
        lines: first..last,
    })
}

/// The text of the next block between fences.
fn block(lines: &[&str]) -> String {
    let inside = lines.iter().skip_while(|line| !line.starts_with("```")).skip(1);
    inside.take_while(|line| !line.starts_with("```")).map(|line| format!("{line}\n")).collect()
}

/// The last command that a line names.
pub fn last_command(line: &str) -> Option<String> {
    let is_command = |text: &&str| text.starts_with("cargo ") || text.starts_with("radiosity ");
    let quoted = line.split('`').skip(1).step_by(2).filter(is_command).last();
    let alone = line.strip_prefix("    ").filter(is_command);
    quoted.or(alone).map(|command| command.split("  #").next().unwrap_or(command).trim().to_owned())
}

/// The document with this output in a place, and its stamp below where there is one.
pub fn with_output(text: &str, place: &Place, output: &str, stamp: Option<&Stamp>) -> String {
    let blanks = if place.is_shown { "    " } else { "" };
    let mut fresh = vec![String::new()];
    fresh.extend(output.trim_end().lines().map(|line| format!("{blanks}{line}").trim_end().to_owned()));
    fresh.extend(stamp.iter().flat_map(|stamp| [String::new(), stamp.to_string()]));
    fresh.push(String::new());
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines.splice(place.lines.clone(), fresh);
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// A document whose outputs are all made in one run, with the stamp of that on its line.
pub fn with_stamp(text: &str, stamp: &Stamp) -> String {
    text.lines().map(|line| if is_stamp(line) { format!("{stamp}\n") } else { format!("{line}\n") }).collect()
}
