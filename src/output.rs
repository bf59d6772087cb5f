//! What leaves the library: pictures, grids of means, reports.

pub mod grid;
pub mod image;
pub mod render;
pub mod report;
pub mod solution_file;
