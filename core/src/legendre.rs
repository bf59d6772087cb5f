//! Orthonormal Legendre polynomials p_n = √(n + ½) P_n: ∫₋₁¹ p_m p_n dx = δ_mn, p_n(1) > 0.
//!
//! Values at single points come from the recurrence of differences anchored at the nearer end,
//!
//!   y = 1 − |x|,  R₀ = 1,  D₀ = 0,  D_{k+1} = (k D_k − (2k + 1) y R_k)/(k + 1),  R_{k+1} = R_k + D_{k+1},
//!
//! where R_k = P_k(|x|). It is exact at the ends, where the three-term recurrence loses n² ulp.

/// Writes p_0(x) … p_{m−1}(x), m = `out.len()`, for x ∈ [−1, 1].
pub fn orthonormal(x: f64, out: &mut [f64]) {
    let y = 1.0 - x.abs();
    let (mut value, mut difference) = (1.0, 0.0);
    for (k, p) in out.iter_mut().enumerate() {
        let degree = k as f64;
        let sign = if x < 0.0 && k % 2 == 1 { -1.0 } else { 1.0 };
        *p = sign * libm::sqrt(degree + 0.5) * value;
        difference = (degree * difference - (2.0 * degree + 1.0) * y * value) / (degree + 1.0);
        value += difference;
    }
}
