//! The light that rays found, and how well it is known.
//!
//! A few sequences of rays, shifted independently, tell the standard deviation s of their mean,
//!
//! ```text
//! s = ( Σ_b (E_b − E)² / (n (n − 1)) )^½ + B/(4 n N)        W m⁻²
//! ```
//!
//! by n sequences of N rays with the means E_b. Parts of one sequence, one after the other, tell it too: together they
//! are as even as one, and err by less than as many independent ones (`Sequences`). To it is added what one ray is
//! worth, of something a quarter as bright as the scene on the whole, of the mean radiosity B: sequences may agree by
//! chance.

use std::ops::Range;

use radiosity_light::tolerances::DARK;
use radiosity_transport::tolerances::BATCHES;

use crate::gather::ray_count::MOST_SURFACES;
use crate::gather::read_irradiance::{Deviation, ReadIrradiance, Uncertainty};
use crate::gather::walked_light::Scores;

/// Brightness of what one ray may have met or missed, over that of the scene on the whole. Chosen.
const ONE_RAY: f64 = 0.25;

/// Light that rays miss which all see it, or none of them, over all that is seen, times their number: n rays miss a
/// part f with the probability (1 − f)ⁿ, and f (1 − f)ⁿ ≤ 1/(e n).
const MISSED: f64 = 0.37;

/// Standard deviation of the mean over parts of one sequence, over that which they would tell if they were independent.
/// Measured on pictures of 3 to 300 rotated rectangles in the unit square, each on its own brightness, by 128 to 1024
/// points: 0.42 to 0.88, the latter where rectangles are narrower than the points are apart.
const TOGETHER: f64 = 0.6;

/// How sequences of rays follow from each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sequences {
    /// Each is shifted on its own.
    Independent,
    /// Each is a part of one. Measured there: the mean errs by 1.4 to 1.8 times less, among 300 rectangles by 1.0 to
    /// 1.5 times. Only where the light that rays meet is known: what is chosen anew for each errs as before.
    OneAfterTheOther,
}

/// Sums over sequences of rays.
pub(super) struct Batches {
    sequences: Sequences,
    /// Irradiance times the number of rays (W m⁻²), bands fastest.
    sums: Vec<f64>,
    bands: usize,
    /// Rays of each sequence.
    sent: u64,
    /// Surfaces that walks came to.
    surfaces: u64,
    /// Whether no walk was given up.
    are_whole: bool,
}

/// Light of a band.
pub(super) struct BandLight {
    /// Irradiance (W m⁻²).
    irradiance: f64,
    /// Its standard deviation (W m⁻²).
    pub(super) error: f64,
}

/// Irradiance per band (W m⁻²) that errors are judged by.
pub(super) struct Beside<'s> {
    /// Mean radiosity of the scene.
    pub(super) scale: &'s [f64],
    /// Irradiance relative to which errors are to be small where less arrives.
    pub(super) dark: &'s [f64],
    /// Light that arrives too.
    pub(super) other: &'s [f64],
}

/// Light by the rays that were sent so far.
pub(super) struct Estimate {
    /// Irradiance per band (W m⁻²).
    irradiance: Vec<f64>,
    deviation: Deviation,
    /// Deviation relative to the irradiance, or to what counts as dark, which decides whether it is small enough.
    pub(super) missed: f64,
}

impl Batches {
    /// No rays yet, of so many bands.
    pub(super) fn of(sequences: Sequences, bands: usize) -> Self {
        Self { sequences, sums: vec![0.0; BATCHES * bands], bands, sent: 0, surfaces: 0, are_whole: true }
    }

    /// Sends `count` further rays of each sequence; `add` adds those of these indices of a sequence that a number
    /// chooses, which follows from `number`.
    pub(super) fn send(&mut self, number: u64, count: u64, add: impl Fn(u64, Range<u64>, &mut Scores)) {
        for (batch, sums) in (0..).zip(self.sums.chunks_exact_mut(self.bands)) {
            let mut scores = Scores { sums, surfaces: 0, are_whole: true };
            let (number, first) = match self.sequences {
                Sequences::Independent => (number.wrapping_add(batch), self.sent),
                Sequences::OneAfterTheOther => (number, BATCHES as u64 * self.sent + batch * count),
            };
            add(number, first..first + count, &mut scores);
            self.surfaces += scores.surfaces;
            self.are_whole &= scores.are_whole;
        }
        self.sent += count;
    }

    /// Rays of each sequence.
    pub(super) fn sent(&self) -> u64 {
        self.sent
    }

    /// Whether as many again would be more than `most`, or walks came to many surfaces, or did not end.
    pub(super) fn are_last(&self, most: u64) -> bool {
        BATCHES as u64 * 2 * self.sent > most || 2 * self.surfaces > MOST_SURFACES || !self.are_whole
    }

    /// Light whose irradiance the sums are, among surfaces of the mean radiosity `scale` per band (W m⁻²).
    pub(super) fn light(&self, scale: &[f64]) -> Vec<BandLight> {
        let rays = self.sent as f64;
        let of = |(band, scale): (usize, &f64)| {
            let (irradiance, deviation) = self.mean(self.each(band).map(|sum| sum / rays));
            BandLight { irradiance, error: deviation + ONE_RAY * scale / (BATCHES as f64 * rays) }
        };
        scale.iter().enumerate().map(of).collect()
    }

    /// Light of which the sums tell a part, those of the first bands over those of the last, of the `whole` per band
    /// (W m⁻²).
    pub(super) fn part_of(&self, whole: &[f64]) -> Vec<BandLight> {
        let bands = whole.len();
        let of = |(band, whole): (usize, &f64)| {
            let part = |[seen, all]: [f64; 2]| if all > 0.0 { seen / all } else { 0.0 };
            let sums = || self.each(band).zip(self.each(band + bands));
            let each = sums().map(|(seen, all)| part([seen, all]));
            let (_, deviation) = self.mean(each);
            let pooled = part([sums().map(|own| own.0).sum(), sums().map(|own| own.1).sum()]);
            let missed = MISSED / (BATCHES as f64 * self.sent as f64);
            BandLight { irradiance: pooled * whole, error: (deviation + missed) * whole }
        };
        whole.iter().enumerate().map(of).collect()
    }

    /// The sums of the sequences in a band.
    fn each(&self, band: usize) -> impl Iterator<Item = f64> + Clone {
        self.sums.iter().skip(band).step_by(self.bands).copied()
    }

    /// The mean of what the sequences found, and its standard deviation.
    fn mean(&self, each: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
        let n = BATCHES as f64;
        let mean = each.clone().sum::<f64>() / n;
        let squares = each.map(|own| (own - mean).powi(2)).sum::<f64>();
        let spread = match self.sequences {
            Sequences::Independent => 1.0,
            Sequences::OneAfterTheOther => TOGETHER,
        };
        (mean, spread * (squares / (n * (n - 1.0))).sqrt())
    }

    /// Whether no walk was given up.
    pub(super) fn are_whole(&self) -> bool {
        self.are_whole
    }
}

impl BandLight {
    /// The light of both, which are found apart.
    pub(super) fn and(&self, other: &Self) -> Self {
        Self { irradiance: self.irradiance + other.irradiance, error: self.error.hypot(other.error) }
    }
}

impl Estimate {
    /// The light of all bands; not known at all unless all walks `are_whole`.
    pub(super) fn of(light: &[BandLight], beside: &Beside, are_whole: bool) -> Self {
        let bands = light.len() as f64;
        let mut found = Self {
            irradiance: Vec::with_capacity(light.len()),
            deviation: Deviation { relative: 0.0, absolute: 0.0, is_dark: false },
            missed: 0.0,
        };
        for (band, (BandLight { irradiance, error }, other)) in light.iter().zip(beside.other).enumerate() {
            let all = irradiance + other;
            let least = DARK * beside.scale[band];
            found.deviation.is_dark |= all < least;
            found.deviation.relative += (error / all.max(least)).powi(2);
            found.deviation.absolute += error * error;
            found.missed += (error / all.max(beside.dark[band])).powi(2);
            found.irradiance.push(*irradiance);
        }
        found.deviation.relative = (found.deviation.relative / bands).sqrt();
        found.deviation.absolute = (found.deviation.absolute / bands).sqrt();
        found.missed = (found.missed / bands).sqrt();
        if !are_whole {
            (found.deviation.relative, found.deviation.absolute) = (f64::INFINITY, f64::INFINITY);
        }
        found
    }
}

impl From<Estimate> for ReadIrradiance {
    fn from(Estimate { irradiance, deviation, .. }: Estimate) -> Self {
        Self { irradiance, uncertainty: Uncertainty { deviation: Some(deviation), doubt: 0.0 } }
    }
}

#[cfg(test)]
mod tests {
    use radiosity_elements::sampling::kronecker;
    use radiosity_elements::sampling::shift::{shift, shifted};

    use super::*;

    /// The part of the unit square below a slanted line, 0.5, by 8 × 32 points: root mean square errors of the means,
    /// and of what is told, over 400 numbers.
    fn errors(sequences: Sequences) -> [f64; 2] {
        let beside = Beside { scale: &[0.0], dark: &[1e-9], other: &[0.0] };
        let squares = (0..400).map(|trial| {
            let mut batches = Batches::of(sequences, 1);
            for count in [16, 16] {
                batches.send(1000 * trial, count, |number, indices, scores| {
                    let offset: [f64; 2] = shift(number);
                    let points = indices.map(|index| shifted(kronecker::point::<2>(index), &offset));
                    scores.sums[0] += points.filter(|[x, y]| 0.7 * x + y < 0.85).count() as f64;
                });
            }
            let Estimate { irradiance, deviation, .. } = Estimate::of(&batches.light(&[0.0]), &beside, true);
            [irradiance[0] - 0.5, deviation.absolute].map(|error| error * error)
        });
        let sums = squares.fold([0.0; 2], |sums, own| [sums[0] + own[0], sums[1] + own[1]]);
        sums.map(|sum| (sum / 400.0_f64).sqrt())
    }

    #[test]
    fn parts_of_one_sequence_err_less_and_tell_so() {
        let [independent, together] = [Sequences::Independent, Sequences::OneAfterTheOther].map(errors);
        assert!(together[0] < independent[0] / 1.4, "{together:?} {independent:?}");
        for [error, told] in [independent, together] {
            assert!((0.5..2.0).contains(&(told / error)), "{told} {error}");
        }
    }
}
