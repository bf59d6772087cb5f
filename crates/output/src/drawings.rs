//! Drawings in vectors: scales, lines, letters, charts, isolines and plans.

pub mod decades;
pub mod mark;
pub mod round;
pub(crate) mod segment;
pub(crate) mod interpolant;
pub mod picture;
pub(crate) mod stroke;
pub(crate) mod track;
mod isolines;
pub(crate) mod lettering;
pub(crate) mod canvas;
pub(crate) mod label;
mod labelled;
pub mod chart;
pub mod scale;
pub mod false_colour;
pub mod legend;
pub(crate) mod plan;
