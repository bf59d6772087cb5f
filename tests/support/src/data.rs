//! The tables of `tests/data`: exact transfers and solutions, made elsewhere.

use std::path::{Path, PathBuf};

use radiosity::geom::DVec3;
use serde_json::Value;

/// A file that lies at this path from the root of the repository.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

/// The text of such a file.
#[track_caller]
pub fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A table of `tests/data`.
#[track_caller]
pub fn table(name: &str) -> Value {
    serde_json::from_str(&text(&format!("tests/data/{name}")))
        .unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The items of a list.
#[track_caller]
pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("no list: {value}"))
}

/// The value as a number.
#[track_caller]
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

/// A list of numbers.
#[track_caller]
pub fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// A list of three numbers.
#[track_caller]
pub fn point(value: &Value) -> DVec3 {
    DVec3::from_slice(&numbers(value))
}
