//! A second look at the readings that stand out.
//!
//! A few walks in a thousand may carry most of the light: where none of them was drawn, a mean is too low and
//! its error too small, and a right reading stands out. If a first verdict finds more than the run tells, the
//! readings that make it do so, at most a quarter of all, are estimated again by four times as many walks with
//! other draws: that takes as long as the first look. If these readings by themselves are found to be off again,
//! the first verdict stands: it is of all readings, none of them chosen. If not, it was chance: their new
//! estimates take the place of the first, and the verdict is made anew. Where time is up before all of them are
//! estimated again, the first verdict stands.

use radiosity_work::Work;

use crate::effort::Effort;
use crate::referee::{Estimate, Referee};
use crate::spot::Spot;
use crate::verdict::{Judged, Verdict};

/// Readings for each one that may be looked at again.
const ONE_IN: usize = 4;

impl Referee {
    /// The verdict on `judged`, the readings of `spots` with estimates by `effort`, for a run that tells the
    /// relative error `told`; `worst` readings are named. Where it finds more than that, the readings that
    /// stand out are estimated again, and it stands or is made anew.
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
        let chosen = first.standing_out(judged, told, judged.len().div_ceil(ONE_IN));
        let again: Vec<Spot> = chosen.iter().map(|reading| spots[*reading].clone()).collect();
        let rays = |judged: &[Judged]| judged.iter().map(|own| own.estimate.rays).sum::<u64>();
        let before = rays(judged);
        let estimates = self.estimates_in_time(&again, &effort.again(), work);
        let Some(estimates) = estimates.into_iter().collect::<Option<Vec<Estimate>>>() else { return first };
        let added: u64 = estimates.iter().map(|own| own.rays).sum();
        let looked_at =
            |(reading, estimate): (&usize, Estimate)| Judged { estimate, ..judged[*reading].clone() };
        let second: Vec<Judged> = chosen.iter().zip(estimates).map(looked_at).collect();
        if Verdict::by_groups(&second, self.groups(), worst).finds(told) {
            return Verdict { rays: before + added, ..first };
        }
        for (reading, own) in chosen.into_iter().zip(second) {
            judged[reading] = own;
        }
        Verdict { rays: before + added, ..Verdict::by_groups(judged, self.groups(), worst) }
    }
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::{Disk, FULL_TURN};
    use radiosity_scene::{Material, SceneBuilder};

    use super::*;

    /// Points on a floor below a lamp, what a long look finds there as what is printed, and what a short one finds.
    fn floor() -> (Referee, Vec<Spot>, Vec<Judged>, Effort) {
        let mut scene = SceneBuilder::new("floor", ["lm"]);
        let grey = scene.material("grey", Material::new(vec![0.5], vec![0.0]).unwrap());
        let glow = scene.material("glow", Material::new(vec![0.5], vec![100.0]).unwrap());
        scene.surface("floor", Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).unwrap(), &grey);
        scene.surface("lamp", Disk::new(DVec3::Z, -DVec3::Z, 0.7, 0.0, FULL_TURN).unwrap(), &glow);
        let referee = Referee::of_light(&scene.build().unwrap());
        let spots: Vec<Spot> = referee.sample(40, 0).into_iter().map(|point| point.spot).collect();
        let effort = Effort::of_walks(1024.0);
        let long = referee.estimates(&spots, &Effort::of_walks(16384.0).seeded(7), &Work::alone());
        let short = referee.estimates(&spots, &effort, &Work::alone());
        let judged = long.into_iter().zip(short).map(|(long, short)| Judged {
            printed: long.bands.iter().map(|mean| mean.value).collect(),
            printed_groups: Vec::new(),
            estimate: short,
            size: 1.0,
            class: "floor".to_owned(),
        });
        (referee, spots, judged.collect(), effort)
    }

    const TOLD: f64 = 2e-3;

    #[test]
    fn a_mean_that_was_too_low_by_chance_is_replaced() {
        let (referee, spots, mut judged, effort) = floor();
        judged[5].estimate.bands[0].value *= 0.7;
        assert!(Verdict::of(&judged, 3).finds(TOLD), "the first look finds it");
        let verdict = referee.verdict(&spots, &mut judged, TOLD, 3, &effort, &Work::alone());
        assert!(!verdict.finds(TOLD), "{verdict:?}");
        assert!((judged[5].estimate.bands[0].value / judged[5].printed[0] - 1.0).abs() < 0.02);
        let last: u64 = judged.iter().map(|own| own.estimate.rays).sum();
        assert!(verdict.rays > last, "the rays of either look count");
    }

    #[test]
    fn what_is_wrong_stands_out_again() {
        let (referee, spots, mut judged, effort) = floor();
        judged[5].printed[0] *= 1.3;
        let verdict = referee.verdict(&spots, &mut judged, TOLD, 3, &effort, &Work::alone());
        assert!(verdict.finds(TOLD), "{verdict:?}");
        assert_eq!(verdict.worst[0].reading, 5);
        assert!(verdict.worst[0].is_outlier);
    }

    /// Faults of all readings, each smaller than the noise of one, of one sign and of either.
    #[test]
    fn faults_of_all_readings_are_found_again() {
        for signs in [[1.0, 1.0], [1.0, -1.0]] {
            let (referee, spots, mut judged, effort) = floor();
            for (own, sign) in judged.iter_mut().zip(signs.into_iter().cycle()) {
                own.printed[0] += 2.0 * sign * own.estimate.bands[0].error;
            }
            let first = Verdict::of(&judged, 3);
            let verdict = referee.verdict(&spots, &mut judged, 0.0, 3, &effort, &Work::alone());
            assert!(first.finds(0.0) && verdict.finds(0.0), "{first:?} {verdict:?}");
            assert_eq!(verdict.squared, first.squared);
        }
    }

    #[test]
    fn nothing_is_looked_at_again_where_nothing_is_found() {
        let (referee, spots, mut judged, effort) = floor();
        let before: Vec<_> = judged.iter().map(|own| own.estimate.clone()).collect();
        let verdict = referee.verdict(&spots, &mut judged, TOLD, 3, &effort, &Work::alone());
        assert!(!verdict.finds(TOLD));
        assert!(judged.iter().zip(&before).all(|(own, before)| own.estimate == *before));
    }
}
