//! The power series of moving surfaces against exact numbers, direct integrals and its own bounds.

mod blocks;
mod points;
mod quads;
mod solve;
mod vectors;
