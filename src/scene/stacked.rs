//! Flat sheets that lie in one plane and share some area of it: what stands on something, or hangs on it.
//!
//! The sign of the gap between two such sheets is lost, and with it what each of them sees. It follows from what they are:
//! one that lies on a one-sided sheet lies on its front, be it the bottom of a box on a floor or a picture on a wall. The
//! smaller one is moved off the larger by a trifle, for which the rules of transport hold: what stands on a floor then
//! exchanges with it alone, as it does in the limit of no gap. Copies and partial overlaps that nothing tells apart are
//! refused.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, PlanarRegion, Surface};

use crate::scene::{coincident::Occupied, gap};

/// Distance by which a sheet is moved off another, in multiples of the least gap.
const OFF: f64 = 1.5;

/// Part of an area that rounding may take for another.
const SAME_AREA: f64 = 1e-6;

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

    /// What decides which of two sheets that coincide lies on the other: the smaller, or of equal ones the one whose middle, or
    /// else whose normal, comes later.
    fn rank(&self) -> [f64; 7] {
        let corners = self.shape.corners();
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let steps = -(self.area().log2() / SAME_AREA).round();
        let [a, b] = [middle, self.normal()].map(|x| x.to_array());
        [steps, a[0], a[1], a[2], b[0], b[1], b[2]]
    }

    fn order(&self, other: &Sheet) -> Ordering {
        let pairs = self.rank().into_iter().zip(other.rank());
        pairs.fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
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
    let mut steps: HashMap<usize, Step> = HashMap::new();
    for (sheet, lower) in layers(sheets) {
        for (on, direction) in lower {
            // What lies on something that is moved itself goes along.
            let off = OFF * gap::least(sheets[sheet].extent(), sheets[on].extent());
            let step = off * direction + steps.get(&on).map_or(DVec3::ZERO, |step| step.by);
            let known = steps.entry(sheet).or_insert(Step { on, by: step });
            if step.length_squared() > known.by.length_squared() {
                *known = Step { on, by: step };
            }
        }
    }
    let mut lying: Vec<Lying> =
        steps.iter().map(|(sheet, step)| Lying { sheet: *sheet, on: step.on }).collect();
    lying.sort_unstable_by_key(|lying| lying.sheet);
    for (sheet, Step { by, .. }) in steps {
        if let Some(Ok(moved)) = sheets[sheet].shape.with_corners(&|x| x + by) {
            sheets[sheet].shape = Arc::from(moved);
        }
    }
    lying
}

/// By how much a sheet is moved, and off which.
struct Step {
    on: usize,
    by: DVec3,
}

/// A sheet with those that it lies on and the directions off them.
type Layer = (usize, Vec<(usize, DVec3)>);

/// The sheets that lie on others, lower ones first.
fn layers(sheets: &[Sheet]) -> Vec<Layer> {
    let occupied: Vec<Occupied> = sheets.iter().map(|sheet| Occupied::new(&sheet.shape)).collect();
    let boxes: Vec<Aabb> = occupied.iter().map(|occupied| *occupied.bounds()).collect();
    let tree = Bvh::build(&boxes);
    let solids = faces_of_solids(sheets);
    let mut lower: HashMap<usize, Vec<(usize, DVec3)>> = HashMap::new();
    for own in 0..sheets.len() {
        let mut near = Vec::new();
        tree.overlapping(&boxes[own], |other| near.push(other));
        for other in near.into_iter().filter(|other| *other < own) {
            let is_pair = sheets[own].is_back_of(&sheets[other]) || sheets[other].is_back_of(&sheets[own]);
            if is_pair || !occupied[own].coincides(&occupied[other]) {
                continue;
            }
            let (sheet, on) =
                if sheets[own].order(&sheets[other]).is_gt() { (own, other) } else { (other, own) };
            let solid = [solids.contains(&sheet), solids.contains(&on)];
            let pair = Pair { sheet: &sheets[sheet], on: &sheets[on], solid };
            if let Some(direction) = pair.direction(&occupied[sheet], &occupied[on]) {
                lower.entry(sheet).or_default().push((on, direction));
            }
        }
    }
    let mut layers: Vec<Layer> = lower.into_iter().collect();
    layers.sort_by(|a, b| sheets[a.0].order(&sheets[b.0]));
    layers
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
        let [is_face, both] = [self.solid[0], self.solid == [true; 2]];
        match self.on.two_sided {
            // The bottom of a box: it may cover the top of another of its size.
            false if faces_it && is_face && (both || !is_copy) => Some(up),
            false if !faces_it && is_within && !is_copy => Some(up),
            false => by_sign(),
            true if is_copy => by_sign(),
            true if self.sheet.two_sided => Some(by_sign().unwrap_or(up)),
            // A box stands on a board with its bottom; a picture shows its front.
            true => Some(by_sign().unwrap_or(if is_face { -normal } else { normal })),
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

#[cfg(test)]
mod tests {
    use radiosity_geom::shapes::Polygon;

    use super::*;

    fn sheet(name: &str, corners: &[[f64; 3]]) -> Sheet {
        let corners = corners.iter().map(|x| DVec3::from_array(*x)).collect();
        let shape: Arc<dyn Surface> = Arc::new(Polygon::new(corners, Vec::new()).expect("a polygon"));
        Sheet { typed: Arc::clone(&shape), shape, two_sided: false, flip: false, name: name.to_owned() }
    }

    /// A square from `low` to `high` at height z, front up.
    fn square(name: &str, low: f64, high: f64, z: f64) -> Sheet {
        sheet(name, &[[low, low, z], [high, low, z], [high, high, z], [low, high, z]])
    }

    fn down(sheet: Sheet) -> Sheet {
        Sheet { flip: true, ..sheet }
    }

    /// A wall over an edge of a square, so that the square is a face of a body.
    fn wall(low: f64, high: f64, z: f64) -> Sheet {
        sheet("wall", &[[low, low, z], [high, low, z], [high, low, z + 1.0], [low, low, z + 1.0]])
    }

    fn height(sheet: &Sheet) -> f64 {
        sheet.shape.corners()[0].z
    }

    /// The heights that the sheets get to.
    fn heights(mut sheets: Vec<Sheet>) -> Vec<f64> {
        set_apart(&mut sheets);
        sheets.iter().map(height).collect()
    }

    #[test]
    fn the_bottom_of_a_box_is_lifted_off_its_floor_into_the_box() {
        let mut sheets =
            vec![square("floor", 0.0, 4.0, 0.0), down(square("bottom", 1.0, 2.0, 0.0)), wall(1.0, 2.0, 0.0)];
        let lying = set_apart(&mut sheets);
        assert_eq!(lying, [Lying { sheet: 1, on: 0 }]);
        let gap = height(&sheets[1]);
        assert!(gap > 0.0 && gap < 1e-6 && height(&sheets[0]) == 0.0);
    }

    #[test]
    fn a_sheet_that_may_be_turned_over_by_mistake_stays() {
        assert_eq!(
            heights(vec![square("floor", 0.0, 4.0, 0.0), down(square("rug", 1.0, 2.0, 0.0))]),
            [0.0, 0.0]
        );
        assert_eq!(heights(vec![square("floor", 0.0, 4.0, 0.0), square("copy", 0.0, 4.0, 0.0)]), [0.0, 0.0]);
        assert_eq!(heights(vec![square("one", 0.0, 4.0, 0.0), square("other", 2.0, 6.0, 0.0)]), [0.0, 0.0]);
    }

    #[test]
    fn a_picture_hangs_before_its_wall() {
        let found = heights(vec![square("picture", 1.0, 2.0, 0.0), square("wall", 0.0, 4.0, 0.0)]);
        assert!(found[0] > 0.0 && found[1] == 0.0);
        let found = heights(vec![square("picture", 1.0, 2.0, 0.0), down(square("wall", 0.0, 4.0, 0.0))]);
        assert_eq!(found, [0.0, 0.0], "it shows the wall its face");
    }

    #[test]
    fn boxes_of_one_size_stand_on_each_other_in_either_order() {
        let faces = || {
            [
                square("top", 0.0, 1.0, 0.0),
                wall(0.0, 1.0, -1.0),
                down(square("bottom", 0.0, 1.0, 0.0)),
                wall(0.0, 1.0, 0.0),
            ]
        };
        let gap = |sheets: &[Sheet]| {
            let of =
                |name: &str| height(sheets.iter().find(|sheet| sheet.name == name).expect("it is there"));
            of("bottom") - of("top")
        };
        let (mut one, mut other) = (faces().to_vec(), faces().to_vec());
        other.reverse();
        set_apart(&mut one);
        set_apart(&mut other);
        assert!(gap(&one) > 0.0 && gap(&one) == gap(&other));
    }

    #[test]
    fn layers_lie_on_each_other() {
        let found = heights(vec![
            square("floor", 0.0, 4.0, 0.0),
            Sheet { two_sided: true, ..square("board", 0.5, 3.0, 0.0) },
            down(square("bottom", 1.0, 2.0, 0.0)),
            wall(1.0, 2.0, 0.0),
        ]);
        assert!(found[0] < found[1] && found[1] < found[2], "{found:?}");
    }

    #[test]
    fn two_sides_of_one_sheet_stay_together() {
        let sheets = vec![square("sheet", 0.0, 1.0, 0.0), down(square("sheet:back", 0.0, 1.0, 0.0))];
        assert_eq!(heights(sheets), [0.0, 0.0]);
    }
}
