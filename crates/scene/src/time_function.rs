//! Values at given times, and between them by straight lines or a natural cubic spline.
//!
//! Between the times t₀ and t₁ with the values a and b, s = (t − t₀)/(t₁ − t₀) and h = t₁ − t₀,
//!
//! ```text
//! line     (1 − s) a + s b
//! spline   (1 − s) a + s b + h²/6 ((1 − s)³ − (1 − s)) M₀ + h²/6 (s³ − s) M₁
//! ```
//!
//! with the second derivatives M at the times, 0 at both ends, such that the first derivatives agree (C. de
//! Boor, *A practical guide to splines*, 1978, chapter IV). Before the first time and after the last the
//! value stays.

use std::ops::{Add, Mul, Sub};

use crate::{
    fault::{Fault, FaultKind, shown},
    ranges::check_number,
};

/// Interpolation between two given values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// A straight line, at constant speed.
    #[default]
    Line,
    /// A natural cubic spline, of continuous speed and acceleration.
    Spline,
}

/// A number or a vector, of which weighted sums are made.
pub trait Interpolable:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
}

impl<T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Interpolable for T {}

/// A function of time, interpolated between values at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeFunction<T> {
    times: Times,
    values: Vec<T>,
    /// Second derivatives by time; empty for straight lines.
    bends: Vec<T>,
}

/// At least two times, each after the one before.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Times(Vec<f64>);

impl Times {
    /// The times of `count` values, which messages call `what`.
    pub(super) fn new(times: Vec<f64>, what: &'static str, count: usize) -> Result<Self, Fault> {
        if count < 2 {
            return Err(Fault::wrong_count(what, "at least two", count));
        }
        if times.len() != count {
            let expected = format!("one number for each of the {count} {what}");
            let fault = Fault::wrong_count("times", &expected, times.len());
            return Err(Fault { kind: FaultKind::Times, ..fault });
        }
        times.iter().try_for_each(|time| check_number(*time))?;
        match times.windows(2).find(|pair| pair[0] >= pair[1]) {
            Some(pair) => {
                let cause = format!("the times do not ascend: {} follows {}", shown(pair[1]), shown(pair[0]));
                let cure = "give times of which each is larger than the one before";
                Err(Fault::new(FaultKind::Times, cause, cure))
            }
            None => Ok(Self(times)),
        }
    }

    /// All times, ascending.
    pub(super) fn all(&self) -> &[f64] {
        &self.0
    }

    /// Index of the last time up to `time`, at most the last but one, and the part of the way to the next
    /// time, 0 to 1.
    pub(super) fn place(&self, time: f64) -> (usize, f64) {
        let last = self.0.len() - 2;
        let before = self.0.partition_point(|own| *own <= time).saturating_sub(1).min(last);
        (before, ((time - self.0[before]) / self.step(before)).clamp(0.0, 1.0))
    }

    /// Time from that at `index` to the next.
    fn step(&self, index: usize) -> f64 {
        self.0[index + 1] - self.0[index]
    }
}

impl<T: Interpolable> TimeFunction<T> {
    /// The `values` at these `times`, which ascend; `what` names the values in messages.
    ///
    /// # Errors
    /// [`FaultKind::WrongCount`] for fewer than two values, [`FaultKind::Times`],
    /// [`FaultKind::NotFinite`] or [`FaultKind::OutOfRange`] for a time.
    pub fn new(what: &'static str, values: Vec<T>, times: Vec<f64>, curve: Curve) -> Result<Self, Fault> {
        let times = Times::new(times, what, values.len())?;
        let bends = match curve {
            Curve::Line => Vec::new(),
            Curve::Spline => bends(&values, &times),
        };
        Ok(Self { times, values, bends })
    }

    /// The times of the values.
    pub(crate) fn times(&self) -> &[f64] {
        self.times.all()
    }

    /// The value at a time; given values are met to the bit.
    pub(crate) fn at(&self, time: f64) -> T {
        let (before, s) = self.times.place(time);
        let r = 1.0 - s;
        let line = self.values[before] * r + self.values[before + 1] * s;
        match &self.bends[..] {
            [] => line,
            bends => {
                let scale = self.times.step(before).powi(2) / 6.0;
                let [low, high] = [r, s].map(|x| scale * x * (x * x - 1.0));
                line + bends[before] * low + bends[before + 1] * high
            }
        }
    }
}

/// Part of the time from one given value to the next within which a sign changes at a value that is 0: above
/// rounding. Chosen.
const AT_END: f64 = 1e-9;

impl TimeFunction<f64> {
    /// The times at which a spline through values that are not negative changes its sign, but for the given
    /// ones. It does so on parts between its extremes, where
    ///
    /// ```text
    /// dx/ds = b − a − h²/6 (2 M₀ + M₁) + h² M₀ s + h²/2 (M₁ − M₀) s² = 0 ;
    /// ```
    pub(crate) fn crossings(&self) -> Vec<f64> {
        let times = self.times();
        let pieces = self.bends.windows(2).zip(self.values.windows(2)).zip(times.windows(2));
        let of_piece = |((bends, values), ends): ((&[f64], &[f64]), &[f64])| {
            let step = ends[1] - ends[0];
            let [m0, m1] = [0, 1].map(|k| step * step * bends[k]);
            let slope = [values[1] - values[0] - (2.0 * m0 + m1) / 6.0, m0, 0.5 * (m1 - m0)];
            let extremes = roots(slope).into_iter().filter(|s| (0.0..1.0).contains(s));
            let inner = extremes.map(|s| ends[0] + s * step);
            let parts: Vec<f64> = [ends[0]].into_iter().chain(inner).chain([ends[1]]).collect();
            let crossing = |part: &[f64]| self.crossing([part[0], part[1]]);
            let is_inside = |time: &f64| ends.iter().all(|end| (time - end).abs() > AT_END * step);
            parts.windows(2).filter_map(crossing).filter(is_inside).collect::<Vec<_>>()
        };
        pieces.flat_map(of_piece).collect()
    }

    /// Time between two at which the function, monotone between them, changes its sign, by bisection; None if
    /// it does not.
    fn crossing(&self, [mut low, mut high]: [f64; 2]) -> Option<f64> {
        let is_negative = |time: f64| self.at(time) < 0.0;
        let before = is_negative(low);
        if before == is_negative(high) {
            return None;
        }
        // As many halvings as f64 has digits.
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = low.midpoint(high);
            let end = if is_negative(middle) == before { &mut low } else { &mut high };
            *end = middle;
        }
        Some(high)
    }
}

/// The real roots of c₀ + c₁ x + c₂ x², ascending.
fn roots([c0, c1, c2]: [f64; 3]) -> Vec<f64> {
    let discriminant = c1 * c1 - 4.0 * c0 * c2;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let sum = -0.5 * (c1 + discriminant.sqrt().copysign(c1));
    let mut roots = vec![sum / c2, c0 / sum];
    roots.retain(|root| root.is_finite());
    roots.sort_by(f64::total_cmp);
    roots
}

/// The second derivatives of the natural spline, by elimination in the tridiagonal system
///
/// ```text
/// h₀ M₀ + 2 (h₀ + h₁) M₁ + h₁ M₂ = 6 ((x₂ − x₁)/h₁ − (x₁ − x₀)/h₀) .
/// ```
fn bends<T: Interpolable>(values: &[T], times: &Times) -> Vec<T> {
    let count = values.len();
    let slope = |k: usize| (values[k + 1] - values[k]) * (1.0 / times.step(k));
    // M_k = rest_k − factor_k M_{k+1}.
    let (mut rest, mut factor) = (vec![T::default(); count], vec![0.0; count]);
    for k in 1..count - 1 {
        let (low, high) = (times.step(k - 1), times.step(k));
        let pivot = 2.0 * (low + high) - low * factor[k - 1];
        factor[k] = high / pivot;
        rest[k] = ((slope(k) - slope(k - 1)) * 6.0 - rest[k - 1] * low) * (1.0 / pivot);
    }
    for k in (1..count - 1).rev() {
        rest[k] = rest[k] - rest[k + 1] * factor[k];
    }
    rest
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;

    use super::*;

    fn time_function(values: &[f64], times: &[f64], curve: Curve) -> TimeFunction<f64> {
        TimeFunction::new("values", values.to_vec(), times.to_vec(), curve).expect("a track")
    }

    #[test]
    fn given_values_are_met_to_the_bit_and_kept_beyond_the_ends() {
        let (values, times) = ([0.1, -0.7, 0.3, 1e-9], [0.3, 0.7, 1.9, 2.0]);
        for curve in [Curve::Line, Curve::Spline] {
            let time_function = time_function(&values, &times, curve);
            for (value, time) in values.iter().zip(times) {
                assert_eq!(time_function.at(time), *value);
            }
            assert_eq!([time_function.at(-1.0), time_function.at(9.0)], [0.1, 1e-9]);
        }
    }

    #[test]
    fn a_line_runs_at_constant_speed_and_a_spline_through_its_points_is_that_line() {
        let (values, times) = ([1.0, 2.0, 5.0], [0.0, 1.0, 4.0]);
        for curve in [Curve::Line, Curve::Spline] {
            let time_function = time_function(&values, &times, curve);
            for k in 0..=40 {
                let time = 0.1 * f64::from(k);
                assert!((time_function.at(time) - (1.0 + time)).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_spline_is_the_cubic_that_is_natural() {
        // On [−1, 1] with a knot at 0, where its first two derivatives are continuous; the second is 0 at
        // both ends.
        let natural = |x: f64| 3.0 * x * x - x.abs().powi(3);
        let time_function = time_function(&[2.0, 0.0, 2.0], &[-1.0, 0.0, 1.0], Curve::Spline);
        for k in -10..=10 {
            let x = 0.1 * f64::from(k);
            assert!((time_function.at(x) - natural(x)).abs() < 1e-14, "{x}");
        }
    }

    #[test]
    fn speed_and_acceleration_of_a_spline_are_continuous() {
        let values = [[0.0, 1.0, 0.0], [0.4, 0.2, 0.1], [-0.3, 0.0, 2.0], [1.0, 1.0, 1.0]];
        let times = vec![0.0, 1.0, 1.5, 3.0];
        let values = values.map(DVec3::from_array).to_vec();
        let time_function = TimeFunction::new("points", values, times, Curve::Spline).expect("a track");
        let step = 1e-4;
        let speed =
            |time: f64| (time_function.at(time + step) - time_function.at(time - step)) / (2.0 * step);
        let bend = |time: f64| {
            (time_function.at(time + step) + time_function.at(time - step) - 2.0 * time_function.at(time))
                / step.powi(2)
        };
        for knot in [1.0, 1.5] {
            // Differences over 2e-4 see third derivatives, about 10, times 2e-4.
            let away = 1.5 * step;
            assert!(speed(knot - away).distance(speed(knot + away)) < 1e-2);
            assert!(bend(knot - away).distance(bend(knot + away)) < 2e-2);
        }
        for end in [0.0 + 1.5 * step, 3.0 - 1.5 * step] {
            assert!(bend(end).length() < 2e-2, "{}", bend(end));
        }
    }

    #[test]
    fn a_spline_crosses_zero_where_its_cubics_do() {
        // On [0, 3] through 1, 0, 0, 1: 0.6 (t² − ¼) about the middle, above 0 beside it.
        let dips = time_function(&[1.0, 0.0, 0.0, 1.0], &[0.0, 1.0, 2.0, 3.0], Curve::Spline);
        assert!(dips.crossings().is_empty(), "it changes its sign at given values");
        // Through ½, 0, 4, 0.5: M₁ of 4 M₁ + M₂ = 27, M₁ + 4 M₂ = −45.
        let [m1, m2] = [153.0 / 15.0, -207.0 / 15.0];
        let dips = time_function(&[0.5, 0.0, 4.0, 0.5], &[0.0, 1.0, 2.0, 3.0], Curve::Spline);
        let first = |s: f64| 0.5 * (1.0 - s) + (s.powi(3) - s) / 6.0 * m1;
        let last = |s: f64| 4.0 + s * (0.5 - 4.0) + ((1.0 - s).powi(3) - (1.0 - s)) / 6.0 * m2;
        let crossings = dips.crossings();
        assert!(crossings.len() == 1 && first(crossings[0]).abs() < 1e-14, "{crossings:?}");
        assert!((0..100).all(|k| last(0.01 * f64::from(k)) > 0.0));
        let line = time_function(&[1.0, 0.0, 1.0], &[0.0, 1.0, 2.0], Curve::Line);
        assert!(line.crossings().is_empty());
    }

    #[test]
    fn what_makes_no_track_is_told() {
        let new = |values: &[f64], times: &[f64]| {
            TimeFunction::new("points", values.to_vec(), times.to_vec(), Curve::Line)
        };
        let fault = |values: &[f64], times: &[f64]| new(values, times).expect_err("it is refused");
        assert_eq!(fault(&[1.0], &[0.0]), Fault::wrong_count("points", "at least two", 1));
        let count = fault(&[1.0, 2.0], &[0.0]);
        assert_eq!(count.to_string(), "times takes one number for each of the 2 points, found 1");
        assert_eq!(fault(&[1.0, 2.0], &[3.0, 2.0]).to_string(), "the times do not ascend: 2 follows 3");
        assert_eq!(fault(&[1.0, 2.0], &[3.0, 3.0]).to_string(), "the times do not ascend: 3 follows 3");
        for times in [[0.0, 0.0], [3.0, 2.0], [3.0, 3.0]] {
            assert_eq!(fault(&[1.0, 2.0], &times).kind, FaultKind::Times);
        }
        assert_eq!(fault(&[1.0, 2.0], &[3.0, f64::NAN]).kind, FaultKind::NotFinite);
    }
}
