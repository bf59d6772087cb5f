//! Pictures of a solution: camera rays meet the true surfaces, where radiosity is read.
//!
//! The camera is a pinhole; a ray that meets the back of a surface, or nothing, is black. Light is computed
//! at the middles of the pixels (`frame_light`). Pixels that an edge of a surface crosses or that differ from
//! one beside them average `samples × samples` points of a regular grid. What is gathered comes from one light
//! field of the whole picture (`light_field`).

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
use super::frame_light::forecast::{nodes, seconds};
use super::frame_light::frame::Frame;
use super::frame_light::neighbourhoods::Neighbourhoods;
use super::frame_light::picture_light::{AVERAGED, GATHERED_FOR_PICTURES, PictureLight};
use super::frame_light::pixel_count::PixelCount;
use super::light_field::{AskedPlace, LightField};
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

/// Pixels that are worked on at once; rows of more before and after them, that neighbours agree: a pixel is
/// compared with the one beside it, and direct light with that two pixels away. The former is chosen.
const AT_ONCE: usize = 1 << 20;
const MARGIN: usize = 4;

/// Samples of pixels that are worked on at once: some hundred bytes each; and by one thread: some microseconds
/// each. Both are chosen.
const SAMPLES_AT_ONCE: usize = 1 << 20;
const TOGETHER: usize = 64;

/// Relative difference of the irradiances of pixels beside each other up to which a sample at an edge takes
/// theirs. Chosen: an eighth of the samples would show half of it.
const EVEN: f64 = 0.02;

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
    let at_once = (AT_ONCE / width).max(1);
    let done = PixelCount::new(width * height, Stage::Picture, work);
    let strips = (0..height).step_by(at_once).map(|first| first..(first + at_once).min(height));
    let mut field = light.gathers().then(|| LightField::new(&light, eye.diagonal));
    let mut pixels: Vec<Pixel> = strips.flat_map(|rows| shot.strip(rows, field.as_mut(), &done)).collect();
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
    let points = nodes(pixels as f64);
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

/// One point of the regular grid of a pixel.
#[derive(Clone, Copy, Debug)]
struct Sample {
    /// The pixel of the frame.
    pixel: usize,
    /// Place in the grid, along and down.
    place: [u32; 2],
}

/// Place that a sample sees.
#[derive(Clone, Copy, Debug)]
struct SamplePlace {
    /// Column and row of its pixel in the frame.
    pixel: [usize; 2],
    seen: SeenPlace,
}

/// Reasons to sample a pixel finely.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Crossing {
    /// None: its middle is enough.
    None,
    /// An edge of a surface crosses it.
    Edge,
    /// It differs from one beside it.
    Light,
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

    /// The pixels of some rows, with light that `field` gathers.
    fn strip(&self, rows: Range<usize>, mut field: Option<&mut LightField>, done: &PixelCount) -> Vec<Pixel> {
        let [width, height] = self.size;
        let first = rows.start.saturating_sub(MARGIN);
        let around = first..(rows.end + MARGIN).min(height);
        let ranks = self.work.ranks;
        let frame = Frame::new(self.eye, &self.view, width, around, ranks);
        let lit = FrameLight::over(&frame, self.light, field.as_deref_mut(), self.work);
        let mut pixels: Vec<Pixel> =
            ranks.map_even(PartName::Middles, frame.len(), width, |pixel| self.middle(&lit, pixel));
        let (start, count) = ((rows.start - first) * width, rows.len() * width);
        let crossings = ranks.map_even(PartName::Crossings, count, width, |place| {
            let pixel = start + place;
            match self.samples > 1 {
                true if self.is_edge(&frame, pixel, first) => Crossing::Edge,
                true if differs(&frame, &pixels, pixel) => Crossing::Light,
                _ => Crossing::None,
            }
        });
        pixels.drain(..start);
        pixels.truncate(count);
        let oversampling = Oversampling { shot: self, first, start };
        oversampling.refine(&lit, &mut pixels, &crossings, field);
        (0..count).for_each(|_| done.add());
        pixels
    }

    /// The pixel as its middle sees it.
    fn middle(&self, lit: &FrameLight, pixel: usize) -> Pixel {
        let (Some(seen), Some(irradiance)) = (lit.frame().seen(pixel), lit.irradiance(pixel)) else {
            return self.nothing();
        };
        self.pixel(seen, irradiance)
    }

    /// A pixel that sees only this place, in this irradiance (W m⁻² per band).
    fn pixel(&self, seen: &SeenPlace, irradiance: &[f64]) -> Pixel {
        let radiosity = self.light.shown(seen, irradiance.iter().copied());
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
                let place = place.map(|at| at * (self.samples - 1));
                let [x, y] = self.point(frame, Sample { pixel, place });
                !self
                    .eye
                    .along(&self.view.ray(x, y + first as f64))
                    .is_some_and(|seen| middle.goes_with(&seen))
            })
    }

    /// The place in the frame of a sample.
    fn point(&self, frame: &Frame, Sample { pixel, place }: Sample) -> [f64; 2] {
        let [column, row] = frame.place(pixel);
        let [x, y] = place.map(|k| (f64::from(k) + 0.5) / f64::from(self.samples));
        [column as f64 + x, row as f64 + y]
    }

    /// The pixels as single samples of them see them, in the light `lit` of their middles and of those beside.
    fn sampled(
        &self,
        lit: &FrameLight,
        first: usize,
        samples: &[Sample],
        field: Option<&mut LightField>,
    ) -> Vec<Pixel> {
        let ranks = self.work.ranks;
        let frame = lit.frame();
        let seen: Vec<Option<SeenPlace>> =
            ranks.map_even(PartName::Sights, samples.len(), TOGETHER, |index| {
                let [x, y] = self.point(frame, samples[index]);
                self.eye.along(&self.view.ray(x, y + first as f64))
            });
        let beside = |index: usize| {
            let at = self.point(frame, samples[index]);
            seen[index].as_ref().and_then(|seen| lit.beside(at, seen, EVEN))
        };
        let mut irradiance = ranks.map_even(PartName::SampleLight, samples.len(), TOGETHER, beside);
        let is_open = |index: &usize| seen[*index].is_some() && irradiance[*index].is_none();
        let open: Vec<usize> = (0..samples.len()).filter(is_open).collect();
        let places: Vec<SamplePlace> = open
            .iter()
            .filter_map(|index| {
                let pixel = frame.place(samples[*index].pixel);
                Some(SamplePlace { pixel, seen: seen[*index]? })
            })
            .collect();
        for (index, light) in open.into_iter().zip(self.computed(&places, field)) {
            irradiance[index] = Some(light);
        }
        let shown = |index: usize| {
            let (Some(seen), Some(irradiance)) = (&seen[index], &irradiance[index]) else {
                return self.nothing();
            };
            self.pixel(seen, irradiance)
        };
        ranks.map_even(PartName::Pixels, samples.len(), TOGETHER, shown)
    }

    /// Irradiance per band (W m⁻²) at the places of samples.
    fn computed(&self, places: &[SamplePlace], field: Option<&mut LightField>) -> Vec<Vec<f64>> {
        let neighbourhoods = Neighbourhoods::of(self.light, places.len(), |index| {
            let SamplePlace { pixel, seen } = &places[index];
            Some((*pixel, seen))
        });
        let direct = |index: usize| {
            self.light.direct(&places[index].seen, neighbourhoods.around(index), ONE_OF_SEVERAL).bands
        };
        let mut irradiance: Vec<Vec<f64>> =
            self.work.ranks.map_even(PartName::MoreDirectLight, places.len(), TOGETHER, direct);
        let rest: Vec<f64> = match field {
            Some(field) => field.at(&self.asked(places, &irradiance), self.work),
            None => places.iter().flat_map(|place| self.light.polynomials(&place.seen)).collect(),
        };
        let bands = self.light.solution().bands().len();
        for (sums, rest) in irradiance.iter_mut().zip(rest.chunks_exact(bands)) {
            sums.iter_mut().zip(rest).for_each(|(sum, rest)| *sum += rest);
        }
        irradiance
    }

    /// Samples as a light field is asked for them, beside their direct light.
    fn asked(&self, places: &[SamplePlace], direct: &[Vec<f64>]) -> Vec<Option<AskedPlace>> {
        let one = |(place, direct): (&SamplePlace, &Vec<f64>)| {
            let footprint = self.view.footprint(place.seen.place.position);
            Some(AskedPlace { seen: place.seen, footprint, beside: direct.iter().sum() })
        };
        places.iter().zip(direct).map(one).collect()
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

/// Samples of the pixels of some rows that are to be sampled finely.
struct Oversampling<'a> {
    shot: &'a Shot<'a>,
    /// First row of the frame.
    first: usize,
    /// First pixel of the frame that is wanted.
    start: usize,
}

impl Oversampling<'_> {
    /// Replaces pixels, seen by their middles, by means: at edges over all samples, elsewhere over the corners and
    /// the middle if these see about the same, else over all samples too.
    fn refine(
        &self,
        lit: &FrameLight,
        pixels: &mut [Pixel],
        crossings: &[Crossing],
        mut field: Option<&mut LightField>,
    ) {
        let crossed = |place: &usize| crossings[*place] != Crossing::None;
        let most = (SAMPLES_AT_ONCE / self.shot.samples.pow(2) as usize).max(1);
        let fine: Vec<usize> = (0..pixels.len()).filter(crossed).collect();
        for fine in fine.chunks(most) {
            let corners = self.sampled(lit, fine, self.corners(), field.as_deref_mut());
            let wants_all = |own: usize| {
                let middle = &pixels[fine[own]];
                crossings[fine[own]] == Crossing::Edge || corners[own].iter().any(|one| apart(one, middle))
            };
            let (more, enough): (Vec<usize>, Vec<usize>) = (0..fine.len()).partition(|own| wants_all(*own));
            let places: Vec<usize> = more.iter().map(|own| fine[*own]).collect();
            let rest = self.sampled(lit, &places, self.others(), field.as_deref_mut());
            for (own, rest) in more.into_iter().zip(rest) {
                pixels[fine[own]] = self.shot.mean(&[&corners[own][..], &rest].concat());
            }
            for own in enough {
                let middle = pixels[fine[own]].clone();
                pixels[fine[own]] = self.shot.mean(&[&corners[own][..], &[middle]].concat());
            }
        }
    }

    /// The corners of the grid of a pixel.
    fn corners(&self) -> Vec<[u32; 2]> {
        CORNERS.map(|corner| corner.map(|at| at * (self.shot.samples - 1))).to_vec()
    }

    /// The points of the grid of a pixel but its corners.
    fn others(&self) -> Vec<[u32; 2]> {
        let (corners, count) = (self.corners(), self.shot.samples);
        let all = (0..count).flat_map(|j| (0..count).map(move |i| [i, j]));
        all.filter(|place| !corners.contains(place)).collect()
    }

    /// The same samples of each of some pixels, pixel by pixel.
    fn sampled(
        &self,
        lit: &FrameLight,
        pixels: &[usize],
        grid: Vec<[u32; 2]>,
        field: Option<&mut LightField>,
    ) -> Vec<Vec<Pixel>> {
        let of = |pixel: usize| {
            let pixel = self.start + pixel;
            grid.iter().map(move |place| Sample { pixel, place: *place })
        };
        let samples: Vec<Sample> = pixels.iter().flat_map(|pixel| of(*pixel)).collect();
        let all = self.shot.sampled(lit, self.first, &samples, field);
        all.chunks(grid.len().max(1)).map(<[Pixel]>::to_vec).collect()
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
