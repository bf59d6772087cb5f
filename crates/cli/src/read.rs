//! Options for reading values, which several verbs share.

use std::str::FromStr;

use radiosity_reading::grid::Rates;
use radiosity_request::ranges::Samples as Count;

/// A summary's words on light that was not gathered because that would have taken long.
pub(crate) const ROUGH: &str = " (light from lamps recomputed, all other light as polynomials: --read gather is finer, and takes longer)";

/// `--read-samples`: two counts written `8,2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Samples(pub(crate) Rates);

impl FromStr for Samples {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let count = |part: &str| part.trim().parse::<Count>().ok().map(Count::count);
        text.split_once(',')
            .and_then(|(direct, indirect)| {
                Some(Samples(Rates { direct: count(direct)?, indirect: count(indirect)? }))
            })
            .ok_or_else(|| "expected two numbers from 1 to 64 with a comma between, such as 8,2".to_owned())
    }
}
