//! Output of the library: pictures, files for other programs, and documents for people.
//!
//! In order: [`table`] (columns and rows, as CSV, JSON and text), [`drawings`] (diagrams, scales, isolines
//! and plans, in vectors and pixels), [`pictures`] (tones, images, triangles), [`files`] (view factors,
//! OpenEXR, glTF) and [`documents`] (reports in HTML and Markdown, plans, the viewer).
//!
//! Imports `geom`, `work`, `scene`, `audit`, `visibility`, `elements`, `solve`, `reading` and `heat`.

pub mod table;
pub mod drawings;
pub mod pictures;
pub mod files;
pub mod documents;
