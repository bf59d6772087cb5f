//! Sizes of blocks before integration: bounds of entries, coarse sums, probing rays, and the norm of an
//! entry.

pub mod entry_norm;
pub mod entry_bounds;
pub mod coarse;
pub mod probing_rays;
