//! The balance of power: emitted power is absorbed or lost; see [`crate::checks`].

use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_light::first_bounce::{Bounce, DirectLightEntry};
use radiosity_transport::Carrier;

use crate::solution::powers::Powers;
use crate::system::Coefficients;

/// Losses of the radiosity that blocks carry.
#[derive(Debug)]
pub(crate) struct Balance {
    starts: Vec<usize>,
    /// c, the coefficients of the constant 1.
    ones: Vec<f64>,
    /// c − Gᵀ c.
    lost: Vec<f64>,
}

/// The light of one band, whose balance is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BandLight<'a> {
    /// Reflectance and exitance.
    pub coating: &'a Coating,
    /// Flux of the luminaires (W).
    pub flux: f64,
    /// Coefficients of the solution in one band.
    pub coefficients: &'a Coefficients,
}

impl Balance {
    /// The balance of the `blocks` between `elements`.
    pub(crate) fn of(elements: &Elements, blocks: &dyn Carrier) -> Self {
        let ones = elements.constant();
        let kept = blocks.apply_transposed(&ones);
        let lost = ones.iter().zip(&kept).map(|(c, gc)| c - gc).collect();
        Self { starts: blocks.starts().to_vec(), ones, lost }
    }

    /// Powers, summed over the bands of `light` with compensation, since their balance is a check; direct
    /// light entered by `entry`.
    pub(crate) fn powers(&self, light: &[BandLight<'_>], entry: &DirectLightEntry) -> Powers {
        let mut sums = [Compensated::default(); 3];
        for (index, BandLight { coating, flux, coefficients }) in light.iter().enumerate() {
            let Coefficients { irradiance, radiosity, waiting, .. } = coefficients;
            let waits = |k: usize| waiting.as_ref().map_or(0.0, |waiting| waiting[k]);
            sums[0].add(*flux);
            // What of it arrives is taken off below.
            sums[2].add(*flux);
            let exitance = coating.emitted(&self.starts, &self.ones);
            let scattered = coating.reflected(&self.starts, irradiance);
            let beside = match entry {
                DirectLightEntry::Split(Bounce { direct, .. }) => {
                    coating.reflected(&self.starts, &direct[index])
                }
                _ => Vec::new(),
            };
            for (k, (one, lost)) in self.ones.iter().zip(&self.lost).enumerate() {
                sums[0].add(exitance[k] * one);
                sums[1].add(one * (irradiance[k] - scattered[k]));
                match entry {
                    DirectLightEntry::Carried => sums[2].add((radiosity[k] - waits(k)) * lost),
                    DirectLightEntry::Lit(lit) => {
                        sums[2].add((radiosity[k] - waits(k)) * lost);
                        sums[2].add(-one * lit[index][k]);
                    }
                    DirectLightEntry::Arrived(direct) => {
                        sums[2].add(one * (exitance[k] - direct[index][k]));
                        sums[2].add((scattered[k] - waits(k)) * lost);
                    }
                    DirectLightEntry::Split(Bounce { direct, reflected, .. }) => {
                        let (direct, once) = (direct[index][k], reflected[index][k]);
                        sums[2].add(one * (exitance[k] - direct));
                        sums[2].add(one * (beside[k] - once));
                        sums[2].add((scattered[k] - beside[k] - waits(k)) * lost);
                    }
                }
            }
        }
        let [emitted, absorbed, lost] = sums.map(|sum| sum.total + sum.rest);
        Powers { emitted, absorbed, lost }
    }
}

/// A sum with Neumaier's compensation.
#[derive(Clone, Copy, Default)]
struct Compensated {
    total: f64,
    rest: f64,
}

impl Compensated {
    fn add(&mut self, x: f64) {
        let sum = self.total + x;
        self.rest +=
            if self.total.abs() >= x.abs() { (self.total - sum) + x } else { (x - sum) + self.total };
        self.total = sum;
    }
}
