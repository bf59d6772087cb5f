//! High-order Galerkin radiosity on curved, untessellated surfaces.

pub mod scene;
