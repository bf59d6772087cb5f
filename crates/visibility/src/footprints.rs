//! Footprints: the parts of planar surfaces on which bodies stand, which no light reaches.
//!
//! A box on a floor hides the floor under it. The darkness there has a sharp edge that no polynomial follows,
//! so elements have to end at the foot of the box. The surface's outline and all lines of contact draw a
//! planar map (`faces`). A face of the map is a footprint if only backs of surfaces, or other footprints, are
//! seen from it (`seal`). It is cut out of the surface as receiver and sender; as a blocker the surface stays
//! whole.

mod footprint;
mod segments;
mod faces;
mod lines;
mod seal;

use std::sync::Arc;

use radiosity_geom::{DVec3, PlanarRegion, Surface, shapes::Trimmed, touching};
use radiosity_scene::Scene;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use crate::Visibility;
use crate::tolerances::LEFT_BESIDE_FOOTPRINTS;
pub use footprint::Footprint;
use seal::SealCandidate;
use segments::Segments;

/// All footprints of a scene, in the order of their surfaces.
pub fn footprints(scene: &Scene) -> Vec<Footprint> {
    let obstacles = Visibility::open(scene);
    let all = 0..scene.surfaces.len();
    let suspects: Vec<Vec<SealCandidate>> =
        all.into_par_iter().map(|surface| suspects(scene, &obstacles, surface)).collect();
    let suspects: Vec<SealCandidate> = suspects.into_iter().flatten().collect();
    let sealed = seal::sealed(scene, &obstacles, &suspects);
    suspects.into_iter().zip(sealed).filter(|(_, sealed)| *sealed).map(|(s, _)| s.footprint).collect()
}

/// The shapes of all surfaces of a scene, without their footprints.
pub fn bare_shapes(scene: &Scene) -> Vec<Arc<dyn Surface>> {
    let mut shapes: Vec<Arc<dyn Surface>> = scene.surfaces.iter().map(|s| Arc::clone(&s.shape)).collect();
    for own in footprints(scene).chunk_by(|a, b| a.surface == b.surface) {
        cut_out(&mut shapes[own[0].surface], own);
    }
    shapes
}

/// Cuts footprints out of the shape of their surface. Each stays that does not fit beside the holes and those
/// before it, or that is the last uncovered part. All are tried at once, then the halves: what fits together
/// fits one by one.
fn cut_out(shape: &mut Arc<dyn Surface>, footprints: &[Footprint]) {
    check_interrupt();
    let holes = footprints.iter().rev().map(|footprint| footprint.region.outer().to_vec()).collect();
    let largest = footprints.iter().map(|footprint| footprint.region.area()).fold(0.0, f64::max);
    let cut = Trimmed::new(Box::new(Arc::clone(shape)), holes).ok();
    if let Some(cut) = cut.filter(|cut| cut.area() > LEFT_BESIDE_FOOTPRINTS * largest) {
        *shape = Arc::new(cut);
    } else if footprints.len() > 1 {
        let (first, second) = footprints.split_at(footprints.len() / 2);
        cut_out(shape, first);
        cut_out(shape, second);
    }
}

/// The faces, smaller than the whole, that lines of contact cut off from a planar surface.
fn suspects(scene: &Scene, obstacles: &Visibility, surface: usize) -> Vec<SealCandidate> {
    check_interrupt();
    let Some(region) = scene.surfaces[surface].shape.region() else { return Vec::new() };
    let lines = lines::on(scene, obstacles, surface, region);
    if lines.is_empty() {
        return Vec::new();
    }
    let tolerance = touching(region.extent(), 0.0);
    let ends: Vec<[DVec3; 2]> = lines.iter().map(|line| line.ends).collect();
    let drawn = Segments::new([lines::outline(region), ends.clone()].concat());
    let loops = faces::faces(&drawn, &|x| region.to_plane(x), tolerance);
    let contacts = Segments::new(ends);
    let regions = loops.into_iter().filter_map(|ring| PlanarRegion::new(ring, Vec::new()).ok());
    let proper = regions.filter(|face| face.area() < (1.0 - LEFT_BESIDE_FOOTPRINTS) * region.area());
    let suspect = |face: PlanarRegion| {
        let standing = lines::around(&lines, &contacts, &face);
        SealCandidate::new(Footprint { surface, region: face, standing }, region)
    };
    let mut found: Vec<SealCandidate> = proper.map(suspect).collect();
    seal::keep_apart(&mut found);
    found
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::shapes::Parallelogram;

    use super::*;

    /// The rule itself: one footprint after the other.
    fn one_by_one(whole: &Arc<dyn Surface>, footprints: &[Footprint]) -> Arc<dyn Surface> {
        footprints.iter().fold(Arc::clone(whole), |shape, Footprint { region, .. }| {
            match Trimmed::new(Box::new(Arc::clone(&shape)), vec![region.outer().to_vec()]) {
                Ok(cut) if cut.area() > LEFT_BESIDE_FOOTPRINTS * region.area() => Arc::new(cut),
                _ => shape,
            }
        })
    }

    proptest! {
        /// Squares anywhere, some of which overlap or leave the floor, with tiles of it; or tiles that leave
        /// less than counts.
        #[test]
        fn footprints_that_do_not_fit_stay_and_no_others(
            places in prop::collection::vec((prop::array::uniform2(-0.2..3.8), 0.1..0.6), 0..24), tiles in 0..5usize,
        ) {
            let square = |x: f64, y: f64, side: f64| {
                let at = |a: f64, b: f64| DVec3::new(x + side * a, y + side * b, 0.0);
                let outer = vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
                let region = PlanarRegion::new(outer, Vec::new()).expect("a square");
                Footprint { surface: 0, region, standing: Vec::new() }
            };
            let scattered = places.into_iter().map(|([x, y], side)| square(x, y, side));
            let side = 2.0 - 1e-7;
            let quarters = (0..tiles).map(|k| square(2.0 * (k % 2) as f64, 2.0 * (k / 2) as f64, side));
            let mut footprints: Vec<Footprint> =
                if tiles < 4 { scattered.chain(quarters).collect() } else { quarters.collect() };
            let first = tiles.min(footprints.len());
            footprints.rotate_left(first);
            let floor: Arc<dyn Surface> =
                Arc::new(Parallelogram::new(DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y).expect("a square"));
            let mut cut = Arc::clone(&floor);
            cut_out(&mut cut, &footprints);
            let expected = one_by_one(&floor, &footprints);
            prop_assert_eq!(cut.region(), expected.region());
        }
    }
}
