//! Settings of a solver.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use crate::error::SolveError;

/// Unknowns that jacobi, gauss-seidel and southwell relax at a time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Granularity {
    /// All unknowns of a block together, through the inverse of its diagonal block.
    #[default]
    Block,
    /// One unknown at a time, through the diagonal entry.
    Coefficient,
}

/// Matrix that cg and gmres multiply residuals by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preconditioner {
    /// The inverses of the diagonal blocks (block Jacobi).
    #[default]
    Block,
    /// No matrix: residuals stay as they are.
    None,
}

/// The order in which gauss-seidel visits the unknowns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sweep {
    /// First to last.
    #[default]
    Forward,
    /// First to last, then last to first; the two count as one iteration.
    Symmetric,
}

/// Settings of a solver; a method ignores those that do not concern it.
///
/// ```
/// use radiosity_solvers::Settings;
///
/// let settings = Settings::default().with_tolerance(1e-12).with_threads(2);
/// assert_eq!((settings.tolerance, settings.threads), (1e-12, 2));
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Settings<'a> {
    /// Wanted ‖b − A x‖₂ / ‖b‖₂, at least 0. Rounding leaves about ε ‖A‖ ‖x‖ / ‖b‖: less is never reached.
    pub tolerance: f64,
    /// Most iterations: sweeps of jacobi and gauss-seidel, matrix products of cg and gmres; for southwell
    /// sweeps' worth of shots, one sweep being as many shots as there are blocks (or coefficients).
    pub max_iterations: usize,
    /// southwell: shots after which it ends with x as it is then ([`Stop::Shots`](crate::Stop::Shots)); None
    /// for as many as the tolerance takes.
    pub shots: Option<usize>,
    /// Threads of the direct methods, 0 for all there are. Never changes a bit of the result.
    pub threads: usize,
    /// The deadline, as time from its beginning: a solve gives up there, and x holds the best so far
    /// ([`Stop::Time`](crate::Stop::Time)); all right-hand sides and fall-backs together. Looked at between
    /// iterations, and between the panels of a factorisation.
    pub time_budget: Option<Duration>,
    /// The interrupt, raised by the caller where nothing is wanted any more ([`SolveError::Cancelled`]);
    /// looked at between iterations, and between the panels of a factorisation.
    pub cancel: Option<&'a AtomicBool>,
    /// southwell: weight w_l > 0 of each unknown; the one with the largest w_l |r_l|, or the block with the
    /// largest sum of them, is shot next. All ones when absent.
    pub measure: Option<&'a [f64]>,
    /// jacobi, gauss-seidel, southwell: whether blocks or single unknowns are relaxed.
    pub granularity: Granularity,
    /// gauss-seidel: the order of visits.
    pub sweep: Sweep,
    /// jacobi, gauss-seidel, southwell, richardson: multiplies every correction, in (0, 2); above 1
    /// overshoots.
    pub relaxation: f64,
    /// cg, gmres: how residuals are preconditioned.
    pub preconditioner: Preconditioner,
    /// gmres: vectors kept before it restarts, at least 1.
    pub restart: usize,
    /// lu, cholesky: also estimate the condition number, at the price of some ten solves.
    pub condition: bool,
}

impl Default for Settings<'_> {
    fn default() -> Self {
        Self {
            tolerance: 1e-8,
            max_iterations: 1000,
            shots: None,
            threads: 1,
            time_budget: None,
            cancel: None,
            measure: None,
            granularity: Granularity::Block,
            sweep: Sweep::Forward,
            relaxation: 1.0,
            preconditioner: Preconditioner::Block,
            restart: 50,
            condition: false,
        }
    }
}

impl<'a> Settings<'a> {
    /// These settings with another [`tolerance`](Self::tolerance).
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// These settings with another [`max_iterations`](Self::max_iterations).
    #[must_use]
    pub fn with_max_iterations(self, max_iterations: usize) -> Self {
        Self { max_iterations, ..self }
    }

    /// These settings with another number of [`shots`](Self::shots).
    #[must_use]
    pub fn with_shots(self, shots: impl Into<Option<usize>>) -> Self {
        Self { shots: shots.into(), ..self }
    }

    /// These settings with another [`threads`](Self::threads).
    #[must_use]
    pub fn with_threads(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// These settings with another [`time_budget`](Self::time_budget).
    #[must_use]
    pub fn with_time_budget(self, time_budget: impl Into<Option<Duration>>) -> Self {
        Self { time_budget: time_budget.into(), ..self }
    }

    /// These settings with another [`cancel`](Self::cancel).
    #[must_use]
    pub fn with_cancel(self, cancel: impl Into<Option<&'a AtomicBool>>) -> Self {
        Self { cancel: cancel.into(), ..self }
    }

    /// These settings with another [`measure`](Self::measure).
    #[must_use]
    pub fn with_measure(self, measure: &'a [f64]) -> Self {
        Self { measure: Some(measure), ..self }
    }

    /// These settings with another [`granularity`](Self::granularity).
    #[must_use]
    pub fn with_granularity(self, granularity: Granularity) -> Self {
        Self { granularity, ..self }
    }

    /// These settings with another [`sweep`](Self::sweep).
    #[must_use]
    pub fn with_sweep(self, sweep: Sweep) -> Self {
        Self { sweep, ..self }
    }

    /// These settings with another [`relaxation`](Self::relaxation).
    #[must_use]
    pub fn with_relaxation(self, relaxation: f64) -> Self {
        Self { relaxation, ..self }
    }

    /// These settings with another [`preconditioner`](Self::preconditioner).
    #[must_use]
    pub fn with_preconditioner(self, preconditioner: Preconditioner) -> Self {
        Self { preconditioner, ..self }
    }

    /// These settings with another [`restart`](Self::restart).
    #[must_use]
    pub fn with_restart(self, restart: usize) -> Self {
        Self { restart, ..self }
    }

    /// These settings with another [`condition`](Self::condition).
    #[must_use]
    pub fn with_condition(self, condition: bool) -> Self {
        Self { condition, ..self }
    }
}

impl Settings<'_> {
    /// These settings with the time budget that is left.
    pub(crate) fn since(&self, started: Instant) -> Self {
        Self {
            time_budget: self.time_budget.map(|budget| budget.saturating_sub(started.elapsed())),
            ..self.clone()
        }
    }

    /// Refuses settings outside their range, for a system of `dim` unknowns.
    pub(crate) fn check(&self, dim: usize) -> Result<(), SolveError> {
        let wrong = |name, wanted| Err(SolveError::Setting { name, wanted });
        if self.tolerance.is_nan() || self.tolerance < 0.0 {
            return wrong("tolerance", "at least 0");
        }
        if !(self.relaxation > 0.0 && self.relaxation < 2.0) {
            return wrong("relaxation", "above 0 and below 2");
        }
        if self.restart == 0 {
            return wrong("restart", "at least 1");
        }
        let Some(measure) = self.measure else { return Ok(()) };
        if measure.len() != dim {
            return Err(SolveError::DimensionMismatch {
                what: "the measure",
                expected: dim,
                found: measure.len(),
            });
        }
        if measure.iter().all(|weight| *weight > 0.0 && weight.is_finite()) {
            return Ok(());
        }
        wrong("measure", "positive and finite for every unknown")
    }
}
