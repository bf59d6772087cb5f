//! Helpers of tests, benches and studies of several packages.
//!
//! Without features it needs nothing of the house, so that the crates at its foot can use it; `geom`,
//! `solvers` and `house` add what needs surfaces, systems of equations, and scenes. A helper that fails
//! panics where it was called.

pub mod random;
pub mod mutations;

pub mod oracle;
pub mod connection;

pub mod grain;
pub mod walls;

#[cfg(feature = "geom")]
pub mod gallery;
#[cfg(feature = "geom")]
pub mod triangle;
#[cfg(feature = "geom")]
pub mod shapes;

#[cfg(feature = "solvers")]
pub mod systems;

#[cfg(feature = "house")]
pub mod compare;
#[cfg(feature = "house")]
pub mod folders;
#[cfg(feature = "house")]
pub mod documents;
#[cfg(feature = "house")]
pub mod data;
#[cfg(feature = "house")]
pub mod scenes;
#[cfg(feature = "house")]
pub mod solved;
#[cfg(feature = "house")]
pub mod readers;
#[cfg(feature = "house")]
pub mod given;
#[cfg(feature = "house")]
pub mod sources;
#[cfg(feature = "house")]
pub mod direct;
#[cfg(feature = "house")]
pub mod opposed;
