//! Numbers of points for contacts of curved patches, found by trial.
//!
//! The formulas of [`crate::rules::common_edge`] and [`crate::rules::common_vertex`] know the singularities
//! of parallelograms. Curved patches have nearer ones: sides that run together, lines that bend across a
//! narrow gap. The rule itself is therefore tried on sections of its domain: a sum over one set of variables
//! with the others fixed at a few values. The least n is taken with
//!
//! ```text
//! Σ_r |S_r(n) − S_r(n + 2)| ≤ ε/2 Σ_r |S_r(n + 2)|
//! ```
//!
//! where S_r is the sum over subdomain r.

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::{MOST_POINTS, UnitRule};
use radiosity_work::interruption::check_interrupt;

use crate::moments::integrand::kernel;
use crate::tolerances::{ROUNDING_OF_SUMS, SHARE_OF_TRIAL};

/// Values of fixed variables, away from the ends, where sides may be collapsed. An arbitrary choice: an
/// integrand that is hardest elsewhere gets too few points, each further value takes as long again.
const HELD: [f64; 2] = [0.3, 0.85];
/// Points of the angular variables while another variable is tried: both sums that are compared have the
/// error of so few, and it cancels.
const FEW: usize = 4;
/// Number of subdomains of an edge.
const EDGE_PARTS: usize = 6;
/// Number of subdomains of a corner.
const CORNER_PARTS: usize = 4;

/// Numbers of points, and what the sums of the largest rules still differ by, relative, if that is too much;
/// else 0.
#[derive(Clone, Copy, Debug)]
pub struct Trial<const N: usize> {
    /// Numbers of points of each variable.
    pub points: [usize; N],
    /// Relative difference that is left.
    pub missed: f64,
}

/// Numbers of points [x, y, angular] for constants on two patches with their common edge at t = 0. `node` is
/// the emitter's chart, at the receiver's speed along the edge.
pub fn edge(p: &Patch, node: &dyn Fn(f64, f64) -> Node, eps: f64) -> Trial<3> {
    let value = |part: usize, [x, y, a, b]: [f64; 4]| {
        let [t, v, z] = [[1.0, a, b], [a, 1.0, b], [a, b, 1.0]][part % 3].map(|place| x * place);
        let base = (1.0 - z) * y;
        let (s, u) = if part < 3 { (base, base + z) } else { (base + z, base) };
        let (x_node, y_node) = (p.node(s, t), node(u, v));
        kernel(&x_node, &y_node) * x_node.area * y_node.area * x * x * (1.0 - z)
    };
    let angles = UnitRule::of(FEW);
    let over_angles = |rule: &UnitRule, f: &dyn Fn(f64, f64) -> f64| -> f64 {
        rule.iter().map(|(a, wa)| rule.iter().map(|(b, wb)| wa * wb * f(a, b)).sum::<f64>()).sum()
    };
    let line = |place: &dyn Fn(f64, f64, f64) -> [f64; 4]| {
        least(2, MOST_POINTS, eps, EDGE_PARTS, |part, n| {
            let rule = UnitRule::of(n);
            rule.iter().map(|(w, ww)| ww * over_angles(angles, &|a, b| value(part, place(w, a, b)))).sum()
        })
    };
    let radial = line(&|x, a, b| [x, 0.5, a, b]);
    let along = line(&|y, a, b| [0.5, y, a, b]);
    let angular = least(3, MOST_POINTS, eps, EDGE_PARTS, |part, n| {
        HELD.iter().map(|x| over_angles(UnitRule::of(n), &|a, b| value(part, [*x, 0.5, a, b]))).sum()
    });
    Trial::of([radial, along, angular])
}

/// Numbers of points [x, angular] for constants on two patches with their common corner at (0, 0); at most
/// `most` angular ones.
pub fn vertex(p: &Patch, q: &Patch, most: usize, eps: f64) -> Trial<2> {
    let value = |part: usize, x: f64, [a, b, c]: [f64; 3]| {
        let places = [[1.0, a, b, c], [a, 1.0, b, c], [a, b, 1.0, c], [a, b, c, 1.0]];
        let [s, t, u, v] = places[part].map(|place| x * place);
        let (x_node, y_node) = (p.node(s, t), q.node(u, v));
        kernel(&x_node, &y_node) * x_node.area * y_node.area * x.powi(3)
    };
    let cube = |n: usize, f: &dyn Fn([f64; 3]) -> f64| -> f64 {
        let rule = UnitRule::of(n);
        let line = |a: f64, b: f64| rule.iter().map(|(c, wc)| wc * f([a, b, c])).sum::<f64>();
        let square = |a: f64| rule.iter().map(|(b, wb)| wb * line(a, b)).sum::<f64>();
        rule.iter().map(|(a, wa)| wa * square(a)).sum()
    };
    let radial = least(2, MOST_POINTS, eps, CORNER_PARTS, |part, n| {
        let rule = UnitRule::of(n);
        rule.iter().map(|(x, wx)| wx * cube(FEW - 1, &|angles| value(part, x, angles))).sum()
    });
    let angular =
        least(3, most, eps, CORNER_PARTS, |part, n| cube(n, &|angles| value(part, HELD[1], angles)));
    Trial::of([radial, angular])
}

impl<const N: usize> Trial<N> {
    fn of(each: [Trial<1>; N]) -> Self {
        Self {
            points: each.map(|trial| trial.points[0]),
            missed: each.map(|trial| trial.missed).iter().sum(),
        }
    }
}

/// The least n ≥ `first` whose sums S_r(n) agree with S_r(n + 2); `most` if none does.
fn least(first: usize, most: usize, eps: f64, parts: usize, sum: impl Fn(usize, usize) -> f64) -> Trial<1> {
    let sums = |n: usize| (0..parts).map(|part| sum(part, n)).collect::<Vec<f64>>();
    let mut coarse = sums(first);
    let (mut n, mut missed) = (first, f64::INFINITY);
    while n < most {
        check_interrupt();
        let fine = sums(n + 2);
        let difference: f64 = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs()).sum();
        let all: f64 = fine.iter().map(|x| x.abs()).sum();
        if difference <= (SHARE_OF_TRIAL * eps).max(ROUNDING_OF_SUMS) * all {
            return Trial { points: [n], missed: 0.0 };
        }
        (n, coarse, missed) = (n + 2, fine, difference / all);
    }
    Trial { points: [most], missed }
}
