//! Fitting shapes together whose coordinates were rounded.
//!
//! In order: `tolerances`, `coincident` (surfaces that lie in one another), `gap` (least gaps between
//! sheets), `middle` (of scenes far from the origin), `bodies` (of sheets), `stacked` (sheets on others, set
//! apart), `weld` (corners and planes made equal); and of outlines: `outline` (areas, tolerances), `plane`
//! (planes and flat coordinates), `overlay` (parts that overlap).
//!
//! Imports `core` and `geom`.

pub mod tolerances;
pub mod sides;
pub mod coincident;
pub mod gap;
pub mod middle;
pub mod bodies;
pub mod stacked;
pub mod weld;
pub mod outline;
pub mod plane;
pub mod overlay;

pub use weld::Welded;
