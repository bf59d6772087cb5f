//! Terms that schemas are made of: texts, numbers, points, tables.

use serde_json::{Value, json};

/// A table of any names, all of whose values are of one kind.
pub(super) fn by_name(description: &str, kind: &str) -> Value {
    json!({
        "description": description, "type": "object", "additionalProperties": reference(kind),
        "propertyNames": { "pattern": "\\S" },
    })
}

/// A definition of the schema.
pub(super) fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/$defs/{name}") })
}

/// A list of values of a kind that is defined, at least `least` of them.
pub(super) fn list(kind: &str, description: &str, least: usize) -> Value {
    json!({ "description": description, "type": "array", "items": reference(kind), "minItems": least })
}

/// Exactly `count` values of a kind that is defined.
pub(super) fn exactly(count: usize, kind: &str, description: &str) -> Value {
    with(list(kind, description, count), "maxItems", count.into())
}

/// A text that is not blank.
pub(super) fn text(description: &str) -> Value {
    json!({ "description": description, "type": "string", "pattern": "\\S" })
}

/// `true` or `false`.
pub(super) fn truth(description: &str) -> Value {
    json!({ "description": description, "type": "boolean", "default": false })
}

/// A number, or a formula of one, with the bounds of `range`, such as `exclusiveMinimum`.
pub(super) fn ranged(range: Value, description: &str) -> Value {
    let number = with(range, "type", "number".into());
    json!({ "description": description, "anyOf": [number, reference("formula")] })
}

/// A number above 0, or a formula of one.
pub(super) fn positive(description: &str) -> Value {
    ranged(json!({ "exclusiveMinimum": 0, "maximum": 1e30 }), description)
}

/// A whole number from `least` to `most`, or a formula of one.
pub(super) fn whole(least: usize, most: usize, description: &str) -> Value {
    let number = json!({ "type": "integer", "minimum": least, "maximum": most });
    json!({ "description": description, "anyOf": [number, reference("formula")] })
}

/// One number for all bands, or a list with one per band.
pub(super) fn per_band(range: Value, description: &str) -> Value {
    let number = ranged(range, "The number of a band");
    let list = json!({ "type": "array", "items": number, "minItems": 1 });
    json!({ "description": description, "anyOf": [number["anyOf"][0], number["anyOf"][1], list] })
}

/// An object with one more entry.
pub(super) fn with(mut object: Value, key: &str, value: Value) -> Value {
    object[key] = value;
    object
}

/// An object with the entries of another one.
pub(super) fn and(mut object: Value, more: Value) -> Value {
    for (key, value) in more.as_object().into_iter().flatten() {
        object[key] = value.clone();
    }
    object
}

/// The range of numbers from 0 on.
pub(super) fn at_least_zero() -> Value {
    json!({ "minimum": 0, "maximum": 1e30 })
}

/// Of the keys of a table `how` many have to be there: `oneOf` them or `anyOf` them.
pub(super) fn required(how: &str, keys: &[&str]) -> Value {
    let alternatives: Vec<Value> = keys.iter().map(|key| json!({ "required": [key] })).collect();
    json!({ how: alternatives })
}

/// A word among those known.
pub(super) fn words(known: &[&str]) -> Value {
    json!({ "type": "string", "enum": known })
}
