//! A cell: a patch with the values of a field at its 2 × 2 Gauss points.
//!
//! The field has one or more channels (a band each, or the constant 1). Brightness, variation and detail of a
//! cell decide about its division; each is the largest over the channels, in multiples of the channel's
//! scale. Quarters without a field of their own take the bilinear function through the four points, which is
//! continued to the border of the cell: receivers at an edge that two surfaces share see nothing but that
//! border. Only where the field is known to jump, continued values keep within the range of the four.
//! Quarters are made when first needed, and kept near the root, where many points need them.

use std::ops::Deref;
use std::sync::OnceLock;

use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{COINCIDENT, DVec3, Plane, Rect, clip_polygon, sides};
use radiosity_scene::Radiance;
use radiosity_visibility::shadow_volume::Quad;
use smallvec::{SmallVec, smallvec};

use crate::cells::moments::{Grid, Moments};
use crate::tolerances::{COSINE_OF_FLAT, LONG_CELL, LONG_STRIP};

/// Number of Gauss points, index 2 a + b for the a-th along s and the b-th along t.
pub(crate) const POINTS: usize = 4;

/// Levels below the root down to which quarters are kept: at most 4⁵ = 1024 for each patch. Deeper ones serve
/// few points, and more would fill the memory.
const KEPT: u8 = 5;

/// Distance from the border of a cell, over that of the point that sees it, at which the radiance nearest to that is
/// asked: a border may lie where it jumps, at the horizon. Chosen: 0.6° is more than rounding turns it.
const INSIDE: f64 = 0.01;

/// Error of the rule over the second difference, at least, where the field bends at once: of |s| over
/// −1 ≤ s ≤ 1 the two-point rule makes 0.577 for ½, with the second difference 0.577.
const BENT: f64 = 0.13;

/// A patch with the values of a field at its Gauss points.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    patch: Patch,
    /// Number of quarterings that made it.
    level: u8,
    quarters: OnceLock<Box<[Cell; 4]>>,
    /// Points whose convex hull contains the cell: its corners if it is flat.
    pub(crate) hull: SmallVec<[DVec3; 4]>,
    /// The Gauss points; the area of each is its share of the cell's.
    pub(crate) nodes: [Node; POINTS],
    /// The positions of the Gauss points, component by component.
    pub(crate) lanes: [[f64; POINTS]; 3],
    pub(crate) field: Field,
    /// Tangent planes at the corners and the Gauss points of a curved cell.
    pub(crate) samples: Vec<Plane>,
    /// Mean of the points of the hull.
    pub(crate) center: DVec3,
    /// Radius of the ball about the centre that contains the hull.
    pub(crate) radius: f64,
    /// The corners, where the cell counts as a flat quadrilateral.
    pub(crate) quad: Option<MeasuredQuad>,
    /// Whether the bilinear function of the four values may be continued beyond their range.
    is_smooth: bool,
    /// Smallest cosine between two normals.
    pub(crate) bend: f64,
    /// Whether its border is the polygon of its hull, which Lambert's formula follows.
    pub(crate) is_straight: bool,
    /// Sagitta over radius: about how far a curved cell lies off the quadrilateral of its corners.
    pub(crate) warp: f64,
    /// By how much its points miss its area and place.
    pub(crate) moments: Moments,
}

/// A field at the Gauss points of a cell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Field {
    /// Values, point after point, channels fastest.
    values: SmallVec<[f64; 12]>,
    /// Mean of each channel over the cell's area, by its finest parts.
    means: SmallVec<[f64; 3]>,
    /// Largest mean of a channel over its scale.
    pub(crate) brightness: f64,
    /// Largest difference of a value from the mean, over the channel's scale.
    pub(crate) spread: f64,
    /// Largest difference between the mean by the cell's points and that by its finest parts, over the
    /// channel's scale.
    pub(crate) detail: f64,
}

/// A quadrilateral with its size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeasuredQuad {
    pub quad: Quad,
    /// Radius of a ball about the mean of its corners that contains it (scene length).
    pub radius: f64,
}

impl MeasuredQuad {
    fn of(quad: Quad) -> Self {
        Self { quad, radius: quad.radius() }
    }
}

impl Field {
    /// The field of these values at the points of a cell, `nodes`; `scale` has one positive number per channel.
    fn new(values: SmallVec<[f64; 12]>, nodes: &[Node; POINTS], scale: &[f64]) -> Self {
        let mut field = Self { values, ..Self::default() };
        field.means = (0..scale.len()).map(|channel| field.mean(nodes, channel)).collect();
        for (channel, scale) in scale.iter().enumerate() {
            let mean = field.means[channel];
            let difference = |k: usize| (field.value(k, channel) - mean).abs();
            let spread = (0..POINTS).map(difference).fold(0.0, f64::max);
            field.brightness = field.brightness.max(mean.abs() / scale);
            field.spread = field.spread.max(spread / scale);
        }
        field
    }

    /// Value of a channel at a Gauss point.
    pub(crate) fn value(&self, point: usize, channel: usize) -> f64 {
        self.values[point * (self.values.len() / POINTS) + channel]
    }

    /// Mean of a channel over the area of a cell, by its points.
    fn mean(&self, nodes: &[Node; POINTS], channel: usize) -> f64 {
        let area: f64 = nodes.iter().map(|node| node.area).sum();
        let sum: f64 = (0..POINTS).map(|k| nodes[k].area * self.value(k, channel)).sum();
        if area > 0.0 { sum / area } else { 0.0 }
    }

    /// Whether it is constant over the cell.
    pub(crate) fn is_uniform(&self) -> bool {
        self.spread == 0.0 && self.detail == 0.0
    }
}

impl Cell {
    /// A cell without a field.
    pub(crate) fn bare(patch: Patch) -> Self {
        Self::at_level(patch, 0)
    }

    fn at_level(patch: Patch, level: u8) -> Self {
        let hull = SmallVec::from_vec(patch.hull());
        let center = hull.iter().sum::<DVec3>() / hull.len() as f64;
        let radius = hull.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max).sqrt();
        let UnitRule { nodes: places, weights } = UnitRule::of(2);
        let node = |k: usize| {
            let node = patch.node(places[k / 2], places[k % 2]);
            Node { area: node.area * weights[k / 2] * weights[k % 2], ..node }
        };
        let nodes: [Node; POINTS] = std::array::from_fn(node);
        let lanes = [0, 1, 2].map(|axis| nodes.map(|node| node.position[axis]));
        let (mut samples, mut moments, mut warp) = (Vec::new(), Moments::EXACT, 0.0);
        let mut corners = None;
        if !patch.is_flat() {
            let grid = Grid::of(&patch);
            let tangent = |node: &Node| Plane { point: node.position, normal: node.normal };
            samples.extend(nodes.iter().chain(&grid.corners()).map(tangent));
            moments = Moments::of(&nodes, &grid, center);
            let found = corners.insert(grid.corners().map(|node| node.position));
            warp = if radius > 0.0 { patch.sagitta_of(found, grid.middle()) / radius } else { 0.0 };
        }
        let corners = corners.unwrap_or_else(|| patch.corners());
        let pairs = samples
            .iter()
            .enumerate()
            .flat_map(|(k, a)| samples[..k].iter().map(move |b| a.normal.dot(b.normal)));
        let bend = pairs.fold(1.0, f64::min);
        let is_straight = patch.is_flat() || (bend > COSINE_OF_FLAT && hull[..] == corners);
        let quad = is_straight.then(|| MeasuredQuad::of(Quad::new(corners)));
        Self {
            patch,
            level,
            quarters: OnceLock::new(),
            hull,
            nodes,
            lanes,
            samples,
            field: Field::default(),
            center,
            radius,
            quad,
            is_smooth: true,
            bend,
            is_straight,
            warp,
            moments,
        }
    }

    /// The cell with `values` of a field at its points; `scale` has one positive number per channel.
    pub(crate) fn with_values(mut self, values: SmallVec<[f64; 12]>, scale: &[f64]) -> Self {
        self.field = Field::new(values, &self.nodes, scale);
        self
    }

    /// The field of an emitter of the exitance 1 that spreads its light so, in one channel of this scale, as a
    /// point sees it.
    pub(crate) fn seen(&self, radiance: &Radiance, point: DVec3, scale: f64) -> Field {
        let towards = |y: DVec3| radiance.relative((point - y).normalize_or_zero());
        let values = self.nodes.iter().map(|node| towards(node.position)).collect();
        let mut field = Field::new(values, &self.nodes, &[scale]);
        let mean = field.means[0];
        // Second differences: the rule errs by about their square where the field is smooth.
        let middle = towards(self.center);
        let bend = (middle - mean).abs();
        let least = if radiance.bends() { BENT } else { 0.0 };
        field.detail = bend * (bend / mean.max(f64::MIN_POSITIVE)).clamp(least, 1.0) / scale;
        let into: SmallVec<[DVec3; 8]> = self.hull.iter().map(|y| point - y).collect();
        let left_out = radiance.left_out(&into) / scale;
        field.detail += left_out;
        // Close to glass all four points may be seen at grazing angles, where it lets nothing through.
        let nearest = self.foot(point).map(towards);
        field.spread =
            nearest.map_or(field.spread, |nearest| field.spread.max((nearest - mean).abs() / scale));
        field.brightness = field.brightness.max(left_out).max(nearest.unwrap_or(0.0) / scale);
        let is_even = field.values.iter().chain(&nearest).all(|value| *value == middle);
        if is_even && left_out == 0.0 {
            (field.spread, field.detail) = (0.0, 0.0);
        }
        field
    }

    /// About the place of a flat cell that is nearest to `x`, a little within, where the cell is seen at a wide angle.
    pub(crate) fn foot(&self, x: DVec3) -> Option<DVec3> {
        if !self.is_flat() || x.distance_squared(self.center) >= 4.0 * self.radius * self.radius {
            return None;
        }
        let normal = self.nodes[0].normal;
        let below = x - (x - self.center).dot(normal) * normal;
        let turn = |[a, b]: [DVec3; 2]| (b - a).cross(below - a).dot(normal);
        let turns = || sides(&self.hull).map(turn);
        let on_side = |[a, b]: [DVec3; 2]| {
            let along = b - a;
            a + along * ((below - a).dot(along) / along.length_squared()).clamp(0.0, 1.0)
        };
        let nearer = |a: &DVec3, b: &DVec3| a.distance_squared(x).total_cmp(&b.distance_squared(x));
        let is_inside = turns().all(|turn| turn >= 0.0) || turns().all(|turn| turn <= 0.0);
        let foot = if is_inside { below } else { sides(&self.hull).map(on_side).min_by(nearer)? };
        let inwards = (self.center - foot).normalize_or_zero();
        Some(foot + INSIDE * foot.distance(x).min(self.radius) * inwards)
    }

    /// The cells that cover the part of a flat cell, of even exitance 1 in one channel of the scale `scale`, on
    /// the inner sides of planes through `point`.
    pub(crate) fn part(&self, point: DVec3, inward: &[DVec3], scale: &[f64]) -> SmallVec<[Self; 2]> {
        let polygon =
            inward.iter().fold(self.patch.polygon(), |part, normal| clip_polygon(&part, point, *normal));
        let patches = Patch::of_polygon(&polygon, self.nodes[0].normal);
        let cell = |patch| Self::bare(from_shortest(patch)).with_values(smallvec![1.0; POINTS], scale);
        patches.into_iter().map(cell).collect()
    }

    /// Whether a plane through `point` passes between points of its hull.
    pub(crate) fn is_crossed(&self, point: DVec3, normal: DVec3) -> bool {
        let heights = || self.hull.iter().map(|y| (*y - point).dot(normal));
        heights().any(|height| height > 0.0) && heights().any(|height| height < 0.0)
    }

    /// Area by the Gauss rule (scene length²).
    pub(crate) fn area(&self) -> f64 {
        self.nodes.iter().map(|node| node.area).sum()
    }

    /// The corners in order, without repetitions (to rounding).
    pub(crate) fn outline(&self) -> Vec<DVec3> {
        let mut corners = self.patch.corners().to_vec();
        let same = |a: &DVec3, b: &DVec3| a.distance(*b) <= COINCIDENT * self.radius;
        corners.dedup_by(|a, b| same(a, b));
        if corners.len() > 1 && same(&corners[0], &corners[corners.len() - 1]) {
            corners.pop();
        }
        corners
    }

    /// The parameters of its surface that it covers, if it is curved.
    pub(crate) fn parameters(&self) -> Rect {
        self.patch.parameters()
    }

    /// Whether the cell lies in a plane.
    pub(crate) fn is_flat(&self) -> bool {
        self.patch.is_flat()
    }

    /// Whether the cell is a flat parallelogram.
    pub(crate) fn is_parallelogram(&self) -> bool {
        self.patch.is_parallelogram()
    }

    /// Largest difference of the values of `quarters` from the bilinear function of this cell, over the
    /// channel's scale.
    pub(crate) fn misfit(&self, quarters: &[Cell; 4], scale: &[f64]) -> f64 {
        let continued = self.continued(scale.len());
        let differences = quarters.iter().zip(&continued).flat_map(|(quarter, continued)| {
            let channels = scale.iter().cycle();
            quarter
                .field
                .values
                .iter()
                .zip(continued)
                .zip(channels)
                .map(|((own, other), scale)| (own - other).abs() / scale)
        });
        differences.fold(0.0, f64::max)
    }

    /// Marks the field as one that may jump.
    pub(crate) fn mark_rough(&mut self) {
        self.is_smooth = false;
    }

    /// Adds these differences to its values, channel by channel.
    pub(super) fn shift(&mut self, differences: &[f64], scale: &[f64]) {
        let channels = scale.len();
        for (channel, (difference, scale)) in differences.iter().zip(scale).enumerate() {
            self.field.means[channel] += difference;
            (0..POINTS).for_each(|k| self.field.values[k * channels + channel] += difference);
            self.field.brightness = self.field.brightness.max(self.field.means[channel].abs() / scale);
        }
    }

    /// Stores its quarters, which carry the same field and have their own, and updates spread, detail and
    /// brightness from them: a cell whose points all miss a peak knows it so. Its values are shifted to have
    /// their mean, so that a cell that is taken undivided errs alike in both directions.
    pub(crate) fn divide(&mut self, quarters: [Cell; 4], scale: &[f64]) {
        let whole: f64 = quarters.iter().map(Cell::area).sum();
        let mut differences: SmallVec<[f64; 3]> = SmallVec::new();
        for (channel, scale) in scale.iter().enumerate() {
            let mean = self.field.mean(&self.nodes, channel);
            let parts =
                quarters.iter().map(|quarter| quarter.area() * quarter.field.means[channel]).sum::<f64>();
            let points =
                quarters.iter().flat_map(|quarter| (0..POINTS).map(|k| quarter.field.value(k, channel)));
            let spread = points.map(|value| (value - mean).abs()).fold(0.0, f64::max);
            self.field.spread = self.field.spread.max(spread / scale);
            let difference = if whole > 0.0 { parts / whole - mean } else { 0.0 };
            self.field.detail = self.field.detail.max(difference.abs() / scale);
            differences.push(difference);
        }
        self.shift(&differences, scale);
        self.quarters = OnceLock::from(Box::new(quarters));
    }

    /// The four quarters, index 2 a + b as for the points.
    pub(crate) fn quarters(&self, scale: &[f64]) -> Quarters<'_> {
        if self.level < KEPT || self.quarters.get().is_some() {
            Quarters::Kept(self.quarters.get_or_init(|| Box::new(self.interpolated(scale))))
        } else {
            Quarters::Passing(Box::new(self.interpolated(scale)))
        }
    }

    /// The directions of the two halvings. A long cell, as a curved one at a pole or a strip between two horizons, is
    /// halved twice along its length.
    pub(super) fn directions(&self) -> [Direction; 2] {
        let apart = |i: usize, j: usize| self.nodes[i].position.distance(self.nodes[j].position);
        let (along, across) = (apart(0, 2).max(apart(1, 3)), apart(0, 1).max(apart(2, 3)));
        let long = if self.is_flat() { LONG_STRIP } else { LONG_CELL };
        match (along > long * across, across > long * along) {
            (true, _) => [Direction::Along; 2],
            (_, true) => [Direction::Across; 2],
            _ => [Direction::Along, Direction::Across],
        }
    }

    /// The four quarters without a field, index 2 a + b, a for the first halving and b for the second.
    pub(crate) fn bare_quarters(&self) -> [Cell; 4] {
        let [first, second] = self.directions();
        let halves = self.patch.halves(first).map(|half| half.halves(second));
        let [[a, b], [c, d]] = halves;
        [a, b, c, d].map(|patch| Self::at_level(patch, self.level + 1))
    }

    /// The four quarters with the bilinear function of the field. Nothing shines less than 0; what may jump
    /// keeps within the range of the four values.
    fn interpolated(&self, scale: &[f64]) -> [Cell; 4] {
        let channels = scale.len();
        let range = |channel: usize| {
            let known = || (0..POINTS).map(|k| self.field.value(k, channel));
            let (low, high) = (known().fold(f64::MAX, f64::min), known().fold(f64::MIN, f64::max));
            if self.is_smooth { (low.min(0.0), f64::INFINITY) } else { (low, high) }
        };
        let ranges: SmallVec<[(f64, f64); 3]> = (0..channels).map(range).collect();
        let mut continued = self.continued(channels).into_iter();
        self.bare_quarters().map(|quarter| {
            let mut values = continued.next().expect("there are four");
            for (value, (low, high)) in values.iter_mut().zip(ranges.iter().cycle()) {
                *value = value.clamp(*low, *high);
            }
            Self { is_smooth: self.is_smooth, ..quarter.with_values(values, scale) }
        })
    }

    /// The bilinear function through the four points at the points of the four quarters.
    fn continued(&self, channels: usize) -> [SmallVec<[f64; 12]>; 4] {
        let places = &UnitRule::of(2).nodes;
        let directions = self.directions();
        // Place of the c-th point of a quarter in a direction.
        let place = |direction: Direction, [a, b]: [usize; 2], c: usize| match directions
            .map(|halved| halved == direction)
        {
            [true, true] => 0.25 * ((2 * a + b) as f64 + places[c]),
            [true, false] => 0.5 * (a as f64 + places[c]),
            [false, true] => 0.5 * (b as f64 + places[c]),
            [false, false] => places[c],
        };
        std::array::from_fn(|index| {
            let part = [index / 2, index % 2];
            let value = |index: usize| {
                let (point, channel) = (index / channels, index % channels);
                let s = place(Direction::Along, part, point / 2);
                let t = place(Direction::Across, part, point % 2);
                self.bilinear([s, t], channel)
            };
            (0..POINTS * channels).map(value).collect()
        })
    }

    /// The bilinear function of a channel through the four points at a place of the unit square.
    pub(super) fn bilinear(&self, place: [f64; 2], channel: usize) -> f64 {
        let places = &UnitRule::of(2).nodes;
        let [s, t] = place.map(|place| (place - places[0]) / (places[1] - places[0]));
        let side = |k: usize| (1.0 - t) * self.field.value(k, channel) + t * self.field.value(k + 1, channel);
        (1.0 - s) * side(0) + s * side(2)
    }

    /// The node at a place of the unit square.
    pub(super) fn node(&self, [s, t]: [f64; 2]) -> Node {
        self.patch.node(s, t)
    }
}

/// A triangle charted from its shortest side, so that a slender one is long in one direction alone; other patches as
/// they are.
fn from_shortest(patch: Patch) -> Patch {
    if !patch.is_triangle() {
        return patch;
    }
    let corners = patch.polygon();
    let length = |k: &usize| corners[*k].distance_squared(corners[(k + 1) % 3]);
    let shortest = (0..3).min_by(|j, k| length(j).total_cmp(&length(k))).unwrap_or(0);
    patch.oriented(shortest, (shortest + 1) % 3)
}

/// The quarters of a cell.
pub(crate) enum Quarters<'a> {
    /// Kept by the cell.
    Kept(&'a [Cell; 4]),
    /// Made for this call.
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
