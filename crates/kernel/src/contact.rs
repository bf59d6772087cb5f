//! How two patches or elements meet: along an edge, at a corner, not at all; and which side they turn to each other.

pub mod clip;
pub mod sectors;
pub mod orientation;
pub mod planes;
pub mod flat;
pub mod curved;
