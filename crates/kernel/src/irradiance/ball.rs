//! Irradiance at a point outside a ball of even exitance, without blockers.
//!
//! ```text
//! F = c/h²                                                            all of the ball above the horizon, c h ≥ 1 ;
//! F = (c arccos y − x s √(1 − y²))/(π h²) + arctan(s √(1 − y²)/x)/π    the horizon through it, |c h| < 1 ;
//! F = 0                                                               else ,
//!
//! h = d/r ,   x = √(h² − 1) ,   y = −x c/s ,
//! ```
//!
//! with the radius r, the distance d of the centre, and the cosine c and sine s of the angle between it and
//! the normal. 0 ≤ F ≤ 1.
//!
//! References: J. M. Snyder, *Area light sources for real-time graphics*, Microsoft Research MSR-TR-96-11
//! (1996); S. Lagarde, C. de Rousiers, *Moving Frostbite to physically based rendering*, SIGGRAPH 2014 course
//! notes.

use std::f64::consts::FRAC_1_PI;

use radiosity_geom::{DVec3, ROUNDING};

/// Irradiance at `x` with the unit normal `n` from a ball of exitance 1 about `center`; None inside it
/// and on it.
pub fn ball(x: DVec3, n: DVec3, center: DVec3, radius: f64) -> Option<f64> {
    let step = center - x;
    let distance = step.length();
    let h = distance / radius;
    if h <= 1.0 + ROUNDING {
        return None;
    }
    let c = step.dot(n) / distance;
    if c * h >= 1.0 {
        return Some(c / (h * h));
    }
    if c * h <= -1.0 {
        return Some(0.0);
    }
    let (s, x) = ((1.0 - c * c).sqrt(), (h * h - 1.0).sqrt());
    let y = (-x * c / s).clamp(-1.0, 1.0);
    let w = s * (1.0 - y * y).sqrt();
    Some(FRAC_1_PI * ((c * y.acos() - x * w) / (h * h) + (w / x).atan()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ max(0, n · ω) dω / π over the cone of directions that meet the ball, by the midpoint rule.
    fn by_directions(n: DVec3, center: DVec3, radius: f64) -> f64 {
        const RINGS: usize = 400;
        let (axis, sine) = (center.normalize(), radius / center.length());
        let (a, b) = axis.any_orthonormal_pair();
        let mut sum = 0.0;
        for ring in 0..RINGS {
            // Even steps of 1 − cos θ are even steps of the solid angle.
            let part = (ring as f64 + 0.5) / RINGS as f64;
            let cosine = 1.0 - part * (1.0 - (1.0 - sine * sine).sqrt());
            for turn in 0..RINGS {
                let (s, c) = (std::f64::consts::TAU * turn as f64 / RINGS as f64).sin_cos();
                let direction = cosine * axis + (1.0 - cosine * cosine).sqrt() * (c * a + s * b);
                sum += direction.dot(n).max(0.0);
            }
        }
        2.0 * (1.0 - (1.0 - sine * sine).sqrt()) * sum / (RINGS * RINGS) as f64
    }

    #[test]
    fn it_is_the_integral_over_directions() {
        for degrees in [0.0_f64, 40.0, 75.0, 90.0, 110.0, 130.0] {
            for distance in [1.05, 1.5, 4.0] {
                let (s, c) = degrees.to_radians().sin_cos();
                let center = distance * DVec3::new(s, 0.0, c);
                let found = ball(DVec3::ZERO, DVec3::Z, center, 1.0).expect("outside");
                let exact = by_directions(DVec3::Z, center, 1.0);
                assert!(
                    (found - exact).abs() < 2e-4 * exact.max(0.1),
                    "{degrees}° {distance}: {found} {exact}"
                );
            }
        }
        assert_eq!(ball(DVec3::ZERO, DVec3::Z, 0.5 * DVec3::Z, 1.0), None);
    }
}
