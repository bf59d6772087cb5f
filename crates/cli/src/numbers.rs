//! Numbers typed as values of options, with what is expected where they are refused.

use std::str::FromStr;

use radiosity_request::ranges::{Number, Pixels, Range};

/// Two counts written `AxB`, such as `16x16` or `800x600`, each at most 16384 as in scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counts(pub(crate) [u32; 2]);

impl FromStr for Counts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = |part: &str| part.parse::<Pixels>().ok().map(|count| count.count() as u32);
        text.split_once(['x', 'X', '×'])
            .and_then(|(first, second)| Some(Counts([count(first)?, count(second)?])))
            .ok_or_else(|| "expected two numbers from 1 to 16384 with an x between, such as 16x16".to_owned())
    }
}

/// A number in a range; what is no number is not in it.
pub(crate) fn number<R: Range>(text: &str) -> Result<f64, &'static str> {
    Ok(text.parse::<Number<R>>()?.into())
}
