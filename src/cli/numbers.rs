//! Numbers typed as values of options, with what is expected where they are refused.

use std::str::FromStr;

use clap::builder::RangedU64ValueParser;

/// Two counts written `AxB`, such as `16x16` or `800x600`, each at most 16384 as in scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counts(pub(crate) [u32; 2]);

impl FromStr for Counts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const MOST: u32 = 16384;
        let count = |part: &str| part.parse().ok().filter(|count| (1..=MOST).contains(count));
        text.split_once(['x', 'X', '×'])
            .and_then(|(first, second)| Some(Counts([count(first)?, count(second)?])))
            .ok_or_else(|| format!("expected two numbers from 1 to {MOST} with an x between, such as 16x16"))
    }
}

/// A number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "expected a number above 0, such as 1e-8")
}

/// A time in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "expected seconds, above 0, such as 30")
}

/// A number that is not negative.
pub(crate) fn not_negative(text: &str) -> Result<f64, String> {
    number(text, |x| x >= 0.0, "expected a length of 0 or more, such as 1e-6")
}

/// A number between 0 and 1.
pub(crate) fn fraction(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0 && x < 1.0, "expected a number above 0 and below 1, such as 1e-3")
}

/// A relative accuracy: below 1e-14 rounding decides, and work would never end.
pub(crate) fn accuracy(text: &str) -> Result<f64, String> {
    number(
        text,
        |x| (1e-14..1.0).contains(&x),
        "expected a number from 1e-14, near rounding, to below 1, such as 1e-3",
    )
}

fn number(text: &str, inside: fn(f64) -> bool, expected: &str) -> Result<f64, String> {
    text.parse().ok().filter(|&x: &f64| x.is_finite() && inside(x)).ok_or_else(|| expected.to_owned())
}

/// A number of threads, at most 1024: more would bring any machine to a standstill (chosen).
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("expected a whole number from 1 to {MOST}; leave it out for one a core"))
}

/// A count from 1 on.
pub(crate) fn at_least_one() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(1..=u64::from(u32::MAX))
}
