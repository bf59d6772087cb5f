//! Groups of planar elements, of which a row is told at once that none exchanges light with it.
//!
//! A tree halves the elements, first by their normals, then parallel ones by their planes and others by their
//! places. With the box B around a group,
//! the box N around its normals and the least offset d = min n·p of its planes, a row with the normal m and
//! the corners x lies apart from all of the group where
//!
//! ```text
//! max over B of m·(y − x) < 0                 the group lies behind the row,
//! max over N of n·x − d   ≤ 0  for each x     the row lies behind all planes of the group,
//! ```
//!
//! or where joined surfaces hide B from the row ([`radiosity_visibility::End`]). Everything is compared by
//! more than the tolerance of single pairs, so that a group is told nothing that its pairs are not.

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_geom::{Aabb, COINCIDENT, DVec3, PARALLEL_PLANES, Plane, touching};

/// Extent of the normals of a group above which it is halved by these: 0.5 is half a right angle, about.
/// Chosen: with a smaller value groups of bent surfaces fall apart; with a larger one few lie behind a row.
const TURN: f64 = 0.5;

/// Height, over the extent of the narrowest element, up to which all touch in their pairs: half of that of
/// pairs.
const TOUCHING: f64 = 0.5 * COINCIDENT;

/// The tree of groups.
pub(super) struct Groups {
    list: Vec<Group>,
    /// The elements in the order of the groups.
    order: Vec<usize>,
    /// Diagonal of the box around all.
    diagonal: f64,
}

/// Elements that lie together.
pub(super) struct Group {
    pub(super) bounds: Aabb,
    /// The box around the normals.
    normals: Aabb,
    /// Least and largest offset of the planes from the middle of `bounds`, along their normals.
    offsets: [f64; 2],
    /// The least extent of an element.
    narrowest: f64,
    /// Places in the order.
    members: Range<usize>,
    /// The largest index of its elements.
    pub(super) last: usize,
    /// The groups that it is halved into; None for a single element.
    pub(super) halves: Option<[usize; 2]>,
}

impl Groups {
    /// The groups of the planar elements of a list.
    pub(super) fn new(elements: &[Element]) -> Self {
        let order: Vec<usize> =
            (0..elements.len()).filter(|element| elements[*element].plane.is_some()).collect();
        let bounds = Aabb::around(order.iter().flat_map(|element| elements[*element].hull.iter().copied()));
        let mut groups = Self { list: Vec::new(), order, diagonal: bounds.diagonal() };
        if !groups.order.is_empty() {
            groups.add(elements, 0..groups.order.len());
        }
        groups
    }

    /// Adds the group of these places and its halves; returns its index.
    fn add(&mut self, elements: &[Element], members: Range<usize>) -> usize {
        let own = self.list.len();
        let group = Group::of(&self.order[members.clone()], elements, members.clone());
        let middle = members.start + group.halve(&mut self.order[members.clone()], elements);
        self.list.push(group);
        if members.len() > 1 {
            let first = self.add(elements, members.start..middle);
            let second = self.add(elements, middle..members.end);
            self.list[own].halves = Some([first, second]);
        }
        own
    }

    /// The group of all, if there are any.
    pub(super) fn root(&self) -> Option<&Group> {
        self.list.first()
    }

    pub(super) fn group(&self, index: usize) -> &Group {
        &self.list[index]
    }

    /// The elements of a group.
    pub(super) fn members(&self, group: &Group) -> &[usize] {
        &self.order[group.members.clone()]
    }

    /// Whether no member of a group exchanges light with an element in this `plane`, as either lies behind
    /// the other, and not in its plane.
    pub(super) fn are_behind(&self, group: &Group, element: &Element, plane: &Plane) -> bool {
        let margin = self.margin(element);
        if group.heights_over(plane)[1] < -margin {
            return true;
        }
        let (heights, least) =
            (|| element.hull.iter().map(|x| group.heights_of(*x)[1]), group.touching(element));
        heights().all(|height| height <= least) && heights().any(|height| height < -margin)
    }

    /// Whether all members of a group lie in the `plane` of an element.
    pub(super) fn are_coplanar(&self, group: &Group, element: &Element, plane: &Plane) -> bool {
        let least = group.touching(element);
        group.heights_over(plane).iter().all(|height| height.abs() <= least)
    }

    /// Whether all members of a group certainly lie in front of an element in this `plane`, and it in front
    /// of them.
    pub(super) fn are_faced(&self, group: &Group, element: &Element, plane: &Plane) -> bool {
        let margin = self.margin(element);
        let lies_before = |x: &DVec3| group.heights_of(*x)[0] > margin;
        group.heights_over(plane)[0] > margin && element.hull.iter().any(lies_before)
    }

    /// Heights below this may count as none in a pair with an element.
    fn margin(&self, element: &Element) -> f64 {
        2.0 * touching(element.extent, self.diagonal)
    }
}

impl Group {
    fn of(order: &[usize], elements: &[Element], members: Range<usize>) -> Self {
        let own = || order.iter().map(|element| &elements[*element]);
        let bounds = Aabb::around(own().flat_map(|element| element.hull.iter().copied()));
        let planes = || own().filter_map(|element| element.plane);
        let normals = Aabb::around(planes().map(|plane| plane.normal));
        let narrowest = own().map(|element| element.extent).fold(f64::INFINITY, f64::min);
        let last = order.iter().copied().max().unwrap_or(0);
        let mut group = Self { bounds, normals, offsets: [0.0; 2], narrowest, members, last, halves: None };
        let range = |[low, high]: [f64; 2], offset: f64| [low.min(offset), high.max(offset)];
        let offsets = planes().map(|plane| group.offset(plane));
        group.offsets = offsets.fold([f64::INFINITY, f64::NEG_INFINITY], range);
        group
    }

    /// Sorts the elements of a group into halves; returns the number of the first.
    fn halve(&self, order: &mut [usize], elements: &[Element]) -> usize {
        let turn = self.normals.max - self.normals.min;
        let [nearest, farthest] = self.offsets;
        if turn.max_element() > TURN {
            let (axis, middle) = (turn.max_position(), self.normals.center());
            return part(order, |element| {
                elements[element].plane.is_some_and(|plane| plane.normal[axis] < middle[axis])
            });
        }
        if turn.max_element() < PARALLEL_PLANES && farthest - nearest > COINCIDENT * self.bounds.diagonal() {
            let middle = 0.5 * (nearest + farthest);
            return part(order, |element| {
                elements[element].plane.is_some_and(|plane| self.offset(plane) < middle)
            });
        }
        let axis = (self.bounds.max - self.bounds.min).max_position();
        let place = |element: &usize| Aabb::around(elements[*element].hull.iter().copied()).center()[axis];
        order.sort_by(|a, b| place(a).total_cmp(&place(b)));
        order.len() / 2
    }

    /// Offset of a plane from the middle of the box, along its normal.
    fn offset(&self, plane: Plane) -> f64 {
        plane.normal.dot(plane.point - self.bounds.center())
    }

    /// Height up to which its members certainly touch an element, or its plane.
    fn touching(&self, element: &Element) -> f64 {
        TOUCHING * self.narrowest.min(element.extent)
    }

    /// Least and largest height of its box over a plane.
    fn heights_over(&self, plane: &Plane) -> [f64; 2] {
        let middle = plane.height(self.bounds.center());
        let half = (0.5 * (self.bounds.max - self.bounds.min)).dot(plane.normal.abs());
        [middle - half, middle + half]
    }

    /// Bounds of the heights of a point over its planes.
    fn heights_of(&self, x: DVec3) -> [f64; 2] {
        let x = x - self.bounds.center();
        let middle = self.normals.center().dot(x);
        let half = (0.5 * (self.normals.max - self.normals.min)).dot(x.abs());
        let [low, high] = self.offsets;
        [middle - half - high, middle + half - low]
    }
}

/// Puts the elements that are `low` first; returns their number.
fn part(order: &mut [usize], low: impl Fn(usize) -> bool) -> usize {
    order.sort_by_key(|element| !low(*element));
    order.iter().filter(|element| low(**element)).count()
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use proptest::prelude::*;
    use radiosity_elements::cells::Layers;
    use radiosity_elements::space::Space;
    use radiosity_elements::{Discretization, Elements, Subdivide};
    use radiosity_kernel::contact::planes::{self, Planes};

    use super::*;

    /// Elements of triangles and boxes.
    fn elements(triangles: &[[[f64; 3]; 3]], boxes: &[[f64; 3]]) -> Elements {
        let mut text = String::new();
        for corners in triangles {
            writeln!(text, "[[surfaces]]\ntriangle = {{ vertices = {corners:?} }}").unwrap();
        }
        for origin in boxes {
            writeln!(text, "[[surfaces]]\nbox = {{ origin = {origin:?}, size = [1, 1, 1] }}").unwrap();
        }
        let scene = radiosity_language::read(&radiosity_scene::Source::new("scene", &text)).expect("a scene");
        let (subdivide, layers) = (Subdivide::Uniform(1), Layers::NONE);
        Elements::new(&scene, &Discretization { order: 0, space: Space::Total, subdivide, layers })
            .expect("all have area")
    }

    fn triangle() -> impl Strategy<Value = [[f64; 3]; 3]> {
        let point = || prop::array::uniform3(-1.0..1.0f64);
        (point(), 0.05..0.5f64, prop::array::uniform3(point())).prop_filter_map(
            "has area",
            |(at, size, corners)| {
                let corner = |c: [f64; 3]| DVec3::from_array(at) * 3.0 + size * DVec3::from_array(c);
                let [a, b, c] = corners.map(corner);
                ((b - a).cross(c - a).length() > 0.1 * size * size).then_some([a, b, c].map(|x| x.to_array()))
            },
        )
    }

    proptest! {
        /// Each pair of a group is told the same alone; boxes on a grid touch each other's planes.
        #[test]
        fn what_is_told_of_groups_is_told_of_their_pairs(
            triangles in prop::collection::vec(triangle(), 1..12),
            boxes in prop::collection::btree_set(prop::array::uniform3(-3..3i32), 1..5),
        ) {
            let boxes: Vec<[f64; 3]> = boxes.into_iter().map(|place| place.map(|x| 2.0 * f64::from(x))).collect();
            let elements = elements(&triangles, &boxes);
            let list = elements.list();
            let groups = Groups::new(list);
            let mut told = 0;
            for element in list {
                let plane = element.plane.expect("all are planar");
                for group in &groups.list {
                    let pairs = || groups.members(group).iter().map(|other| planes::of(element, &list[*other]));
                    if groups.are_behind(group, element, &plane) {
                        told += 1;
                        prop_assert!(pairs().all(|pair| pair == Planes::Behind));
                    }
                    if groups.are_coplanar(group, element, &plane) {
                        told += 1;
                        prop_assert!(pairs().all(|pair| pair == Planes::Coplanar));
                    }
                    if groups.are_faced(group, element, &plane) {
                        told += 1;
                        prop_assert!(pairs().all(|pair| pair == Planes::Exchanging));
                    }
                }
            }
            prop_assert!(told > list.len(), "single elements are told, most of them");
        }
    }
}
