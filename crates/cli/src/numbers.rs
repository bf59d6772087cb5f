//! Numbers typed as values of options, with what is expected where they are refused.

use radiosity_request::ranges::{Number, Pixels, Range};

/// Two counts written `AxB`, such as `16x16` or `800x600`, each at most 16384 as in scenes.
pub(crate) fn counts(text: &str) -> Result<[u32; 2], &'static str> {
    let count = |part: &str| part.parse::<Pixels>().ok().map(|count| count.count() as u32);
    let counts =
        text.split_once(['x', 'X', '×']).and_then(|(first, second)| Some([count(first)?, count(second)?]));
    counts.ok_or("expected two numbers from 1 to 16384 with an x between, such as 16x16")
}

/// A number in a range; what is no number is not in it.
pub(crate) fn number<R: Range>(text: &str) -> Result<f64, &'static str> {
    Ok(text.parse::<Number<R>>()?.into())
}
