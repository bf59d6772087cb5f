//! Smooth light over a picture: computed at few pixels, interpolated between them.
//!
//! Light is computed at every [`COARSEST`]-th pixel both ways, and fitted between ([`super::fit`]) from those that lie on
//! the same smooth surface. Where fewer than four do, where they lie too far on one side, or where the fit leaves
//! more than [`ROUGH`], pixels half as far apart follow, down to all pixels: at contacts and in corners, where light changes
//! fast. Near the borders of surfaces the coarsest are not trusted.
//!
//! References: G. Ward, F. Rubinstein, R. Clear, *A ray tracing solution for diffuse interreflection*, SIGGRAPH 1988
//! (interpolation of indirect light); there by the distances of what is seen, here by what the fit leaves.

use rayon::prelude::*;

use super::eye::Seen;
use super::fit::Fit;
use super::frame::Frame;

/// Pixels from one computed value to the next at first: a power of two. Chosen.
pub(super) const COARSEST: usize = 16;

/// What a linear fit may differ by from a quadratic one, over what a fit may leave. Chosen: what remains is smaller by about as
/// much; fits of few values leave little even where light peaks between them.
const BENT: f64 = 3.0;

/// What a fit may leave, over all light of the place, and the pixels between computed values up to which it may leave twice
/// as much: such places are small. Both are chosen.
const ROUGH: f64 = 4e-3;
const SMALL: usize = 4;

/// How far on one side values may lie; and between pixels. Chosen: without the former, light was 5 % off at the border of a
/// ceiling.
const ASIDE: f64 = 0.25;
const ASIDE_BETWEEN: f64 = 0.8;

/// Reach of the fit for places between pixels, in pixels.
const BETWEEN: f64 = 2.5;

/// Light that is computed where it is wanted.
pub(super) trait Source: Sync {
    /// The smooth light (W m⁻²) per band at a pixel and what it sees.
    fn smooth(&self, pixel: usize, seen: &Seen) -> Vec<f64>;

    /// Other light at the pixel, all bands together.
    fn other(&self, pixel: usize) -> f64;
}

/// Values per band at every pixel of a frame.
#[derive(Debug)]
pub(super) struct Smooth<'a> {
    frame: &'a Frame,
    bands: usize,
    /// Pixel by pixel, bands fastest; zero where nothing is seen.
    values: Vec<f64>,
}

impl<'a> Smooth<'a> {
    /// The light of all pixels of a frame in so many bands.
    pub(super) fn over(frame: &'a Frame, bands: usize, source: &impl Source) -> Self {
        let mut known: Vec<Option<Vec<f64>>> = vec![None; frame.len()];
        let mut values = vec![0.0; frame.len() * bands];
        let mut open: Vec<usize> = (0..frame.len()).filter(|pixel| frame.seen(*pixel).is_some()).collect();
        let mut spacing = COARSEST;
        while !open.is_empty() && spacing > 0 {
            let wanted = wanted(frame, &known, &open, spacing);
            let computed: Vec<Option<Vec<f64>>> = wanted
                .par_iter()
                .with_max_len(1)
                .map(|pixel| frame.seen(*pixel).map(|seen| source.smooth(*pixel, seen)))
                .collect();
            wanted.into_iter().zip(computed).for_each(|(pixel, value)| known[pixel] = value);
            let found: Vec<Option<Vec<f64>>> = open
                .par_iter()
                .map(|pixel| fitted(frame, &known, *pixel, spacing, source.other(*pixel)))
                .collect();
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

    /// The light of a pixel.
    pub(super) fn at(&self, pixel: usize) -> &[f64] {
        &self.values[pixel * self.bands..(pixel + 1) * self.bands]
    }

    /// The light at a place seen at a point of the picture, counted from the first row of the frame; None where no pixel
    /// around sees that surface.
    pub(super) fn between(&self, [x, y]: [f64; 2], seen: &Seen) -> Option<Vec<f64>> {
        let mut fit = Fit::new();
        let [column, row] = [x, y].map(|at| at.floor() as isize);
        for (i, j) in (-2..=2).flat_map(|j| (-2..=2).map(move |i| (i, j))) {
            let Some(pixel) = self.frame.pixel([column + i, row + j]) else { continue };
            let middle = [column + i, row + j].map(|at| at as f64 + 0.5);
            self.take(&mut fit, pixel, weight([x - middle[0], y - middle[1]], BETWEEN), seen);
        }
        let found = fit.found().filter(|found| found.aside <= ASIDE_BETWEEN);
        found.map(|found| found.value).or_else(|| fit.mean())
    }

    fn take<'b>(&'b self, fit: &mut Fit<'b>, pixel: usize, weight: f64, seen: &Seen) {
        let Some(other) = self.frame.seen(pixel).filter(|other| weight > 0.0 && seen.goes_with(other)) else {
            return;
        };
        fit.take(offset(seen, other), weight, self.at(pixel));
    }
}

/// The pixels to compute: around those that are open, the next ones of the lattice.
fn wanted(frame: &Frame, known: &[Option<Vec<f64>>], open: &[usize], spacing: usize) -> Vec<usize> {
    let mut wanted: Vec<usize> =
        open.iter().flat_map(|pixel| around(frame, *pixel, spacing, [0, 1])).flatten().collect();
    wanted.sort_unstable();
    wanted.dedup();
    wanted.retain(|pixel| known[*pixel].is_none() && frame.seen(*pixel).is_some());
    wanted
}

/// Pixels of the lattice from `steps[0]` to `steps[1]` of its steps from the one before a pixel, both ways; only the pixel itself
/// where all belong to the lattice.
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
    known: &[Option<Vec<f64>>],
    pixel: usize,
    spacing: usize,
    other: f64,
) -> Option<Vec<f64>> {
    if let Some(value) = &known[pixel] {
        return Some(value.clone());
    }
    let seen = frame.seen(pixel)?;
    let goes = |other: Option<usize>| {
        other.and_then(|other| frame.seen(other)).is_some_and(|other| seen.goes_with(other))
    };
    if spacing == COARSEST && !around(frame, pixel, spacing, [0, 1]).all(goes) {
        return None;
    }
    let mut fit = Fit::new();
    let [column, row] = frame.place(pixel);
    for other in around(frame, pixel, spacing, [-1, 2]).flatten() {
        let (Some(value), Some(there)) = (&known[other], frame.seen(other)) else { continue };
        let [x, y] = frame.place(other);
        let apart = [x as f64 - column as f64, y as f64 - row as f64];
        let weight = weight(apart, 2.0 * spacing as f64);
        if weight > 0.0 && seen.goes_with(there) {
            fit.take(offset(seen, there), weight, value);
        }
    }
    let found = fit.found().filter(|found| found.aside <= ASIDE)?;
    let own: f64 = found.value.iter().sum();
    let rough = if spacing <= SMALL { 2.0 * ROUGH } else { ROUGH };
    (found.residual.max(found.bend / BENT) * own <= rough * (own + other)).then_some(found.value)
}

/// (1 − (r/R)²)².
fn weight([x, y]: [f64; 2], reach: f64) -> f64 {
    (1.0 - (x * x + y * y) / (reach * reach)).max(0.0).powi(2)
}

/// The offset of a place in the tangent plane of another.
fn offset(from: &Seen, to: &Seen) -> [f64; 2] {
    let (along, across) = from.normal.any_orthonormal_pair();
    let step = to.place.position - from.place.position;
    [step.dot(along), step.dot(across)]
}
