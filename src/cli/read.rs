//! What values are read from: options that reading verbs share.

use std::str::FromStr;

use clap::Args;
use radiosity::gather::choice::By;
use radiosity::output::grid::Rates;
use radiosity::output::quality::Reading;
use radiosity::output::reader::Read;
use radiosity::solve::Outcome;

use crate::cli::numbers::accuracy;
use crate::cli::options::MethodArgs;

/// Accuracy that a solution by rays is worth being read to. Chosen: its own error is some percent, of which this adds little.
const BY_RAYS: f64 = 7e-3;

/// `--read` and the accuracy of it.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// What is read [default: gather; with --quality finest gather-twice]
    #[arg(long, value_name = "MODE")]
    pub(crate) read: Option<Read>,

    /// By what light is gathered
    #[arg(long, value_name = "WAY", default_value = "auto")]
    pub(crate) read_by: By,

    /// Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as --quality says; 7e-3 of a solution by
    /// rays; --eps or --accuracy where that is smaller]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    pub(crate) read_eps: Option<f64>,
}

impl ReadArgs {
    /// As typed, the rest as the quality and the solution say; no coarser than an accuracy that was typed.
    pub(crate) fn reading(&self, method: &MethodArgs, outcome: &Outcome) -> Reading {
        let usual = method.quality.reading();
        let of_solution = if outcome.sampling.is_some() { usual.eps.max(BY_RAYS) } else { usual.eps };
        let typed = [method.eps, method.wanted_accuracy()].into_iter().flatten();
        Reading {
            read: self.read.unwrap_or(usual.read),
            by: self.read_by,
            eps: self.read_eps.unwrap_or(typed.fold(of_solution, f64::min)),
            rates: usual.rates,
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
