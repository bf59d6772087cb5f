//! Makes the figures, tables and outputs of the documents anew, or compares them, each by the command that
//! the text names.
//!
//! `cargo run --release -p radiosity-studies --bin refresh -- [--check [--parts]] [PART OF A COMMAND]` goes
//! through the documents with marks (`tests/support/src/documents.rs` says which marks there are):
//! docs/measured.md and benches/README.md, about an hour for all commands, and README.md, docs/room.md and
//! docs/enclosure.md, each of which is made as a whole. Every place, or page, gets the commit, the day and
//! the machine.
//!
//! `--check` writes nothing: it compares what is printed with what stands there, cell by cell, names what
//! differs, and fails if anything does. Counts and words have to be equal, other numbers to agree to a unit
//! of their last digit. Numbers before a unit of time, columns whose names end with one, and columns at the
//! right (`---:`) depend on the machine and never differ. With `--parts` only the commands run that a mark
//! gives for a part of its rows.
//!
//! A command that fails leaves its place as it was. Commands run one after another, in the current folder,
//! which has to be the root of the repository; a document is written after each.

#![expect(clippy::print_stderr, reason = "progress for people")]

mod machine;
mod request;

use std::error::Error;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;
use std::{env, fs};

use radiosity_test_support::documents::comparison::{Extent, differences};
use radiosity_test_support::documents::quotes::renewed;
use radiosity_test_support::documents::shell::{QUOTING, Shell, TABLES, WALKS};
use radiosity_test_support::documents::stamp::Stamp;
use radiosity_test_support::documents::steps::{Kind, Step, steps, with_output, with_stamp};

use request::{Mode, Request};

/// A failure, in words.
type Fault = Box<dyn Error>;

fn main() -> Result<ExitCode, Fault> {
    let request = Request::of(env::args().skip(1))?;
    // None where nothing is written.
    let stamp = if request.mode == Mode::Write { Some(machine::stamp()?) } else { None };
    let mut wrong = Vec::new();
    for document in TABLES {
        tables(document, &request, stamp.as_ref(), &mut wrong)?;
    }
    for document in WALKS {
        walk(document, &request, stamp.as_ref(), &mut wrong)?;
    }
    if stamp.is_some() {
        quotes(&mut wrong)?;
    }
    wrong.iter().for_each(|why| eprintln!("{why}"));
    Ok(if wrong.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Makes or checks the places of a document that are wanted, each by itself.
fn tables(
    document: &str,
    request: &Request,
    stamp: Option<&Stamp>,
    wrong: &mut Vec<String>,
) -> Result<(), Fault> {
    let shell = Shell::at(Path::new("."));
    for k in 0..steps(&fs::read_to_string(document)?)?.len() {
        let step = steps(&fs::read_to_string(document)?)?.swap_remove(k);
        let Some(step) = request.wanted(step) else { continue };
        match timed(&step.command, || shell.done(&step, true)) {
            Err(why) => wrong.push(why),
            Ok(fresh) if stamp.is_none() => {
                compare(document, &step, &fresh, request.extent(), wrong);
            }
            Ok(fresh) => {
                // Read again: the document may have changed while the command ran.
                let text = fs::read_to_string(document)?;
                let same = steps(&text)?.into_iter().nth(k).filter(|now| now.command == step.command);
                let Some(Kind::Output(place)) = same.map(|now| now.kind) else { continue };
                if fresh.trim().is_empty() {
                    wrong.push(format!("'{}' prints nothing", step.command));
                } else {
                    fs::write(document, with_output(&text, &place, &fresh, stamp))?;
                }
            }
        }
    }
    Ok(())
}

/// Makes or checks a page whose commands follow each other, where any of them is wanted.
fn walk(
    document: &str,
    request: &Request,
    stamp: Option<&Stamp>,
    wrong: &mut Vec<String>,
) -> Result<(), Fault> {
    let mut text = fs::read_to_string(document)?;
    let count = steps(&text)?.len();
    if !steps(&text)?.into_iter().any(|step| request.wanted(step).is_some()) {
        return Ok(());
    }
    let root = env::current_dir()?;
    let shell = Shell::of_walk(&root, &machine::binaries()?)?;
    for k in 0..count {
        let step = steps(&text)?.swap_remove(k);
        let told = if let Kind::File { name, .. } = &step.kind { name } else { &step.command };
        match (timed(told, || shell.done(&step, stamp.is_some())), &step.kind) {
            (Err(why), _) => {
                wrong.push(why);
                return Ok(());
            }
            (Ok(fresh), Kind::Output(place)) if stamp.is_some() => {
                text = with_output(&text, place, &fresh, None)
            }
            (Ok(fresh), _) => compare(document, &step, &fresh, Extent::Whole, wrong),
        }
    }
    if let Some(stamp) = stamp {
        fs::write(document, with_stamp(&text, stamp))?;
        for (name, file) in shell.pictures(&text) {
            fs::copy(file, Path::new(document).with_file_name(name))?;
        }
    }
    Ok(())
}

/// Adds what is different from what stands at a step's place.
fn compare(document: &str, step: &Step, fresh: &str, extent: Extent, wrong: &mut Vec<String>) {
    let Kind::Output(place) = &step.kind else { return };
    if fresh.trim().is_empty() {
        wrong.push(format!("'{}' prints nothing", step.command));
    }
    let found = differences(&place.there, fresh, extent);
    wrong.extend(found.iter().map(|difference| format!("{document}, '{}', {difference}", step.command)));
}

/// Writes the numbers that texts repeat from tables.
fn quotes(wrong: &mut Vec<String>) -> Result<(), Fault> {
    let texts = TABLES
        .iter()
        .chain(&WALKS)
        .chain(&QUOTING)
        .map(|document| Ok((*document, fs::read_to_string(document)?)));
    let texts: Vec<(&str, String)> = texts.collect::<Result<_, Fault>>()?;
    let tables = texts.iter().map(|(_, text)| steps(text)).collect::<Result<Vec<_>, _>>()?.concat();
    for (document, text) in &texts {
        let fresh = renewed(text, &tables);
        wrong.extend(fresh.faults.iter().map(|why| format!("{document}: {why}")));
        if fresh.text != *text {
            fs::write(document, fresh.text)?;
        }
    }
    Ok(())
}

/// The result of some work, whose command and time are told.
fn timed<T>(command: &str, work: impl FnOnce() -> T) -> T {
    eprintln!("{command}");
    let start = Instant::now();
    let result = work();
    eprintln!("    {:.1} s", start.elapsed().as_secs_f64());
    result
}

/// The line that a program prints.
fn line_of(program: &str, words: &[&str]) -> Result<String, Fault> {
    let ran = Command::new(program).args(words).output()?;
    if !ran.status.success() {
        return Err(format!("'{program} {}' fails", words.join(" ")).into());
    }
    Ok(String::from_utf8(ran.stdout)?.trim().to_owned())
}
