//! Ten thousand broken files for all readers: each is read or refused, within five seconds and a gigabyte, and
//! without a look outside the folder of the scene.
//!
//! `cargo run --release -p radiosity-studies --bin mutations` runs all readers, each in a process of its own;
//! `mutations READER CASES` one of them. The seed is fixed. A file that takes too long is left where the
//! message says.

#![expect(clippy::print_stdout, reason = "a table for people")]
#![expect(clippy::print_stderr, reason = "the file that took too long")]

use std::cell::Cell;
use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, exit};
use std::sync::Mutex;
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

use radiosity_studies::memory::most_memory;
use radiosity_test_support::mutations::break_often;
use radiosity_test_support::readers::{Reader, ReaderAtWork, WORDS};

/// Broken files of each reader.
const CASES: u32 = 500;
/// Longest time of a file.
const LONGEST: Duration = Duration::from_secs(5);
/// Most memory of a process (MB).
const MOST_MEMORY: f64 = 1000.0;

/// When the reading of the present file began.
static BEGUN: Mutex<Option<Instant>> = Mutex::new(None);

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match &words[..] {
        [] => all(),
        [name, cases] => {
            let reader = Reader::ALL.into_iter().find(|reader| reader.file() == name);
            one(reader.ok_or_else(|| format!("'{name}' is unknown"))?, cases.parse()?);
            Ok(())
        }
        _ => Err("give READER and CASES, or nothing".into()),
    }
}

fn all() -> Result<(), Box<dyn Error>> {
    println!("| file | broken | read | s at most | MB at most |\n|---|---|---|---|---|");
    let mut failed = Vec::new();
    for reader in Reader::ALL {
        let status =
            Command::new(std::env::current_exe()?).args([reader.file(), &CASES.to_string()]).status()?;
        if !status.success() {
            failed.push(reader.file());
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(format!("failed: {}", failed.join(", ")).into()) }
}

fn one(reader: Reader, cases: u32) {
    let at_work = ReaderAtWork::new(reader);
    assert!(at_work.read(&at_work.whole), "{} is right", reader.file());
    watch(at_work.path());
    let (read, longest) = (Cell::new(0), Cell::new(Duration::ZERO));
    break_often(cases, &at_work.whole, &WORDS, |bytes| {
        let begun = Instant::now();
        *BEGUN.lock().expect("nobody panics") = Some(begun);
        read.set(read.get() + u32::from(at_work.read(bytes)));
        *BEGUN.lock().expect("nobody panics") = None;
        longest.set(longest.get().max(begun.elapsed()));
        assert!(most_memory() < MOST_MEMORY, "it took {} MB", most_memory());
    });
    let (read, longest) = (read.get(), longest.get().as_secs_f64());
    println!("| {} | {cases} | {read} | {longest:.3} | {:.0} |", reader.file(), most_memory());
}

/// Ends the process when a file takes too long.
fn watch(path: PathBuf) {
    spawn(move || {
        loop {
            sleep(Duration::from_millis(100));
            let begun = *BEGUN.lock().expect("nobody panics");
            if begun.is_some_and(|begun| begun.elapsed() > LONGEST) {
                eprintln!("{} takes too long", path.display());
                exit(1);
            }
        }
    });
}
