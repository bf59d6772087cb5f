//! Numbers of cells that surfaces are cut into.

use radiosity_elements::Elements;
use radiosity_geom::Surface;

/// Cells along u and v of each surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CellCounts {
    /// As many of every surface.
    Even([usize; 2]),
    /// Those of each surface.
    Each(Vec<[usize; 2]>),
}

/// Parts of a line of parameters by which its length is found. Chosen: enough for a closed line.
const PARTS: usize = 8;

impl CellCounts {
    /// Cells of about one size on all surfaces: the square root of the area of all over `about`, but at most `side`
    /// along u or v.
    pub fn by_size(elements: &Elements, about: usize, side: usize) -> Self {
        let surfaces = 0..elements.surfaces();
        let area: f64 = surfaces.clone().map(|surface| elements.shape(surface).area()).sum();
        let length = (area / about as f64).sqrt();
        let counts = |surface: usize| {
            let count = |of: f64| ((of / length).round() as usize).clamp(1, side);
            middle_lines(elements.shape(surface)).map(count)
        };
        Self::Each(surfaces.map(counts).collect())
    }

    /// Cells of a surface.
    pub fn of(&self, surface: usize) -> [usize; 2] {
        match self {
            Self::Even(counts) => *counts,
            Self::Each(counts) => counts[surface],
        }
    }
}

impl From<[usize; 2]> for CellCounts {
    fn from(counts: [usize; 2]) -> Self {
        Self::Even(counts)
    }
}

/// Lengths of the lines along u and along v through the middle of the parameters (scene length).
fn middle_lines(shape: &dyn Surface) -> [f64; 2] {
    let at = |k: usize| -1.0 + 2.0 * k as f64 / PARTS as f64;
    let along_u = |k: usize| shape.jet(at(k), 0.0).position;
    let along_v = |k: usize| shape.jet(0.0, at(k)).position;
    [
        (0..PARTS).map(|k| along_u(k).distance(along_u(k + 1))).sum(),
        (0..PARTS).map(|k| along_v(k).distance(along_v(k + 1))).sum(),
    ]
}
