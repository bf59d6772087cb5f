//! The messages in the sources that hold a cure.

use std::path::{Path, PathBuf};

use super::literals::{Token, tokens};

/// Functions that take a cause and a cure, or words of which a message is made.
const MAKERS: [&str; 22] = [
    "refuse",
    "refuse_at",
    "new",
    "foreign",
    "conflict",
    "absent",
    "unknown_or",
    "unknown",
    "unknown_name",
    "bad_extent",
    "bad_opening",
    "no_direction",
    "missing_key",
    "cured",
    "words",
    "refusal",
    "fault",
    "bad_picture",
    "wrong_type",
    "refused",
    "of_kind",
    "error",
];

/// Types whose `new` takes a cause and a cure.
const TYPES: [&str; 2] = ["Refusal", "Fault"];

/// Letters and signs from which on a text is taken for words of a message.
const LEAST: usize = 8;

/// Texts that stand in one message, or one of several texts of a choice.
#[derive(Debug)]
pub(super) struct Stated {
    /// File and line.
    pub(super) place: String,
    pub(super) texts: Vec<String>,
}

/// The parts of a text outside of braces, whose content messages fill in.
fn fixed_parts(text: &str) -> Vec<String> {
    let plain = text.replace("{{", "\u{1}").replace("}}", "\u{2}");
    let mut parts = vec![String::new()];
    let mut is_filled = false;
    for sign in plain.chars() {
        match sign {
            '{' => is_filled = true,
            '}' => {
                is_filled = false;
                parts.push(String::new());
            }
            _ if is_filled => {}
            _ => parts.last_mut().expect("there is one").push(sign),
        }
    }
    parts.iter().map(|part| part.replace('\u{1}', "{").replace('\u{2}', "}")).collect()
}

fn is_of_message(text: &str) -> bool {
    let fixed: String = fixed_parts(text).concat();
    text.contains(' ') && fixed.trim().chars().count() >= LEAST
}

/// Whether the fixed parts of a text stand in a message, one behind the other.
fn stand_in(parts: &[String], message: &str) -> bool {
    let mut rest = message;
    parts.iter().all(|part| match rest.split_once(part.as_str()) {
        Some((_, after)) => {
            rest = after;
            true
        }
        None => false,
    })
}

impl Stated {
    /// Whether all its texts stand in one of the messages.
    pub(super) fn stands_in(&self, messages: &[impl AsRef<str>]) -> bool {
        let texts: Vec<Vec<String>> = self.texts.iter().map(|text| fixed_parts(text)).collect();
        let holds = |message: &str| texts.iter().all(|parts| stand_in(parts, message));
        messages.iter().any(|message| holds(message.as_ref()))
    }
}

/// The end of what the bracket at `open` opens.
fn closing(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0;
    for (place, token) in tokens.iter().enumerate().skip(open) {
        if "([{".chars().any(|sign| token.is_sign(sign)) {
            depth += 1;
        } else if ")]}".chars().any(|sign| token.is_sign(sign)) {
            depth -= 1;
            if depth == 0 {
                return place;
            }
        }
    }
    tokens.len()
}

/// The texts of messages in these tokens, as those of one message unless they are a choice.
fn stated(place: &dyn Fn(usize) -> String, tokens: &[Token]) -> Vec<Stated> {
    let texts = tokens.iter().filter(|token| token.text().is_some_and(is_of_message));
    let owned = |token: &Token| token.text().unwrap_or_default().to_owned();
    let is_choice = tokens.iter().filter_map(Token::word).any(|word| ["match", "if", "let"].contains(&word));
    if is_choice {
        return texts.map(|token| Stated { place: place(token.line), texts: vec![owned(token)] }).collect();
    }
    let texts: Vec<&Token> = texts.collect();
    let first = texts.first().map(|token| token.line);
    first
        .map(|line| Stated { place: place(line), texts: texts.into_iter().map(owned).collect() })
        .into_iter()
        .collect()
}

/// The messages of a source.
fn of_source(path: &Path, source: &str) -> Vec<Stated> {
    let source = source.split("#[cfg(test)]").next().unwrap_or_default();
    let tokens = tokens(source);
    let place = |line: usize| format!("{}:{line}", path.display());
    let word = |at: usize| tokens.get(at).and_then(Token::word).unwrap_or_default();
    let is_sign = |at: usize, sign: char| tokens.get(at).is_some_and(|token| token.is_sign(sign));
    let mut all = Vec::new();
    for at in 0..tokens.len() {
        let before = at.checked_sub(1);
        let is_defined = before.is_some_and(|before| word(before) == "fn" || is_sign(before, '['));
        let of_type = at.checked_sub(3).map(word).unwrap_or_default();
        if MAKERS.contains(&word(at)) && is_sign(at + 1, '(') && !is_defined {
            if word(at) != "new" || TYPES.contains(&of_type) {
                all.extend(stated(&place, &tokens[at + 2..closing(&tokens, at + 1)]));
            }
        } else if word(at) == "fn" && word(at + 1).contains("cure") {
            let body = (at..tokens.len()).find(|place| is_sign(*place, '{') || is_sign(*place, ';'));
            if let Some(open) = body.filter(|open| is_sign(*open, '{')) {
                all.extend(each(&place, &tokens[open..closing(&tokens, open)]));
            }
        } else if word(at) == "let" || word(at) == "const" {
            let equals = (at..tokens.len()).find(|place| is_sign(*place, '=') || is_sign(*place, ';'));
            let Some(equals) = equals.filter(|equals| is_sign(*equals, '=')) else { continue };
            let names = tokens[at..equals].iter().filter_map(Token::word);
            if names.map(str::to_lowercase).any(|name| name.contains("cure")) {
                all.extend(each(&place, &tokens[equals..end_of_statement(&tokens, equals)]));
            }
        }
    }
    all
}

/// Each text of these tokens by itself.
fn each(place: &dyn Fn(usize) -> String, tokens: &[Token]) -> Vec<Stated> {
    let texts = tokens.iter().filter(|token| token.text().is_some_and(is_of_message));
    texts
        .map(|token| Stated {
            place: place(token.line),
            texts: vec![token.text().unwrap_or_default().to_owned()],
        })
        .collect()
}

/// The semicolon that ends the statement of which `at` is a token, or the bracket around it.
fn end_of_statement(tokens: &[Token], at: usize) -> usize {
    let mut place = at;
    while place < tokens.len() {
        let token = &tokens[place];
        if "([{".chars().any(|sign| token.is_sign(sign)) {
            place = closing(tokens, place) + 1;
        } else if ";)]}".chars().any(|sign| token.is_sign(sign)) {
            return place;
        } else {
            place += 1;
        }
    }
    tokens.len()
}

/// The messages with cures of all sources of the library and of the command.
pub(super) fn all() -> Vec<Stated> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut open: Vec<PathBuf> = vec![root.join("crates"), root.join("src")];
    let mut sources = Vec::new();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).expect("it can be read") {
            let path = entry.expect("an entry").path();
            match path.is_dir() {
                true if path.ends_with("tests") || path.ends_with("target") => {}
                true => open.push(path),
                false => sources.push(path),
            }
        }
    }
    sources.retain(|path| path.extension().is_some_and(|ending| ending == "rs"));
    sources.sort();
    assert!(sources.len() > 500, "{} sources", sources.len());
    let of_file = |path: &PathBuf| {
        let source = std::fs::read_to_string(path).expect("a source");
        of_source(path.strip_prefix(root).expect("it is below"), &source)
    };
    sources.iter().flat_map(of_file).collect()
}

#[test]
fn messages_are_found_by_their_makers() {
    let source = "fn a() { refuse(format!(\"it is {x} and no\"), \"write another one\") }\n\
                  fn cure(self) { match self { A => \"take this one\", B => \"take that one\" } }\n\
                  fn b() { let cure = \"leave it out\"; Vec::new(\"nothing of it\") }\n\
                  #[error(\"nothing of this\")] const CURE: &str = \"correct it all\";";
    let found: Vec<Vec<String>> =
        of_source(Path::new("a.rs"), source).into_iter().map(|own| own.texts).collect();
    let expected = [
        vec!["it is {x} and no", "write another one"],
        vec!["take this one"],
        vec!["take that one"],
        vec!["leave it out"],
        vec!["correct it all"],
    ];
    assert_eq!(found, expected);
    let stated = Stated { place: String::new(), texts: vec!["it is {x} and no".to_owned()] };
    assert!(stated.stands_in(&["error: it is 3 and no"]) && !stated.stands_in(&["error: it is 3"]));
}
