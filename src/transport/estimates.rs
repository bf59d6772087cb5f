//! Sizes of blocks before integration: bounds of entries, coarse sums, probing rays, and the norm of an entry.

pub(in crate::transport) mod entry_norm;
pub(in crate::transport) mod entry_bounds;
pub(in crate::transport) mod coarse;
pub(in crate::transport) mod probing_rays;
