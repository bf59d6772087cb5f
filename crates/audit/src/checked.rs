//! Errors that a run tells, made true by its referee.
//!
//! Each printed number has an estimate of its error that the method makes by itself, its *own* estimate o.
//! They are multiplied by one factor κ ≥ 1 a run and quantity,
//!
//! ```text
//! κ = Verdict::factor(o) ,     o² = Σ o_i² / Σ (M_i² − s_i²) .
//! ```
//!
//! Own estimates that are too small are thereby made as large as what is found; what no walk can see, such as the
//! last digits of a smooth enclosure, stays told by the method. A number at which the referee looked and which is
//! off by more than chance errs by at least what that leaves of the difference.
//!
//! Own estimates of light are parts of it: they tell nothing of a 0 that is printed where light is, and no factor
//! makes that more. Of what they miss, (κ² − 1) o² in the mean square, half is therefore taken to be where they
//! tell it, and half to be everywhere:
//!
//! ```text
//! e_i² = o_i² + m² (o_i² / o² + 1) / 2 ,     m² = (κ² − 1) o² ,     Σ e_i² = κ² Σ o_i² ;
//! ```
//!
//! m² = err² + SE where they tell nothing at all.

use std::fmt;

use radiosity_work::digits::significant;
use serde::{Serialize, Serializer};

use crate::verdict::{Judged, Verdict};

/// Relative error, seen or that would be seen, beyond which what was found is nothing but rounding.
const NOTHING: f64 = 1e3;

/// Classes that a finding names at the most. Chosen: what a line of a terminal holds.
const NAMED: usize = 5;

/// The error of a run that its referee found, as summaries and reports tell it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Checked {
    /// Relative error in the L2 mean; 0 where none was seen.
    #[serde(serialize_with = "relative")]
    pub error: f64,
    /// Its standard error.
    #[serde(serialize_with = "relative")]
    pub error_sd: f64,
    /// The least relative error that would have been seen.
    #[serde(serialize_with = "relative")]
    pub visible: f64,
    /// Relative error in the L2 mean by the method's own estimates.
    #[serde(serialize_with = "relative")]
    pub own_error: f64,
    /// κ, the factor that these are multiplied by.
    pub error_factor: f64,
    /// Counts, and what differs most.
    pub audit: Looked,
    /// Plural noun of what was judged.
    #[serde(skip)]
    of: &'static str,
    /// Whether the error exceeds chance.
    #[serde(skip)]
    is_seen: bool,
    /// Words on what differs by more than chance and by more than the own estimates tell.
    #[serde(skip)]
    finding: Option<String>,
    /// Root mean square of the own estimates, in the unit of what was judged.
    #[serde(skip)]
    own_rms: f64,
    /// Root mean square m of what these miss, in that unit.
    #[serde(skip)]
    missed_rms: f64,
    /// Differences of the readings that are off, by their numbers.
    #[serde(skip)]
    off: Vec<(usize, f64)>,
}

/// Writes a relative error; none where it is of nothing but rounding.
fn relative<S: Serializer>(error: &f64, to: S) -> Result<S::Ok, S::Error> {
    if *error > NOTHING { to.serialize_none() } else { to.serialize_f64(*error) }
}

/// The readings that a referee looked at, and the largest differences.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Looked {
    /// Readings.
    pub readings: usize,
    /// Readings that were to be judged, and were left out because time was up.
    pub left_out: usize,
    /// Rays.
    pub rays: u64,
    /// The mean of signed differences, printed less true, that exceeds chance most; None without any.
    pub signed_mean: Option<Named>,
    /// The reading that differs most; None where nothing was read.
    pub worst: Option<Named>,
}

/// A difference, printed less true, with its surface or plane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Named {
    /// Name of the surface or plane.
    pub of: String,
    /// The difference over what is true.
    pub relative: f64,
    /// Its standard error.
    pub error: f64,
}

impl Checked {
    /// The errors that `verdict` on the readings `judged` makes of the method's `own` estimates of their errors,
    /// one for each reading: root mean squares over its bands. `of` is the plural noun of what was judged.
    ///
    /// # Panics
    /// If there is not an estimate for each reading.
    pub fn of(judged: &[Judged], own: &[f64], verdict: &Verdict, of: &'static str) -> Self {
        let own_error = Self::relative(judged, own);
        let worst = verdict.worst.first().filter(|worst| worst.found.value != 0.0).map(|worst| Named {
            of: worst.of.clone(),
            relative: (worst.printed - worst.found.value) / worst.found.value.abs(),
            error: worst.found.error / worst.found.value.abs(),
        });
        let signed_mean = verdict.signed.first().map(|signed| Named {
            of: signed.of.clone(),
            relative: signed.relative,
            error: signed.error,
        });
        let unit = Verdict::mean(judged);
        Self {
            error: verdict.error(),
            error_sd: verdict.error_sd(),
            visible: verdict.visible(),
            own_error,
            error_factor: verdict.factor(own_error),
            audit: Looked { readings: verdict.readings, left_out: 0, rays: verdict.rays, signed_mean, worst },
            of,
            is_seen: verdict.exceeds(0.0),
            finding: finding(verdict, own_error, of),
            own_rms: own_error * unit,
            missed_rms: verdict.missed(own_error) * unit,
            off: Verdict::off(judged),
        }
    }

    /// As found, but so many readings were left out because time was up.
    #[must_use]
    pub fn without(self, left_out: usize) -> Self {
        Self { audit: Looked { left_out, ..self.audit }, ..self }
    }

    /// The relative size, in the L2 mean of the readings `judged`, of the method's `own` estimates of their
    /// errors, one for each reading: root mean squares over its bands.
    ///
    /// # Panics
    /// If there is not an estimate for each reading.
    pub fn relative(judged: &[Judged], own: &[f64]) -> f64 {
        assert_eq!(judged.len(), own.len(), "an estimate for each reading");
        let square = |(judged, own): (&Judged, &f64)| judged.printed.len() as f64 * own * own;
        let squares: f64 = judged.iter().zip(own).map(square).sum();
        if squares == 0.0 { 0.0 } else { (squares / Verdict::size(judged)).sqrt() }
    }

    /// The error that is told of a number of the `own` estimate; `reading` is its number among those that
    /// were judged, if it was.
    pub fn told(&self, own: f64, reading: Option<usize>) -> f64 {
        (self.error_factor * own).max(self.difference(reading))
    }

    /// The error that is told of light of the `own` estimate, which is a part of it, root mean square over the bands;
    /// `reading` is as in [`Checked::told`].
    pub fn told_of_light(&self, own: f64, reading: Option<usize>) -> f64 {
        let there = if self.own_rms > 0.0 { 0.5 * ((own / self.own_rms).powi(2) + 1.0) } else { 1.0 };
        own.hypot(self.missed_rms * there.sqrt()).max(self.difference(reading))
    }

    /// The difference of a reading that was judged and is off; 0 for all others.
    fn difference(&self, reading: Option<usize>) -> f64 {
        let is = |(number, _): &&(usize, f64)| Some(*number) == reading;
        self.off.iter().find(is).map_or(0.0, |(_, difference)| *difference)
    }

    /// Whether more was found than the method's own estimates tell, by more than three standard errors.
    pub fn finds_more(&self) -> bool {
        self.finding.is_some()
    }

    /// Whether more was found than the method's own estimates tell, by chance in one of forty right runs.
    pub fn doubts(&self) -> bool {
        self.missed_rms > 0.0 || self.finds_more()
    }

    /// Words on that, with the names of the places.
    pub fn finding(&self) -> Option<&str> {
        self.finding.as_deref()
    }
}

/// The line of a summary.
impl fmt::Display for Checked {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let said = match self.is_seen {
            _ if self.visible.max(self.error) > NOTHING => "all are 0 as far as walks tell".to_owned(),
            true => format!("off by {} % (± {} %)", percent(self.error), percent(self.error_sd)),
            false if self.visible == 0.0 => "no difference".to_owned(),
            false => format!("no error above {} % seen", percent(self.visible)),
        };
        let Looked { readings, left_out, .. } = self.audit;
        let of = if readings + left_out == 1 { self.of.trim_end_matches('s') } else { self.of };
        match left_out {
            0 => write!(to, "checked at {readings} {of} by path tracing: {said}"),
            _ => {
                let all = readings + left_out;
                write!(to, "checked at {readings} of {all} {of} by path tracing, as time was up: {said}")
            }
        }
    }
}

/// Words on what exceeds the relative error `told`.
fn finding(verdict: &Verdict, told: f64, of: &str) -> Option<String> {
    if !verdict.finds(told) {
        return None;
    }
    let all = verdict.exceeds(told).then(|| {
        let [error, sd] = [verdict.error(), verdict.error_sd()].map(percent);
        format!("all {of} together by {error} % (± {sd} %)")
    });
    let found = verdict.signed.iter().filter(|own| own.finds(told)).take(NAMED);
    let signed = found
        .map(|own| format!("\"{}\" by {} % (± {} %)", own.of, percent(own.relative), percent(own.error)));
    let parts: Vec<String> = all.into_iter().chain(signed).collect();
    Some(parts.join(", "))
}

fn percent(part: f64) -> String {
    significant(100.0 * part, 2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::referee::Mean;

    /// Readings of which 1 ± 1e-4 is true, printed so.
    fn judged(printed: &[f64]) -> Vec<Judged> {
        let found = Mean { value: 1.0, error: 1e-4 };
        printed.iter().map(|printed| Judged::of_number("floor", *printed, found, 1)).collect()
    }

    fn checked(printed: &[f64], own: f64) -> Checked {
        let judged = judged(printed);
        Checked::of(&judged, &vec![own; judged.len()], &Verdict::of(&judged, 3), "readings")
    }

    #[test]
    fn own_estimates_that_are_too_small_become_as_large_as_what_is_found() {
        let off = checked(&[1.02; 64], 1e-3);
        assert!(
            (off.error_factor - 20.0).abs() < 0.2 && (off.told(1e-3, None) - 0.02).abs() < 2e-4,
            "{off:?}"
        );
        assert!(off.finds_more() && off.to_string().contains("off by 2 %"), "{off}");
        let enough = checked(&[1.02; 64], 0.03);
        assert!(enough.error_factor == 1.0 && !enough.finds_more(), "{enough:?}");
    }

    #[test]
    fn a_number_that_may_be_off_by_chance_errs_by_what_that_leaves() {
        let mut printed = [1.0; 64];
        printed[5] = 1.0006;
        let one = checked(&printed, 1e-6);
        assert!((one.told_of_light(1e-6, Some(5)) - 1.4e-4).abs() < 1e-5, "{one:?}");
        printed[5] = 1.0004;
        let none = checked(&printed, 1e-6);
        assert!(none.told_of_light(1e-6, Some(5)) < 2e-5, "{none:?}");
    }

    #[test]
    fn digits_below_what_walks_see_stay_told_by_the_method() {
        let right = checked(&[1.0; 64], 1e-9);
        assert_eq!((right.error_factor, right.told(1e-9, Some(3))), (1.0, 1e-9));
        assert!(right.to_string().contains("no error above 0.007") && right.finding().is_none(), "{right}");
    }

    /// Seven walls of 600 ± 3 W are right, and 32 ± 0.1 W of a coin of a sixtieth of their area is printed as 47 W.
    #[test]
    fn a_small_surface_errs_by_its_difference_beside_noisy_large_ones() {
        let reading = |printed: f64, found: Mean, size: f64| Judged {
            size,
            ..Judged::of_number("surface", printed, found, 1)
        };
        let mut judged = vec![reading(600.0, Mean { value: 600.0, error: 3.0 }, 1.0); 7];
        judged.push(reading(47.0, Mean { value: 32.0, error: 0.1 }, 1.0 / 60.0));
        let own = vec![0.5; judged.len()];
        let checked = Checked::of(&judged, &own, &Verdict::of(&judged, 3), "surfaces");
        assert!((checked.told(0.5, Some(7)) - 15.0).abs() < 0.2, "{checked:?}");
    }

    /// A quarter of the readings print 0 where 1 is true, and own estimates are a thousandth of what is printed:
    /// ¼ is told of all in the mean square, and a 0 errs by half of that square where it was not judged.
    #[test]
    fn a_printed_zero_errs_where_more_is_found_than_told() {
        let printed: Vec<f64> = (0..64).map(|k| if k % 4 == 0 { 0.0 } else { 1.0 }).collect();
        let own: Vec<f64> = printed.iter().map(|printed| 1e-3 * printed).collect();
        let judged = judged(&printed);
        let verdict = Verdict::of(&judged, 3);
        let checked = Checked::of(&judged, &own, &verdict, "readings");
        let told = |own: f64| checked.told_of_light(own, None);
        assert!((verdict.error() - 0.5).abs() < 1e-3, "{verdict:?}");
        let square = own.iter().map(|own| told(*own).powi(2)).sum::<f64>() / 64.0;
        assert!((square / (verdict.squared + verdict.squared_error) - 1.0).abs() < 1e-3, "{square}");
        assert!((0.35..0.45).contains(&told(0.0)) && told(1e-3) > told(0.0), "{}", told(0.0));
        // The zero is off by 1, which is found where it was judged.
        assert!((checked.told_of_light(0.0, Some(4)) - 1.0).abs() < 1e-3);
    }

    /// All print 0 where 1 is true: own estimates tell nothing, and all err by 1.
    #[test]
    fn where_all_print_zero_all_err_by_what_was_found() {
        let dark = checked(&[0.0; 64], 0.0);
        assert!((dark.told_of_light(0.0, None) - 1.0).abs() < 1e-3, "{dark:?}");
    }

    #[test]
    fn light_that_is_right_keeps_its_own_errors() {
        let right = checked(&[1.0; 64], 1e-3);
        assert_eq!([0.0, 1e-3, 5.0].map(|own| right.told_of_light(own, None)), [0.0, 1e-3, 5.0]);
    }

    #[test]
    fn a_number_that_is_off_errs_by_its_difference() {
        let mut printed = [1.0; 64];
        printed[5] = 1.3;
        let one = checked(&printed, 1e-3);
        assert!((one.told(1e-3, Some(5)) - 0.3).abs() < 1e-9 && one.told(1e-3, Some(4)) < 0.1, "{one:?}");
    }
}
