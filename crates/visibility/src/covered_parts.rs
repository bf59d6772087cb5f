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
//! unseen; of two in one plane the smaller lies on the larger.

mod sequence;

use std::cmp::Ordering;
use std::collections::HashMap;

use radiosity_fit::gap::closed;
use radiosity_fit::tolerances::SHARED_AREA;
use radiosity_geom::{
    Aabb, Bvh, DVec3, PARALLEL_PLANES, PlanarRegion, ROUNDING, difference, layer_order, polygon_area,
    polygon_width, touching,
};
use radiosity_scene::Scene;
use radiosity_work::interruption::check_interrupt;

use crate::tolerances::NARROW_PIECE;
use sequence::Sequence;

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

/// The covered parts of a scene.
#[derive(Clone, Debug)]
pub struct CoveredParts {
    list: Vec<CoveredPart>,
    /// Places in the list of those of each surface, ascending.
    of_surface: Vec<Vec<usize>>,
}

impl CoveredParts {
    /// The covered parts of `scene`, in the order of their contacts.
    pub fn new(scene: &Scene) -> Self {
        let sheets = Sheets::of(scene);
        let mut found = Finder { sheets: &sheets, list: Vec::new(), between: HashMap::new() };
        for (number, contact) in sheets.contacts().iter().enumerate() {
            check_interrupt();
            found.add(number, contact);
        }
        let mut of_surface = vec![Vec::new(); scene.surfaces.len()];
        found.list.iter().enumerate().for_each(|(place, part)| of_surface[part.surface].push(place));
        Self { list: found.list, of_surface }
    }

    /// All of them.
    pub fn list(&self) -> &[CoveredPart] {
        &self.list
    }

    /// The parts of one surface.
    pub fn of_surface(&self, surface: usize) -> impl ExactSizeIterator<Item = &CoveredPart> {
        self.of_surface[surface].iter().map(|place| &self.list[*place])
    }
}

/// The parts of the convex `pieces` of a surface outside of convex `holes`; `normal` is the unit normal of its front.
pub fn without<'a>(
    pieces: Vec<Vec<DVec3>>,
    holes: impl IntoIterator<Item = &'a Vec<DVec3>>,
    normal: DVec3,
) -> Vec<Vec<DVec3>> {
    let holes: Vec<&[DVec3]> = holes.into_iter().map(Vec::as_slice).collect();
    if holes.is_empty() {
        return pieces;
    }
    // Seen along the normal, so that a gap counts for nothing.
    let outline = |polygon: &[DVec3]| Aabb::around(polygon.iter().map(|x| *x - x.dot(normal) * normal));
    let places = Sequence::new(holes.iter().map(|hole| {
        let bounds = outline(hole);
        let far = bounds.min.abs().max(bounds.max.abs()).max_element();
        bounds.inflate(ROUNDING * (bounds.diagonal() + far))
    }));
    let mut open = Vec::new();
    // Pieces with the number of holes that are cut out of them already, the next to come last.
    let mut stack: Vec<(Vec<DVec3>, usize)> = pieces.into_iter().rev().map(|piece| (piece, 0)).collect();
    while let Some((piece, done)) = stack.pop() {
        match places.first_overlapping(done, &outline(&piece)) {
            Some(next) => {
                let parts = difference(&piece, holes[next], normal).into_iter().rev();
                stack.extend(parts.map(|part| (part, next + 1)));
            }
            None => open.push(piece),
        }
    }
    open
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

/// The flat surfaces of a scene.
struct Sheets<'a> {
    scene: &'a Scene,
    /// Index of each surface.
    list: Vec<usize>,
    /// The boxes around them, so large that those of sheets on each other overlap.
    boxes: Vec<Aabb>,
    tree: Bvh,
}

impl<'a> Sheets<'a> {
    fn of(scene: &'a Scene) -> Self {
        let region = |index: &usize| scene.surfaces[*index].shape.region();
        let list: Vec<usize> = (0..scene.surfaces.len()).filter(|index| region(index).is_some()).collect();
        let bounds = |region: &PlanarRegion| {
            Aabb::around(region.outer().iter().copied()).inflate(closed(region.extent(), region.extent()))
        };
        let boxes: Vec<Aabb> = list.iter().filter_map(region).map(bounds).collect();
        let tree = Bvh::build(&boxes);
        Self { scene, list, boxes, tree }
    }

    fn region(&self, surface: usize) -> &'a PlanarRegion {
        self.scene.surfaces[surface].shape.region().expect("sheets are flat")
    }

    /// All contacts: first those whose fronts face each other, the closest first, then the others. If
    /// something between two sheets faces one of them, it is closer to that one than a sheet that covers
    /// without seeing.
    fn contacts(&self) -> Vec<SheetContact> {
        let mut found = Vec::new();
        for (under, bounds) in self.list.iter().zip(&self.boxes) {
            self.tree.overlapping(bounds, |place| found.extend(self.contact(*under, self.list[place])));
        }
        found.sort_by(|a, b| {
            b.mutual
                .cmp(&a.mutual)
                .then(a.gap.total_cmp(&b.gap))
                .then((a.under, a.over).cmp(&(b.under, b.over)))
        });
        found
    }

    /// The contact of a sheet with another that may lie on it.
    fn contact(&self, under: usize, over: usize) -> Option<SheetContact> {
        let [region, other] = [under, over].map(|surface| self.region(surface));
        let is_parallel = region.normal().cross(other.normal()).length() < PARALLEL_PLANES;
        let mutual = region.normal().dot(other.normal()) < 0.0;
        // A contact of two fronts is found once, from the larger surface.
        let is_turned = || {
            let order = layer_order(other.area(), region.area());
            let places = || (middle(region), under).partial_cmp(&(middle(other), over));
            order.then_with(|| places().unwrap_or(Ordering::Equal)).is_lt()
        };
        if under == over || !is_parallel || mutual && is_turned() {
            return None;
        }
        // Of two fronts in one plane the smaller was laid on the larger.
        let is_laid_under = || !mutual && is_turned() && height_over(other, region).is_some();
        let most = closed(region.extent(), other.extent());
        let gap = height_over(region, other).filter(|gap| *gap <= most && !is_laid_under())?;
        Some(SheetContact { under, over, mutual, gap })
    }

    /// The surfaces that may lie on `pieces` of sheets that lie on each other, the larger of this extent.
    fn near(&self, pieces: &[Vec<DVec3>], extent: f64) -> impl Iterator<Item = usize> {
        // From one sheet to the other, and from there to a third.
        let bounds = Aabb::around(pieces.iter().flatten().copied()).inflate(2.0 * closed(extent, extent));
        self.tree.near(&bounds).into_iter().map(|place| self.list[place])
    }
}

/// Covered parts while they are found.
struct Finder<'a> {
    sheets: &'a Sheets<'a>,
    list: Vec<CoveredPart>,
    /// Places in the list of the parts of a surface that another covers.
    between: HashMap<[usize; 2], Vec<usize>>,
}

impl Finder<'_> {
    /// Adds the parts that a contact covers and no contact before it.
    fn add(&mut self, number: usize, contact: &SheetContact) {
        let SheetContact { under, over, mutual, .. } = *contact;
        let [lower, upper] = [under, over].map(|surface| self.sheets.region(surface));
        let pieces = lower.common_parts(upper).collect();
        let larger = lower.extent().max(upper.extent());
        let pieces = self.open(pieces, under, larger);
        let pieces = if mutual { self.open(pieces, over, larger) } else { pieces };
        let extent = lower.extent().min(upper.extent());
        let is_broad = |piece: &Vec<DVec3>| polygon_width(piece) > NARROW_PIECE * extent;
        let pieces: Vec<Vec<DVec3>> = pieces.into_iter().filter(is_broad).collect();
        if area(&pieces) <= SHARED_AREA * lower.area().min(upper.area()) {
            return;
        }
        if mutual {
            let onto = |x: &DVec3| x - upper.height(*x) * upper.normal();
            let turned = |piece: &Vec<DVec3>| piece.iter().rev().map(onto).collect();
            self.push([over, under], pieces.iter().map(turned).collect(), number);
        }
        self.push([under, over], pieces, number);
    }

    /// The parts of `pieces` outside what is covered of a surface already; the larger of the sheets of a
    /// contact is of this extent.
    fn open(&self, pieces: Vec<Vec<DVec3>>, surface: usize, extent: f64) -> Vec<Vec<DVec3>> {
        let near = self.sheets.near(&pieces, extent);
        let mut places: Vec<usize> =
            near.filter_map(|other| self.between.get(&[surface, other])).flatten().copied().collect();
        places.sort_unstable();
        let holes = places.into_iter().flat_map(|place| &self.list[place].pieces);
        without(pieces, holes, self.sheets.region(surface).normal())
    }

    /// Appends what the second surface covers of the first.
    fn push(&mut self, [surface, other]: [usize; 2], pieces: Vec<Vec<DVec3>>, contact: usize) {
        self.between.entry([surface, other]).or_default().push(self.list.len());
        self.list.push(CoveredPart { surface, pieces, contact });
    }
}

/// Mean corner, which orders two sheets of one area independently of their places in the list.
fn middle(region: &PlanarRegion) -> [f64; 3] {
    (region.outer().iter().sum::<DVec3>() / region.outer().len() as f64).to_array()
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// The rest is what one hole after the other leaves of all pieces, to the last bit.
        #[test]
        fn holes_are_cut_out_of_the_pieces_that_they_reach(
            places in prop::collection::vec(prop::array::uniform5(0.0..1.0f64), 0..40), far in -1e7..1e7f64,
        ) {
            let triangle = |[x, y, size, turn, height]: [f64; 5]| {
                let corner = |k: usize| {
                    let (sin, cos) = (6.3 * turn + 2.0943951 * k as f64).sin_cos();
                    let size = 0.3 * (0.1 + size);
                    DVec3::new(far + x + size * cos, y + size * sin, far + 1e-6 * height)
                };
                (0..3).map(corner).collect::<Vec<DVec3>>()
            };
            let at = |x: f64, y: f64| DVec3::new(far + x, y, far);
            let square = |x: f64| vec![at(x, 0.0), at(x + 0.5, 0.0), at(x + 0.5, 1.0), at(x, 1.0)];
            let pieces = vec![square(0.0), square(0.5)];
            let holes: Vec<Vec<DVec3>> = places.into_iter().map(triangle).collect();
            let cut = |rest: Vec<Vec<DVec3>>, hole: &Vec<DVec3>| {
                rest.iter().flat_map(|piece| difference(piece, hole, DVec3::Z)).collect()
            };
            let expected = holes.iter().fold(pieces.clone(), cut);
            prop_assert_eq!(without(pieces, &holes, DVec3::Z), expected);
        }
    }
}
