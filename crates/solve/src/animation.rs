//! Light that follows moving things, frame after frame.
//!
//! `series` expands the transfer between two flat elements in powers of the displacement between them, and
//! `expansions` does so for the pairs of a scene; `sequence` solves any frame after any other and keeps what
//! has not changed (`sequence_report`: what that cost, and what is missed; `light_before`: the light that the
//! next frame starts from); `stage` does so where somebody else places what moves; `path_interpolation`
//! interpolates the light along a known path (`chebyshev`, `segment`), as far as that pays (`patience`);
//! `follower` chooses among them, and tells when that is repaid.

pub mod error;
pub mod frame;
pub mod sequence_report;
mod chebyshev;
mod light_before;
mod segment;
mod patience;
pub mod sequence;
pub mod stage;
mod path_interpolation;
pub mod follower;
