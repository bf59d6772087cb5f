//! The JSON schema of the scene format tells of every key. What it takes and refuses is tested with the validator of
//! Python (`python/tests/test_schema.py`).

use std::collections::BTreeSet;

use radiosity::scene::Source;
use radiosity::{language::schema, scene::Fault};
use serde_json::Value;

/// The keys that may stand in place of `none`.
fn known(text: &str) -> Vec<&'static str> {
    match radiosity::language::read(&Source::new("none", text)).expect_err("no key is called none").fault {
        Fault::UnknownKey { key, known } if key == "none" => known,
        fault => panic!("{text}: {fault}"),
    }
}

#[test]
fn the_schema_tells_of_every_key_and_no_other() {
    let schema = schema();
    let told = |table: &Value| -> BTreeSet<String> {
        let keys = table["properties"].as_object().unwrap_or_else(|| panic!("{table:#} has no keys"));
        let described = |value: &Value| value.get("description").is_some() || value.get("$ref").is_some();
        assert!(keys.values().all(described), "{table:#}");
        keys.keys().cloned().collect()
    };
    let same = |table: &Value, text: &str| {
        let known: BTreeSet<String> = known(text).into_iter().map(str::to_owned).collect();
        assert_eq!(told(table), known, "{text}");
    };
    same(&schema, "none = 1");
    let definitions = &schema["$defs"];
    for (name, text) in [
        ("camera", "[camera]\nnone = 1"),
        ("plane", "[planes.desk]\nnone = 1"),
        ("material", "[materials.wall]\nnone = 1"),
        ("pattern", "[materials.wall]\nreflectance = { none = 1 }"),
        ("surface", "[[surfaces]]\nnone = 1"),
        (
            "transform",
            "[[surfaces]]\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 1 }\ntransform = { none = 1 }",
        ),
        ("sky", "[sky]\nnone = 1"),
        ("luminaire", "[[luminaires]]\nnone = 1"),
        ("part", "[parts.chair]\nnone = 1"),
        ("instance", "[[instances]]\nnone = 1"),
        ("array", "[[instances]]\npart = \"chair\"\narray = { none = 1 }"),
    ] {
        same(&definitions[name], text);
    }
    let shapes = definitions["surface"]["oneOf"].as_array().unwrap();
    assert!(shapes.len() > 10);
    for shape in shapes {
        let key = shape["required"][0].as_str().unwrap();
        same(&definitions[key], &format!("[[surfaces]]\n{key} = {{ none = 1 }}"));
    }
}
