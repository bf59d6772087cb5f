//! The outer rule of a near pair: cells of the receiver, planned before integration.
//!
//! In each direction of a cell the nearest singularities ([`emitter`](crate::rules::near::emitter)) choose
//! the sinh map; where convergence stays slow the cell is cut. Before that the receiver is cut along the
//! projections of near edges, so that the layers of width ≈ gap along these lie at sides of cells.

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Direction, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{DVec3, clip_polygon};
use radiosity_work::interruption::check_interrupt;
use smallvec::SmallVec;

use crate::contact::gap::gap;
use crate::irradiance::lambert;
use crate::rules::far;
use crate::rules::far::SMALLEST_RATIO;
use crate::rules::near::emitter::Emitter;
use crate::rules::near::line::{LineRule, Request, StretchedRule};
use crate::rules::near::polar::{Edge, edges, fraction};
use crate::tolerances::{MOST_CUTS_OF_CELL, MOST_HALVINGS_OF_SPLIT};

/// Distance, relative to the pair's size, below which nothing is resolved: 500 rounding errors; for touching
/// patches it changes the result by as little.
const SHARPEST: f64 = 1e-13;
/// Smallest transfer that the accuracy is relative to: ε is made finer by √1000 = 32 at the most. What
/// carries less counts little, and would take more points than pairs that carry much.
const LEAST_TRANSFER: f64 = 1e-3;
/// Height of an edge over the receiver, relative to the receiver's size, up to which the receiver is cut
/// along its projection. An arbitrary choice: layers along higher edges are broad enough for the maps, and
/// each cut makes two cells of one.
const HOT: f64 = 0.1;
/// Cost of a sample of the polar rule, in samples of a tensor rule: an estimate of its time, which decides
/// between two rules that are both right.
const POLAR_COST: f64 = 5.0;
/// Cells after which a plan is given up: a bound of the time of planning. Other rules are left for such
/// pairs.
const MOST_CELLS: usize = 2000;

/// A cell with the rule chosen for it.
#[derive(Debug)]
pub(super) struct Leaf {
    pub cell: Patch,
    pub emitter: Patch,
    pub rule: Rule,
}

/// A rule for a cell with its cost.
#[derive(Clone, Copy, Debug)]
struct PricedRule {
    rule: Rule,
    /// In samples of a tensor rule.
    cost: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// Rules along and across, each point with a polar integral over the emitter.
    Polar([StretchedRule; 2]),
    /// Far enough apart: a tensor rule, points of the cell, then of the emitter.
    Tensor([usize; 4]),
}

/// The plan of one pair, while it is made.
pub(super) struct Planner<'a> {
    outer: &'a AreaBasis,
    inner: &'a AreaBasis,
    /// Accuracy of the inner integral; after [`Planner::pair`] relative to an irradiance of 1.
    pub eps: f64,
    /// Distances of singularities below this length count as this length.
    floor: f64,
    /// Cost beyond which the plan is given up.
    limit: f64,
    /// Cells that may still be made.
    cells: usize,
    pub leaves: Vec<Leaf>,
    /// Cost, in samples of a tensor rule.
    pub cost: f64,
}

impl<'a> Planner<'a> {
    pub(super) fn new(outer: &'a AreaBasis, inner: &'a AreaBasis, eps: f64, limit: f64) -> Self {
        Self { outer, inner, eps, floor: 0.0, limit, cells: MOST_CELLS, leaves: Vec::new(), cost: 0.0 }
    }

    pub(super) fn pair(&mut self, outer: &Patch, inner: &Patch) {
        self.floor = SHARPEST * outer.longest().1.max(inner.longest().1);
        let edges = edges(inner);
        let parts = cut_along(outer, &edges);
        // The inner integral's error counts relative to its mean, the transfer; where that is small the inner
        // integral is small on part of the receiver. √ of the transfer was enough in all cases measured.
        let transfer = mean_irradiance(&parts, &inner.polygon());
        self.eps *= transfer.clamp(LEAST_TRANSFER, 1.0).sqrt();
        let emitter = Emitter::new(inner, self.inner, self.eps);
        parts.iter().for_each(|part| self.cell(part, &emitter, 0));
    }

    fn cell(&mut self, cell: &Patch, emitter: &Emitter, depth: usize) {
        check_interrupt();
        if self.cells == 0 || self.cost >= self.limit {
            self.cost = f64::INFINITY;
            return;
        }
        self.cells -= 1;
        let tensor = self.tensor(cell, emitter);
        let reached = emitter.reached(cell, self.eps);
        if tensor.is_none() && !reached {
            let ((direction, extent), (inner, reach)) = (cell.longest(), emitter.patch.longest());
            if extent >= reach {
                cell.halves(direction).iter().for_each(|half| self.cell(half, emitter, depth + 1));
            } else {
                for half in emitter.patch.halves(inner) {
                    self.cell(cell, &Emitter::new(&half, self.inner, self.eps), depth + 1);
                }
            }
            return;
        }
        if let (Some(tensor), false) = (tensor, reached) {
            return self.leaf(cell, emitter, tensor);
        }
        let request = Request {
            fraction: fraction(cell, self.outer),
            degree: self.outer.order() + usize::from(!cell.is_parallelogram()),
            eps: self.eps,
        };
        let rules = emitter.places(cell, self.floor, self.eps).map(|roots| LineRule::of(&roots, &request));
        let worst = usize::from(rules[1].gain() > rules[0].gain());
        if let Some(at) = rules[worst].cut
            && depth < MOST_CUTS_OF_CELL
        {
            let direction = [Direction::Along, Direction::Across][worst];
            cell.cut(direction, at.place).iter().for_each(|part| self.cell(part, emitter, depth + 1));
            return;
        }
        let polar = self.polar(cell, emitter, rules.map(|line| line.rule));
        match tensor {
            Some(tensor) if tensor.cost < polar.cost => self.leaf(cell, emitter, tensor),
            _ => self.leaf(cell, emitter, polar),
        }
    }

    fn leaf(&mut self, cell: &Patch, emitter: &Emitter, priced: PricedRule) {
        self.cost += priced.cost;
        self.leaves.push(Leaf { cell: cell.clone(), emitter: emitter.patch.clone(), rule: priced.rule });
    }

    fn polar(&self, cell: &Patch, emitter: &Emitter, rules: [StretchedRule; 2]) -> PricedRule {
        let places = [(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.1, 0.9), (0.5, 0.5)];
        let inner: usize =
            places.iter().map(|(s, t)| emitter.polar.count(&cell.node(*s, *t), self.eps)).sum();
        let count = (rules[0].points * rules[1].points * inner) as f64 / places.len() as f64;
        PricedRule { rule: Rule::Polar(rules), cost: POLAR_COST * count }
    }

    fn tensor(&self, cell: &Patch, emitter: &Emitter) -> Option<PricedRule> {
        let longest = [cell.extents(), emitter.patch.extents()].concat().into_iter().fold(0.0, f64::max);
        let gap = gap(cell, &emitter.patch);
        if gap < SMALLEST_RATIO * longest {
            return None;
        }
        let degrees = [self.outer.order(), self.inner.order()];
        let counts = far::counts(cell, &emitter.patch, degrees, gap, self.eps);
        let cost = counts.iter().map(|n| *n as f64).product();
        Some(PricedRule { rule: Rule::Tensor(counts), cost })
    }
}

/// Mean irradiance over coplanar parts from an emitter of radiosity 1 with these corners, to some ten percent
/// (3 × 3 points on each part).
fn mean_irradiance(parts: &[Patch], emitter: &[DVec3]) -> f64 {
    let rule = UnitRule::of(3);
    let (mut sum, mut area) = (0.0, 0.0);
    for part in parts {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = part.node(s, t);
            let seen: SmallVec<[DVec3; 4]> = emitter.iter().map(|corner| corner - node.position).collect();
            sum += ws * wt * node.area * lambert::polygon(node.normal, &seen);
            area += ws * wt * node.area;
        }
    }
    sum / area
}

/// The parts of a flat patch, cut along the projections of near `edges`.
fn cut_along(patch: &Patch, edges: &[Edge]) -> Vec<Patch> {
    let normal = patch.node(0.5, 0.5).normal;
    let extents = patch.extents();
    let size = extents[0].max(extents[1]);
    let mut parts = vec![patch.polygon()];
    for edge in edges {
        let steepness = edge.along.dot(normal);
        let side = edge.along.cross(normal);
        // An edge steeper than 30° is near in one point only: a cut along it would part what is smooth.
        if steepness.abs() > 0.5 {
            continue;
        }
        parts = parts.into_iter().flat_map(|part| halves(part, edge, side, normal, size)).collect();
    }
    if parts.len() == 1 {
        return vec![patch.clone()];
    }
    parts.iter().flat_map(|part| Patch::of_polygon(part, normal)).collect()
}

fn halves(part: Vec<DVec3>, edge: &Edge, side: DVec3, normal: DVec3, size: f64) -> Vec<Vec<DVec3>> {
    let end = edge.start + edge.along * edge.length;
    let [h0, h1] = [edge.start, end].map(|x| (x - part[0]).dot(normal).abs());
    let near = h0.min(h1);
    let reaches = |sign: f64| part.iter().map(|x| sign * (*x - edge.start).dot(side)).fold(0.0, f64::max);
    // No cut nearer to the border than half the edge's height: the part would be narrower than the layer.
    if near > HOT * size || reaches(1.0).min(reaches(-1.0)) < 0.5 * near.max(1e-9 * size) {
        return vec![part];
    }
    [side, -side]
        .map(|side| clip_polygon(&part, edge.start, side))
        .into_iter()
        .filter(|half| half.len() > 2)
        .collect()
}

/// Tensor samples if the longest extent is halved until every part is far enough apart; infinite above
/// `limit`, and for patches that touch or cross each other.
pub(super) fn split_cost(p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64, limit: f64) -> f64 {
    cost_of_halves(p, q, degrees, eps, limit, MOST_HALVINGS_OF_SPLIT)
}

/// As [`split_cost`], with at most so many halvings, one inside the other.
fn cost_of_halves(p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64, limit: f64, halvings: u32) -> f64 {
    let gap = gap(p, q);
    if gap == 0.0 || halvings == 0 {
        return f64::INFINITY;
    }
    if gap >= SMALLEST_RATIO * p.longest().1.max(q.longest().1) {
        return far::counts(p, q, degrees, gap, eps).iter().map(|n| *n as f64).product();
    }
    let mut cost = 0.0;
    for [a, b] in Patch::halve_longer(p, q) {
        cost += cost_of_halves(&a, &b, degrees, eps, limit - cost, halvings - 1);
        if cost > limit {
            return f64::INFINITY;
        }
    }
    cost
}
