//! What blocks that were not integrated may be off by.

/// What the block of a pair may be off by, copies of congruent pairs included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remainder {
    /// Receiver and emitter.
    pub places: [usize; 2],
    /// Bound of the norm of the difference from the integrated block.
    pub bound: f64,
}
