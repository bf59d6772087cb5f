//! Occlusion correction: what blockers take away from a block, by outlines of polygons or by sampling.

pub(in crate::transport) mod sampled;
pub(in crate::transport) mod outlines;
