//! Bounds of the errors of blocks that were not integrated.

/// Bound of the error of the block of a pair, copies of congruent pairs included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remainder {
    /// Receiver and emitter.
    pub places: [usize; 2],
    /// Bound of the norm of the difference from the integrated block.
    pub bound: f64,
}
