//! Sheets of even, unknown temperature: what their sides absorb leaves them anywhere.
//!
//! A two-sided surface that is given the flux q per area of its first side has one level σ T⁴ for both sides
//! s, whose parts A_s exchange heat,
//!
//! ```text
//! Σ_s ε_s A_s (σ T⁴ − H̄_s) = q A_1 ,     σ T⁴ = q A_1 / Σ ε_s A_s + Σ_s ε_s A_s H̄_s / Σ ε_s A_s
//! ```
//!
//! with the mean irradiances H̄ of its sides. So a walk that a side absorbs goes on from an even point of
//! side s with the probability ε_s A_s / Σ ε A, where nothing stands on it.

use radiosity_geom::Rect;

use crate::lattice::{DIMENSIONS, Draws, Lattice};
use crate::random::{OF_SHEETS, Random};
use crate::rays::{Place, Rays};
use crate::spread::Spread;

/// Tries to find a point that nothing stands on. Chosen: where a hundredth of a sheet is bare, 7 % of the
/// walks that it absorbs would be lost, at a tenth one in 5 × 10¹¹.
const TRIES: usize = 256;

/// Points that tell how much of a side is bare, as a power of 2. Chosen: the part errs by some 10⁻³ where
/// there is an edge, and it only matters to heated sheets that are partly covered.
const BARE: u32 = 10;

/// A sheet.
#[derive(Debug)]
pub(crate) struct Sheet {
    /// Its level by the given flux alone, q A_1 / Σ ε A (W m⁻²).
    pub(crate) level: f64,
    /// Part ε A / Σ ε A of the first side.
    pub(crate) first: f64,
    /// Indices of its sides.
    pub(crate) sides: [usize; 2],
    spreads: [Spread; 2],
}

impl Sheet {
    /// The sheet of two sides of these emissivities, given the flux `flux` (W m⁻²).
    pub(crate) fn new(rays: &Rays, sides: [usize; 2], emissivities: [f64; 2], flux: f64) -> Self {
        let spreads = sides.map(|side| Spread::over(rays.shape(side), Rect::FULL));
        let bare = [0, 1].map(|k| rays.area(sides[k]) * bare_part(rays, sides[k], &spreads[k]));
        let absorbing = [0, 1].map(|k| emissivities[k] * bare[k]);
        // Sides that absorb nothing, or are covered whole, are never asked.
        let sum = (absorbing[0] + absorbing[1]).max(f64::MIN_POSITIVE);
        Self { level: flux * bare[0] / sum, first: absorbing[0] / sum, sides, spreads }
    }

    /// The place that a walk leaves from, with its weight.
    pub(crate) fn leave(&self, rays: &Rays, draws: &mut Draws<'_>) -> Option<(Place, f64)> {
        for _ in 0..TRIES {
            let side = usize::from(draws.next() >= self.first);
            let spread = &self.spreads[side];
            let point = spread.point(draws.pair())?;
            let place = Place::on(self.sides[side], &point);
            if rays.is_bare(&place) {
                return Some((place, spread.weight(&point)));
            }
            draws.go_to(DIMENSIONS);
        }
        None
    }
}

/// The part of a surface that nothing stands on; 1 where no point is covered.
fn bare_part(rays: &Rays, surface: usize, spread: &Spread) -> f64 {
    let mut random = Random::of(&[surface as u64, OF_SHEETS]);
    let lattice = Lattice::moved(BARE, &mut random);
    let (mut bare, mut all) = (0.0, 0.0);
    for k in 0..1 << BARE {
        let mut draws = Draws::new(&lattice, k, random.clone());
        let Some(point) = spread.point(draws.pair()) else { continue };
        let weight = spread.weight(&point);
        all += weight;
        if rays.is_bare(&Place::on(surface, &point)) {
            bare += weight;
        }
    }
    bare / all
}
