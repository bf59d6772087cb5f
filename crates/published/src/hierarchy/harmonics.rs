//! Real spherical harmonics of degree l ≤ 2, and the clamped cosine in them.
//!
//! ```text
//! max(0, n·ω) = Σ_lm A_l Y_lm(n) Y_lm(ω) ,     A₀ = π , A₁ = 2π/3 , A₂ = π/4 , A₃ = 0 , A₄ = −π/24 , …
//! ```
//!
//! Cut off after l = 2 the sum is ¼ + ½ t + 5/32 (3 t² − 1) of t = n·ω: its greatest error is 1/16, at
//! t = ±1, and its least value −0.0396. Reference: R. Ramamoorthi, P. Hanrahan, *On the relationship between
//! radiance and irradiance*, JOSA A 18 (2001), eq. 19.

use std::f64::consts::PI;

use radiosity_geom::DVec3;

/// Number of harmonics with l ≤ 2.
pub const HARMONICS: usize = 9;

/// A_l of each harmonic.
const COSINE: [f64; HARMONICS] = {
    let (one, two) = (2.0 * PI / 3.0, PI / 4.0);
    [PI, one, one, one, two, two, two, two, two]
};

/// Y_lm of a unit vector, in the order (0,0), (1,−1), (1,0), (1,1), (2,−2), …, (2,2); orthonormal on the
/// sphere.
pub fn harmonics(DVec3 { x, y, z }: DVec3) -> [f64; HARMONICS] {
    let (zero, one) = ((0.25 / PI).sqrt(), (0.75 / PI).sqrt());
    let (two, axial) = ((3.75 / PI).sqrt(), (0.3125 / PI).sqrt());
    [
        zero,
        one * y,
        one * z,
        one * x,
        two * x * y,
        two * y * z,
        axial * (3.0 * z * z - 1.0),
        two * x * z,
        0.5 * two * (x * x - y * y),
    ]
}

/// A_l Y_lm(n): the coefficients of max(0, n·ω) for a unit vector n.
pub fn clamped_cosine(n: DVec3) -> [f64; HARMONICS] {
    let values = harmonics(n);
    std::array::from_fn(|k| COSINE[k] * values[k])
}

/// y += factor · x.
pub(crate) fn add(y: &mut [f64; HARMONICS], factor: f64, x: &[f64; HARMONICS]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += factor * x);
}
