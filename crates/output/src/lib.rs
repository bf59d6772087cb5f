//! Output of the library: pictures, charts, values at points, grids of means, view factors, reports.

pub mod drawings;
pub mod readings;
pub mod pictures;
pub mod files;
pub mod documents;
