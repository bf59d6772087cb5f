//! Covered parts: the parts of flat surfaces on which other flat surfaces lie.
//!
//! A body that stands on a floor, a picture on a wall or a sheet on a table leaves no gap through which light
//! passes. In that limit the part of the floor under the sheet and the part of the sheet over the floor
//! exchange light with each other only, and κ dA becomes the identity: a point sees the point that it
//! touches. No polynomial follows the edge of that darkness, and rules for a gap of 1e-8 are slow, so both
//! parts become elements of their own. A gap counts as closed up to four times the least gap that the rules
//! resolve (`fit::gap`).
//!
//! Of several sheets over a place the nearest covers it. A sheet that lies on another with its back covers it
//! unseen.

use std::cmp::Ordering;

use radiosity_fit::gap::closed;
use radiosity_fit::tolerances::SHARED_AREA;
use radiosity_geom::{
    Aabb, Bvh, DVec3, PARALLEL_PLANES, PlanarRegion, difference, polygon_area, polygon_width, touching,
};
use radiosity_scene::Scene;

use crate::tolerances::NARROW_PIECE;

/// A part of a flat surface on which another surface lies.
#[derive(Clone, Debug)]
pub struct CoveredPart {
    /// Index of the surface.
    pub surface: usize,
    /// The part, as disjoint convex pieces, counter-clockwise seen from the surface's front.
    pub pieces: Vec<Vec<DVec3>>,
    /// Number of the contact; the two parts of a contact exchange light.
    pub contact: usize,
}

/// All covered parts of a scene, in the order of their contacts.
pub fn covered_parts(scene: &Scene) -> Vec<CoveredPart> {
    let mut found: Vec<CoveredPart> = Vec::new();
    for (contact, SheetContact { under, over, mutual, .. }) in contacts(scene).into_iter().enumerate() {
        let region = |surface: usize| scene.surfaces[surface].shape.region().expect("sheets are flat");
        let pieces = region(under).common_parts(region(over)).collect();
        let pieces = without(pieces, of_surface(&found, under), region(under).normal());
        let pieces =
            if mutual { without(pieces, of_surface(&found, over), region(over).normal()) } else { pieces };
        let extent = region(under).extent().min(region(over).extent());
        let pieces: Vec<Vec<DVec3>> =
            pieces.into_iter().filter(|piece| polygon_width(piece) > NARROW_PIECE * extent).collect();
        if area(&pieces) <= SHARED_AREA * region(under).area().min(region(over).area()) {
            continue;
        }
        if mutual {
            let onto = |x: &DVec3| x - region(over).height(*x) * region(over).normal();
            let turned = |piece: &Vec<DVec3>| piece.iter().rev().map(onto).collect();
            found.push(CoveredPart { surface: over, pieces: pieces.iter().map(turned).collect(), contact });
        }
        found.push(CoveredPart { surface: under, pieces, contact });
    }
    found
}

/// The parts of the convex `pieces` outside the `covered_parts` of their surface; `normal` is the unit normal
/// of its front.
pub fn without<'a>(
    pieces: Vec<Vec<DVec3>>,
    covered_parts: impl Iterator<Item = &'a CoveredPart>,
    normal: DVec3,
) -> Vec<Vec<DVec3>> {
    let holes = covered_parts.flat_map(|cover| &cover.pieces);
    holes.fold(pieces, |rest, hole| rest.iter().flat_map(|piece| difference(piece, hole, normal)).collect())
}

/// The `covered_parts` of one surface.
pub fn of_surface(covered_parts: &[CoveredPart], surface: usize) -> impl Iterator<Item = &CoveredPart> {
    covered_parts.iter().filter(move |cover| cover.surface == surface)
}

/// Total area of disjoint pieces (scene length²).
fn area(pieces: &[Vec<DVec3>]) -> f64 {
    pieces.iter().map(|piece| polygon_area(piece)).sum()
}

/// A sheet that lies on the front of another.
struct SheetContact {
    /// The surface whose front is covered.
    under: usize,
    /// The surface that lies on it.
    over: usize,
    /// Whether the two fronts face each other, so that both are covered.
    mutual: bool,
    /// Largest distance between the two (scene length).
    gap: f64,
}

/// All contacts: first those whose fronts face each other, the closest first, then the others. If something
/// between two sheets faces one of them, it is closer to that one than a sheet that covers without seeing.
fn contacts(scene: &Scene) -> Vec<SheetContact> {
    let sheets: Vec<(usize, &PlanarRegion)> = (scene.surfaces.iter().enumerate())
        .filter_map(|(index, surface)| Some((index, surface.shape.region()?)))
        .collect();
    let bounds = |region: &PlanarRegion| Aabb::around(region.outer().iter().copied());
    let boxes: Vec<Aabb> = sheets
        .iter()
        .map(|(_, region)| bounds(region).inflate(closed(region.extent(), region.extent())))
        .collect();
    let tree = Bvh::build(&boxes);
    let mut found = Vec::new();
    for (own, (under, region)) in sheets.iter().enumerate() {
        tree.overlapping(&boxes[own], |place| {
            let (over, other) = sheets[place];
            let is_parallel = region.normal().cross(other.normal()).length() < PARALLEL_PLANES;
            let mutual = region.normal().dot(other.normal()) < 0.0;
            // A contact of two fronts is found once, from the larger surface.
            let is_turned =
                || (size(region), *under).partial_cmp(&(size(other), over)) == Some(Ordering::Less);
            if *under == over || !is_parallel || mutual && is_turned() {
                return;
            }
            let most = closed(region.extent(), other.extent());
            if let Some(gap) = height_over(region, other).filter(|gap| *gap <= most) {
                found.push(SheetContact { under: *under, over, mutual, gap });
            }
        });
    }
    found.sort_by(|a, b| {
        b.mutual.cmp(&a.mutual).then(a.gap.total_cmp(&b.gap)).then((a.under, a.over).cmp(&(b.under, b.over)))
    });
    found
}

/// Area and mean corner, which order two sheets independently of their places in the list.
fn size(region: &PlanarRegion) -> [f64; 4] {
    let [x, y, z] = (region.outer().iter().sum::<DVec3>() / region.outer().len() as f64).to_array();
    [region.area(), x, y, z]
}

/// The largest height of the sheet `over` above the front of `under`; None where a corner is not in front.
/// Heights refer to the plane of the larger sheet, since that of a small one is uncertain far away.
fn height_over(under: &PlanarRegion, over: &PlanarRegion) -> Option<f64> {
    let [small, large] = if under.extent() < over.extent() { [under, over] } else { [over, under] };
    let up = if std::ptr::eq(large, under) { 1.0 } else { -under.normal().dot(over.normal()).signum() };
    let tolerance = touching(small.extent(), large.extent());
    let heights = || small.outer().iter().map(|x| up * large.height(*x));
    heights().all(|height| height > tolerance).then(|| heights().fold(0.0, f64::max))
}
