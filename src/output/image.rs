//! Photographs: linear light in three channels, exposed to sRGB.

use super::picture::Picture;
use super::raster::Raster;

/// A picture in linear light, red, green and blue per pixel, rows from the top.
#[derive(Clone, Debug)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Vec<[f64; 3]>,
}

impl Image {
    /// The colours of radiosities times `balance`: three bands are red, green and blue; others are averaged to grey.
    pub fn new(raster: &Raster, balance: [f64; 3]) -> Self {
        let colour = |values: &[f64]| match *values {
            [red, green, blue] => [red * balance[0], green * balance[1], blue * balance[2]],
            _ => [values.iter().sum::<f64>() / values.len() as f64; 3],
        };
        let [width, height] = raster.size();
        Self { width, height, pixels: raster.pixels().map(colour).collect() }
    }

    /// Exposure that brings the brightest fiftieth of the non-black pixels to white: 1 over the 98th percentile of
    /// their largest channel; 1 for a black picture.
    pub fn automatic_exposure(&self) -> f64 {
        let mut levels: Vec<f64> =
            self.pixels.iter().map(|p| p.iter().copied().fold(0.0, f64::max)).filter(|x| *x > 0.0).collect();
        if levels.is_empty() {
            return 1.0;
        }
        levels.sort_by(f64::total_cmp);
        1.0 / levels[(levels.len() - 1) * 98 / 100]
    }

    /// The pixels times `exposure` as sRGB, clipped at white.
    pub fn exposed(&self, exposure: f64) -> Picture {
        let pixels = self.pixels.iter().map(|pixel| pixel.map(|x| quantise(x * exposure))).collect();
        Picture::new(self.width, self.height, pixels)
    }
}

/// Linear light in [0, 1], clipped, to the sRGB code (IEC 61966-2-1).
fn quantise(linear: f64) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_ends_and_middle() {
        assert_eq!(quantise(-1.0), 0);
        assert_eq!(quantise(0.0), 0);
        assert_eq!(quantise(1.0), 255);
        assert_eq!(quantise(7.0), 255);
        assert_eq!(quantise(0.5), 188);
        assert_eq!(quantise(0.003), 10);
    }
}
