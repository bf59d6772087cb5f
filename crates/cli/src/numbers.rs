//! Numbers typed as values of options, with what is expected where they are refused.

use clap::builder::RangedU64ValueParser;
use radiosity_request::ranges;
use radiosity_request::ranges::PIXELS;

/// Two counts written `AxB`, such as `16x16` or `800x600`, each at most 16384 as in scenes.
pub(crate) fn counts(text: &str) -> Result<[u32; 2], String> {
    let count = |part: &str| part.parse().ok().filter(|count: &u32| PIXELS.contains(&u64::from(*count)));
    let counts =
        text.split_once(['x', 'X', '×']).and_then(|(first, second)| Some([count(first)?, count(second)?]));
    let expected =
        || format!("expected two numbers from 1 to {} with an x between, such as 16x16", PIXELS.end());
    counts.ok_or_else(expected)
}

/// A number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    number(text, ranges::positive)
}

/// A time in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    number(text, ranges::seconds)
}

/// A number that is not negative.
pub(crate) fn not_negative(text: &str) -> Result<f64, String> {
    number(text, ranges::not_negative)
}

/// A number between 0 and 1.
pub(crate) fn fraction(text: &str) -> Result<f64, String> {
    number(text, ranges::fraction)
}

/// A relative accuracy.
pub(crate) fn accuracy(text: &str) -> Result<f64, String> {
    number(text, ranges::accuracy)
}

/// A number in a range; what is no number is not in it.
fn number(text: &str, checked: fn(f64) -> Result<f64, &'static str>) -> Result<f64, String> {
    Ok(checked(text.parse().unwrap_or(f64::NAN))?)
}

/// A number of threads.
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| ranges::THREADS.contains(&(*count as u64)));
    count.ok_or_else(|| format!("{}; leave it out for one a core", ranges::whole(&ranges::THREADS)))
}

/// A count from 1 on.
pub(crate) fn at_least_one() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(ranges::ITERATIONS)
}
