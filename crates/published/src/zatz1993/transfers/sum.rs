//! The sum over the points of two pieces,
//!
//! ```text
//! G^kl = Σ_a C_k(a) Σ_c κ(x_a, y_c) E_l(c) .
//! ```

use radiosity_geom::DVec3;
use radiosity_kernel::kernel;

use super::side::Side;

/// Whether nothing stands between two points.
pub(super) type Sees<'a> = &'a dyn Fn(DVec3, DVec3) -> bool;

/// The sum under way.
pub(super) struct Sum<'a> {
    sees: Option<Sees<'a>>,
    columns: usize,
    /// G^kl, row-major.
    pub values: Vec<f64>,
    /// Kernel evaluations.
    pub samples: u64,
    /// Visibility tests.
    pub rays: u64,
}

impl<'a> Sum<'a> {
    /// Nothing yet, of so many rows and columns.
    pub(super) fn new([rows, columns]: [usize; 2], sees: Option<Sees<'a>>) -> Self {
        Self { sees, columns, values: vec![0.0; rows * columns], samples: 0, rays: 0 }
    }

    /// Adds the terms of all points of two pieces.
    pub(super) fn add(&mut self, receiver: &Side, emitter: &Side) {
        let mut arriving = vec![0.0; self.columns];
        for (here, row) in receiver.nodes.iter().zip(&receiver.rows) {
            arriving.fill(0.0);
            for (there, sent) in emitter.nodes.iter().zip(&emitter.rows) {
                let value = kernel(here, there);
                self.samples += 1;
                if value <= 0.0 || !self.passes(here.position, there.position) {
                    continue;
                }
                arriving.iter_mut().zip(sent).for_each(|(sum, sent)| *sum += value * sent);
            }
            for (values, factor) in self.values.chunks_exact_mut(self.columns).zip(row) {
                values.iter_mut().zip(&arriving).for_each(|(sum, arriving)| *sum += factor * arriving);
            }
        }
    }

    fn passes(&mut self, x: DVec3, y: DVec3) -> bool {
        let Some(sees) = self.sees else { return true };
        self.rays += 1;
        sees(x, y)
    }
}
