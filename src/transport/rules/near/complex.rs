//! Complex numbers, with the operations that convergence rates and radial weights need.

use core::ops::{Add, Mul, Sub};

/// re + i im.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Complex {
    pub(super) const ONE: Self = Self::new(1.0, 0.0);

    pub(super) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    pub(super) fn scale(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    pub(super) fn abs(self) -> f64 {
        (self.re * self.re + self.im * self.im).sqrt()
    }

    pub(super) fn over(self, other: Self) -> Self {
        let square = other.re * other.re + other.im * other.im;
        (self * Self::new(other.re, -other.im)).scale(1.0 / square)
    }

    /// The square root with a non-negative real part.
    pub(super) fn sqrt(self) -> Self {
        let size = self.abs();
        let re = (0.5 * (size + self.re)).max(0.0).sqrt();
        let im = (0.5 * (size - self.re)).max(0.0).sqrt();
        Self::new(re, if self.im < 0.0 { -im } else { im })
    }

    /// Principal inverse of sinh.
    pub(super) fn asinh(self) -> Self {
        // sinh is odd; with a non-negative real part the sum below does not cancel.
        if self.re < 0.0 {
            let mirrored = self.scale(-1.0).asinh();
            return mirrored.scale(-1.0);
        }
        let sum = self + (self * self + Self::ONE).sqrt();
        Self::new(sum.abs().ln(), sum.im.atan2(sum.re))
    }

    /// ϱ = |z + √(z² − 1)| ≥ 1: the sum of the half axes of the ellipse with foci ±1 through z.
    pub(super) fn ellipse(self) -> f64 {
        let half = 0.5 * ((self - Self::ONE).abs() + (self + Self::ONE).abs());
        half + (half * half - 1.0).max(0.0).sqrt()
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn asinh_inverts_sinh() {
        for (a, b) in [(0.3, 0.2), (-1.5, 1.4), (8.0, -0.7), (0.0, 1.5)] {
            let w = Complex::new(f64::sinh(a) * f64::cos(b), f64::cosh(a) * f64::sin(b));
            assert!((w.asinh() - Complex::new(a, b)).abs() < 1e-13, "{a} {b}");
        }
    }

    #[test]
    fn ellipse_of_an_imaginary_point() {
        // z = i y lies on the ellipse of ϱ = y + √(1 + y²).
        assert!((Complex::new(0.0, 0.75).ellipse() - 2.0).abs() < 1e-15);
        assert_eq!(Complex::new(0.4, 0.0).ellipse(), 1.0);
    }
}
