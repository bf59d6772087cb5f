//! Theorems about surfaces: every shape against its definition, and the shapes together in known scenes.

mod conformance;
mod gallery;
mod random;
