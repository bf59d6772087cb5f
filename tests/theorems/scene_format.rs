//! The document and the schema of the scene format are true: scenes of the document are read, every key of the
//! language stands in its table and in the schema, every shape is shown.

use std::collections::BTreeSet;
use std::fs;

use radiosity::language::{read, schema};
use radiosity::scene::{Scene, Source};
use radiosity_test_support::data;
use serde_json::Value;

/// The languages that scenes are written in.
const LANGUAGES: [&str; 3] = ["toml", "json", "csv"];

/// Tables of keys, each under a heading, and a text with the key `xyzzy`, which is like no other in such a table.
const TABLES: [(&str, &str); 16] = [
    ("## The file", "xyzzy = 1"),
    ("## Materials", "[materials.wall]\nxyzzy = 1"),
    ("## Textures", "[materials.wall]\nreflectance = { xyzzy = 1 }"),
    ("## Camera", "[camera]\nxyzzy = 1"),
    ("## Planes of sensors", "[planes.desk]\nxyzzy = 1"),
    ("## Surfaces", "[[surfaces]]\nxyzzy = 1"),
    (
        "## Placement",
        "[[surfaces]]\ntriangle = { vertices = [[0,0,0],[1,0,0],[0,1,0]] }\ntransform = { xyzzy = 1 }",
    ),
    ("## Luminaires", "[[luminaires]]\nxyzzy = 1"),
    ("## Sky and sun", "[sky]\nxyzzy = 1"),
    ("## Parts and instances", "[parts.chair]\nxyzzy = 1"),
    ("## Parts and instances", "[[instances]]\nxyzzy = 1"),
    ("## Parts and instances", "[[instances]]\npart = \"chair\"\narray = { xyzzy = 1 }"),
    ("## Motions", "[[motion]]\nxyzzy = 1"),
    ("## Motions", "[[motion]]\ntranslate = { xyzzy = 1 }"),
    ("## Motions", "[[motion]]\nrotate = { xyzzy = 1 }"),
    ("## Motions", "[[motion]]\nemission = { xyzzy = 1 }"),
];

fn document() -> String {
    data::text("docs/scene.md")
}

/// The fenced blocks of a language.
fn blocks<'a>(text: &'a str, language: &'a str) -> impl Iterator<Item = &'a str> {
    let fenced = text.split("```").skip(1).step_by(2);
    fenced.filter_map(move |block| block.strip_prefix(language)?.strip_prefix('\n'))
}

/// The scenes that the document shows in a language.
fn scenes(text: &str, language: &str) -> Vec<Scene> {
    let scene = |block: &str| {
        read(&Source::new(&format!("document.{language}"), block))
            .unwrap_or_else(|error| panic!("{error}\n{block}"))
    };
    blocks(text, language).map(scene).collect()
}

/// The part of the document from a heading to the next one.
fn section<'a>(text: &'a str, heading: &str) -> &'a str {
    let (_, rest) =
        text.split_once(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("there is no '{heading}'"));
    rest.split("\n##").next().unwrap_or_default()
}

/// The keys that may stand in place of `xyzzy`; nothing where the text is refused for another reason.
fn known(text: &str) -> Option<Vec<String>> {
    let fault = read(&Source::new("text", text)).expect_err("no key is called xyzzy").fault;
    let cure = fault.cure().filter(|_| fault.to_string() == "unknown key \"xyzzy\"")?;
    let (_, known) = cure.split_once("known keys: ")?;
    Some(known.split(", ").map(str::to_owned).collect())
}

/// The shape keys of the language, each with its fields.
fn shapes() -> Vec<(String, Vec<String>)> {
    let keys = known("[[surfaces]]\nxyzzy = 1").expect("surfaces have keys");
    // These are tables, but no shapes.
    let keys = keys.into_iter().filter(|key| !["glass", "transform"].contains(&key.as_str()));
    let fields = |key: String| Some((key.clone(), known(&format!("[[surfaces]]\n{key} = {{ xyzzy = 1 }}"))?));
    keys.filter_map(fields).collect()
}

#[test]
fn scenes_of_the_document_are_read() {
    let text = document();
    assert_eq!(text.split("```").count() % 2, 1, "a block is not closed");
    let mut count = 0;
    let mut shown = BTreeSet::new();
    for language in LANGUAGES {
        let scenes = scenes(&text, language);
        assert!(!scenes.is_empty(), "there is no example in {language}");
        count += scenes.len();
        shown.extend(scenes.iter().flat_map(|scene| scene.surfaces.iter().map(|surface| surface.kind)));
    }
    let shapes = shapes();
    assert!(shapes.len() > 10, "the shapes were found: {shapes:?}");
    assert!(count >= shapes.len(), "{count} examples of {} shapes", shapes.len());
    let missing: Vec<&str> =
        shapes.iter().map(|(key, _)| key.as_str()).filter(|key| !shown.contains(key)).collect();
    assert!(missing.is_empty(), "no example of {missing:?}");
}

/// The blocks that are files of one scene, each with its name.
fn files(text: &str) -> Vec<(&str, &str)> {
    let fenced = text.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.strip_prefix("toml ")?.split_once('\n')).collect()
}

#[test]
fn the_scene_of_several_files_is_read() {
    let text = document();
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files(&text) {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let room = folder.path().join("room.toml");
    let scene = radiosity::load(&room.to_string_lossy()).unwrap_or_else(|error| panic!("{error}"));
    scene.require_light().unwrap();
    assert_eq!(scene.surfaces.len(), 8);
    assert!(scene.surface_named("lamp[1].globe").is_ok());
}

#[test]
fn scenes_in_toml_have_light() {
    let text = document();
    for (block, scene) in blocks(&text, "toml").zip(scenes(&text, "toml")) {
        scene.require_light().unwrap_or_else(|error| panic!("{error}\n{block}"));
        assert!(scene.camera.is_some(), "no camera in\n{block}");
    }
}

#[test]
fn every_key_stands_in_its_table() {
    let text = document();
    let has = |heading: &str, keys: &[String]| {
        let section = section(&text, heading);
        let missing: Vec<&String> =
            keys.iter().filter(|key| !section.contains(&format!("`{key}`"))).collect();
        assert!(missing.is_empty(), "'{heading}' does not tell of {missing:?}");
    };
    let shapes = shapes();
    let is_shape = |key: &str| shapes.iter().any(|(shape, _)| *shape == key);
    for (heading, example) in TABLES {
        let mut keys = known(example).unwrap_or_else(|| panic!("'{example}' is refused for something else"));
        keys.retain(|key| !is_shape(key));
        assert!(keys.len() > 1, "{heading}: {keys:?}");
        has(heading, &keys);
    }
    for (key, fields) in &shapes {
        has(&format!("### `{key}`"), fields);
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
        let known = known(text).unwrap_or_else(|| panic!("'{text}' is refused for something else"));
        assert_eq!(told(table), BTreeSet::from_iter(known), "{text}");
    };
    same(&schema, "xyzzy = 1");
    let definitions = &schema["$defs"];
    for (name, text) in [
        ("camera", "[camera]\nxyzzy = 1"),
        ("plane", "[planes.desk]\nxyzzy = 1"),
        ("material", "[materials.wall]\nxyzzy = 1"),
        ("pattern", "[materials.wall]\nreflectance = { xyzzy = 1 }"),
        ("surface", "[[surfaces]]\nxyzzy = 1"),
        (
            "transform",
            "[[surfaces]]\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 1 }\ntransform = { xyzzy = 1 }",
        ),
        ("sky", "[sky]\nxyzzy = 1"),
        ("luminaire", "[[luminaires]]\nxyzzy = 1"),
        ("part", "[parts.chair]\nxyzzy = 1"),
        ("instance", "[[instances]]\nxyzzy = 1"),
        ("array", "[[instances]]\npart = \"chair\"\narray = { xyzzy = 1 }"),
    ] {
        same(&definitions[name], text);
    }
    let shapes = definitions["surface"]["oneOf"].as_array().unwrap();
    assert!(shapes.len() > 10);
    for shape in shapes {
        let key = shape["required"][0].as_str().unwrap();
        same(&definitions[key], &format!("[[surfaces]]\n{key} = {{ xyzzy = 1 }}"));
    }
}
