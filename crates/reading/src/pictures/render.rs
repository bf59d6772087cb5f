//! Pictures of a solution: camera rays meet the true surfaces, where radiosity is read.
//!
//! The camera is a pinhole; a ray that meets the back of a surface, or nothing, is black. Light is computed
//! at the middles of the pixels (`frame_light`). Pixels that an edge of a surface crosses or that differ from
//! one beside them average `samples × samples` points of a regular grid.

use std::ops::Range;

use radiosity_light::penumbra::RayEffort;
use radiosity_scene::Camera;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solution::Solution;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::PartName;
use radiosity_work::{Progress, Stage, Work};
use serde::{Deserialize, Serialize};

use super::frame_light::FrameLight;
use super::frame_light::eye::{Eye, SeenPlace};
use super::frame_light::forecast::{INTERPOLATED, seconds};
use super::frame_light::frame::Frame;
use super::frame_light::picture_light::{AVERAGED, GATHERED_FOR_PICTURES, PictureLight};
use super::frame_light::pixel_count::PixelCount;
use super::frame_light::smooth::COARSEST;
use super::pinhole::Pinhole;
use super::pixel_samples::PixelSamples;
use super::raster::Raster;
use crate::quantity::Quantity;
pub use crate::reader::ReadMode;

/// Relative difference of the radiosities of two pixels from which both are sampled finely. Chosen: four
/// steps of eight bits, and twice the error in penumbrae.
const CONTRAST: f64 = 0.04;

/// Seconds that gathering the light of a picture may take unless asked for. Chosen.
const PATIENCE: f64 = 10.0;

/// Threads that the time is reckoned with, whatever the number that works: what is read does not depend on
/// it. Chosen.
const THREADS: f64 = 2.0;

/// Pixels that are worked on at once; rows of more before and after them, that neighbours agree: a pixel's
/// value hangs on those two steps of the lattice away, of each of its spacings, and one beside it. The former
/// is chosen.
const AT_ONCE: usize = 1 << 20;
const MARGIN: usize = 5 * COARSEST;

/// Rays for direct light at one of several samples of a pixel: their errors average out. Chosen.
const ONE_OF_SEVERAL: RayEffort = RayEffort { error_factor: 3.0, sure: false };

/// The corners of the unit square.
const CORNERS: [[u32; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];

/// Renders `solution` through `camera`; about how long that takes is told first.
///
/// The pixels hold the quantity `shown`, W m⁻² (radiosity is radiance times π), in the bands of the solution.
pub fn render(
    solution: &Solution,
    visibility: &Visibility,
    camera: &Camera,
    samples: u32,
    read: ReadMode,
    shown: Quantity,
    work: &Work<'_>,
) -> Raster {
    let light =
        PictureLight::new(solution, visibility, read, GATHERED_FOR_PICTURES).showing(shown, camera.eye);
    let eye = Eye { elements: solution.elements(), visibility, diagonal: visibility.bounds().diagonal() };
    let [width, height] = [camera.width as usize, camera.height as usize];
    let shot =
        Shot { light: &light, eye: &eye, view: Pinhole::new(camera), size: [width, height], samples, work };
    work.report(Progress::Expected { stage: Stage::Picture, seconds: shot.seconds() });
    let at_once = (AT_ONCE / width).div_ceil(COARSEST).max(1) * COARSEST;
    let done = PixelCount::new(width * height, Stage::Picture, work);
    let strips = (0..height).step_by(at_once).map(|first| first..(first + at_once).min(height));
    let mut pixels: Vec<Pixel> = strips.flat_map(|rows| shot.strip(rows, &done)).collect();
    let bands = solution.bands().iter().map(|band| band.name.clone()).collect();
    let values = pixels.iter().flat_map(|pixel| &pixel.radiosity).copied().collect();
    let coverage = pixels.iter().map(|pixel| pixel.coverage).collect();
    let samples = pixels.iter_mut().map(|pixel| pixel.samples.take()).enumerate();
    let samples = samples.filter_map(|(index, samples)| Some((index, samples?))).collect();
    let emitters = pixels.iter().map(|pixel| pixel.emits).collect();
    Raster::new([camera.width, camera.height], bands, values, coverage)
        .with_samples(samples)
        .with_emitters(emitters)
}

/// Source of light of a picture of so many pixels unless told otherwise: gathered, if two threads do that
/// within some ten seconds, else with direct light alone recomputed. Direct light takes its time in both.
pub fn usual_read(solution: &Solution, visibility: &Visibility, pixels: u64) -> ReadMode {
    let points = pixels as f64 / INTERPOLATED;
    let eps = AVERAGED * GATHERED_FOR_PICTURES;
    let seconds = GatherMethod::Auto.seconds(solution, visibility, eps, points, f64::INFINITY, false);
    let gathered = seconds / THREADS;
    if gathered <= PATIENCE { ReadMode::Gather } else { ReadMode::Direct }
}

/// The radiosity seen through a pixel.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Pixel {
    /// Mean of the shown quantity over the pixel, per band (W m⁻²).
    radiosity: Vec<f64>,
    /// Part of the pixel in which a front is seen.
    coverage: f64,
    /// Whether something that emits is seen in the pixel.
    emits: bool,
    /// Samples that are averaged, if they are more than the middle.
    samples: Option<PixelSamples>,
}

/// A picture about to be taken.
struct Shot<'a> {
    light: &'a PictureLight<'a>,
    eye: &'a Eye<'a>,
    view: Pinhole,
    /// Pixels across and down.
    size: [usize; 2],
    samples: u32,
    work: &'a Work<'a>,
}

impl Shot<'_> {
    /// About the seconds that the picture takes.
    fn seconds(&self) -> f64 {
        let [width, height] = self.size;
        let seen = |pixel: usize| {
            let [column, row] = [pixel % width, pixel / width].map(|at| at as f64 + 0.5);
            self.eye.along(&self.view.ray(column, row))
        };
        seconds(self.light, width * height, &seen, self.work.ranks)
    }

    /// The pixels of some rows.
    fn strip(&self, rows: Range<usize>, done: &PixelCount) -> Vec<Pixel> {
        let [width, height] = self.size;
        let first = rows.start.saturating_sub(MARGIN);
        let around = first..(rows.end + MARGIN).min(height);
        let ranks = self.work.ranks;
        let frame = Frame::new(self.eye, &self.view, width, around, ranks);
        let lit = FrameLight::over(&frame, self.light, self.work);
        let middles: Vec<Pixel> =
            ranks.map_even(PartName::Middles, frame.len(), width, |pixel| self.middle(&lit, pixel));
        let pixel = |pixel: usize| {
            let is_fine =
                self.samples > 1 && (self.is_edge(&frame, pixel, first) || differs(&frame, &middles, pixel));
            let sampled = || self.sampled(&lit, pixel, first, &middles[pixel]);
            let value = if is_fine { sampled() } else { middles[pixel].clone() };
            done.add();
            value
        };
        let start = (rows.start - first) * width;
        ranks.map_even(PartName::Pixels, rows.len() * width, width, |place| pixel(start + place))
    }

    /// The pixel as its middle sees it.
    fn middle(&self, lit: &FrameLight, pixel: usize) -> Pixel {
        let (Some(seen), Some(irradiance)) = (lit.frame().seen(pixel), lit.irradiance(pixel)) else {
            return self.nothing();
        };
        let radiosity = self.light.shown(seen, irradiance.into_iter());
        Pixel { radiosity, coverage: 1.0, emits: self.emits(seen), samples: None }
    }

    fn nothing(&self) -> Pixel {
        let radiosity = vec![0.0; self.light.solution().bands().len()];
        Pixel { radiosity, coverage: 0.0, emits: false, samples: None }
    }

    /// Whether the element of a place emits.
    fn emits(&self, seen: &SeenPlace) -> bool {
        self.light.solution().bands().iter().any(|band| band.coating.exitance[seen.element] > 0.0)
    }

    /// Whether an edge of a surface crosses a pixel of a frame that begins with the row `first`. That does
    /// not depend on light, so that pixels at edges of little contrast are sampled alike in all frames of a
    /// film.
    fn is_edge(&self, frame: &Frame, pixel: usize, first: usize) -> bool {
        let Some(middle) = frame.seen(pixel) else { return false };
        let [column, row] = frame.place(pixel).map(|at| at as isize);
        let mut beside = (-1..=1).flat_map(|j| (-1..=1).map(move |i| [column + i, row + j]));
        let goes = |at: [isize; 2]| {
            frame.pixel(at).is_none_or(|other| frame.seen(other).is_some_and(|other| middle.goes_with(other)))
        };
        !beside.all(goes)
            && CORNERS.iter().any(|place| {
                let [x, y] = self.point(frame, pixel, place.map(|at| at * (self.samples - 1)));
                !self
                    .eye
                    .along(&self.view.ray(x, y + first as f64))
                    .is_some_and(|seen| middle.goes_with(&seen))
            })
    }

    /// The place in the frame of one point of the regular grid of a pixel.
    fn point(&self, frame: &Frame, pixel: usize, place: [u32; 2]) -> [f64; 2] {
        let [column, row] = frame.place(pixel);
        let [x, y] = place.map(|k| (f64::from(k) + 0.5) / f64::from(self.samples));
        [column as f64 + x, row as f64 + y]
    }

    /// The mean over a pixel of a frame that begins with the row `first`; `middle` is the pixel as its middle
    /// sees it. Where the corners see about the same, they and the middle are enough.
    fn sampled(&self, lit: &FrameLight, pixel: usize, first: usize, middle: &Pixel) -> Pixel {
        let sample = |place: [u32; 2]| self.sample(lit, pixel, first, place);
        let most = self.samples - 1;
        let corners = CORNERS.map(|corner| corner.map(|at| at * most));
        let few: Vec<Pixel> = corners.into_iter().map(sample).chain([middle.clone()]).collect();
        if few.iter().all(|one| !apart(one, middle)) && !self.is_edge(lit.frame(), pixel, first) {
            return self.mean(&few);
        }
        let is_corner = |place: &[u32; 2]| corners.contains(place);
        let all = (0..=most).flat_map(|j| (0..=most).map(move |i| [i, j]));
        let rest: Vec<Pixel> = all.filter(|place| !is_corner(place)).map(sample).collect();
        self.mean(&[&few[..4], &rest].concat())
    }

    /// The pixel as one point of its regular grid sees it.
    fn sample(&self, lit: &FrameLight, pixel: usize, first: usize, place: [u32; 2]) -> Pixel {
        let at = self.point(lit.frame(), pixel, place);
        let seen = self.eye.along(&self.view.ray(at[0], at[1] + first as f64));
        let Some(seen) = seen else { return self.nothing() };
        let direct = self.light.direct(&seen, ONE_OF_SEVERAL).bands;
        let rest = lit.between(at, &seen).unwrap_or_else(|| self.light.rest(&seen, &direct).bands);
        let radiosity = self.light.shown(&seen, direct.iter().zip(rest).map(|(d, s)| d + s));
        Pixel { radiosity, coverage: 1.0, emits: self.emits(&seen), samples: None }
    }

    /// The pixel that averages these samples.
    fn mean(&self, pixels: &[Pixel]) -> Pixel {
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

/// Whether a pixel differs from one of the eight beside it.
fn differs(frame: &Frame, middles: &[Pixel], pixel: usize) -> bool {
    let [column, row] = frame.place(pixel).map(|at| at as isize);
    let beside = (-1..=1).flat_map(|j| (-1..=1).map(move |i| [column + i, row + j]));
    beside.filter_map(|at| frame.pixel(at)).any(|other| apart(&middles[pixel], &middles[other]))
}

/// Whether two pixels differ.
fn apart(a: &Pixel, b: &Pixel) -> bool {
    let apart: f64 = a.radiosity.iter().zip(&b.radiosity).map(|(a, b)| (a - b).abs()).sum();
    let both: f64 = a.radiosity.iter().chain(&b.radiosity).sum();
    a.coverage != b.coverage || 2.0 * apart > CONTRAST * both
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
