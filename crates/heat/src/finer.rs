//! The balance on elements that are cut once more, by transfers of its own.

use radiosity_solve::{Options, Outcome};
use radiosity_work::{Progress, Stage, Work};

use super::case::Case;
use super::cut::{COARSER, Cut};
use super::error::HeatError;
use super::figures::{SurfaceHeat, figures};
use super::transfers::Transfers;

/// Accuracy of transfers beyond which none is asked for. Chosen: a coarser one tells nothing.
const LARGEST_EPS: f64 = 0.1;

/// Elements of a cut with their transfers.
#[derive(Debug)]
pub(super) struct Finer {
    cut: Cut,
    transfers: Transfers,
}

impl Finer {
    /// The elements of a cut with their transfers.
    ///
    /// # Errors
    /// As [`Transfers::on`].
    pub(super) fn of(cut: Cut, case: &Case, work: &Work<'_>) -> Result<Self, HeatError> {
        let compared = comparing(work);
        let [eps, shadow_eps] =
            [case.options.eps, case.options.shadow_eps].map(|own| (COARSER * own).min(LARGEST_EPS));
        let options = Options { order: cut.order, eps, shadow_eps, ..case.options };
        let find = || Transfers::on(&cut.mesh, case, &options, &work.observed_by(&compared));
        let transfers = work.during(Stage::Comparison, find)?;
        Ok(Self { cut, transfers })
    }

    /// The figures of a case on these elements.
    ///
    /// # Errors
    /// What the solver refuses; more heat drawn than arrives.
    pub(super) fn figures(&mut self, case: &Case, work: &Work<'_>) -> Result<Vec<SurfaceHeat>, HeatError> {
        let compared = comparing(work);
        let solve = || self.transfers.light(case, &work.observed_by(&compared));
        let light = work.during(Stage::Comparison, solve)?;
        figures(&case.scene, &case.roles, &light)
    }

    /// These, for one case after another.
    pub(super) fn for_many(self) -> Self {
        Self { transfers: self.transfers.for_many(), ..self }
    }

    /// Whether all surfaces are cut.
    pub(super) fn is_whole(&self) -> bool {
        self.cut.is_whole
    }

    /// The factor of differences from the `outcome` of a case that makes them errors; None where they tell none.
    pub(super) fn factor(&self, case: &Case, outcome: &Outcome) -> Option<f64> {
        self.cut.factor(&case.roles, outcome)
    }
}

/// Tells of work that estimates the error of another one.
fn comparing(work: &Work<'_>) -> impl Fn(Progress) {
    move |progress| of_comparison(progress).into_iter().for_each(|own| work.report(own))
}

/// Progress of a solution that is made to estimate the error of another: its stages are parts of one.
fn of_comparison(progress: Progress) -> Option<Progress> {
    let stage = Stage::Comparison;
    match progress {
        Progress::Done { stage: Stage::Blocks, done, of } => Some(Progress::Done { stage, done, of }),
        Progress::Rays { done, of, .. } => {
            Some(Progress::Done { stage, done: done as usize, of: of as usize })
        }
        Progress::Expected { stage: Stage::Blocks, seconds } => Some(Progress::Expected { stage, seconds }),
        Progress::Began { .. } | Progress::Ended { .. } => None,
        other => Some(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds that a comparison expects count as its own, not as those of the solution that it judges.
    #[test]
    fn a_comparison_tells_its_own_seconds() {
        let told = |stage| of_comparison(Progress::Expected { stage, seconds: 2.0 });
        let own = told(Stage::Blocks);
        assert!(
            matches!(own, Some(Progress::Expected { stage: Stage::Comparison, seconds: 2.0 })),
            "{own:?}"
        );
    }
}
