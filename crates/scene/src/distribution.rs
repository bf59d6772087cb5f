//! Distributions of the intensity of luminaires over directions.
//!
//! With the angle γ from the aim of the luminaire, the relative intensity d and the flux factor Ω = ∫ d dω
//! are
//!
//! ```text
//! point             d = 1                                            Ω = 4π
//! spot, exponent n  d = cosⁿ γ for γ < 90°, else 0                   Ω = 2π / (n + 1)
//! spot, angle       d = 1 for γ ≤ γ₀, 0 for γ ≥ γ₁, between them     Ω = 2π (1 − (c₀ + c₁)/2 · (1 − 1/(1 − k²)))
//!                   d = (1 + cos k(γ − γ₀))/2, k = π/(γ₁ − γ₀)
//! table             d = I in cd, as a photometric file states it      Ω = ∫ I dω = its flux in lm
//! ```
//!
//! with c = cos γ, γ₀ and γ₁ half the angle less and plus half the edge, so that d = ½ at half the angle. The
//! intensity is I = s d with the strength s of each band (W/sr, or cd where exitance is in lm/m²; without a
//! unit for tables), the flux Φ = s Ω.
//!
//! The frame of a luminaire is that of photometric files ([`radiosity_photometry`]): it aims along −z, the
//! plane C = 0 contains x.

use std::f64::consts::PI;
use std::sync::Arc;

use radiosity_geom::{DVec3, ROUNDING};
use radiosity_photometry::Photometry;

use crate::{fault::Fault, ranges::check_range};

/// Largest exponent: half of the peak is left at 0.7°. Chosen.
const STEEPEST: f64 = 1e4;

/// A distribution of relative intensity over directions.
#[derive(Clone, Debug, PartialEq)]
pub enum Distribution {
    /// Equal intensity in all directions.
    Point,
    /// A power of the cosine.
    Power {
        /// Exponent n ≥ 0; 1 is that of a small flat diffuse emitter.
        exponent: f64,
    },
    /// A cone with an edge.
    Cone {
        /// Angle across the cone within which more than half the peak is sent, degrees.
        angle: f64,
        /// Angle over which the peak falls to nothing, degrees.
        edge: f64,
    },
    /// A table of luminous intensities.
    Table(Arc<Photometry>),
}

/// The directions on one side of a plane across the aim.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hemisphere {
    /// The part of Ω in these directions (sr; lm for a table).
    pub flux_factor: f64,
    /// The angle (degrees) over which the largest d would fall to nothing as steeply as d changes anywhere in
    /// these directions; 0 where d jumps.
    pub scale: f64,
}

impl Distribution {
    /// Checks the ranges of exponent, angle and edge.
    ///
    /// # Errors
    /// A number that is not finite or out of range.
    pub fn check(&self) -> Result<(), Fault> {
        match *self {
            Self::Point | Self::Table(_) => Ok(()),
            Self::Power { exponent } => check_range(
                exponent,
                (0.0..=STEEPEST).contains(&exponent),
                "the exponent",
                "0 ≤ exponent ≤ 10000",
            ),
            Self::Cone { angle, edge } => {
                check_range(angle, angle > 0.0 && angle < 360.0, "the angle", "0 < angle < 360 degrees")?;
                let widest = angle.min(360.0 - angle).min(179.0);
                let range = "0 ≤ edge ≤ angle, 360 − angle and 179 degrees";
                check_range(edge, (0.0..=widest).contains(&edge), "the edge", range)
            }
        }
    }

    /// Relative intensity d in a unit direction of the frame of the luminaire.
    pub(crate) fn relative(&self, direction: DVec3) -> f64 {
        let cosine = -direction.z;
        match *self {
            Self::Point => 1.0,
            Self::Power { exponent } if cosine > 0.0 => cosine.powf(exponent),
            Self::Power { .. } => 0.0,
            Self::Cone { angle, edge } => {
                let [inner, outer] = ends(angle, edge);
                match direction.truncate().length().atan2(cosine) {
                    gamma if gamma <= inner => 1.0,
                    gamma if gamma >= outer => 0.0,
                    gamma => 0.5 * (1.0 + (PI * (gamma - inner) / (outer - inner)).cos()),
                }
            }
            Self::Table(ref table) => table.intensity(direction),
        }
    }

    /// Largest relative intensity d (1; cd for a table).
    pub fn peak(&self) -> f64 {
        match self {
            Self::Table(table) => table.largest(),
            _ => 1.0,
        }
    }

    /// Flux factor Ω (sr; lm for a table).
    pub fn flux_factor(&self) -> f64 {
        self.flux_between(0.0, 180.0)
    }

    /// The part of Ω (sr; lm for a table) at angles γ from `least` to `most`, degrees.
    fn flux_between(&self, least: f64, most: f64) -> f64 {
        if let Self::Table(table) = self {
            return table.flux_between(least, most);
        }
        2.0 * PI * (self.antiderivative(most.to_radians()) - self.antiderivative(least.to_radians()))
    }

    /// The hemispheres along the aim and against it; none that is dark.
    pub(crate) fn hemispheres(&self) -> [Option<Hemisphere>; 2] {
        let dark = ROUNDING * self.flux_factor();
        [(0.0, 90.0), (90.0, 180.0)].map(|(least, most)| {
            let (flux_factor, scale) = (self.flux_between(least, most), self.scale(least, most));
            (flux_factor > dark).then_some(Hemisphere { flux_factor, scale })
        })
    }

    /// An antiderivative of d sin γ; of tables 0.
    fn antiderivative(&self, gamma: f64) -> f64 {
        match *self {
            Self::Table(_) => 0.0,
            Self::Point => -gamma.cos(),
            Self::Power { exponent } => -gamma.cos().max(0.0).powf(exponent + 1.0) / (exponent + 1.0),
            Self::Cone { angle, edge } => {
                let [inner, outer] = ends(angle, edge);
                let fallen =
                    if outer > inner { along_edge(gamma.clamp(inner, outer), inner, outer) } else { 0.0 };
                fallen - gamma.min(inner).cos()
            }
        }
    }

    /// Least and greatest d at angles of at most `within` from the angle `gamma`, degrees; bounds of a table.
    pub(crate) fn range(&self, gamma: f64, within: f64) -> [f64; 2] {
        let (nearest, farthest) = ((gamma - within).max(0.0), (gamma + within).min(180.0));
        match self {
            Self::Table(table) => table.web.range(nearest, farthest),
            // All others fall with γ.
            _ => [farthest, nearest].map(|gamma| {
                let (sin, cos) = gamma.to_radians().sin_cos();
                self.relative(DVec3::new(sin, 0.0, -cos))
            }),
        }
    }

    /// The angle, degrees, over which the largest d would fall to nothing as steeply as d changes anywhere at
    /// angles γ from `least` to `most`, degrees; 0 where d jumps.
    fn scale(&self, least: f64, most: f64) -> f64 {
        match *self {
            Self::Table(ref table) => table.web.scale(least, most),
            Self::Point => f64::INFINITY,
            // n cosⁿ⁻¹ γ sin γ is greatest where sin² γ = 1/n.
            Self::Power { exponent } => {
                let n = exponent.max(1.0);
                (n.sqrt() * ((n - 1.0) / n).powf(0.5 * (n - 1.0))).recip().to_degrees()
            }
            Self::Cone { edge, .. } => 2.0 * edge / PI,
        }
    }
}

/// The integral ∫ (1 + cos k(γ − γ₀))/2 sin γ dγ from γ₀ to γ, k = π/(γ₁ − γ₀) > 1.
fn along_edge(gamma: f64, inner: f64, outer: f64) -> f64 {
    let k = PI / (outer - inner);
    let wave = |gamma: f64| {
        ((1.0 + k) * gamma - k * inner).cos() / (1.0 + k) + ((1.0 - k) * gamma + k * inner).cos() / (1.0 - k)
    };
    let whole = |gamma: f64| -0.5 * gamma.cos() - 0.25 * wave(gamma);
    whole(gamma) - whole(inner)
}

/// Angles γ₀ and γ₁ (radians) between which a cone falls to nothing, for its angle and edge in degrees.
fn ends(angle: f64, edge: f64) -> [f64; 2] {
    [0.5 * (angle - edge), 0.5 * (angle + edge)].map(f64::to_radians)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2π ∫ d sin γ dγ between angles in degrees by the midpoint rule of so many steps.
    fn integral(distribution: &Distribution, limits: [f64; 2], steps: usize) -> f64 {
        let [least, most] = limits.map(f64::to_radians);
        let step = (most - least) / steps as f64;
        let at = |k: usize| {
            let gamma = least + (k as f64 + 0.5) * step;
            distribution.relative(DVec3::new(gamma.sin(), 0.0, -gamma.cos())) * gamma.sin()
        };
        2.0 * PI * step * (0..steps).map(at).sum::<f64>()
    }

    #[test]
    fn the_flux_is_the_integral_of_the_intensity() {
        let powers = [0.0, 1.0, 2.5, 40.0].map(|exponent| Distribution::Power { exponent });
        let cones = [(40.0, 0.0), (40.0, 5.0), (40.0, 40.0), (200.0, 60.0), (180.0, 179.0), (300.0, 60.0)];
        let cones = cones.map(|(angle, edge)| Distribution::Cone { angle, edge });
        for distribution in powers.into_iter().chain(cones).chain([Distribution::Point]) {
            distribution.check().expect("a distribution");
            let parts = [[0.0, 90.0], [90.0, 180.0], [0.0, 180.0], [31.0, 77.0]];
            for [least, most] in parts {
                let (closed, numeric) =
                    (distribution.flux_between(least, most), integral(&distribution, [least, most], 1 << 20));
                assert!((closed - numeric).abs() < 1e-5, "{distribution:?}: {closed} {numeric}");
            }
        }
    }
}
