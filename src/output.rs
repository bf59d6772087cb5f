//! What leaves the library: pictures, grids of means, reports, view factors.

pub mod grid;
pub mod image;
pub mod render;
pub mod report;
pub mod solution_file;
pub mod view_factors;
