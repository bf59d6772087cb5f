//! What blockers take from a block: by outlines of polygons, or sampled.

pub(in crate::transport) mod sampled;
pub(in crate::transport) mod outlines;
