//! Polynomials in Bernstein form: p(x) = Σ bᵢ C(n, i) xⁱ (1 − x)ⁿ⁻ⁱ on [0, 1], bᵢ numbers or vectors.
//!
//! De Casteljau's scheme bᵢ ← (1 − x) bᵢ + x bᵢ₊₁ evaluates, differentiates and splits; it is stable because
//! for x ∈ [0, 1] it only forms weighted means. The polynomial lies in the convex hull of its coefficients.

use std::ops::{Add, Mul, Sub};

/// Coefficients: numbers and vectors.
pub(crate) trait Coefficient:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>> Coefficient for T {}

/// The Bernstein polynomials of degree N − 2 at `x`, and a last entry 0, for [`combine`].
pub(crate) fn weights<const N: usize>(x: f64) -> [f64; N] {
    let mut w = [0.0; N];
    w[0] = 1.0;
    for n in 1..N - 1 {
        for k in (1..=n).rev() {
            w[k] = (1.0 - x) * w[k] + x * w[k - 1];
        }
        w[0] *= 1.0 - x;
    }
    w
}

/// Value and derivative at `x` of the polynomial of degree N − 1 ≥ 1, with `w` = [`weights`] of x: the last
/// step of de Casteljau's scheme, whose two entries are the sums of b₀ … and b₁ … under the weights. Equal
/// coefficients have derivative 0 exactly.
pub(crate) fn combine<T: Coefficient, const N: usize>(b: &[T; N], w: &[f64; N], x: f64) -> (T, T) {
    let (mut low, mut high) = (b[0] * w[0], b[1] * w[0]);
    for k in 1..N - 1 {
        low = low + b[k] * w[k];
        high = high + b[k + 1] * w[k];
    }
    let step = high - low;
    (low + step * x, step * (N - 1) as f64)
}

/// Value and derivative at `x` of the polynomial of degree N − 1 ≥ 1.
pub(crate) fn evaluate<T: Coefficient, const N: usize>(b: &[T; N], x: f64) -> (T, T) {
    combine(b, &weights(x), x)
}

/// The coefficients on [0, x] and on [x, 1]; x outside [0, 1] extends the polynomial.
pub(crate) fn split<T: Coefficient, const N: usize>(b: &[T; N], x: f64) -> [[T; N]; 2] {
    let (mut left, mut right) = (*b, *b);
    for n in (0..N).rev() {
        left[N - 1 - n] = right[0];
        for k in 0..n {
            right[k] = right[k] + (right[k + 1] - right[k]) * x;
        }
    }
    [left, right]
}

/// The coefficients on [low, high], high ≥ 0.
pub(crate) fn restrict<T: Coefficient, const N: usize>(b: &[T; N], low: f64, high: f64) -> [T; N] {
    let [left, _] = split(b, high);
    split(&left, if high > 0.0 { low / high } else { 0.0 })[1]
}

/// Coefficients on [0, 1] of Σ cᵢ xⁱ: bⱼ = Σ_{i ≤ j} C(j, i)/C(n, i) cᵢ.
pub(crate) fn from_powers<const N: usize>(c: [f64; N]) -> [f64; N] {
    std::array::from_fn(|j| {
        let mut ratio = 1.0;
        let mut sum = 0.0;
        for (i, c) in c.iter().enumerate().take(j + 1) {
            sum += ratio * c;
            ratio *= (j - i) as f64 / (N - 1 - i).max(1) as f64;
        }
        sum
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_form_is_the_same_polynomial(
            c in prop::array::uniform4(-1.0..1.0), x in -0.1..1.1, low in 0.0..0.4, width in 0.1..0.6,
        ) {
            let value = |x: f64| c[0] + x * (c[1] + x * (c[2] + x * c[3]));
            let slope = |x: f64| c[1] + x * (2.0 * c[2] + x * 3.0 * c[3]);
            let b = from_powers(c);
            let (v, s) = evaluate(&b, x);
            prop_assert!((v - value(x)).abs() < 1e-14 && (s - slope(x)).abs() < 1e-13);
            let part = restrict(&b, low, low + width);
            prop_assert!((evaluate(&part, x).0 - value(low + x * width)).abs() < 1e-14);
            let [left, right] = split(&b, x);
            prop_assert!((left[3] - value(x)).abs() < 1e-14 && (right[0] - value(x)).abs() < 1e-14);
        }
    }
}
