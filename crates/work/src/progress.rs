//! How far work is.

use std::fmt;
use std::time::Duration;

/// How far work is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Nothing of a stage is done, and it takes about so many seconds.
    Expected {
        /// The stage.
        stage: Stage,
        /// About how long it takes (s).
        seconds: f64,
    },
    /// So many things of a stage are done.
    Done {
        /// The stage.
        stage: Stage,
        /// Things that are done.
        done: usize,
        /// Things to be done in all.
        of: usize,
    },
    /// Rays between elements.
    Rays {
        /// Rays sent.
        done: u64,
        /// Rays to be sent in all.
        of: u64,
        /// Estimate of the relative error that an earlier round left, once there is one.
        error: Option<f64>,
    },
    /// An iteration of a linear solver.
    Iteration {
        /// The band.
        band: usize,
        /// Bands in all.
        of: usize,
        /// Number of the iteration.
        iteration: usize,
        /// Relative residual after it.
        residual: f64,
    },
    /// A stage of a solution is finished.
    Finished {
        /// The stage.
        stage: Stage,
        /// Its wall time.
        took: Duration,
    },
}

/// A stage of work: what is counted there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// What hides what is found out.
    Visibility,
    /// Surfaces are cut into elements.
    Elements,
    /// Direct light that is split off, and its first bounce.
    Direct,
    /// Pairs of elements whose blocks are integrated, or rounds in which links are refined.
    Blocks,
    /// The linear systems.
    Solve,
    /// Elements or sensors whose error is estimated.
    Estimate,
    /// Pairs of elements, or rays, of solutions that tell the error of another one.
    Comparison,
    /// Runs of a study, in thousandths of their work.
    Runs,
    /// Points that are read.
    Points,
    /// Cells that are read.
    Cells,
    /// Pixels, and what they wait for.
    Picture,
    /// Pixels whose direct light is computed.
    DirectPixels,
    /// Pixels at which reflected light is gathered, of those that are so far known to want it.
    GatheredPixels,
    /// Texels of the light of surfaces.
    Texels,
}

/// Its name, in few words.
impl fmt::Display for Stage {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str(self.name())
    }
}

impl Stage {
    /// Its name, in few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Visibility => "visibility",
            Self::Elements => "elements",
            Self::Direct => "direct",
            Self::Blocks => "blocks",
            Self::Solve => "solve",
            Self::Estimate => "estimate",
            Self::Comparison => "for the error",
            Self::Runs => "runs",
            Self::Points => "points",
            Self::Cells => "cells",
            Self::Picture => "picture",
            Self::DirectPixels => "direct light",
            Self::GatheredPixels => "gathering",
            Self::Texels => "texels",
        }
    }
}
