//! The referee: walks for each reading, their means and errors.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_scene::Scene;
use radiosity_work::ranks::PartName;
use radiosity_work::{Progress, Stage, Work};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::effort::Effort;
use crate::even_choice::spread;
use crate::groups::Groups;
use crate::lamps::Lamps;
use crate::lattice::{Draws, Lattice};
use crate::random::{OF_LATTICES, OF_SAMPLES, OF_WALKS, Random};
use crate::rays::Rays;
use crate::sample::{SamplePoint, over_surfaces};
use crate::skin::Skin;
use crate::spectrum::{Spectrum, TOGETHER};
use crate::spot::{Begin, Spot, Start};
use crate::suns::Suns;
use crate::walk::{Ground, Scores};
use crate::walk_cost::WalkCost;

/// Weight k⁻¹ below which a walk may end. Measured (`docs/theory/error.md`): of ½, 1, 1.5, 2 and 4 the k of the
/// least variance at equal time on most scenes.
const GOING_ON: f64 = 2.0;

/// A scene, to be read by walks.
#[derive(Debug)]
pub struct Referee {
    rays: Rays,
    groups: Groups,
    scene: Scene,
}

/// An unbiased mean of walks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mean {
    /// The mean (W m⁻²).
    pub value: f64,
    /// Its standard error s, from the spread of independent means.
    pub error: f64,
}

/// The estimate of one reading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// One mean for each band.
    pub bands: Vec<Mean>,
    /// The light of each group by itself, one mean for each band, in the order of [`Referee::groups`].
    pub groups: Vec<Vec<Mean>>,
    /// Rays that were traced for it.
    pub rays: u64,
}

/// The sums of one move of the lattice.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Shift {
    /// Means group by group, all bands of each.
    means: Vec<Vec<f64>>,
    /// Part of the surface that nothing stands on.
    pub(crate) bare: f64,
    pub(crate) rays: u64,
}

impl Shift {
    /// The mean of a band, all groups together.
    pub(crate) fn mean(&self, band: usize) -> f64 {
        self.means.iter().map(|group| group[band]).sum()
    }
}

impl Referee {
    /// The referee of the light of a scene.
    pub fn of_light(scene: &Scene) -> Self {
        Self { rays: Rays::of(scene), groups: Groups::of(scene), scene: scene.clone() }
    }

    /// The light groups that estimates keep apart: None for what belongs to no group.
    pub fn groups(&self) -> &[Option<String>] {
        self.groups.names()
    }

    /// About `count` points, even over the fronts of all surfaces where nothing stands on them; others by
    /// another seed.
    pub fn sample(&self, count: usize, seed: u64) -> Vec<SamplePoint> {
        over_surfaces(&self.rays, count, &mut Random::of(&[seed, OF_SAMPLES]))
    }

    /// Estimates of the light at each spot, in order, whatever time it takes: the same on any number of threads and
    /// ranks.
    pub fn estimates(&self, spots: &[Spot], effort: &Effort, work: &Work<'_>) -> Vec<Estimate> {
        let unhurried = Work { deadline: None, ..*work };
        self.estimates_in_time(spots, effort, &unhurried).into_iter().flatten().collect()
    }

    /// As [`Referee::estimates`], but None of a spot whose walks were not done when time was up.
    pub fn estimates_in_time(
        &self,
        spots: &[Spot],
        effort: &Effort,
        work: &Work<'_>,
    ) -> Vec<Option<Estimate>> {
        let seconds = effort.seconds(spots.len(), &WalkCost::of_light(&self.scene));
        work.report(Progress::Expected { stage: Stage::Referee, seconds });
        let grounds: Vec<Ground<'_>> =
            (0..self.scene.bands.len()).step_by(TOGETHER).map(|first| self.ground(first)).collect();
        let bands = self.scene.bands.len();
        let shifts = read(&self.rays, &grounds, bands, spots, effort, work);
        shifts.iter().map(|own| own.as_deref().map(|own| estimate(own, bands))).collect()
    }

    fn ground(&self, first: usize) -> Ground<'_> {
        let skins = Skin::all(&self.scene, first);
        Ground {
            lamps: Lamps::of(&self.scene, &self.rays, &skins, &self.groups, first),
            suns: Suns::of(&self.scene, first),
            rays: &self.rays,
            groups: &self.groups,
            skins,
            sheets: &[],
            surroundings: Spectrum::default(),
            going_on: GOING_ON,
        }
    }
}

/// The moves of the lattice at each spot; None as [`shifts`] says.
pub(crate) fn read(
    rays: &Rays,
    grounds: &[Ground<'_>],
    bands: usize,
    spots: &[Spot],
    effort: &Effort,
    work: &Work<'_>,
) -> Vec<Option<Vec<Shift>>> {
    let starts: Vec<Start<'_>> = spots.iter().map(|spot| Start::of(spot, rays)).collect();
    shifts(spots.len(), work, |spot, shift| {
        let parts = grounds.iter().enumerate().map(|(part, ground)| {
            let name = [effort.seed, spot as u64, shift as u64, part as u64];
            shift_of(ground, &starts[spot], effort.log, &name)
        });
        let sums: Vec<Scores> = parts.collect();
        let rays = sums.iter().map(|own| own.rays).sum();
        let group = |group: usize| {
            let values = sums.iter().flat_map(|own| own.groups[group].0);
            values.take(bands).collect()
        };
        Shift { means: (0..sums[0].groups.len()).map(group).collect(), bare: sums[0].bare, rays }
    })
}

/// The moves of the lattice at so many spots; None of a spot whose moves were not all made when time was up.
/// That is not looked at where pieces are recorded: a later run takes them for done. `make` is asked for each by
/// the numbers of its spot and its move.
pub(crate) fn shifts<T>(
    spots: usize,
    work: &Work<'_>,
    make: impl Fn(usize, usize) -> T + Sync,
) -> Vec<Option<Vec<T>>>
where
    T: Serialize + DeserializeOwned + Send,
{
    let (done, count) = (AtomicUsize::new(0), spots * Effort::SHIFTS);
    // Those that are left out when time is up are then spread, too.
    let order: Vec<usize> = spread(spots).collect();
    let is_recorded = work.ranks.record_all();
    let shift = |k: usize| {
        let is_late = !is_recorded && work.is_late_here();
        let made = (!is_late).then(|| make(order[k / Effort::SHIFTS], k % Effort::SHIFTS));
        work.report_done(Stage::Referee, done.fetch_add(1, Ordering::Relaxed) + 1, count);
        made
    };
    let mut made = work.ranks.map_even(PartName::Referee, count, 1, shift).into_iter();
    let mut found: Vec<Option<Vec<T>>> = (0..spots).map(|_| None).collect();
    for spot in order {
        // All moves of the spot are taken, the missing ones too.
        let own: Vec<Option<T>> = made.by_ref().take(Effort::SHIFTS).collect();
        found[spot] = own.into_iter().collect();
    }
    found
}

/// The means of one move of the lattice at a start.
fn shift_of(ground: &Ground<'_>, start: &Start<'_>, log: u32, name: &[u64; 4]) -> Scores {
    let [seed, spot, shift, part] = *name;
    let mut random = Random::of(&[seed, spot, shift, part, OF_LATTICES]);
    let lattice = Lattice::moved(log, &mut random);
    let count = 1u64 << log;
    let mut scores = Scores::none(ground.groups.names().len());
    let (mut weights, mut covered) = (0.0, 0.0);
    for k in 0..count {
        let mut draws = Draws::new(&lattice, k, Random::of(&[seed, spot, shift, part, OF_WALKS, k]));
        match start.begin(draws.pair()) {
            Begin::Covered(weight) => covered += weight,
            Begin::Against(ray) => {
                weights += 1.0;
                ground.look(&ray, &mut draws, &mut scores);
            }
            Begin::At(vertex, weight) => {
                weights += weight;
                ground.walk(vertex, weight, &mut draws, &mut scores);
            }
        }
        if scores.are_lost() {
            break;
        }
    }
    if weights > 0.0 {
        scores.groups.iter_mut().for_each(|sum| *sum = (1.0 / weights) * *sum);
    }
    if covered > 0.0 {
        scores.bare = weights / (weights + covered);
    }
    scores
}

fn estimate(shifts: &[Shift], bands: usize) -> Estimate {
    let groups = shifts[0].means.len();
    let of = |value: &dyn Fn(&Shift) -> f64| Mean::of(&shifts.iter().map(value).collect::<Vec<_>>());
    let total = |band: usize| of(&|own| own.mean(band));
    let group = |group: usize| (0..bands).map(|band| of(&|own| own.means[group][band])).collect();
    Estimate {
        bands: (0..bands).map(total).collect(),
        groups: (0..groups).map(group).collect(),
        rays: shifts.iter().map(|own| own.rays).sum(),
    }
}

impl Estimate {
    /// Whether all its numbers are such.
    pub fn is_finite(&self) -> bool {
        self.bands
            .iter()
            .chain(self.groups.iter().flatten())
            .all(|mean| (mean.value + mean.error).is_finite())
    }
}

impl Mean {
    /// The mean of independent values, at least two, and its standard error.
    pub fn of(values: &[f64]) -> Self {
        let count = values.len() as f64;
        let value = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|own| (own - value).powi(2)).sum();
        Self { value, error: (squares / (count * (count - 1.0))).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::{Disk, FULL_TURN};
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_work::Deadline;

    use super::*;

    /// Walks that are not done when time is up are left out; who wants all of them waits.
    #[test]
    fn walks_end_with_the_time_that_they_are_given() {
        let mut scene = SceneBuilder::new("disk", ["lm"]);
        let glow = scene.material("glow", Material::new(vec![0.5], vec![1.0]).expect("it is one"));
        let disk = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("it is one");
        scene.surface("disk", disk, &glow);
        let referee = Referee::of_light(&scene.build().expect("it is one"));
        let spots: Vec<Spot> = referee.sample(9, 0).into_iter().map(|point| point.spot).collect();
        let effort = Effort::of_walks(64.0);
        let past = Deadline::at(Some(Instant::now()));
        let late = Work::alone().until(&past);
        assert!(referee.estimates_in_time(&spots, &effort, &late).iter().all(Option::is_none));
        let all = referee.estimates(&spots, &effort, &late);
        assert_eq!(all.len(), spots.len());
        let unhurried = referee.estimates_in_time(&spots, &effort, &Work::alone());
        assert_eq!(unhurried.into_iter().flatten().collect::<Vec<_>>(), all);
    }
}
