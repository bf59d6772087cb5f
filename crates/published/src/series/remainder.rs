//! Remainder of a series cut after order N: a bound of the powers left out.
//!
//! ```text
//! |C_n⁽²⁾(cos θ)| ≤ Ξ_n = min( T_n , (n + 1 + 1/sin θ)/(2 sin²θ) ) ,    T_n = (n + 1)(n + 2)(n + 3)/6
//! |φ_n| ≤ Σ_{k≤M} |N_k| Ξ_{n−k} qⁿ⁻ᵏ =: b_n ,    q = √B
//! |Σ_{n>N} φ_n tⁿ| ≤ b_{N+1} |t|^{N+1} Σ_k hᵏ T_{m+k}/T_m ,    h = q |t| < 1 ,  m = max(N + 1 − M, 0)
//! ```
//!
//! M is the degree of the numerator. The second bound of C_n⁽²⁾ is that of its closed form [sin((n+1)θ)/sin θ −
//! (n+1) cos((n+2)θ)]/(2 sin²θ). All ratios Ξ_{n+k}/Ξ_n are at most T_{m+k}/T_m. Indices below zero count as
//! zero. The last sum has a closed form of positive terms, by Vandermonde's identity: Σ_k C(m+3+k, 3) hᵏ =
//! Σ_{j≤3} C(m+3, 3−j) hʲ/(1−h)^{j+1}.

/// Ξ_n for sin²θ.
#[inline(always)]
pub(crate) fn gegenbauer_bound(n: usize, sine2: f64) -> f64 {
    let n = n as f64;
    let everywhere = (n + 1.0) * (n + 2.0) * (n + 3.0) / 6.0;
    let aside = (n + 1.0 + 1.0 / sine2.sqrt()) / (2.0 * sine2);
    everywhere.min(aside)
}

/// Σ_k hᵏ T_{m+k}/T_m for the terms above order `orders`, with a numerator of this degree; infinite for h ≥
/// 1.
pub(crate) fn tail(orders: usize, degree: usize, h: f64) -> f64 {
    if h.is_nan() || h >= 1.0 {
        return f64::INFINITY;
    }
    let m = (orders + 1).saturating_sub(degree) as f64;
    let x = 1.0 / (1.0 - h);
    let z = h * x;
    let [one, two, three] = [m + 3.0, (m + 3.0) * (m + 2.0) / 2.0, (m + 3.0) * (m + 2.0) * (m + 1.0) / 6.0];
    x * (three + z * (two + z * (one + z))) / three
}
