//! Glass: how much light panes let through, by the angle of incidence.
//!
//! At a surface of glass of the index n, light that comes in at θ goes on at θ′, sin θ = n sin θ′, and the
//! parts r of either polarisation are reflected (Fresnel):
//!
//! ```text
//! r_⊥ = ((cos θ − n cos θ′) / (cos θ + n cos θ′))² ,     r_∥ = ((n cos θ − cos θ′) / (n cos θ + cos θ′))²
//! ```
//!
//! N panes with all reflections between their 2 N surfaces let through
//!
//! ```text
//! τ = ½ Σ_⊥,∥ (1 − r) / (1 + (2 N − 1) r) · a^(1 / cos θ′)
//! ```
//!
//! where a is what the glass itself, along the normal, does not absorb: 1, or such that τ(0) is the
//! transmittance stated.
//!
//! Reference: J. Duffie, W. Beckman, *Solar Engineering of Thermal Processes*, 4th ed., sections 5.1 to 5.3.

use crate::{fault::Fault, ranges::check_range};

/// Panes of glass, one after the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    panes: u32,
    index: f64,
    /// Transmittance a of the glass itself along the normal, without reflections, 0 < a ≤ 1.
    clear: f64,
}

impl Glass {
    /// 1 to 4 panes of the index n, 1 ≤ n ≤ 3, which let through the part `transmittance` of what comes along
    /// the normal, or all but what is reflected.
    ///
    /// # Errors
    /// A number that is out of range or not finite.
    pub fn new(panes: u32, index: f64, transmittance: Option<f64>) -> Result<Self, Fault> {
        check_range(f64::from(panes), (1..=4).contains(&panes), "the number of panes", "1 ≤ panes ≤ 4")?;
        check_range(index, (1.0..=3.0).contains(&index), "the index of refraction", "1 ≤ index ≤ 3")?;
        let clear = Self { panes, index, clear: 1.0 };
        let Some(transmittance) = transmittance else { return Ok(clear) };
        let share = transmittance / clear.transmittance(1.0);
        let range =
            "0 < transmittance ≤ what is not reflected: 0.918 of one pane, 0.849 of two, of index 1.52";
        check_range(transmittance, share > 0.0 && share <= 1.0, "the transmittance", range)?;
        Ok(Self { clear: share, ..clear })
    }

    /// Transmittance τ at the cosine of the angle of incidence; 0 from behind.
    pub(crate) fn transmittance(&self, cosine: f64) -> f64 {
        if cosine <= 0.0 {
            return 0.0;
        }
        let n = self.index;
        let within = (1.0 - (1.0 - cosine * cosine).max(0.0) / (n * n)).sqrt();
        let across = ((cosine - n * within) / (cosine + n * within)).powi(2);
        let along = ((n * cosine - within) / (n * cosine + within)).powi(2);
        let surfaces = f64::from(2 * self.panes - 1);
        let through = |r: f64| (1.0 - r) / (1.0 + surfaces * r);
        0.5 * (through(across) + through(along)) * self.clear.powf(1.0 / within)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Along the normal r = ((n − 1)/(n + 1))² at each surface: 0.0434 for 1.526 (Duffie & Beckman, example
    /// 5.1.1), and at 60° one cover of that index transmits ½ ((1 − 0.185)/(1 + 0.185) + (1 − 0.001)/(1 +
    /// 0.001)) = 0.843.
    #[test]
    fn panes_let_through_what_textbooks_say() {
        let one = Glass::new(1, 1.526, None).expect("a pane");
        let r = (0.526_f64 / 2.526).powi(2);
        assert!((one.transmittance(1.0) - (1.0 - r) / (1.0 + r)).abs() < 1e-14);
        assert!((one.transmittance(0.5) - 0.843).abs() < 1e-3, "{}", one.transmittance(0.5));
        let two = Glass::new(2, 1.526, None).expect("panes");
        assert!((two.transmittance(1.0) - (1.0 - r) / (1.0 + 3.0 * r)).abs() < 1e-14);
        let dim = Glass::new(2, 1.526, Some(0.5)).expect("panes");
        assert!((dim.transmittance(1.0) - 0.5).abs() < 1e-14 && dim.transmittance(0.2) < 0.5);
        assert!(Glass::new(1, 1.526, Some(0.95)).is_err() && Glass::new(1, 0.5, None).is_err());
        assert!(one.transmittance(1e-9) < 1e-6);
    }
}
