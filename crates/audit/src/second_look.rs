//! A second look at the readings that stand out.
//!
//! A few walks in a thousand may carry most of the light: where none of them was drawn, a mean is too low and
//! its error too small, and a right reading stands out. If a first verdict finds more than the run tells, the
//! readings that make it do so, at most [`MOST`], are estimated again by four times as many walks with other
//! draws. These estimates do not depend on the choice of the readings and take the place of the first; the
//! verdict is then made anew. What is wrong stands out again, what was chance does not.

use radiosity_work::Work;

use crate::effort::Effort;
use crate::referee::Referee;
use crate::spot::Spot;
use crate::verdict::{Judged, Verdict};

/// Most readings that are looked at again. Chosen: of 64 readings, they then cost as much as the first look.
const MOST: usize = 16;

impl Referee {
    /// The verdict on `judged`, the readings of `spots` with estimates by `effort`, for a run that tells the
    /// relative error `told`; `worst` readings are named. Where it finds more than that, the readings that
    /// stand out are estimated again.
    ///
    /// # Panics
    /// If there is not a spot for each reading.
    pub fn verdict(
        &self,
        spots: &[Spot],
        judged: &mut [Judged],
        told: f64,
        worst: usize,
        effort: &Effort,
        work: &Work<'_>,
    ) -> Verdict {
        assert_eq!(spots.len(), judged.len(), "a spot for each reading");
        let first = Verdict::by_groups(judged, self.groups(), worst);
        if !first.finds(told) {
            return first;
        }
        let chosen = first.standing_out(judged, told, MOST);
        let again: Vec<Spot> = chosen.iter().map(|reading| spots[*reading].clone()).collect();
        let rays = |judged: &[Judged]| judged.iter().map(|own| own.estimate.rays).sum::<u64>();
        let before = rays(judged);
        let estimates = self.estimates(&again, &effort.again(), work);
        let added: u64 = estimates.iter().map(|own| own.rays).sum();
        for (reading, estimate) in chosen.into_iter().zip(estimates) {
            judged[reading].estimate = estimate;
        }
        Verdict { rays: before + added, ..Verdict::by_groups(judged, self.groups(), worst) }
    }
}
