//! Triangles of every surface, for programs that draw triangles: positions, normals and parameters at their
//! corners.
//!
//! Flat surfaces become the fewest convex pieces that the scene knows them by, cut into fans; where a sheet
//! lies on them they are left out, so that no two triangles fill one place. Bodies that stand on a surface
//! hide it and cut nothing. Curved surfaces are cut along lines of constant u and v, finely enough that the
//! surface and its parameters are nowhere farther from the triangles than a tolerance. Corners that two flat
//! surfaces share are the same in both to the last bit.
//!
//! Triangles run counter-clockwise seen from the front.

mod corner;
mod flat;
mod curved;

use std::collections::HashMap;

use radiosity_geom::{DVec3, NO_AREA, PlanarRegion, Surface};
use radiosity_scene::{Scene, SceneSurface};
use radiosity_visibility::covered_parts::{CoveredPart, CoveredParts, without};
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use corner::Corner;

/// The triangles of one surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangulation {
    /// Corners (scene length), in the coordinates that the scene is computed in: less
    /// [`Scene::middle`](radiosity_scene::Scene::middle).
    pub positions: Vec<DVec3>,
    /// Unit normal of the front at each corner.
    pub normals: Vec<DVec3>,
    /// Parameters (u, v) ∈ [−1, 1]² of each corner.
    pub parameters: Vec<[f64; 2]>,
    /// Indices of the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// The triangles of all surfaces of `scene`; curved surfaces are met within `tolerance` (scene length).
pub fn tessellation(scene: &Scene, tolerance: f64) -> Vec<Triangulation> {
    let covered_parts = CoveredParts::new(scene);
    let surface = |(index, surface): (usize, &SceneSurface)| {
        check_interrupt();
        let shape = surface.shape.as_ref();
        let facets = match shape.region() {
            Some(region) => {
                let own: Vec<&CoveredPart> = covered_parts.of_surface(index).collect();
                flat::facets(shape, open_pieces(region, &own), tolerance)
            }
            None => curved::facets(shape, tolerance),
        };
        Triangulation::of(shape, facets)
    };
    scene.surfaces.par_iter().enumerate().map(surface).collect()
}

/// Convex pieces of a flat surface outside its `covered_parts`: with no corners on its borders other than its
/// own, where that can be.
fn open_pieces(region: &PlanarRegion, covered_parts: &[&CoveredPart]) -> Vec<Vec<DVec3>> {
    if covered_parts.is_empty() {
        return region.convex_pieces().to_vec();
    }
    let covered = covered_parts.iter().flat_map(|cover| cover.pieces.clone());
    let holes = region.holes().iter().cloned().chain(covered).collect();
    match PlanarRegion::new(region.outer().to_vec(), holes) {
        Ok(open) => open.convex_pieces().to_vec(),
        // Covered parts that reach the border, or lie beside each other, are no holes.
        Err(_) => {
            let holes = covered_parts.iter().flat_map(|part| &part.pieces);
            without(region.convex_pieces().to_vec(), holes, region.normal())
        }
    }
}

impl Triangulation {
    /// The triangles of convex facets of a surface, cut into fans; equal corners become one, and what has no
    /// area is left out.
    fn of(shape: &dyn Surface, facets: Vec<Vec<Corner>>) -> Self {
        let mut triangulation = Self::default();
        let mut known = HashMap::new();
        for facet in facets {
            let own: Vec<u32> = facet
                .into_iter()
                .map(|corner| {
                    let key = corner.parameters.map(f64::to_bits);
                    *known.entry(key).or_insert_with(|| triangulation.add(shape, corner))
                })
                .collect();
            for k in 1..own.len() - 1 {
                triangulation.push([own[0], own[k], own[k + 1]]);
            }
        }
        triangulation
    }

    /// Adds a corner; its index.
    fn add(&mut self, shape: &dyn Surface, Corner { position, parameters: [u, v] }: Corner) -> u32 {
        self.positions.push(position);
        self.normals.push(shape.jet(u, v).normal);
        self.parameters.push([u, v]);
        self.positions.len() as u32 - 1
    }

    /// Adds a triangle, its front turned to that of the surface, unless it has no area.
    fn push(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|corner| self.positions[corner as usize]);
        let across = (b - a).cross(c - a);
        let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
        if across.length() <= NO_AREA * longest {
            return;
        }
        let front: DVec3 = corners.iter().map(|corner| self.normals[*corner as usize]).sum();
        let [a, b, c] = corners;
        self.triangles.push(if across.dot(front) < 0.0 { [a, c, b] } else { corners });
    }
}
