//! Gauss–Legendre rules on [0, 1], computed once and shared.
//!
//! `∫₀¹ f(s) ds ≈ Σ_a w_a f(x_a)`, exact for polynomials of degree 2n − 1. Patches are charted by the unit
//! square, so that a corner or an edge of contact lies at zero.

use std::sync::OnceLock;

use radiosity_core::gauss;

/// Most points per direction of any rule of the kernel. A kernel that needs more is nearly singular, and
/// halving its patches takes fewer points than a finer rule.
pub const MOST_POINTS: usize = 64;

/// An n-point rule on [0, 1].
#[derive(Clone, Debug)]
pub struct UnitRule {
    /// Nodes, ascending, in (0, 1).
    pub nodes: Vec<f64>,
    /// Weights, positive, summing to 1.
    pub weights: Vec<f64>,
}

/// A rule along one direction of a patch.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Nodes in [0, 1].
    pub nodes: &'a [f64],
    /// Their weights, as many.
    pub weights: &'a [f64],
}

impl UnitRule {
    /// The rule of `points` points, limited to 1..=[`MOST_POINTS`].
    pub fn of(points: usize) -> &'static Self {
        static RULES: [OnceLock<UnitRule>; MOST_POINTS + 1] = [const { OnceLock::new() }; MOST_POINTS + 1];
        let points = points.clamp(1, MOST_POINTS);
        RULES[points].get_or_init(|| Self::compute(points))
    }

    fn compute(points: usize) -> Self {
        let mut nodes = vec![0.0; points];
        let mut weights = vec![0.0; points];
        gauss::legendre(&mut nodes, &mut weights).expect("slices are equal and not empty");
        for (x, w) in nodes.iter_mut().zip(&mut weights) {
            *x = 0.5 * (1.0 + *x);
            *w *= 0.5;
        }
        Self { nodes, weights }
    }

    /// Its nodes and weights.
    pub fn line(&self) -> Line<'_> {
        Line { nodes: &self.nodes, weights: &self.weights }
    }

    /// Nodes with their weights.
    pub fn iter(&self) -> impl Iterator<Item = (f64, f64)> + Clone {
        self.nodes.iter().copied().zip(self.weights.iter().copied())
    }
}
