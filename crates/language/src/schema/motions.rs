//! Motions in the schema.

use serde_json::{Value, json};

use super::terms::{exactly, list, of, or, reference, table, text, truth, with};

/// `[[motion]]`.
pub(super) fn motion() -> Value {
    let keys = vec![
        ("name", text("Its name, given once in the scene")),
        ("surfaces", names("Surfaces that move, by name; a * stands for any ending")),
        ("instances", names("Instances that move with all that is in them")),
        ("luminaires", names("Luminaires that move")),
        ("camera", truth("The camera moves along")),
        ("translate", translate()),
        ("rotate", rotate()),
    ];
    let one = json!([{ "required": ["translate"] }, { "required": ["rotate"] }]);
    with(table("What moves together along a rigid path", &[], keys), "anyOf", one)
}

fn names(description: &str) -> Value {
    let name = text("A name");
    json!({ "description": description, "anyOf": [name, { "type": "array", "items": name }] })
}

fn translate() -> Value {
    let keys = vec![
        ("points", list("vector", "How far it is from where it rests", 2)),
        ("times", times()),
        ("curve", curve()),
    ];
    table("How far it is moved", &["points"], keys)
}

fn rotate() -> Value {
    let turns = json!({
        "description": "Rotations about several axes", "type": "array", "minItems": 2,
        "items": exactly(4, "number", "Axis x, y, z and degrees about it"),
    });
    let keys = vec![
        ("center", of("point", "It stays where it is")),
        ("axis", of("vector", "The axis through the centre")),
        ("angles", list("number", "How far it is turned from where it rests, degrees", 2)),
        ("turns", turns),
        ("times", times()),
        ("curve", curve()),
    ];
    let angles = json!({ "required": ["axis", "angles"], "not": { "required": ["turns"] } });
    let turns = json!({
        "required": ["turns"],
        "not": { "anyOf": [{ "required": ["axis"] }, { "required": ["angles"] }, { "required": ["curve"] }] },
    });
    with(table("How far it is turned", &["center"], keys), "oneOf", json!([angles, turns]))
}

fn times() -> Value {
    let times = with(reference("number"), "description", "A time".into());
    json!({ "description": "When, in ascending order; at equal steps unless given", "type": "array", "items": times })
}

fn curve() -> Value {
    let curves =
        json!({ "description": "What is between two of them", "type": "string", "enum": ["line", "spline"] });
    or(json!("line"), curves)
}
