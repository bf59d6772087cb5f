//! Fitting shapes together whose coordinates were rounded.
//!
//! In order: `coincident` (surfaces that lie in one another), `gap` (the least one between sheets), `middle` (of scenes far from the
//! origin), `stacked` (sheets on others, set apart), `weld` (corners and planes made equal); and of outlines: `outline` (their
//! vectors of area), `ring` (their tolerances), `plane` (theirs), `overlay` (parts that overlap).
//!
//! Imports the geometry only.

pub mod coincident;
pub mod gap;
pub mod middle;
pub mod stacked;
pub mod weld;
pub mod outline;
pub mod ring;
pub mod plane;
pub mod overlay;

pub use weld::Welded;
