//! The scene format as a JSON schema (draft 2020-12), for editors and other programs: the schemas of all
//! tables, and the definitions that they refer to.
//!
//! It tells keys, kinds, counts and ranges. What takes a whole scene to find, such as an outline that crosses
//! itself, only reading tells.

use serde_json::{Map, Value, json};

use crate::{
    file::{
        CameraFile, InstanceFile, LuminaireFile, MaskFile, MaterialFile, MotionFile, PartFile, PatternFile,
        PlaneFile, RowsFile, SceneFile, SkyFile, SurfaceFile,
    },
    keys::KeyTable,
    kinds::TransformFile,
    shape,
    terms::{and, exactly, list, positive, ranged, reference, text, whole, with},
};

/// The dialect of JSON schemas.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The schema of a scene in TOML or JSON, or of a list of polygons in JSON.
pub fn schema() -> Value {
    let definitions: Map<String, Value> = values()
        .into_iter()
        .chain(tables())
        .chain(shape::schemas())
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    let whole = json!({
        "$schema": DIALECT, "title": "A scene of radiosity", "$defs": definitions,
        "type": ["object", "array"], "items": reference("outline"),
    });
    and(SceneFile::schema(), whole)
}

fn tables() -> Vec<(&'static str, Value)> {
    vec![
        ("camera", CameraFile::schema()),
        ("sky", SkyFile::schema()),
        ("plane", PlaneFile::schema()),
        ("material", MaterialFile::schema()),
        ("pattern", PatternFile::schema()),
        ("transform", TransformFile::schema()),
        ("surface", SurfaceFile::schema()),
        ("luminaire", LuminaireFile::schema()),
        ("part", PartFile::schema()),
        ("instance", InstanceFile::schema()),
        ("array", RowsFile::schema()),
        ("motion", MotionFile::schema()),
        ("mask", MaskFile::schema()),
    ]
}

/// Definitions that several tables refer to by name.
fn values() -> Vec<(&'static str, Value)> {
    let formula = json!({
        "description": "A formula of numbers and variables, such as \"=width/2 - 0.1\"", "type": "string",
        "pattern": "^=",
    });
    let index = whole(0, u32::MAX as usize, "An index");
    let patch = with(exactly(16, "number", "Indices of control points, from 0, row by row"), "items", index);
    let weights = with(exactly(4, "number", "Four weights, each above 0"), "items", positive("A weight"));
    vec![
        ("formula", formula),
        ("number", ranged(json!({ "minimum": -1e30, "maximum": 1e30 }), "A number or a formula")),
        ("point", exactly(3, "number", "x, y, z")),
        ("vector", exactly(3, "number", "x, y, z")),
        ("outline", list("point", "Corners in order", 3)),
        ("row", exactly(4, "point", "Four control points")),
        ("weights", weights),
        ("patch", patch),
        ("name", text("A name")),
    ]
}
