//! How two patches or elements lie to each other: in one plane, before or behind, touching along an edge, at a corner, or apart.

pub(in crate::transport) mod clip;
pub(in crate::transport) mod sectors;
pub(in crate::transport) mod orientation;
pub(crate) mod planes;
pub(in crate::transport) mod flat;
pub(in crate::transport) mod curved;
