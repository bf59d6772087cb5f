//! What leaves the library: pictures, grids of means, values at points, view factors, reports.

pub mod image;
pub mod reader;
pub mod grid;
pub mod probe;
pub mod render;
pub mod report;
pub mod solution_file;
pub mod view_factors;
