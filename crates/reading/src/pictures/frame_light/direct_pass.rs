//! Direct light at the middles of pixels: by few rays first, and by more where pixels beside each other see
//! other emitters.

use radiosity_light::penumbra::{RayEffort, VisibleEmitters};
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use super::frame::Frame;
use crate::pictures::eye::SeenPlace;
use crate::pictures::neighbourhoods::Neighbourhoods;
use crate::pictures::picture_light::{DirectIrradiance, PictureLight};
use crate::pictures::pixel_count::PixelCount;

/// Pixels that are compared with one, to each side. Chosen: with first rays that miss a shadow in four of
/// five pixels, one of so many still finds it.
const BESIDE: isize = 2;

/// Pixels that one thread looks at after each other. Chosen: they take some microseconds each.
const TOGETHER: usize = 64;

/// The direct irradiance of all pixels; nothing where nothing is seen. All pixels are told, then those that
/// are computed again.
pub(crate) fn lit(frame: &Frame, light: &PictureLight, work: &Work<'_>) -> Vec<Vec<f64>> {
    let neighbourhoods =
        Neighbourhoods::of(light, frame.len(), |pixel| Some((frame.place(pixel), frame.seen(pixel)?)));
    let look = |pixel: usize, sure: bool, pixel_count: &PixelCount| {
        let effort = RayEffort { error_factor: 1.0, sure };
        let around = neighbourhoods.around(pixel);
        let direct = |seen: &SeenPlace| light.direct(seen, around, effort);
        let lit = frame.seen(pixel).map_or_else(DirectIrradiance::default, direct);
        pixel_count.add();
        lit
    };
    let ranks = work.ranks;
    let pixel_count = PixelCount::new(frame.len(), Stage::DirectPixels, work);
    let first: Vec<DirectIrradiance> =
        ranks
            .map_even(PartName::DirectLight, frame.len(), TOGETHER, |pixel| look(pixel, false, &pixel_count));
    let unsure: Vec<usize> =
        (0..frame.len()).into_par_iter().filter(|pixel| is_unsure(frame, &first, *pixel)).collect();
    let pixel_count = PixelCount::new(unsure.len(), Stage::DirectPixels, work);
    let sure = |place: usize| look(unsure[place], true, &pixel_count);
    let again: Vec<DirectIrradiance> =
        ranks.map_even(PartName::MoreDirectLight, unsure.len(), TOGETHER, sure);
    let mut all: Vec<Vec<f64>> = first.into_iter().map(|lit| lit.bands).collect();
    unsure.into_iter().zip(again).for_each(|(pixel, lit)| all[pixel] = lit.bands);
    all
}

/// Whether a pixel sees some emitters wholly and the others not at all, but one beside it on the same surface
/// does not see the same.
fn is_unsure(frame: &Frame, all: &[DirectIrradiance], pixel: usize) -> bool {
    let (Some(seen), Some(visible @ VisibleEmitters::Sees(_))) = (frame.seen(pixel), all[pixel].visible)
    else {
        return false;
    };
    let [column, row] = frame.place(pixel).map(|at| at as isize);
    let beside = (-BESIDE..=BESIDE).flat_map(|j| (-BESIDE..=BESIDE).map(move |i| [column + i, row + j]));
    beside.filter_map(|at| frame.pixel(at)).any(|other| {
        all[other].visible.is_some_and(|other| other != visible)
            && frame.seen(other).is_some_and(|other| seen.goes_with(other))
    })
}
