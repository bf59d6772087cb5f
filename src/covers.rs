//! Covers: the parts of flat surfaces on which others lie.
//!
//! What stands on a floor with a face of its own, hangs on a wall or lies on a table leaves no gap that light passes. In that limit
//! the part of the floor under it and the part of the face over it exchange light with each other alone, and κ dA becomes the
//! identity: a point sees the point that it touches. No polynomial follows the edge of that darkness, and rules of a gap of 1e-8
//! are slow. So both parts become elements of their own. Sheets count as closed up to a
//! few times the least gap that the rules tell from none (`scene::gap`).
//!
//! Of several sheets over a place the nearest covers it. A sheet whose back lies on another covers it without seeing it.

use std::cmp::Ordering;

use radiosity_geom::{Aabb, Bvh, DVec3, PlanarRegion, difference, polygon_area, polygon_width, touching};

use crate::scene::{Scene, gap::closed};

/// Sine of the angle of two planes below which they count as parallel.
const PARALLEL: f64 = 1e-6;

/// Share of the smaller of two sheets that they have to share to cover each other.
const SHARED: f64 = 1e-6;

/// Width of a piece below which it is rounding, as a part of the smaller sheet's extent.
const NARROW: f64 = 1e-6;

/// A part of a flat surface on which another lies.
#[derive(Clone, Debug)]
pub struct Cover {
    /// Index of the surface.
    pub surface: usize,
    /// The part, as convex pieces that do not overlap, counter-clockwise seen from its front.
    pub pieces: Vec<Vec<DVec3>>,
    /// The contact: what it exchanges light with has the same number.
    pub contact: usize,
}

/// All covers of a scene, by their contacts.
pub fn covers(scene: &Scene) -> Vec<Cover> {
    let mut found: Vec<Cover> = Vec::new();
    for (contact, Contact { under, over, mutual, .. }) in contacts(scene).into_iter().enumerate() {
        let region = |surface: usize| scene.surfaces[surface].shape.region().expect("sheets are flat");
        let pieces = region(under).common_parts(region(over)).collect();
        let pieces = without(pieces, of_surface(&found, under), region(under).normal());
        let pieces =
            if mutual { without(pieces, of_surface(&found, over), region(over).normal()) } else { pieces };
        let extent = region(under).extent().min(region(over).extent());
        let pieces: Vec<Vec<DVec3>> =
            pieces.into_iter().filter(|piece| polygon_width(piece) > NARROW * extent).collect();
        if area(&pieces) <= SHARED * region(under).area().min(region(over).area()) {
            continue;
        }
        if mutual {
            let onto = |x: &DVec3| x - region(over).height(*x) * region(over).normal();
            let turned = |piece: &Vec<DVec3>| piece.iter().rev().map(onto).collect();
            found.push(Cover { surface: over, pieces: pieces.iter().map(turned).collect(), contact });
        }
        found.push(Cover { surface: under, pieces, contact });
    }
    found
}

/// What of convex `pieces` the `covers` of their surface leave, where its front has the unit normal `normal`.
pub fn without<'a>(
    pieces: Vec<Vec<DVec3>>,
    covers: impl Iterator<Item = &'a Cover>,
    normal: DVec3,
) -> Vec<Vec<DVec3>> {
    let holes = covers.flat_map(|cover| &cover.pieces);
    holes.fold(pieces, |rest, hole| rest.iter().flat_map(|piece| difference(piece, hole, normal)).collect())
}

/// Those of `covers` that belong to `surface`.
pub fn of_surface(covers: &[Cover], surface: usize) -> impl Iterator<Item = &Cover> {
    covers.iter().filter(move |cover| cover.surface == surface)
}

/// Area of pieces that do not overlap (scene length²).
fn area(pieces: &[Vec<DVec3>]) -> f64 {
    pieces.iter().map(|piece| polygon_area(piece)).sum()
}

/// A sheet that lies on the front of another.
struct Contact {
    /// The surface whose front is covered.
    under: usize,
    /// What lies on it.
    over: usize,
    /// Whether the front of that lies on it, and is covered in turn.
    mutual: bool,
    /// Their distance (scene length).
    gap: f64,
}

/// All contacts, those that see each other first, and of those the closest. What covers without seeing comes last: where something
/// lies between the two that sees one of them, that is closer to it.
fn contacts(scene: &Scene) -> Vec<Contact> {
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
            let is_parallel = region.normal().cross(other.normal()).length() < PARALLEL;
            let mutual = region.normal().dot(other.normal()) < 0.0;
            // What sees each other is found once, from the larger.
            let is_turned =
                || (size(region), *under).partial_cmp(&(size(other), over)) == Some(Ordering::Less);
            if *under == over || !is_parallel || mutual && is_turned() {
                return;
            }
            let most = closed(region.extent(), other.extent());
            if let Some(gap) = height_over(region, other).filter(|gap| *gap <= most) {
                found.push(Contact { under: *under, over, mutual, gap });
            }
        });
    }
    found.sort_by(|a, b| {
        b.mutual.cmp(&a.mutual).then(a.gap.total_cmp(&b.gap)).then((a.under, a.over).cmp(&(b.under, b.over)))
    });
    found
}

/// Its area and the middle of its corners: tell two sheets apart, whatever their places in the list.
fn size(region: &PlanarRegion) -> [f64; 4] {
    let [x, y, z] = (region.outer().iter().sum::<DVec3>() / region.outer().len() as f64).to_array();
    [region.area(), x, y, z]
}

/// The largest height of a sheet, `over`, over the front of another; None where a corner does not lie before it. Heights go by the
/// plane of the larger one: that of a small one is uncertain far away.
fn height_over(under: &PlanarRegion, over: &PlanarRegion) -> Option<f64> {
    let [small, large] = if under.extent() < over.extent() { [under, over] } else { [over, under] };
    let up = if std::ptr::eq(large, under) { 1.0 } else { -under.normal().dot(over.normal()).signum() };
    let tolerance = touching(small.extent(), large.extent());
    let heights = || small.outer().iter().map(|x| up * large.height(*x));
    heights().all(|height| height > tolerance).then(|| heights().fold(0.0, f64::max))
}
