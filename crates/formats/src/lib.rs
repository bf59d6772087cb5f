//! Scenes of other programs: a [`Model`](model::Model) is read from one of several [formats](format::Format), repaired,
//! and written.
//!
//! Flow: bytes → `read` → [`Model`](model::Model) → `repair` → a scene of `radiosity`, or text of another format.
//!
//! Files of luminaires are read by `radiosity-photometry`.
//!
//! Pictures: bytes → [`picture::read`] → [`Picture`](picture::Picture).

pub mod files;
pub mod model;
pub mod names;
pub mod colour;
pub mod format;
pub mod picture;
mod budget;
mod includes;
mod xform;
pub mod merge;
mod builder;
pub mod mesh;
pub mod mgf;
pub mod rad;
pub mod stl;
pub mod ply;
pub mod obj;
pub mod gltf;
pub mod mitsuba;
pub mod vs3;
pub mod read;
pub mod write;
pub mod materials;
pub mod unit;
pub mod up;
mod fronts;
pub mod repair;
