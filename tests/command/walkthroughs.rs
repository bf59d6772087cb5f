//! The README and the pages that lead from nothing to a result: their marked commands are run as they stand,
//! and print what the pages say.
//!
//! `cargo run --release -p radiosity-studies --bin refresh -- PART` writes the page with a command that
//! contains PART.

use std::fs;
use std::path::Path;

use radiosity_test_support::documents::comparison::{Extent, differences};
use radiosity_test_support::documents::shell::{Shell, WALKS};
use radiosity_test_support::documents::steps::{Kind, last_command, steps};

#[test]
fn the_readme_says_what_its_commands_print() {
    follow(WALKS[0]);
}

#[test]
fn a_room_in_lux_is_walked_through() {
    follow(WALKS[1]);
}

#[test]
fn an_enclosure_in_watts_is_walked_through() {
    follow(WALKS[2]);
}

fn follow(page: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let binaries = Path::new(env!("CARGO_BIN_EXE_radiosity")).parent().expect("the binary lies in a folder");
    let text = fs::read_to_string(root.join(page)).expect("the page is there");
    let unmarked: Vec<&str> = unmarked(&text).collect();
    assert!(unmarked.is_empty(), "{page}: commands on lines of their own without a mark: {unmarked:?}");
    let shell = Shell::of_walk(root, binaries).expect("a folder");
    let mut outputs = 0;
    for step in steps(&text).expect("marks are whole") {
        let printed = shell.done(&step, false).unwrap_or_else(|why| panic!("{page}: {why}"));
        let Kind::Output(place) = step.kind else { continue };
        outputs += 1;
        let found = differences(&place.there, &printed, Extent::Whole);
        let found: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert!(found.is_empty(), "{page}: '{}', {}; {}", step.command, found.join("; "), cure());
    }
    assert!(outputs > 0, "{page} has commands");
}

fn cure() -> &'static str {
    "`cargo run --release -p radiosity-studies --bin refresh -- PART` writes the page with a command that contains PART"
}

/// Commands that fill a line, below which no mark stands.
fn unmarked(text: &str) -> impl Iterator<Item = &str> {
    let is_whole = |line: &str| line.starts_with('`') && line.ends_with('`') && last_command(line).is_some();
    let below = text.lines().skip(1).chain([""]);
    let unmarked =
        text.lines().zip(below).filter(move |(line, below)| is_whole(line) && !below.starts_with("<!--"));
    unmarked.map(|(line, _)| line)
}
