//! Product integration along a ray of the polar rule, exact for polynomials however sharp the kernel.
//!
//! ```text
//! ∫₀¹ t f(t)/(t² + η²)² dt = Σ_j α_j f(t_j) ,    ∫₀¹ t² f(t)/(t² + η²)² dt = Σ_j β_j f(t_j)
//! ```
//!
//! for every polynomial f of degree < n; t_j are the Gauss points of [0, 1], w_j their weights:
//!
//! ```text
//! α_j = w_j Σ_i (2i + 1) P_i(2t_j − 1) A_i ,    A_i = ∫₀¹ t P_i(2t − 1)/(t² + η²)² dt , B_i with t² .
//! ```
//!
//! With z = −1 + 2𝚒η and Legendre's function of the second kind, Neumann's ∫₋₁¹ P_i(x)/(z − x) dx = 2 Q_i(z)
//! gives
//!
//! ```text
//! c_i = ∫₀¹ P_i/(t − 𝚒η) dt = −2 Q_i(z) ,   d_i = ∫₀¹ P_i/(t − 𝚒η)² dt = −4 Q_i′(z) ,
//! A_i = Im d_i/(2η) ,   B_i = ½ (Re d_i + Im c_i/η) ,
//! (z² − 1) Q_i′ = i (z Q_i − Q_{i−1}) ,   Q₀ = −¼ ln(1 + η⁻²) − ½ 𝚒 atan(1/η) .
//! ```
//!
//! Q_i satisfies (i + 1) Q_{i+1} = (2i + 1) z Q_i − i Q_{i−1}. It is computed forwards while that keeps
//! enough digits, else backwards from a high index (Miller's algorithm), being the decaying solution. For
//! η > ½, where the two parts of B_i cancel, t P_i is expanded: B_i = ½ A_i + ½ ((i + 1) A_{i+1} + i
//! A_{i−1})/(2i + 1).
//!
//! Reference: NIST Digital Library of Mathematical Functions, §14.

use num_complex::Complex64;
use radiosity_elements::rule::UnitRule;

use crate::rules::near::ellipse::ellipse;

/// Accuracy of the recurrences relative to that of the rule: four digits to spare, since weights sum A_i and
/// B_i with factors 2i + 1 and of both signs.
const RECURRENCE_ACCURACY: f64 = 1e-4;
/// Largest η for forward recurrence: beyond it the moments need Q to full relative accuracy, and Q falls so
/// fast that forward recurrence loses it. With a smaller value the backward one runs more often, which takes
/// longer.
const FARTHEST_FORWARD: f64 = 1.0;
/// Loss of accuracy that forward recurrence may always have, as a natural logarithm: a factor of 20, which
/// leaves 4e-15, whatever is asked. With a smaller value the backward recurrence runs more often, which takes
/// longer.
const LEAST_LOSS: f64 = 3.0;

/// The rule of n points along rays.
#[derive(Debug)]
pub(super) struct Radial {
    rule: &'static UnitRule,
    /// −ln of the accuracy of the backward recurrence.
    digits: f64,
    /// η below which forward recurrence keeps enough digits.
    forward: f64,
    /// (2i + 1) w_j P_i(2t_j − 1), a row per j.
    projection: Vec<f64>,
    functions: Vec<Complex64>,
    /// A_i and B_i, i = 0..=n.
    moments: Vec<[f64; 2]>,
    /// [α_j, β_j] of the last η.
    weights: Vec<[f64; 2]>,
}

impl Radial {
    /// Exact to about `eps` for polynomials up to `degree`.
    pub(super) fn new(degree: usize, eps: f64) -> Self {
        let n = degree + 1;
        let rule = UnitRule::of(n);
        let mut projection = Vec::with_capacity(n * n);
        for (t, w) in rule.iter() {
            let (mut low, mut p) = (0.0, 1.0);
            for i in 0..n {
                let f = i as f64;
                projection.push((2.0 * f + 1.0) * w * p);
                let x = 2.0 * t - 1.0;
                (low, p) = (p, ((2.0 * f + 1.0) * x * p - f * low) / (f + 1.0));
            }
        }
        let functions = vec![Complex64::new(0.0, 0.0); n + 1];
        let digits = -(RECURRENCE_ACCURACY * eps).ln();
        let loss = (-f64::EPSILON.ln() - digits).max(LEAST_LOSS);
        // On Re z = −1 the ellipse with ϱ = e^{loss/n}, whose half axes are cosh and sinh of ln ϱ.
        let (wide, high) = ((loss / n as f64).cosh(), (loss / n as f64).sinh());
        let forward = (0.5 * high * (1.0 - 1.0 / (wide * wide)).sqrt()).min(FARTHEST_FORWARD);
        Self {
            rule,
            digits,
            forward,
            projection,
            functions,
            moments: vec![[0.0; 2]; n + 1],
            weights: vec![[0.0; 2]; n],
        }
    }

    /// Points on a ray.
    pub(super) fn len(&self) -> usize {
        self.weights.len()
    }

    /// t_j with [α_j, β_j] for η > 0.
    pub(super) fn at(&mut self, eta: f64) -> impl Iterator<Item = (f64, [f64; 2])> {
        self.second_kind(eta);
        self.integrals(eta);
        let n = self.weights.len();
        for (weight, row) in self.weights.iter_mut().zip(self.projection.chunks_exact(n)) {
            *weight = [0.0; 2];
            for (c, [a, b]) in row.iter().zip(&self.moments) {
                weight[0] += c * a;
                weight[1] += c * b;
            }
        }
        self.rule.nodes.iter().copied().zip(self.weights.iter().copied())
    }

    /// Q_i(−1 + 2𝚒η), i = 0..=n.
    fn second_kind(&mut self, eta: f64) {
        let z = Complex64::new(-1.0, 2.0 * eta);
        let n = self.functions.len() - 1;
        let inverse = 1.0 / eta;
        let first = Complex64::new(-0.25 * (inverse * inverse).ln_1p(), -0.5 * inverse.atan());
        self.functions[0] = first;
        if eta < self.forward {
            self.functions[1] = z * first - 1.0;
            for i in 1..n {
                let f = i as f64;
                let next = (z * self.functions[i]).scale(2.0 * f + 1.0) - self.functions[i - 1].scale(f);
                self.functions[i + 1] = next.scale(1.0 / (f + 1.0));
            }
            return;
        }
        let growth = ellipse(z).ln();
        // Any small value starts Miller's recurrence; the results are scaled to Q₀.
        let start = n + 1 + (self.digits / (2.0 * growth)) as usize;
        let (mut high, mut low) = (Complex64::new(0.0, 0.0), Complex64::new(1e-100, 0.0));
        for i in (1..=start).rev() {
            if i <= n {
                self.functions[i] = low;
            }
            let f = i as f64;
            let next = (z * low).scale(2.0 * f + 1.0) - high.scale(f + 1.0);
            (high, low) = (low, next.scale(1.0 / f));
        }
        let factor = first / low;
        self.functions[1..].iter_mut().for_each(|q| *q *= factor);
    }

    fn integrals(&mut self, eta: f64) {
        let z = Complex64::new(-1.0, 2.0 * eta);
        let size = 1.0 + eta * eta;
        let turn = Complex64::new(eta, -1.0).scale(1.0 / (eta * size));
        let n = self.functions.len() - 1;
        self.moments[0] = [0.5 / (eta * eta * size), 0.5 * ((1.0 / eta).atan() / eta - 1.0 / size)];
        for i in 1..=n {
            let d = (z * self.functions[i] - self.functions[i - 1]) * turn.scale(i as f64);
            self.moments[i] = [0.5 * d.im / eta, 0.5 * d.re - self.functions[i].im / eta];
        }
        if eta > 0.5 {
            for i in 0..n {
                let f = i as f64;
                let before = if i > 0 { self.moments[i - 1][0] } else { 0.0 };
                let neighbours = ((f + 1.0) * self.moments[i + 1][0] + f * before) / (2.0 * f + 1.0);
                self.moments[i][1] = 0.5 * (self.moments[i][0] + neighbours);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀¹ t^{k+1}/(t² + η²)² dt by t = η sinh μ and a fine Gauss rule, without recurrence or closed form.
    fn plain(eta: f64, k: i32) -> f64 {
        let top = (1.0 / eta).asinh();
        let pieces = top.ceil() as usize;
        let width = top / pieces as f64;
        let mut sum = 0.0;
        for piece in 0..pieces {
            for (x, w) in UnitRule::of(30).iter() {
                let mu = width * (piece as f64 + x);
                let t = eta * mu.sinh();
                sum += w * width * eta * mu.cosh() * t.powi(k + 1) / (eta * mu.cosh()).powi(4);
            }
        }
        sum
    }

    #[test]
    fn monomials_are_integrated_at_every_sharpness() {
        for (degree, eps) in
            [0, 1, 4, 8, 20].into_iter().flat_map(|d| [1e-2, 1e-5, 1e-9, 1e-14].map(|e| (d, e)))
        {
            let tolerance = 2e-13f64.max(0.01 * eps);
            let mut radial = Radial::new(degree, eps);
            for eta in [1e-9, 1e-6, 1e-3, 0.03, 0.1, 0.3, 0.49, 0.51, 1.0, 3.0, 40.0, 1e4] {
                let weights: Vec<_> = radial.at(eta).collect();
                for k in 0..=degree as i32 {
                    let [a, b] = weights.iter().fold([0.0; 2], |[a, b], (t, [alpha, beta])| {
                        [a + alpha * t.powi(k), b + beta * t.powi(k)]
                    });
                    let (first, second) = (plain(eta, 0), plain(eta, 1));
                    let (alpha, beta) = (plain(eta, k), plain(eta, k + 1));
                    assert!((a - alpha).abs() < tolerance * first, "A: {degree} {eta} {k}: {a} {alpha}");
                    assert!((b - beta).abs() < tolerance * second, "B: {degree} {eta} {k}: {b} {beta}");
                }
            }
        }
    }
}
