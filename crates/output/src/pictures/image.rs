//! Photographs: linear light in three channels, exposed to sRGB.
//!
//! A pixel with several samples is the mean of their colours on the screen, not the colour of their mean.
//! Codes are dithered (`dither`), all channels alike, so that grey stays grey.

use super::dither::dither;
use super::tone::Tone;
use crate::drawings::picture::Picture;
use radiosity_reading::exposure::Exposure;
use radiosity_reading::pictures::pixel_samples::PixelSamples;
use radiosity_reading::pictures::raster::Raster;

/// A raster seen as linear light, red, green and blue.
#[derive(Clone, Copy, Debug)]
pub struct Image<'a> {
    raster: &'a Raster,
    balance: [f64; 3],
}

impl<'a> Image<'a> {
    /// The colours of radiosities times `balance`: three bands are red, green and blue; others are averaged
    /// to grey.
    pub fn new(raster: &'a Raster, balance: [f64; 3]) -> Self {
        Self { raster, balance }
    }

    /// Exposure that brings the brightest fiftieth of what is lit to white: 1 over the 98th percentile of the
    /// largest channel of the pixels that are not black and see nothing that emits, or of all that are not
    /// black where there are no others; 1 for a black picture.
    pub fn automatic_exposure(&self) -> Exposure {
        let largest = |values: &[f64]| self.colour(values).into_iter().fold(0.0, f64::max);
        let all = self.raster.pixels().map(largest).enumerate().filter(|(_, level)| *level > 0.0);
        let (emitters, lit): (Vec<_>, Vec<_>) = all.partition(|(pixel, _)| self.raster.sees_emitter(*pixel));
        let counted = if lit.is_empty() { emitters } else { lit };
        let mut levels: Vec<f64> = counted.into_iter().map(|(_, level)| level).collect();
        levels.sort_by(f64::total_cmp);
        let white = levels.len().checked_sub(1).map_or(1.0, |last| levels[last * 98 / 100]);
        Exposure::automatic(1.0 / white)
    }

    /// The pixels as sRGB: at an exposure that was chosen with a soft approach to white, at one that was asked
    /// for in proportion.
    pub fn exposed(&self, exposure: Exposure) -> Picture {
        let tone = if exposure.is_automatic() { Tone::Shoulder } else { Tone::Linear };
        let [width, height] = self.raster.size();
        let exposed = |x: f64| (x * exposure.factor()).max(0.0);
        let shown = |values: &[f64]| tone.shown(self.colour(values).map(exposed));
        let pixel = |(index, values): (usize, &[f64])| {
            let light =
                self.raster.samples(index).map_or_else(|| shown(values), |several| mean(several, shown));
            let [column, row] = [index as u32 % width, index as u32 / width];
            let dither = dither(column, row);
            light.map(|x| code(x, dither))
        };
        Picture::new(width, height, self.raster.pixels().enumerate().map(pixel).collect())
    }

    fn colour(&self, values: &[f64]) -> [f64; 3] {
        match *values {
            [red, green, blue] => [red * self.balance[0], green * self.balance[1], blue * self.balance[2]],
            _ => [values.iter().sum::<f64>() / values.len() as f64; 3],
        }
    }
}

/// The mean of the colours of all parts of a pixel; what sees nothing is black.
fn mean(samples: &PixelSamples, shown: impl Fn(&[f64]) -> [f64; 3]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for part in samples.parts() {
        sum.iter_mut().zip(shown(&part.radiosity)).for_each(|(sum, x)| *sum += part.share * x);
    }
    sum
}

/// The sRGB code of linear light up to 1, rounded up where what lies between two is above 1 − `dither`.
fn code(linear: f64, dither: f64) -> u8 {
    (255.0 * encoded(linear) + dither) as u8
}

/// Linear light, cut off at 1, as sRGB encodes it (IEC 61966-2-1).
fn encoded(linear: f64) -> f64 {
    match linear {
        x if x <= 0.003_130_8 => 12.92 * x,
        x if x < 1.0 => 1.055 * x.powf(1.0 / 2.4) - 0.055,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    /// Both tones, white at 1.
    fn both() -> [Exposure; 2] {
        [Exposure::fixed(1.0), Exposure::automatic(1.0)]
    }

    /// A grey picture of these radiosities, one pixel high.
    fn strip(values: &[f64]) -> Raster {
        let bands = vec!["grey".to_owned()];
        Raster::new([values.len() as u32, 1], bands, values.to_vec(), vec![1.0; values.len()])
    }

    fn codes(raster: &Raster, exposure: Exposure) -> Vec<u8> {
        let picture = Image::new(raster, [1.0; 3]).exposed(exposure);
        (0..raster.size()[0] as i32).map(|x| picture.at(x, 0).expect("it is inside")[0]).collect()
    }

    #[test]
    fn srgb_ends_and_middle() {
        let nearest = |linear: f64| code(linear, 0.5);
        assert_eq!([0.0, 0.003, 0.5, 1.0, 7.0].map(nearest), [0, 10, 188, 255, 255]);
    }

    #[test]
    fn greys_below_the_knee_are_in_proportion() {
        let greys: Vec<f64> = (0..160).map(|k| f64::from(k) / 200.0).collect();
        for exposure in both() {
            for (code, grey) in codes(&strip(&greys), exposure).into_iter().zip(&greys) {
                assert!((f64::from(code) - 255.0 * encoded(*grey)).abs() < 1.0, "{grey}: {code}");
            }
        }
    }

    /// Walls below 0.5 and a lamp of 100 that fills a tenth of the picture: the walls decide, and the lamp where
    /// it is all that is seen, or where nobody knows that it emits.
    #[test]
    fn what_emits_does_not_count_in_the_exposure() {
        let values: Vec<f64> = (0..100).map(|k| if k < 10 { 100.0 } else { f64::from(k) / 200.0 }).collect();
        let raster = strip(&values);
        let factor = |raster: &Raster| Image::new(raster, [1.0; 3]).automatic_exposure().factor();
        let lamp: Vec<bool> = values.iter().map(|x| *x > 1.0).collect();
        // Of 90 walls, those after the place 89 · 98 / 100 are brighter than white.
        assert_eq!(factor(&raster.clone().with_emitters(lamp)), 1.0 / (f64::from(10 + 87) / 200.0));
        assert_eq!(factor(&raster.clone().with_emitters(vec![true; 100])), 0.01);
        assert_eq!(factor(&raster), 0.01);
        assert_eq!(factor(&strip(&[0.0; 4])), 1.0);
    }

    #[test]
    fn flat_patches_keep_their_mean() {
        const SIDE: u32 = 64;
        let flat = |value: f64| {
            let count = (SIDE * SIDE) as usize;
            Raster::new([SIDE; 2], vec!["grey".to_owned()], vec![value; count], vec![1.0; count])
        };
        let picture = |value: f64| Image::new(&flat(value), [1.0; 3]).exposed(Exposure::fixed(1.0));
        for value in [0.01, 0.1234, 0.3, 0.5004, 0.77, 0.999] {
            let picture = picture(value);
            let codes = (0..SIDE as i32).flat_map(|y| (0..SIDE as i32).map(move |x| [x, y]));
            let codes = codes.map(|[x, y]| picture.at(x, y).expect("it is inside"));
            let sum: f64 =
                codes.inspect(|c| assert!(c[0] == c[1] && c[1] == c[2])).map(|c| f64::from(c[0])).sum();
            let mean = sum / f64::from(SIDE * SIDE);
            assert!((mean - 255.0 * encoded(value)).abs() < 0.05, "{value}: {mean}");
        }
        assert_eq!(picture(0.0), Picture::filled(SIDE, SIDE, [0; 3]));
        assert_eq!(picture(1.0), Picture::filled(SIDE, SIDE, [255; 3]));
    }

    /// A lamp that is 100 times as bright as white covers a third of the pixel in the middle.
    #[test]
    fn edges_of_lamps_lie_between_their_sides() {
        const LAMP: f64 = 100.0;
        const WALL: f64 = 0.2;
        let seen = [LAMP, LAMP, LAMP, WALL, WALL, WALL, WALL, WALL, WALL].map(|x| vec![x]).to_vec();
        let raster = strip(&[WALL, (LAMP + 2.0 * WALL) / 3.0, LAMP]);
        let several = BTreeMap::from([(1, PixelSamples::new(seen, 1, 9))]);
        for exposure in both() {
            assert_eq!(codes(&raster, exposure)[1..], [255, 255], "the mean alone is burnt out");
            let [wall, edge, lamp] = codes(&raster.clone().with_samples(several.clone()), exposure)[..]
            else {
                panic!("three pixels");
            };
            let expected = 255.0 * encoded((1.0 + 2.0 * WALL) / 3.0);
            assert!((f64::from(edge) - expected).abs() <= 1.0, "{edge}: {expected}");
            assert!(wall < edge && edge < lamp && lamp == 255, "{wall} {edge} {lamp}");
        }
    }
}
