//! Sizes of light textures: texels of about one size on all surfaces, as many as a budget allows.
//!
//! A surface whose parameter lines are at most a and b long along u and v gets ⌈a/h⌉ + 1 by ⌈b/h⌉ + 1 texels
//! of the side h, with h the least for which all together stay within the budget.

use radiosity_geom::Surface;
use radiosity_scene::Scene;

/// Fewest texels along a parameter of a flat surface, and of a curved one, on which light varies with the
/// normal; most of any. All are chosen.
const FEWEST: usize = 2;
const FEWEST_CURVED: usize = 9;
const MOST: usize = 2048;

/// Parts of a parameter line whose lengths are added; parameter lines that are measured.
const PIECES: usize = 16;
const LINES: usize = 5;

/// Halvings of the range of h, in ratio: more than its digits.
const HALVINGS: usize = 60;

/// Texels along u and v of each surface, `texels` together.
pub(super) fn sizes(scene: &Scene, texels: usize) -> Vec<[usize; 2]> {
    let extents: Vec<Extent> =
        scene.surfaces.iter().map(|surface| Extent::of(surface.shape.as_ref())).collect();
    let longest = extents.iter().flat_map(|extent| extent.lengths).fold(0.0, f64::max);
    // At the finer end one surface alone is past the budget, unless it has its fewest.
    let (mut fine, mut coarse) = (longest / (texels + MOST) as f64, longest);
    for _ in 0..HALVINGS {
        let side = (fine * coarse).sqrt();
        let count: usize = extents.iter().map(|extent| extent.size(side)).map(|[w, h]| w * h).sum();
        if count <= texels { coarse = side } else { fine = side }
    }
    extents.iter().map(|extent| extent.size(coarse)).collect()
}

/// The extent of a surface along its parameter lines.
struct Extent {
    /// Lengths of the longest lines along u and along v (scene length).
    lengths: [f64; 2],
    fewest: usize,
}

impl Extent {
    fn of(shape: &dyn Surface) -> Self {
        let at = |s: f64, t: f64| shape.jet(2.0 * s - 1.0, 2.0 * t - 1.0).position;
        let length = |line: &dyn Fn(f64) -> radiosity_geom::DVec3| -> f64 {
            let place = |k: usize| line(k as f64 / PIECES as f64);
            (0..PIECES).map(|k| place(k).distance(place(k + 1))).sum()
        };
        let lines = || (0..LINES).map(|k| k as f64 / (LINES - 1) as f64);
        let along = lines().map(|t| length(&|s| at(s, t))).fold(0.0, f64::max);
        let across = lines().map(|s| length(&|t| at(s, t))).fold(0.0, f64::max);
        let fewest = if shape.region().is_some() { FEWEST } else { FEWEST_CURVED };
        Self { lengths: [along, across], fewest }
    }

    /// Texels of about the side `side`.
    fn size(&self, side: f64) -> [usize; 2] {
        self.lengths
            .map(|length| (length / side).ceil().min(MOST as f64) as usize + 1)
            .map(|count| count.clamp(self.fewest, MOST))
    }
}
