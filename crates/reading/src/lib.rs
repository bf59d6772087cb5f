//! Light read from a solution, with its errors, warnings and report.
//!
//! In order: values on a grid of points ([`field`]), warnings, light at points and sensors ([`reader`],
//! [`probe`], [`grid`], [`uniformity`], [`plane_figures`]) with its errors ([`read_error`], [`quality`],
//! [`own_error`]), the cost of a run ([`run_cost`]) and what a referee says of what is printed
//! ([`checked_readings`]), of a solution ([`judging`]) and of view factors ([`judged_factors`],
//! [`checked_factors`]), the report of a run ([`report`], [`rank_work`], [`checkpoint`]), light of pixels and
//! texels ([`pictures`]), and solutions in files ([`files`]: our own, and curved cells of VTK).
//!
//! Imports `core`, `geom`, `solvers`, `work`, `scene`, `language`, `audit`, `visibility`, `elements`,
//! `kernel`, `transport`, `light`, `published` and `solve`.

pub mod field;
pub mod warning;
pub mod uniformity;
pub mod quantity;
pub mod exposure;
pub mod difference;
pub mod reader;
pub mod cell_counts;
pub mod grid;
pub mod probe;
pub mod read_error;
pub mod plane_figures;
pub mod quality;
pub mod own_error;
pub mod run_cost;
pub mod checked_readings;
pub mod judging;
pub mod judged_factors;
pub mod checked_factors;
pub mod accuracy_warning;
pub mod rank_work;
pub mod checkpoint;
mod masked_surfaces;
pub mod report;
pub mod row_sums;
pub mod surface_light;
pub mod pictures;
pub mod files;
