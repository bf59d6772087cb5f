//! Pictures of a solution: camera rays meet the true surfaces, where radiosity is read.
//!
//! The camera is a pinhole; a ray that meets the back of a surface, or nothing, is black. Light is computed
//! at the middles of the pixels (`frame_light`). Pixels that an edge of a surface crosses or that differ from
//! one beside them average the points of a turned grid (`pixel_grid`). What is gathered comes from one light
//! field of the whole picture (`light_field`).

use std::ops::Range;
use std::time::Duration;

use radiosity_scene::Camera;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solution::Solution;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::PartName;
use radiosity_work::{FORECAST_THREADS, Progress, Stage, Work};

use super::eye::Eye;
use super::frame_light::FrameLight;
use super::frame_light::forecast::nodes;
use super::frame_light::frame::Frame;
use super::light_field::LightField;
use super::oversampling::Oversampling;
use super::picture_light::{AVERAGED, GATHERED_FOR_PICTURES, PictureLight};
use super::pixel_count::PixelCount;
use super::raster::Raster;
use super::shot::{Pixel, Shot};
use crate::quantity::Quantity;
pub use crate::reader::ReadMode;

/// Seconds that gathering the light of a picture may take unless asked for. Chosen.
const PATIENCE: f64 = 10.0;

/// Relative accuracy of recomputed light in previews. Chosen: light by a draft's polynomials errs by as much.
pub const ACCURACY_OF_PREVIEWS: f64 = 3e-2;

/// Pixels from which on it is told how long a picture takes. Chosen: the forecast itself computes light at some
/// hundred.
const FORECAST_FROM: usize = 1 << 14;

/// Pixels that are worked on at once; rows of more before and after them, that neighbours agree: a pixel is
/// compared with the one beside it, and direct light with that two pixels away. The former is chosen.
const AT_ONCE: usize = 1 << 20;
const MARGIN: usize = 4;

/// Settings of a picture of a solution.
#[derive(Clone, Copy, Debug)]
pub struct PictureRequest<'a> {
    /// The solution.
    pub solution: &'a Solution,
    /// Its surfaces as obstacles.
    pub visibility: &'a Visibility,
    /// The camera through which it is seen.
    pub camera: &'a Camera,
    /// Camera rays along each side of a pixel that is sampled finely.
    pub samples: u32,
    /// The light that is read.
    pub read: ReadMode,
    /// The quantity that the pixels hold.
    pub shown: Quantity,
    /// Whether recomputed light has the accuracy of previews ([`ACCURACY_OF_PREVIEWS`]): in less time, to look around.
    pub is_preview: bool,
}

impl PictureRequest<'_> {
    /// Takes the picture; about how long that takes is told first.
    ///
    /// The pixels hold W m⁻² (radiosity is radiance times π), in the bands of the solution.
    pub fn picture(&self, work: &Work<'_>) -> Raster {
        work.during(Stage::Picture, || alone(&self.light(), self.visibility, self.camera, self.samples, work))
    }

    /// About the seconds that the picture takes.
    pub fn seconds(&self, work: &Work<'_>) -> f64 {
        let light = self.light();
        let eye = Eye::of(light.solution(), self.visibility);
        Shot::through(self.camera, &light, &eye, self.samples, work).seconds()
    }

    fn light(&self) -> PictureLight<'_> {
        let eps = if self.is_preview { ACCURACY_OF_PREVIEWS } else { GATHERED_FOR_PICTURES };
        let light = PictureLight::new(self.solution, self.visibility, self.read, eps);
        light.showing(self.shown, self.camera.eye)
    }
}

/// The picture of this light through `camera`, which no other one shares its light with.
fn alone(
    light: &PictureLight,
    visibility: &Visibility,
    camera: &Camera,
    samples: u32,
    work: &Work<'_>,
) -> Raster {
    let eye = Eye::of(light.solution(), visibility);
    let shot = Shot::through(camera, light, &eye, samples, work);
    if shot.size.iter().product::<usize>() >= FORECAST_FROM {
        work.report(Progress::Expected { stage: Stage::Picture, seconds: shot.seconds() });
    }
    let mut field = light.gathers().then(|| LightField::new(light, eye.diagonal));
    taken(&shot, field.as_mut())
}

/// The picture of a shot with light that `field` gathers.
pub(super) fn taken(shot: &Shot, mut field: Option<&mut LightField>) -> Raster {
    let [width, height] = shot.size;
    let at_once = (AT_ONCE / width).max(1);
    let done = PixelCount::new(width * height, Stage::Picture, shot.work);
    let strips = (0..height).step_by(at_once).map(|first| first..(first + at_once).min(height));
    let mut pixels: Vec<Pixel> =
        strips.flat_map(|rows| strip(shot, rows, field.as_deref_mut(), &done)).collect();
    let bands = shot.light.solution().bands().iter().map(|band| band.name.clone()).collect();
    let values = pixels.iter().flat_map(|pixel| &pixel.radiosity).copied().collect();
    let coverage = pixels.iter().map(|pixel| pixel.coverage).collect();
    let samples = pixels.iter_mut().map(|pixel| pixel.samples.take()).enumerate();
    let samples = samples.filter_map(|(index, samples)| Some((index, samples?))).collect();
    let emitters = pixels.iter().map(|pixel| pixel.emits).collect();
    Raster::new(shot.size.map(|pixels| pixels as u32), bands, values, coverage)
        .with_samples(samples)
        .with_emitters(emitters)
}

/// The pixels of some rows, with light that `field` gathers.
fn strip(
    shot: &Shot,
    rows: Range<usize>,
    mut field: Option<&mut LightField>,
    done: &PixelCount,
) -> Vec<Pixel> {
    let [width, height] = shot.size;
    let first = rows.start.saturating_sub(MARGIN);
    let around = first..(rows.end + MARGIN).min(height);
    let ranks = shot.work.ranks;
    let frame = Frame::new(shot.eye, &shot.view, width, around, ranks);
    let lit = FrameLight::over(&frame, shot.light, field.as_deref_mut(), shot.work);
    let mut pixels: Vec<Pixel> =
        ranks.map_even(PartName::Middles, frame.len(), width, |pixel| shot.middle(&lit, pixel));
    let (start, count) = ((rows.start - first) * width, rows.len() * width);
    let crossings = ranks.map_even(PartName::Crossings, count, width, |place| {
        shot.crossing(&frame, &pixels, start + place, first)
    });
    pixels.drain(..start);
    pixels.truncate(count);
    let oversampling = Oversampling { shot, first, start };
    oversampling.refine(&lit, &mut pixels, &crossings, field);
    (0..count).for_each(|_| done.add());
    pixels
}

/// Source of light of a picture of so many pixels unless told otherwise: gathered, if two threads do that
/// within some ten seconds and in the time `left`, if that is limited; else with direct light alone recomputed. Direct
/// light takes its time in both.
pub fn usual_read(
    solution: &Solution,
    visibility: &Visibility,
    pixels: u64,
    left: Option<Duration>,
) -> ReadMode {
    let points = nodes(pixels as f64);
    let eps = AVERAGED * GATHERED_FOR_PICTURES;
    let seconds = GatherMethod::Auto.seconds(solution, visibility, eps, points, f64::INFINITY, false);
    let gathered = seconds / FORECAST_THREADS;
    let patience = left.map_or(PATIENCE, |left| left.as_secs_f64().min(PATIENCE));
    if gathered <= patience { ReadMode::Gather } else { ReadMode::Direct }
}

/// Factors that make the emitted light of a three-band scene white, as a camera's white balance. All are 1 if
/// a band emits nothing, and for any other number of bands.
pub fn white_balance(solution: &Solution) -> [f64; 3] {
    if solution.bands().len() != 3 {
        return [1.0; 3];
    }
    let list = solution.elements().list();
    let power = |band: usize| -> f64 {
        let exitance = &solution.bands()[band].coating.exitance;
        let elements: f64 = list.iter().zip(exitance).map(|(element, e)| element.area * e).sum();
        elements + solution.emitters().points.flux(band)
    };
    let powers = [power(0), power(1), power(2)];
    if powers.contains(&0.0) {
        return [1.0; 3];
    }
    let mean = powers.iter().sum::<f64>() / 3.0;
    powers.map(|power| mean / power)
}
