//! The judge of an adaptation: light at some sensors by walks that know nothing of any run.
//!
//! Its means M_i ± s_i are made once, of as many walks as show an error of the wanted accuracy A, if that takes a few
//! seconds, and every run is compared with them:
//!
//! ```text
//! err² + SE ≤ A²     (see radiosity_audit::Verdict) .
//! ```

use std::time::Duration;

use radiosity_audit::{Effort, Estimate, Judged, Mean, Referee, Spot, Verdict, WalkCost, evenly};
use radiosity_work::Work;
use radiosity_work::ranks::PartName;

use super::sensor::Sensor;
use crate::gather::gather_method::SOME_POINTS;
use crate::gather::lune::Lune;
use crate::gather::standpoint::Standpoint;
use crate::gather::surface_point::SurfacePoint;
use crate::goal::{Aim, Goal};
use crate::solved::Solved;
use crate::tolerances::USUAL_EPS;

/// Sensors at which light is judged: an L2 mean of 64 is known to a tenth of itself. Chosen.
const READINGS: usize = 64;

/// Seconds of two threads for the first look, and for the longest: the first shows 1 to 3 % in most rooms, and what
/// is to be seen falls as their square root. No longer than so many times the first run, whose own estimate is soon
/// made. Chosen.
const FIRST: f64 = 0.1;
const LONGEST: f64 = 10.0;
const OF_A_RUN: f64 = 5.0;

/// Light at sensors that is right in the mean, and how well it is known.
#[derive(Debug)]
pub(super) struct Judge {
    sensors: Vec<Sensor>,
    estimates: Vec<Estimate>,
    /// Whether an error as small as is wanted would be seen; err² is then known to a third of A².
    pub is_sharp: bool,
}

impl Judge {
    /// The judge of what `goal` wants of runs of a scene, of which `run` is the first; None where light is not what
    /// walks find: without shadows, with masks, or of some reflections alone; and where time is up.
    pub(super) fn of(goal: &Goal, run: &Solved, work: &Work<'_>) -> Option<Self> {
        let (solution, visibility) = (&run.outcome.solution, run.visibility());
        let is_all = visibility.casts() && solution.masked().is_none() && !solution.is_truncated();
        let readings = Effort::readings(FIRST, READINGS, &WalkCost::of_light(&run.scene));
        let all = Sensor::of(goal, solution, visibility);
        let count = all.len();
        let sensors: Vec<Sensor> = evenly(all.into_iter(), count, readings, 0).collect();
        if is_all && !sensors.is_empty() { Self::at(sensors, goal.accuracy, run, work) } else { None }
    }

    fn at(sensors: Vec<Sensor>, accuracy: f64, run: &Solved, work: &Work<'_>) -> Option<Self> {
        let scene = &run.scene;
        let referee = Referee::of_light(scene);
        let spots: Vec<Spot> = sensors.iter().map(Sensor::spot).collect();
        let first = Effort::of_seconds(FIRST, spots.len(), &WalkCost::of_light(scene));
        let estimates_of = |effort: &Effort| -> Option<Vec<Estimate>> {
            referee.estimates_in_time(&spots, effort, work).into_iter().collect()
        };
        let mut judge = Self { estimates: estimates_of(&first)?, is_sharp: false, sensors };
        let more = (judge.visible() / accuracy).powi(2);
        let longest = (OF_A_RUN * run.outcome.seconds_by_counts()).min(LONGEST);
        if more > 1.0 && FIRST * more <= longest && work.fits(Duration::from_secs_f64(FIRST * more)) {
            let effort = Effort::of_walks(first.walks() as f64 * more).seeded(1);
            judge.estimates = estimates_of(&effort).unwrap_or(judge.estimates);
        }
        // Walks come in powers of 2.
        judge.is_sharp = judge.visible() <= std::f64::consts::SQRT_2 * accuracy;
        Some(judge)
    }

    /// The least error that it would see.
    fn visible(&self) -> f64 {
        let right = |estimate: &Estimate| estimate.bands.iter().map(|mean| mean.value).collect();
        self.verdict(self.estimates.iter().map(right).collect()).visible()
    }

    /// Rays that a walk takes, and the variance of a walk over the mean square of light: both together tell what it
    /// takes to read light by walks.
    pub(super) fn price(&self) -> f64 {
        let rays: u64 = self.estimates.iter().map(|estimate| estimate.rays).sum();
        let means = || self.estimates.iter().flat_map(|estimate| &estimate.bands);
        let variance: f64 = means().map(|mean| mean.error.powi(2)).sum();
        let size: f64 = means().map(|mean| mean.value.powi(2)).sum::<f64>() - variance;
        rays as f64 / self.sensors.len() as f64 * variance / size.max(f64::MIN_POSITIVE)
    }

    /// The verdict on the light of a run, read as `goal` reads it.
    pub(super) fn on(&self, run: &Solved, goal: &Goal, work: &Work<'_>) -> Verdict {
        let read = match goal.of {
            Aim::Solution => self.polynomials(run),
            Aim::Gathered | Aim::Points | Aim::Seen => self.gathered(run, goal, work),
        };
        self.verdict(read)
    }

    /// Irradiance gathered at each sensor, per band, as it will be read.
    fn gathered(&self, run: &Solved, goal: &Goal, work: &Work<'_>) -> Vec<Vec<f64>> {
        let solution = &run.outcome.solution;
        let usual = if run.outcome.sampling.is_some() { f64::INFINITY } else { USUAL_EPS };
        let eps = Goal::reading(goal.accuracy).min(usual);
        let gathering = goal.by.gathering(solution, run.visibility(), eps, 1.0, SOME_POINTS, false);
        let read = |place: usize| {
            let receiver = &self.sensors[place].point;
            let read = gathering.read(receiver);
            match Lune::of(receiver, solution.elements()) {
                Some(lune) => read.with(&lune.polynomial_light(solution)).irradiance,
                None => read.irradiance,
            }
        };
        work.ranks.map_even(PartName::SensorLight, self.sensors.len(), 1, read)
    }

    /// Irradiance of the polynomials at each sensor, per band.
    fn polynomials(&self, run: &Solved) -> Vec<Vec<f64>> {
        let solution = &run.outcome.solution;
        let bands = 0..solution.bands().len();
        let read = |sensor: &Sensor| {
            let (x, normal) = (sensor.point.position, sensor.point.normal);
            let found = Standpoint::find(solution.elements(), run.visibility(), x, normal);
            let value = |band| {
                let of = |point: &SurfacePoint| solution.irradiance(band, point.element, &point.place);
                found.on().map_or(0.0, of)
            };
            bands.clone().map(value).collect()
        };
        self.sensors.iter().map(read).collect()
    }

    /// The verdict on what was read. Each band counts by its own weight w: all its numbers are multiplied by √w.
    fn verdict(&self, read: Vec<Vec<f64>>) -> Verdict {
        let judged = |((sensor, estimate), printed): ((&Sensor, &Estimate), Vec<f64>)| {
            let roots = || sensor.weights.iter().map(|weight| weight.sqrt());
            let weighed =
                |(root, mean): (f64, &Mean)| Mean { value: root * mean.value, error: root * mean.error };
            Judged {
                printed: roots().zip(printed).map(|(root, value)| root * value).collect(),
                printed_groups: Vec::new(),
                estimate: Estimate {
                    bands: roots().zip(&estimate.bands).map(weighed).collect(),
                    groups: Vec::new(),
                    rays: estimate.rays,
                },
                size: 1.0,
                class: String::new(),
            }
        };
        let all: Vec<Judged> = self.sensors.iter().zip(&self.estimates).zip(read).map(judged).collect();
        Verdict::of(&all, 0)
    }
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;
    use radiosity_light::receiver_point::ReceiverPoint;

    use super::*;

    /// Of a red and of a blue wall, the light of the colour that either hardly reflects hardly counts: 8 sensors of
    /// each, where 2 and 1 are true, read 2.2 and 1.5 at red walls, 2.6 and 1.1 at blue ones.
    #[test]
    fn each_band_counts_by_its_own_weight() {
        let found = [2.0, 1.0].map(|value| Mean { value, error: 1e-9 });
        let walls = [([4.0, 0.01], [2.2, 1.5]), ([0.01, 4.0], [2.6, 1.1])];
        let all = || (0..16).map(|k| walls[k % 2]);
        let sensor = |weights: [f64; 2]| Sensor {
            point: ReceiverPoint::free(DVec3::ZERO, DVec3::Z),
            weights: weights.to_vec(),
        };
        let judge = Judge {
            sensors: all().map(|(weights, _)| sensor(weights)).collect(),
            estimates: vec![Estimate { bands: found.to_vec(), groups: Vec::new(), rays: 1 }; 16],
            is_sharp: true,
        };
        let verdict = judge.verdict(all().map(|(_, read)| read.to_vec()).collect());
        let missed: f64 = 4.0 * 0.2 * 0.2 + 0.01 * 0.5 * 0.5 + 0.01 * 0.6 * 0.6 + 4.0 * 0.1 * 0.1;
        let size = (4.0 + 0.01) * (2.0 * 2.0 + 1.0);
        assert!((verdict.squared - missed / size).abs() < 1e-12, "{verdict:?}");
    }
}
