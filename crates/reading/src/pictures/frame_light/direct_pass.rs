//! Direct light at the places of a frame: computed at the pixels of a coarse grid, and between them fitted where it is
//! even, computed where it is not.
//!
//! Around a pixel a polynomial is fitted to the light of the grid's pixels on its surface (`light_field::fit`). It
//! holds where the corners of its cell are on that surface, and where it leaves at most ε/2 of all light E, or of
//! √(E Ē) in places darker than the mean Ē of the scene, beside their own errors. Of every cell of the grid one more
//! pixel is computed: where its fit errs by more, as across a shadow that is narrower than a cell, the pixels around
//! are computed too, and so on along that shadow. A shadow is missed where it is narrower than a pixel, or lies in a
//! cell or two.
//!
//! By few rays first, and by more where pixels beside each other see other emitters.

use radiosity_elements::sampling::shift::{number_of, shift};
use radiosity_light::penumbra::{RayEffort, VisibleEmitters};
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use super::frame::Frame;
use crate::pictures::eye::SeenPlace;
use crate::pictures::light_field::fit::{Fit, weight};
use crate::pictures::light_field::offset;
use crate::pictures::neighbourhoods::Neighbourhoods;
use crate::pictures::picture_light::{DirectIrradiance, PictureLight};
use crate::pictures::pixel_count::PixelCount;

/// Pixels from one of the grid to the next. Chosen.
pub(super) const STEP: usize = 4;

/// Error that a fit may leave, over that of light that is computed. Chosen: what it errs by is smaller.
const FITTED: f64 = 0.5;

/// Pixels that are compared with one, to each side. Chosen: with first rays that miss a shadow in four of
/// five pixels, one of so many still finds it.
const BESIDE: isize = 2;

/// Pixels that one thread looks at after each other. Chosen: they take some microseconds each.
const TOGETHER: usize = 64;

/// Light of a pixel.
#[derive(Clone, Debug)]
enum PixelLight {
    /// Nothing is seen, or nothing is known yet.
    Unknown,
    /// Irradiance per band (W m⁻²) by a fit.
    Fitted(Vec<f64>),
    Computed(DirectIrradiance),
}

/// Direct light at the pixels of a frame, as far as it is known.
struct DirectPass<'a> {
    frame: &'a Frame,
    light: &'a PictureLight<'a>,
    neighbourhoods: Neighbourhoods,
    work: &'a Work<'a>,
    /// Pixels that see anything and whose light is known.
    known: PixelCount<'a>,
    pixels: Vec<PixelLight>,
}

/// The direct irradiance per band (W m⁻²) of all pixels; nothing where nothing is seen.
pub(crate) fn lit(frame: &Frame, light: &PictureLight, work: &Work<'_>) -> Vec<Vec<f64>> {
    let mut pass = DirectPass::new(frame, light, work);
    if light.penumbra().is_some() {
        pass.compute(&pass.grid(), true);
        pass.fit();
        pass.test();
        pass.count_fitted();
    }
    let open: Vec<usize> = (0..frame.len()).filter(|pixel| pass.is_open(*pixel)).collect();
    pass.compute(&open, false);
    pass.make_sure(&open);
    pass.bands()
}

impl<'a> DirectPass<'a> {
    fn new(frame: &'a Frame, light: &'a PictureLight<'a>, work: &'a Work<'a>) -> Self {
        let neighbourhoods =
            Neighbourhoods::of(light, frame.len(), |pixel| Some((frame.place(pixel), frame.seen(pixel)?)));
        let sees = (0..frame.len()).filter(|pixel| frame.seen(*pixel).is_some()).count();
        let known = PixelCount::new(sees, Stage::DirectPixels, work);
        Self { frame, light, neighbourhoods, work, known, pixels: vec![PixelLight::Unknown; frame.len()] }
    }

    /// The pixels of the grid that see anything.
    fn grid(&self) -> Vec<usize> {
        let is_of_grid = |pixel: &usize| self.frame.place(*pixel).iter().all(|at| at % STEP == 0);
        (0..self.frame.len()).filter(is_of_grid).filter(|pixel| self.frame.seen(*pixel).is_some()).collect()
    }

    fn is_open(&self, pixel: usize) -> bool {
        matches!(self.pixels[pixel], PixelLight::Unknown) && self.frame.seen(pixel).is_some()
    }

    /// Computes the light of these pixels.
    fn compute(&mut self, pixels: &[usize], sure: bool) {
        let effort = RayEffort { error_factor: 1.0, sure };
        let part = if sure { PartName::MoreDirectLight } else { PartName::DirectLight };
        let computed: Vec<DirectIrradiance> =
            self.work.ranks.map_even(part, pixels.len(), TOGETHER, |index| {
                let around = self.neighbourhoods.around(pixels[index]);
                let direct = |seen: &SeenPlace| self.light.direct(seen, around, effort);
                let lit = self.frame.seen(pixels[index]).map_or_else(DirectIrradiance::default, direct);
                // Others are computed anew.
                if matches!(self.pixels[pixels[index]], PixelLight::Unknown) {
                    self.known.add();
                }
                lit
            });
        for (pixel, lit) in pixels.iter().zip(computed) {
            self.pixels[*pixel] = PixelLight::Computed(lit);
        }
    }

    /// Fits the light of all other pixels where fits hold.
    fn fit(&mut self) {
        let open: Vec<usize> = (0..self.frame.len()).filter(|pixel| self.is_open(*pixel)).collect();
        let fitted: Vec<Option<Vec<f64>>> = open.par_iter().map(|pixel| self.fitted(*pixel)).collect();
        for (pixel, fitted) in open.into_iter().zip(fitted) {
            self.pixels[pixel] = fitted.map_or(PixelLight::Unknown, PixelLight::Fitted);
        }
    }

    /// The light of a pixel by those of the grid around; None where that is not even.
    fn fitted(&self, pixel: usize) -> Option<Vec<f64>> {
        let seen = self.frame.seen(pixel)?;
        let mut fit = Fit::new();
        let at = self.frame.place(pixel);
        let first = at.map(|at| (at / STEP) as isize);
        for (i, j) in (-1..=2).flat_map(|j| (-1..=2).map(move |i| (first[0] + i, first[1] + j))) {
            let Some(node) = self.frame.pixel([i, j].map(|at| at * STEP as isize)) else {
                // Beyond the last of the grid nothing says what light does.
                if is_corner([i, j], at) {
                    return None;
                }
                continue;
            };
            let beside = self.frame.seen(node).filter(|there| seen.goes_with(there));
            let (PixelLight::Computed(lit), Some(there)) = (&self.pixels[node], beside) else {
                if is_corner([i, j], at) {
                    return None;
                }
                continue;
            };
            let weight = weight(apart(at, [i, j]));
            if weight == 0.0 {
                continue;
            }
            fit.take(offset(seen, there), weight, &lit.bands, lit.error);
        }
        let found = fit.found()?;
        (found.left() <= self.tolerance(seen, &found.value)).then_some(found.value)
    }

    /// Most error of the sum over the bands (W m⁻²) at a place with this direct light.
    fn tolerance(&self, seen: &SeenPlace, direct: &[f64]) -> f64 {
        let all = direct.iter().sum::<f64>() + self.light.polynomials(seen).iter().sum::<f64>();
        FITTED * self.light.eps() * self.light.judged_by(all)
    }

    /// Computes the light of a pixel of every cell with fitted ones, and of those around where a fit errs by more
    /// than is allowed.
    fn test(&mut self) {
        let mut asked = self.tests();
        while !asked.is_empty() {
            let fits: Vec<PixelLight> = asked.iter().map(|pixel| self.pixels[*pixel].clone()).collect();
            self.compute(&asked, true);
            let mut around = vec![];
            for (pixel, fit) in asked.into_iter().zip(fits) {
                if self.is_off(pixel, &fit) {
                    around.extend(self.fitted_around(pixel));
                }
            }
            around.sort_unstable();
            around.dedup();
            asked = around;
        }
    }

    /// One fitted pixel of every cell, each at another place in it.
    fn tests(&self) -> Vec<usize> {
        let mut asked = Vec::new();
        for cell in self.grid() {
            let [column, row] = self.frame.place(cell);
            let choice: [f64; 2] = shift(number_of([column as f64, row as f64]));
            let [i, j] = choice.map(|part| (part * STEP as f64) as usize);
            let pixel = self.frame.pixel([(column + i) as isize, (row + j) as isize]);
            asked.extend(pixel.filter(|pixel| self.is_fitted(*pixel)));
        }
        asked
    }

    fn is_fitted(&self, pixel: usize) -> bool {
        matches!(self.pixels[pixel], PixelLight::Fitted(_))
    }

    /// Counts the pixels whose fits hold, and those that were computed to test fits.
    fn count_fitted(&self) {
        let known = self.pixels.iter().filter(|light| !matches!(light, PixelLight::Unknown)).count();
        (self.grid().len()..known).for_each(|_| self.known.add());
    }

    /// Whether a fit errs by more than is allowed at a pixel that is computed.
    fn is_off(&self, pixel: usize, fit: &PixelLight) -> bool {
        let (PixelLight::Computed(lit), PixelLight::Fitted(fitted), Some(seen)) =
            (&self.pixels[pixel], fit, self.frame.seen(pixel))
        else {
            return false;
        };
        let off = lit.bands.iter().sum::<f64>() - fitted.iter().sum::<f64>();
        off.abs() > self.tolerance(seen, &lit.bands) + 2.0 * lit.error
    }

    /// The fitted pixels around one, as far away as the next of the grid.
    fn fitted_around(&self, pixel: usize) -> impl Iterator<Item = usize> {
        let [column, row] = self.frame.place(pixel).map(|at| at as isize);
        let reach = -(STEP as isize)..=STEP as isize;
        let all = reach.clone().flat_map(move |j| reach.clone().map(move |i| [column + i, row + j]));
        all.filter_map(|at| self.frame.pixel(at)).filter(|pixel| self.is_fitted(*pixel))
    }

    /// Computes again those of the pixels `asked` of which it is not sure what they see.
    fn make_sure(&mut self, asked: &[usize]) {
        let is_unsure = |pixel: &&usize| self.is_unsure(**pixel);
        let unsure: Vec<usize> = asked.par_iter().filter(is_unsure).copied().collect();
        self.compute(&unsure, true);
    }

    /// Whether a pixel sees some emitters wholly and the others not at all, but one beside it on the same surface
    /// does not see the same.
    fn is_unsure(&self, pixel: usize) -> bool {
        let (Some(seen), Some(visible @ VisibleEmitters::Sees(_))) =
            (self.frame.seen(pixel), self.visible(pixel))
        else {
            return false;
        };
        let [column, row] = self.frame.place(pixel).map(|at| at as isize);
        let mut beside =
            (-BESIDE..=BESIDE).flat_map(|j| (-BESIDE..=BESIDE).map(move |i| [column + i, row + j]));
        beside.any(|at| {
            self.frame.pixel(at).is_some_and(|other| {
                self.visible(other).is_some_and(|other| other != visible)
                    && self.frame.seen(other).is_some_and(|other| seen.goes_with(other))
            })
        })
    }

    /// Emitters that a pixel sees, where that is known.
    fn visible(&self, pixel: usize) -> Option<VisibleEmitters> {
        match &self.pixels[pixel] {
            PixelLight::Computed(lit) => lit.visible,
            PixelLight::Unknown | PixelLight::Fitted(_) => None,
        }
    }

    fn bands(self) -> Vec<Vec<f64>> {
        let own = |light| match light {
            PixelLight::Unknown => Vec::new(),
            PixelLight::Fitted(bands) => bands,
            PixelLight::Computed(lit) => lit.bands,
        };
        self.pixels.into_iter().map(own).collect()
    }
}

/// Whether a pixel of the grid, in steps of it, is a corner of the cell of another pixel.
fn is_corner(node: [isize; 2], pixel: [usize; 2]) -> bool {
    apart(pixel, node).iter().all(|apart| apart.abs() < 1.0)
}

/// How far a pixel is from one of the grid, along and down (steps of the grid).
fn apart(pixel: [usize; 2], node: [isize; 2]) -> [f64; 2] {
    std::array::from_fn(|axis| pixel[axis] as f64 / STEP as f64 - node[axis] as f64)
}
