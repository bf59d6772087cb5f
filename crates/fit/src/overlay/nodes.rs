//! Nodes of a drawing, and the sides near to a point.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use radiosity_geom::{Aabb, Bvh, distance_to_segment, sides};

/// Pieces of the extent that longer sides are searched in, since the box around a slanting side is large. An
/// arbitrary choice, on which time alone depends: fewer pieces find more sides that are not near, more make
/// more boxes.
const PIECES: f64 = 16.0;

pub(super) fn bits(x: DVec3) -> [u64; 3] {
    x.to_array().map(f64::to_bits)
}

/// Points no two of which are nearer than the tolerance.
pub(super) struct Nodes {
    pub(super) points: Vec<DVec3>,
    pub(super) flat: Vec<DVec2>,
    pub(super) index: HashMap<[u64; 3], usize>,
    cells: HashMap<[i64; 2], Vec<usize>>,
    cell: f64,
    /// Number of nodes made of given points; these come first.
    pub(super) given: usize,
}

impl Nodes {
    pub(super) fn new(tolerance: f64) -> Self {
        let cell = tolerance.max(f64::MIN_POSITIVE);
        Nodes { points: vec![], flat: vec![], index: HashMap::new(), cells: HashMap::new(), cell, given: 0 }
    }

    /// Index of the sides near to a point.
    pub(super) fn near(&self, sides: &[[usize; 2]]) -> Near {
        let [low, high] = self.bounds();
        let extent = low.distance(high).max(f64::MIN_POSITIVE);
        let (mut boxes, mut of) = (Vec::with_capacity(sides.len()), Vec::with_capacity(sides.len()));
        for (index, side) in sides.iter().enumerate() {
            let ends = side.map(|node| self.flat[node].extend(0.0));
            let pieces = (PIECES * ends[0].distance(ends[1]) / extent).ceil().max(1.0);
            for k in 0..pieces as usize {
                let part = [k, k + 1].map(|k| ends[0].lerp(ends[1], k as f64 / pieces));
                boxes.push(Aabb::around(part).inflate(self.cell));
                of.push(index);
            }
        }
        Near { tree: Bvh::build(&boxes), sides: of }
    }

    pub(super) fn bounds(&self) -> [DVec2; 2] {
        let low = self.flat.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        [low, self.flat.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max)]
    }

    /// The nearest node within the tolerance of a point, or a new one.
    pub(super) fn take(&mut self, x: DVec3, flat: DVec2) -> usize {
        let cell = (flat / self.cell).floor();
        let cell = [cell.x as i64, cell.y as i64];
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [i, j]));
        let near = around
            .filter_map(|[i, j]| self.cells.get(&[cell[0].saturating_add(i), cell[1].saturating_add(j)]))
            .flatten();
        let nearest = near
            .map(|node| (*node, self.flat[*node].distance(flat)))
            .filter(|(_, distance)| *distance <= self.cell)
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((node, _)) = nearest {
            return node;
        }
        let node = self.points.len();
        self.points.push(x);
        self.flat.push(flat);
        self.index.entry(bits(x)).or_insert(node);
        self.cells.entry(cell).or_default().push(node);
        node
    }
}

/// Sides in pieces, each in a box that leaves out no point nearer to it than the tolerance: a point is in few
/// of them also where long sides cross.
pub(super) struct Near {
    tree: Bvh,
    /// The side of each piece.
    sides: Vec<usize>,
}

impl Near {
    /// Visits the sides that may be near to a point, some of them twice.
    pub(super) fn at(&self, point: DVec3, mut visit: impl FnMut(usize)) {
        self.tree.overlapping(&Aabb { min: point, max: point }, |piece| visit(self.sides[piece]));
    }
}

/// The rings with each side led through the nodes that lie on it, without sides of no length.
pub(super) fn through_nodes(rings: Vec<Vec<usize>>, nodes: &Nodes, tolerance: f64) -> Vec<Vec<usize>> {
    let point = |node: usize| nodes.flat[node].extend(0.0);
    let sides: Vec<[usize; 2]> = rings.iter().flat_map(|ring| sides(ring)).collect();
    let near = nodes.near(&sides);
    let mut on: Vec<Vec<usize>> = vec![Vec::new(); sides.len()];
    for node in 0..nodes.flat.len() {
        let at = point(node);
        near.at(at, |side| {
            let [from, to] = sides[side];
            let is_near = || distance_to_segment(at, [point(from), point(to)]) <= tolerance;
            if node != from && node != to && from != to && is_near() {
                on[side].push(node);
            }
        });
    }
    let mut side = 0;
    let mut led = Vec::with_capacity(rings.len());
    for ring in rings {
        let mut nodes_of = Vec::with_capacity(ring.len());
        for from in ring {
            nodes_of.push(from);
            let way = |node: &usize| nodes.flat[*node].distance_squared(nodes.flat[from]);
            on[side].sort_by(|a, b| way(a).total_cmp(&way(b)));
            nodes_of.append(&mut on[side]);
            side += 1;
        }
        nodes_of.dedup();
        led.push(nodes_of);
    }
    led
}
