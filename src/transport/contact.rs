//! How two patches or elements meet: along an edge, at a corner, not at all; and which side they turn to each other.

pub(in crate::transport) mod clip;
pub(in crate::transport) mod sectors;
pub(in crate::transport) mod orientation;
pub(crate) mod planes;
pub(in crate::transport) mod flat;
pub(in crate::transport) mod curved;
