//! The outer rule of a near pair: cells of the receiver, known beforehand.
//!
//! I_l(x) is analytic on the receiver's plane, over the emitter as well however near, except at the complex points at
//! distance zero from an edge of the emitter (where the foot lies on it) or from a corner. On a straight line
//! x(s) = x₀ + s X of a cell's chart these are the roots of two quadratics,
//!
//! ```text
//! |x(s) − v|² = 0 :          s = ( −X·w ± 𝚒 |X × w| ) / |X|² ,   w = x₀ − v ,
//! distance(x(s), edge) = 0 : the same with the parts of X and w across the edge.
//! ```
//!
//! Per direction of a cell the roots nearest to it choose the sinh map; where a map still leaves a slow
//! rate, the cell is cut. Beforehand the receiver is cut along the projections of edges that come near, so that the
//! layers of width ≈ gap along them lie at sides of cells.

use radiosity_geom::{DVec3, clip_polygon};

use super::complex::Complex;
use super::polar::{Edge, Polar, edges, fraction};
use super::stretch::Stretch;
use crate::elements::basis::AreaBasis;
use crate::elements::patch::{Direction, Patch};
use crate::kernel::pair::gap;
use crate::kernel::separated::{self, SMALLEST_RATIO};

/// ϱ below which a cell is cut.
const SLOWEST: f64 = 1.8;
/// Edges nearer than this part of the receiver's size get a cut along their projection.
const HOT: f64 = 0.1;
/// Cost of a sample of the polar rule in samples of a tensor rule.
const POLAR_COST: f64 = 3.0;
/// Most cuts of one cell.
const DEEPEST: usize = 40;
/// Where along the other direction the lines of a chart are examined.
const LINES: [f64; 7] = [0.0, 0.02, 0.25, 0.5, 0.75, 0.98, 1.0];

/// A cell with the rule chosen for it.
#[derive(Debug)]
pub(super) struct Leaf {
    pub cell: Patch,
    pub emitter: Patch,
    pub rule: Rule,
}

/// The rule of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// Outer points along and across, each with a polar integral over the emitter.
    Polar([(Stretch, usize); 2]),
    /// Far enough: a tensor rule, points of the cell, then of the emitter.
    Tensor([usize; 4]),
}

/// The leaves of one pair under way.
pub(super) struct Planner<'a> {
    outer: &'a AreaBasis,
    inner: &'a AreaBasis,
    eps: f64,
    pub leaves: Vec<Leaf>,
    /// In samples of a tensor rule.
    pub cost: f64,
}

impl<'a> Planner<'a> {
    pub(super) fn new(outer: &'a AreaBasis, inner: &'a AreaBasis, eps: f64) -> Self {
        Self { outer, inner, eps, leaves: Vec::new(), cost: 0.0 }
    }

    /// Plans the flat pair of an outer and an inner patch.
    pub(super) fn pair(&mut self, outer: &Patch, inner: &Patch) {
        let emitter = Emitter::new(inner, self.inner);
        for part in cut_along(outer, &emitter.edges) {
            self.cell(&part, &emitter, 0);
        }
    }

    fn cell(&mut self, cell: &Patch, emitter: &Emitter, depth: usize) {
        let rates = [Direction::Along, Direction::Across].map(|d| Rate::of(cell, d, &emitter.edges));
        let tensor = self.tensor(cell, emitter);
        if tensor.is_none() && !emitter.reached(cell, self.inner, self.eps) {
            let ((direction, extent), (inner, reach)) = (longest(cell), longest(&emitter.patch));
            if extent >= reach {
                cell.halves(direction).iter().for_each(|half| self.cell(half, emitter, depth + 1));
            } else {
                for half in emitter.patch.halves(inner) {
                    self.cell(cell, &Emitter::new(&half, self.inner), depth + 1);
                }
            }
            return;
        }
        let slow = usize::from(rates[1].rho < rates[0].rho);
        if tensor.is_none() && rates[slow].rho < SLOWEST && depth < DEEPEST {
            for part in cut(cell, slow, rates[slow].place) {
                self.cell(&part, emitter, depth + 1);
            }
            return;
        }
        let polar = self.polar(cell, emitter, &rates);
        let (cost, rule) = match tensor {
            Some(tensor) if tensor.0 < polar.0 || !emitter.reached(cell, self.inner, self.eps) => tensor,
            _ => polar,
        };
        self.cost += cost;
        self.leaves.push(Leaf { cell: cell.clone(), emitter: emitter.patch.clone(), rule });
    }

    fn polar(&self, cell: &Patch, emitter: &Emitter, rates: &[Rate; 2]) -> (f64, Rule) {
        let degree = self.outer.order() + usize::from(!cell.is_parallelogram());
        let fraction = fraction(cell, self.outer);
        let points = [0, 1].map(|k| {
            let Rate { stretch, rho, .. } = rates[k];
            (stretch, stretch.points(rho, fraction, degree, self.eps))
        });
        let places = [(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.1, 0.9), (0.5, 0.5)];
        let inner: usize = places.iter().map(|(s, t)| emitter.polar.count(&cell.node(*s, *t), self.eps)).sum();
        let count = (points[0].1 * points[1].1 * inner) as f64 / places.len() as f64;
        (POLAR_COST * count, Rule::Polar(points))
    }

    fn tensor(&self, cell: &Patch, emitter: &Emitter) -> Option<(f64, Rule)> {
        let longest = [cell.extents(), emitter.patch.extents()].concat().into_iter().fold(0.0, f64::max);
        let gap = gap(cell, &emitter.patch);
        if gap < SMALLEST_RATIO * longest {
            return None;
        }
        let degrees = [self.outer.order(), self.inner.order()];
        let counts = separated::counts(cell, &emitter.patch, degrees, gap, self.eps);
        Some((counts.iter().map(|n| *n as f64).product(), Rule::Tensor(counts)))
    }
}

fn longest(patch: &Patch) -> (Direction, f64) {
    let [along, across] = patch.extents();
    if along >= across { (Direction::Along, along) } else { (Direction::Across, across) }
}

struct Emitter<'a> {
    patch: Patch,
    edges: Vec<Edge>,
    polar: Polar<'a>,
}

impl<'a> Emitter<'a> {
    fn new(patch: &Patch, basis: &'a AreaBasis) -> Self {
        Self { patch: patch.clone(), edges: edges(patch), polar: Polar::new(patch, basis) }
    }

    /// Whether the emitter's polynomials stay tame at the feet of a cell's points.
    fn reached(&self, cell: &Patch, basis: &AreaBasis, eps: f64) -> bool {
        let normal = self.patch.node(0.5, 0.5).normal;
        let growth = |x: &DVec3| {
            let foot = *x - normal * (*x - self.edges[0].start).dot(normal);
            let place = basis.frame().locate(foot, radiosity_geom::DVec2::ZERO);
            let a = place[0].abs().max(place[1].abs()).max(1.0);
            (a + (a * a - 1.0).sqrt()).powi(basis.order() as i32)
        };
        cell.polygon().iter().map(growth).fold(0.0, f64::max) * 1e-15 < eps.max(1e-12)
    }
}

/// How fast a direction of a cell converges.
struct Rate {
    stretch: Stretch,
    rho: f64,
    /// Where a cut would help.
    place: f64,
}

impl Rate {
    fn of(cell: &Patch, direction: Direction, edges: &[Edge]) -> Self {
        let mut roots = Vec::new();
        for line in LINES {
            let ends = match direction {
                Direction::Along => [cell.node(0.0, line), cell.node(1.0, line)],
                Direction::Across => [cell.node(line, 0.0), cell.node(line, 1.0)],
            };
            let (start, step) = (ends[0].position, ends[1].position - ends[0].position);
            if step != DVec3::ZERO {
                edges.iter().for_each(|edge| singularities(start, step, edge, &mut roots));
            }
        }
        let slowest = |stretch: Stretch| {
            roots.iter().map(|root| (stretch.ellipse(*root), *root)).fold(
                (f64::INFINITY, Complex::ONE),
                |best, next| if next.0 < best.0 { next } else { best },
            )
        };
        let (rho, worst) = slowest(Stretch::PLAIN);
        let mapped = Stretch::around(worst.re, worst.im.max(1e-13));
        let (better, next) = slowest(mapped);
        let place = |root: Complex| if (0.1..=0.9).contains(&root.re) { root.re } else { 0.5 };
        if better > rho {
            Self { stretch: mapped, rho: better, place: place(next) }
        } else {
            Self { stretch: Stretch::PLAIN, rho, place: place(worst) }
        }
    }
}

/// Adds the singular places of the inner integral on the line `start` + s `step` that belong to `edge`.
fn singularities(start: DVec3, step: DVec3, edge: &Edge, roots: &mut Vec<Complex>) {
    let from = start - edge.start;
    roots.push(root(from, step));
    let across = |v: DVec3| v - edge.along * v.dot(edge.along);
    let (w, x) = (across(from), across(step));
    if x.length_squared() > 1e-24 * step.length_squared() {
        let place = root(w, x);
        let foot = from.dot(edge.along) + place.re * step.dot(edge.along);
        if (0.0..=edge.length).contains(&foot) {
            roots.push(place);
        }
    }
}

fn root(w: DVec3, x: DVec3) -> Complex {
    Complex::new(-x.dot(w), x.cross(w).length()).scale(1.0 / x.length_squared())
}

/// The two parts of a flat cell cut at `place` of direction 0 or 1.
fn cut(cell: &Patch, direction: usize, place: f64) -> [Patch; 2] {
    let ([a, b, c, d], normal) = (cell.corners(), cell.node(0.5, 0.5).normal);
    let flat = |corners| Patch::Flat { corners, normal };
    if direction == 0 {
        let (low, high) = (a.lerp(b, place), d.lerp(c, place));
        [flat([a, low, high, d]), flat([low, b, c, high])]
    } else {
        let (left, right) = (a.lerp(d, place), b.lerp(c, place));
        [flat([a, b, right, left]), flat([left, right, c, d])]
    }
}

/// The parts of a flat patch between the projections of the near ones of `edges`.
fn cut_along(patch: &Patch, edges: &[Edge]) -> Vec<Patch> {
    let normal = patch.node(0.5, 0.5).normal;
    let extents = patch.extents();
    let size = extents[0].max(extents[1]);
    let mut parts = vec![patch.polygon()];
    for edge in edges {
        let steepness = edge.along.dot(normal);
        let side = edge.along.cross(normal);
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

fn halves(
    part: Vec<DVec3>,
    edge: &Edge,
    side: DVec3,
    normal: DVec3,
    size: f64,
) -> Vec<Vec<DVec3>> {
    let end = edge.start + edge.along * edge.length;
    let [h0, h1] = [edge.start, end].map(|x| (x - part[0]).dot(normal).abs());
    let near = h0.min(h1);
    let reaches = |sign: f64| part.iter().map(|x| sign * (*x - edge.start).dot(side)).fold(0.0, f64::max);
    if near > HOT * size || reaches(1.0).min(reaches(-1.0)) < 0.5 * near.max(1e-9 * size) {
        return vec![part];
    }
    [side, -side]
        .map(|side| clip_polygon(&part, edge.start, side))
        .into_iter()
        .filter(|half| half.len() > 2)
        .collect()
}
