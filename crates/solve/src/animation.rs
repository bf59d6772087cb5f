//! Light that follows moving things, frame after frame.
//!
//! `series` expands the transfer between two flat elements in powers of the displacement between them, and
//! `expansions` does so for the pairs of a scene; `sequence` solves any frame after any other and keeps what
//! has not changed (`account`: what that cost, and what is missed); `course` interpolates the light along a
//! known path (`chebyshev`); `follower` chooses among them, and `ledger` tells when that is repaid.

pub mod error;
pub mod frame;
pub mod account;
mod chebyshev;
mod told;
mod ledger;
pub mod sequence;
mod course;
pub mod follower;
