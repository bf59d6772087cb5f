//! Clips the polygons of a pair by the plane of the other element.
//!
//! The kernel between two planar elements is zero beyond the line where the plane of one cuts the other,
//!
//! ```text
//! κ(x, y) ∝ max(0, n_x·(y − x)) max(0, n_y·(x − y)) ,
//! ```
//!
//! because either height is over one plane, the same for all points of the other element. Cutting along this
//! line once keeps all rules away from it.

use radiosity_elements::patch::Patch;
use radiosity_geom::Plane;
use radiosity_kernel::contact::clip::Facet;

/// The parts of two elements, flat ones without what lies behind the other's plane, if it has one in
/// `planes`. Points closer to a plane than `tolerance` lie on it.
pub(super) fn clipped(
    [first, second]: [Vec<Patch>; 2],
    planes: [Option<Plane>; 2],
    tolerance: f64,
) -> [Vec<Patch>; 2] {
    [in_front(first, planes[1], tolerance), in_front(second, planes[0], tolerance)]
}

fn in_front(patches: Vec<Patch>, plane: Option<Plane>, tolerance: f64) -> Vec<Patch> {
    let Some(Plane { point, normal }) = plane else { return patches };
    let horizon = Facet { corners: vec![point], normal };
    let seen = |patch: Patch| {
        let Patch::Flat { normal, .. } = patch else { return vec![patch] };
        let whole = Facet::of(&patch);
        match whole.in_front_of(&horizon, tolerance) {
            None => Vec::new(),
            Some(part) if part.corners == whole.corners => vec![patch],
            Some(part) => Patch::of_polygon(&part.corners, normal),
        }
    };
    patches.into_iter().flat_map(seen).collect()
}

#[cfg(test)]
mod tests {
    use radiosity_geom::{DVec3, polygon_area};

    use super::*;

    #[test]
    fn a_floor_ends_at_the_plane_of_what_looks_at_it() {
        let corners = [[0., 0., 0.], [4., 0., 0.], [4., 3., 0.], [0., 3., 0.]].map(DVec3::from_array);
        let floor = Patch::Flat { corners, normal: DVec3::Z };
        let seen = |x: f64, normal: DVec3| -> f64 {
            let parts =
                in_front(vec![floor.clone()], Some(Plane { point: DVec3::new(x, 1.0, 1.0), normal }), 1e-9);
            parts.iter().map(|part| polygon_area(&part.polygon())).sum()
        };
        assert!((seen(1.0, DVec3::X) - 9.0).abs() < 1e-12);
        // The plane rises at 45°: it meets the floor at x = 2.
        assert!((seen(3.0, DVec3::new(-1.0, 0.0, 1.0).normalize()) - 6.0).abs() < 1e-12);
        assert_eq!([seen(5.0, -DVec3::X), seen(5.0, DVec3::X)], [12.0, 0.0]);
    }
}
