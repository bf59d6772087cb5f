//! What of polygons lies before the plane of the other element.
//!
//! The kernel between two planar elements is clipped at the lines where the plane of each cuts the other:
//!
//! ```text
//! κ(x, y) ∝ max(0, n_x·(y − x)) max(0, n_y·(x − y)) ,
//! ```
//!
//! and either height is that over one plane, for all points of the other element. A polygon is cut along that line once, so
//! that no rule ever meets it.

use crate::elements::patch::Patch;
use crate::kernel::clip::Facet;
use crate::kernel::planes::Plane;

/// The parts of two elements that lie in `planes` if in any, those that are flat without what lies behind the other's plane;
/// points closer to it than `tolerance` lie on it.
pub(super) fn each_other(
    [first, second]: [Vec<Patch>; 2],
    planes: [Option<Plane>; 2],
    tolerance: f64,
) -> [Vec<Patch>; 2] {
    [before(first, planes[1], tolerance), before(second, planes[0], tolerance)]
}

fn before(patches: Vec<Patch>, plane: Option<Plane>, tolerance: f64) -> Vec<Patch> {
    let Some((point, normal)) = plane else { return patches };
    let horizon = Facet { corners: vec![point], normal };
    let seen = |patch: Patch| {
        let Patch::Flat { normal, .. } = patch else { return vec![patch] };
        let whole = Facet { corners: patch.polygon(), normal };
        match whole.in_front_of(&horizon, tolerance) {
            None => Vec::new(),
            Some(part) if part.corners == whole.corners => vec![patch],
            Some(part) => Patch::of_polygon(&part.corners, normal),
        }
    };
    patches.into_iter().flat_map(seen).collect()
}
