//! What values are read from: options that reading verbs share.

use std::str::FromStr;

use clap::Args;
use radiosity::gather::choice::By;
use radiosity::output::grid::Rates;
use radiosity::output::quality::Reading;
use radiosity::output::reader::Read;
use radiosity::solve::Options;
use radiosity::studies::adaptation::Goal;
use radiosity::visibility::Hiding;

use crate::cli::aim::Wanted;
use crate::cli::error::CliError;
use crate::cli::numbers::accuracy;
use crate::cli::options::MethodArgs;
use crate::cli::run::Run;

/// Accuracy that a solution by rays is worth being read to. Chosen: its own error is some percent, of which this adds little.
const BY_RAYS: f64 = 1e-2;

/// What a summary says of light that was not gathered because that would have taken long.
pub(crate) const ROUGH: &str = " (light from lamps recomputed, all other light as polynomials: --read gather is finer, and takes longer)";

/// `--read` and the accuracy of it.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// What is read [default: gather; with --quality finest gather-twice]
    #[arg(long, value_name = "MODE")]
    pub(crate) read: Option<Read>,

    /// By what light is gathered [default: auto]
    #[arg(long, value_name = "WAY")]
    pub(crate) read_by: Option<By>,

    /// Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as --quality says; 1e-2 of a solution by
    /// rays; less for a wanted accuracy below 4e-3: 0.3 of that]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    pub(crate) read_eps: Option<f64>,
}

impl ReadArgs {
    /// Refuses what would have no effect on the reading of a solution with these options, or an accuracy of what is not read.
    pub(crate) fn check(&self, options: &Options, method: &MethodArgs) -> Result<(), CliError> {
        check_aim(self.read, method)?;
        let refuse = |message: &str, cure: &str| {
            Err(CliError::Refused { message: message.to_owned(), cure: cure.to_owned() })
        };
        match self.read {
            Some(Read::Basis) if self.read_eps.is_some() => refuse(
                "--read-eps is the accuracy of recomputed light, and --read basis recomputes none",
                "leave one of them out",
            ),
            Some(Read::Basis | Read::Direct) if self.read_by.is_some() => refuse(
                "--read-by says by what light is gathered, and --read basis and direct gather none",
                "leave one of them out, or take --read gather",
            ),
            _ if self.read_by == Some(By::Rays)
                && (options.masks.is_some() || options.shadows == Hiding::Off) =>
            {
                refuse(
                    "--read-by rays always sees exact shadows, and the solution has others: --shadows mask or off",
                    "take --read-by cells, or solve with other shadows",
                )
            }
            _ => Ok(()),
        }
    }

    /// By what light is gathered.
    pub(crate) fn by(&self) -> By {
        self.read_by.unwrap_or_default()
    }

    /// As typed, the rest as the quality says.
    pub(crate) fn plain(&self, method: &MethodArgs) -> Reading {
        let usual = method.quality.reading();
        self.typed(usual, method.eps.unwrap_or(usual.eps))
    }

    /// As typed; `eps` where no accuracy was, and the rest as usual.
    fn typed(&self, usual: Reading, eps: f64) -> Reading {
        Reading {
            read: self.read.unwrap_or(usual.read),
            by: self.by(),
            eps: self.read_eps.unwrap_or(eps),
            rates: usual.rates,
        }
    }

    /// As typed, the rest as the quality and the solution say; no coarser than the accuracy of the solution, where one was
    /// asked for.
    pub(crate) fn reading(&self, method: &MethodArgs, run: &Run) -> Reading {
        let usual = method.quality.reading();
        let is_sampled = run.solved.outcome.sampling.is_some();
        let of_solution = if is_sampled { usual.eps.max(BY_RAYS) } else { usual.eps };
        let asked = [method.eps, method.wanted_accuracy().map(Goal::reading), run.saved_accuracy()]
            .into_iter()
            .flatten();
        self.typed(usual, asked.fold(of_solution, f64::min))
    }
}

/// Refuses an accuracy of gathered light where polynomials are read.
pub(crate) fn check_aim(read: Option<Read>, method: &MethodArgs) -> Result<(), CliError> {
    let is_of_gathered = method.wanted_accuracy().is_some() && method.aim != Some(Wanted::Solution);
    match read {
        Some(Read::Basis | Read::Direct) if is_of_gathered => Err(CliError::Refused {
            message: "--accuracy is that of gathered light, and --read basis and direct read polynomials"
                .to_owned(),
            cure: "add --for solution, or take --read gather".to_owned(),
        }),
        _ => Ok(()),
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
