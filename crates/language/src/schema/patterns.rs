//! Patterns of materials in the schema.

use serde_json::{Value, json};

use super::terms::{exactly, or, per_band, ranged, reference, table, text, with};

/// A value in whose place a pattern may stand.
pub(super) fn or_pattern(value: Value) -> Value {
    let mut kinds = value["anyOf"].as_array().cloned().unwrap_or_default();
    kinds.push(reference("pattern"));
    with(value, "anyOf", kinds.into())
}

/// A table in place of the numbers of a material.
pub(super) fn pattern() -> Value {
    let factor = per_band(json!({ "minimum": 0, "maximum": 1e30 }), "Times its numbers");
    let scale = ranged(json!({ "exclusiveMinimum": 0, "maximum": 1e6 }), "How often it fits");
    let two = with(exactly(2, "number", "Along u and along v"), "items", scale.clone());
    let scale = json!({
        "description": "How often it fits along u and v", "anyOf": [scale["anyOf"][0], scale["anyOf"][1], two],
    });
    let row = |least: usize| json!({ "type": "array", "items": reference("number"), "minItems": least });
    let rows = json!({ "type": "array", "items": row(1), "minItems": 1 });
    let terms = json!({ "type": "array", "items": exactly(3, "number", "Powers of u and v, and a factor") });
    let each = |one: Value, description: &str| {
        let list = json!({ "type": "array", "items": one, "minItems": 1 });
        json!({ "description": description, "anyOf": [one, list] })
    };
    let words = |description: &str, words: &[&str]| json!({ "description": description, "type": "string", "enum": words });
    let keys = vec![
        ("image", text("Path of a picture, PNG or OpenEXR, from the folder of this file")),
        ("cells", each(rows, "Rows of numbers from the top, v = 1, for all bands or for each")),
        ("polynomial", each(terms, "Terms [i, j, c] of the sum of c u^i v^j, for all bands or for each")),
        ("scale", or(json!(1), scale)),
        ("offset", or(json!([0, 0]), exactly(2, "number", "How much of it is passed at u = −1, v = −1"))),
        ("wrap", or(json!("repeat"), words("What is beyond its border", &["repeat", "mirror", "clamp"]))),
        ("encoding", words("How the numbers of a picture stand for light", &["srgb", "linear"])),
        ("factor", or(json!(1), factor)),
    ];
    let one = json!([{ "required": ["image"] }, { "required": ["cells"] }, { "required": ["polynomial"] }]);
    with(table("What varies over a surface", &[], keys), "oneOf", one)
}
