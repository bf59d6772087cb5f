//! Output of the library: values at points, pictures, files for other programs, and documents for people.
//!
//! In order: [`drawings`] (charts, scales, isolines and plans, in vectors and pixels), [`readings`] (of a
//! solution: points, grids, planes, reports, warnings), [`pictures`] (cameras, samples, light maps,
//! triangles), [`files`] (solutions, view factors, OpenEXR, VTK, glTF) and [`documents`] (reports in HTML and
//! Markdown, plans, the viewer).
//!
//! Imports `core`, `geom`, `solvers`, `work`, `scene`, `language`, `visibility`, `elements`, `kernel`,
//! `transport`, `light`, `published`, `solve` and `heat`.

pub mod drawings;
pub mod readings;
pub mod pictures;
pub mod files;
pub mod documents;
