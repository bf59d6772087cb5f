//! Every message with a cure is a row of a table, or is named with the reason for which it is none.

use std::sync::LazyLock;

use super::messages::{self, Stated};
use super::untried::UNTRIED;
use super::workplace::typed;
use super::{commands, files, runs, scenes, warnings, workplace};
use crate::program::radiosity;
use radiosity_test_support::folders::folder;

/// All that the rows of the tables draw, one blank between words.
static TOLD: LazyLock<Vec<String>> = LazyLock::new(|| {
    let room = |text: String| {
        let folder = folder(&[("room.toml", text)]);
        radiosity(folder.path(), &["check", "room.toml"])
    };
    let rows = scenes::ROWS.iter().copied().flatten().chain(warnings::ROWS);
    let of_scenes = rows.map(|row| room(row.with(row.bad)));
    let of_files = files::CHANGED.iter().flat_map(|file| file.rows.iter().map(|row| file.refused(row)));
    let place = workplace::files();
    let lines = commands::ROWS.iter().copied().flatten().chain(runs::ROWS);
    let of_commands = lines.map(|row| typed(place.path(), row.bad));
    let outputs = of_scenes.chain(of_files).chain(of_commands);
    let text = |output: std::process::Output| {
        let both = [output.stdout, output.stderr].concat();
        one_line(&String::from_utf8_lossy(&both))
    };
    outputs.map(text).collect()
});

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn is_told(stated: &Stated) -> bool {
    TOLD.iter().any(|message| stated.stands_in(message))
}

#[test]
fn every_message_with_a_cure_is_a_row_or_is_named() {
    let all = messages::all();
    assert!(all.len() > 500, "{} messages", all.len());
    let is_named = |own: &&Stated| UNTRIED.iter().any(|untried| untried.names(own));
    let missing: Vec<String> = all
        .iter()
        .filter(|own| !is_told(own) && !is_named(own))
        .map(|own| format!("{}: {:?}", own.place, own.texts))
        .collect();
    assert!(missing.is_empty(), "no row draws\n{}", missing.join("\n"));
}

#[test]
fn what_is_named_stands_in_the_sources_and_in_no_row() {
    let all = messages::all();
    for untried in UNTRIED {
        let found: Vec<&Stated> = all.iter().filter(|own| untried.names(own)).collect();
        assert!(!found.is_empty(), "{:?} is in no message", untried.words);
        assert!(!found.iter().all(|own| is_told(own)), "{:?} is told by a row", untried.words);
    }
}
