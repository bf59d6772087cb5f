//! Sizes of light textures: texels of about one size on all surfaces, as many as a budget allows.
//!
//! A surface whose parameter lines are at most a and b long along u and v gets ⌈a/h⌉ + 1 by ⌈b/h⌉ + 1 texels
//! of the side h, with h the least for which all together stay within the budget.

use radiosity_geom::Surface;
use radiosity_scene::Scene;

use crate::pictures::light_field::extent::Extent;

/// Fewest texels along a parameter of a flat surface, and of a curved one, on which light varies with the
/// normal; most of any. All are chosen.
const FEWEST: usize = 2;
const FEWEST_CURVED: usize = 9;
const MOST: usize = 2048;

/// Halvings of the range of h, in ratio: more than its digits.
const HALVINGS: usize = 60;

/// Texels along u and v of each surface, `texels` together.
pub(super) fn sizes(scene: &Scene, texels: usize) -> Vec<[usize; 2]> {
    let sizes: Vec<Size> = scene.surfaces.iter().map(|surface| Size::of(surface.shape.as_ref())).collect();
    let longest = sizes.iter().flat_map(|size| size.extent.lengths).fold(0.0, f64::max);
    // At the finer end one surface alone is past the budget, unless it has its fewest.
    let (mut fine, mut coarse) = (longest / (texels + MOST) as f64, longest);
    for _ in 0..HALVINGS {
        let side = (fine * coarse).sqrt();
        let count: usize = sizes.iter().map(|size| size.texels(side)).map(|[w, h]| w * h).sum();
        if count <= texels { coarse = side } else { fine = side }
    }
    sizes.iter().map(|size| size.texels(coarse)).collect()
}

/// The extent of a surface, and the fewest texels along its parameters.
struct Size {
    extent: Extent,
    fewest: usize,
}

impl Size {
    fn of(shape: &dyn Surface) -> Self {
        let fewest = if shape.region().is_some() { FEWEST } else { FEWEST_CURVED };
        Self { extent: Extent::of(shape), fewest }
    }

    /// Texels of about the side `side`.
    fn texels(&self, side: f64) -> [usize; 2] {
        self.extent
            .lengths
            .map(|length| (length / side).ceil().min(MOST as f64) as usize + 1)
            .map(|count| count.clamp(self.fewest, MOST))
    }
}
