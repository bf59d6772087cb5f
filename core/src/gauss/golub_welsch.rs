//! Gauss rules from the eigenvalues of the symmetric tridiagonal Jacobi matrix.
//!
//!   J = tridiag(√γ_k, δ_k, √γ_{k+1}),   J v = x v   ⇒   xᵢ = eigenvalue,  wᵢ = μ₀ v₀² / ‖v‖²
//!
//! where δ_k, γ_k are the coefficients of the monic recurrence π_{k+1} = (x − δ_k) π_k − γ_k π_{k−1}. This is
//! equation (17) in H. R. Zatz, "Galerkin radiosity" (1993), with the factor μ₀ it leaves out. The eigenvalues come
//! from the implicit QL iteration with Wilkinson's shift; of the eigenvectors only the first components are carried.
//!
//! The classical route, kept for comparison: [`jacobi`](super::jacobi()) is faster and far more accurate. Here nodes
//! are good to about 10⁻¹⁵ absolutely, and the weights near the ends lose two to four digits.
//!
//! Reference: G. H. Golub, J. H. Welsch, "Calculation of Gauss quadrature rules", Math. Comp. 23 (1969).

use super::RuleError;
use super::error::points;
use crate::jacobi::{Weight, integral, monic::Monic};
use crate::math::{hypot, sqrt};

/// Most QL steps per eigenvalue; three are usual. Chosen; not tuned.
const STEPS: usize = 60;

/// Writes the n-point Gauss rule of the weight (1 − x)^α (1 + x)^β by the QL iteration, nodes ascending.
///
/// `nodes`, `weights` and `scratch` have the common length n; `scratch` is overwritten.
///
/// # Errors
/// [`RuleError`] if the slices are empty or differ in length, and then nothing is written;
/// [`RuleError::NoConvergence`] if an eigenvalue does not settle, which no valid weight is known to cause.
pub fn golub_welsch(
    weight: Weight,
    nodes: &mut [f64],
    weights: &mut [f64],
    scratch: &mut [f64],
) -> Result<(), RuleError> {
    let n = points(nodes, weights)?;
    if scratch.len() != n {
        return Err(RuleError::Lengths);
    }
    let monic = Monic::new(weight);
    for k in 0..n {
        nodes[k] = monic.delta(k).hi;
        scratch[k] = 0.5 * sqrt(monic.four_gamma(k + 1).hi);
        weights[k] = 0.0;
    }
    scratch[n - 1] = 0.0;
    weights[0] = 1.0;
    let mut matrix = Tridiagonal { diagonal: nodes, beside: scratch, first: weights };
    for l in 0..n {
        matrix.settle(l)?;
    }
    let mu_0 = integral(weight).hi;
    for w in weights.iter_mut() {
        *w = mu_0 * (*w * *w);
    }
    sort(nodes, weights);
    Ok(())
}

/// A symmetric tridiagonal matrix under QL iteration, and the first components of its eigenvectors.
struct Tridiagonal<'a> {
    diagonal: &'a mut [f64],
    /// `beside[k]` couples k and k + 1; the last one is 0.
    beside: &'a mut [f64],
    first: &'a mut [f64],
}

impl Tridiagonal<'_> {
    /// Iterates until `diagonal[l]` is an eigenvalue.
    fn settle(&mut self, l: usize) -> Result<(), RuleError> {
        for _ in 0..STEPS {
            let end = self.block_end(l);
            if end == l {
                return Ok(());
            }
            self.step(l, end);
        }
        Err(RuleError::NoConvergence)
    }

    /// The first m ≥ l whose coupling to m + 1 is negligible.
    fn block_end(&self, l: usize) -> usize {
        let mut m = l;
        while m + 1 < self.diagonal.len() {
            let size = self.diagonal[m].abs() + self.diagonal[m + 1].abs();
            if self.beside[m].abs() <= 0.5 * f64::EPSILON * size {
                break;
            }
            m += 1;
        }
        m
    }

    /// One implicit QL step on the rows l … end.
    fn step(&mut self, l: usize, end: usize) {
        let (d, e) = (&mut *self.diagonal, &mut *self.beside);
        // Wilkinson's shift: the eigenvalue of the leading 2 × 2 block nearer to d[l].
        let g = (d[l + 1] - d[l]) / (2.0 * e[l]);
        let mut g = d[end] - d[l] + e[l] / (g + hypot(g, 1.0).copysign(g));
        let (mut sine, mut cosine, mut p) = (1.0, 1.0, 0.0);
        // Chase the bulge upwards with rotations in the planes (i, i + 1).
        for i in (l..end).rev() {
            let (f, b) = (sine * e[i], cosine * e[i]);
            let r = hypot(f, g);
            e[i + 1] = r;
            if r == 0.0 {
                d[i + 1] -= p;
                e[end] = 0.0;
                return;
            }
            (sine, cosine) = (f / r, g / r);
            g = d[i + 1] - p;
            let turn = (d[i] - g) * sine + 2.0 * cosine * b;
            p = sine * turn;
            d[i + 1] = g + p;
            g = cosine * turn - b;
            let (z, y) = (self.first[i], self.first[i + 1]);
            self.first[i + 1] = sine * z + cosine * y;
            self.first[i] = cosine * z - sine * y;
        }
        d[l] -= p;
        e[l] = g;
        e[end] = 0.0;
    }
}

/// Sorts the nodes, carrying the weights along: insertion, since QL leaves them nearly in order.
fn sort(nodes: &mut [f64], weights: &mut [f64]) {
    for i in 1..nodes.len() {
        let mut j = i;
        while j > 0 && nodes[j - 1] > nodes[j] {
            nodes.swap(j - 1, j);
            weights.swap(j - 1, j);
            j -= 1;
        }
    }
}
