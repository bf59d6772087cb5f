//! Many emitters by a tree of balls.
//!
//! A node whose ball, of radius r, is small beside its distance d from a point x stands for all of its emitters,
//!
//! ```text
//! w = Σ E₀ A c c' / (π max(d, r)²) ,     c ≤ 1, c' ≤ 1: bounds of the cosines at x and at them, of the ball ,
//! ```
//!
//! any other node is opened. One of its emitters is chosen on the way down: of two children each gets the part w of
//! what their parent has, or Σ E₀ A where both are 0. So a look at some nodes and at the children on one way takes the
//! place of one at all emitters. As for single emitters w is 0 only where nothing arrives, to rounding.
//!
//! References: B. Walter, S. Fernandez, A. Arbree et al., *Lightcuts*, ACM Trans. Graph. 24 (2005), 1098-1107;
//! A. Conty Estévez, C. Kulla, *Importance sampling of many lights with adaptive tree splitting*, Proc. ACM Comput.
//! Graph. Interact. Tech. 1 (2018), 25:1-17 (the choice on the way down).

use std::f64::consts::PI;
use std::ops::Range;

use radiosity_geom::{Aabb, DVec3};

use super::lamp::{Lamp, cosine};
use crate::receiver_point::ReceiverPoint;

/// Radius of a node over its distance, below which it is not opened. Chosen. Measured below a layer of 400 lamps:
/// with 0.25, 0.5 and 1 the second moment of a choice is 1.03, 1.06 and 1.14 for 1 by single emitters, from 86, 24
/// and 4 nodes; near that layer 1.08, 1.22 and 1.79.
const FAR: f64 = 0.5;

/// Part of the longest side of a node that a unit between normals counts as, where it is divided: opposed emitters are
/// parted first, those at right angles are not. Chosen.
const TURN: f64 = 0.6;

/// Cosine of two normals above which they are one. Chosen: flat emitters are parallel to rounding, or not at all.
const PARALLEL: f64 = 1.0 - 1e-12;

/// Emitters in their order, with nodes over them.
#[derive(Debug)]
pub(super) struct LampTree {
    /// Depth first: the first child of a node is the next one.
    nodes: Vec<LampNode>,
}

/// A node, by its place in the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct NodePlace(u32);

/// Emitters beside each other in the list.
#[derive(Debug)]
struct LampNode {
    lamps: Range<u32>,
    /// Number of nodes below it.
    below: usize,
    /// Σ E₀ A.
    power: f64,
    center: DVec3,
    radius: f64,
    /// Largest radius of an emitter (scene length).
    largest: f64,
    /// Normal of all of them, where it is the same.
    normal: Option<DVec3>,
}

impl LampTree {
    /// The tree over a list, which it puts in order.
    pub(super) fn over(list: &mut [Lamp]) -> Self {
        let mut nodes = Vec::with_capacity(2 * list.len());
        add_nodes(list, 0, &mut nodes);
        Self { nodes }
    }

    /// Whether one of the emitters within so many of their radii of a point `is_wanted`.
    pub(super) fn any_near(
        &self,
        list: &[Lamp],
        point: DVec3,
        radii: f64,
        is_wanted: impl Fn(&Lamp) -> bool,
    ) -> bool {
        let mut next = 0;
        while let Some(node) = self.nodes.get(next) {
            let is_far = node.center.distance(point) - node.radius >= radii * node.largest;
            if !is_far && node.below == 0 && is_wanted(&list[node.lamps.start as usize]) {
                return true;
            }
            next += if is_far { 1 + node.below } else { 1 };
        }
        false
    }
}

/// The emitters of a tree as a point sees them.
#[derive(Debug)]
pub(super) struct SeenTree<'a> {
    pub(super) tree: &'a LampTree,
    pub(super) list: &'a [Lamp],
    pub(super) receiver: ReceiverPoint,
}

impl SeenTree<'_> {
    /// Nodes that cover the list, in order, with what the emitters of each send to the point, about.
    pub(super) fn nodes(&self) -> impl Iterator<Item = (NodePlace, f64)> {
        let mut next = 0;
        std::iter::from_fn(move || {
            loop {
                let place = next;
                let node = self.tree.nodes.get(place)?;
                let is_opened = node.below > 0
                    && node.radius >= FAR * node.center.distance(self.receiver.position)
                    && !node.is_hidden_from(&self.receiver);
                next += if is_opened { 1 } else { 1 + node.below };
                if !is_opened {
                    return Some((NodePlace(place as u32), self.sent(node)));
                }
            }
        })
    }

    /// The places in the list of the emitters of a node.
    pub(super) fn lamps(&self, NodePlace(node): NodePlace) -> Range<u32> {
        self.node(node as usize).lamps.clone()
    }

    /// Part of one of the emitters of a node in what they send to the point.
    pub(super) fn share_of(&self, NodePlace(node): NodePlace, lamp: u32) -> f64 {
        let (mut own, mut share) = (node as usize, 1.0);
        while self.node(own).below > 0 {
            let Fork { children: [first, second], part } = self.fork(own);
            let is_first = self.node(first).lamps.contains(&lamp);
            (own, share) = if is_first { (first, share * part) } else { (second, share * (1.0 - part)) };
        }
        share
    }

    /// The place in the list of the emitter of a node that a number in [0, 1) chooses by what it sends to the point.
    pub(super) fn chosen(&self, NodePlace(node): NodePlace, choice: f64) -> u32 {
        let (mut own, mut choice) = (node as usize, choice);
        while self.node(own).below > 0 {
            let Fork { children: [first, second], part } = self.fork(own);
            (own, choice) = if choice < part {
                (first, choice / part)
            } else {
                // Rounding may lead to 1.
                (second, ((choice - part) / (1.0 - part)).min(1.0 - f64::EPSILON))
            };
        }
        self.node(own).lamps.start
    }

    /// The way on from a node that has children.
    fn fork(&self, node: usize) -> Fork {
        let children = [node + 1, node + 2 + self.node(node + 1).below];
        let [first, second] = children.map(|child| self.node(child));
        let [mut one, mut other] = [first, second].map(|child| self.sent(child));
        if one + other <= 0.0 {
            [one, other] = [first.power, second.power];
        }
        Fork { children, part: one / (one + other) }
    }

    /// About the light that the emitters of a node send to the point without shadows; 0 only where they send none.
    fn sent(&self, node: &LampNode) -> f64 {
        if node.below == 0 {
            return self.list[node.lamps.start as usize].bound(&self.receiver);
        }
        if node.is_hidden_from(&self.receiver) {
            return 0.0;
        }
        let distance = node.center.distance(self.receiver.position);
        node.power * node.cosines(&self.receiver, distance) / (PI * distance.max(node.radius).powi(2))
    }

    fn node(&self, place: usize) -> &LampNode {
        &self.tree.nodes[place]
    }
}

/// The way from a node to one of its children.
struct Fork {
    children: [usize; 2],
    /// Part of the first child in what both send.
    part: f64,
}

impl LampNode {
    /// Whether none of its emitters can send light to a point.
    fn is_hidden_from(&self, receiver: &ReceiverPoint) -> bool {
        let step = self.center - receiver.position;
        let is_below = |normal: DVec3| step.dot(normal) + self.radius <= 0.0;
        let is_behind = |normal: DVec3| self.radius <= step.dot(normal);
        is_below(receiver.normal)
            || receiver.ground.is_some_and(is_below)
            || self.normal.is_some_and(is_behind)
    }

    /// Bounds of the cosines at a point and at its emitters, multiplied.
    fn cosines(&self, receiver: &ReceiverPoint, distance: f64) -> f64 {
        let step = self.center - receiver.position;
        let own = |normal: DVec3| (self.radius - step.dot(normal)) / (distance + self.radius);
        cosine(receiver, step, self.radius) * self.normal.map_or(1.0, own)
    }
}

/// Adds the nodes over emitters that begin at `start` in the whole list, and puts these in order.
fn add_nodes(lamps: &mut [Lamp], start: u32, nodes: &mut Vec<LampNode>) {
    let place = nodes.len();
    let bounds = Aabb::around(lamps.iter().map(|lamp| lamp.center));
    let center = bounds.center();
    let radius = lamps.iter().map(|lamp| center.distance(lamp.center) + lamp.radius).fold(0.0, f64::max);
    let first = lamps[0].plane.map(|plane| plane.normal);
    let is_same = |normal: &DVec3| {
        lamps.iter().all(|lamp| lamp.plane.is_some_and(|plane| plane.normal.dot(*normal) > PARALLEL))
    };
    let normal = first.filter(is_same);
    let largest = lamps.iter().map(|lamp| lamp.radius).fold(0.0, f64::max);
    let power = lamps.iter().map(|lamp| lamp.brightness * lamp.area).sum();
    nodes.push(LampNode {
        lamps: start..start + lamps.len() as u32,
        below: 0,
        power,
        center,
        radius,
        largest,
        normal,
    });
    if lamps.len() == 1 {
        return;
    }
    let half = lamps.len() / 2;
    let [axis, normal_axis] = longest_axes(lamps, &bounds);
    let key = |lamp: &Lamp| lamp.center.dot(axis) + normal_of(lamp).dot(normal_axis);
    lamps.sort_by(|a, b| key(a).total_cmp(&key(b)).then(a.element.cmp(&b.element)));
    let (one, other) = lamps.split_at_mut(half);
    add_nodes(one, start, nodes);
    add_nodes(other, start + half as u32, nodes);
    nodes[place].below = nodes.len() - place - 1;
}

/// Axes of middles and of normals, one of them 0, along which emitters within these bounds reach farthest: a
/// unit between normals counts as `TURN` of the longest side of the bounds.
fn longest_axes(lamps: &[Lamp], bounds: &Aabb) -> [DVec3; 2] {
    let size = bounds.max - bounds.min;
    let normals = Aabb::around(lamps.iter().map(normal_of));
    let turns = TURN * size.max_element() * (normals.max - normals.min);
    let (axis, turn_axis) = (size.max_position(), turns.max_position());
    if turns[turn_axis] >= size[axis] {
        [DVec3::ZERO, DVec3::AXES[turn_axis]]
    } else {
        [DVec3::AXES[axis], DVec3::ZERO]
    }
}

/// The normal of a flat emitter, else 0.
fn normal_of(lamp: &Lamp) -> DVec3 {
    lamp.plane.map_or(DVec3::ZERO, |plane| plane.normal)
}
