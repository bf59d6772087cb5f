//! A bounding-volume hierarchy over boxes, whatever is in them: which overlap a box, which a ray may meet.
//! What a ray meets first of surfaces is for [`RayTree`](crate::RayTree) to tell.
//!
//! Built top-down: each node is split between the two of 16 bins of box centres that minimise the expected
//! number of box tests, Σ area · count (the surface-area heuristic; Goldsmith and Salmon, 1987; binning after
//! Wald, 2007). Only the caller knows what a box contains, and tests it in full precision; the hierarchy
//! leaves out what a ray cannot reach. Boxes are inflated by 1e-8 of their size, more than the overhang 1e-9
//! at which a hit is still accepted.

use crate::slabs::Slabs;
use crate::tolerances::OVERHANG;
use crate::{Aabb, Ray};
use smallvec::SmallVec;

/// Bins of box centres between which a node may be split. An arbitrary choice: more find better splits of
/// unevenly spread boxes, and take longer to fill.
pub(crate) const BINS: usize = 16;
/// Below this depth splits halve the number of boxes instead, which bounds the depth.
const HEURISTIC_DEPTH: usize = 40;

/// A tree of boxes.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The caller's indices in the order of the leaves.
    order: Vec<u32>,
}

/// A leaf holds `order[first .. first + count]`; an inner node (`count` = 0) has its children at `first` and
/// `first + 1`.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    first: u32,
    count: u32,
}

impl Bvh {
    /// The hierarchy over `boxes`; it reports indices into them. At most 2³² − 1 boxes.
    pub fn build(boxes: &[Aabb]) -> Bvh {
        let inflated: Vec<Aabb> = boxes.iter().map(|b| b.inflate(margin(b))).collect();
        let mut order: Vec<u32> = (0..u32::try_from(boxes.len()).expect("fewer than 2³² boxes")).collect();
        let mut nodes = Vec::with_capacity(2 * boxes.len());
        if !boxes.is_empty() {
            nodes.push(leaf(&inflated, &order, 0, boxes.len()));
            divide(&inflated, &mut order, &mut nodes, 0, 0);
        }
        Bvh { nodes, order }
    }

    /// Whether `test` returns true for any box the ray may meet, in no particular order; stops at the first.
    pub fn any(&self, ray: &Ray, mut test: impl FnMut(usize) -> bool) -> bool {
        let slabs = Slabs::new(ray);
        self.search(|bounds| slabs.entry(bounds, ray.range[0], ray.range[1]).is_some()).any(&mut test)
    }

    /// Calls `visit` with the index of every box that overlaps `query`.
    pub fn overlapping(&self, query: &Aabb, mut visit: impl FnMut(usize)) {
        self.search(|bounds| bounds.overlaps(query)).for_each(&mut visit);
    }

    /// The indices of the boxes that overlap `query`, ascending.
    pub fn near(&self, query: &Aabb) -> Vec<usize> {
        let mut near: Vec<usize> = self.search(|bounds| bounds.overlaps(query)).collect();
        near.sort_unstable();
        near
    }

    /// The indices of all boxes that pass `may_hold`, and of some others, in no particular order. What a box
    /// fails has to be failed by every box inside it.
    pub fn search(&self, may_hold: impl Fn(&Aabb) -> bool) -> impl Iterator<Item = usize> {
        let mut stack: SmallVec<[usize; 32]> = SmallVec::new();
        stack.extend((!self.nodes.is_empty()).then_some(0));
        let leaves = std::iter::from_fn(move || {
            while let Some(index) = stack.pop() {
                let node = &self.nodes[index];
                if !may_hold(&node.bounds) {
                    continue;
                }
                if node.count > 0 {
                    return Some(node);
                }
                stack.extend([node.first as usize + 1, node.first as usize]);
            }
            None
        });
        leaves.flat_map(|leaf| self.content(leaf))
    }

    fn content(&self, leaf: &Node) -> impl Iterator<Item = usize> + '_ {
        self.order[leaf.first as usize..(leaf.first + leaf.count) as usize].iter().map(|k| *k as usize)
    }
}

/// Margin for rounding in the slab test and for hits accepted just outside the parameter domain.
fn margin(bounds: &Aabb) -> f64 {
    let far = bounds.min.abs().max(bounds.max.abs()).max_element();
    OVERHANG * bounds.diagonal() + 4e-15 * far
}

fn leaf(boxes: &[Aabb], order: &[u32], first: usize, count: usize) -> Node {
    let content = order[first..first + count].iter().map(|k| boxes[*k as usize]);
    Node { bounds: content.fold(Aabb::EMPTY, Aabb::union), first: first as u32, count: count as u32 }
}

/// Splits leaf `node` and its children as long as that lowers the expected cost.
fn divide(boxes: &[Aabb], order: &mut [u32], nodes: &mut Vec<Node>, node: usize, depth: usize) {
    let (first, count) = (nodes[node].first as usize, nodes[node].count as usize);
    let slots = &mut order[first..first + count];
    let middle =
        if depth < HEURISTIC_DEPTH { split_by_area(boxes, slots, &nodes[node].bounds) } else { None };
    let Some(middle) = middle.or_else(|| (count > 4).then(|| split_in_half(boxes, slots))) else { return };
    let left = nodes.len();
    nodes.push(leaf(boxes, order, first, middle));
    nodes.push(leaf(boxes, order, first + middle, count - middle));
    (nodes[node].first, nodes[node].count) = (left as u32, 0);
    divide(boxes, order, nodes, left, depth + 1);
    divide(boxes, order, nodes, left + 1, depth + 1);
}

/// Reorders `slots` by the best plane between bins; returns how many go left, or `None` if a leaf is cheaper.
fn split_by_area(boxes: &[Aabb], slots: &mut [u32], bounds: &Aabb) -> Option<usize> {
    let center = |k: &u32| boxes[*k as usize].center();
    let spread = Aabb::around(slots.iter().map(center));
    let BinCut { axis, bin, cost } = (0..3)
        .filter(|axis| spread.max[*axis] > spread.min[*axis])
        .flat_map(|axis| best_plane(boxes, slots, &spread, axis))
        .min_by(|a, b| a.cost.total_cmp(&b.cost))?;
    // 0.2: a box test is taken to cost a tenth of a surface test. An assumption, which decides how many boxes
    // a leaf holds and not what is found.
    let leaf_cost = bounds.surface() * (slots.len() as f64 - 0.2);
    if cost >= leaf_cost {
        return None;
    }
    let is_left = |k: &u32| bin_of(center(k)[axis], &spread, axis) <= bin;
    slots.sort_by_key(|k| !is_left(k));
    Some(slots.iter().filter(|k| is_left(k)).count())
}

/// A cut between two bins.
struct BinCut {
    axis: usize,
    /// The bin after which to cut.
    bin: usize,
    /// Area · count of both sides.
    cost: f64,
}

/// The best cut along `axis`.
fn best_plane(boxes: &[Aabb], slots: &[u32], spread: &Aabb, axis: usize) -> Option<BinCut> {
    let mut bins = [(Aabb::EMPTY, 0usize); BINS];
    for k in slots {
        let bounds = boxes[*k as usize];
        let bin = &mut bins[bin_of(bounds.center()[axis], spread, axis)];
        *bin = (bin.0.union(bounds), bin.1 + 1);
    }
    let add = |side: &mut (Aabb, usize), bin: &(Aabb, usize)| {
        *side = (side.0.union(bin.0), side.1 + bin.1);
        Some(side.0.surface() * side.1 as f64)
    };
    let left: Vec<f64> = bins.iter().scan((Aabb::EMPTY, 0), add).collect();
    let right: Vec<f64> = bins.iter().rev().scan((Aabb::EMPTY, 0), add).collect();
    let cut = |bin: usize| BinCut { axis, bin, cost: left[bin] + right[BINS - 2 - bin] };
    (0..BINS - 1).map(cut).min_by(|a, b| a.cost.total_cmp(&b.cost))
}

fn bin_of(center: f64, spread: &Aabb, axis: usize) -> usize {
    let place = (center - spread.min[axis]) / (spread.max[axis] - spread.min[axis]);
    ((place * BINS as f64) as usize).min(BINS - 1)
}

/// Reorders `slots` about the median centre along the longest spread; returns how many go left.
fn split_in_half(boxes: &[Aabb], slots: &mut [u32]) -> usize {
    let center = |k: &u32| boxes[*k as usize].center();
    let spread = Aabb::around(slots.iter().map(center));
    let axis = (spread.max - spread.min).max_position();
    let middle = slots.len() / 2;
    slots.select_nth_unstable_by(middle, |a, b| {
        (center(a)[axis], a).partial_cmp(&(center(b)[axis], b)).expect("finite")
    });
    middle
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Surface;
    use crate::shapes::Triangle;
    use glam::DVec3;
    use proptest::prelude::*;

    fn triangles(points: &[[f64; 9]]) -> Vec<Triangle> {
        let corner = |p: &[f64; 9], k: usize| DVec3::from_slice(&p[3 * k..]);
        points.iter().filter_map(|p| Triangle::new([0, 1, 2].map(|k| corner(p, k))).ok()).collect()
    }

    fn hierarchy(shapes: &[Triangle]) -> Bvh {
        let boxes: Vec<Aabb> = shapes.iter().map(|s| s.bounds(&crate::Rect::FULL)).collect();
        Bvh::build(&boxes)
    }

    #[test]
    fn an_empty_hierarchy_hits_nothing() {
        let bvh = Bvh::build(&[]);
        assert!(!bvh.any(&Ray::new(DVec3::ZERO, DVec3::X), |_| unreachable!()));
        bvh.overlapping(&Aabb { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY }, |_| unreachable!());
    }

    #[test]
    fn coinciding_boxes_are_all_visited() {
        let unit = Aabb { min: DVec3::ZERO, max: DVec3::ONE };
        let bvh = Bvh::build(&[unit; 1000]);
        let mut seen = 0;
        bvh.overlapping(&unit, |_| seen += 1);
        assert_eq!(seen, 1000);
        let mut tested = 0;
        assert!(!bvh.any(&Ray::new(-DVec3::ONE, DVec3::ONE), |_| {
            tested += 1;
            false
        }));
        assert_eq!(tested, 1000);
    }

    proptest! {
        #[test]
        fn agrees_with_brute_force(
            points in prop::collection::vec(prop::array::uniform9(-1.0..1.0), 1..60),
            rays in prop::collection::vec(prop::array::uniform6(-1.5..1.5), 20),
            flat in prop::bool::ANY,
        ) {
            let shapes = triangles(&points);
            let bvh = hierarchy(&shapes);
            for r in rays {
                let direction = DVec3::new(r[3], if flat { 0.0 } else { r[4] }, r[5]);
                let ray = Ray { origin: DVec3::new(r[0], r[1], r[2]), direction, range: [0.0, 1.0] };
                let mut visited = Vec::new();
                bvh.any(&ray, |k| {
                    visited.push(k);
                    false
                });
                for (k, shape) in shapes.iter().enumerate() {
                    prop_assert!(!shape.occludes(&ray) || visited.contains(&k));
                }
                let is_any_met = shapes.iter().any(|shape| shape.occludes(&ray));
                prop_assert_eq!(bvh.any(&ray, |k| shapes[k].occludes(&ray)), is_any_met);
            }
            let query = Aabb { min: DVec3::splat(-0.2), max: DVec3::splat(0.3) };
            let mut seen = Vec::new();
            bvh.overlapping(&query, |k| seen.push(k));
            for (k, shape) in shapes.iter().enumerate() {
                prop_assert!(!shape.bounds(&crate::Rect::FULL).overlaps(&query) || seen.contains(&k));
            }
        }
    }
}
