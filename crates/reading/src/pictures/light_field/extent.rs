//! The extent of a surface along its parameter lines.

use radiosity_geom::{DVec3, Surface};

/// Parts of a parameter line whose lengths are added; parameter lines that are measured.
const PIECES: usize = 16;
const LINES: usize = 5;

/// The extent of a surface along its parameter lines.
pub(crate) struct Extent {
    /// Lengths of the longest lines along u and along v (scene length).
    pub lengths: [f64; 2],
}

impl Extent {
    /// The extent of a surface.
    pub(crate) fn of(shape: &dyn Surface) -> Self {
        let at = |s: f64, t: f64| shape.jet(2.0 * s - 1.0, 2.0 * t - 1.0).position;
        let length = |line: &dyn Fn(f64) -> DVec3| -> f64 {
            let place = |k: usize| line(k as f64 / PIECES as f64);
            (0..PIECES).map(|k| place(k).distance(place(k + 1))).sum()
        };
        let lines = || (0..LINES).map(|k| k as f64 / (LINES - 1) as f64);
        let along = lines().map(|t| length(&|s| at(s, t))).fold(0.0, f64::max);
        let across = lines().map(|s| length(&|t| at(s, t))).fold(0.0, f64::max);
        Self { lengths: [along, across] }
    }
}
