//! The inner patch of a near pair, and the singularities of its inner integral.
//!
//! I_l(x) is analytic on the receiver's plane, however near the emitter, except at complex points at distance
//! zero from an edge of the emitter (if their foot lies on it) or from a corner. On a straight line
//! x(s) = x₀ + s X of a cell's chart these are the roots of two quadratics,
//!
//! ```text
//! |x(s) − v|² = 0 :          s = ( −X·w ± 𝚒 |X × w| ) / |X|² ,   w = x₀ − v ,
//! distance(x(s), edge) = 0 : the same with the parts of X and w across the edge.
//! ```
//!
//! On a receiver inclined to the emitter's plane, the emitter's polynomials add a term h² ln h where the line
//! meets that plane inside the emitter.

use num_complex::Complex64;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::DVec3;

use crate::rules::near::polar::{Edge, Polar, edges};

/// Singularities farther than this from the cell, in lengths of the cell, are ignored: rules converge at
/// seven digits a point there. Strong maps bring those up to it near.
const FAR: f64 = 1e3;
/// Imaginary part below which a singularity gets a line in the other direction. Beyond it rules gain 0.4
/// digits a point and more, and the fixed lines find it well enough.
const CLOSE: f64 = 0.25;
/// Most such lines, the nearest first: as many as the emitter has sides.
const MOST_CLOSE: usize = 4;
/// Singularities whose difference is below this part of their distance from the cell count as one: their
/// convergence rates differ by as little. With a larger value the nearest one may be missed.
const ALIKE: f64 = 0.02;
/// Parameters of the lines on which singularities are looked for: denser at the ends, beside which edges run.
/// An arbitrary choice: a singularity that is nearer on a line between them is not seen, and each line takes
/// time in every cell.
const LINES: [f64; 7] = [0.0, 0.02, 0.25, 0.5, 0.75, 0.98, 1.0];

pub(super) struct Emitter<'a> {
    pub patch: Patch,
    edges: Vec<Edge>,
    pub polar: Polar<'a>,
}

impl<'a> Emitter<'a> {
    pub(super) fn new(patch: &Patch, basis: &'a AreaBasis, eps: f64) -> Self {
        Self { patch: patch.clone(), edges: edges(patch), polar: Polar::new(patch, basis, eps) }
    }

    /// Whether the emitter's polynomials, extended to the feet of a cell's points, grow so little that
    /// rounding stays below ε.
    pub(super) fn reached(&self, cell: &Patch, eps: f64) -> bool {
        cell.polygon().iter().all(|x| self.polar.reaches(*x, eps))
    }

    /// Singularities of the inner integral on lines along and across a cell's chart.
    ///
    /// One that is close to the cell and found in one direction may lie between the lines of the other
    /// direction, which then gets a line at its parameter.
    pub(super) fn places(&self, cell: &Patch, floor: f64, eps: f64) -> [Vec<Complex64>; 2] {
        let directions = [Direction::Along, Direction::Across];
        let mut found = directions.map(|direction| self.roots(cell, direction, &LINES, floor, eps));
        let lines = [&found[1], &found[0]].map(|others| {
            let mut close: Vec<Complex64> = others
                .iter()
                .copied()
                .filter(|root| root.im < CLOSE && (0.0..=1.0).contains(&root.re))
                .collect();
            close.sort_by(|a, b| a.im.total_cmp(&b.im));
            close.iter().take(MOST_CLOSE).map(|root| root.re).collect::<Vec<f64>>()
        });
        for ((roots_found, direction), lines) in found.iter_mut().zip(directions).zip(&lines) {
            roots_found.extend(self.roots(cell, direction, lines, floor, eps));
        }
        found.map(distinct)
    }

    /// Singularities on given lines of one direction, their imaginary parts not below `floor`.
    fn roots(
        &self,
        cell: &Patch,
        direction: Direction,
        lines: &[f64],
        floor: f64,
        eps: f64,
    ) -> Vec<Complex64> {
        let mut found = Vec::new();
        for line in lines {
            let ends = match direction {
                Direction::Along => [cell.node(0.0, *line), cell.node(1.0, *line)],
                Direction::Across => [cell.node(*line, 0.0), cell.node(*line, 1.0)],
            };
            let (start, step) = (ends[0].position, ends[1].position - ends[0].position);
            if step != DVec3::ZERO {
                let first = found.len();
                self.edges.iter().for_each(|edge| singularities(start, step, edge, &mut found));
                found.extend(self.polar.crossing(start, step, eps));
                let least = floor / step.length();
                found[first..].iter_mut().for_each(|root| root.im = root.im.max(least));
            }
        }
        found
    }
}

/// The singularities near the cell, those that almost coincide once.
fn distinct(roots: Vec<Complex64>) -> Vec<Complex64> {
    let mut kept: Vec<Complex64> = Vec::new();
    for root in roots {
        let distance = (root - root.re.clamp(0.0, 1.0)).norm();
        if distance < FAR && !kept.iter().any(|other| (*other - root).norm() <= ALIKE * distance) {
            kept.push(root);
        }
    }
    kept
}

/// Adds the singularities on the line `start` + s `step` that belong to `edge`.
fn singularities(start: DVec3, step: DVec3, edge: &Edge, roots: &mut Vec<Complex64>) {
    let from = start - edge.start;
    // A line parallel to the edge, to rounding, keeps its distance.
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

fn root(w: DVec3, x: DVec3) -> Complex64 {
    Complex64::new(-x.dot(w), x.cross(w).length()) / x.length_squared()
}
