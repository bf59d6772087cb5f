//! Piecewise linear functions: tents on a grid of cells.
//!
//! ```text
//! Λ_ij(u, v) = λ_i(u) λ_j(v) ,     λ_i linear between breaks, 1 at break i and 0 at all others
//! ```
//!
//! They are continuous across the cells of the surface, and sum to 1. On triangles and other polygons the
//! cells are those of the parallelogram around them, cut off at the outline: there are no tents of three
//! corners.

use super::functions::SurfaceFunctions;

/// The tents at the corners of a grid of cells; number i·n + j at break i of u and j of the n of v.
#[derive(Clone, Debug)]
pub(super) struct Tents {
    breaks: [Vec<f64>; 2],
}

impl Tents {
    /// Tents of the cells between `breaks` of u and of v, which ascend from −1 to 1.
    pub(super) fn new(breaks: [Vec<f64>; 2]) -> Self {
        Self { breaks }
    }
}

impl SurfaceFunctions for Tents {
    fn count(&self) -> usize {
        self.breaks.iter().map(Vec::len).product()
    }

    fn values(&self, parameters: [f64; 2], out: &mut [f64]) {
        out.fill(0.0);
        let [u, v] = [0, 1].map(|k| Span::at(&self.breaks[k], parameters[k]));
        let across = self.breaks[1].len();
        for (i, along) in u.pair() {
            for (j, other) in v.pair() {
                out[i * across + j] = along * other;
            }
        }
    }
}

/// The interval of a grid that holds a place, and how far along it the place is.
struct Span {
    low: usize,
    /// 0 at its lower break, 1 at the upper one.
    part: f64,
}

impl Span {
    fn at(breaks: &[f64], x: f64) -> Self {
        let low = breaks.partition_point(|own| *own <= x).clamp(1, breaks.len() - 1) - 1;
        Self { low, part: (x - breaks[low]) / (breaks[low + 1] - breaks[low]) }
    }

    /// The functions that are not zero there, with their values.
    fn pair(&self) -> [(usize, f64); 2] {
        [(self.low, 1.0 - self.part), (self.low + 1, self.part)]
    }
}
