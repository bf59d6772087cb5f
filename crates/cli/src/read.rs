//! Options for reading values, which several verbs share.

use radiosity_reading::grid::Rates;
use radiosity_reading::reader::ReadMode;
use radiosity_request::ranges::Samples as Count;

/// A summary's words on light that was `read` without being gathered because that would have taken long, not
/// because it was `asked` for; else empty.
pub(crate) fn rough(asked: Option<ReadMode>, read: ReadMode) -> &'static str {
    match (asked, read) {
        (None, ReadMode::Direct) => {
            " (light from lamps recomputed, all other light as polynomials: --read gather is finer, and takes longer)"
        }
        _ => "",
    }
}

/// `--read-samples`: two counts written `8,2`.
pub(crate) fn samples(text: &str) -> Result<Rates, &'static str> {
    let count = |part: &str| part.trim().parse::<Count>().ok().map(Count::count);
    let rates = text
        .split_once(',')
        .and_then(|(direct, indirect)| Some(Rates { direct: count(direct)?, indirect: count(indirect)? }));
    rates.ok_or("expected two numbers from 1 to 64 with a comma between, such as 8,2")
}
