//! Makes the figures, tables and outputs of the documents anew, each by the command that the text names.
//!
//! `cargo run --release -p radiosity-studies --bin refresh -- [PART OF A COMMAND]` goes through
//! docs/measured.md and benches/README.md, about an hour for all commands. What is made anew stands between
//! two marks, and is what the nearest command above it prints on its standard output:
//!
//! ```text
//! … Error against time: `cargo run --release -p radiosity-studies --bin read_off`.
//! <!-- output -->
//! | … |
//! <!-- end -->
//! ```
//!
//! A command stands in back-quotes, or alone in an indented line, and begins with `cargo`.
//! `<!-- output, shown -->` indents what is printed by four blanks, so that it stays as it is;
//! `<!-- run -->`, without an end, runs the command for the files it writes. A command that fails leaves its
//! place as it was. Commands run one after another, in the current folder, which has to be the root of the
//! repository; a document is written after each.

#![expect(clippy::print_stderr, reason = "progress for people")]

use std::io::{Error, Result};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;
use std::{env, fs};

/// Documents that hold output of commands; the README is written by `tests/command/walkthroughs.rs`.
const DOCUMENTS: [&str; 2] = ["docs/measured.md", "benches/README.md"];

const RUN: &str = "<!-- run -->";
const OUTPUT: &str = "<!-- output -->";
const SHOWN: &str = "<!-- output, shown -->";
const END: &str = "<!-- end -->";

/// A place between marks, and the command above them.
struct Place {
    command: String,
    shown: bool,
    /// Lines between the marks, from the first on and before the last; None where nothing is pasted.
    between: Option<[usize; 2]>,
}

fn main() -> Result<ExitCode> {
    let part = env::args().nth(1).unwrap_or_default();
    let mut failed = Vec::new();
    for document in DOCUMENTS {
        for k in 0..places(&fs::read_to_string(document)?)?.len() {
            // Read again: the last command may have changed the document itself.
            let text = fs::read_to_string(document)?;
            let place = places(&text)?.swap_remove(k);
            if !place.command.contains(&part) {
                continue;
            }
            match output(&place.command) {
                Ok(fresh) if fresh.trim().is_empty() && place.between.is_some() => {
                    failed.push(format!("'{}' prints nothing", place.command));
                }
                Ok(fresh) => fs::write(document, replaced(&text, &place, &fresh))?,
                Err(why) => failed.push(why),
            }
        }
    }
    failed.iter().for_each(|why| eprintln!("{why}"));
    Ok(if failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn places(text: &str) -> Result<Vec<Place>> {
    let (mut places, mut command) = (Vec::new(), None);
    for (k, line) in text.lines().enumerate() {
        command = last_command(line).or(command);
        let mark = line.trim();
        if ![RUN, OUTPUT, SHOWN].contains(&mark) {
            continue;
        }
        let missing = |what: &str| Error::other(format!("line {}: {mark} has no {what}", k + 1));
        // An end behind another mark belongs to that.
        let mut after = text.lines().skip(k + 1).map(str::trim);
        let end = after.position(|line| [RUN, OUTPUT, SHOWN, END].contains(&line));
        let end = end.filter(|end| text.lines().nth(k + 1 + end).is_some_and(|line| line.trim() == END));
        let between =
            if mark == RUN { None } else { Some([k + 1, k + 1 + end.ok_or_else(|| missing("end"))?]) };
        let command = command.clone().ok_or_else(|| missing("command above it"))?;
        places.push(Place { command, shown: mark == SHOWN, between });
    }
    Ok(places)
}

/// The text with `fresh` in a place.
fn replaced(text: &str, place: &Place, fresh: &str) -> String {
    let Some([first, end]) = place.between else { return text.to_owned() };
    let lines: Vec<&str> = text.lines().collect();
    let blanks = if place.shown { "    " } else { "" };
    let pasted = fresh.trim_end().lines().map(|line| format!("{blanks}{line}"));
    let kept = |lines: &[&str]| lines.iter().map(|line| (*line).to_owned()).collect::<Vec<_>>();
    // Blank lines around, so that tables and code are told from the marks.
    let blank = || std::iter::once(String::new());
    let all = kept(&lines[..first])
        .into_iter()
        .chain(blank())
        .chain(pasted)
        .chain(blank())
        .chain(kept(&lines[end..]));
    all.map(|line| line.trim_end().to_owned() + "\n").collect()
}

/// The last command that a line of a document names.
fn last_command(line: &str) -> Option<String> {
    let quoted = line.split('`').skip(1).step_by(2).filter(|part| part.starts_with("cargo ")).last();
    let alone = line.strip_prefix("    ").filter(|line| line.starts_with("cargo "));
    quoted.or(alone).map(|command| command.split("  #").next().unwrap_or(command).trim().to_owned())
}

/// Output of a command; its errors go to the terminal.
fn output(command: &str) -> std::result::Result<String, String> {
    eprintln!("{command}");
    let start = Instant::now();
    let ran = Command::new("bash").args(["-o", "pipefail", "-c", command]).stderr(Stdio::inherit()).output();
    let done = ran.map_err(|why| format!("'{command}' could not be run: {why}"))?;
    eprintln!("    {:.1} s", start.elapsed().as_secs_f64());
    if !done.status.success() {
        return Err(format!("'{command}' failed: {}", done.status));
    }
    String::from_utf8(done.stdout).map_err(|_| format!("what '{command}' prints is no text"))
}
