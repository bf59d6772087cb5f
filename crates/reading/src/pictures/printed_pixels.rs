//! Pixels of a picture as readings that a referee checks.
//!
//! Those that see one surface from corner to corner are judged: at edges a pixel holds as many samples as
//! were asked for, which errs by more than light does. What a lamp emits is known, and is left out: it would
//! outshine the errors of all the rest.

use radiosity_audit::{Pixel, Spot, evenly};
use radiosity_scene::{Camera, Scene};
use radiosity_solve::gather::read_irradiance::Uncertainty;
use radiosity_visibility::Visibility;

use super::frame_light::forecast::nodes;
use super::picture_light::GATHERED_FOR_PICTURES;
use super::pinhole::Pinhole;
use super::raster::Raster;
use crate::checked_readings::PrintedReading;
use crate::own_error::OwnError;
use crate::quality::{Quality, ReadSettings};
use crate::reader::ReadMode;

/// Places of a pixel that have to see the same surface: its corners and its middle.
const PLACES: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 0.5]];

/// Pixels that are looked at, of which about 64 are judged. Chosen: a quarter of most pictures is of plain
/// pixels.
const LOOKED_AT: usize = 256;

/// A picture of radiosity whose pixels are readings.
#[derive(Debug)]
pub struct PrintedPixels<'a> {
    raster: &'a Raster,
    camera: &'a Camera,
    scene: &'a Scene,
    visibility: &'a Visibility,
    view: Pinhole,
    own: OwnError,
    /// Places in row order of the pixels that may be judged, with their surfaces.
    judged: Vec<(usize, usize)>,
}

impl<'a> PrintedPixels<'a> {
    /// The pixels of a picture of `scene` through `camera`, with own estimates of their errors.
    pub fn of(
        raster: &'a Raster,
        camera: &'a Camera,
        scene: &'a Scene,
        visibility: &'a Visibility,
        own: OwnError,
    ) -> Self {
        let all = raster.coverage().len();
        let pixels =
            Self { raster, camera, scene, visibility, view: Pinhole::new(camera), own, judged: Vec::new() };
        let chosen = evenly(0..all, all, LOOKED_AT, 0);
        let judged = chosen.filter_map(|pixel| Some((pixel, pixels.surface(pixel)?))).collect();
        Self { judged, ..pixels }
    }

    /// About the number of points at which the light of the picture was gathered.
    pub fn gathered_points(&self) -> usize {
        nodes(self.raster.coverage().len() as f64) as usize
    }

    /// Number of readings.
    pub fn count(&self) -> usize {
        self.judged.len()
    }

    /// One of the readings.
    pub fn reading(&self, number: usize) -> Option<PrintedReading> {
        let (pixel, surface) = *self.judged.get(number)?;
        let [column, row] = self.place(pixel);
        let printed = self.raster.pixels().nth(pixel)?.to_vec();
        Some(PrintedReading {
            spot: Spot::Pixel(Pixel::of(self.camera, column, row)),
            own: self.own.of_reading(&printed, Uncertainty::default()),
            printed,
            printed_groups: Vec::new(),
            class: self.scene.surfaces[surface].name.clone(),
        })
    }

    /// Column and row of a pixel.
    fn place(&self, pixel: usize) -> [u32; 2] {
        let [width, pixel] = [self.camera.width, pixel as u32];
        [pixel % width, pixel / width]
    }

    /// The surface that is seen from corner to corner, if it is one that emits nothing.
    fn surface(&self, pixel: usize) -> Option<usize> {
        let [x, y] = self.place(pixel).map(f64::from);
        let seen = |[s, t]: [f64; 2]| {
            let front = self.visibility.nearest(&self.view.ray(x + s, y + t))?;
            front.front.then_some(front.surface)
        };
        let first = seen(PLACES[0])?;
        let is_plain = PLACES.iter().all(|place| seen(*place) == Some(first));
        (is_plain && !self.scene.surfaces[first].material.emits()).then_some(first)
    }
}

/// Settings by which light of pictures and textures is read from `read`.
pub fn settings_of_pictures(read: ReadMode) -> ReadSettings {
    ReadSettings { read, eps: GATHERED_FOR_PICTURES, ..Quality::Default.reading() }
}
