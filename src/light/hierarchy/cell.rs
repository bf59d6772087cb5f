//! A cell: a patch with a field at its 2 × 2 Gauss points.
//!
//! The field is kept per channel (a band, or the constant 1). What decides about division is kept in multiples of a scale
//! per channel, the largest over the channels: how bright the cell is, how much the field varies over it, and how far its
//! mean is off that of its quarters. Quarters that were not given their own field take the bilinear interpolant of the four
//! points; they are made when they are first asked for, and kept near the root, where many ask.

use std::ops::Deref;
use std::sync::OnceLock;

use radiosity_geom::DVec3;
use smallvec::SmallVec;

use crate::elements::patch::{Direction, Node, Patch};
use crate::elements::rule::UnitRule;
use crate::visibility::shadow_volume::Quad;

/// Length over breadth above which a curved cell is only cut across.
const LONG: f64 = 2.0;

/// Gauss points of a cell, index 2 a + b for the a-th along s and the b-th along t.
pub(crate) const POINTS: usize = 4;

/// Levels below the root down to which quarters are kept.
const KEPT: u8 = 5;

/// Cosine between its normals from which on a cell with straight sides is much like a flat one.
const LEVEL: f64 = 0.999;

/// A patch with a field at its Gauss points.
#[derive(Clone, Debug)]
pub struct Cell {
    patch: Patch,
    /// Quarterings that made it.
    level: u8,
    quarters: OnceLock<Box<[Cell; 4]>>,
    /// Points whose convex hull contains it: its corners if it is flat.
    pub hull: SmallVec<[DVec3; 4]>,
    /// The Gauss points; the area of each is its part of the cell's.
    pub nodes: [Node; POINTS],
    /// Their places, component by component.
    pub lanes: [[f64; POINTS]; 3],
    /// The field at each point, channel after channel.
    values: SmallVec<[f64; 12]>,
    /// Places and normals at the corners of a curved cell and at its Gauss points.
    pub facets: Vec<(DVec3, DVec3)>,
    /// Middle of the hull.
    pub center: DVec3,
    /// Radius of the ball around the middle that holds the hull.
    pub radius: f64,
    /// Its corners and the radius around their mean, where its hull is that of four points or fewer.
    pub quad: Option<(Quad, f64)>,
    /// Largest mean over the scale.
    pub brightness: f64,
    /// Largest difference from the mean over the scale.
    pub spread: f64,
    /// Largest difference of the mean from that of the quarters, over the scale.
    pub detail: f64,
    /// Smallest cosine between two normals.
    pub bend: f64,
    /// Whether its border is the polygon of its hull: Lambert's form follows the border alone.
    pub is_straight: bool,
    /// About how far a curved cell lies from the quad of its corners, in its plane or out of it, over its radius.
    pub warp: f64,
}

impl Cell {
    /// A patch of an element without a field.
    pub fn bare(patch: Patch) -> Self {
        Self::at_level(patch, 0)
    }

    fn at_level(patch: Patch, level: u8) -> Self {
        let hull = SmallVec::from_vec(patch.hull());
        let center = hull.iter().sum::<DVec3>() / hull.len() as f64;
        let radius = hull.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max).sqrt();
        let (places, weights) = UnitRule::of(2).line();
        let node = |k: usize| {
            let node = patch.node(places[k / 2], places[k % 2]);
            Node { area: node.area * weights[k / 2] * weights[k % 2], ..node }
        };
        let nodes: [Node; POINTS] = std::array::from_fn(node);
        let lanes = [0, 1, 2].map(|axis| nodes.map(|node| node.position[axis]));
        let mut facets = Vec::new();
        if !patch.is_flat() {
            facets.extend(nodes.iter().map(|node| (node.position, node.normal)));
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[s, t]| patch.node(s, t));
            facets.extend(corners.iter().map(|node| (node.position, node.normal)));
        }
        let pairs =
            facets.iter().enumerate().flat_map(|(k, a)| facets[..k].iter().map(move |b| a.1.dot(b.1)));
        let bend = pairs.fold(1.0, f64::min);
        let is_straight = patch.is_flat() || (bend > LEVEL && hull[..] == patch.corners());
        let quad = is_straight.then(|| Quad::new(patch.corners())).map(|quad| (quad, quad.radius()));
        let warp = if radius > 0.0 { patch.sagitta() / radius } else { 0.0 };
        Self {
            patch,
            level,
            quarters: OnceLock::new(),
            hull,
            nodes,
            lanes,
            facets,
            values: SmallVec::new(),
            center,
            radius,
            quad,
            brightness: 0.0,
            spread: 0.0,
            detail: 0.0,
            bend,
            is_straight,
            warp,
        }
    }

    /// The same cell with a field at its points.
    pub fn with_values(mut self, values: SmallVec<[f64; 12]>, scale: &[f64]) -> Self {
        self.values = values;
        for (channel, scale) in scale.iter().enumerate() {
            let mean = self.mean(channel);
            let difference = |k: usize| (self.value(k, channel) - mean).abs();
            let spread = (0..POINTS).map(difference).fold(0.0, f64::max);
            self.brightness = self.brightness.max(mean.abs() / scale);
            self.spread = self.spread.max(spread / scale);
        }
        self
    }

    /// The field at a point.
    pub fn value(&self, point: usize, channel: usize) -> f64 {
        self.values[point * (self.values.len() / POINTS) + channel]
    }

    /// Mean of the field over the cell's area.
    pub fn mean(&self, channel: usize) -> f64 {
        let area = self.area();
        let sum: f64 = (0..POINTS).map(|k| self.nodes[k].area * self.value(k, channel)).sum();
        if area > 0.0 { sum / area } else { 0.0 }
    }

    /// Area by the Gauss rule.
    pub fn area(&self) -> f64 {
        self.nodes.iter().map(|node| node.area).sum()
    }

    /// Its corners in order, each once.
    pub fn outline(&self) -> Vec<DVec3> {
        let mut corners = self.patch.corners().to_vec();
        let same = |a: &DVec3, b: &DVec3| a.distance(*b) <= 1e-9 * self.radius;
        corners.dedup_by(|a, b| same(a, b));
        if corners.len() > 1 && same(&corners[0], &corners[corners.len() - 1]) {
            corners.pop();
        }
        corners
    }

    /// Whether it lies in a plane.
    pub fn is_flat(&self) -> bool {
        self.patch.is_flat()
    }

    /// Whether the field is the same everywhere on it.
    pub fn is_uniform(&self) -> bool {
        self.spread == 0.0 && self.detail == 0.0
    }

    /// Whether it is a flat parallelogram.
    pub fn is_parallelogram(&self) -> bool {
        self.patch.is_parallelogram()
    }

    /// Gives it its quarters, with the same field, and takes over what they show of it.
    pub fn divide(&mut self, quarters: [Cell; 4], scale: &[f64]) {
        let whole: f64 = quarters.iter().map(Cell::area).sum();
        for (channel, scale) in scale.iter().enumerate() {
            let mean = self.mean(channel);
            let parts = quarters.iter().map(|quarter| quarter.area() * quarter.mean(channel)).sum::<f64>();
            let points = quarters.iter().flat_map(|quarter| (0..POINTS).map(|k| quarter.value(k, channel)));
            let spread = points.map(|value| (value - mean).abs()).fold(0.0, f64::max);
            self.spread = self.spread.max(spread / scale);
            if whole > 0.0 {
                self.detail = self.detail.max((parts / whole - mean).abs() / scale);
            }
        }
        self.quarters = OnceLock::from(Box::new(quarters));
    }

    /// The four quarters, index 2 a + b like the points.
    pub fn quarters(&self, scale: &[f64]) -> Quarters<'_> {
        if self.level < KEPT || self.quarters.get().is_some() {
            Quarters::Kept(self.quarters.get_or_init(|| Box::new(self.interpolated(scale))))
        } else {
            Quarters::Passing(Box::new(self.interpolated(scale)))
        }
    }

    /// The directions in which it is halved: a long curved cell, as at a pole, twice along its length.
    fn directions(&self) -> [Direction; 2] {
        let apart = |i: usize, j: usize| self.nodes[i].position.distance(self.nodes[j].position);
        let (along, across) = (apart(0, 2).max(apart(1, 3)), apart(0, 1).max(apart(2, 3)));
        match self.is_flat() {
            false if along > LONG * across => [Direction::Along; 2],
            false if across > LONG * along => [Direction::Across; 2],
            _ => [Direction::Along, Direction::Across],
        }
    }

    /// The four quarters without a field, index 2 a + b, a for the first halving and b for the second.
    pub fn bare_quarters(&self) -> [Cell; 4] {
        let [first, second] = self.directions();
        let halves = self.patch.halves(first).map(|half| half.halves(second));
        let [[a, b], [c, d]] = halves;
        [a, b, c, d].map(|patch| Self::at_level(patch, self.level + 1))
    }

    /// The four quarters with the bilinear interpolant of the field, which does not leave the range of the four points.
    fn interpolated(&self, scale: &[f64]) -> [Cell; 4] {
        let places = &UnitRule::of(2).nodes;
        let channels = scale.len();
        let directions = self.directions();
        // Share of the points at the far side of the cell in a direction, at the c-th point of a quarter.
        let share = |direction: Direction, [a, b]: [usize; 2], c: usize| {
            let place = match directions.map(|halved| halved == direction) {
                [true, true] => 0.25 * ((2 * a + b) as f64 + places[c]),
                [true, false] => 0.5 * (a as f64 + places[c]),
                [false, true] => 0.5 * (b as f64 + places[c]),
                [false, false] => places[c],
            };
            (place - places[0]) / (places[1] - places[0])
        };
        let mut index = 0;
        self.bare_quarters().map(|quarter| {
            let part = [index / 2, index % 2];
            index += 1;
            let value = |place: usize| {
                let (point, channel) = (place / channels, place % channels);
                let (s, t) =
                    (share(Direction::Along, part, point / 2), share(Direction::Across, part, point % 2));
                let side = |k: usize| (1.0 - t) * self.value(k, channel) + t * self.value(k + 1, channel);
                let known = || (0..POINTS).map(|k| self.value(k, channel));
                let (low, high) = (known().fold(f64::MAX, f64::min), known().fold(f64::MIN, f64::max));
                ((1.0 - s) * side(0) + s * side(2)).max(low).min(high)
            };
            let values = (0..POINTS * channels).map(value).collect();
            quarter.with_values(values, scale)
        })
    }
}

/// The quarters of a cell.
pub enum Quarters<'a> {
    /// Kept with it.
    Kept(&'a [Cell; 4]),
    /// Made for once.
    Passing(Box<[Cell; 4]>),
}

impl Deref for Quarters<'_> {
    type Target = [Cell; 4];

    fn deref(&self) -> &[Cell; 4] {
        match self {
            Self::Kept(quarters) => quarters,
            Self::Passing(quarters) => quarters,
        }
    }
}
