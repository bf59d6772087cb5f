//! Surfaces outside openings: an opening sends the light of the whole sky, whatever stands before it outside.

use std::collections::BTreeSet;
use std::sync::Arc;

use radiosity_geom::{DVec3, Encounter, PlanarRegion, RayTree, Surface};
use radiosity_scene::{Scene, SceneSurface};
use radiosity_work::listed::quoted;

use crate::golden_spiral;
use crate::inspection::warning::Warning;

/// Code of the warning.
pub const BEFORE_OPENINGS: &str = "outside";

/// Rays from each point of an opening. Chosen: those of a rectangle, five times as many, see what hides a hundredth of
/// the sky.
const RAYS: usize = 256;

/// Rays that have to meet a surface, as one may slip along a wall.
const LEAST_MET: usize = 3;

/// A warning for each opening before which something stands outside.
pub fn before_openings(scene: &Scene) -> Vec<Warning> {
    if !scene.surfaces.iter().any(SceneSurface::is_opening) {
        return Vec::new();
    }
    let tree = RayTree::new(scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect());
    let openings = (0..scene.surfaces.len()).filter(|surface| scene.surfaces[*surface].is_opening());
    openings.filter_map(|opening| warning(scene, opening, &outside(scene, &tree, opening))).collect()
}

fn warning(scene: &Scene, opening: usize, outside: &BTreeSet<usize>) -> Option<Warning> {
    let names: Vec<&str> = outside.iter().map(|own| scene.surfaces[*own].name.as_str()).collect();
    let message = format!(
        "is an opening to the sky, and {}, outside before it, {} none of that: leave the opening a hole, and \
         close the space outside, beyond what stands there, with openings",
        quoted(&names),
        if names.len() == 1 { "hides" } else { "hide" },
    );
    (!names.is_empty()).then(|| Warning::about(BEFORE_OPENINGS, &scene.surfaces[opening].name, message))
}

/// The surfaces that rays from an opening meet outside.
fn outside(scene: &Scene, tree: &RayTree, opening: usize) -> BTreeSet<usize> {
    let shape = &scene.surfaces[opening].shape;
    let out = -shape.jet(0.0, 0.0).normal;
    // The front of another opening shines into the same room.
    let is_outside = |found: &Encounter| !(found.front && scene.surfaces[found.surface].is_opening());
    // Both sides of a sheet count as its front.
    let sheet =
        |surface: usize| scene.surfaces[surface].other_side.map_or(surface, |other| other.min(surface));
    let mut met = vec![0; scene.surfaces.len()];
    for point in points(shape.as_ref()) {
        let found = (0..RAYS).filter_map(|ray| tree.nearest_from(opening, point, direction(out, ray)));
        found.filter(is_outside).for_each(|found| met[sheet(found.surface)] += 1);
    }
    (0..met.len()).filter(|own| met[*own] >= LEAST_MET).collect()
}

/// Points of a flat surface: the middle of each convex piece, and halfway to its corners.
fn points(shape: &dyn Surface) -> Vec<DVec3> {
    let pieces = shape.region().map_or(&[][..], PlanarRegion::convex_pieces);
    let of_piece = |piece: &Vec<DVec3>| {
        let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
        let halfway: Vec<DVec3> = piece.iter().map(|corner| 0.5 * (middle + *corner)).collect();
        [middle].into_iter().chain(halfway)
    };
    pieces.iter().flat_map(of_piece).collect()
}

/// A direction by the cosine about a unit vector, of [`RAYS`] along a golden spiral.
fn direction(about: DVec3, ray: usize) -> DVec3 {
    let (x, y) = about.any_orthonormal_pair();
    let square = (ray as f64 + 0.5) / RAYS as f64;
    let (sine, cosine) = golden_spiral::turn(ray);
    square.sqrt() * (cosine * x + sine * y) + (1.0 - square).sqrt() * about
}
