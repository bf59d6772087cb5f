//! Many emitters by a tree of balls.
//!
//! A node whose ball is small beside its distance from a point x stands for all of its emitters,
//!
//! ```text
//! Σ E₀ A c c' / (π d²) ,     c ≤ 1, c' ≤ 1: bounds of the cosines at x and at them, of the ball ,
//! ```
//!
//! and each of them gets the part E₀ A of it; any other node is opened, as is one whose Σ E₀ A is lost beside that
//! of those before it. As for single emitters the bound is 0 only where nothing arrives, to rounding.
//!
//! Reference: B. Walter, S. Fernandez, A. Arbree et al., *Lightcuts*, ACM Trans. Graph. 24 (2005), 1098-1107.

use std::f64::consts::PI;
use std::ops::Range;

use radiosity_geom::{Aabb, DVec3};

use super::lamp::{Lamp, cosine};
use crate::receiver_point::ReceiverPoint;

/// Radius of a node over its distance, below which it is not opened: d² then varies by a factor of 2.8 within it.
/// Chosen. Measured below two layers of 400 lamps: the second moment of a choice is 1.12 for 1.00 by single emitters.
const FAR: f64 = 0.25;

/// Cosine of two normals above which they are one. Chosen: flat emitters are parallel to rounding, or not at all.
const PARALLEL: f64 = 1.0 - 1e-12;

/// Emitters in their order, with nodes over them.
#[derive(Debug)]
pub(super) struct LampTree {
    /// Depth first: the first child of a node is the next one.
    nodes: Vec<LampNode>,
    /// Σ E₀ A of the emitters before each place of the list, and of all.
    powers: Vec<f64>,
}

/// Emitters beside each other in the list.
#[derive(Debug)]
struct LampNode {
    lamps: Range<u32>,
    /// Number of nodes below it.
    below: usize,
    center: DVec3,
    radius: f64,
    /// Normal of all of them, where it is the same.
    normal: Option<DVec3>,
}

impl LampTree {
    /// The tree over a list, which it puts in order.
    pub(super) fn over(list: &mut [Lamp]) -> Self {
        let mut nodes = Vec::with_capacity(2 * list.len());
        add_nodes(list, 0, &mut nodes);
        let mut powers = vec![0.0];
        let mut sum = 0.0;
        powers.extend(list.iter().map(|lamp| {
            sum += lamp.brightness * lamp.area;
            sum
        }));
        Self { nodes, powers }
    }

    /// Calls `take` for parts of the list, in order, that cover it, with what each sends to a point, about.
    pub(super) fn visit(
        &self,
        list: &[Lamp],
        receiver: &ReceiverPoint,
        take: &mut dyn FnMut(Range<u32>, f64),
    ) {
        let mut next = 0;
        while let Some(node) = self.nodes.get(next) {
            let distance = node.center.distance(receiver.position);
            let lamps = node.lamps.clone();
            if node.below == 0 {
                let bound = list[lamps.start as usize].bound(receiver);
                take(lamps, bound);
            } else if node.is_hidden_from(receiver) {
                take(lamps, 0.0);
                next += node.below;
            } else if node.radius < FAR * distance && self.power(&lamps) > 0.0 {
                let bound =
                    self.power(&lamps) * node.cosines(receiver, distance) / (PI * distance * distance);
                take(lamps, bound);
                next += node.below;
            }
            next += 1;
        }
    }

    /// Σ E₀ A of some emitters.
    fn power(&self, lamps: &Range<u32>) -> f64 {
        self.powers[lamps.end as usize] - self.powers[lamps.start as usize]
    }

    /// Part of one of some emitters in what all of them send.
    pub(super) fn share_of(&self, lamps: &Range<u32>, place: u32) -> f64 {
        self.power(&(place..place + 1)) / self.power(lamps)
    }

    /// The place among some emitters that a number in [0, 1) chooses in proportion to E₀ A.
    pub(super) fn chosen(&self, lamps: &Range<u32>, choice: f64) -> u32 {
        let wanted = self.powers[lamps.start as usize] + choice * self.power(lamps);
        let before = self.powers.partition_point(|power| *power <= wanted) as u32;
        before.saturating_sub(1).clamp(lamps.start, lamps.end - 1)
    }
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
    nodes.push(LampNode { lamps: start..start + lamps.len() as u32, below: 0, center, radius, normal });
    if lamps.len() == 1 {
        return;
    }
    let size = bounds.max - bounds.min;
    let axis = if size.x >= size.y.max(size.z) {
        DVec3::X
    } else if size.y >= size.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    let half = lamps.len() / 2;
    let key = |lamp: &Lamp| lamp.center.dot(axis);
    lamps.sort_by(|a, b| key(a).total_cmp(&key(b)).then(a.element.cmp(&b.element)));
    let (one, other) = lamps.split_at_mut(half);
    add_nodes(one, start, nodes);
    add_nodes(other, start + half as u32, nodes);
    nodes[place].below = nodes.len() - place - 1;
}
