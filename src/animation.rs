//! Light that follows moving things, frame after frame.
//!
//! `sequence` solves any frame after any other and keeps what has not changed; `course` interpolates the light along a known path
//! (`chebyshev`); `follower` chooses among them.

pub mod error;
pub mod frame;
pub mod chebyshev;
pub mod sequence;
pub mod course;
pub mod follower;
