//! What values are read from: options that reading verbs share.

use std::str::FromStr;

use clap::{Args, ValueEnum};
use radiosity::output::grid::Rates;
use radiosity::output::quality::{Quality, Reading};
use radiosity::output::reader::Read;

use crate::cli::modes::QualityMode;
use crate::cli::numbers::fraction;

/// `--read` and the accuracy of it.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// What is read [default: gather; with --quality finest gather-twice]
    #[arg(long, value_name = "MODE")]
    pub(crate) read: Option<ReadMode>,

    /// Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3; as --quality says]
    #[arg(long, value_name = "E", value_parser = fraction)]
    pub(crate) read_eps: Option<f64>,
}

impl ReadArgs {
    /// As typed, the rest as `quality` says.
    pub(crate) fn reading(&self, quality: QualityMode) -> Reading {
        let usual = Quality::from(quality).reading();
        Reading {
            read: self.read.map_or(usual.read, Read::from),
            eps: self.read_eps.unwrap_or(usual.eps),
            rates: usual.rates,
        }
    }
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
    /// The same, with the light of those surfaces gathered as well: slower, for the last digit
    GatherTwice,
}

impl From<ReadMode> for Read {
    fn from(mode: ReadMode) -> Read {
        match mode {
            ReadMode::Basis => Read::Basis,
            ReadMode::Direct => Read::Direct,
            ReadMode::Gather => Read::Gather,
            ReadMode::GatherTwice => Read::GatherTwice,
        }
    }
}

/// `--read-samples`: two counts written `8,2`, each at most 64 (chosen).
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
