//! A picture about to be taken, and its pixels.

use radiosity_scene::Camera;
use radiosity_work::Work;
use serde::{Deserialize, Serialize};

use super::eye::{Eye, SeenPlace};
use super::frame_light::FrameLight;
use super::frame_light::forecast::seconds;
use super::picture_light::PictureLight;
use super::pinhole::Pinhole;
use super::pixel_grid::PixelGrid;
use super::pixel_samples::PixelSamples;

/// The radiosity seen through a pixel.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Pixel {
    /// Mean of the shown quantity over the pixel, per band (W m⁻²).
    pub radiosity: Vec<f64>,
    /// Part of the pixel in which a front is seen.
    pub coverage: f64,
    /// Whether something that emits is seen in the pixel.
    pub emits: bool,
    /// Samples that are averaged, if they are more than the middle.
    pub samples: Option<PixelSamples>,
}

/// A picture about to be taken.
pub(super) struct Shot<'a> {
    /// Light of what is seen.
    pub light: &'a PictureLight<'a>,
    /// The surfaces that camera rays meet.
    pub eye: &'a Eye<'a>,
    /// The camera.
    pub view: Pinhole,
    /// Pixels across and down.
    pub size: [usize; 2],
    /// Points of a pixel that is sampled finely.
    pub grid: PixelGrid,
    /// The work that the picture is a part of.
    pub work: &'a Work<'a>,
}

impl<'a> Shot<'a> {
    /// The shot of `light` through a camera, with so many rays along each side of a pixel that is sampled finely.
    pub(super) fn through(
        camera: &Camera,
        light: &'a PictureLight<'a>,
        eye: &'a Eye<'a>,
        samples: u32,
        work: &'a Work<'a>,
    ) -> Self {
        let size = [camera.width as usize, camera.height as usize];
        Self { light, eye, view: Pinhole::new(camera), size, grid: PixelGrid::new(samples), work }
    }

    /// About the seconds that the picture takes two threads.
    pub(super) fn seconds(&self) -> f64 {
        let [width, height] = self.size;
        let seen = |pixel: usize| {
            let [column, row] = [pixel % width, pixel / width].map(|at| at as f64 + 0.5);
            self.eye.along(&self.view.ray(column, row))
        };
        seconds(self.light, width * height, &seen, self.work.ranks)
    }

    /// The pixel as its middle sees it.
    pub(super) fn middle(&self, lit: &FrameLight, pixel: usize) -> Pixel {
        let (Some(seen), Some(irradiance)) = (lit.frame().seen(pixel), lit.irradiance(pixel)) else {
            return self.nothing();
        };
        self.pixel(seen, irradiance)
    }

    /// A pixel that sees only this place, in this irradiance (W m⁻² per band).
    pub(super) fn pixel(&self, seen: &SeenPlace, irradiance: &[f64]) -> Pixel {
        let radiosity = self.light.shown(seen, irradiance.iter().copied());
        Pixel { radiosity, coverage: 1.0, emits: self.emits(seen), samples: None }
    }

    /// A pixel that sees nothing.
    pub(super) fn nothing(&self) -> Pixel {
        let radiosity = vec![0.0; self.light.solution().bands().len()];
        Pixel { radiosity, coverage: 0.0, emits: false, samples: None }
    }

    /// Whether the element of a place emits.
    fn emits(&self, seen: &SeenPlace) -> bool {
        self.light.solution().bands().iter().any(|band| band.coating.exitance[seen.element] > 0.0)
    }

    /// The pixel that averages these samples.
    pub(super) fn mean(&self, pixels: &[Pixel]) -> Pixel {
        let mut mean = self.nothing();
        let scale = 1.0 / pixels.len() as f64;
        for Pixel { radiosity, coverage, emits, .. } in pixels {
            mean.radiosity.iter_mut().zip(radiosity).for_each(|(sum, value)| *sum += scale * value);
            mean.coverage += scale * coverage;
            mean.emits |= emits;
        }
        let seen = pixels.iter().filter(|pixel| pixel.coverage > 0.0).map(|pixel| pixel.radiosity.clone());
        let samples = PixelSamples::new(seen.collect(), mean.radiosity.len(), pixels.len());
        Pixel { samples: Some(samples), ..mean }
    }
}
