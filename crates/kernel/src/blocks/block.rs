//! One block of G with its cost, and the accuracy asked of blocks.

use serde::{Deserialize, Serialize};

use crate::moments::Moments;

/// The accuracy asked of blocks.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// ε of the smooth rules, relative to the block's largest entry or to a hundredth of its row's, whichever
    /// is larger. On curved elements an entry below 1e-8 counts as 1e-8.
    pub eps: f64,
    /// ε of the visibility within a block.
    pub shadow_eps: f64,
}

impl Accuracy {
    /// Loosened for a block whose shadows are small compared with its row: ε times `factor` where above 1, up
    /// to √ε_shadow; ε_shadow times its square.
    pub fn loosened(&self, factor: f64) -> Self {
        let eps = (self.eps * factor).min(self.shadow_eps.sqrt()).max(self.eps);
        Self { eps, shadow_eps: self.shadow_eps * factor.max(1.0).powi(2) }
    }

    /// Number of times that a partly hidden pair is halved: ½ log₂(1/ε), at most 12.
    ///
    /// Each halving decides part of the pair; the rest is sampled. After half the binary digits of ε about √ε
    /// of it is undecided, which samples need to tell to √ε; twelve bound the number of parts.
    pub fn shadow_levels(&self) -> u32 {
        (-0.5 * self.shadow_eps.log2()).clamp(0.0, 12.0) as u32
    }
}

/// The hardest contact met between a pair of elements, from easy to hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum PairKind {
    /// Constants on flat elements: contour integrals, exact.
    Contour,
    /// Far apart: a plain tensor rule.
    Separated,
    /// Near, therefore split.
    Split,
    /// A common corner.
    Vertex,
    /// A common edge.
    Edge,
    /// A contact that was cut into common edges and corners.
    Contact,
    /// A curved element with itself.
    Same,
}

/// Cost, error and contact of a block, without its values.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct BlockReport {
    /// Hardest contact met.
    pub kind: PairKind,
    /// As [`Block::partly_hidden`].
    pub partly_hidden: bool,
    /// As [`Block::unresolved`].
    pub unresolved: bool,
    /// As [`Block::untried`].
    pub untried: bool,
    /// As [`Block::error`].
    pub error: f64,
    /// Largest absolute value; NaN if one of them is.
    pub largest: f64,
    /// As [`Block::samples`].
    pub samples: u64,
    /// As [`Block::distinct`].
    pub distinct: u64,
    /// As [`Block::rays`].
    pub rays: u64,
}

/// One block and what it cost.
#[derive(Debug, Serialize, Deserialize)]
pub struct Block {
    /// G_kl, row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Hardest contact met.
    pub kind: PairKind,
    /// Whether something hides a part of one element from the other.
    pub partly_hidden: bool,
    /// Whether a near part was left at the smallest size, with unknown accuracy.
    pub unresolved: bool,
    /// Whether the rules did not try: the values say nothing.
    pub untried: bool,
    /// Estimate of the largest absolute error of `values` from unresolved parts.
    pub error: f64,
    /// Terms of the rules, or logarithms of contour integrals.
    pub samples: u64,
    /// Kernel evaluations, or logarithms.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

impl Block {
    /// Cost, error and contact of the block.
    pub fn report(&self) -> BlockReport {
        let Self { kind, partly_hidden, unresolved, untried, error, samples, distinct, rays, .. } = *self;
        let largest = self.values.iter().map(|value| value.abs()).fold(0.0, larger);
        BlockReport { kind, partly_hidden, unresolved, untried, error, largest, samples, distinct, rays }
    }

    /// The block of these values.
    pub fn from_report(values: Vec<f64>, report: &BlockReport) -> Self {
        let BlockReport { kind, partly_hidden, unresolved, untried, error, samples, distinct, rays, .. } =
            *report;
        Self { values, kind, partly_hidden, unresolved, untried, error, samples, distinct, rays }
    }

    /// The block with these moments and no known error.
    pub fn of(moments: Moments, kind: PairKind, partly_hidden: bool) -> Self {
        Self {
            samples: moments.samples,
            distinct: moments.distinct,
            rays: moments.rays,
            values: moments.into_block(),
            kind,
            partly_hidden,
            unresolved: false,
            untried: false,
            error: 0.0,
        }
    }

    /// The block with receiver and emitter exchanged; `rows` is the number of the receiver's functions
    /// before.
    pub fn turned(mut self, rows: usize) -> Self {
        let columns = self.values.len() / rows;
        self.values = (0..self.values.len()).map(|k| self.values[k % rows * columns + k / rows]).collect();
        self
    }

    /// A block of `size` entries that the rules leave to rays, after so many probing rays.
    pub fn untried(size: usize, kind: PairKind, rays: u64) -> Self {
        Self { untried: true, kind, ..Self::hidden(size, rays) }
    }

    /// The zero block of `size` entries of a pair of which all `rays` probing rays were blocked.
    pub fn hidden(size: usize, rays: u64) -> Self {
        Self {
            values: vec![0.0; size],
            kind: PairKind::Separated,
            partly_hidden: true,
            unresolved: false,
            untried: false,
            error: 0.0,
            samples: 0,
            distinct: 0,
            rays,
        }
    }
}

/// The larger of two numbers; NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
