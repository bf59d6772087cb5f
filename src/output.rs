//! What leaves the library: pictures, charts, values at points, grids of means, view factors, reports.

pub mod decades;
pub mod field;
pub mod difference;
pub mod reader;
pub mod grid;
pub mod picture;
pub(crate) mod lettering;
pub(crate) mod canvas;
pub mod chart;
pub mod pinhole;
pub mod probe;
pub mod quality;
pub mod raster;
pub mod exr_file;
pub mod image;
pub mod render;
pub mod missed;
pub mod report;
pub mod scale;
pub mod false_colour;
pub mod legend;
pub mod solution_file;
pub mod view_factors;
pub mod wireframe;
