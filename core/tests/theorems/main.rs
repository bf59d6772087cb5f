//! Theorems about the crate, and tables made elsewhere.

mod bases;
mod connection;
mod conversion;
mod matrices;
mod oracle;
mod readme;
mod rules;
mod tables;
mod values;
