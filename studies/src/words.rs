//! The words of a command line, each one of those that a study knows.

use std::env::args;

/// The words that were typed, or a message that names an unknown word and all known ones.
pub fn words(known: &[&str]) -> Result<Vec<String>, String> {
    let words: Vec<String> = args().skip(1).collect();
    match words.iter().find(|word| !known.contains(&word.as_str())) {
        Some(word) => Err(format!("'{word}' is unknown: choose from {}", known.join(", "))),
        None => Ok(words),
    }
}
