//! Helpers of several studies. Each study is a program of its own: `cargo run --release -p radiosity-studies
//! --bin read_off`.

pub mod boxes;
pub mod memory;
pub mod spread;
pub mod words;
