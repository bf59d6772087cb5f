//! The language of scenes: texts, trees and built-in scenes in, valid scenes out.
//!
//! In order: `csv_rows` and `input` (bytes of files), `builtin` (the scenes that need no file), `fields`
//! (values of a tree), `terms` of schemas, `keys` (each declared once, with reader and schema) and `kinds`
//! of values, `formula` and `variables`, `json_text`, `polygon_list`, `language` and `toml_text` (text →
//! tree), `include` (trees of several files), `model_tree` and `import` (scenes of other programs → tree),
//! `tessellation` (curved → flat), `shape` and `file` (tree → as typed), `merging`, `instances`, `export`
//! (a scene for other programs), `textures`, `validation`, `luminaires` and `motions` (as typed → parts of
//! a scene), `reading` (all of that in its order) and `writing` (back), and `schema` (the same language for
//! editors).
//!
//! Imports `geom`, `work`, `photometry`, `formats` and `scene`.

pub mod csv_rows;
pub mod input;
mod builtin;
mod fields;
mod terms;
mod keys;
mod kinds;
mod formula;
mod variables;
mod json_text;
mod polygon_list;
mod language;
mod toml_text;
mod include;
mod model_tree;
mod import;
mod tessellation;
mod shape;
mod file;
mod merging;
mod instances;
mod export;
mod textures;
mod validation;
mod luminaires;
mod motions;
mod reading;
mod writing;
mod schema;

pub use builtin::Builtin;
pub use builtin::Parameter;
pub use import::Import;
pub use model_tree::model_text;
pub use reading::{builtin, builtins, load, read, read_with, source, source_by};
pub use schema::schema;
pub use writing::{model, text};
