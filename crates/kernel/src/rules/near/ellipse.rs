//! Bernstein's ellipse through a point of the complex plane, which decides how fast Gauss rules converge.

use num_complex::Complex64;

/// ϱ = |z + √(z² − 1)| ≥ 1: the sum of the half axes of the ellipse with foci ±1 through z.
pub(super) fn ellipse(z: Complex64) -> f64 {
    let half = 0.5 * ((z - 1.0).norm() + (z + 1.0).norm());
    half + (half * half - 1.0).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ellipse_of_an_imaginary_point() {
        // z = i y lies on the ellipse of ϱ = y + √(1 + y²).
        assert!((ellipse(Complex64::new(0.0, 0.75)) - 2.0).abs() < 1e-15);
        assert_eq!(ellipse(Complex64::new(0.4, 0.0)), 1.0);
    }

    /// z = cosh(a + 𝚒b) lies on the ellipse of ϱ = eᵃ.
    #[test]
    fn ellipses_are_images_of_lines_under_cosh() {
        for (a, b) in [(0.01, 0.3), (0.5, -1.0), (2.0, 3.0), (40.0, 0.1)] {
            let z = Complex64::new(a, b).cosh();
            assert!((ellipse(z).ln() - a).abs() < 1e-12 / a.min(1.0), "{a} {b}");
        }
    }
}
