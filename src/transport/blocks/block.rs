//! One block of G with what it cost, and the accuracy that is asked of it.

use crate::transport::moments::Moments;

/// What accuracy the blocks are asked to have.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// Of the smooth rules, relative to the block's largest entry or a hundredth of its row's, whichever is larger; entries of
    /// curved elements below 1e-8 count as that.
    pub eps: f64,
    /// Of visibility within a block.
    pub shadow_eps: f64,
}

impl Accuracy {
    /// Looser by `factor`, where that is above 1: for a block whose shadows weigh little beside its row.
    pub(crate) fn loosened(&self, factor: f64) -> Self {
        let eps = (self.eps * factor).min(self.shadow_eps.sqrt()).max(self.eps);
        Self { eps, shadow_eps: self.shadow_eps * factor.max(1.0).powi(2) }
    }

    /// How often a partly hidden pair is halved: ½ log₂(1/ε).
    ///
    /// Each halving takes part of the pair out of doubt, and samples in what is left do the rest.
    pub(crate) fn shadow_levels(&self) -> u32 {
        (-0.5 * self.shadow_eps.log2()).clamp(0.0, 12.0) as u32
    }
}

/// The rule that a pair of elements needed most of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Constants on flat elements: by their contours, exact.
    Contour,
    /// Plain tensor rule.
    Separated,
    /// Split because it is near.
    Split,
    /// A common corner.
    Vertex,
    /// A common edge.
    Edge,
    /// Cut so that edges of contact match.
    Contact,
    /// A curved element with itself.
    Same,
}

/// One block and what it cost.
#[derive(Debug)]
pub(crate) struct Block {
    /// G_kl, row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Hardest kind of contact met.
    pub kind: Kind,
    /// Whether visibility had to be sampled.
    pub partly_hidden: bool,
    /// Whether a near part was left at the smallest size allowed, its accuracy unknown.
    pub unresolved: bool,
    /// Estimate of the largest absolute error of `values` that comes from parts left unresolved.
    pub error: f64,
    /// Terms of the rules; logarithms where the contours were integrated.
    pub samples: u64,
    /// Kernel evaluations, or logarithms.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

impl Block {
    /// The block with these moments, of which no error is known.
    pub(in crate::transport) fn of(moments: Moments, kind: Kind, partly_hidden: bool) -> Self {
        Self {
            samples: moments.samples,
            distinct: moments.distinct,
            rays: moments.rays,
            values: moments.into_block(),
            kind,
            partly_hidden,
            unresolved: false,
            error: 0.0,
        }
    }

    /// The block with receiver and emitter exchanged, of `rows` functions of the receiver.
    pub(crate) fn turned(mut self, rows: usize) -> Self {
        let columns = self.values.len() / rows;
        self.values = (0..self.values.len()).map(|k| self.values[k % rows * columns + k / rows]).collect();
        self
    }

    /// The zero block of so many entries, of elements between which none of so many `rays` passes.
    pub(crate) fn hidden(size: usize, rays: u64) -> Self {
        Self {
            values: vec![0.0; size],
            kind: Kind::Separated,
            partly_hidden: true,
            unresolved: false,
            error: 0.0,
            samples: 0,
            distinct: 0,
            rays,
        }
    }
}
