//! Pictures of frames that follow each other, with reflected light that they share.
//!
//! Frames are taken in stretches: all of a stretch are solved before the first picture. Light is gathered at spots
//! of the light field (`light_field`) in some frames of the stretch, and follows from these in others (`stretch`).
//! Direct light and what cameras see are found in each frame. What is told of the error is measured: some spots of
//! each frame are gathered although their light is interpolated.
//!
//! References: K. Myszkowski, P. Rokita, T. Tawara, *Perception-guided global illumination solution for animation
//! rendering*, SIGGRAPH 2001 (light shared by frames; there photons, here gathered light).

mod film_error;
mod span;
mod movement;
mod stretch;

use std::collections::HashMap;

use radiosity_elements::Elements;
use radiosity_scene::{Camera, Scene};
use radiosity_solve::animation::frame::Frame;
use radiosity_work::{Stage, Work};

use super::eye::Eye;
use super::light_field::LightField;
use super::light_field::spot::Spot;
use super::light_field::spot_gatherer::{SpotGatherer, SpotLight};
use super::picture_light::{GATHERED_FOR_PICTURES, PictureLight};
use super::raster::Raster;
use super::render::taken;
use super::shot::Shot;
use crate::quantity::Quantity;
use crate::reader::ReadMode;
pub use film_error::FilmError;
use movement::Movement;
use stretch::{Stretch, StretchFrame};

/// Frames from the first of a stretch to its last, which is the first of the next one. Chosen: light is gathered in
/// an eighth of them where it is smooth, and so many solutions are held.
const STRETCH: usize = 32;

/// Part of the time of pictures alone that pictures of a film take. Measured in the billiard room at 160 × 90, 33
/// frames, each solved and checked too: 1.41 s a frame, alone 2.90 s.
const SHARED: f64 = 0.5;

/// A frame that is solved, as a film shows it.
#[derive(Clone, Debug)]
pub struct FilmFrame<'a> {
    /// Its number.
    pub number: usize,
    /// Its light.
    pub frame: &'a Frame,
    /// The camera.
    pub camera: Camera,
    /// Whether a picture of it is wanted.
    pub is_wanted: bool,
}

/// Pictures of the frames of a scene, stretch by stretch.
#[derive(Debug)]
pub struct Film<'a> {
    scene: &'a Scene,
    read: ReadMode,
    samples: u32,
    /// Diagonal of the first frame's bounding box, by which the lattices of all are made (scene length).
    diagonal: f64,
    /// Spots that were gathered in the last frame, with its number.
    last: Option<(usize, HashMap<Spot, Option<SpotLight>>)>,
    error: FilmError,
}

impl<'a> Film<'a> {
    /// A film of a scene, of which this is the first frame, with light that is `read` so, and so many camera rays along
    /// each side of a pixel.
    pub fn new(scene: &'a Scene, first: &Frame, read: ReadMode, samples: u32) -> Self {
        let diagonal = first.visibility.bounds().diagonal();
        Self { scene, read, samples, diagonal, last: None, error: FilmError::default() }
    }

    /// Frames from the first to the last of a stretch, which are to be solved before its pictures are taken: several
    /// where they share light.
    pub fn stretch(&self) -> usize {
        if PictureLight::is_gathered(self.read) { STRETCH } else { 0 }
    }

    /// About the seconds that the picture of a frame takes, one of many.
    pub fn seconds(&self, frame: &FilmFrame, work: &Work<'_>) -> f64 {
        let light = self.light(frame);
        let eye = Eye::of(light.solution(), &frame.frame.visibility);
        let alone = Shot::through(&frame.camera, &light, &eye, self.samples, work).seconds();
        if light.gathers() { SHARED * alone } else { alone }
    }

    /// Takes the pictures that are wanted of a stretch of frames in turn.
    ///
    /// # Errors
    /// The first of `take`.
    ///
    /// # Panics
    /// If the scene has no frame of such a number.
    pub fn pictures<E>(
        &mut self,
        frames: &[FilmFrame],
        work: &Work<'_>,
        mut take: impl FnMut(&FilmFrame, Raster) -> Result<(), E>,
    ) -> Result<(), E> {
        if frames.is_empty() {
            return Ok(());
        }
        let lights: Vec<PictureLight> = frames.iter().map(|frame| self.light(frame)).collect();
        let mut stretch = work.during(Stage::Picture, || self.shared(frames, &lights));
        let wanted = frames.iter().zip(&lights).enumerate().filter(|(_, (frame, _))| frame.is_wanted);
        for (place, (frame, light)) in wanted {
            let mut source = StretchFrame { stretch: &mut stretch, frame: place };
            let raster = work.during(Stage::Picture, || {
                let mut field =
                    light.gathers().then(|| LightField::known_by(&mut source, light, self.diagonal));
                let eye = Eye::of(light.solution(), &frame.frame.visibility);
                let shot = Shot::through(&frame.camera, light, &eye, self.samples, work);
                taken(&shot, field.as_mut())
            });
            take(frame, raster)?;
        }
        let (error, spots) = stretch.end();
        self.error.add(&error);
        self.last = frames.last().map(|frame| (frame.number, spots));
        Ok(())
    }

    /// The error of reflected light that was interpolated so far.
    pub fn error(&self) -> FilmError {
        self.error
    }

    /// The light of a frame.
    fn light<'b>(&self, FilmFrame { frame, camera, .. }: &FilmFrame<'b>) -> PictureLight<'b> {
        let Frame { solution, visibility, .. } = frame;
        PictureLight::new(solution, visibility, self.read, GATHERED_FOR_PICTURES)
            .showing(Quantity::Radiosity, camera.eye)
    }

    /// The spots that frames share, with these lights.
    fn shared<'b>(&mut self, frames: &[FilmFrame], lights: &'b [PictureLight<'b>]) -> Stretch<'b> {
        let numbers: Vec<usize> = frames.iter().map(|frame| frame.number).collect();
        let elements: Vec<&Elements> = lights.iter().map(|light| light.solution().elements()).collect();
        let gatherers = lights.iter().map(|light| SpotGatherer::new(light, self.diagonal)).collect();
        let last = self.last.take().filter(|(number, _)| Some(number) == numbers.first());
        let known = last.map(|(_, spots)| spots).unwrap_or_default();
        Stretch::new(gatherers, Movement::of(self.scene, &numbers, &elements), known)
    }
}
