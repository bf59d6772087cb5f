//! The progress of work.

use std::fmt;

/// News of the progress of work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Beginning of a stage of which nothing is done yet, with its expected time.
    Expected {
        /// The stage that begins.
        stage: Stage,
        /// About how long it takes (s).
        seconds: f64,
    },
    /// Number of things of a stage that are done.
    Done {
        /// The stage that is counted.
        stage: Stage,
        /// Things that are done.
        done: usize,
        /// Things to be done in all.
        of: usize,
    },
    /// Rays between elements.
    Rays {
        /// Number of rays sent.
        done: u64,
        /// Rays to be sent in all.
        of: u64,
        /// Estimate of the relative error that an earlier round left, once there is one.
        error: Option<f64>,
    },
    /// An iteration of a linear solver.
    Iteration {
        /// Index of the band, from 0.
        band: usize,
        /// Bands in all.
        of: usize,
        /// Number of the iteration.
        iteration: usize,
        /// Relative residual after it.
        residual: f64,
    },
    /// A stage begins, within the one that began last and has not ended. The thread that leads the work tells it.
    Began {
        /// The stage that begins.
        stage: Stage,
    },
    /// The stage that began last ends.
    Ended {
        /// The stage that ends.
        stage: Stage,
    },
}

/// A stage of work, and the things that are counted there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Reading of what the work is done on, and reserving of files; nothing is counted.
    Load,
    /// Finding out which backs heat reaches; nothing is counted.
    Backs,
    /// Finding out which surfaces hide others; nothing is counted.
    Visibility,
    /// Cutting surfaces into elements; nothing is counted.
    Elements,
    /// Direct light that is split off, and its first bounce.
    Direct,
    /// Pairs of elements whose blocks are integrated, or rounds in which links are refined.
    Blocks,
    /// Making rows of transfers sum to 1; nothing is counted.
    Closure,
    /// Linear systems, band by band.
    Solve,
    /// Self-checks of a solution; nothing is counted.
    Checks,
    /// Elements or sensors whose error is estimated.
    Estimate,
    /// Pairs of elements, or rays, of solutions that tell the error of another one.
    Comparison,
    /// Runs of a study, in thousandths of their work.
    Runs,
    /// Tables of light that readings share; nothing is counted.
    Tables,
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
    /// Readings that the referee judges, in parts of their walks.
    Referee,
    /// Writing of files, and what is made for them alone; nothing is counted.
    Output,
}

/// Name of the stage, in few words.
impl fmt::Display for Stage {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str(self.name())
    }
}

impl Stage {
    /// Name of the stage, in few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Load => "load",
            Self::Backs => "backs",
            Self::Visibility => "visibility",
            Self::Elements => "elements",
            Self::Direct => "direct",
            Self::Blocks => "blocks",
            Self::Closure => "closure",
            Self::Solve => "solve",
            Self::Checks => "self-checks",
            Self::Estimate => "estimate",
            Self::Comparison => "for the error",
            Self::Runs => "runs",
            Self::Tables => "tables",
            Self::Points => "points",
            Self::Cells => "cells",
            Self::Picture => "picture",
            Self::DirectPixels => "direct light",
            Self::GatheredPixels => "gathering",
            Self::Texels => "texels",
            Self::Referee => "referee",
            Self::Output => "output",
        }
    }
}
