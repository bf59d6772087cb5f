//! Theorems about surfaces: every shape against its definition, and the shapes together in known scenes.

mod catalogue;
mod conformance;
mod contacts;
mod first_hits;
mod scenes;
mod teapot;
