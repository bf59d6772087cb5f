//! What leaves the library: pictures, charts, values at points, grids of means, view factors, reports.

pub mod canvas;
pub mod decades;
pub mod chart;
pub mod difference;
pub mod exr_file;
pub mod false_colour;
pub mod field;
pub mod reader;
pub mod grid;
pub mod image;
pub mod legend;
pub mod lettering;
pub mod picture;
pub mod pinhole;
pub mod probe;
pub mod quality;
pub mod raster;
pub mod render;
pub mod report;
pub mod scale;
pub mod solution_file;
pub mod view_factors;
pub mod wireframe;
