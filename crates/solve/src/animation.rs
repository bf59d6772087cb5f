//! Light that follows moving things, frame after frame.
//!
//! `series` expands the transfer between two flat elements in powers of the displacement between them, and
//! `expansions` does so for the pairs of a scene; `sequence` solves any frame after any other and keeps what
//! has not changed (`sequence_report`: what that cost, and what is missed); `path_interpolation` interpolates
//! the light along a known path (`chebyshev`); `follower` chooses among them, and tells when that is repaid.

pub mod error;
pub mod frame;
pub mod sequence_report;
mod chebyshev;
pub mod sequence;
mod path_interpolation;
pub mod follower;
