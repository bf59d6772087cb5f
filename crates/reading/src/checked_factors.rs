//! View factors with their errors: the method's own estimates, made true by a referee where it looks.

use radiosity_audit::{Checked, Effort, evenly};
use radiosity_scene::Scene;
use radiosity_solve::view_factors::ViewFactors;
use radiosity_work::Work;

use crate::judged_factors::JudgedFactors;

/// Errors of view factors.
#[derive(Clone, Debug)]
pub struct CheckedFactors {
    /// The largest error of a factor in the row of each surface.
    pub errors: Vec<f64>,
    /// The referee's findings; None where it did not look.
    pub checked: Option<Checked>,
}

impl CheckedFactors {
    /// Most rows that are judged. Chosen: the L2 mean of their factors is known to a tenth of itself.
    pub const ROWS: usize = 64;

    /// The largest error of a factor.
    pub fn largest(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }

    /// The errors of factors, as far as the method tells.
    pub fn unjudged(factors: &ViewFactors) -> Self {
        Self { errors: factors.errors.clone(), checked: None }
    }

    /// The errors of factors of which the pairs that are `wanted` are judged by so much effort, those of some of the
    /// surfaces `from`.
    pub fn judged(
        scene: &Scene,
        factors: &ViewFactors,
        from: &[usize],
        wanted: &dyn Fn(usize, usize) -> bool,
        effort: &Effort,
        work: &Work<'_>,
    ) -> Self {
        let rows: Vec<usize> = evenly(from.iter().copied(), from.len(), Self::ROWS, 0).collect();
        let run = JudgedFactors::of(scene, factors, &rows, wanted, effort, work);
        if run.factors.is_empty() {
            return Self::unjudged(factors);
        }
        let checked = run.checked;
        let mut errors: Vec<f64> = factors.errors.iter().map(|own| checked.told(*own, None)).collect();
        for (reading, factor) in run.factors.iter().enumerate() {
            let told = checked.told(factors.errors[factor.from], Some(reading));
            errors[factor.from] = errors[factor.from].max(told);
        }
        Self { errors, checked: Some(checked) }
    }
}
