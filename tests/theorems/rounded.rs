//! Scenes as other programs leave them: gaps of every size, rounded coordinates, map coordinates, any order
//! of surfaces.
//!
//! What is true of a room is true of it rounded: rows of view factors add up to what they should, and factors
//! do not jump.

#![expect(clippy::print_stdout, reason = "errors are measured here, and shown with --nocapture")]

mod builtin;
mod covered_parts;
mod gaps;
mod kept;
mod recesses;
mod rooms;
mod rounding;
mod shared;
mod sheet;
