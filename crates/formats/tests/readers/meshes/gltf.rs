//! glTF and GLB.

use std::f64::consts::PI;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use glam::DVec3;
use radiosity_formats::gltf::read;
use radiosity_formats::model::{Model, Sides};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;

use crate::measures::{assert_cube, names, notes};
use crate::memory::Memory;
use crate::meshes::shapes::{assert_refusal, corner, region, triangles};

/// Corners of the cube as floats, then its triangles as bytes: 96 and 36 bytes.
pub(crate) fn buffer() -> Vec<u8> {
    let floats = (0..8).flat_map(corner).flat_map(|value| (value as f32).to_le_bytes());
    floats.chain(triangles().concat().into_iter().map(|corner| corner as u8)).collect()
}

fn uri(bytes: &[u8]) -> String {
    format!("data:application/octet-stream;base64,{}", BASE64_STANDARD.encode(bytes))
}

/// A file of a cube; `uri` is that of its buffer, `nodes` its nodes.
pub(crate) fn text_of(uri: &str, nodes: &str) -> String {
    let uri = if uri.is_empty() { String::new() } else { format!("\"uri\": \"{uri}\",") };
    format!(
        r#"{{
  "asset": {{"version": "2.0", "generator": "by hand"}},
  "scene": 0,
  "scenes": [{{"nodes": [0]}}],
  "nodes": [{nodes}],
  "meshes": [{{"name": "cube", "primitives": [
    {{"attributes": {{"POSITION": 0}}, "indices": 1, "material": 0}}
  ]}}],
  "materials": [
    {{"name": "red", "pbrMetallicRoughness": {{"baseColorFactor": [0.8, 0.2, 0.1, 1], "metallicFactor": 0}},
      "emissiveFactor": [1, 0.5, 0], "extensions": {{"KHR_materials_emissive_strength": {{"emissiveStrength": 4}}}}}}
  ],
  "cameras": [{{"type": "perspective", "perspective": {{"yfov": 0.5, "znear": 0.1}}}}],
  "accessors": [
    {{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}},
    {{"bufferView": 1, "componentType": 5121, "count": 36, "type": "SCALAR"}}
  ],
  "bufferViews": [
    {{"buffer": 0, "byteLength": 96}},
    {{"buffer": 0, "byteOffset": 96, "byteLength": 36}}
  ],
  "buffers": [{{{uri} "byteLength": 132}}]
}}"#
    )
}

/// The cube in one text.
pub(crate) fn text() -> String {
    text_of(&uri(&buffer()), r#"{"name": "box", "mesh": 0}"#)
}

/// The cube in one binary file.
pub(crate) fn bits() -> Vec<u8> {
    glb(&text_of("", r#"{"mesh": 0}"#), &buffer())
}

fn glb(text: &str, binary: &[u8]) -> Vec<u8> {
    let mut text = text.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bits = b"glTF".to_vec();
    for word in [2, 12 + 8 + text.len() + 8 + binary.len(), text.len(), 0x4E4F_534A] {
        bits.extend((word as u32).to_le_bytes());
    }
    bits.extend(text);
    for word in [binary.len(), 0x004E_4942] {
        bits.extend((word as u32).to_le_bytes());
    }
    bits.extend(binary);
    bits
}

fn from(text: &str) -> Result<Model, Refusal> {
    read("a.gltf", text.as_bytes(), &NoFiles)
}

fn with_nodes(nodes: &str) -> Model {
    from(&text_of(&uri(&buffer()), nodes)).unwrap()
}

#[test]
fn the_cube_is_six_squares_as_text_and_as_bits() {
    let model = from(&text()).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model), ["box-1", "box-2", "box-3", "box-4", "box-5", "box-6"]);
    assert_eq!(model.bands, ["r", "g", "b"]);
    let red = &model.materials[0];
    assert_eq!((red.name.as_str(), red.reflectance.as_slice()), ("red", &[0.8, 0.2, 0.1][..]));
    assert_eq!(red.emission, [4.0 * PI, 2.0 * PI, 0.0]);
    assert!(model.surfaces.iter().all(|x| x.material == Some(0) && x.sides == Sides::Front));
    assert_eq!(model.surfaces[0].place, Some(FilePlace::Line(7)));
    assert_eq!(notes(&model), ["12 coplanar triangles were merged to 6 polygons"]);
    let model = read("a.glb", &bits(), &NoFiles).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model)[0], "cube-1");
    let start = bits().windows(15).position(|part| part.starts_with(b"{\"attributes\""));
    assert_eq!(model.surfaces[0].place, start.map(FilePlace::Byte));
}

#[test]
fn buffers_stand_beside_the_file() {
    let files = Memory::of([("a cube.bin", buffer())]);
    let text = text_of("a%20cube.bin", r#"{"mesh": 0}"#);
    assert_cube(&read("a.gltf", text.as_bytes(), &files).unwrap(), DVec3::splat(0.5), true);
    let said = "a.gltf:22: the buffer 0: the file 'a cube.bin' cannot be read: a scene without a folder of its own \
                names no other files";
    assert_refusal(from(&text), said, "beside the model");
}

#[test]
fn nodes_place_meshes_and_cameras() {
    // A parent scales by 2 and moves along x, its child turns a quarter about y.
    let turn = 0.5f64.sqrt();
    let model = with_nodes(&format!(
        r#"{{"children": [1, 2], "scale": [2, 2, 2], "translation": [10, 0, 0]}},
           {{"mesh": 0, "rotation": [0, {turn}, 0, {turn}]}},
           {{"camera": 0, "matrix": [0,0,-1,0, 0,1,0,0, 1,0,0,0, 3,4,5,1]}}"#
    ));
    let low = model.surfaces.iter().flat_map(|x| region(x).corners()).reduce(DVec3::min).unwrap();
    let high = model.surfaces.iter().flat_map(|x| region(x).corners()).reduce(DVec3::max).unwrap();
    // About y, x goes to −z and z to x.
    assert!(
        low.distance(DVec3::new(10.0, 0.0, -2.0)) < 1e-12
            && high.distance(DVec3::new(12.0, 2.0, 0.0)) < 1e-12
    );
    assert!(model.surfaces.iter().all(|x| (region(x).area() - 4.0).abs() < 1e-12));
    let camera = model.camera.unwrap();
    assert_eq!((camera.eye, camera.up), (DVec3::new(16.0, 8.0, 10.0), DVec3::Y));
    // Its z axis is x: it looks along −x.
    assert!((camera.target - camera.eye).distance(DVec3::NEG_X) < 1e-12);
    assert!((camera.fov - 0.5 * 180.0 / PI).abs() < 1e-12 && camera.size.is_none());
}

#[test]
fn mirrored_nodes_keep_their_fronts_outside() {
    let mirrored = r#"{"mesh": 0, "scale": [-1, 1, 1], "translation": [1, 0, 0]}"#;
    assert_cube(&with_nodes(mirrored), DVec3::splat(0.5), true);
}

#[test]
fn nodes_are_objects_of_their_own() {
    let nodes = r#"{"children": [1, 2]}, {"name": "a", "mesh": 0},
                   {"name": "a", "mesh": 0, "translation": [1, 0, 0]}"#;
    let model = with_nodes(nodes);
    assert_eq!(model.surfaces.len(), 12);
    assert_eq!((names(&model)[0], names(&model)[6]), ("a-1", "a-2-1"));
}

/// A square from (0, 0) to (1, 1) of one primitive, its members and further accessors and views given.
fn square(primitive: &str, accessors: &str, views: &str, bytes: &[u8]) -> String {
    format!(
        r#"{{"asset": {{"version": "2.1"}}, "nodes": [{{"mesh": 0}}],
  "meshes": [{{"primitives": [{{{primitive}}}]}}],
  "accessors": [{accessors}],
  "bufferViews": [{views}],
  "buffers": [{{"uri": "{}", "byteLength": {}}}]}}"#,
        uri(bytes),
        bytes.len()
    )
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn assert_square(text: &str) {
    let model = from(text).unwrap();
    assert_eq!(model.surfaces.len(), 1, "{text}");
    let region = region(&model.surfaces[0]);
    assert_eq!((region.area(), region.normal(), region.outer().len()), (1.0, DVec3::Z, 4));
    assert_eq!((names(&model), model.surfaces[0].material), (vec!["polygon-1"], None));
}

#[test]
fn strips_fans_and_indices_of_all_kinds_are_read() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let points = |order: &[usize]| -> Vec<u8> {
        floats(&order.iter().flat_map(|k| [corners[*k][0], corners[*k][1], 0.0]).collect::<Vec<f32>>())
    };
    let position = r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}"#;
    let view = r#"{"buffer": 0, "byteLength": 48}"#;
    let of = |mode: u8, order: &[usize]| {
        square(&format!(r#""attributes": {{"POSITION": 0}}, "mode": {mode}"#), position, view, &points(order))
    };
    assert_square(&of(5, &[0, 1, 2, 3]));
    assert_square(&of(6, &[0, 1, 3, 2]));
    for (kind, size) in [(5121, 1), (5123, 2), (5125, 4)] {
        let mut bytes = points(&[0, 1, 2, 3]);
        for index in [0u32, 1, 3, 0, 3, 2] {
            bytes.extend(&index.to_le_bytes()[..size]);
        }
        let text = square(
            r#""attributes": {"POSITION": 0}, "indices": 1"#,
            &format!(
                r#"{position}, {{"bufferView": 1, "componentType": {kind}, "count": 6, "type": "SCALAR"}}"#
            ),
            &format!(r#"{view}, {{"buffer": 0, "byteOffset": 48, "byteLength": {}}}"#, 6 * size),
            &bytes,
        );
        assert_square(&text);
    }
    // Strips are joined by repeated corners.
    let joined = r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                    {"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}"#;
    let views = r#"{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 6}"#;
    let bytes = [points(&[0, 1, 2, 3]), vec![0, 0, 0, 1, 2, 3]].concat();
    assert_square(&square(
        r#""attributes": {"POSITION": 0}, "indices": 1, "mode": 5"#,
        joined,
        views,
        &bytes,
    ));
}

#[test]
fn sparse_strided_and_normalized_points_are_read() {
    // Points 20 bytes apart, the last one wrong and replaced.
    let wrong = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [9.0, 9.0]];
    let mut bytes = floats(&wrong.iter().flat_map(|[x, y]| [*x, *y, 0.0, 7.0, 7.0]).collect::<Vec<f32>>());
    bytes.extend([3, 0, 0, 0]);
    bytes.extend(floats(&[1.0, 1.0, 0.0]));
    let sparse = r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
        "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 1, "byteOffset": 4}}}"#;
    let views = r#"{"buffer": 0, "byteLength": 80, "byteStride": 20}, {"buffer": 0, "byteOffset": 80, "byteLength": 16}"#;
    let primitive = r#""attributes": {"POSITION": 0}, "mode": 5"#;
    assert_square(&square(primitive, sparse, views, &bytes));
    let small: Vec<u8> =
        [[0, 0], [255, 0], [0, 255], [255, 255]].concat().chunks(2).flat_map(|x| [x[0], x[1], 0]).collect();
    let normalized =
        r#"{"bufferView": 0, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC3"}"#;
    assert_square(&square(primitive, normalized, r#"{"buffer": 0, "byteLength": 12}"#, &small));
    // Without a view all is 0 but what is replaced.
    let bytes = [vec![1, 2, 3, 0], floats(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0])].concat();
    let zeros = r#"{"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 3,
        "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 4}}}"#;
    assert_square(&square(primitive, zeros, r#"{"buffer": 0, "byteLength": 40}"#, &bytes));
}

#[test]
fn points_that_no_bytes_state_and_that_are_no_numbers_are_refused() {
    let bare = text().replace(
        r#"{"bufferView": 0, "componentType": 5126, "count": 8"#,
        r#"{"componentType": 5126, "count": 8"#,
    );
    let said =
        "a.gltf:15: the accessor 0: its points are all 0: it has neither a buffer view nor sparse values";
    assert_refusal(from(&bare), said, "without compression");
    // 1e200 twice is beyond all numbers, and 0 times that is none.
    let nodes = r#"{"scale": [1e200, 1, 1], "children": [1]}, {"scale": [1e200, 1, 1], "mesh": 0}"#;
    let said = "a.gltf:7: a coordinate is beyond 1e50";
    assert_refusal(from(&text_of(&uri(&buffer()), nodes)), said, "scale the model down");
}

#[test]
fn textures_are_told_with_the_number_that_stands_for_them() {
    let textured = text()
        .replace(r#""metallicFactor": 0"#, r#""metallicFactor": 0, "baseColorTexture": {"index": 0}"#)
        .replace(r#""emissiveFactor""#, r#""emissiveTexture": {"index": 1}, "emissiveFactor""#);
    let model = from(&textured).unwrap();
    let material = &model.materials[0];
    assert!((material.reflectance[0] - 0.4).abs() < 1e-15, "{material:?}");
    assert!(material.emission.iter().all(|value| *value == 0.0), "{material:?}");
    let expected = [
        "textures are left out: their mean reflectance is taken for 0.5",
        "textures of emission are left out: what they make shine is dark",
    ];
    assert_eq!(&notes(&model)[..2], expected);
}

#[test]
fn what_is_left_out_is_noted() {
    let odd = text()
        .replace(r#""metallicFactor": 0"#, r#""metallicFactor": 0.25, "baseColorTexture": {"index": 0}"#)
        .replace(r#""name": "red""#, r#""name": "red", "alphaMode": "BLEND", "doubleSided": true"#)
        .replace(
            r#""mesh": 0}"#,
            r#""mesh": 0, "camera": 1, "extensions": {"KHR_lights_punctual": {"light": 0}}}"#,
        )
        .replace(r#""cameras": ["#, r#""cameras": [{}, {"type": "orthographic"}, "#)
        .replace(r#""material": 0}"#, r#""material": 0}, {"attributes": {"POSITION": 0}, "mode": 1}"#)
        .replace(
            r#""scene": 0"#,
            r#""scene": 0, "animations": [{}], "extensionsRequired": ["KHR_lights_punctual"]"#,
        );
    let model = from(&odd).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert!(model.surfaces.iter().all(|surface| surface.sides == Sides::Both));
    // (1 − 0.25) of 0.8, half of it for the texture.
    assert!((model.materials[0].reflectance[0] - 0.3).abs() < 1e-15);
    let expected = [
        "animations are left out",
        "point lights, spots and directed light are left out",
        "cameras without perspective are left out",
        "specular reflection is left out",
        "textures are left out: their mean reflectance is taken for 0.5",
        "transparency is left out",
        "points and lines are left out",
        "12 coplanar triangles were merged to 6 polygons",
    ];
    assert_eq!(notes(&model), expected);
}

#[test]
fn broken_files_are_refused() {
    let refused =
        |text: &str, said: &str, cure: &str| assert_refusal(from(text), &format!("a.gltf{said}"), cure);
    let change = |from: &str, to: &str| {
        assert!(text().contains(from), "{from}");
        text().replacen(from, to, 1)
    };
    refused("", ":1: the file: EOF while parsing a value", "export the model again");
    refused(
        "{\n\"asset\": {\"version\": 2}}",
        ":2: the file: invalid type: integer `2`, expected a string",
        "correct it",
    );
    refused("{}", ":1: the file: missing field `asset`", "correct it");
    refused(&change(r#""2.0""#, r#""1.0""#), ":1: the version is '1.0'", "glTF 2.0");
    let required = r#""scene": 0, "extensionsRequired": ["KHR_draco_mesh_compression"]"#;
    refused(
        &change(r#""scene": 0"#, required),
        ":1: the extension KHR_draco_mesh_compression is required",
        "without compression",
    );
    refused(
        &change(r#""scene": 0"#, r#""scene": 7"#),
        ":1: the scene 7 is named, 1 are listed, from 0 on",
        "index",
    );
    refused(
        &change(r#"[{"nodes": [0]}]"#, r#"[{"nodes": [3]}]"#),
        ":1: the node 3 is named, 1 are listed, from 0 on",
        "index",
    );
    refused(
        &change(r#""mesh": 0"#, r#""mesh": 2"#),
        ":5: the mesh 2 is named, 1 are listed, from 0 on",
        "index",
    );
    refused(
        &change(r#""mesh": 0"#, r#""children": [0]"#),
        ":5: the node 0 has two parents, or is below itself",
        "children",
    );
    refused(
        &change(r#""mesh": 0"#, r#""mesh": 0, "rotation": [0, 0, 0, 0]"#),
        ":5: the rotation of the node has no direction",
        "length 1",
    );
    refused(
        &change(r#""mesh": 0"#, r#""mesh": "0""#),
        ":5: the node 0: invalid type: string \"0\", expected usize",
        "correct it",
    );
    refused(
        &change(r#""mesh": 0"#, r#""scale": [1e999, 1, 1]"#),
        ":5: the node 0: number out of range",
        "correct it",
    );
    refused(
        &change(r#""mesh": 0"#, r#""mesh": 0, "scale": [1e60, 1, 1]"#),
        ":7: a coordinate is beyond 1e50",
        "scale",
    );
    refused(
        &change(r#""mesh": 0"#, r#""camera": 0"#),
        ": the file holds no triangles in its scene",
        "polygons",
    );
    refused(
        &change(r#""indices": 1"#, r#""indices": 0"#),
        ":15: the accessor 0: indices cannot be VEC3 of component type 5126",
        "SCALAR",
    );
    refused(
        &change(r#""POSITION": 0"#, r#""POSITION": 1"#),
        ":16: the accessor 1: points cannot be SCALAR of component type 5121",
        "VEC3",
    );
    refused(
        &change(r#""material": 0"#, r#""material": 1"#),
        ":7: the material 1 is named, 1 are listed, from 0 on",
        "index",
    );
    refused(
        &change(r#""count": 8"#, r#""count": 7"#),
        ":7: a triangle has a vertex beyond the 7 that are listed",
        "index",
    );
    refused(
        &change(r#""count": 8"#, r#""count": 9"#),
        ":15: the accessor 0: 9 rows of 12 bytes, 12 apart, do not fit behind byte 0 of a view of 96",
        "export",
    );
    refused(
        &change(r#""count": 8"#, r#""count": 99999999999"#),
        ":15: the accessor 0: it has more than 40000000 rows",
        "split",
    );
    refused(
        &change(r#""count": 8"#, r#""count": -8"#),
        ":15: the accessor 0: invalid value: integer `-8`, expected usize",
        "correct",
    );
    refused(&change("5126", "5127"), ":15: the accessor 0: there is no component type 5127", "export");
    refused(
        &change(r#""count": 36"#, r#""count": 35"#),
        ":7: triangles have 35 corners, no multiple of 3",
        "count",
    );
    refused(
        &change(r#""byteLength": 36"#, r#""byteLength": 37"#),
        ":20: the view spans 37 bytes from byte 96 on; the buffer has 132",
        "export",
    );
    refused(
        &change(r#""byteLength": 132"#, r#""byteLength": 133"#),
        ":22: the buffer 0: it has 132 bytes, 133 are announced",
        "copy",
    );
    refused(&change(";base64", ""), ":22: the buffer 0: its data is not base64", "base64");
    refused(
        &change("base64,", "base64,*"),
        ":22: the buffer 0: its data (application/octet-stream;base64): Invalid symbol 42, offset 0.",
        "export",
    );
    refused(
        &change("[0.8, 0.2", "[-0.8, 0.2"),
        ":10: the material 0 has a factor below 0 or beyond measure, or a metallic factor above 1",
        "colours",
    );
    refused(
        &change(r#""mesh": 0"#, r#""mesh": 0, "camera": 0"#).replace("0.5, \"znear\"", "7, \"znear\""),
        ":13: the camera 0 has an angle of 401.07045659157626 degrees, or no direction",
        "yfov",
    );
}

#[test]
fn broken_bits_are_refused() {
    let refused = |bits: &[u8], said: &str, cure: &str| {
        assert_refusal(read("a.glb", bits, &NoFiles), &format!("a.glb: {said}"), cure);
    };
    let bits = bits();
    let change = |at: usize, byte: u8| {
        let mut changed = bits.clone();
        changed[at] = byte;
        changed
    };
    refused(&change(4, 1), "byte 4: this is no GLB of version 2", "glTF 2.0");
    let end = bits.len();
    refused(
        &bits[..end - 1],
        &format!("byte 8: the file has {} bytes, its header says {end}", end - 1),
        "copy",
    );
    refused(&change(16, b'j'), "byte 16: the first chunk is not JSON", "export");
    refused(&change(15, 1), "byte 12: the file ends within a chunk", "copy");
    refused(&change(20, 0xff), "byte 20: the JSON is not UTF-8", "UTF-8");
    refused(&change(20, b'?'), "byte 20: the file: expected value", "export");
    let at = bits.windows(9).position(|part| part == b"\"meshes\":").unwrap();
    refused(&change(at + 8, b'?'), &format!("byte {}: the file: expected `:`", at + 8), "export");
    let last = end - 1;
    refused(
        &change(last, 8),
        &format!(
            "byte {}: a triangle has a vertex beyond the 8 that are listed",
            20 + text_of("", "{\"mesh\": 0}").find("{\"attr").unwrap()
        ),
        "index",
    );
}
