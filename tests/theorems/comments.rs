//! Comments are read: no line of them is wider than 120 columns, and documentation opens with its subject.

use crate::sources::texts;

/// Widest line of a comment, in characters; text is written to 110, and rows of tables may stand out.
const WIDEST: usize = 120;

/// Openings that point elsewhere, or ask, where a noun is wanted.
const OPENINGS: [&str; 5] = ["The same", "That of", "Those of", "One that", "What "];

fn is_too_wide(line: &str) -> bool {
    line.trim_start().starts_with("//") && line.chars().count() > WIDEST
}

/// Numbers, from 0, of the lines with which documentation opens badly.
fn bad_openings(text: &str) -> Vec<usize> {
    let mut bad = Vec::new();
    let mut before = "";
    for (number, line) in text.lines().map(str::trim_start).enumerate() {
        let words = line.strip_prefix("/// ").or(line.strip_prefix("//! "));
        let is_first = !before.starts_with("///") && !before.starts_with("//!");
        if is_first && words.is_some_and(|words| OPENINGS.iter().any(|opening| words.starts_with(opening))) {
            bad.push(number);
        }
        before = line;
    }
    bad
}

/// Lines of all sources that `faults` finds in their texts, by name and number.
fn found(faults: impl Fn(&str) -> Vec<usize>) -> Vec<String> {
    let texts = texts();
    assert!(texts.len() > 900, "{} sources", texts.len());
    let named = |(path, text): &(std::path::PathBuf, String)| {
        let lines = faults(text).into_iter().map(|number| format!("{}:{}", path.display(), number + 1));
        lines.collect::<Vec<_>>()
    };
    texts.iter().flat_map(named).collect()
}

#[test]
fn lines_of_comments_are_not_too_wide() {
    let wide =
        |text: &str| (0..).zip(text.lines()).filter(|(_, line)| is_too_wide(line)).map(|(k, _)| k).collect();
    assert_eq!(found(wide), [""; 0]);
}

#[test]
fn documentation_opens_with_its_subject() {
    assert_eq!(found(bad_openings), [""; 0]);
}

#[test]
fn faults_of_comments_are_seen() {
    assert!(
        is_too_wide(&format!("// {}", "π".repeat(118))) && !is_too_wide(&format!("// {}", "π".repeat(117)))
    );
    assert_eq!(bad_openings("/// Area in m².\n/// The same.\nfn f() {}\n\n    /// Those of others.\n"), [4]);
}
