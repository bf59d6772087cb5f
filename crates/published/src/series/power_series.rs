//! Power series of quotients by the square of 1 + A p + B p².
//!
//! ```text
//! (1 + A p + B p²)⁻² = Σ ξ_n pⁿ ,   A = 2α/r² ,  B = β/r² ,   ξ_n = C_n⁽²⁾(−α/(√β r)) (√β/r)ⁿ
//! ξ₀ = 1 ,   n r² ξ_n = −(2(n + 1) α ξ_{n−1} + (n + 2) β ξ_{n−2})
//! ```
//!
//! with Gegenbauer's polynomials C⁽²⁾; the recurrence follows from (1 + Ap + Bp²) f′ + 2(A + 2Bp) f = 0. With
//! a numerator N₀ + N₁p + … the quotient follows from two synthetic divisions,
//!
//! ```text
//! w_n = N_n − A w_{n−1} − B w_{n−2} ,     φ_n = w_n − A φ_{n−1} − B φ_{n−2} ,
//! ```
//!
//! four multiplications and additions per order, without a division. Both forms are stable for every angle,
//! α = 0 included (ξ_{2m} = (−1)ᵐ (m + 1) Bᵐ, odd terms zero). They converge for |p| √β < r.
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.1 and 18.12.4 (λ = 2).

/// Writes ξ_0 … ξ_{m−1}, m = `out.len()`, for α = d·r, β = d² and `r2` = r² > 0.
pub fn inverse_square(alpha: f64, beta: f64, r2: f64, out: &mut [f64]) {
    let (mut before, mut last) = (0.0, 1.0);
    for (n, xi) in out.iter_mut().enumerate() {
        if n > 0 {
            let n = n as f64;
            let next = -(2.0 * (n + 1.0) * alpha * last + (n + 2.0) * beta * before) / (n * r2);
            (before, last) = (last, next);
        }
        *xi = last;
    }
}

/// Writes φ_0 … φ_{m−1} of (N₀ + N₁p + …)/(1 + A p + B p²)², m = `out.len()`, M terms above, for W quotients
/// side by side.
#[inline]
pub(super) fn quotient<const W: usize, const M: usize>(
    numerator: &[[f64; W]; M],
    a: &[f64; W],
    b: &[f64; W],
    out: &mut [[f64; W]],
) {
    let zero = [0.0; W];
    let (mut once_before, mut once, mut twice_before, mut twice) = (zero, zero, zero, zero);
    for (n, phi) in out.iter_mut().enumerate() {
        let given = numerator.get(n).unwrap_or(&zero);
        for lane in 0..W {
            let w = given[lane] - a[lane] * once[lane] - b[lane] * once_before[lane];
            (once_before[lane], once[lane]) = (once[lane], w);
            let value = w - a[lane] * twice[lane] - b[lane] * twice_before[lane];
            (twice_before[lane], twice[lane]) = (twice[lane], value);
            phi[lane] = value;
        }
    }
}
