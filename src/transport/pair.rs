//! The block of one pair of elements: both flat, or one of them curved.

pub(in crate::transport) mod planar;
pub(in crate::transport) mod curved;
