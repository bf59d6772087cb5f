//! Piecewise constants: 1 on one cell, 0 elsewhere. Their Ritz system is that of classical radiosity,
//!
//! ```text
//! B_k = E_k + ρ_k Σ_l F_kl B_l .
//! ```

use radiosity_geom::Rect;

use super::functions::SurfaceFunctions;

/// The constants of the cells of a surface.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    rects: Vec<Rect>,
}

impl Cells {
    /// Constants of cells that cover [−1, 1]² and do not overlap.
    pub(super) fn new(rects: Vec<Rect>) -> Self {
        Self { rects }
    }
}

impl SurfaceFunctions for Cells {
    fn count(&self) -> usize {
        self.rects.len()
    }

    /// A border belongs to the cells above it.
    fn values(&self, [u, v]: [f64; 2], out: &mut [f64]) {
        let holds = |[low, high]: [f64; 2], x: f64| low <= x && (x < high || high == 1.0);
        for (rect, out) in self.rects.iter().zip(out) {
            *out = f64::from(u8::from(holds(rect.u, u) && holds(rect.v, v)));
        }
    }
}
