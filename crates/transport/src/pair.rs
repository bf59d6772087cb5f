//! The block of one pair of elements: both flat, or one of them curved.

pub(crate) mod tolerance;
pub(crate) mod planar;
pub(crate) mod curved;
