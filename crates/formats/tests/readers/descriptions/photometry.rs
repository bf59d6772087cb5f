//! Luminaires: intensities and flux of photometric tables, and both formats, right, odd and broken.

mod texts;
mod flux;
mod ies;
mod eulumdat;
mod mutations;

use glam::DVec3;

/// The direction at angles C and γ in degrees.
fn direction(c: f64, gamma: f64) -> DVec3 {
    let (c, gamma) = (c.to_radians(), gamma.to_radians());
    DVec3::new(gamma.sin() * c.cos(), gamma.sin() * c.sin(), -gamma.cos())
}
