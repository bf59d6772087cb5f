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

/// Contact, error and cost of a block, without its values.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct BlockReport {
    /// Hardest contact met.
    pub kind: PairKind,
    /// Whether something hides a part of one element from the other.
    pub partly_hidden: bool,
    /// Whether a near part was left at the smallest size, with unknown accuracy.
    pub unresolved: bool,
    /// Whether the rules did not try: the values say nothing.
    pub untried: bool,
    /// Estimate of the largest absolute error of a value from unresolved parts.
    pub error: f64,
    /// First entry of the parts whose rules tell their errors.
    pub told: f64,
    /// Terms of the rules, or logarithms of contour integrals.
    pub samples: u64,
    /// Kernel evaluations, or logarithms.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

/// One block and what it cost.
#[derive(Debug, Serialize, Deserialize)]
pub struct Block {
    /// G_kl, row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Its cost and its error.
    pub report: BlockReport,
}

impl Block {
    /// The block of these values, without an error, of so many terms of a pair that nothing hides.
    pub fn exact(values: Vec<f64>, kind: PairKind, samples: u64) -> Self {
        let report = BlockReport {
            kind,
            partly_hidden: false,
            unresolved: false,
            untried: false,
            error: 0.0,
            told: 0.0,
            samples,
            distinct: samples,
            rays: 0,
        };
        Self { values, report }
    }

    /// The block with these moments and no known error.
    pub fn of(moments: Moments, kind: PairKind, partly_hidden: bool) -> Self {
        let Moments { samples, distinct, rays, .. } = moments;
        let Self { values, report } = Self::exact(moments.into_block(), kind, samples);
        Self { values, report: BlockReport { partly_hidden, distinct, rays, ..report } }
    }

    /// A block of `size` entries that the rules leave to rays, after so many probing rays.
    pub fn untried(size: usize, kind: PairKind, rays: u64) -> Self {
        let Self { values, report } = Self::hidden(size, rays);
        Self { values, report: BlockReport { untried: true, kind, ..report } }
    }

    /// The zero block of `size` entries of a pair of which all `rays` probing rays were blocked.
    pub fn hidden(size: usize, rays: u64) -> Self {
        let Self { values, report } = Self::exact(vec![0.0; size], PairKind::Separated, 0);
        Self { values, report: BlockReport { partly_hidden: true, rays, ..report } }
    }

    /// The block with receiver and emitter exchanged; `rows` is the number of the receiver's functions
    /// before.
    pub fn turned(mut self, rows: usize) -> Self {
        let columns = self.values.len() / rows;
        self.values = (0..self.values.len()).map(|k| self.values[k % rows * columns + k / rows]).collect();
        self
    }

    /// Largest absolute value; NaN if one of them is.
    pub fn largest(&self) -> f64 {
        self.values.iter().map(|value| value.abs()).fold(0.0, larger)
    }
}

/// The larger of two numbers; NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// H + Hᵀ of a square matrix H with so many rows.
pub fn add_transpose(values: &mut [f64], count: usize) {
    for k in 0..count {
        for l in 0..=k {
            let sum = values[k * count + l] + values[l * count + k];
            (values[k * count + l], values[l * count + k]) = (sum, sum);
        }
    }
}

/// ½ (H + Hᵀ) of a square matrix H with so many rows.
pub fn take_symmetric_part(values: &mut [f64], count: usize) {
    add_transpose(values, count);
    values.iter_mut().for_each(|value| *value *= 0.5);
}
