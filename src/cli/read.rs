//! What values are read from: options that reading verbs share.

use std::str::FromStr;

use clap::{Args, ValueEnum};
use radiosity::output::grid::Rates;
use radiosity::output::reader::Read;

use crate::cli::options::fraction;

/// `--read` and the accuracy of it.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// What is read
    #[arg(long, value_name = "MODE", default_value = "gather")]
    pub(crate) read: ReadMode,

    /// Accuracy of gathered light, relative, between 0 and 1
    #[arg(long, value_name = "E", default_value = "1e-3", value_parser = fraction)]
    pub(crate) read_eps: f64,
}

/// `--read`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReadMode {
    /// The polynomials of the elements alone
    Basis,
    /// Direct light and its shadows exact at every point, the rest from the polynomials
    Direct,
    /// Direct light exact, and the reflected light of all surfaces gathered anew at every point, with shadows
    Gather,
}

impl From<ReadMode> for Read {
    fn from(mode: ReadMode) -> Read {
        match mode {
            ReadMode::Basis => Read::Basis,
            ReadMode::Direct => Read::Direct,
            ReadMode::Gather => Read::Gather,
        }
    }
}

/// `--read-samples`: two counts written `8,2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Samples(pub(crate) Rates);

impl FromStr for Samples {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const MOST: usize = 64;
        let count = |part: &str| part.trim().parse().ok().filter(|count| (1..=MOST).contains(count));
        text.split_once(',')
            .and_then(|(direct, indirect)| {
                Some(Samples(Rates { direct: count(direct)?, indirect: count(indirect)? }))
            })
            .ok_or_else(|| format!("expected two numbers from 1 to {MOST} with a comma between, such as 8,2"))
    }
}
