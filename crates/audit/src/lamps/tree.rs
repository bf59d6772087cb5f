//! The tree by which lamps are chosen.

use radiosity_geom::{Aabb, DVec3};

/// Least square of a distance (scene length²), so that quotients stay numbers.
const LEAST: f64 = 1e-200;

/// A lamp, as the tree knows it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaf {
    pub(super) bounds: Aabb,
    /// Flux of all bands (W).
    pub(super) flux: f64,
    /// A point of its plane and the normal by which all its light leaves, if it is flat.
    pub(super) plane: Option<(DVec3, DVec3)>,
}

/// A binary tree over lamps.
#[derive(Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Node of each lamp.
    leaves: Vec<u32>,
}

#[derive(Debug)]
struct Node {
    center: DVec3,
    half: DVec3,
    /// Square of the radius of its box.
    radius_squared: f64,
    flux: f64,
    plane: Option<(DVec3, DVec3)>,
    parent: u32,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    Lamp(usize),
    Fork([u32; 2]),
}

impl Tree {
    /// The tree over these lamps.
    pub(super) fn of(lamps: &[Leaf]) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * lamps.len()), leaves: vec![0; lamps.len()] };
        let mut order: Vec<usize> = (0..lamps.len()).collect();
        if !lamps.is_empty() {
            tree.add(lamps, &mut order, 0);
        }
        tree
    }

    /// Adds the node of some lamps, split at the middle of the longest side of their centres' box.
    fn add(&mut self, lamps: &[Leaf], own: &mut [usize], parent: u32) -> u32 {
        let place = self.nodes.len() as u32;
        let bounds = own.iter().map(|lamp| lamps[*lamp].bounds).fold(Aabb::EMPTY, Aabb::union);
        let half = 0.5 * (bounds.max - bounds.min);
        let single = (own.len() == 1).then(|| own[0]);
        self.nodes.push(Node {
            center: bounds.center(),
            half,
            radius_squared: half.length_squared(),
            flux: own.iter().map(|lamp| lamps[*lamp].flux).sum(),
            plane: single.and_then(|lamp| lamps[lamp].plane),
            parent,
            content: Content::Lamp(own[0]),
        });
        match single {
            Some(lamp) => self.leaves[lamp] = place,
            None => {
                let centers = Aabb::around(own.iter().map(|lamp| lamps[*lamp].bounds.center()));
                let extent = centers.max - centers.min;
                let axis = (0..3).max_by(|a, b| extent[*a].total_cmp(&extent[*b])).unwrap_or(0);
                let key = |lamp: &usize| lamps[*lamp].bounds.center()[axis];
                own.sort_by(|a, b| key(a).total_cmp(&key(b)).then(a.cmp(b)));
                let (low, high) = own.split_at_mut(own.len() / 2);
                let children = [self.add(lamps, low, place), self.add(lamps, high, place)];
                self.nodes[place as usize].content = Content::Fork(children);
            }
        }
        place
    }

    /// The lamp that a draw chooses for a point that receives along `normal`, and its probability; None where
    /// no lamp sends it light.
    pub(super) fn choose(&self, point: DVec3, normal: DVec3, draw: f64) -> Option<(usize, f64)> {
        let (mut node, mut share, mut draw) = (self.nodes.first()?, 1.0, draw);
        loop {
            let children = match node.content {
                Content::Lamp(lamp) => return Some((lamp, share)),
                Content::Fork(children) => children.map(|child| &self.nodes[child as usize]),
            };
            let [low, high] = children.map(|child| child.importance(point, normal));
            let part = low / (low + high);
            if part.is_nan() {
                return None;
            }
            let is_low = draw < part;
            let own = if is_low { part } else { 1.0 - part };
            draw = (if is_low { draw / part } else { (draw - part) / own }).clamp(0.0, 1.0 - f64::EPSILON);
            share *= own;
            node = children[usize::from(!is_low)];
        }
    }

    /// The probability with which a point that receives along `normal` chooses a lamp.
    pub(super) fn share(&self, lamp: usize, point: DVec3, normal: DVec3) -> f64 {
        let (mut place, mut share) = (self.leaves[lamp], 1.0);
        while place != 0 {
            let parent = self.nodes[place as usize].parent;
            let Content::Fork(children) = self.nodes[parent as usize].content else { return 0.0 };
            let [low, high] = children.map(|child| self.nodes[child as usize].importance(point, normal));
            let part = low / (low + high);
            share *= if children[0] == place { part } else { 1.0 - part };
            place = parent;
        }
        if share.is_nan() { 0.0 } else { share }
    }
}

impl Node {
    /// A number about in proportion to the light that its lamps may send to a point that receives along
    /// `normal`; 0 where they send none for certain.
    fn importance(&self, point: DVec3, normal: DVec3) -> f64 {
        let step = self.center - point;
        if normal.dot(step) + self.half.dot(normal.abs()) <= 0.0 {
            return 0.0;
        }
        if self.plane.is_some_and(|(origin, front)| (point - origin).dot(front) <= 0.0) {
            return 0.0;
        }
        // Not at 0: a lamp may be a point, and a receiver at it.
        self.flux / step.length_squared().max(self.radius_squared).max(LEAST)
    }
}
