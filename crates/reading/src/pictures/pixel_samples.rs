//! The samples of one pixel that averages several.
//!
//! A raster holds their mean. A photograph needs them apart: where a lamp ends within a pixel, the mean is as
//! bright as the lamp once it is cut off at white, and edges become stairs. Of more than 16, sorted by
//! brightness, groups of about equal numbers are averaged: such samples look alike.

use serde::{Deserialize, Serialize};

/// Most values that are kept. Chosen: lamps end in steps of a sixteenth at worst.
const MOST: usize = 16;

/// Radiosities (W m⁻²) seen through parts of a pixel, in 32 bits; nothing is seen through the rest of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PixelSamples {
    bands: usize,
    /// Of each part its share in the pixel, then its radiosity per band.
    parts: Box<[f32]>,
}

/// A part of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelPart {
    /// Its share in the pixel.
    pub share: f64,
    /// Radiosity seen through the part (W m⁻²), per band.
    pub radiosity: Vec<f64>,
}

impl PixelSamples {
    /// The samples of a pixel of so many `bands`, `count` in all, of which some have `seen` these
    /// radiosities.
    pub fn new(mut seen: Vec<Vec<f64>>, bands: usize, count: usize) -> Self {
        let brightness = |sample: &Vec<f64>| sample.iter().sum::<f64>();
        seen.sort_by(|a, b| brightness(a).total_cmp(&brightness(b)));
        let part = |group: &[Vec<f64>]| {
            let mean =
                |band: usize| group.iter().map(|sample| sample[band]).sum::<f64>() / group.len() as f64;
            let share = group.len() as f64 / count as f64;
            [share].into_iter().chain((0..bands).map(mean)).map(|x| x as f32).collect::<Vec<f32>>()
        };
        let parts = seen.chunks(count.div_ceil(MOST)).flat_map(part).collect();
        Self { bands, parts }
    }

    /// The parts through which something is seen.
    pub fn parts(&self) -> impl Iterator<Item = PixelPart> {
        self.parts.chunks_exact(1 + self.bands).map(|part| PixelPart {
            share: f64::from(part[0]),
            radiosity: part[1..].iter().copied().map(f64::from).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_parts_keep_the_mean_and_the_ends() {
        for side in [1, 3, 4, 5, 64] {
            let count: usize = side * side;
            let seen: Vec<Vec<f64>> =
                (0..count - count / 4).map(|k| vec![(k * 7 % count) as f64, 1.0]).collect();
            let sum = |band: usize| seen.iter().map(|sample| sample[band]).sum::<f64>() / count as f64;
            let expected = [sum(0), sum(1)];
            let samples = PixelSamples::new(seen, 2, count);
            let parts: Vec<PixelPart> = samples.parts().collect();
            assert!(parts.len() <= MOST, "{side}: {}", parts.len());
            for (band, expected) in expected.into_iter().enumerate() {
                let found: f64 = parts.iter().map(|part| part.share * part.radiosity[band]).sum();
                assert!((found - expected).abs() <= 1e-6 * expected, "{side}: {found}");
            }
        }
        assert_eq!(PixelSamples::new(Vec::new(), 2, 9).parts().count(), 0);
    }
}
