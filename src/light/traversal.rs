//! The walk from a point over the cells of elements.

mod cell_rule;

use std::f64::consts::PI;

use radiosity_geom::DVec3;
use smallvec::SmallVec;

use crate::light::area_light::{AreaLight, irradiance};
use crate::light::blockers::Before;
use crate::light::blockers::Shadows;
use crate::light::hierarchy::cell::{Cell, POINTS};
use crate::light::hierarchy::tree::Tree;
use crate::light::lines::hidden_spans::HiddenSpans;
use crate::light::lines::line_quadrature::LineQuadrature;
use crate::light::occluders::Occluders;
use crate::light::receiver_point::ReceiverPoint;
use crate::visibility::Visibility;

/// Most quarterings of a cell, of a curved one, whose quarters at a pole stay as near as it was, and of one of the surface
/// that the point lies on.
const DEPTH: usize = 24;
const CURVED_DEPTH: usize = 12;
const OWN_DEPTH: usize = 8;

/// Most cells that one sum may look at: beyond them every cell is taken as it is, and may err by all that it contributes.
const MOST_CELLS: usize = 20_000;

/// How close a point and its normal must come to those of a ball, in parts of its radius.
const ON_DOME: f64 = 1e-9;

/// Part of what might arrive below which a sum is taken again, and below which nothing is told apart from darkness.
const DARK: f64 = 0.4;
const LEAST: f64 = 0.05;

/// Distance in multiples of the radius from which on a lamp is taken as a whole.
const CLOSE: f64 = 2.0;

/// What a vantage point sees of elements.
pub(crate) struct Traversal<'a> {
    vantage: &'a ReceiverPoint,
    visibility: &'a Visibility,
    surroundings: &'a Occluders,
    shadows: Shadows<'a>,
    /// Largest error of a cell so far, in multiples of the scales.
    coarsest: f64,
    /// Cells looked at in this sum.
    visited: usize,
}

/// The walk over one element.
struct Pass<'a> {
    tree: &'a Tree,
    /// Error allowed a cell, in multiples of the channels' scales.
    tolerance: f64,
    deepest: usize,
    /// Whether the point lies on the element's surface.
    own: bool,
    /// The kernel, where the surface is a ball around the point: 1/(4πR²) everywhere.
    dome: Option<f64>,
    out: &'a mut [f64],
}

impl<'a> Traversal<'a> {
    /// From a receiver point `vantage` of the site that the occluders `surroundings` belong to.
    pub(crate) fn new(
        vantage: &'a ReceiverPoint,
        visibility: &'a Visibility,
        surroundings: &'a Occluders,
    ) -> Self {
        Self {
            vantage,
            visibility,
            surroundings,
            shadows: Shadows::new(vantage, visibility, surroundings),
            coarsest: 0.0,
            visited: 0,
        }
    }

    /// Whether all obstacles are flat, so that flat cells that shine evenly are exact.
    pub(crate) fn is_flat(&self) -> bool {
        self.shadows.all_flat()
    }

    /// The irradiance from each of `trees`, those of the surroundings, channel after channel, as `add` adds that from one with a
    /// given tolerance: `share` of the irradiance from all, about which `other` comes on top, in multiples of the scales.
    /// `level` tells the irradiance in the same multiples.
    ///
    /// The irradiance is not known beforehand. Where it turns out to be much less than it might have been, trees are walked
    /// again, finer, of which cells were taken too coarsely for that.
    pub(crate) fn within_share(
        &mut self,
        trees: &[Tree],
        share: f64,
        other: f64,
        add: impl Fn(&mut Self, usize, f64, &mut [f64]),
        level: impl Fn(&[f64]) -> f64,
    ) -> Vec<f64> {
        let bound: f64 = trees.iter().enumerate().map(|(index, tree)| self.bound(index, tree)).sum();
        let channels = trees.first().map_or(1, |tree| tree.scale().len());
        let mut parts = vec![0.0; trees.len() * channels];
        let mut coarsest: SmallVec<[f64; 64]> = SmallVec::new();
        for (index, part) in parts.chunks_exact_mut(channels).enumerate() {
            self.coarsest = 0.0;
            add(self, index, share * (other + bound), part);
            coarsest.push(self.coarsest);
        }
        let level = (other + level(&parts)).max(LEAST * bound);
        if level < DARK * (other + bound) {
            self.visited = 0;
            for (index, part) in parts.chunks_exact_mut(channels).enumerate() {
                if coarsest[index] > share * level {
                    part.fill(0.0);
                    add(self, index, share * level, part);
                }
            }
        }
        parts
    }

    /// About the most that can arrive from element `index`, in multiples of the scales.
    fn bound(&self, index: usize, tree: &Tree) -> f64 {
        if self.is_out_of_sight(index, tree) {
            return 0.0;
        }
        let bound = |cell: &Cell| {
            let is_far = 2.0 * cell.radius < self.distance(cell);
            let is_told = is_far || self.is_like_flat(cell);
            let factor = if is_told { self.weights(cell).iter().sum::<f64>().min(1.0) } else { 1.0 };
            cell.brightness * factor
        };
        tree.roots().iter().map(bound).sum()
    }

    /// Adds the irradiance from element `index`, channel after channel, to `out`; each cell is allowed the error
    /// `tolerance` times the scale of the channel.
    pub(crate) fn add(&mut self, index: usize, tree: &Tree, tolerance: f64, out: &mut [f64]) {
        let Some(places) = self.surroundings.before(index) else { return };
        if self.is_out_of_sight(index, tree) {
            return;
        }
        let before = self.shadows.ask(places, &tree.bounds);
        let own = self.vantage.surface == Some(tree.surface);
        let deepest = match (own, tree.plane) {
            (true, _) => OWN_DEPTH,
            (false, None) => CURVED_DEPTH,
            (false, Some(_)) => DEPTH,
        };
        let dome = if own { self.dome(tree.surface) } else { None };
        let mut pass = Pass { tree, tolerance, deepest, own, dome, out };
        for root in tree.roots() {
            self.visit(&mut pass, root, before, 0);
        }
    }

    /// Irradiance from all of element `index`, a lamp of exitance 1, good to `tolerance` over its brightness `brightness`; None
    /// where it is too near to be taken as a whole.
    pub(crate) fn lamp(
        &mut self,
        index: usize,
        lamp: &AreaLight,
        brightness: f64,
        tolerance: f64,
    ) -> Option<f64> {
        let Some(places) = self.surroundings.before(index) else { return Some(0.0) };
        let (eye, normal) = (self.vantage.position, self.vantage.normal);
        if lamp.center.distance(eye) < CLOSE * lamp.radius {
            return None;
        }
        let sides = lamp.outline(eye);
        let corners: Vec<DVec3> = sides.iter().map(|side| side[0]).collect();
        if corners.is_empty() || self.vantage.is_above(&corners) {
            return Some(0.0);
        }
        let is_whole = self.vantage.overlooks(&corners);
        let whole = if is_whole { irradiance(eye, normal, &sides) } else { lamp.most_from(eye) };
        let error = tolerance / (brightness * whole);
        if error >= 1.0 {
            self.coarsest = self.coarsest.max(brightness * whole);
            return Some(if self.shadows.hide_lamp(lamp, places) { 0.0 } else { whole });
        }
        let (screen, lit) = lamp.screen(eye, &sides)?;
        let Some((flat, curved)) = self.shadows.before_lamp(lamp, &screen, places) else { return Some(0.0) };
        let mut facets = HiddenSpans::before_lamp(screen, lit);
        flat.iter().for_each(|pyramid| facets.add_flat(pyramid));
        curved.iter().for_each(|surface| self.shadows.add_curved(&mut facets, *surface, false));
        if facets.is_empty() && is_whole {
            return Some(whole);
        }
        self.coarsest = self.coarsest.max(tolerance);
        let [seen, all] = LineQuadrature::of_lamp(self.vantage, &facets).irradiances(error);
        Some(if is_whole && all > 0.0 { whole * seen / all } else { seen })
    }

    fn is_out_of_sight(&self, index: usize, tree: &Tree) -> bool {
        let behind = |(point, normal): (DVec3, DVec3)| (self.vantage.position - point).dot(normal) <= 0.0;
        self.surroundings.before(index).is_none() || tree.plane.is_some_and(behind)
    }

    fn visit(&mut self, pass: &mut Pass, cell: &Cell, above: Before, depth: usize) {
        if !self.vantage.clears(cell.center, cell.radius) && self.vantage.is_above(&cell.hull) {
            return;
        }
        let Some(before) = self.shadows.narrow(above, cell) else { return };
        let estimate = self.estimate(pass, cell, before);
        self.visited += 1;
        if estimate.error <= pass.tolerance || depth == pass.deepest || self.visited > MOST_CELLS {
            // Lines are only as good as the tolerance.
            let by_points = before.is_nothing() || (cell.is_flat() && self.shadows.are_flat(before));
            let error = if by_points { estimate.error.min(pass.tolerance) } else { pass.tolerance };
            self.coarsest = self.coarsest.max(error);
            let weights = match estimate.error.is_finite() {
                true => estimate.weights,
                false => self.seen(pass, cell, estimate.weights, before),
            };
            pass.take(cell, &weights);
            return;
        }
        for quarter in cell.quarters(pass.tree.scale()).iter() {
            self.visit(pass, quarter, before, depth + 1);
        }
    }

    /// The kernel between any two points of the inside of a ball, of which `surface` is the whole, if the point is one.
    fn dome(&self, surface: usize) -> Option<f64> {
        let (center, radius) = self.visibility.whole_dome(surface)?;
        let ReceiverPoint { position, normal, ground, .. } = *self.vantage;
        let is_inward = (center - position).distance(radius * normal) <= ON_DOME * radius;
        (ground.is_none() && is_inward).then_some(1.0 / (4.0 * PI * radius * radius))
    }
}

impl Pass<'_> {
    fn take(&mut self, cell: &Cell, weights: &[f64; POINTS]) {
        for (channel, out) in self.out.iter_mut().enumerate() {
            *out += (0..POINTS).map(|k| weights[k] * cell.value(k, channel)).sum::<f64>();
        }
    }
}
