//! Readings judged by a referee: light that is printed, beside what walks of light find there.
//!
//! The places are points of surfaces, even over their fronts, and sensors of the scene's planes. Each is read
//! as [`probe`](crate::probe::probe) reads it, and light group by light group where the solution keeps these
//! apart; the [`Referee`] knows nothing of the solution.

use std::fmt;

use radiosity_audit::{Effort, Estimate, Judged, Referee, Spot, Verdict};
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use radiosity_solve::solution::group_light::GroupLight;
use radiosity_solve::solved::Solved;
use radiosity_work::Work;

use crate::probe::{Probe, probe_each};
use crate::quality::ReadSettings;
use crate::reader::ReadMode;
use radiosity_work::digits::significant;

/// Part of the readings that are points of surfaces where there are planes. Chosen: planes are asked for, and
/// surfaces send them their light.
const OF_SURFACES: f64 = 2.0 / 3.0;

/// The readings that are to be judged, and the effort for them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judging {
    /// About the number of readings.
    pub readings: usize,
    /// Walks for each of them.
    pub effort: Effort,
    /// Seed of their places.
    pub seed: u64,
    /// Relative error that the run tells: no more than that is no finding.
    pub told: f64,
}

/// A reading with its place.
#[derive(Clone, Debug)]
pub struct JudgedReading {
    /// The place, in the coordinates that the scene was given in.
    pub probe: Probe,
    /// The printed numbers there, beside what the referee found.
    pub judged: Judged,
}

/// Readings of a run, judged.
#[derive(Clone, Debug)]
pub struct JudgedRun {
    /// The readings.
    pub readings: Vec<JudgedReading>,
    /// Places that could not be read, as by polynomials there is light on surfaces alone, or of which walks tell no
    /// number.
    pub unread: usize,
    /// The referee's verdict on them.
    pub verdict: Verdict,
}

/// A place at which light is read, with the name of its surface or plane.
struct Place {
    probe: Probe,
    class: String,
}

impl JudgedRun {
    /// Judges light of `solved` that is read with `settings`. The bits do not depend on threads and ranks.
    pub fn of(
        solved: &Solved,
        settings: &ReadSettings,
        referee: &Referee,
        judging: &Judging,
        work: &Work<'_>,
    ) -> Self {
        let scene = &solved.scene;
        let all = places(scene, referee, judging);
        let irradiance = |solution: &Solution| irradiances(solution, solved, settings, &all, work);
        let whole = irradiance(&solved.outcome.solution);
        let groups: Vec<Vec<Option<Vec<f64>>>> =
            group_solutions(solved, referee).into_iter().map(|own| own.read(&all, irradiance)).collect();
        let is_read: Vec<usize> = (0..all.len()).filter(|place| whole[*place].is_some()).collect();
        let spots =
            |read: &[usize]| -> Vec<Spot> { read.iter().map(|place| all[*place].spot(scene)).collect() };
        let estimates = referee.estimates(&spots(&is_read), &judging.effort, work);
        let is_told = |(_, estimate): &(usize, Estimate)| estimate.is_finite();
        let (is_read, estimates): (Vec<usize>, Vec<Estimate>) =
            is_read.into_iter().zip(estimates).filter(is_told).unzip();
        let mut judged: Vec<Judged> = is_read
            .iter()
            .zip(estimates)
            .map(|(place, estimate)| Judged {
                printed: whole[*place].clone().unwrap_or_default(),
                printed_groups: groups.iter().filter_map(|own| own[*place].clone()).collect(),
                estimate,
                weight: 1.0,
                class: all[*place].class.clone(),
            })
            .collect();
        let verdict = referee.verdict(
            &spots(&is_read),
            &mut judged,
            judging.told,
            Verdict::WORST,
            &judging.effort,
            work,
        );
        let readings = is_read.iter().zip(judged);
        let readings = readings.map(|(place, judged)| JudgedReading { probe: all[*place].probe, judged });
        Self { readings: readings.collect(), unread: all.len() - is_read.len(), verdict }
    }
}

/// The verdict in a line.
impl fmt::Display for JudgedRun {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str(&checked(&self.verdict, "readings"))
    }
}

/// Relative error that would be seen beyond which what was found is nothing but rounding.
const NOTHING: f64 = 1e3;

/// A verdict on numbers of this plural noun in a line.
pub fn checked(verdict: &Verdict, of: &str) -> String {
    let percent = |part: f64| significant(100.0 * part, 2);
    let said = match verdict.exceeds(0.0) {
        false if verdict.visible() == 0.0 => "no difference".to_owned(),
        false if verdict.visible() > NOTHING => "all are 0 as far as walks tell".to_owned(),
        true => format!("off by {} % (± {} %)", percent(verdict.error()), percent(verdict.error_sd())),
        false => format!("no error above {} % seen", percent(verdict.visible())),
    };
    format!("checked at {} {of} by path tracing: {said}", verdict.readings)
}

/// The relative error that a solution read with `settings` tells: the largest of the accuracies of its
/// transfers and of recomputed light, of the error that rays leave, and of its estimate.
pub fn told(solved: &Solved, settings: &ReadSettings) -> f64 {
    let reading = if settings.read == ReadMode::Basis { 0.0 } else { settings.eps };
    let by_rays = solved.outcome.sampling.and_then(|sampling| sampling.error);
    let estimate = solved.achieved.and_then(|achieved| achieved.estimate);
    [by_rays, estimate].into_iter().flatten().fold(solved.options.eps.max(reading), f64::max)
}

impl Place {
    fn spot(&self, scene: &Scene) -> Spot {
        Spot::Point { position: self.probe.position - scene.middle, normal: self.probe.normal }
    }
}

/// Points of surfaces, then sensors.
fn places(scene: &Scene, referee: &Referee, judging: &Judging) -> Vec<Place> {
    let sensors: usize = scene.planes.iter().map(|plane| plane.counts().iter().product::<usize>()).sum();
    let wanted = judging.readings - (OF_SURFACES * judging.readings as f64).ceil() as usize;
    let of_planes = wanted.min(sensors);
    let points = referee.sample(judging.readings - of_planes, judging.seed);
    let on_surfaces = points.into_iter().filter_map(|point| {
        let Spot::Point { position, normal } = point.spot else { return None };
        let probe = Probe { position: position + scene.middle, normal };
        Some(Place { probe, class: scene.surfaces[point.surface].name.clone() })
    });
    let mut all: Vec<Place> = on_surfaces.collect();
    let on_planes =
        scene.planes.iter().flat_map(|plane| Probe::of_plane(plane).map(move |probe| (plane, probe)));
    let chosen = evenly(on_planes, sensors, of_planes, judging.seed);
    all.extend(chosen.map(|(plane, probe)| Place { probe, class: plane.name().to_owned() }));
    all
}

/// About `wanted` of `count` items, one of each part of equal length.
pub fn evenly<T>(
    items: impl Iterator<Item = T>,
    count: usize,
    wanted: usize,
    seed: u64,
) -> impl Iterator<Item = T> {
    // The sensor of a part is another in each part and for each seed: multiples of an irrational number.
    const SEEDS: u64 = 1 << 20;
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let place = move |part: usize| {
        let within = ((seed % SEEDS + 1) as f64 * (part as f64 + 1.0) * golden).fract();
        ((part as f64 + within) * count as f64 / wanted as f64) as usize
    };
    let mut next = 0;
    items.enumerate().filter_map(move |(number, item)| {
        let is_next = next < wanted && number >= place(next);
        next += usize::from(is_next);
        is_next.then_some(item)
    })
}

/// The irradiance that a solution prints at each place; None where it cannot be read.
fn irradiances(
    solution: &Solution,
    solved: &Solved,
    settings: &ReadSettings,
    places: &[Place],
    work: &Work<'_>,
) -> Vec<Option<Vec<f64>>> {
    let reader = settings.reader(solution, solved.visibility());
    let probes: Vec<Probe> = places.iter().map(|place| place.probe).collect();
    let readings = probe_each(&reader, &probes, solved.scene.middle, work);
    readings.into_iter().map(|reading| Some(reading.ok()?.irradiance)).collect()
}

/// The light of a group by itself, at its factor.
enum GroupSolution {
    /// It has none.
    Dark {
        bands: usize,
    },
    Lit {
        solution: Box<Solution>,
        factor: f64,
    },
}

impl GroupSolution {
    fn of(solved: &Solved, group: &GroupLight) -> Self {
        let known = solved.scene.light_groups();
        let own = known.into_iter().find(|own| Some(own.name.as_str()) == group.group.as_deref());
        Self::Lit {
            solution: Box::new(solved.outcome.solution.of_group(&solved.scene, group)),
            factor: own.map_or(1.0, |own| own.factor),
        }
    }

    /// Its irradiance at each place, as `irradiance` reads it.
    fn read(
        &self,
        places: &[Place],
        irradiance: impl Fn(&Solution) -> Vec<Option<Vec<f64>>>,
    ) -> Vec<Option<Vec<f64>>> {
        match self {
            Self::Dark { bands } => vec![Some(vec![0.0; *bands]); places.len()],
            Self::Lit { solution, factor } => {
                let mut read = irradiance(solution);
                read.iter_mut().flatten().flatten().for_each(|value| *value *= factor);
                read
            }
        }
    }
}

/// The light of each of the referee's groups; none where the solution does not keep them apart.
fn group_solutions(solved: &Solved, referee: &Referee) -> Vec<GroupSolution> {
    let kept = solved.outcome.solution.groups();
    if kept.is_empty() {
        return Vec::new();
    }
    let of = |name: &Option<String>| match kept.iter().find(|own| own.group == *name) {
        Some(group) => GroupSolution::of(solved, group),
        None => GroupSolution::Dark { bands: solved.scene.bands.len() },
    };
    referee.groups().iter().map(of).collect()
}
