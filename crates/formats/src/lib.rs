//! Scenes of other programs: a [`Model`](model::Model) is read from one of several [formats](format::Format),
//! repaired, and written.
//!
//! Flow: bytes → [`read`] → `Model` → [`repair`] → a scene of `radiosity`, or text of another format
//! (`write`). Files of luminaires are read by `photometry`.
//!
//! In order: [`tolerances`], [`model`], `names` and `colour` (what readers make); [`format`](mod@format)
//! (which there are); [`picture`] (PNG and OpenEXR → numbers of texels); `lines`, `scalar`, `budget`,
//! `includes`, `xform`, `merge`, `face_normals`, `opposed_faces`, `builder` and [`mesh`] (what readers
//! share); the readers, `mgf` to `vs3`, three with a writer; `read` and `write` (any of them); `materials`,
//! `unit` and `up` (what a file does not state); `fronts` and [`repair`].
//!
//! Imports `geom`, `work`, `fit` and `photometry`.

pub mod tolerances;
pub mod model;
pub mod names;
pub mod colour;
pub mod format;
pub mod picture;
mod lines;
mod scalar;
mod budget;
mod includes;
mod xform;
pub mod merge;
mod face_normals;
mod opposed_faces;
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
