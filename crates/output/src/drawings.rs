//! Drawings: scales, lines, letters, diagrams, isolines and plans.

pub(crate) mod markup;
pub mod tick;
pub mod nice_numbers;
pub(crate) mod interpolant;
pub mod picture;
pub(crate) mod stroke;
pub(crate) mod polyline;
mod isolines;
pub(crate) mod lettering;
pub mod drawing;
pub mod diagram;
pub(crate) mod label;
mod labelled_isolines;
pub mod chart;
pub mod scale;
pub mod false_colour;
pub mod legend;
pub(crate) mod plan;
