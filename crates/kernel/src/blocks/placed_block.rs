//! Blocks with their places in G.

use std::borrow::Cow;

/// A block with its place in G.
#[derive(Clone, Debug)]
pub struct PlacedBlock<'a> {
    /// The receiver.
    pub row: usize,
    /// The emitter.
    pub column: usize,
    /// Row-major, receiver functions by emitter functions.
    pub values: Cow<'a, [f64]>,
}
