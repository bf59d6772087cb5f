//! Words and numbers of a text.

/// Numbers below it are roundings, whose digits differ from machine to machine.
const ROUNDING: f64 = 1e-12;

/// Units that a time stands before.
pub(super) const TIMES: [&str; 7] = ["s", "ms", "µs", "ns", "min", "minutes", "seconds"];

/// A number as it is printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number<'a> {
    /// Its text.
    pub text: &'a str,
    /// Where that begins, in bytes.
    pub start: usize,
    value: f64,
    /// One unit of its last digit; none of a count.
    last_digit: Option<f64>,
}

/// A part of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part<'a> {
    /// Anything that is no number, up to the next blank.
    Word(&'a str),
    /// A number.
    Number(Number<'a>),
}

/// The words and numbers of a text, in order. A digit behind a letter belongs to a word.
pub fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let (mut at, mut word) = (0, 0);
    while at < text.len() {
        let rest = &text[at..];
        let step = rest.chars().next().map_or(1, char::len_utf8);
        let before = text[..at].chars().next_back();
        let length = if before.is_some_and(char::is_alphanumeric) { 0 } else { number_length(rest, before) };
        if length == 0 {
            at += step;
            continue;
        }
        push_words(&mut parts, &text[word..at]);
        parts.push(Part::Number(Number::new(&rest[..length], at)));
        at += length;
        word = at;
    }
    push_words(&mut parts, &text[word..]);
    parts
}

fn push_words<'a>(parts: &mut Vec<Part<'a>>, text: &'a str) {
    parts.extend(text.split_whitespace().map(Part::Word));
}

/// Bytes of the number that a text begins with, 0 of none.
fn number_length(text: &str, before: Option<char>) -> usize {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let sign =
        text.chars().next().filter(|c| ['-', '−'].contains(c) && before.is_none_or(|c| " (,".contains(c)));
    let start = sign.map_or(0, char::len_utf8);
    let mut end = start + digits(start);
    let mut found = end - start;
    if text[end..].starts_with('.') && digits(end + 1) > 0 {
        found += digits(end + 1);
        end += 1 + digits(end + 1);
    }
    if found == 0 {
        return 0;
    }
    if text[end..].starts_with('e') {
        let signed = end + 1 + usize::from(text[end + 1..].starts_with(['-', '+']));
        if digits(signed) > 0 {
            end = signed + digits(signed);
        }
    }
    end
}

impl<'a> Number<'a> {
    fn new(text: &'a str, start: usize) -> Self {
        let plain = text.replace('−', "-");
        let value: f64 = plain.parse().expect("digits are a number");
        let (mantissa, exponent) = plain.split_once('e').unwrap_or((&plain, "0"));
        let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
        let exponent: i32 = exponent.parse().expect("digits are an exponent");
        let is_count = decimals == 0 && !plain.contains('e');
        Self { text, start, value, last_digit: (!is_count).then(|| 10f64.powi(exponent - decimals)) }
    }

    /// Whether it says what `other` says: counts do where they are equal, other numbers where they are apart
    /// by a unit of the last digit of either, or are roundings both.
    pub fn agrees(&self, other: &Self) -> bool {
        let apart = (self.value - other.value).abs();
        let is_rounding = |number: &Self| number.last_digit.is_some() && number.value.abs() < ROUNDING;
        match (self.last_digit, other.last_digit) {
            (None, None) => apart == 0.0,
            (own, its) => {
                apart <= 1.0001 * own.unwrap_or(0.0).max(its.unwrap_or(0.0))
                    || [self, other].into_iter().all(is_rounding)
            }
        }
    }

    /// Its value, rounded to as many digits as `pattern` has, and written as that is.
    pub fn written_as(&self, pattern: &Self) -> String {
        let (mantissa, _) = pattern.text.split_once('e').unwrap_or((pattern.text, ""));
        let is_leading = |c: char| !('1'..='9').contains(&c);
        let digits =
            mantissa.trim_start_matches(is_leading).chars().filter(char::is_ascii_digit).count().max(1);
        if pattern.text.contains('e') {
            return format!("{:.*e}", digits - 1, self.value);
        }
        if pattern.last_digit.is_none() && self.last_digit.is_none() {
            return format!("{}", self.value);
        }
        // The exponent of the rounded value, which may have gained a digit.
        let rounded: f64 = format!("{:.*e}", digits - 1, self.value).parse().expect("it is a number");
        let exponent = if rounded == 0.0 { 0 } else { rounded.abs().log10().floor() as i32 };
        format!("{:.*}", (digits as i32 - 1 - exponent).max(0) as usize, rounded)
    }
}

/// Whether two texts say the same: equal words, and numbers that agree. A number before a unit of time agrees
/// with any before another.
pub fn agree(there: &str, now: &str) -> bool {
    let [there, now] = [there, now].map(parts);
    let are_units = |at: usize| [&there, &now].iter().all(|parts| parts.get(at).is_some_and(is_unit_of_time));
    let mut pairs = there.iter().zip(&now).enumerate();
    there.len() == now.len()
        && pairs.all(|(at, pair)| match pair {
            (Part::Number(there), Part::Number(now)) => are_units(at + 1) || there.agrees(now),
            (Part::Word(there), Part::Word(now)) => there == now || are_units(at),
            _ => false,
        })
}

fn is_unit_of_time(part: &Part<'_>) -> bool {
    matches!(part, Part::Word(word) if TIMES.contains(&word.trim_matches([',', ';', ')', '.'])))
}
