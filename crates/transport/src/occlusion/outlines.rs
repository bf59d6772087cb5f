//! Occlusion correction by outlines: what planar blockers take away from the transfer between two elements of
//! which at least one is flat.
//!
//! ```text
//! G = G⁰ − S ,     S_kl = ∫ φ_k(x) ∫_{H(x)} φ_l(y) κ(x, y) dA_y dA_x ,
//! ```
//!
//! where G⁰ is the unobstructed block and H(x) the part of the inner element that is hidden from the outer
//! point x. H(x) consists of polygons, found by clipping ([`radiosity_kernel::irradiance::visible_polygon`]).
//! It lies behind a blocker, away from x, so that the inner integral is smooth even where the one over all y
//! is singular. Constants are integrated by Lambert's formula, higher functions by Gauss rules over the
//! polygons, halved while they are near ([`radiosity_kernel::rules::far`]).
//!
//! The outer element is the one farther from the blockers relative to its size: the shadows on the other then
//! move smoothly with x. A curved element is always the outer one; its points see the part of the flat one
//! above their tangent planes. The inner integral jumps along sides of blockers that stand on the outer
//! element: it is cut along them. It has kinks where an edge of one blocker passes a corner of another or of
//! the element: cells are halved until two levels agree.

mod edges;
mod kinks;
mod sides;

use core::f64::consts::FRAC_1_PI;
use std::borrow::Cow;

use radiosity_elements::Element;
use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{Aabb, DVec2, DVec3, clip_polygon, polygon_area};
use radiosity_kernel::blocks::block::Block;
use radiosity_kernel::contact::clip::Facet;
use radiosity_kernel::contact::gap::point_to_polygon;
use radiosity_kernel::irradiance::visible_polygon::{inside_any, irradiance, irradiance_seen};
use radiosity_kernel::moments::{Moments, Side};
use radiosity_kernel::rules::far;
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_visibility::Visibility;
use radiosity_visibility::bounding_ball::Ball;
use radiosity_visibility::shadow_volume::Corners;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use crate::tolerances::{
    AGREED_BY_LEVELS, LOOSEST_OF_OUTLINES, MOST_HALVINGS_OF_INNER, MOST_HALVINGS_OF_OUTER,
};
use edges::Edges;
use sides::Sides;

/// Ratio of sides above which a cell is halved across the longer one only. At 1.5 its halves are as slender
/// the other way as a cell of 1.33; with a larger value slender cells are quartered, and their quarters are
/// as slender.
const SLENDER: f64 = 1.5;
/// Most cells of one patch of the outer element; what is left then counts as error. The worst patches of the
/// built-in scenes, and of the rooms with slits in `tests/stress`, take a tenth of it.
const MOST_CELLS: u64 = 1 << 16;

/// Number of outer patches from which they are summed in parallel: fewer are done before threads share them.
const MANY: usize = 8;

/// Width over length below which a hidden polygon is a rounding error: collinear edges of shadows leave such
/// slivers.
const SLIVER: f64 = 1e-13;

/// Differences of two levels below this part of the entry are rounding.
const ROUNDING: f64 = 1e-15;

/// Halvings before a cell counts as wholly visible or wholly hidden because all its points are: few points
/// may miss the edge of a shadow. Two make it a quarter as long; more take four times the cells each.
const SURE: usize = 2;

/// Safety factor on a cell's maximal contribution, which is estimated from its corners and middle: the kernel
/// varies little between them in cells that its rules may be used on.
const CARRIED: f64 = 1.2;

/// The accuracy asked of an occlusion correction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limit {
    /// Largest error of an entry.
    pub error: f64,
    /// About the largest entry of the unobstructed block.
    pub entry: f64,
}

/// An occlusion correction.
#[derive(Debug)]
pub(crate) struct Occlusion {
    /// S_kl, row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Whether anything is hidden.
    pub hides: bool,
    /// Whether everything is hidden from every point of the rule.
    pub dark: bool,
    /// Estimate of the largest error from cells left at the smallest size.
    pub error: f64,
    /// Terms of the rules.
    pub samples: u64,
}

impl Occlusion {
    /// The correction for `blockers`, all of them planar, between two elements of which at least one is flat.
    pub(crate) fn of(pair: [&Element; 2], blockers: &[usize], visibility: &Visibility, limit: Limit) -> Self {
        let blockers = visibility.by_place(blockers);
        let accuracy = limit.error / limit.entry;
        let Sides { side, outer, inner } = Sides::of(pair, &blockers, visibility, accuracy);
        let bodies = visibility.one_of_each_body(&blockers);
        let correction = Correction::new(pair, side, &inner, &bodies, visibility, limit);
        let area = |patch: &Patch| patch.node(0.5, 0.5).area;
        let whole: f64 = outer.iter().map(area).sum();
        let add = |sums: &mut CorrectionSums, patch: &Patch| {
            sums.left = MOST_CELLS;
            sums.visit(
                patch,
                &bodies,
                None,
                limit.error * (area(patch) / whole).sqrt(),
                MOST_HALVINGS_OF_OUTER,
            );
        };
        let mut sums = CorrectionSums::new(&correction);
        if outer.len() < MANY {
            outer.iter().for_each(|patch| add(&mut sums, patch));
            return sums.finish();
        }
        // Partial sums are added in the order of the patches: the same result on any number of threads.
        let sum_of = |patch: &Patch| {
            let mut part = CorrectionSums::new(&correction);
            add(&mut part, patch);
            part
        };
        let parts: Vec<CorrectionSums> = outer.par_iter().map(sum_of).collect();
        parts.iter().for_each(|part| sums.merge(part));
        sums.finish()
    }
}

/// The block between two elements with planar `blockers`, its correction accurate to `limit`. `unshaded`
/// makes the unobstructed block.
pub(crate) fn occluded_block(
    pair: [&Element; 2],
    blockers: &[usize],
    visibility: &Visibility,
    limit: Limit,
    unshaded: impl FnOnce() -> Block,
) -> Block {
    let occlusion = Occlusion::of(pair, blockers, visibility, limit);
    if occlusion.dark {
        let mut block = Block::hidden(occlusion.values.len(), 0);
        block.report.samples = occlusion.samples;
        return block;
    }
    let mut block = unshaded();
    block.values.iter_mut().zip(&occlusion.values).for_each(|(value, hidden)| *value -= hidden);
    if let [factor] = &mut block.values[..] {
        *factor = factor.max(0.0);
    }
    block.report.partly_hidden = occlusion.hides;
    block.report.error += occlusion.error;
    block.report.samples += occlusion.samples;
    block.report.distinct += occlusion.samples;
    block
}

/// The correction from one cell of the outer element.
struct CellSum {
    values: Vec<f64>,
    /// Points of the rule along and across the cell.
    points: [usize; 2],
    /// Part of the inner element that is hidden from all points of the rule together.
    shadow: HiddenShare,
}

/// Part of the inner element that is hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum HiddenShare {
    Nothing,
    Part,
    Everything,
}

impl HiddenShare {
    fn and(self, other: Self) -> Self {
        if self == other { self } else { Self::Part }
    }
}

/// The constants of one correction.
struct Correction<'a> {
    pair: [&'a Element; 2],
    visibility: &'a Visibility,
    edges: Edges,
    side: Side,
    outer: &'a Element,
    inner: &'a Element,
    /// The parts of the inner element that face the outer one.
    polygons: Vec<Vec<DVec3>>,
    /// A ball around each part, and one around all.
    balls: Vec<Ball>,
    ball: Ball,
    normal: DVec3,
    /// About the largest φ_k φ_l, per unit of the raw functions.
    unit: f64,
    /// The constant raw function of the inner element, and the entry of G per unit of ∫∫κ.
    constant: f64,
    constants: f64,
    points: usize,
    /// Relative accuracy of the inner integrals: 0.3 of the block's, most of which is left to the outer ones.
    accuracy: f64,
    limit: Limit,
}

impl<'a> Correction<'a> {
    fn new(
        pair: [&'a Element; 2],
        side: Side,
        inner: &[Facet],
        blockers: &[usize],
        visibility: &'a Visibility,
        limit: Limit,
    ) -> Self {
        let [outer, other] = match side {
            Side::Receiver => pair,
            Side::Emitter => [pair[1], pair[0]],
        };
        let corners: Vec<DVec3> = inner.iter().flat_map(|facet| facet.corners.iter().copied()).collect();
        let normal = other.plane.map_or(DVec3::ZERO, |plane| plane.normal);
        let unit = pair.iter().map(|element| element.basis.transform()[0]).product();
        let accuracy = (0.3 * limit.error / limit.entry).clamp(1e-14, LOOSEST_OF_OUTLINES);
        Self {
            pair,
            visibility,
            edges: Edges::new(blockers, visibility, &corners, normal),
            side,
            outer,
            inner: other,
            balls: inner.iter().map(|facet| Ball::around(&facet.corners)).collect(),
            ball: Ball::around(&corners),
            polygons: inner.iter().map(|facet| facet.corners.clone()).collect(),
            normal,
            unit,
            constant: other.basis.constant(),
            constants: unit * outer.basis.constant() * other.basis.constant(),
            points: points(outer.basis.total_degree(), accuracy),
            accuracy,
            limit,
        }
    }
}

/// The running sums of one correction.
struct CorrectionSums<'a> {
    correction: &'a Correction<'a>,
    moments: Moments<'a>,
    /// Raw functions of the inner element at one point.
    row: Vec<f64>,
    hides: bool,
    dark: bool,
    error: f64,
    samples: u64,
    /// Cells that may still be halved.
    left: u64,
}

impl<'a> CorrectionSums<'a> {
    fn new(correction: &'a Correction<'a>) -> Self {
        Self {
            correction,
            moments: Moments::new(&correction.pair[0].basis, &correction.pair[1].basis),
            row: vec![0.0; correction.inner.basis.len()],
            hides: false,
            dark: true,
            error: 0.0,
            samples: 0,
            left: 0,
        }
    }

    fn merge(&mut self, other: &Self) {
        self.moments.add_raw(other.moments.values(), 0);
        self.hides |= other.hides;
        self.dark &= other.dark;
        self.error += other.error;
        self.samples += other.samples;
    }

    fn finish(self) -> Occlusion {
        let Self { hides, dark, error, samples, moments, .. } = self;
        Occlusion { values: moments.into_block(), hides, dark: dark && hides, error, samples }
    }

    /// Adds a cell of the outer element with an error up to `limit`. `coarse` are its moments by one rule, if
    /// known.
    fn visit(&mut self, cell: &Patch, blockers: &[usize], coarse: Option<CellSum>, limit: f64, depth: usize) {
        check_interrupt();
        let blockers =
            self.correction.visibility.narrow_bodies(blockers, &cell.hull(), self.correction.edges.inner());
        if blockers.is_empty() {
            self.dark = false;
            return;
        }
        let coarse = coarse.unwrap_or_else(|| self.sum(cell, &blockers, [self.correction.points; 2]));
        let cut = CellCut::of(cell);
        let parts = cut.parts(cell);
        let points = cut.points(self.correction.points, coarse.points);
        let sums: Vec<CellSum> = parts.iter().map(|part| self.sum(part, &blockers, points)).collect();
        let fine = |k: usize| sums.iter().map(|sum| sum.values[k]).sum::<f64>();
        let differences = coarse.values.iter().enumerate().map(|(k, value)| (value - fine(k)).abs());
        let difference = differences.fold(0.0, f64::max) * self.correction.unit;
        // The first two levels, of few points, may agree by chance: they have to agree better.
        let agreed = if depth == MOST_HALVINGS_OF_OUTER { limit } else { AGREED_BY_LEVELS * limit };
        let agreed = agreed.max(ROUNDING * self.correction.limit.entry);
        let shadow = sums.iter().map(|sum| sum.shadow).fold(coarse.shadow, HiddenShare::and);
        let is_sure = shadow == HiddenShare::Part || depth + SURE <= MOST_HALVINGS_OF_OUTER;
        let is_told = difference <= agreed && is_sure;
        self.left = self.left.saturating_sub(parts.len() as u64);
        let is_last = depth == 0 || self.left == 0;
        if is_last && difference > agreed {
            self.error += difference;
        }
        let may_miss = is_told && !is_last && self.may_miss(cell, &blockers);
        let entries = self.correction.outer.basis.len() * self.correction.inner.basis.len();
        let share = limit / (parts.len() as f64).sqrt();
        for (index, (part, sum)) in parts.iter().zip(sums).enumerate() {
            let is_done = is_last || is_told && !(may_miss && self.may_miss(part, &blockers));
            if is_done {
                self.moments.add_raw(&sum.values[..entries], 0);
            } else {
                // No part takes the cells that later ones may need.
                let cells_left = self.left;
                self.left = cells_left.div_ceil((parts.len() - index) as u64);
                let own = self.left;
                self.visit(part, &blockers, Some(sum), share, depth - 1);
                self.left += cells_left - own;
            }
        }
    }

    /// Whether the rule on a cell may have missed shadows that matter.
    fn may_miss(&self, cell: &Patch, blockers: &[usize]) -> bool {
        CARRIED * self.most(cell) > self.correction.limit.error
            && self.correction.edges.may_be_passed_over(
                cell,
                blockers,
                self.correction.points as f64,
                self.correction.accuracy,
            )
    }

    /// Maximal contribution of a cell to an entry, estimated from the unobstructed irradiance at its corners
    /// and middle.
    fn most(&self, cell: &Patch) -> f64 {
        let nodes =
            [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[s, t]| cell.node(s, t));
        let seen = |x: &Node| -> f64 {
            self.correction.polygons.iter().map(|polygon| irradiance(x.position, x.normal, polygon)).sum()
        };
        nodes.iter().map(seen).fold(0.0, f64::max) * nodes[0].area * self.correction.constants
    }

    /// Moments of what is hidden from a cell, receiver's raw functions by emitter's. If the outer element has
    /// constants only, the moments with its two coordinates follow: one number may agree on two levels by
    /// chance, three hardly do.
    fn sum(&mut self, cell: &Patch, blockers: &[usize], points: [usize; 2]) -> CellSum {
        let (own, other) = (self.correction.outer.basis.len(), self.correction.inner.basis.len());
        let witnesses = if own == 1 { 2 * other } else { 0 };
        let (mut sum, mut shadow) = (vec![0.0; own * other + witnesses], None);
        let (mut left, mut right) = (vec![0.0; own], vec![0.0; other]);
        let [along, across] = points.map(UnitRule::of);
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            check_interrupt();
            let x = cell.node(s, t);
            right.fill(0.0);
            let found = self.hidden(&x, blockers, &mut right);
            shadow = Some(shadow.map_or(found, |other| found.and(other)));
            if found == HiddenShare::Nothing {
                continue;
            }
            let coordinates = self.correction.outer.basis.frame().coordinates(&x);
            self.correction.outer.basis.raw(coordinates, &mut left);
            let weight = ws * wt * x.area;
            let (rows, columns) = match self.correction.side {
                Side::Receiver => (&left, &right),
                Side::Emitter => (&right, &left),
            };
            let (moments, witnesses) = sum.split_at_mut(own * other);
            for (row, l) in moments.chunks_exact_mut(columns.len()).zip(rows) {
                row.iter_mut().zip(columns).for_each(|(value, r)| *value += weight * l * r);
            }
            for (row, place) in witnesses.chunks_exact_mut(other).zip(coordinates) {
                row.iter_mut().zip(&right).for_each(|(value, r)| *value += weight * left[0] * place * r);
            }
        }
        CellSum { values: sum, points, shadow: shadow.unwrap_or(HiddenShare::Nothing) }
    }

    /// Adds ∫ κ(x, y) R_l(y) dA_y over what is hidden from x to `out`; returns how much is hidden.
    fn hidden(&mut self, x: &Node, blockers: &[usize], out: &mut [f64]) -> HiddenShare {
        let volumes = self.correction.visibility.volumes(blockers, x.position, &self.correction.ball);
        let (mut any, mut everything) = (false, true);
        for index in 0..self.correction.polygons.len() {
            let Some(polygon) = self.seen_from(x, index) else { continue };
            let (hidden, all) = inside_any(&polygon, &self.correction.balls[index], &volumes);
            everything &= all;
            any |= !hidden.is_empty();
            hidden.into_iter().for_each(|seen| self.gather(x, seen, out));
        }
        self.dark &= everything;
        self.hides |= any;
        match (any, everything) {
            (false, _) => HiddenShare::Nothing,
            (true, true) => HiddenShare::Everything,
            (true, false) => HiddenShare::Part,
        }
    }

    /// The part of a polygon of the inner element that a point sees without blockers.
    fn seen_from(&self, x: &Node, index: usize) -> Option<Cow<'_, [DVec3]>> {
        let polygon = &self.correction.polygons[index];
        if self.correction.outer.plane.is_some() {
            return Some(Cow::Borrowed(polygon));
        }
        let is_before = (x.position - polygon[0]).dot(self.correction.normal) > 0.0;
        let above = clip_polygon(polygon, x.position, x.normal);
        (is_before && above.len() > 2).then_some(Cow::Owned(above))
    }

    /// Adds the integral over a hidden polygon, given by its corners relative to x.
    fn gather(&mut self, x: &Node, seen: Corners, out: &mut [f64]) {
        if out.len() == 1 {
            self.samples += seen.len() as u64;
            out[0] += self.correction.constant * irradiance_seen(x.normal, seen);
            return;
        }
        let polygon: Corners = seen.iter().map(|a| a + x.position).collect();
        for patch in Patch::of_polygon(&polygon, self.correction.normal) {
            let corners = patch.polygon();
            let length = Aabb::around(corners.iter().copied()).diagonal();
            if polygon_area(&corners) > SLIVER * length * length {
                self.gauss(x, &patch, out, MOST_HALVINGS_OF_INNER);
            }
        }
    }

    fn gauss(&mut self, x: &Node, patch: &Patch, out: &mut [f64], depth: usize) {
        let [along, across] = patch.extents();
        let [a, b, c, d] = patch.corners();
        let gap = point_to_polygon(x.position, &[a, b, c, d][..if patch.is_triangle() { 3 } else { 4 }]);
        if gap < SMALLEST_RATIO * along.max(across) && depth > 0 {
            let direction = if along >= across { Direction::Along } else { Direction::Across };
            return patch.halves(direction).iter().for_each(|half| self.gauss(x, half, out, depth - 1));
        }
        let basis = &self.correction.inner.basis;
        let degree = basis.total_degree() + usize::from(!patch.is_parallelogram());
        let rule = |extent: f64| {
            let ratio = (gap / extent).max(SMALLEST_RATIO);
            let rho = 2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt();
            UnitRule::of(far::points(degree, self.correction.accuracy, rho))
        };
        let (first, second) = (rule(along), rule(across));
        let area = [(b - a).cross(d - a), (b - a).cross(c - b), (c - d).cross(d - a)].map(|n| n.length());
        let height = (x.position - a).dot(self.correction.normal) * FRAC_1_PI;
        for (s, ws) in first.iter() {
            let (start, across) = (a + (b - a) * s, (d - a) * (1.0 - s) + (c - b) * s);
            for (t, wt) in second.iter() {
                let y = start + across * t;
                let offset = y - x.position;
                let square = offset.length_squared();
                // The area element is linear in s and t.
                let stretch = area[0] + (area[1] - area[0]) * s + (area[2] - area[0]) * t;
                let weight = ws * wt * stretch * height * offset.dot(x.normal) / (square * square);
                basis.raw(basis.frame().locate(y, DVec2::ZERO), &mut self.row);
                out.iter_mut().zip(&self.row).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        self.samples += (first.nodes.len() * second.nodes.len()) as u64;
    }
}

/// Points per direction of the outer rule, for functions of this degree times the inner integral, which is
/// smooth except for kinks: one point more per three digits, an estimate. Halving takes up what it misses.
fn points(degree: usize, accuracy: f64) -> usize {
    (0.5 * degree as f64 + 1.5 - accuracy.log10() / 3.0) as usize
}

/// Ways to cut a cell: into quarters, or across the longer side of a slender one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CellCut {
    Halves(Direction),
    Quarters,
}

impl CellCut {
    fn of(cell: &Patch) -> Self {
        let [along, across] = cell.extents();
        if along > SLENDER * across {
            Self::Halves(Direction::Along)
        } else if across > SLENDER * along {
            Self::Halves(Direction::Across)
        } else {
            Self::Quarters
        }
    }

    fn parts(self, cell: &Patch) -> Vec<Patch> {
        match self {
            Self::Halves(direction) => cell.halves(direction).to_vec(),
            Self::Quarters => {
                let halves = cell.halves(Direction::Along);
                halves.iter().flat_map(|half| half.halves(Direction::Across)).collect()
            }
        }
    }

    /// Points of the rule on the parts, of `usual` points per direction, along and across, after a rule of
    /// `coarse` points on the whole. Halves lie beside the same points as the whole in the direction that is
    /// not cut: another number of points there tells whether these suffice.
    fn points(self, usual: usize, coarse: [usize; 2]) -> [usize; 2] {
        let other = |points: usize| if points == usual { usual + 1 } else { usual };
        match self {
            Self::Halves(Direction::Along) => [usual, other(coarse[1])],
            Self::Halves(Direction::Across) => [other(coarse[0]), usual],
            Self::Quarters => [usual; 2],
        }
    }
}
