//! The light that rays found, and how well it is known.
//!
//! A few sequences of rays, shifted independently, tell the standard deviation s of their mean,
//!
//! ```text
//! s = ( Σ_b (E_b − E)² / (n (n − 1)) )^½ + B/(4 n N)        W m⁻²
//! ```
//!
//! by n sequences of N rays with the means E_b. To it is added what one ray is worth, of something a quarter as bright
//! as the scene on the whole, of the mean radiosity B: sequences may agree by chance.

use std::ops::Range;

use radiosity_light::tolerances::DARK;
use radiosity_transport::tolerances::BATCHES;

use crate::gather::ray_count::MOST_SURFACES;
use crate::gather::read_irradiance::{Deviation, ReadIrradiance};
use crate::gather::walked_light::Scores;

/// Brightness of what one ray may have met or missed, over that of the scene on the whole. Chosen.
const ONE_RAY: f64 = 0.25;

/// Sums over sequences of rays that are independent of each other.
pub(super) struct Batches {
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
    pub(super) fn of(bands: usize) -> Self {
        Self { sums: vec![0.0; BATCHES * bands], bands, sent: 0, surfaces: 0, are_whole: true }
    }

    /// Sends `count` further rays of each sequence; `add` adds those of these indices of the sequence of this number.
    pub(super) fn send(&mut self, count: u64, add: impl Fn(u64, Range<u64>, &mut Scores)) {
        for (batch, sums) in self.sums.chunks_exact_mut(self.bands).enumerate() {
            let mut scores = Scores { sums, surfaces: 0, are_whole: true };
            add(batch as u64, self.sent..self.sent + count, &mut scores);
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

    /// The estimate by the sums.
    pub(super) fn estimate(&self, beside: &Beside) -> Estimate {
        let bands = self.bands;
        let (n, rays) = (BATCHES as f64, self.sent as f64);
        let mut found = Estimate {
            irradiance: Vec::with_capacity(bands),
            deviation: Deviation { relative: 0.0, absolute: 0.0, is_dark: false },
            missed: 0.0,
        };
        for (band, other) in beside.other.iter().enumerate() {
            let batches = || self.sums.iter().skip(band).step_by(bands).map(|sum| sum / rays);
            let mean = batches().sum::<f64>() / n;
            let square = batches().map(|batch| (batch - mean).powi(2)).sum::<f64>();
            let one = ONE_RAY * beside.scale[band] / (n * rays);
            let error = (square / (n * (n - 1.0))).sqrt() + one;
            let least = DARK * beside.scale[band];
            found.deviation.is_dark |= mean + other < least;
            found.deviation.relative += (error / (mean + other).max(least)).powi(2);
            found.deviation.absolute += error * error;
            found.missed += (error / (mean + other).max(beside.dark[band])).powi(2);
            found.irradiance.push(mean);
        }
        found.deviation.relative = (found.deviation.relative / bands as f64).sqrt();
        found.deviation.absolute = (found.deviation.absolute / bands as f64).sqrt();
        found.missed = (found.missed / bands as f64).sqrt();
        if !self.are_whole {
            (found.deviation.relative, found.deviation.absolute) = (f64::INFINITY, f64::INFINITY);
        }
        found
    }
}

impl From<Estimate> for ReadIrradiance {
    fn from(Estimate { irradiance, deviation, .. }: Estimate) -> Self {
        Self { irradiance, deviation: Some(deviation) }
    }
}
