//! Links, each an undirected record that is used both ways, and the gathering over them.
//!
//! ```text
//! Φ_p = Σ_q w B_q ,     f_p = Σ_q w s_q Y(d_pq) ,     s_q = B_q of a face, x_q·Y(−d_pq) of a cluster
//! ```
//!
//! The weight w is the exchange of two faces times visibility; with clusters it is V/(π r²), times the area
//! that a face shows towards the cluster's centre.

use std::f64::consts::PI;

use radiosity_core::dot;
use radiosity_geom::{DVec3, RayTree};
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use super::exchange::exchange;
use super::face::Face;
use super::fields::Fields;
use super::harmonics::{HARMONICS, add, harmonics};
use super::pair_refinement::Pair;
use super::sight::visible_part;
use super::tree::Tree;

/// Nodes that one thread gathers at a time at least: a node takes less time than to hand it over.
const CHUNK: usize = 256;

/// A pair of nodes that exchange light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    pub pair: Pair,
    /// w (scene length² between faces, no unit between a face and a cluster, 1/length² between clusters).
    pub weight: f64,
    /// w if nothing were hidden.
    pub unhidden: f64,
}

impl Link {
    /// The link of two nodes, its visibility by `rays` rays.
    pub(crate) fn new(tree: &Tree, obstacles: &RayTree, pair: Pair, rays: usize) -> Self {
        check_interrupt();
        let unhidden = unhidden(tree, pair);
        let weight = match unhidden > 0.0 {
            true => unhidden * visible_part(tree, obstacles, pair.map(|node| node as usize), rays),
            false => 0.0,
        };
        Self { pair, weight, unhidden }
    }
}

/// The weight of a link that nothing hides.
fn unhidden(tree: &Tree, pair: Pair) -> f64 {
    let [p, q] = pair.map(|node| &tree.nodes()[node as usize]);
    if let (Some(a), Some(b)) = (&p.face, &q.face) {
        return exchange(a, b);
    }
    let (offset, distance2) = (q.center - p.center, p.center.distance_squared(q.center));
    let toward = offset.normalize_or_zero();
    let area = |face: &Option<Box<Face>>, direction| face.as_ref().map_or(1.0, |face| shown(face, direction));
    area(&p.face, toward) * area(&q.face, -toward) / (PI * distance2)
}

/// The area that a face shows towards a direction (scene length²).
fn shown(face: &Face, direction: DVec3) -> f64 {
    dot(&face.moments, &harmonics(direction)).max(0.0)
}

/// All links, by the nodes that they join.
#[derive(Debug, Default)]
pub(crate) struct Links {
    /// Where the ends of each node start, and their number.
    starts: Vec<usize>,
    /// The ends of all nodes.
    ends: Vec<End>,
}

/// An end of a link at a node.
#[derive(Clone, Copy, Debug, Default)]
struct End {
    /// The other node.
    other: u32,
    /// w.
    weight: f64,
}

impl Links {
    /// Sorts a list of links by nodes; those that carry nothing are left out.
    pub(crate) fn new(nodes: usize, list: &[Link]) -> Self {
        let directed = || list.iter().filter(|link| link.weight != 0.0).flat_map(ends);
        let mut starts = vec![0; nodes + 1];
        directed().for_each(|(node, _)| starts[node as usize + 1] += 1);
        (0..nodes).for_each(|node| starts[node + 1] += starts[node]);
        let mut free = starts.clone();
        let mut sorted = vec![End::default(); starts[nodes]];
        for (node, end) in directed() {
            sorted[free[node as usize]] = end;
            free[node as usize] += 1;
        }
        Self { starts, ends: sorted }
    }

    /// Fields that all nodes receive, from those that they send; sums in the order of the list, whatever the
    /// threads.
    pub(crate) fn gather(&self, tree: &Tree, sent: &Fields) -> Fields {
        let clusters = tree.clusters();
        let fields = (0..clusters).into_par_iter().with_min_len(CHUNK);
        let powers = (clusters..tree.nodes().len()).into_par_iter().with_min_len(CHUNK);
        Fields {
            clusters: fields.map(|node| self.field(tree, sent, node)).collect(),
            faces: powers.map(|node| self.power(tree, sent, node)).collect(),
        }
    }

    fn of(&self, node: usize) -> &[End] {
        &self.ends[self.starts[node]..self.starts[node + 1]]
    }

    /// Φ of a face (W).
    fn power(&self, tree: &Tree, sent: &Fields, node: usize) -> f64 {
        check_interrupt();
        let from = |End { other, weight }: &End| {
            let other = *other as usize;
            weight * source(tree, sent, other, direction(tree, other, node))
        };
        self.of(node).iter().map(from).sum()
    }

    /// f of a cluster.
    fn field(&self, tree: &Tree, sent: &Fields, node: usize) -> [f64; HARMONICS] {
        check_interrupt();
        let mut field = [0.0; HARMONICS];
        for End { other, weight } in self.of(node) {
            let other = *other as usize;
            let toward = direction(tree, node, other);
            add(&mut field, weight * source(tree, sent, other, -toward), &harmonics(toward));
        }
        field
    }

    /// w of the link of a face with itself, 0 without one.
    pub(crate) fn own(&self, node: usize) -> f64 {
        self.of(node).iter().filter(|end| end.other as usize == node).map(|end| end.weight).sum()
    }
}

/// The ends of a link, each with its node; one end of a link to itself.
fn ends(link: &Link) -> impl Iterator<Item = (u32, End)> + use<> {
    let Link { pair: [p, q], weight, .. } = *link;
    let back = (p != q).then_some((q, End { other: p, weight }));
    std::iter::once((p, End { other: q, weight })).chain(back)
}

fn direction(tree: &Tree, from: usize, to: usize) -> DVec3 {
    (tree.nodes()[to].center - tree.nodes()[from].center).normalize_or_zero()
}

/// s of a node in a direction.
fn source(tree: &Tree, sent: &Fields, node: usize, direction: DVec3) -> f64 {
    match node.checked_sub(tree.clusters()) {
        Some(face) => sent.faces[face],
        None => dot(&sent.clusters[node], &harmonics(direction)),
    }
}
