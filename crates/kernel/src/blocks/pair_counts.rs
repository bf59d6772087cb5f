//! Numbers of pairs by contact and by reason of being skipped.

use serde::{Deserialize, Serialize};

use crate::blocks::block::{BlockReport, PairKind};

/// Numbers of pairs by contact and by reason of being skipped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PairCounts {
    /// Unordered pairs, curved elements with themselves included.
    pub total: usize,
    /// One lies behind the other.
    pub skipped_behind: usize,
    /// Both lie in one plane.
    pub skipped_coplanar: usize,
    /// One blocker hides one from the other.
    pub skipped_hidden: usize,
    /// Neither side ever sends light: both are black and do not emit.
    pub skipped_black: usize,
    /// Equal to an earlier pair up to similarity (also counted by contact).
    pub repeated: usize,
    /// Curved elements with themselves.
    pub same: usize,
    /// Hardest contact a common edge.
    pub edge: usize,
    /// Hardest contact a common corner.
    pub vertex: usize,
    /// Contacts that were cut into common edges and corners.
    pub contact: usize,
    /// Near, therefore split.
    pub split: usize,
    /// Far apart.
    pub separated: usize,
    /// Constants on flat elements: contour integrals, exact.
    pub contour: usize,
    /// Something hides a part (also counted by contact).
    pub partly_hidden: usize,
    /// A near part was left at the smallest size, with unknown accuracy (also counted by contact).
    pub unresolved: usize,
    /// Carried by rays from both sides, because no rule reached the accuracy (also counted by contact).
    #[serde(default)]
    pub by_rays: usize,
}

impl PairCounts {
    /// Pairs that were integrated or copied.
    pub fn integrated(&self) -> usize {
        self.same + self.edge + self.vertex + self.contact + self.split + self.separated + self.contour
    }

    /// Adds the counts of other pairs.
    pub fn add(&mut self, other: &Self) {
        self.total += other.total;
        self.skipped_behind += other.skipped_behind;
        self.skipped_coplanar += other.skipped_coplanar;
        self.skipped_hidden += other.skipped_hidden;
        self.skipped_black += other.skipped_black;
        self.repeated += other.repeated;
        self.same += other.same;
        self.edge += other.edge;
        self.vertex += other.vertex;
        self.contact += other.contact;
        self.split += other.split;
        self.separated += other.separated;
        self.contour += other.contour;
        self.partly_hidden += other.partly_hidden;
        self.unresolved += other.unresolved;
        self.by_rays += other.by_rays;
    }

    /// Counts one more pair whose block was integrated or copied.
    pub fn take(&mut self, block: &BlockReport) {
        let counter = match block.kind {
            PairKind::Contour => &mut self.contour,
            PairKind::Separated => &mut self.separated,
            PairKind::Split => &mut self.split,
            PairKind::Vertex => &mut self.vertex,
            PairKind::Edge => &mut self.edge,
            PairKind::Contact => &mut self.contact,
            PairKind::Same => &mut self.same,
        };
        *counter += 1;
        self.partly_hidden += usize::from(block.partly_hidden);
        self.unresolved += usize::from(block.unresolved);
    }
}
