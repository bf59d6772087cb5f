//! How shadow masks are made.

use std::num::NonZeroUsize;

use serde::{Deserialize, Serialize};

/// Resolution of masks, and the average that they sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Masking {
    /// Cells along each side of an element, at the finest; masks are sampled at their corners.
    pub cells: NonZeroUsize,
    /// The average that is sampled.
    pub average: Average,
}

impl Default for Masking {
    /// 40 cells along each side, of which each tells the part of the light that arrives.
    fn default() -> Self {
        Self { cells: const { NonZeroUsize::new(40).expect("40 is not 0") }, average: Average::Weighted }
    }
}

/// The value of a mask at its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Average {
    /// The part of the emitter's light that arrives.
    Weighted,
    /// The part of the emitter's area that is seen, as in Zatz 1993.
    Plain,
}
