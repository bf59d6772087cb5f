//! The block of one pair of elements: flat ones, and those of which one is curved.

pub(in crate::transport) mod planar;
pub(in crate::transport) mod curved;
