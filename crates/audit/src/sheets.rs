//! Sheets of even, unknown temperature: what their sides absorb leaves them anywhere.
//!
//! A two-sided surface with the given flux q per area A has one level σ T⁴ for both sides s,
//!
//! ```text
//! Σ_s ε_s A (σ T⁴ − H̄_s) = q A ,     σ T⁴ = q / Σ ε_s + Σ_s ε_s H̄_s / Σ ε_s
//! ```
//!
//! with the mean irradiances H̄ of its sides. So a walk that a side absorbs goes on from an even point of side
//! s with the probability ε_s / Σ ε.

use std::sync::Arc;

use radiosity_geom::{Rect, Surface};

use crate::spread::{Spread, SpreadPoint};

/// A sheet.
#[derive(Debug)]
pub(crate) struct Sheet {
    /// What the given flux adds to its level, q / Σ ε (W m⁻²).
    pub(crate) level: f64,
    sides: [Spread; 2],
    /// Part ε / Σ ε of the first side.
    first: f64,
}

impl Sheet {
    /// The sheet of two sides of these emissivities, given the flux `flux` (W m⁻²).
    pub(crate) fn new(shapes: [&Arc<dyn Surface>; 2], emissivities: [f64; 2], flux: f64) -> Self {
        let sum = emissivities[0] + emissivities[1];
        Self {
            level: flux / sum,
            sides: shapes.map(|shape| Spread::over(shape, Rect::FULL)),
            first: emissivities[0] / sum,
        }
    }

    /// The point that a walk leaves from by three draws, with its weight.
    pub(crate) fn leave(&self, [side, s, t]: [f64; 3]) -> Option<(SpreadPoint, f64)> {
        let spread = &self.sides[usize::from(side >= self.first)];
        let point = spread.point([s, t])?;
        Some((point, spread.weight(&point)))
    }
}
