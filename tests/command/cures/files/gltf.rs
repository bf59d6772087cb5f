//! Faults of glTF files.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.gltf",
    changed: "scene.gltf",
    arguments: &[],
    files: &[(
        "scene.gltf",
        r#"{"asset": {"version": "2.0"},
"scene": 0,
"scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "metallicFactor": 0}, "emissiveFactor": [1, 1, 1]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}],
"accessors": [
{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
{"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}],
"bufferViews": [
{"buffer": 0, "byteLength": 48},
{"buffer": 0, "byteOffset": 48, "byteLength": 6}],
"buffers": [{"byteLength": 54, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAECAAID"}]}
"#,
    )],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: r#""2.0""#,
        bad: "2",
        cured: r#""2.0""#,
        told: &["the file: invalid type", "help: correct it, or export the model again"],
    },
    Row {
        part: r#""2.0""#,
        bad: r#""1.0""#,
        cured: r#""2.0""#,
        told: &["the version is '1.0'", "help: export the model as glTF 2.0"],
    },
    Row {
        part: r#""scene": 0,"#,
        bad: r#""scene": 0, "extensionsRequired": ["KHR_draco_mesh_compression"],"#,
        cured: r#""scene": 0,"#,
        told: &[
            "the extension KHR_draco_mesh_compression is required",
            "help: export the model without it, without compression",
        ],
    },
    Row {
        part: r#""scene": 0"#,
        bad: r#""scene": 7"#,
        cured: r#""scene": 0"#,
        told: &[
            "the scene 7 is named, 1 are listed, from 0 on",
            "help: correct the index, or export the model again",
        ],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"children": [0]}"#,
        cured: r#"{"mesh": 0}"#,
        told: &[
            "the node 0 has two parents, or is below itself",
            "help: correct the lists of children, or export the model again",
        ],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"mesh": 0, "rotation": [0, 0, 0, 0]}"#,
        cured: r#"{"mesh": 0, "rotation": [0, 0, 0, 1]}"#,
        told: &["the rotation of the node has no direction", "help: give it a quaternion of length 1"],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"mesh": 0, "rotation": [0, 0, 0, 0]}"#,
        cured: r#"{"mesh": 0}"#,
        told: &["the rotation of the node has no direction", "or take it out"],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"mesh": 0, "scale": [1e60, 1, 1]}"#,
        cured: r#"{"mesh": 0, "scale": [1, 1, 1]}"#,
        told: &["a coordinate is beyond 1e50", "or scale the model down"],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"camera": 0}"#,
        cured: r#"{"mesh": 0, "camera": 0}"#,
        told: &["the file holds no triangles in its scene", "help: save the model with polygons"],
    },
    Row {
        part: r#""indices": 1"#,
        bad: r#""indices": 0"#,
        cured: r#""indices": 1"#,
        told: &[
            "indices cannot be VEC3 of component type 5126",
            "help: export the model again; points are VEC3 of floats, indices SCALAR of unsigned integers",
        ],
    },
    Row {
        part: r#""POSITION": 0"#,
        bad: r#""POSITION": 1"#,
        cured: r#""POSITION": 0"#,
        told: &[
            "points cannot be SCALAR of component type 5121",
            "help: export the model again; points are VEC3 of floats",
        ],
    },
    Row {
        part: r#""material": 0"#,
        bad: r#""material": 1"#,
        cured: r#""material": 0"#,
        told: &["the material 1 is named, 1 are listed, from 0 on", "help: correct the index"],
    },
    Row {
        part: r#""count": 4"#,
        bad: r#""count": 3"#,
        cured: r#""count": 4"#,
        told: &[
            "a triangle has a vertex beyond the 3 that are listed",
            "help: correct the index, or export the model again",
        ],
    },
    Row {
        part: r#""count": 4"#,
        bad: r#""count": 5"#,
        cured: r#""count": 4"#,
        told: &[
            "5 rows of 12 bytes, 12 apart, do not fit behind byte 0 of a view of 48",
            "help: correct it, or export the model again",
        ],
    },
    Row {
        part: r#""count": 4"#,
        bad: r#""count": 99999999999"#,
        cured: r#""count": 4"#,
        told: &["it has more than 40000000 rows", "help: split the model"],
    },
    Row {
        part: "5126",
        bad: "5127",
        cured: "5126",
        told: &["there is no component type 5127", "help: correct it, or export the model again"],
    },
    Row {
        part: r#""count": 6"#,
        bad: r#""count": 5"#,
        cured: r#""count": 6"#,
        told: &[
            "triangles have 5 corners, no multiple of 3",
            "help: correct the count, or export the model again",
        ],
    },
    Row {
        part: r#""byteLength": 6}"#,
        bad: r#""byteLength": 7}"#,
        cured: r#""byteLength": 6}"#,
        told: &[
            "the view spans 7 bytes from byte 48 on; the buffer has 54",
            "help: correct it, or export the model again",
        ],
    },
    Row {
        part: r#""byteLength": 54"#,
        bad: r#""byteLength": 55"#,
        cured: r#""byteLength": 54"#,
        told: &["the buffer 0: it has 54 bytes, 55 are announced", "help: copy or export the model again"],
    },
    Row {
        part: ";base64,",
        bad: ",",
        cured: ";base64,",
        told: &["the buffer 0: its data is not base64", "help: write it as 'data:…;base64,…'"],
    },
    Row {
        part: "base64,",
        bad: "base64,*",
        cured: "base64,",
        told: &[
            "the buffer 0: its data (application/octet-stream;base64): Invalid symbol 42",
            "help: export the model again",
        ],
    },
    Row {
        part: r#", "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAECAAID""#,
        bad: "",
        cured: r#", "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAECAAID""#,
        told: &["the buffer 0: it has no uri, and no binary chunk holds it", "help: export the model again"],
    },
    Row {
        part: "[0.5, 0.5, 0.5, 1]",
        bad: "[-0.5, 0.5, 0.5, 1]",
        cured: "[0.5, 0.5, 0.5, 1]",
        told: &[
            "the material 0 has a factor below 0 or beyond measure, or a metallic factor above 1",
            "help: correct its colours; factors are from 0 to 1",
        ],
    },
    Row {
        part: r#"{"mesh": 0}"#,
        bad: r#"{"mesh": 0, "camera": 0, "scale": [1, 1, 0]}"#,
        cured: r#"{"mesh": 0, "camera": 0, "scale": [1, 1, 1]}"#,
        told: &["the camera 0 has an angle of 28.6", "and scale its node by other than 0"],
    },
    Row {
        part: r#""bufferView": 0, "componentType": 5126"#,
        bad: r#""componentType": 5126"#,
        cured: r#""bufferView": 0, "componentType": 5126"#,
        told: &[
            "its points are all 0: it has neither a buffer view nor sparse values",
            "help: export the model without compression",
        ],
    },
    Row {
        part: r#""count": 4, "type": "VEC3""#,
        bad: r#""count": 4, "type": "VEC3", "sparse": {"count": 5, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}}"#,
        cured: r#""count": 4, "type": "VEC3""#,
        told: &["it replaces 5 of 4 rows", "help: correct it, or export the model again"],
    },
    Row {
        part: r#""count": 4, "type": "VEC3""#,
        bad: r#""count": 3, "type": "VEC3", "sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 5, "componentType": 5121}, "values": {"bufferView": 0}}"#,
        cured: r#""count": 4, "type": "VEC3""#,
        told: &["it replaces a row beyond the 3 that it has", "help: correct it, or export the model again"],
    },
];
