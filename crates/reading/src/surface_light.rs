//! The light of each surface: means and extremes of irradiance, and the powers that arrive, stay and are sent
//! out.
//!
//! ```text
//! Φ = ∫ E dA ,     mean E = Φ / A ,     absorbed ∫ (1 − ρ − τ) E dA ,     emitted ∫ E₀ dA ,
//! ```
//!
//! from the means over cells ([`grid`](super::grid)), where A is the area of the elements: without holes, and
//! without footprints that are cut out of them. Extremes are those of the means over the part of each cell
//! that elements cover.

use radiosity_solve::solution::Solution;

use super::grid::Cell;
use super::quantity::of_bands;

/// The light of one surface. Powers are in the unit of exitance times scene length².
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceLight {
    /// Index of the surface.
    pub surface: usize,
    /// Area of its elements (scene length²).
    pub area: f64,
    /// Mean irradiance of each band (unit of exitance).
    pub irradiance: Vec<f64>,
    /// Least and greatest irradiance of its cells, in the mean of the bands.
    pub extremes: [f64; 2],
    /// Power of each band that arrives.
    pub received: Vec<f64>,
    /// Power of each band that is absorbed.
    pub absorbed: Vec<f64>,
    /// Power of each band that it emits.
    pub emitted: Vec<f64>,
}

impl SurfaceLight {
    /// The light of each surface that has elements, in the scene's order; `cells` are those of the surfaces
    /// of `solution`, surface after surface.
    pub fn of(solution: &Solution, cells: &[Cell]) -> Vec<Self> {
        let bare = |cells: &&[Cell]| cells.iter().any(|cell| cell.exposed > 0.0);
        cells.chunk_by(|a, b| a.surface == b.surface).filter(bare).map(|own| light(solution, own)).collect()
    }
}

fn light(solution: &Solution, cells: &[Cell]) -> SurfaceLight {
    let (surface, bands) = (cells[0].surface, solution.bands());
    let area: f64 = cells.iter().map(|cell| cell.exposed).sum();
    let received: Vec<f64> = (0..bands.len())
        .map(|band| cells.iter().map(|cell| cell.irradiance[band] * cell.area).sum())
        .collect();
    let extremes = cells
        .iter()
        .filter(|cell| cell.exposed > 0.0)
        .map(|cell| of_bands(&cell.irradiance, None) * cell.area / cell.exposed)
        .fold([f64::INFINITY, 0.0], |[least, most], value| [f64::min(least, value), f64::max(most, value)]);
    let absorbed = |band: usize| cells.iter().map(|cell| cell.absorbed[band] * cell.area).sum();
    let list = solution.elements().list();
    let emitted = |band: usize| {
        let exitance = &bands[band].coating.exitance;
        let elements = solution.elements().of_surface(surface);
        // What all elements emit alike, and what each emits beside it.
        let alike = exitance[elements.start];
        alike * area + elements.map(|own| (exitance[own] - alike) * list[own].area).sum::<f64>()
    };
    SurfaceLight {
        surface,
        area,
        irradiance: received.iter().map(|power| power / area).collect(),
        extremes,
        absorbed: (0..bands.len()).map(absorbed).collect(),
        emitted: (0..bands.len()).map(emitted).collect(),
        received,
    }
}
