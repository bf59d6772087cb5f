//! Printed readings, checked by a referee.
//!
//! About 64 of what a run prints, evenly chosen, are estimated by walks that know the scene alone; what is
//! found makes the method's own estimates true ([`Checked`]).

use radiosity_audit::{Checked, Effort, Estimate, Judged, Referee, Spot, Verdict, WalkCost, evenly};
use radiosity_elements::cells::cells_of;
use radiosity_geom::{Rect, Surface};
use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::grid::Cell;
use crate::own_error::OwnError;
use crate::probe::{OnSurface, ProbeReading};

/// Plural noun of what is checked.
const READINGS: &str = "readings";

/// Name, among those of surfaces and planes, of points that lie on none.
const IN_THE_OPEN: &str = "points in the open";

/// Part of a cell that may be covered where it is judged. Chosen: rounding of areas.
const COVERED: f64 = 1e-6;

/// Distance from the edge of a surface, in its parameters, within which a point lies on it. Chosen: a thousand
/// times the rounding of places.
const EDGE: f64 = 1e-9;

/// A reading that is printed.
#[derive(Clone, Debug)]
pub struct PrintedReading {
    /// The place that is read, in the coordinates that the scene is computed in.
    pub spot: Spot,
    /// The printed numbers, one for each band.
    pub printed: Vec<f64>,
    /// The light of each group by itself, in the order of [`Referee::groups`]; empty where it was not
    /// printed.
    pub printed_groups: Vec<Vec<f64>>,
    /// The method's own estimate of their error, root mean square over the bands.
    pub own: f64,
    /// Name of the surface or plane.
    pub class: String,
}

impl PrintedReading {
    /// A probe's reading, of a `plane` or else of the surface that it lies on; None on the border of a surface:
    /// light there is the limit from within, and walks start beside it as well.
    pub fn of_probe(
        reading: &ProbeReading,
        scene: &Scene,
        own: &OwnError,
        plane: Option<&str>,
    ) -> Option<Self> {
        let surface = || reading.on.as_ref().map(|on| scene.surfaces[on.surface].name.as_str());
        let is_on_border = |on: &OnSurface| is_border(&*scene.surfaces[on.surface].shape, on.parameters);
        (!reading.on.as_ref().is_some_and(is_on_border)).then(|| Self {
            spot: reading.probe.spot(scene),
            printed: reading.irradiance.clone(),
            printed_groups: Vec::new(),
            own: own.of_reading(&reading.irradiance, reading.uncertainty),
            class: plane.or_else(surface).unwrap_or(IN_THE_OPEN).to_owned(),
        })
    }

    /// The mean irradiance of a cell of a grid of `cells` along u and v; None where something stands on it:
    /// its mean counts that part as dark, and walks leave it out.
    pub fn of_cell(cell: &Cell, cells: [usize; 2], scene: &Scene, own: &OwnError) -> Option<Self> {
        let rect = cells_of(cells).nth(cell.index[0] * cells[1] + cell.index[1])?;
        (cell.exposed >= (1.0 - COVERED) * cell.area).then(|| Self {
            spot: Spot::Cell { surface: cell.surface, rect },
            printed: cell.irradiance.clone(),
            printed_groups: Vec::new(),
            own: own.of_reading(&cell.irradiance, cell.uncertainty),
            class: scene.surfaces[cell.surface].name.clone(),
        })
    }
}

/// Whether a place lies on the border of a shape: at an end of a parameter, but at no seam, where both ends are one
/// place, and at no pole, where the other parameter changes nothing.
fn is_border(shape: &dyn Surface, [u, v]: [f64; 2]) -> bool {
    let extent = shape.bounds(&Rect::FULL).diagonal();
    let here = shape.jet(u, v).position;
    let is_here = |u: f64, v: f64| shape.jet(u, v).position.distance(here) <= EDGE * extent;
    let is_end = |parameter: f64| parameter.abs() > 1.0 - EDGE;
    let elsewhere = |parameter: f64| parameter - 0.7 * parameter.signum();
    let ends_u = is_end(u) && !is_here(-u, v) && !is_here(u, elsewhere(v));
    let ends_v = is_end(v) && !is_here(u, -v) && !is_here(elsewhere(u), v);
    ends_u || ends_v
}

/// How much is checked, and by how many walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckEffort {
    /// About the number of readings.
    pub readings: usize,
    /// Walks for each of them.
    pub effort: Effort,
    /// Seed of the choice.
    pub seed: u64,
}

impl CheckEffort {
    /// About the seconds that its walks in a scene take two threads.
    pub fn seconds(&self, scene: &Scene) -> f64 {
        self.effort.seconds(self.readings, &WalkCost::of_light(scene))
    }
}

/// Readings of a run with what the referee says of them.
#[derive(Clone, Debug)]
pub struct CheckedReadings {
    /// Numbers of the readings that were judged, among all.
    pub numbers: Vec<usize>,
    /// These readings beside what was found, in the same order.
    pub judged: Vec<Judged>,
    /// The verdict on them.
    pub verdict: Verdict,
    /// Errors that follow.
    pub checked: Checked,
}

impl CheckedReadings {
    /// Judges as many of the `count` readings as the effort says, evenly chosen, of those that `reading`
    /// gives. The bits do not depend on threads and ranks, but on the clock where time is limited: those that are
    /// not done when it is up are left out.
    pub fn of(
        referee: &Referee,
        count: usize,
        reading: impl Fn(usize) -> Option<PrintedReading>,
        effort: &CheckEffort,
        work: &Work<'_>,
    ) -> Self {
        let chosen = evenly(0..count, count, effort.readings, effort.seed);
        let (numbers, printed): (Vec<usize>, Vec<PrintedReading>) =
            chosen.filter_map(|number| Some((number, reading(number)?))).unzip();
        let spots: Vec<Spot> = printed.iter().map(|own| own.spot.clone()).collect();
        let estimates = referee.estimates_in_time(&spots, &effort.effort, work);
        let left_out = estimates.iter().filter(|estimate| estimate.is_none()).count();
        let is_told = |(_, estimate): &(_, Estimate)| estimate.is_finite();
        let told = numbers.into_iter().zip(printed).zip(estimates);
        let told = told.filter_map(|(own, estimate)| Some((own, estimate?))).filter(is_told);
        let (mut numbers_judged, mut judged, mut spots, mut own) = (vec![], vec![], vec![], vec![]);
        for ((number, printed), estimate) in told {
            let PrintedReading { spot, printed, printed_groups, own: error, class } = printed;
            numbers_judged.push(number);
            judged.push(Judged { printed, printed_groups, estimate, size: 1.0, class });
            spots.push(spot);
            own.push(error);
        }
        let told = Checked::relative(&judged, &own);
        let verdict = referee.verdict(&spots, &mut judged, told, Verdict::WORST, &effort.effort, work);
        let checked = Checked::of(&judged, &own, &verdict, READINGS).without(left_out);
        Self { numbers: numbers_judged, judged, verdict, checked }
    }

    /// The errors that are told of all readings, of which the method's own estimates are `own`: these alone
    /// where nothing was checked.
    pub fn all_told(checked: Option<&Self>, own: impl Iterator<Item = f64>) -> Vec<f64> {
        let told = |(number, own)| checked.map_or(own, |checked| checked.told(number, own));
        own.enumerate().map(told).collect()
    }

    /// The errors that are told of readings of other light of the run than was judged, as of another frame.
    pub fn all_told_of_others(checked: Option<&Self>, own: impl Iterator<Item = f64>) -> Vec<f64> {
        let told = |own| checked.map_or(own, |found| found.checked.told_of_light(own, None));
        own.map(told).collect()
    }

    /// The error that is told of the reading of this number, of which the method's own estimate is `own`.
    fn told(&self, number: usize, own: f64) -> f64 {
        self.checked.told_of_light(own, self.numbers.binary_search(&number).ok())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::{Cylinder, FULL_TURN, Sphere};
    use radiosity_language::builtin;

    use super::*;

    /// Points of the floor of the furnace, where light is 2, that print `light` and tell the error `own`.
    fn floor(number: usize, light: f64, own: f64) -> Option<PrintedReading> {
        let position = DVec3::new((number as f64 + 0.5) / 128.0, 0.3, 0.0);
        Some(PrintedReading {
            spot: Spot::Point { position: position - builtin("furnace-cube").ok()?.middle, normal: DVec3::Z },
            printed: vec![light],
            printed_groups: Vec::new(),
            own,
            class: "floor".to_owned(),
        })
    }

    fn checked(reading: impl Fn(usize) -> Option<PrintedReading>) -> CheckedReadings {
        let referee = Referee::of_light(&builtin("furnace-cube").expect("it is built in"));
        let effort = CheckEffort { readings: 64, effort: Effort::of_walks(4096.0), seed: 0 };
        CheckedReadings::of(&referee, 128, reading, &effort, &Work::alone())
    }

    #[test]
    fn readings_that_are_right_keep_their_own_errors() {
        let right = checked(|number| floor(number, 2.0, 1e-2));
        assert_eq!((right.judged.len(), right.numbers.len()), (64, 64));
        assert!(right.numbers.is_sorted_by(|a, b| a < b) && right.numbers[63] >= 126, "{:?}", right.numbers);
        assert_eq!(right.checked.error_factor, 1.0);
        assert_eq!(CheckedReadings::all_told(Some(&right), [1e-2; 128].into_iter()), vec![1e-2; 128]);
    }

    #[test]
    fn readings_that_are_off_err_by_what_was_found_those_that_were_not_judged_too() {
        let off = checked(|number| floor(number, 2.2, 1e-2));
        let told = CheckedReadings::all_told(Some(&off), [1e-2; 128].into_iter());
        assert!(told.iter().all(|error| (error - 0.2).abs() < 0.02), "{told:?}");
        assert!(
            off.checked.finding().is_some_and(|finding| finding.contains("\"floor\" by 10 %")),
            "{off:?}"
        );
    }

    /// A quarter prints 0, of which own estimates tell nothing: readings at which nobody looked err by half of the
    /// mean square of all, which is 1.
    #[test]
    fn a_printed_zero_errs_where_light_is() {
        let light = |number: usize| if number.is_multiple_of(4) { 0.0 } else { 2.0 };
        let off = checked(|number| floor(number, light(number), 1e-2 * light(number)));
        let told = CheckedReadings::all_told(Some(&off), (0..128).map(|number| 1e-2 * light(number)));
        let is_unseen = |number: &usize| light(*number) == 0.0 && !off.numbers.contains(number);
        let unseen: Vec<f64> = (0..128).filter(is_unseen).map(|number| told[number]).collect();
        assert!(unseen.len() > 8 && unseen.iter().all(|error| (0.6..0.9).contains(error)), "{unseen:?}");
    }

    #[test]
    fn a_single_reading_that_is_off_errs_by_its_own_difference() {
        let right = checked(|number| floor(number, 2.0, 1e-2));
        let wrong = right.numbers[20];
        let one = checked(|number| floor(number, if number == wrong { 1.0 } else { 2.0 }, 1e-2));
        assert!((one.told(wrong, 1e-2) - 1.0).abs() < 0.02, "{one:?}");
        assert!(one.told(wrong + 1, 1e-2) < 0.5, "{one:?}");
    }

    #[test]
    fn what_cannot_be_judged_is_left_out() {
        let half = checked(|number| floor(number, 2.0, 1e-2).filter(|_| number < 64));
        assert_eq!(half.judged.len(), 32);
        assert!(checked(|_| None).judged.is_empty());
    }

    #[test]
    fn seams_and_poles_are_no_borders() {
        let pipe = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).expect("it is one");
        let half = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, [0.0, PI]).expect("it is one");
        let ball = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("it is one");
        let is_border =
            |shape: &dyn Surface, ends: [[f64; 2]; 3]| ends.map(|end| super::is_border(shape, end));
        let ends = [[-1.0, 0.5], [0.5, 1.0], [0.5, 0.5]];
        assert_eq!(is_border(&pipe, ends), [false, true, false]);
        assert_eq!(is_border(&half, ends), [true, true, false]);
        assert_eq!(is_border(&ball, ends), [false; 3]);
    }
}
