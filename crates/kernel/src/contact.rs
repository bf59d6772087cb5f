//! Contacts of two patches or elements, along an edge, at a corner or none, and the sides that they turn to
//! each other.

pub mod clip;
pub mod sectors;
pub mod orientation;
pub mod planes;
pub mod gap;
pub mod patches;
