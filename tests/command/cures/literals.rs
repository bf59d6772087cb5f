//! Texts that stand in sources: a lexer of as much of Rust as tells them from all else.

/// A token of a source, with the line that it stands in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) kind: Kind,
    /// From 1.
    pub(super) line: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A word: a keyword, a name, or a number.
    Word(String),
    /// The text of a string, its escapes taken.
    Text(String),
    /// Any other sign.
    Sign(char),
}

impl Token {
    pub(super) fn is_sign(&self, sign: char) -> bool {
        self.kind == Kind::Sign(sign)
    }

    pub(super) fn word(&self) -> Option<&str> {
        match &self.kind {
            Kind::Word(word) => Some(word),
            _ => None,
        }
    }

    pub(super) fn text(&self) -> Option<&str> {
        match &self.kind {
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// The tokens of a source, without comments and characters.
pub(super) fn tokens(source: &str) -> Vec<Token> {
    let signs: Vec<char> = source.chars().collect();
    let (mut at, mut line, mut tokens) = (0, 1, Vec::new());
    while at < signs.len() {
        let (kind, end) = token(&signs, at);
        tokens.extend(kind.map(|kind| Token { kind, line }));
        line += signs[at..end.min(signs.len())].iter().filter(|sign| **sign == '\n').count();
        at = end;
    }
    tokens
}

/// The token that begins at `at`, if one does, and where it ends.
fn token(signs: &[char], at: usize) -> (Option<Kind>, usize) {
    let is_at = |place: usize, sign: char| signs.get(place) == Some(&sign);
    let sign = signs[at];
    match sign {
        _ if sign.is_whitespace() => (None, at + 1),
        '/' if is_at(at + 1, '/') => (None, until(signs, at, |place| is_at(place, '\n'))),
        '"' => string(signs, at + 1),
        'r' if is_at(at + 1, '"') || is_at(at + 1, '#') && (is_at(at + 2, '"') || is_at(at + 2, '#')) => {
            raw(signs, at + 1)
        }
        '\'' if is_at(at + 1, '\\') => (None, 1 + until(signs, at + 3, |place| is_at(place, '\''))),
        '\'' if is_at(at + 2, '\'') => (None, at + 3),
        _ if is_of_word(sign) => {
            let end = until(signs, at, |place| !is_of_word(signs[place]));
            (Some(Kind::Word(signs[at..end].iter().collect())), end)
        }
        _ => (Some(Kind::Sign(sign)), at + 1),
    }
}

fn is_of_word(sign: char) -> bool {
    sign.is_alphanumeric() || sign == '_'
}

/// The first place from `at` on where `is_end` holds, or the end.
fn until(signs: &[char], at: usize, is_end: impl Fn(usize) -> bool) -> usize {
    (at..signs.len()).find(|place| is_end(*place)).unwrap_or(signs.len())
}

/// A string whose first sign is at `at`, and where it ends.
fn string(signs: &[char], mut at: usize) -> (Option<Kind>, usize) {
    let mut text = String::new();
    while signs[at] != '"' {
        match (signs[at], signs[at + 1]) {
            ('\\', '\n') => {
                at = until(signs, at + 1, |place| !signs[place].is_whitespace());
                continue;
            }
            ('\\', 'n') => text.push('\n'),
            ('\\', escaped) => text.push(escaped),
            (sign, _) => {
                text.push(sign);
                at += 1;
                continue;
            }
        }
        at += 2;
    }
    (Some(Kind::Text(text)), at + 1)
}

/// A raw string whose number signs begin at `at`, and where it ends.
fn raw(signs: &[char], at: usize) -> (Option<Kind>, usize) {
    let start = until(signs, at, |place| signs[place] == '"') + 1;
    let end: Vec<char> = std::iter::once('"').chain(signs[at..start - 1].iter().copied()).collect();
    let last = until(signs, start, |place| signs[place..].starts_with(&end));
    (Some(Kind::Text(signs[start..last].iter().collect())), last + end.len())
}

#[test]
fn texts_are_told_from_all_else() {
    let source = "let a = \"b \\\"c\\\" \\\n   d\"; // \"no\"\nr#\"e \"f\"\"# '\"' '\\'' 'x &'a str";
    let texts: Vec<String> = tokens(source).iter().filter_map(Token::text).map(str::to_owned).collect();
    assert_eq!(texts, ["b \"c\" d", "e \"f\""]);
    let words: Vec<String> = tokens(source).iter().filter_map(Token::word).map(str::to_owned).collect();
    assert_eq!(words, ["let", "a", "x", "a", "str"]);
    assert_eq!(tokens("a\n\nb")[1].line, 3);
}
