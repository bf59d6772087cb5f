//! Theorems about the crate, and tables made elsewhere.

mod bases;
mod conversion;
mod matrices;
mod oracle;
mod rules;
mod tables;
mod values;
