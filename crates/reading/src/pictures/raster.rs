//! A raster: the radiosity seen through every pixel, per band, in linear light.

use std::collections::BTreeMap;

use super::pixel_samples::PixelSamples;
use crate::field::Field;

/// Radiosities (W m⁻²) per pixel and band, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    width: u32,
    height: u32,
    bands: Vec<String>,
    /// Pixel by pixel, bands fastest.
    values: Vec<f64>,
    /// Part of each pixel in which a front is seen.
    coverage: Vec<f64>,
    /// Samples of the pixels that average several, by their places in row order.
    samples: BTreeMap<usize, PixelSamples>,
    /// Whether something that emits is seen in each pixel; empty where that is not known.
    emitters: Vec<bool>,
}

impl Raster {
    /// Radiosities of `bands` in row order from the top left, bands fastest, and for each pixel the part of
    /// it in which the front of a surface is seen. The radiosities are means over the whole pixel.
    ///
    /// # Panics
    /// If there are not `width · height` coverages or not as many values times bands.
    pub fn new([width, height]: [u32; 2], bands: Vec<String>, values: Vec<f64>, coverage: Vec<f64>) -> Self {
        assert_eq!(coverage.len(), width as usize * height as usize, "one coverage per pixel");
        assert_eq!(values.len(), coverage.len() * bands.len(), "one value per pixel and band");
        Self { width, height, bands, values, coverage, samples: BTreeMap::new(), emitters: Vec::new() }
    }

    /// The raster with the samples of pixels that average several, by their places in row order.
    #[must_use]
    pub fn with_samples(self, samples: BTreeMap<usize, PixelSamples>) -> Self {
        Self { samples, ..self }
    }

    /// The raster with what is known of emitters: whether each pixel, in row order, sees something that emits.
    ///
    /// # Panics
    /// If there is not one entry per pixel.
    #[must_use]
    pub fn with_emitters(self, emitters: Vec<bool>) -> Self {
        assert_eq!(emitters.len(), self.coverage.len(), "one entry per pixel");
        Self { emitters, ..self }
    }

    /// Pixels across and down.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Names of the bands.
    pub fn bands(&self) -> &[String] {
        &self.bands
    }

    /// Radiosities per band of every pixel, in row order.
    pub fn pixels(&self) -> impl Iterator<Item = &[f64]> {
        self.values.chunks_exact(self.bands.len())
    }

    /// The samples that the pixel at a place in row order averages, if it averages several.
    pub fn samples(&self, pixel: usize) -> Option<&PixelSamples> {
        self.samples.get(&pixel)
    }

    /// Whether something that emits is known to be seen in the pixel at a place in row order.
    pub fn sees_emitter(&self, pixel: usize) -> bool {
        self.emitters.get(pixel).copied().unwrap_or(false)
    }

    /// Part of each pixel in which a front is seen, in row order.
    pub fn coverage(&self) -> &[f64] {
        &self.coverage
    }

    /// One number per pixel: the radiosity of one band, or the mean of all, of the surfaces seen there.
    ///
    /// # Panics
    /// If there is no such band.
    pub fn field(&self, band: Option<usize>) -> Field {
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let one = |values: &[f64]| band.map_or_else(|| mean(values), |band| values[band]);
        let seen = |(values, coverage): (&[f64], &f64)| one(values) / coverage;
        let values = self.pixels().zip(&self.coverage).map(seen).collect();
        Field::new(self.size(), values, self.coverage.clone())
    }
}
