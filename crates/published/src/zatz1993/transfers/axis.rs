//! One parameter of one patch: points, weights, and the values of its functions there.
//!
//! For a weight W(x) = (1 − x)^α (1 + x)^β: Σ_a w_a f(x_a) = ∫₋₁¹ f W dx for polynomials f of
//! degree ≤ 2n − 1.

use radiosity_core::gauss;
use radiosity_core::jacobi::{self, Weight};

/// Points of one parameter on [−1, 1].
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Exponents (α, β) for which the functions are orthonormal.
    pub weight: [u8; 2],
    /// x_a, ascending.
    pub nodes: Vec<f64>,
    /// w_a, point by point.
    pub weights: Vec<f64>,
    /// Function values, point by point.
    values: Vec<f64>,
}

impl Axis {
    /// The `points`-point Gauss rule of `weight`, with the polynomials up to `order` orthonormal for it.
    pub(super) fn new(order: usize, points: usize, weight: [u8; 2]) -> Self {
        Self::of(order, points, weight, weight)
    }

    /// Points and weights of [`Self::new`] with orthonormal Legendre polynomials.
    pub(super) fn with_legendre(order: usize, points: usize, weight: [u8; 2]) -> Self {
        Self::of(order, points, weight, [0, 0])
    }

    fn of(order: usize, points: usize, rule: [u8; 2], functions: [u8; 2]) -> Self {
        let (mut nodes, mut weights) = (vec![0.0; points], vec![0.0; points]);
        let mut values = vec![0.0; points * (order + 1)];
        gauss::jacobi(Weight::integer(rule[0], rule[1]), &mut nodes, &mut weights)
            .expect("a rule has at least one point");
        for (x, out) in nodes.iter().zip(values.chunks_exact_mut(order + 1)) {
            jacobi::orthonormal(Weight::integer(functions[0], functions[1]), *x, out);
        }
        Self { weight: functions, nodes, weights, values }
    }

    /// These points with the weight (1 − x)^α (1 + x)^β divided out: a rule for ∫ f dx.
    pub(super) fn divided(mut self, [a, b]: [u8; 2]) -> Self {
        for (x, w) in self.nodes.iter().zip(&mut self.weights) {
            *w /= (1.0 - x).powi(i32::from(a)) * (1.0 + x).powi(i32::from(b));
        }
        self
    }

    /// Function number `degree` at point number `point`.
    pub(super) fn value(&self, point: usize, degree: usize) -> f64 {
        let degrees = self.values.len() / self.nodes.len();
        self.values[point * degrees + degree]
    }
}
