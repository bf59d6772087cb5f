//! Numbers of cells that surfaces are cut into.

use radiosity_geom::Surface;
use radiosity_scene::Scene;

/// Cells along u and v of each surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CellCounts {
    /// As many of every surface.
    Even([usize; 2]),
    /// Counts of each surface.
    Each(Vec<[usize; 2]>),
}

/// Cells along u and v of the surfaces of small scenes, and most along either elsewhere.
const SIDE: usize = 16;

/// Cells of all surfaces of larger scenes, about, besides one of each. Chosen: seconds.
const ABOUT: usize = 5000;

/// Parts of a line of parameters by which its length is found. Chosen: enough for a closed line.
const PARTS: usize = 8;

impl CellCounts {
    /// 16 × 16 of every surface, or cells of about one size where these were more than about 5000.
    pub fn usual(scene: &Scene) -> Self {
        match scene.surfaces.len() * SIDE * SIDE <= ABOUT {
            true => Self::Even([SIDE; 2]),
            false => Self::by_size(scene, ABOUT, SIDE),
        }
    }

    /// Cells of about one size on all surfaces: their sides are the square root of the area of all over `about`, and a
    /// surface has at most `most` along u or v.
    pub fn by_size(scene: &Scene, about: usize, most: usize) -> Self {
        let shapes = || scene.surfaces.iter().map(|surface| surface.shape.as_ref());
        let area: f64 = shapes().map(Surface::area).sum();
        let length = (area / about as f64).sqrt();
        let counts = |shape: &dyn Surface| {
            let count = |of: f64| ((of / length).round() as usize).clamp(1, most);
            middle_lines(shape).map(count)
        };
        Self::Each(shapes().map(counts).collect())
    }

    /// Cells of so many surfaces.
    pub fn total(&self, surfaces: usize) -> usize {
        (0..surfaces).map(|surface| self.of(surface)).map(|[u, v]| u * v).sum()
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
