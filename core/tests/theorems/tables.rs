//! The reference tables of `tests/data`: 28 digits, made with 60.

use std::path::Path;

use serde_json::Value;

/// The array "tables" of a file.
pub(crate) fn tables(name: &str) -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    let text = std::fs::read_to_string(path).expect("the reference tables are part of the package");
    let Value::Object(mut file) = serde_json::from_str(&text).expect("the tables are JSON") else { panic!() };
    let Some(Value::Array(tables)) = file.remove("tables") else { panic!("no tables in {name}") };
    assert!(!tables.is_empty());
    tables
}

/// The decimal strings under a key.
pub(crate) fn decimals(table: &Value, key: &str) -> Vec<String> {
    let entries = table[key].as_array().expect("an array of decimals");
    entries.iter().map(|entry| entry.as_str().expect("a decimal").to_owned()).collect()
}

/// The decimals under a key, rounded to floats.
pub(crate) fn floats(table: &Value, key: &str) -> Vec<f64> {
    decimals(table, key).iter().map(|text| text.parse().expect("a decimal")).collect()
}

/// A whole number under a key.
pub(crate) fn integer(table: &Value, key: &str) -> usize {
    table[key].as_u64().expect("a whole number") as usize
}

/// A number under a key.
pub(crate) fn number(table: &Value, key: &str) -> f64 {
    table[key].as_f64().expect("a number")
}
