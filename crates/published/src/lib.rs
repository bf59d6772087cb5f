//! Methods of four papers, beside the Galerkin method of this library.
//!
//! In order: `zatz1993` (Zatz 1993: Legendre transfers and shadow masks), `collocation` (light that is right
//! at points), `hierarchy` (hierarchical radiosity with links), `bases` (Szirmay-Kalos 1996: variational
//! forms in any functions), `series` and `expansions` (Arquès, Biri and Michelin 2001: transfers between
//! displaced elements as power series).
//!
//! Imports `core`, `geom`, `solvers`, `work`, `scene`, `visibility`, `elements`, `kernel`, `transport` and
//! `light`.

pub mod zatz1993;
pub mod collocation;
pub mod hierarchy;
pub mod bases;
pub mod series;
pub mod expansions;
