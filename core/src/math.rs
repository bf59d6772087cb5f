//! The elementary functions this crate uses.
//!
//! Everything a table may need is a `const fn`, so that a rule computed by the compiler and one computed at
//! run time go through the same operations and agree bit for bit. None of the float methods of std is used.

use crate::double::Double;

pub(crate) use libm::sqrt;

/// √v for v = 0 or positive and normal, within 0.51 ulp; a dozen times slower than [`sqrt`], and `const`.
pub(crate) const fn const_sqrt(v: f64) -> f64 {
    Double::new(v).sqrt().hi
}

/// The octant t ∈ [0, π/4] → (sin t, cos t), each within 1 ulp.
///
/// Taylor polynomials of degree 17 and 16; the first neglected terms are below 2⁻⁶⁰.
#[inline(always)]
pub(crate) const fn sin_cos_octant(t: f64) -> (f64, f64) {
    let q = t * t;
    (t + t * q * horner(q, &SINE), 1.0 - q * (0.5 - q * horner(q, &COSINE)))
}

/// sin φ for φ ∈ [0, π/2].
#[inline(always)]
pub(crate) const fn sin_quadrant(phi: f64) -> f64 {
    let (sin, cos) = sin_cos_octant(0.5 * phi);
    2.0 * sin * cos
}

/// c₀ + q (c₁ + q (c₂ + …)).
#[inline(always)]
pub(crate) const fn horner<const N: usize>(q: f64, c: &[f64; N]) -> f64 {
    let mut sum = c[N - 1];
    let mut k = N - 1;
    while k > 0 {
        k -= 1;
        sum = c[k] + q * sum;
    }
    sum
}

/// (−1)ᵏ⁺¹/(2k+3)!: sin t = t + t³ Σ `SINE[k]` t²ᵏ.
const SINE: [f64; 8] = factorials::<8>(3, -1.0);

/// (−1)ᵏ/(2k+4)!: cos t = 1 − t²/2 + t⁴ Σ `COSINE[k]` t²ᵏ.
const COSINE: [f64; 7] = factorials::<7>(4, 1.0);

/// ±1/first!, ∓1/(first+2)!, …
const fn factorials<const N: usize>(first: usize, sign: f64) -> [f64; N] {
    let mut factorial = 1.0;
    let mut j = 2;
    while j <= first {
        factorial *= j as f64;
        j += 1;
    }
    let mut out = [0.0; N];
    let mut sign = sign;
    let mut k = 0;
    while k < N {
        out[k] = sign / factorial;
        sign = -sign;
        factorial *= ((first + 2 * k + 1) * (first + 2 * k + 2)) as f64;
        k += 1;
    }
    out
}
