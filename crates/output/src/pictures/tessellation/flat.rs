//! Flat surfaces: convex pieces, cut further only where the parameters are not affine in the plane.

use radiosity_elements::cells::cells_of;
use radiosity_elements::clip_to_cell;
use radiosity_geom::{DVec3, Surface};

use super::corner::Corner;

/// Most cells along a parameter. Chosen: the error of what a planar quadrilateral needs at all falls as the
/// square of their number.
const FINEST: usize = 64;

/// The `pieces` of a flat surface with the parameters of their corners, so cut that parameters interpolated
/// over a triangle lie within `tolerance` (scene length) of their places.
pub(super) fn facets(shape: &dyn Surface, pieces: Vec<Vec<DVec3>>, tolerance: f64) -> Vec<Vec<Corner>> {
    let mut cells = 1;
    loop {
        let parts = match cells {
            1 => pieces.clone(),
            _ => cells_of([cells; 2]).flat_map(|rect| clip_to_cell(shape, &pieces, &rect)).collect(),
        };
        let facets: Vec<Vec<Corner>> =
            parts.iter().map(|part| part.iter().map(|x| corner(shape, *x)).collect()).collect();
        if cells >= FINEST || facets.iter().all(|facet| skew(shape, facet) <= tolerance) {
            return facets;
        }
        cells *= 2;
    }
}

fn corner(shape: &dyn Surface, position: DVec3) -> Corner {
    let foot = shape.project(position);
    Corner { position, parameters: [foot.u, foot.v] }
}

/// Greatest distance of the point at a triangle's mean parameters from the triangle's middle, over the fan of
/// a facet (scene length).
fn skew(shape: &dyn Surface, facet: &[Corner]) -> f64 {
    let apart = |k: usize| {
        let corners = [facet[0], facet[k], facet[k + 1]];
        let middle = corners.iter().map(|corner| corner.position).sum::<DVec3>() / 3.0;
        let mean = |axis: usize| corners.iter().map(|corner| corner.parameters[axis]).sum::<f64>() / 3.0;
        shape.jet(mean(0), mean(1)).position.distance(middle)
    };
    (1..facet.len() - 1).map(apart).fold(0.0, f64::max)
}
