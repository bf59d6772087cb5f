//! Chance: laws of sums whose errors are themselves estimated.
//!
//! Sums of unequal squares are about those of h equal ones, and their s² have 7 h degrees of freedom,
//!
//! ```text
//! h = (Σ s_i²)² / Σ s_i⁴ ,     Σ d_i² / Σ s_i² ~ F(h, 7 h) ,     Σ d_i / √(Σ s_i²) ~ Student's t of 7 h
//! ```
//!
//! (F. Satterthwaite, Biometrics Bull. 2, 1946). What is as seldom by chance as three standard errors of a normal
//! number, or as many more as there are things to choose from, is a finding.

use crate::effort::Effort;

/// Degrees of freedom of s².
pub(crate) const FREEDOM: f64 = Effort::SHIFTS as f64 - 1.0;

/// Standard errors beyond which something is a finding, of one thing that is looked at: by chance one in 700.
pub(crate) const FINDING: f64 = 3.0;

/// The normal number that is exceeded as seldom as t of Student's distribution of ν degrees of freedom (D. Wallace,
/// Ann. Math. Stat. 30, 1959).
pub(crate) fn normal_of_student(t: f64, freedom: f64) -> f64 {
    let size = (freedom * (t * t / freedom).ln_1p()).sqrt();
    (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) * size.copysign(t)
}

/// The t of Student's distribution of ν degrees of freedom that is exceeded as seldom as a normal number: the inverse
/// of [`normal_of_student`].
pub(crate) fn student_of_normal(normal: f64, freedom: f64) -> f64 {
    let size = (8.0 * freedom + 3.0) / (8.0 * freedom + 1.0) * normal;
    (freedom * (size * size / freedom).exp_m1()).sqrt().copysign(normal)
}

/// The normal number that is exceeded as seldom as a ratio of F(ν₁, ν₂) (E. Paulson, Ann. Math. Stat. 13, 1942).
pub(crate) fn normal_of_ratio(ratio: f64, above: f64, below: f64) -> f64 {
    let [above, below] = [above, below].map(|freedom| 2.0 / (9.0 * freedom));
    let root = ratio.max(0.0).cbrt();
    ((1.0 - below) * root - (1.0 - above)) / (below * root * root + above).sqrt()
}

/// Standard errors that the largest of `count` means exceeds as seldom by chance as one exceeds three.
pub(crate) fn threshold(count: usize) -> f64 {
    // P(|z| > x) ≈ √(2/π) e^(−x²/2) / x; solved for P = 0.0027 / count by iteration.
    let wanted = 0.0027 / count.max(1) as f64;
    let mut x = FINDING;
    for _ in 0..50 {
        x = (2.0 * ((2.0 / std::f64::consts::PI).sqrt() / (x * wanted)).ln()).max(1.0).sqrt();
    }
    x.max(FINDING)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Student's t of seven degrees of freedom exceeds 4.52997 as seldom as a normal number exceeds 3, by the integrals
    /// of both.
    #[test]
    fn seven_degrees_of_freedom_exceed_more_as_seldom() {
        let student = student_of_normal(FINDING, FREEDOM);
        assert!((student / 4.52997 - 1.0).abs() < 0.01, "{student}");
        assert!((normal_of_student(student, FREEDOM) / FINDING - 1.0).abs() < 1e-14);
    }
}
