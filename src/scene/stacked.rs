//! Flat sheets that lie in one plane and share some area of it: what stands on something, or hangs on it.
//!
//! The sign of the gap between two such sheets is lost, and with it what each of them sees. It follows from what they are:
//! one that lies on a one-sided sheet lies on its front, be it the bottom of a box on a floor or a picture on a wall. The
//! smaller one is moved off the larger by a trifle, for which the rules of transport hold: what stands on a floor then
//! exchanges with it alone, as it does in the limit of no gap. Copies and partial overlaps that nothing tells apart are
//! refused.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, PlanarRegion, Surface};

use crate::scene::{coincident::Occupied, gap};

/// Distance by which a sheet is moved off another, in multiples of the least gap.
const OFF: f64 = 1.5;

/// Part of an area that rounding may take for another.
const SAME_AREA: f64 = 1e-6;

/// Most sheets on top of each other, less one.
const MOST_LAYERS: usize = 4;

/// A flat sheet that may lie on others.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    /// The surface as it stands in the scene.
    pub(super) shape: Arc<dyn Surface>,
    /// As it was read.
    pub(super) typed: Arc<dyn Surface>,
    /// Whether its back emits and receives as well.
    pub(super) two_sided: bool,
    /// Whether its front is that of the shape turned over.
    pub(super) flip: bool,
    /// Its name: a sheet and the one called `name:back` are two sides of one.
    pub(super) name: String,
}

/// A sheet that was found to lie on another, both by their places in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lying {
    pub(super) sheet: usize,
    pub(super) on: usize,
}

impl Sheet {
    /// The normal of its front.
    fn normal(&self) -> DVec3 {
        let normal = self.region().map_or(DVec3::ZERO, PlanarRegion::normal);
        if self.flip { -normal } else { normal }
    }

    fn region(&self) -> Option<&PlanarRegion> {
        self.shape.region()
    }

    fn area(&self) -> f64 {
        self.region().map_or(0.0, PlanarRegion::area)
    }

    fn extent(&self) -> f64 {
        self.region().map_or(0.0, PlanarRegion::extent)
    }

    /// Mean height of its corners over another sheet, as they were typed.
    fn typed_height(&self, other: &Sheet) -> f64 {
        let corners = self.typed.corners();
        let Some(region) = other.typed.region() else { return 0.0 };
        let sign = if other.flip { -1.0 } else { 1.0 };
        sign * corners.iter().map(|x| region.height(*x)).sum::<f64>() / corners.len() as f64
    }

    fn is_back_of(&self, front: &Sheet) -> bool {
        self.name.strip_suffix(":back") == Some(front.name.as_str())
    }
}

/// Moves sheets that lie on others off them. Returns which do; those that nothing tells apart stay.
pub(super) fn set_apart(sheets: &mut [Sheet]) -> Vec<Lying> {
    let mut found: Vec<Lying> = Vec::new();
    for _ in 0..MOST_LAYERS {
        let steps = steps(sheets);
        if steps.is_empty() {
            break;
        }
        for (lying, step) in steps {
            let sheet = &mut sheets[lying.sheet];
            if let Some(Ok(moved)) = sheet.shape.with_corners(&|x| x + step) {
                sheet.shape = Arc::from(moved);
            }
            if !found.contains(&lying) {
                found.push(lying);
            }
        }
    }
    found
}

/// Which sheets lie on others, and by how much each is to be moved; each sheet once.
fn steps(sheets: &[Sheet]) -> Vec<(Lying, DVec3)> {
    let occupied: Vec<Occupied> = sheets.iter().map(|sheet| Occupied::new(&sheet.shape)).collect();
    let boxes: Vec<Aabb> = occupied.iter().map(|occupied| *occupied.bounds()).collect();
    let tree = Bvh::build(&boxes);
    let solids = faces_of_solids(sheets);
    let mut moved = HashSet::new();
    let mut steps = Vec::new();
    for own in 0..sheets.len() {
        let mut near = Vec::new();
        tree.overlapping(&boxes[own], |other| near.push(other));
        near.sort_unstable();
        for other in near.into_iter().filter(|other| *other < own) {
            let is_pair = sheets[own].is_back_of(&sheets[other]) || sheets[other].is_back_of(&sheets[own]);
            if is_pair || !occupied[own].coincides(&occupied[other]) {
                continue;
            }
            // Of equal ones the later lies on the earlier.
            let larger = (1.0 + SAME_AREA) * sheets[other].area() < sheets[own].area();
            let (sheet, on) = if larger { (other, own) } else { (own, other) };
            let pair = Pair {
                sheet: &sheets[sheet],
                on: &sheets[on],
                solid: [solids.contains(&sheet), solids.contains(&on)],
            };
            let Some(direction) = pair.direction(&occupied[sheet], &occupied[on]) else { continue };
            if moved.insert(sheet) {
                let off = OFF * gap::least(sheets[sheet].extent(), sheets[on].extent());
                steps.push((Lying { sheet, on }, off * direction));
            }
        }
    }
    steps
}

/// A sheet and the larger one that it lies on.
struct Pair<'a> {
    sheet: &'a Sheet,
    on: &'a Sheet,
    /// Whether either shares an edge with sheets of other planes.
    solid: [bool; 2],
}

impl Pair<'_> {
    /// The unit vector from the larger sheet towards the smaller one; None where nothing tells.
    fn direction(&self, own: &Occupied, other: &Occupied) -> Option<DVec3> {
        let (up, normal) = (self.on.normal(), self.sheet.normal());
        let common = own.common_area(other);
        let is_within = common > (1.0 - SAME_AREA) * self.sheet.area();
        let is_copy = is_within && common > (1.0 - SAME_AREA) * self.on.area();
        let faces_it = !self.sheet.two_sided && normal.dot(up) < 0.0;
        let by_sign = || {
            let height = self.sheet.typed_height(self.on);
            (height != 0.0).then(|| height.signum() * up)
        };
        match self.on.two_sided {
            // The bottom of a box on a box of its size.
            false if is_copy => {
                if faces_it && self.solid == [true; 2] {
                    Some(up)
                } else {
                    by_sign()
                }
            }
            false if faces_it || is_within => Some(up),
            false => by_sign(),
            true if self.sheet.two_sided && !is_copy => Some(by_sign().unwrap_or(up)),
            true if self.sheet.two_sided || is_copy => by_sign(),
            // A box stands on a board with its bottom; a picture shows its front.
            true => Some(by_sign().unwrap_or(if self.solid[0] { -normal } else { normal })),
        }
    }
}

/// The sheets that share an edge with one in another plane.
fn faces_of_solids(sheets: &[Sheet]) -> HashSet<usize> {
    let key = |x: DVec3| x.to_array().map(|x| (x + 0.0).to_bits());
    let mut at: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    let corners: Vec<Vec<DVec3>> = sheets.iter().map(|sheet| sheet.shape.corners()).collect();
    for (index, corners) in corners.iter().enumerate() {
        corners.iter().for_each(|corner| at.entry(key(*corner)).or_default().push(index));
    }
    let shares_edge = |own: usize| {
        let mut others: HashMap<usize, usize> = HashMap::new();
        for other in corners[own].iter().flat_map(|corner| &at[&key(*corner)]) {
            *others.entry(*other).or_default() += 1;
        }
        let across = |other: usize| sheets[own].normal().cross(sheets[other].normal()).length() > 1e-6;
        others.into_iter().any(|(other, count)| count > 1 && across(other))
    };
    (0..sheets.len()).filter(|own| shares_edge(*own)).collect()
}
