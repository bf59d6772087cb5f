//! Readings of a solution: light at points and on grids, its uniformity and errors, reports and warnings.

pub mod warning;
pub mod uniformity;
pub mod shown;
pub mod difference;
pub mod reader;
pub mod grid;
pub mod probe;
pub mod read_error;
pub mod plane_figures;
pub mod quality;
pub mod missed;
pub(crate) mod peak_memory;
pub mod rank_work;
pub mod checkpoint;
pub mod report;
pub mod row_sums;
pub mod surface_light;
