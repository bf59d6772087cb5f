//! Every message with a cure is a row of a table, or is named with the reason for which it is none.

use std::sync::LazyLock;

use super::drawn;
use super::messages::{self, Stated};
use super::untried::UNTRIED;

/// All that the rows of the tables draw, one blank between words.
static TOLD: LazyLock<Vec<String>> = LazyLock::new(|| {
    let text = |output: &std::process::Output| {
        one_line(&(String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr)))
    };
    drawn::all().map(text).collect()
});

/// The messages with cures of all sources.
static MESSAGES: LazyLock<Vec<Stated>> = LazyLock::new(messages::all);

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn is_told(stated: &Stated) -> bool {
    stated.stands_in(&TOLD)
}

#[test]
fn every_message_with_a_cure_is_a_row_or_is_named() {
    let all = &*MESSAGES;
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
    let all = &*MESSAGES;
    for untried in UNTRIED {
        let found: Vec<&Stated> = all.iter().filter(|own| untried.names(own)).collect();
        assert!(!found.is_empty(), "{:?} is in no message", untried.words);
        assert!(!found.iter().all(|own| is_told(own)), "{:?} is told by a row", untried.words);
    }
}
