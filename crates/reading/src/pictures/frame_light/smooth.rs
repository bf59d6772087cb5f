//! Smooth light over a picture: computed at few pixels, interpolated between them.
//!
//! Light is computed at every [`COARSEST`]-th pixel both ways, and fitted between (`fit`) from those that lie
//! on the same smooth surface. Where fewer than four do, where they lie too far on one side, or where the fit
//! leaves more than [`ROUGH`] beside the values' own errors, pixels half as far apart follow, down to all
//! pixels: at contacts and in corners, where light changes fast. So do they where the values lie in a row,
//! too few to tell whether light bends between them. Near the borders of surfaces the coarsest are not
//! trusted. Computed values with errors are themselves replaced by the fit, which averages them.
//!
//! References: G. Ward, F. Rubinstein, R. Clear, *A ray tracing solution for diffuse interreflection*,
//! SIGGRAPH 1988 (interpolation of indirect light); there by the distances of what is seen, here by what the
//! fit leaves.

use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use super::eye::SeenPlace;
use super::fit::{Fit, FitResult};
use super::frame::Frame;
use super::pixel_count::PixelCount;

/// Pixels from one computed value to the next at first: a power of two. Chosen.
pub(crate) const COARSEST: usize = 16;

/// Most difference between a linear fit and a quadratic one, over the most residual of a fit. Chosen: the
/// error that remains is smaller by about as much; fits of few values leave little even where light peaks
/// between them.
const BENT: f64 = 3.0;

/// Most residual of a fit, over all light of the place, and the pixels between computed values up to which
/// twice as much is allowed: such places are small. Both are chosen.
const ROUGH: f64 = 4e-3;
const SMALL: usize = 4;

/// Pixels between computed values up to which linear fits are trusted. Chosen.
const IN_A_ROW: usize = 2;

/// Most share `aside` by which values lie on one side, at pixels and between pixels. Chosen: without the
/// former, light was 5 % off at the border of a ceiling.
const ASIDE: f64 = 0.25;
const ASIDE_BETWEEN: f64 = 0.8;

/// Reach of the fit for places between pixels, in pixels.
const BETWEEN: f64 = 2.5;

/// Pixels that one thread computes after each other, and fits. Chosen: they take some milliseconds, and some
/// microseconds, each.
const DEAR: usize = 1;
const CHEAP: usize = 256;

/// Smooth light at a pixel and the place that it sees.
pub(crate) type SmoothAt<'a> = &'a (dyn Fn(usize, &SeenPlace) -> ComputedLight + Sync);

/// Light that was computed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct ComputedLight {
    /// Irradiance per band (W m⁻²).
    pub bands: Vec<f64>,
    /// Standard deviation of the sum over the bands (W m⁻²).
    pub error: f64,
}

/// Values per band at every pixel of a frame.
#[derive(Debug)]
pub(crate) struct Smooth<'a> {
    frame: &'a Frame,
    bands: usize,
    /// Pixel by pixel, bands fastest; zero where nothing is seen.
    values: Vec<f64>,
}

impl<'a> Smooth<'a> {
    /// The light `smooth` of all pixels of a frame in so many bands, where each has other light per band (W
    /// m⁻²) as well; those computed at one spacing are told.
    pub(crate) fn over(
        frame: &'a Frame,
        bands: usize,
        smooth: SmoothAt<'_>,
        other: &[Vec<f64>],
        work: &Work<'_>,
    ) -> Self {
        let mut known: Vec<Option<ComputedLight>> = vec![None; frame.len()];
        let mut values = vec![0.0; frame.len() * bands];
        let mut open: Vec<usize> = (0..frame.len()).filter(|pixel| frame.seen(*pixel).is_some()).collect();
        let mut spacing = COARSEST;
        let ranks = work.ranks;
        while !open.is_empty() && spacing > 0 {
            let wanted = wanted(frame, &known, &open, spacing);
            let pixel_count = PixelCount::new(wanted.len(), Stage::GatheredPixels, work);
            let compute = |place: usize| {
                let pixel = wanted[place];
                let known = frame.seen(pixel).map(|seen| smooth(pixel, seen));
                pixel_count.add();
                known
            };
            let computed: Vec<Option<ComputedLight>> =
                ranks.map_even(PartName::GatheredLight, wanted.len(), DEAR, compute);
            wanted.into_iter().zip(computed).for_each(|(pixel, value)| known[pixel] = value);
            let beside = |pixel: usize| other[pixel].iter().sum();
            let fit = |place: usize| fitted(frame, &known, open[place], spacing, beside(open[place]));
            let found: Vec<Option<Vec<f64>>> = ranks.map_even(PartName::FittedLight, open.len(), CHEAP, fit);
            let mut left = Vec::new();
            for (pixel, value) in open.into_iter().zip(found) {
                match value {
                    Some(value) => values[pixel * bands..(pixel + 1) * bands].copy_from_slice(&value),
                    None => left.push(pixel),
                }
            }
            open = left;
            spacing /= 2;
        }
        Self { frame, bands, values }
    }

    /// Irradiance per band of a pixel (W m⁻²).
    pub(crate) fn at(&self, pixel: usize) -> &[f64] {
        &self.values[pixel * self.bands..(pixel + 1) * self.bands]
    }

    /// The light at a place seen at a point of the picture, counted from the first row of the frame; None
    /// where no pixel around sees that surface.
    pub(crate) fn between(&self, [x, y]: [f64; 2], seen: &SeenPlace) -> Option<Vec<f64>> {
        let mut fit = Fit::new();
        let [column, row] = [x, y].map(|at| at.floor() as isize);
        for (i, j) in (-2..=2).flat_map(|j| (-2..=2).map(move |i| (i, j))) {
            let Some(pixel) = self.frame.pixel([column + i, row + j]) else { continue };
            let middle = [column + i, row + j].map(|at| at as f64 + 0.5);
            self.take(&mut fit, pixel, weight([x - middle[0], y - middle[1]], BETWEEN), seen);
        }
        let found = fit.found().filter(|found| found.aside <= ASIDE_BETWEEN);
        found.map(|found| fit.within(found.value)).or_else(|| fit.mean())
    }

    fn take<'b>(&'b self, fit: &mut Fit<'b>, pixel: usize, weight: f64, seen: &SeenPlace) {
        let Some(other) = self.frame.seen(pixel).filter(|other| weight > 0.0 && seen.goes_with(other)) else {
            return;
        };
        fit.take(offset(seen, other), weight, self.at(pixel), 0.0);
    }
}

/// The pixels to compute: around those that are open, the next ones of the lattice.
fn wanted(frame: &Frame, known: &[Option<ComputedLight>], open: &[usize], spacing: usize) -> Vec<usize> {
    let mut wanted: Vec<usize> =
        open.iter().flat_map(|pixel| around(frame, *pixel, spacing, [0, 1])).flatten().collect();
    wanted.sort_unstable();
    wanted.dedup();
    wanted.retain(|pixel| known[*pixel].is_none() && frame.seen(*pixel).is_some());
    wanted
}

/// Pixels of the lattice from `steps[0]` to `steps[1]` of its steps from the one before a pixel, both ways;
/// only the pixel itself where all belong to the lattice.
fn around(
    frame: &Frame,
    pixel: usize,
    spacing: usize,
    steps: [isize; 2],
) -> impl Iterator<Item = Option<usize>> {
    let steps = if spacing == 1 { [0, 0] } else { steps };
    let first = frame.place(pixel).map(|at| (at - at % spacing) as isize);
    let side = steps[0]..=steps[1];
    let places = side.clone().flat_map(move |j| side.clone().map(move |i| [i, j]));
    places.map(move |[i, j]| frame.pixel([first[0] + i * spacing as isize, first[1] + j * spacing as isize]))
}

/// The value of a pixel, computed or fitted; None where the lattice is too coarse.
fn fitted(
    frame: &Frame,
    known: &[Option<ComputedLight>],
    pixel: usize,
    spacing: usize,
    other: f64,
) -> Option<Vec<f64>> {
    let seen = frame.seen(pixel)?;
    let own = known[pixel].as_ref();
    if let Some(ComputedLight { bands, error: 0.0 }) = own {
        return Some(bands.clone());
    }
    let between = || {
        fit_of(frame, known, pixel, seen, spacing).found().and_then(|found| trusted(found, spacing, other))
    };
    let goes = |other: Option<usize>| {
        other.and_then(|other| frame.seen(other)).is_some_and(|other| seen.goes_with(other))
    };
    let is_inside = spacing < COARSEST || around(frame, pixel, spacing, [0, 1]).all(goes);
    let found = if is_inside { between() } else { None };
    found.or_else(|| own.map(|own| own.bands.clone()))
}

/// The fit of the known values around a pixel, on the same smooth surface.
fn fit_of<'a>(
    frame: &Frame,
    known: &'a [Option<ComputedLight>],
    pixel: usize,
    seen: &SeenPlace,
    spacing: usize,
) -> Fit<'a> {
    let mut fit = Fit::new();
    let [column, row] = frame.place(pixel);
    for other in around(frame, pixel, spacing, [-1, 2]).flatten() {
        let (Some(value), Some(there)) = (&known[other], frame.seen(other)) else { continue };
        let [x, y] = frame.place(other);
        let apart = [x as f64 - column as f64, y as f64 - row as f64];
        let weight = weight(apart, 2.0 * spacing as f64);
        if weight > 0.0 && seen.goes_with(there) {
            fit.take(offset(seen, there), weight, &value.bands, value.error);
        }
    }
    fit
}

/// The value of a fit, if it is trusted beside `other` light. Light below 0 by no more than a fit may leave
/// is none.
fn trusted(found: FitResult, spacing: usize, other: f64) -> Option<Vec<f64>> {
    let FitResult { value, residual, noise, aside, bend } = found;
    let size = value.iter().map(|value| value.max(0.0)).sum::<f64>() + other;
    let rough = if spacing <= SMALL { 2.0 * ROUGH } else { ROUGH } * size;
    let most = rough.hypot(noise);
    let bend = bend.or((spacing <= IN_A_ROW).then_some(0.0))?;
    let is_smooth = aside <= ASIDE && residual <= most && bend <= BENT * most;
    let is_light = value.iter().all(|value| *value >= -rough);
    (is_smooth && is_light).then(|| value.into_iter().map(|value| value.max(0.0)).collect())
}

/// (1 − (r/R)²)².
fn weight([x, y]: [f64; 2], reach: f64) -> f64 {
    (1.0 - (x * x + y * y) / (reach * reach)).max(0.0).powi(2)
}

/// The offset of a place in the tangent plane of another.
fn offset(from: &SeenPlace, to: &SeenPlace) -> [f64; 2] {
    let (along, across) = from.normal.any_orthonormal_pair();
    let step = to.place.position - from.place.position;
    [step.dot(along), step.dot(across)]
}
