//! The words of a command line, each one of those that a study knows.

use std::env::args;

/// What was typed, or which word is unknown and what is known.
pub fn words(known: &[&str]) -> Result<Vec<String>, String> {
    let words: Vec<String> = args().skip(1).collect();
    match words.iter().find(|word| !known.contains(&word.as_str())) {
        Some(word) => Err(format!("'{word}' is unknown: choose from {}", known.join(", "))),
        None => Ok(words),
    }
}
