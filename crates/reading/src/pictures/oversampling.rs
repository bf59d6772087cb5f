//! Pixels that are sampled finely: those that an edge of a surface crosses, or that differ from one beside them.
//!
//! They average the points of a turned grid (`pixel_grid`). A sample that sees the smooth surface that middles of
//! pixels about it see takes the light of a fit to theirs where that leaves little; elsewhere its own is computed.

use radiosity_light::penumbra::RayEffort;
use radiosity_work::ranks::PartName;
use serde::{Deserialize, Serialize};

use super::eye::SeenPlace;
use super::frame_light::frame::Frame;
use super::frame_light::{FrameLight, other_light};
use super::light_field::{AskedPlace, LightField};
use super::neighbourhoods::Neighbourhoods;
use super::shot::{Pixel, Shot};

/// Relative difference of the radiosities of two pixels from which both are sampled finely. Chosen: four
/// steps of eight bits, and twice the error in penumbrae.
const CONTRAST: f64 = 0.04;

/// Samples of pixels that are worked on at once: some hundred bytes each; and by one thread: some microseconds
/// each. Both are chosen.
const SAMPLES_AT_ONCE: usize = 1 << 20;
const TOGETHER: usize = 64;

/// Part of the light that a fit to the pixels beside a sample may leave, up to which the sample takes it. Chosen: an
/// eighth of the samples would show half of it.
const EVEN: f64 = 0.02;

/// Rays for direct light at one of several samples of a pixel: their errors average out. Chosen.
const ONE_OF_SEVERAL: RayEffort = RayEffort { error_factor: 3.0, sure: false };

/// One point of a pixel.
#[derive(Clone, Copy, Debug)]
struct Sample {
    /// The pixel of the frame.
    pixel: usize,
    /// Place in the pixel, along and down, in pixels.
    point: [f64; 2],
}

/// Place that a sample sees.
#[derive(Clone, Copy, Debug)]
struct SamplePlace {
    /// Column and row of its pixel in the frame.
    pixel: [usize; 2],
    /// Its own place in the frame.
    at: [f64; 2],
    seen: SeenPlace,
}

/// Reasons to sample a pixel finely.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Crossing {
    /// None: its middle is enough.
    None,
    /// An edge of a surface crosses it.
    Edge,
    /// It differs from one beside it.
    Light,
}

/// Samples of the pixels of some rows that are to be sampled finely.
pub(super) struct Oversampling<'a> {
    pub shot: &'a Shot<'a>,
    /// First row of the frame.
    pub first: usize,
    /// First pixel of the frame that is wanted.
    pub start: usize,
}

impl Oversampling<'_> {
    /// Replaces pixels, seen by their middles, by means: at edges over all samples, elsewhere over the outer ones and
    /// the middle if these see about the same, else over all samples too.
    pub(super) fn refine(
        &self,
        lit: &FrameLight,
        pixels: &mut [Pixel],
        crossings: &[Crossing],
        mut field: Option<&mut LightField>,
    ) {
        let most = (SAMPLES_AT_ONCE / self.shot.grid.points().len()).max(1);
        let [outer, inner] = self.shot.grid.outer_and_inner();
        let crossed_by = |crossing: Crossing| -> Vec<usize> {
            (0..pixels.len()).filter(|place| crossings[*place] == crossing).collect()
        };
        let (edges, fine) = (crossed_by(Crossing::Edge), crossed_by(Crossing::Light));
        for edges in edges.chunks(most) {
            let samples = self.sampled(lit, edges, self.shot.grid.points(), field.as_deref_mut());
            for (place, samples) in edges.iter().zip(samples) {
                pixels[*place] = self.shot.mean(&samples);
            }
        }
        for fine in fine.chunks(most) {
            let around = self.sampled(lit, fine, &outer, field.as_deref_mut());
            let wants_all = |own: usize| around[own].iter().any(|one| apart(one, &pixels[fine[own]]));
            let (more, enough): (Vec<usize>, Vec<usize>) = (0..fine.len()).partition(|own| wants_all(*own));
            let places: Vec<usize> = more.iter().map(|own| fine[*own]).collect();
            let rest = self.sampled(lit, &places, &inner, field.as_deref_mut());
            for (own, rest) in more.into_iter().zip(rest) {
                pixels[fine[own]] = self.shot.mean(&[&around[own][..], &rest].concat());
            }
            for own in enough {
                let middle = pixels[fine[own]].clone();
                pixels[fine[own]] = self.shot.mean(&[&around[own][..], &[middle]].concat());
            }
        }
    }

    /// Samples at these points of each of some pixels, pixel by pixel.
    fn sampled(
        &self,
        lit: &FrameLight,
        pixels: &[usize],
        points: &[[f64; 2]],
        field: Option<&mut LightField>,
    ) -> Vec<Vec<Pixel>> {
        let of = |pixel: usize| {
            let pixel = self.start + pixel;
            points.iter().map(move |point| Sample { pixel, point: *point })
        };
        let samples: Vec<Sample> = pixels.iter().flat_map(|pixel| of(*pixel)).collect();
        let all = self.shot.sampled(lit, self.first, &samples, field);
        (0..pixels.len()).map(|own| all[own * points.len()..][..points.len()].to_vec()).collect()
    }
}

impl Shot<'_> {
    /// Why a pixel of a frame that begins with the row `first`, seen by the middles `pixels`, is to be sampled finely.
    pub(super) fn crossing(&self, frame: &Frame, pixels: &[Pixel], pixel: usize, first: usize) -> Crossing {
        match self.grid.points().len() > 1 {
            true if self.is_edge(frame, pixel, first) => Crossing::Edge,
            true if differs(frame, pixels, pixel) => Crossing::Light,
            _ => Crossing::None,
        }
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
            && self.grid.corners().into_iter().any(|point| {
                let [x, y] = place(frame, Sample { pixel, point });
                !self
                    .eye
                    .along(&self.view.ray(x, y + first as f64))
                    .is_some_and(|seen| middle.goes_with(&seen))
            })
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
                let [x, y] = place(frame, samples[index]);
                self.eye.along(&self.view.ray(x, y + first as f64))
            });
        let beside = |index: usize| {
            let at = place(frame, samples[index]);
            seen[index].as_ref().and_then(|seen| lit.beside(at, seen, EVEN))
        };
        let mut irradiance = ranks.map_even(PartName::SampleLight, samples.len(), TOGETHER, beside);
        let is_open = |index: &usize| seen[*index].is_some() && irradiance[*index].is_none();
        let open: Vec<usize> = (0..samples.len()).filter(is_open).collect();
        let places: Vec<SamplePlace> = open
            .iter()
            .filter_map(|index| {
                let (pixel, at) = (frame.place(samples[*index].pixel), place(frame, samples[*index]));
                Some(SamplePlace { pixel, at, seen: seen[*index]? })
            })
            .collect();
        for (index, light) in open.into_iter().zip(self.computed(lit, &places, field)) {
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

    /// Irradiance per band (W m⁻²) at the places of samples: direct light is computed, other light only where it is not
    /// even about them.
    fn computed(
        &self,
        lit: &FrameLight,
        places: &[SamplePlace],
        field: Option<&mut LightField>,
    ) -> Vec<Vec<f64>> {
        let neighbourhoods = Neighbourhoods::of(self.light, places.len(), |index| {
            let SamplePlace { pixel, seen, .. } = &places[index];
            Some((*pixel, seen))
        });
        let ranks = self.work.ranks;
        let direct = |index: usize| {
            self.light.direct(&places[index].seen, neighbourhoods.around(index), ONE_OF_SEVERAL).bands
        };
        let mut irradiance: Vec<Vec<f64>> =
            ranks.map_even(PartName::MoreDirectLight, places.len(), TOGETHER, direct);
        let beside = |index: usize| {
            let SamplePlace { at, seen, .. } = &places[index];
            lit.other_beside(*at, seen, irradiance[index].iter().sum(), EVEN)
        };
        let even: Vec<Option<Vec<f64>>> =
            ranks.map_even(PartName::SampleLight, places.len(), TOGETHER, beside);
        let asked =
            |index: usize| even[index].is_none().then(|| self.asked(&places[index], &irradiance[index]));
        let asked: Vec<Option<AskedPlace>> = (0..places.len()).map(asked).collect();
        let rest = other_light(&asked, self.light, field, self.work);
        let bands = self.light.solution().bands().len();
        for ((sums, even), rest) in irradiance.iter_mut().zip(&even).zip(rest.chunks_exact(bands)) {
            let rest = even.as_deref().unwrap_or(rest);
            sums.iter_mut().zip(rest).for_each(|(sum, rest)| *sum += rest);
        }
        irradiance
    }

    /// A sample as a light field is asked for it, beside its direct light.
    fn asked(&self, place: &SamplePlace, direct: &[f64]) -> AskedPlace {
        let footprint = self.view.footprint(place.seen.place.position);
        let beside = direct.iter().sum();
        AskedPlace { seen: place.seen, footprint, beside, error_factor: ONE_OF_SEVERAL.error_factor }
    }
}

/// The place of a sample in the frame, in pixels.
fn place(frame: &Frame, Sample { pixel, point: [x, y] }: Sample) -> [f64; 2] {
    let [column, row] = frame.place(pixel);
    [column as f64 + x, row as f64 + y]
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
