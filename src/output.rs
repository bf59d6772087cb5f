//! What leaves the library: pictures, grids of means, values at points, reports.

pub mod image;
pub mod reader;
pub mod grid;
pub mod probe;
pub mod render;
pub mod report;
pub mod solution_file;
