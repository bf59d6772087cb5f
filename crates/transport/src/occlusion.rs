//! Occlusion correction: what blockers take away from a block, by outlines of polygons or by sampling.

pub(crate) mod outside_ball;
pub(crate) mod beside_frusta;
pub(crate) mod sampled;
pub(crate) mod outlines;
