//! Sizes of blocks that are known before they are integrated: bounds of entries, coarse sums, and what a few rays meet.

pub(in crate::transport) mod entry_norm;
pub(in crate::transport) mod entry_bounds;
pub(in crate::transport) mod coarse;
pub(in crate::transport) mod probing_rays;
