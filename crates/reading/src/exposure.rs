//! Exposure of pictures: how much light is white.
//!
//! A picture shows the quantity B, in the scene's unit, as x B, 1 for white. The factor x is told in exposure
//! values as well, EV = log₂ x: each step up doubles the brightness, as a camera's exposure compensation does.

use radiosity_work::digits::{decimals, significant};
use serde::Serialize;

/// Exposure of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Exposure {
    /// Factor on the quantity before it becomes colours, above 0 (1/unit of exitance).
    factor: f64,
    /// The factor in exposure values.
    ev: f64,
    /// Whether it was chosen for what is seen.
    automatic: bool,
}

impl Exposure {
    /// An exposure that was asked for.
    pub fn fixed(factor: f64) -> Self {
        Self { factor, ev: factor.log2(), automatic: false }
    }

    /// An exposure that was chosen for what is seen.
    pub fn automatic(factor: f64) -> Self {
        Self { automatic: true, ..Self::fixed(factor) }
    }

    /// Factor on the quantity before it becomes colours (1/unit of exitance).
    pub fn factor(&self) -> f64 {
        self.factor
    }

    /// The factor in exposure values, log₂.
    pub fn ev(&self) -> f64 {
        self.ev
    }

    /// Whether it was chosen for what is seen.
    pub fn is_automatic(&self) -> bool {
        self.automatic
    }

    /// The exposure of a quantity in this unit in words.
    pub fn told(&self, quantity: &str, unit: &str) -> String {
        let white = significant(1.0 / self.factor, 3);
        let how = if self.automatic { ", chosen" } else { "" };
        format!("exposure {} EV{how}: {quantity} of {white} {unit} is white", decimals(self.ev, 2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_doubles() {
        let told = |factor: f64| Exposure::fixed(factor).told("radiosity", "W/m²");
        assert_eq!(told(1.0), "exposure 0.00 EV: radiosity of 1 W/m² is white");
        assert_eq!(told(0.125), "exposure -3.00 EV: radiosity of 8 W/m² is white");
        let chosen = Exposure::automatic(4.0);
        assert_eq!(
            chosen.told("illuminance", "lx"),
            "exposure 2.00 EV, chosen: illuminance of 0.25 lx is white"
        );
    }
}
