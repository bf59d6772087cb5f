//! What leaves the library: pictures, charts, grids of means, reports, view factors.

pub mod canvas;
pub mod chart;
pub mod difference;
pub mod exr_file;
pub mod false_colour;
pub mod field;
pub mod grid;
pub mod image;
pub mod legend;
pub mod lettering;
pub mod picture;
pub mod pinhole;
pub mod raster;
pub mod render;
pub mod report;
pub mod scale;
pub mod solution_file;
pub mod view_factors;
pub mod wireframe;
