//! Harmonic functions: cosines over a whole surface, even across its sides.
//!
//! ```text
//! f_ij(u, v) = cos(i π u′) cos(j π v′) ,     u′ = (u + 1)/2 ,  v′ = (v + 1)/2 ∈ [0, 1]
//! ```
//!
//! with i + j ≤ N, or i, j ≤ N. On a surface of constant area element and area A they are orthogonal, ∫ f_ij²
//! dA = A, A/2 or A/4 for none, one or two of i and j above 0. A function of slope ≠ 0 at a side, mirrored
//! there, has a kink: its coefficients fall like 1/i², and the error of the best sum in L² like N^(−3/2) in
//! each direction. Elementwise polynomials have no such limit.

use std::f64::consts::FRAC_PI_2;

use radiosity_elements::space::Space;

use super::functions::SurfaceFunctions;

/// Cosines up to a degree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cosines {
    space: Space,
    degree: usize,
}

impl Cosines {
    /// Cosines of i + j ≤ `degree`, or of i, j ≤ `degree`, in the order of `space`.
    pub(super) fn new(space: Space, degree: usize) -> Self {
        Self { space, degree }
    }
}

impl SurfaceFunctions for Cosines {
    fn count(&self) -> usize {
        self.space.count(self.degree)
    }

    fn values(&self, parameters: [f64; 2], out: &mut [f64]) {
        let cosine = |degree: usize, x: f64| (degree as f64 * FRAC_PI_2 * (x + 1.0)).cos();
        for (k, out) in out.iter_mut().enumerate() {
            let (i, j) = self.space.degrees(self.degree, k);
            *out = cosine(i, parameters[0]) * cosine(j, parameters[1]);
        }
    }
}
