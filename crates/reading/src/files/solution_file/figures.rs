//! Cost and self-checks of a solution as the file keeps them; without times and threads, so that the same
//! input makes the same file.

use radiosity_kernel::{PairCounts, WorstError};
use radiosity_published::hierarchy::Counts;
use radiosity_solve::checks::Checks;
use radiosity_solve::solution::Solution;
use radiosity_solve::solution::powers::Powers;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::Achieved;
use radiosity_solve::{Outcome, Sampling, Stages, TransportChoice};
use radiosity_solvers::method::Method;
use serde::{Deserialize, Serialize};

/// The figures of an [`Outcome`].
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Figures {
    solver: String,
    converged: bool,
    iterations: usize,
    residual: f64,
    /// Whether direct light was split off; false in files without this key.
    #[serde(default)]
    split: bool,
    /// Relative residual of each band.
    pub(super) residuals: Vec<f64>,
    kernel_samples: u64,
    kernel_samples_distinct: u64,
    shadow_rays: u64,
    accuracy_reached: f64,
    #[serde(default)]
    worst_error: Option<WorstError>,
    /// The accuracy that the run reached, where one was wanted.
    #[serde(default)]
    pub(super) achieved: Option<Achieved>,
    /// The transport that carried the pairs of elements, and why.
    choice: TransportChoice,
    /// Cost and error of the rays, where rays carried the pairs.
    sampling: Option<Sampling>,
    /// Numbers of nodes, links and pairs, where hierarchical radiosity found the light.
    #[serde(default)]
    links: Option<Counts>,
    /// Number of coefficients per band, where it is not that of the elements.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    unknowns: Option<usize>,
    pairs: PairCounts,
    checks: Checks,
}

impl Figures {
    /// The figures of `solved`.
    pub(super) fn of(solved: &Solved) -> Self {
        let outcome = &solved.outcome;
        let bands = outcome.solution.bands();
        Self {
            solver: outcome.solver.to_owned(),
            converged: outcome.converged,
            iterations: outcome.iterations,
            residual: outcome.residual,
            split: outcome.split,
            residuals: bands.iter().map(|band| band.coefficients.residual).collect(),
            kernel_samples: outcome.samples,
            kernel_samples_distinct: outcome.distinct,
            shadow_rays: outcome.rays,
            accuracy_reached: outcome.accuracy_reached,
            worst_error: outcome.worst_error,
            achieved: solved.achieved,
            choice: outcome.choice.clone(),
            sampling: outcome.sampling,
            links: outcome.links,
            unknowns: Some(outcome.unknowns).filter(|own| *own != outcome.solution.elements().coefficients()),
            pairs: outcome.pairs,
            checks: outcome.checks,
        }
    }

    /// The balance of power.
    pub(super) fn powers(&self) -> Powers {
        self.checks.powers()
    }

    /// The outcome again, with zero times. None if there is no such solver.
    pub(super) fn outcome(self, solution: Solution) -> Option<Outcome> {
        Some(Outcome {
            unknowns: self.unknowns.unwrap_or_else(|| solution.elements().coefficients()),
            functionals: Vec::new(),
            solution,
            checks: self.checks,
            choice: self.choice,
            sampling: self.sampling,
            links: self.links,
            pairs: self.pairs,
            samples: self.kernel_samples,
            distinct: self.kernel_samples_distinct,
            rays: self.shadow_rays,
            accuracy_reached: self.accuracy_reached,
            worst_error: self.worst_error,
            solver: Method::named(&self.solver).ok()?.name,
            iterations: self.iterations,
            residual: self.residual,
            split: self.split,
            converged: self.converged,
            shots: None,
            seconds: Stages::default(),
        })
    }
}
