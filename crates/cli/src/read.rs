//! Options for reading values, which several verbs share.

use clap::Args;
use radiosity_reading::grid::Rates;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::reader::ReadMode;
use radiosity_request::ReadRequest;
use radiosity_request::ranges;
use radiosity_solve::Options;
use radiosity_solve::gather::gather_method::GatherMethod;

use crate::error::CliError;
use crate::numbers::accuracy;
use crate::options::MethodArgs;
use crate::run::Run;

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

/// `--read` and the accuracy of it.
#[derive(Debug, Args)]
pub(crate) struct ReadArgs {
    /// Light that is read [default: gather; with --quality finest gather-twice]
    #[arg(long, value_name = "MODE")]
    pub(crate) read: Option<ReadMode>,

    /// By what light is gathered [default: auto]
    #[arg(long, value_name = "WAY")]
    pub(crate) read_by: Option<GatherMethod>,

    /// Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as --quality says; 1e-2 of
    /// a solution by rays; less for a wanted accuracy below 4e-3: 0.3 of that]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    pub(crate) read_eps: Option<f64>,
}

impl ReadArgs {
    /// The request for reading.
    pub(crate) fn request(&self) -> ReadRequest {
        ReadRequest { read: self.read, by: self.read_by, eps: self.read_eps, samples: None }
    }

    /// Refuses what would have no effect on the reading of a solution with these options, or an accuracy of
    /// what is not read.
    pub(crate) fn check(&self, options: &Options, method: &MethodArgs) -> Result<(), CliError> {
        Ok(self.request().check(options, &method.request())?)
    }

    /// Way of gathering light.
    pub(crate) fn by(&self) -> GatherMethod {
        self.read_by.unwrap_or_default()
    }

    /// Settings of reading: those that were typed, the others from the quality.
    pub(crate) fn plain(&self, method: &MethodArgs) -> ReadSettings {
        self.request().plain(&method.request())
    }

    /// Settings of reading: those that were typed, the others from the quality and the solution.
    pub(crate) fn reading(&self, method: &MethodArgs, run: &Run) -> ReadSettings {
        self.request().reading(&method.request(), &run.solved, run.is_saved())
    }
}

/// `--read-samples`: two counts written `8,2`.
pub(crate) fn samples(text: &str) -> Result<Rates, String> {
    let count = |part: &str| {
        part.trim().parse().ok().filter(|count: &usize| ranges::POINTS.contains(&(*count as u64)))
    };
    let rates = text
        .split_once(',')
        .and_then(|(direct, indirect)| Some(Rates { direct: count(direct)?, indirect: count(indirect)? }));
    let most = ranges::POINTS.end();
    rates.ok_or_else(|| format!("expected two numbers from 1 to {most} with a comma between, such as 8,2"))
}
