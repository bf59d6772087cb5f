//! The JSON schema of the scene format: it takes whatever is a scene, tells of every key, and refuses what is
//! wrong.

use std::collections::BTreeSet;

use jsonschema::Validator;
use radiosity::{language::schema, scene::Fault};
use radiosity_test_support::data;
use serde_json::{Value, json};

fn validator() -> Validator {
    jsonschema::draft202012::new(&schema()).expect("the schema is one")
}

fn of_toml(text: &str) -> Value {
    let tree: toml::Value = toml::from_str(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    serde_json::to_value(tree).expect("no number of a scene is NaN")
}

/// The scenes of the document, in TOML, as files of a scene of several, and in JSON.
fn documented() -> Vec<Value> {
    let text = data::text("docs/scene.md");
    let blocks = text.split("```").skip(1).step_by(2);
    let scene = |block: &str| {
        let (language, text) = block.split_once('\n')?;
        match language.split(' ').next()? {
            "toml" => Some(of_toml(text)),
            "json" => Some(serde_json::from_str(text).unwrap()),
            _ => None,
        }
    };
    blocks.filter_map(scene).collect()
}

#[track_caller]
fn accepted(validator: &Validator, scene: &Value) {
    let errors: Vec<String> =
        validator.iter_errors(scene).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{errors:?}\n{scene:#}");
}

#[test]
fn the_schema_is_a_schema() {
    let errors: Vec<String> = jsonschema::meta::validator_for(&schema())
        .unwrap()
        .iter_errors(&schema())
        .map(|e| e.to_string())
        .collect();
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

#[test]
fn whatever_is_a_scene_is_accepted() {
    let validator = validator();
    let documented = documented();
    assert!(documented.len() > 20, "{} scenes of the document", documented.len());
    documented.iter().for_each(|scene| accepted(&validator, scene));
    for name in radiosity::language::builtin_names() {
        accepted(&validator, &of_toml(&radiosity::language::text_of(name, &[]).unwrap().text()));
    }
    for file in ["tests/data/every-shape.toml", "examples/office.toml", "examples/textured-room.toml"] {
        let text = data::text(file);
        accepted(&validator, &of_toml(&text));
    }
}

/// The keys that may stand in place of `none`.
fn known(text: &str) -> Vec<&'static str> {
    match radiosity::language::from_toml(text, "none").expect_err("no key is called none").fault {
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

/// A scene with every kind of thing, to be broken in one place.
fn scene() -> Value {
    json!({
        "bands": ["grey"], "unit": "lx",
        "variables": {"width": 2, "half": "=width/2"},
        "camera": {"eye": [0, 0, 1], "target": [0, 0, 0]},
        "planes": {"desk": {"origin": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]], "spacing": 0.1}},
        "materials": {"white": {"reflectance": 0.5, "emission": [1]}},
        "parts": {"lamp": {"surfaces": [{"sphere": {"center": [0, 0, 0], "radius": "=half"}}]}},
        "surfaces": [
            {"name": "floor", "material": "white", "order": 2, "subdivide": [2, 1],
             "transform": {"scale": 2, "rotate": [0, 0, 1, 90]},
             "quad": {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}},
            {"material": "white", "box": {"origin": [0, 0, 2], "size": [1, 1, 1], "open": ["top"]}}
        ],
        "instances": [{"part": "lamp", "array": {"count": [2, 2], "step": [[1, 0, 0], [0, 1, 0]]}}]
    })
}

#[test]
fn wrong_scenes_are_refused() {
    let validator = validator();
    accepted(&validator, &scene());
    let floor = "/surfaces/0";
    for (place, key, value) in [
        ("", "tilte", json!("a slip")),
        ("", "title", json!(" ")),
        ("", "bands", json!([])),
        ("", "bands", json!(["a", "a"])),
        ("", "unit", json!("watts per square metre")),
        ("", "include", json!([1])),
        ("/variables", "wi-dth", json!(1)),
        ("/variables", "width", json!("2")),
        ("/camera", "fov", json!(180)),
        ("/camera", "width", json!(1.5)),
        ("/camera", "eye", json!([0, 0])),
        ("/planes/desk", "spacing", json!(0)),
        ("/planes/desk", "spacing", json!([0.1, 0.1, 0.1])),
        ("/materials/white", "reflectance", json!(1)),
        ("/materials/white", "reflectance", json!([0.5, -0.1])),
        ("/materials/white", "emission", json!(-1)),
        ("/materials/white", "transmittance", json!(1)),
        ("/materials/white", "reflectance", json!({})),
        ("/materials/white", "reflectance", json!({"image": " "})),
        ("/materials/white", "reflectance", json!({"cells": []})),
        ("/materials/white", "reflectance", json!({"cells": [[0.5]], "polynomial": []})),
        ("/materials/white", "emission", json!({"cells": [[0.5]], "wrap": "tile"})),
        ("/materials/white", "emission", json!({"cells": [[0.5]], "scale": 0})),
        ("/materials/white", "emission", json!({"polynomial": [[0, 0]]})),
        ("/materials/white", "emission", json!({"polynomial": [[0, 0, 1]], "factor": -1})),
        (floor, "back_material", json!(3)),
        ("/materials/white", "colour", json!("red")),
        (floor, "order", json!(21)),
        (floor, "subdivide", json!([0, 1])),
        (floor, "flux", json!("bright")),
        (floor, "two_sided", json!("yes")),
        (floor, "triangle", json!({"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]})),
        (floor, "quad", json!({"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]]})),
        (floor, "quad", json!({"vertexes": []})),
        (floor, "transform", json!({"scale": 0})),
        (floor, "transform", json!({"rotate": [0, 0, 1]})),
        ("/surfaces/1/box", "size", json!([1, 1, 0])),
        ("/surfaces/1/box", "corners", json!([[0, 0, 0], [1, 1, 1]])),
        ("/surfaces/1/box", "open", json!(["ceiling"])),
        ("/parts/lamp", "legs", json!(4)),
        ("/instances/0", "part", json!(3)),
        ("/instances/0/array", "count", json!(0)),
        ("/instances/0/array", "count", json!([1, 1, 1, 1])),
        ("/instances/0/array", "step", json!([1, 0])),
    ] {
        let mut wrong = scene();
        wrong.pointer_mut(place).unwrap()[key] = value.clone();
        assert!(!validator.is_valid(&wrong), "{place}/{key} = {value}");
        assert!(
            radiosity::language::from_json(&wrong.to_string(), "wrong.json").is_err(),
            "{place}/{key} = {value}"
        );
    }
    for (place, key) in [
        ("/surfaces/0", "quad"),
        ("/surfaces/1/box", "size"),
        ("/materials/white", "reflectance"),
        ("/instances/0", "part"),
        ("/camera", "target"),
    ] {
        let mut wrong = scene();
        wrong.pointer_mut(place).unwrap().as_object_mut().unwrap().remove(key);
        assert!(!validator.is_valid(&wrong), "{place} without {key}");
    }
    assert!(!validator.is_valid(&json!([[[0, 0], [1, 0], [0, 1]]])));
    assert!(!validator.is_valid(&json!("a text")));
}

/// Extents are a diameter, two sides, formulas of them, or the word `file`.
#[test]
fn extents_are_lengths_or_that_of_the_file() {
    let validator = validator();
    let with = |extent: Value| {
        let mut scene = scene();
        scene["luminaires"] = json!([{"position": [0, 0, 1], "point": {}, "flux": 1, "extent": extent}]);
        scene
    };
    for extent in [json!(0.3), json!("=half"), json!([1.2, 0]), json!(["=half", 0.3]), json!("file")] {
        accepted(&validator, &with(extent));
    }
    for extent in
        [json!(0), json!(-1), json!([1]), json!([1, -1]), json!([1, 1, 1]), json!("area"), json!(true)]
    {
        assert!(!validator.is_valid(&with(extent.clone())), "{extent}");
    }
}
