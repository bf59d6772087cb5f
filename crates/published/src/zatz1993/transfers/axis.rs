//! The points of one parameter of one piece.
//!
//! For a weight W(x) = (1 − x)^α (1 + x)^β: Σ_a w_a f(x_a) = ½ ∫₋₁¹ f W dx for polynomials f of
//! degree ≤ 2n − 1.

use radiosity_core::gauss;
use radiosity_core::jacobi::Weight;

/// The exponents of a weight that vanishes doubly at −1, where the edge lies.
pub(super) const DOUBLE_ZERO: [u8; 2] = [0, 2];

/// Points and weights of one parameter.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Points of the chart [0, 1], ascending: ½ (1 + x_a).
    nodes: Vec<f64>,
    weights: Vec<f64>,
}

impl Axis {
    /// The `points`-point Gauss rule of the weight with these exponents.
    pub(super) fn new(points: usize, [a, b]: [u8; 2]) -> Self {
        let (mut nodes, mut weights) = (vec![0.0; points], vec![0.0; points]);
        gauss::jacobi(Weight::integer(a, b), &mut nodes, &mut weights)
            .expect("a rule has at least one point");
        nodes.iter_mut().for_each(|x| *x = 0.5 * (1.0 + *x));
        weights.iter_mut().for_each(|w| *w *= 0.5);
        Self { nodes, weights }
    }

    /// These points with the weight (1 + x)² divided out: a rule for ½ ∫ f dx.
    pub(super) fn divided(mut self) -> Self {
        for (x, w) in self.nodes.iter().zip(&mut self.weights) {
            *w /= (2.0 * x).powi(2);
        }
        self
    }

    /// The points with their weights.
    pub(super) fn iter(&self) -> impl Iterator<Item = (f64, f64)> {
        self.nodes.iter().copied().zip(self.weights.iter().copied())
    }
}
