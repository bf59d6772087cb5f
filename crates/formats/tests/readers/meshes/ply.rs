//! PLY.

use glam::DVec3;
use radiosity_formats::model::{Model, Shape};
use radiosity_formats::ply::read;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;

use crate::measures::{assert_cube, names, notes};
use crate::meshes::shapes::{SIDES, assert_refusal, corner};

/// The unit cube as text, of squares.
pub(crate) fn text() -> String {
    let mut text =
        "ply\nformat ascii 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n\
                    property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n"
            .to_owned();
    for [x, y, z] in (0..8).map(corner) {
        text += &format!("{x} {y} {z}\n");
    }
    for [a, b, c, d] in SIDES {
        text += &format!("4 {a} {b} {c} {d}\n");
    }
    text
}

/// The unit cube as bits, with properties in an unusual order.
pub(crate) fn bits(is_big: bool) -> Vec<u8> {
    let order = if is_big { "big" } else { "little" };
    let mut bits = format!(
        "ply\r\nformat binary_{order}_endian 1.0\r\nobj_info odd\r\nelement material 1\r\nproperty list ushort \
         double kd\r\nelement vertex 8\r\nproperty uchar red\r\nproperty double z\r\nproperty int8 x\r\nproperty \
         float32 y\r\nelement face 6\r\nproperty short flags\r\nproperty list uint uint16 vertex_index\r\nend_header\r\n"
    )
    .into_bytes();
    let mut put = |word: &[u8]| {
        let mut word = word.to_vec();
        if is_big {
            word.reverse();
        }
        bits.extend(word);
    };
    put(&2u16.to_le_bytes());
    put(&0.5f64.to_le_bytes());
    put(&f64::NAN.to_le_bytes());
    for [x, y, z] in (0..8).map(corner) {
        put(&[9]);
        put(&z.to_le_bytes());
        put(&(x as i8).to_le_bytes());
        put(&(y as f32).to_le_bytes());
    }
    for side in SIDES {
        put(&(-3i16).to_le_bytes());
        put(&4u32.to_le_bytes());
        side.iter().for_each(|corner| put(&(*corner as u16).to_le_bytes()));
    }
    bits
}

fn from(text: &str) -> Result<Model, Refusal> {
    read("a.ply", text.as_bytes(), &NoFiles)
}

#[test]
fn the_cube_is_six_squares_as_text_and_as_bits() {
    let model = from(&text()).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model)[5], "polygon-6");
    assert_eq!(model.surfaces[5].place, Some(FilePlace::Line(24)));
    assert_eq!(model.bands, ["grey"]);
    assert!(model.notes.is_empty());
    for is_big in [false, true] {
        let model = read("a.ply", &bits(is_big), &NoFiles).unwrap();
        assert_cube(&model, DVec3::splat(0.5), true);
        let elements = "elements other than vertices and faces are left out";
        assert_eq!(notes(&model), [elements, "colours are left out"]);
        let Some(FilePlace::Byte(first)) = model.surfaces[0].place else { panic!("bits have bytes") };
        assert_eq!(first + 6 * 14, bits(is_big).len());
    }
}

#[test]
fn odd_texts_are_read() {
    assert_cube(&from(&text().replace('\n', "\r\n")).unwrap(), DVec3::splat(0.5), true);
    assert_cube(&from(&text().replace('\n', "\r")).unwrap(), DVec3::splat(0.5), true);
    // Faces before vertices, rows over several lines, what is skipped may be any word.
    let odd = "ply\nformat ascii 1.0\nelement face 1\nproperty list int float vertex_indices\nproperty float q\n\
               element empty 99999999999\nelement vertex 5\nproperty double y\nproperty double x\nproperty float nx\n\
               property double z\nelement edge 1\nproperty int vertex1\nend_header\n\n5 0 1 2\n 3.0 4 -nan\n\
               0 0 nan 0 0 1 x 0 1 2 nan 0 2 1 nan 0 1 0 nan 0\n7\n";
    let model = from(odd).unwrap();
    let Shape::Polygon { outline, .. } = &model.surfaces[0].shape else { panic!("a polygon") };
    assert_eq!(outline.len(), 5);
    assert_eq!(outline[2].to_array(), [2.0, 1.0, 0.0]);
    assert_eq!(model.surfaces[0].place, Some(FilePlace::Line(16)));
    assert_eq!(notes(&model), ["elements other than vertices and faces are left out", "edges are left out"]);
}

#[test]
fn broken_files_are_refused() {
    let refused = |text: &str, said: &str, cure: &str| assert_refusal(from(text), said, cure);
    let change = |from: &str, to: &str| text().replacen(from, to, 1);
    refused("", "a.ply:1: the header does not end", "end_header");
    refused("plyx\n", "a.ply:1: the file does not begin with 'ply'", "name the format");
    refused("ply\nend_header\n", "a.ply:2: the header names no format", "format ascii 1.0");
    refused(&change("1.0", "2.0"), "a.ply:2: the version 2.0 is not known", "1.0");
    refused(&change("ascii", "text"), "a.ply:2: 'text' is no format of PLY", "binary_little_endian");
    refused(&change("comment", "remark"), "a.ply:3: 'remark' is no statement of a header", "comment");
    refused(&change("vertex 8", "vertex -8"), "a.ply:4: the number of 'vertex' is '-8'", "how many");
    refused(&change("float x", "real x"), "a.ply:5: 'real' is no type of numbers", "float");
    refused(&change("float x", "float w"), "a.ply:4: the vertices have no property x", "x, y and z");
    refused(
        &change("vertex_indices", "corners"),
        "a.ply:8: the elements 'face' have no list vertex_indices",
        "list",
    );
    refused("ply\nproperty int a\n", "a.ply:2: a property stands before all elements", "behind");
    refused(
        &change("vertex 8", "vertex 88888888"),
        "a.ply:4: 88888888 elements are announced, 18 at the most are there",
        "correct the count",
    );
    refused(&change("face 6", "face 7"), "a.ply:24: the file ends early", "correct the counts");
    refused(
        &change("face 6", "face 0"),
        "a.ply: the file holds no faces with a list vertex_indices",
        "polygons",
    );
    refused(&change("1 0 0", "nan 0 0"), "a.ply:12: a coordinate of this vertex is not finite", "correct it");
    refused(&change("1 0 0", "1 O 0"), "a.ply:12: 'O' is no number", "number");
    let corner = |word: &str| change("4 4 5 7 6", &format!("4 4 5 7 {word}"));
    let said = |word: &str| format!("a.ply:20: the face has the vertex {word}; 8 are listed, from 0 on");
    for word in ["8", "-1", "0.5", "NaN", "inf"] {
        refused(&corner(word), &said(word), "correct the number");
    }
    refused(&change("4 4 5", "-4 4 5"), "a.ply:20: the list 'vertex_indices' has the length -4", "length");
    refused(
        &change("4 4 5", "1e12 4 5"),
        "a.ply:20: the list 'vertex_indices' has the length 1000000000000",
        "length",
    );
    refused(&change("4 4 5 7 6", "2 4 5"), "a.ply:20: a face has 2 corners, 3 are the least", "three");
}

#[test]
fn broken_bits_are_refused() {
    let bits = bits(false);
    let end = bits.len();
    let cut = read("a.ply", &bits[..end - 1], &NoFiles);
    assert_refusal(cut, &format!("a.ply: byte {}: the file ends early", end - 1), "export it again");
    let mut huge = bits.clone();
    huge[end - 12..end - 8].fill(255);
    let said = format!("a.ply: byte {}: the list 'vertex_index' has the length 4294967295", end - 12);
    assert_refusal(read("a.ply", &huge, &NoFiles), &said, "correct its length");
}
