//! How many pairs of elements went which way.

use serde::{Deserialize, Serialize};

use crate::transport::blocks::block::{Block, Kind};

/// How many pairs of elements went which way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PairCounts {
    /// Unordered pairs, curved elements with themselves included.
    pub total: usize,
    /// One lies behind the other.
    pub skipped_facing: usize,
    /// Both lie in one plane.
    pub skipped_coplanar: usize,
    /// One blocker hides one from the other.
    pub skipped_hidden: usize,
    /// Neither side ever sends light: both are black and emit nothing.
    pub skipped_black: usize,
    /// Equal to an earlier pair up to similarity (counted below as well).
    pub repeated: usize,
    /// Curved elements with themselves.
    pub same: usize,
    /// Hardest contact: a common edge.
    pub edge: usize,
    /// Hardest contact: a common corner.
    pub vertex: usize,
    /// Cut so that edges of contact match.
    pub contact: usize,
    /// Near, therefore split.
    pub split: usize,
    /// Apart.
    pub separated: usize,
    /// Constants on flat elements: by their contours, exact.
    pub contour: usize,
    /// Pairs in which visibility was sampled (counted above as well).
    pub partly_hidden: usize,
    /// Pairs with a near part left at the smallest size, accuracy unknown (counted above as well).
    pub unresolved: usize,
}

impl PairCounts {
    /// Counts one more pair whose block was integrated, or is a copy of one that was.
    pub(crate) fn take(&mut self, block: &Block) {
        let counter = match block.kind {
            Kind::Contour => &mut self.contour,
            Kind::Separated => &mut self.separated,
            Kind::Split => &mut self.split,
            Kind::Vertex => &mut self.vertex,
            Kind::Edge => &mut self.edge,
            Kind::Contact => &mut self.contact,
            Kind::Same => &mut self.same,
        };
        *counter += 1;
        self.partly_hidden += usize::from(block.partly_hidden);
        self.unresolved += usize::from(block.unresolved);
    }
}
