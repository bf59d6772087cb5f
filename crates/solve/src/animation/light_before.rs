//! Light of the last frames, from which the next one starts.
//!
//! Where frames follow each other at equal steps of time, the next one starts from 2 y_n − y_{n−1}: its error
//! is that of the second difference, which is small beside the first where things move smoothly.

use crate::driver::Unknowns;

/// Relative difference of two steps of time that count as equal: roundings of moments.
const EQUAL: f64 = 1e-9;

/// Unknowns of the last two frames, and their moments.
#[derive(Debug, Default)]
pub(super) struct LightBefore {
    last: Option<TimedUnknowns>,
    earlier: Option<TimedUnknowns>,
}

/// Unknowns at a moment, which is none where nothing is known of the next one.
#[derive(Debug)]
struct TimedUnknowns {
    moment: Option<f64>,
    unknowns: Unknowns,
}

impl LightBefore {
    /// Unknowns for a frame to start from, at a moment if it has one; empty where there is no frame before.
    pub(super) fn start(&self, moment: Option<f64>) -> Unknowns {
        let Some(last) = &self.last else { return Unknowns::default() };
        let earlier = self.earlier.as_ref().filter(|earlier| continues(earlier, last, moment));
        let next = earlier.and_then(|earlier| last.unknowns.extrapolated(&earlier.unknowns));
        next.unwrap_or_else(|| last.unknowns.clone())
    }

    /// Takes the unknowns of the frame at a moment, if it has one.
    pub(super) fn take(&mut self, moment: Option<f64>, unknowns: Unknowns) {
        self.earlier = self.last.replace(TimedUnknowns { moment, unknowns });
    }
}

/// Whether a moment comes as long after `last` as that after `earlier`.
fn continues(earlier: &TimedUnknowns, last: &TimedUnknowns, moment: Option<f64>) -> bool {
    let steps = |a: Option<f64>, b: Option<f64>| Some(b? - a?);
    let (before, next) = (steps(earlier.moment, last.moment), steps(last.moment, moment));
    let are_equal = |(before, next): (f64, f64)| (before - next).abs() <= EQUAL * before.abs();
    before.zip(next).is_some_and(are_equal)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unknowns(value: f64) -> Unknowns {
        Unknowns::of(vec![vec![vec![value, 1.0]]])
    }

    #[test]
    fn what_moves_evenly_is_met_and_jumps_start_from_the_last_frame() {
        let mut light = LightBefore::default();
        assert_eq!(light.start(Some(0.0)), Unknowns::default());
        light.take(Some(0.0), unknowns(1.0));
        assert_eq!(light.start(Some(0.5)), unknowns(1.0));
        light.take(Some(0.5), unknowns(1.25));
        assert_eq!(light.start(Some(1.0)), unknowns(1.5));
        for other in [Some(0.75), Some(0.0), None] {
            assert_eq!(light.start(other), unknowns(1.25));
        }
    }
}
