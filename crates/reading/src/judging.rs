//! A solution judged by a referee at places that are chosen for it.
//!
//! The places are points of surfaces, even over their fronts, and sensors of the scene's planes. Each is read
//! as [`probe`](crate::probe::probe) reads it, and light group by light group where the solution keeps these
//! apart; the [`Referee`] knows nothing of the solution.

use radiosity_audit::{Checked, Judged, Referee, Spot, Verdict, evenly, spread};
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use radiosity_solve::solution::group_light::GroupLight;
use radiosity_solve::solved::Solved;
use radiosity_visibility::Visibility;
use radiosity_work::{Pace, Work};

use crate::checked_readings::{CheckEffort, CheckedReadings, PrintedReading};
use crate::own_error::OwnError;
use crate::probe::{Probe, ProbeFault, ProbeReading, probe_each};
use crate::quality::ReadSettings;
use crate::reader::Reader;

/// Part of the readings that are points of surfaces where there are planes. Chosen: planes are asked for, and
/// surfaces send them their light.
const OF_SURFACES: f64 = 2.0 / 3.0;

/// Places that are read at once where time is limited. Chosen: enough for some threads, and soon done.
const AT_ONCE: usize = 16;

/// A reading with its place.
#[derive(Clone, Debug)]
pub struct JudgedReading {
    /// The place, in the coordinates that the scene was given in.
    pub probe: Probe,
    /// The printed numbers there, beside what the referee found.
    pub judged: Judged,
}

/// Readings of a solution, judged.
#[derive(Clone, Debug)]
pub struct JudgedRun {
    /// The readings.
    pub readings: Vec<JudgedReading>,
    /// Places that could not be read, as by polynomials there is light on surfaces alone, or of which walks
    /// tell no number.
    pub unread: usize,
    /// The referee's verdict on them.
    pub verdict: Verdict,
    /// Errors that follow from it.
    pub checked: Checked,
}

/// A way in which light is read.
#[derive(Clone, Copy)]
struct Way<'a> {
    settings: &'a ReadSettings,
    pace: Option<&'a Pace>,
    /// Whether it is as accurate as counts in the mean of all readings alone.
    is_for_mean: bool,
}

impl<'a> Way<'a> {
    /// The reader of a solution among obstacles.
    fn reader(&self, solution: &'a Solution, visibility: &'a Visibility) -> Reader<'a> {
        let reader = self.settings.reader(solution, visibility);
        let reader = if self.is_for_mean { reader.for_mean() } else { reader };
        match self.pace {
            Some(pace) => reader.paced(pace),
            None => reader,
        }
    }
}

/// A place at which light is read, with the name of its surface or plane.
struct Place {
    probe: Probe,
    class: String,
}

impl JudgedRun {
    /// Judges light of `solved` that is read with `settings`, that of its groups apart too. The bits do not
    /// depend on threads and ranks.
    pub fn of(
        solved: &Solved,
        settings: &ReadSettings,
        referee: &Referee,
        effort: &CheckEffort,
        work: &Work<'_>,
    ) -> Self {
        let way = Way { settings, pace: None, is_for_mean: false };
        Self::by_groups(solved, way, group_solutions(solved, referee), referee, effort, work)
    }

    /// As [`JudgedRun::of`], of the light of all groups together alone: it is read once, at this pace if there is one,
    /// as accurately as counts in the mean of all.
    pub fn of_all_light(
        solved: &Solved,
        settings: &ReadSettings,
        pace: Option<&Pace>,
        referee: &Referee,
        effort: &CheckEffort,
        work: &Work<'_>,
    ) -> Self {
        let way = Way { settings, pace, is_for_mean: true };
        Self::by_groups(solved, way, Vec::new(), referee, effort, work)
    }

    fn by_groups(
        solved: &Solved,
        way: Way<'_>,
        groups: Vec<GroupSolution>,
        referee: &Referee,
        effort: &CheckEffort,
        work: &Work<'_>,
    ) -> Self {
        let (scene, own) = (&solved.scene, OwnError::of(solved, way.settings));
        let all = places(scene, referee, effort);
        let read = |solution: &Solution| readings(solution, solved, way, &all, work);
        let whole = read(&solved.outcome.solution);
        let left_out = whole.iter().filter(|own| own.is_none()).count();
        let groups: Vec<Vec<Option<Vec<f64>>>> = groups.into_iter().map(|own| own.read(&all, read)).collect();
        let printed = |place: usize| {
            let reading = whole[place].as_ref()?.as_ref().ok()?;
            let whole = PrintedReading::of_probe(reading, scene, &own, Some(&all[place].class))?;
            let printed_groups = groups.iter().filter_map(|own| own[place].clone()).collect();
            Some(PrintedReading { printed_groups, ..whole })
        };
        let every = CheckEffort { readings: all.len(), ..*effort };
        let found = CheckedReadings::of(referee, all.len(), printed, &every, work);
        let late = found.checked.audit.left_out;
        let readings = found.numbers.iter().zip(found.judged);
        let readings = readings.map(|(place, judged)| JudgedReading { probe: all[*place].probe, judged });
        Self {
            readings: readings.collect(),
            unread: all.len() - found.numbers.len(),
            verdict: found.verdict,
            checked: found.checked.without(left_out + late),
        }
    }
}

/// Points of surfaces, then sensors.
fn places(scene: &Scene, referee: &Referee, effort: &CheckEffort) -> Vec<Place> {
    let sensors: usize = scene.planes.iter().map(|plane| plane.counts().iter().product::<usize>()).sum();
    let wanted = effort.readings - (OF_SURFACES * effort.readings as f64).ceil() as usize;
    let of_planes = wanted.min(sensors);
    let points = referee.sample(effort.readings - of_planes, effort.seed);
    let on_surfaces = points.into_iter().filter_map(|point| {
        let Spot::Point { position, normal } = point.spot else { return None };
        let probe = Probe { position: position + scene.middle, normal };
        Some(Place { probe, class: scene.surfaces[point.surface].name.clone() })
    });
    let mut all: Vec<Place> = on_surfaces.collect();
    let on_planes =
        scene.planes.iter().flat_map(|plane| Probe::of_plane(plane).map(move |probe| (plane, probe)));
    let chosen = evenly(on_planes, sensors, of_planes, effort.seed);
    all.extend(chosen.map(|(plane, probe)| Place { probe, class: plane.name().to_owned() }));
    all
}

/// The light that a solution prints at each place; None where it was not read when time was up.
fn readings(
    solution: &Solution,
    solved: &Solved,
    way: Way<'_>,
    places: &[Place],
    work: &Work<'_>,
) -> Vec<Option<Result<ProbeReading, ProbeFault>>> {
    let reader = way.reader(solution, solved.visibility());
    let probes: Vec<Probe> = places.iter().map(|place| place.probe).collect();
    let Some(pace) = way.pace else {
        return probe_each(&reader, &probes, solved.scene.middle, work).into_iter().map(Some).collect();
    };
    let mut found: Vec<_> = probes.iter().map(|_| None).collect();
    // Those that are left out are spread over all.
    for some in spread(probes.len()).collect::<Vec<_>>().chunks(AT_ONCE) {
        if pace.time_left().is_zero() {
            break;
        }
        let chosen: Vec<Probe> = some.iter().map(|place| probes[*place]).collect();
        let readings = probe_each(&reader, &chosen, solved.scene.middle, work);
        some.iter().zip(readings).for_each(|(place, reading)| found[*place] = Some(reading));
    }
    found
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

    /// Its irradiance at each place, as `read` reads it.
    fn read(
        &self,
        places: &[Place],
        read: impl Fn(&Solution) -> Vec<Option<Result<ProbeReading, ProbeFault>>>,
    ) -> Vec<Option<Vec<f64>>> {
        match self {
            Self::Dark { bands } => vec![Some(vec![0.0; *bands]); places.len()],
            Self::Lit { solution, factor } => {
                let at_factor = |reading: ProbeReading| {
                    reading.irradiance.into_iter().map(|value| factor * value).collect()
                };
                read(solution).into_iter().map(|reading| Some(at_factor(reading?.ok()?))).collect()
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
