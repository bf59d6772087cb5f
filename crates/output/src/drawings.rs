//! Drawings in vectors: scales, lines, letters, charts, isolines and plans.

pub mod log_axis;
pub mod tick;
pub mod nice_numbers;
pub(crate) mod segment;
pub(crate) mod interpolant;
pub mod picture;
pub(crate) mod stroke;
pub(crate) mod polyline;
mod isolines;
pub(crate) mod lettering;
pub(crate) mod canvas;
pub(crate) mod label;
mod labelled_isolines;
pub mod chart;
pub mod scale;
pub mod false_colour;
pub mod legend;
pub(crate) mod plan;
