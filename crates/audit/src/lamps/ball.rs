//! Points on the part of a ball that a point sees, even over its solid angle.
//!
//! From the distance d a ball of the radius R fills the cone of directions of at most θ₁ from its middle,
//!
//! ```text
//! sin θ₁ = R / d ,     cos θ = 1 − s (1 − cos θ₁) ,     p = 1 / (2π (1 − cos θ₁)) .
//! ```
//!
//! Reference: P. Shirley, C. Wang, K. Zimmerman, *Monte Carlo techniques for direct lighting calculations*, ACM
//! Trans. Graph. 15(1), 1996.

use std::f64::consts::TAU;

use radiosity_geom::{DVec3, Surface};

use super::on_lamp::OnLamp;

/// Distance, as a part of the radius, within which points on the ball are drawn by area: the cone is then nearly a
/// half-space, and its edge all rounding.
const NEAR: f64 = 1e-4;

/// A ball that shines outwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    center: DVec3,
    radius: f64,
}

impl Ball {
    /// The ball whose whole outside a surface is.
    pub(super) fn of(shape: &dyn Surface) -> Option<Self> {
        let (center, radius) = shape.ball()?;
        let jet = shape.jet(0.1, 0.1);
        (jet.normal.dot(jet.position - center) > 0.0).then_some(Self { center, radius })
    }

    /// 1 − cos θ₁ and the step from a point outside to the middle.
    fn cone(&self, from: DVec3) -> Option<(f64, DVec3)> {
        let step = self.center - from;
        let sine = self.radius / step.length();
        if sine * (1.0 + NEAR) >= 1.0 {
            return None;
        }
        // 1 − √(1 − s²) without cancellation.
        Some((sine * sine / (1.0 + (1.0 - sine * sine).sqrt()), step))
    }

    /// Density per solid angle of its points for a point; None where they are drawn by area.
    pub(super) fn density(&self, from: DVec3) -> Option<f64> {
        self.cone(from).map(|(opening, _)| (TAU * opening).recip())
    }

    /// The point of two draws for a point; None where it is to be drawn by area.
    pub(super) fn point(&self, [s, t]: [f64; 2], from: DVec3) -> Option<OnLamp> {
        let (opening, step) = self.cone(from)?;
        let distance = step.length();
        let axis = step / distance;
        let (x, y) = axis.any_orthonormal_pair();
        let fall = s * opening;
        let (cosine, sine) = (1.0 - fall, (fall * (2.0 - fall)).sqrt());
        let (sin, cos) = (TAU * t).sin_cos();
        let along = sine * (cos * x + sin * y) + cosine * axis;
        // The nearer root of |from + t along − center| = R.
        let inner = (self.radius * self.radius - (distance * sine).powi(2)).max(0.0).sqrt();
        let point = from + (distance * cosine - inner) * along;
        Some(OnLamp { point, parameters: [0.0; 2], along, density: (TAU * opening).recip() })
    }
}
