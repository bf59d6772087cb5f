//! Functions over a surface, known by their values at its parameters.

use std::fmt::Debug;

/// Finitely many functions f_a over the parameters (u, v) ∈ [−1, 1]² of a surface, linearly independent
/// there. They have no unit.
pub trait SurfaceFunctions: Debug + Send + Sync {
    /// Number of functions.
    fn count(&self) -> usize;

    /// f_a(u, v) into `out`, of length [`count`](Self::count).
    fn values(&self, parameters: [f64; 2], out: &mut [f64]);
}
