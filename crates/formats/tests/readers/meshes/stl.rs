//! STL.

use glam::DVec3;
use radiosity_formats::model::{Model, Shape, Sides};
use radiosity_formats::stl::read;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;

use crate::measures::{assert_cube, names, notes};
use crate::meshes::shapes::{assert_refusal, corner, triangles};

/// The unit cube as text.
pub(crate) fn text() -> String {
    let mut text = "solid cube\n".to_owned();
    for triangle in triangles() {
        text += "facet normal 0 0 0\n outer loop\n";
        for [x, y, z] in triangle.map(corner) {
            text += &format!("  vertex {x} {y} {z:e}\n");
        }
        text += " endloop\nendfacet\n";
    }
    text + "endsolid cube\n"
}

/// The unit cube as bits, with a header that begins like a text.
pub(crate) fn bits() -> Vec<u8> {
    let mut bits = b"solid made by a program".to_vec();
    bits.resize(80, b' ');
    bits.extend(12u32.to_le_bytes());
    for triangle in triangles() {
        bits.extend([0; 12]);
        for value in triangle.map(corner).concat() {
            bits.extend((value as f32).to_le_bytes());
        }
        bits.extend([0; 2]);
    }
    bits
}

fn from(text: &str) -> Result<Model, radiosity_photometry::error::Refusal> {
    read("a.stl", text.as_bytes(), &NoFiles)
}

#[test]
fn the_cube_is_six_squares_as_text_and_as_bits() {
    let model = from(&text()).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model), ["cube-1", "cube-2", "cube-3", "cube-4", "cube-5", "cube-6"]);
    assert_eq!(model.surfaces[1].place, Some(FilePlace::Line(16)));
    assert_eq!(model.bands, ["grey"]);
    assert!(model.surfaces.iter().all(|x| x.material.is_none() && x.sides == Sides::Open));
    assert_eq!(notes(&model), ["12 coplanar triangles were merged to 6 polygons"]);
    let model = read("a.stl", &bits(), &NoFiles).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model)[0], "polygon-1");
    assert_eq!(model.surfaces[1].place, Some(FilePlace::Byte(184)));
}

#[test]
fn odd_texts_are_read() {
    let upper = text().to_uppercase().replace('\n', "\r\n\r\n");
    assert_cube(
        &read("a.stl", &[b"\xef\xbb\xbf", upper.as_bytes()].concat(), &NoFiles).unwrap(),
        DVec3::splat(0.5),
        true,
    );
    let facet = |normal: &str| {
        format!(
            "facet normal {normal}\nouter loop\nvertex 0 0 0\nvertex 1. 0 0\nvertex +0 1e0 0\nendloop\nendfacet\n"
        )
    };
    let model = from(&format!("solid\n{}endsolid\nsolid b c\n{0}endsolid\n", facet("nan nan nan"))).unwrap();
    assert_eq!(names(&model), ["polygon-1", "b c"]);
    let model = from(&format!("solid a\n{}", facet("0 0 -1"))).unwrap();
    assert_eq!(notes(&model), ["normals that contradict the order of corners are left out"]);
}

#[test]
fn odd_bits_are_read() {
    let mut more = bits();
    more[..5].copy_from_slice(b"other");
    more[133] = 7;
    more.extend([1; 9]);
    let model = read("a.stl", &more, &NoFiles).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    let expected = [
        "attributes of triangles are left out",
        "bytes behind the last triangle are left out",
        "12 coplanar triangles were merged to 6 polygons",
    ];
    assert_eq!(notes(&model), expected);
}

#[test]
fn broken_files_are_refused() {
    let refused = |text: &str, said: &str, cure: &str| assert_refusal(from(text), said, cure);
    refused("", "a.stl: the file holds no facets", "name its format");
    refused("solid a\nendsolid a\n", "a.stl: the file holds no facets", "polygons");
    refused("solid a\n\nvertex 1 2 3\n", "a.stl:3: 'vertex' cannot stand here", "outer loop");
    refused("solid a\nfacet normal 0 0 1\n\n", "a.stl:2: the text ends within a facet", "endfacet");
    let start = "solid a\nfacet normal 0 0 1\nouter loop\n";
    refused(&format!("{start}vertex 1 2\n"), "a.stl:4: a vertex has 2 numbers, it takes three", "x, y and z");
    refused(&format!("{start}vertex 1 2 1e999\n"), "a.stl:4: z is 1e999", "finite");
    refused(&format!("{start}vertex 1 2 z\n"), "a.stl:4: z is 'z', which is no number", "number");
    refused(
        &format!("{start}vertex 1 2 3\nvertex 1 2 4\nendloop\n"),
        "a.stl:6: the facet has 2 corners",
        "give it three",
    );
    let three = "vertex 1 2 3\nvertex 1 2 4\nvertex 0 0 0\nendloop\n";
    refused(&format!("{start}{three}vertex 0 0 1\n"), "a.stl:8: 'vertex' cannot stand here", "facet");
    refused(&format!("{start}{three}outer loop\n"), "a.stl:8: 'outer' cannot stand here", "facet");
    refused("solid a\nfacet\nendfacet\n", "a.stl:3: a face has 0 corners, 3 are the least", "three");
    refused("solid a\nvertex \0\n", "a.stl: byte 15: this is not a text: it holds a zero byte", "UTF-8");
}

#[test]
fn broken_bits_are_refused() {
    let refused =
        |bits: &[u8], said: &str, cure: &str| assert_refusal(read("a.stl", bits, &NoFiles), said, cure);
    let cure = "export it again";
    refused(&bits()[..683], "a.stl: byte 80: 12 triangles are announced, 11 are there", cure);
    let mut huge = bits();
    huge[80..84].fill(255);
    refused(&huge, "a.stl: byte 80: 4294967295 triangles are announced, 12 are there", cure);
    refused(
        &[200; 50],
        "a.stl: byte 50: the file ends after 50 bytes; a binary STL has a header of 84",
        cure,
    );
    let mut not_finite = bits();
    not_finite[84 + 50 + 12..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    refused(
        &not_finite,
        "a.stl: byte 134: a coordinate of this triangle is not finite",
        "take the triangle out",
    );
}

#[test]
fn a_cylinder_of_facets_stays_its_facets() {
    // 48 facets of 2 triangles each.
    let mut text = "solid pipe\n".to_owned();
    let point = |k: usize, z: f64| {
        let angle = std::f64::consts::TAU * (k % 48) as f64 / 48.0;
        format!("vertex {:.7} {:.7} {z}\n", angle.cos(), angle.sin())
    };
    for k in 0..48 {
        let [a, b, c, d] = [point(k, 0.0), point(k + 1, 0.0), point(k + 1, 2.0), point(k, 2.0)];
        for [x, y, z] in [[&a, &b, &c], [&a, &c, &d]] {
            text += &format!("facet normal 0 0 0\nouter loop\n{x}{y}{z}endloop\nendfacet\n");
        }
    }
    let model = from(&text).unwrap();
    assert_eq!(model.surfaces.len(), 48);
    let is_square = |shape: &Shape| matches!(shape, Shape::Polygon { outline, .. } if outline.len() == 4);
    assert!(model.surfaces.iter().all(|surface| is_square(&surface.shape)));
}
