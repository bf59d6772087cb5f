//! Theorems about the crate, and tables made elsewhere.

mod bases;
mod conversion;
mod matrices;
mod readme;
mod rules;
mod tables;
mod values;
