//! Blocks that are known otherwise than by rules, such as by a series of what moves.

use std::fmt::Debug;

use radiosity_elements::Element;
use radiosity_kernel::blocks::block::Block;

/// A block that is known.
#[derive(Debug)]
pub enum Known {
    /// The block of the scene before, if that was integrated for the same accuracy.
    Same,
    /// A block given here.
    Block {
        /// The block itself.
        block: Block,
        /// Bound of the norm of what it differs by from the integrated block.
        remainder: f64,
    },
}

/// Blocks that are known otherwise than by rules.
pub trait KnownBlocks: Debug + Send + Sync {
    /// Takes note of the elements of the next scene, before any of its blocks is asked for.
    fn move_to(&self, elements: &[Element]);

    /// The block of two flat elements with nothing between them, at these places among all elements, if it is
    /// known; `eps` is the error that rules are allowed, relative to its largest entry, and `samples` are those
    /// of the block of the scene before. Called once for a pair of a scene, from any thread.
    fn block(
        &self,
        places: [usize; 2],
        elements: [&Element; 2],
        eps: f64,
        samples: Option<u64>,
    ) -> Option<Known>;
}
