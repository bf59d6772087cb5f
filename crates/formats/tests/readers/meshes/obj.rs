//! OBJ with MTL.

use std::f64::consts::PI;

use glam::DVec3;
use radiosity_formats::model::{Model, Shape, Sides};
use radiosity_formats::obj::read;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;

use crate::measures::{assert_cube, names, notes};
use crate::memory::Memory;
use crate::meshes::shapes::{SIDES, assert_refusal, corner, triangles};

/// The unit cube of squares, each in a group of its own, of two materials.
pub(crate) fn text() -> String {
    let mut text = "# a cube\nmtllib cube.mtl\no cube\n".to_owned();
    for [x, y, z] in (0..8).map(corner) {
        text += &format!("v {x} {y} {z}\n");
    }
    text += "vn 0 0 1\nvt 0 0\ns off\n";
    for (index, side) in SIDES.iter().enumerate() {
        let [a, b, c, d] = side.map(|corner| corner + 1);
        let material = if index == 1 { "lamp" } else { "white paint" };
        text += &format!("g side {index}\nusemtl {material}\nf {a}/1/1 {b}//1 {c}/1 {d}\n");
    }
    text
}

/// Materials of the OBJ, as an MTL.
pub(crate) const MTL: &str = "# materials\nnewmtl white paint\nKd 0.8 0.7 0.6\nKs 0 0 0\nd 1\nTr 0\nillum 2\n\n\
                              newmtl lamp\nKd 0\nKe 10 20 30\n";

/// The unit cube of triangles with odd statements.
pub(crate) fn odd() -> String {
    let mut text = "\u{feff}#!program\r\n\r\n  V 0 0 0 1.0\r\n".to_owned();
    for [x, y, z] in (1..8).map(corner) {
        text += &format!("v\t{x}.0 \\\r\n {y:e}   +{z} # corner\r\n");
    }
    text += "vp 0 1\r\nlod 3\r\np 1\r\nl 1 2\r\nl 2 3\r\ncstype bezier\r\ncurv 0 1 1 2\r\nend\r\n";
    for triangle in triangles() {
        // Backwards from the last vertex.
        let [a, b, c] = triangle.map(|corner| corner as i64 - 8);
        text += &format!("fo {a} {b}// {c}/\r\n");
    }
    text
}

/// The files beside the model.
pub(crate) fn beside() -> Memory {
    Memory::of([("cube.mtl", MTL.as_bytes())])
}

fn from(text: &str) -> Result<Model, Refusal> {
    read("a.obj", text.as_bytes(), &beside())
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn the_cube_is_six_squares_of_two_materials() {
    let model = from(&text()).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    assert_eq!(names(&model), ["side 0", "side 1", "side 2", "side 3", "side 4", "side 5"]);
    assert_eq!(model.bands, ["r", "g", "b"]);
    let [paint, lamp] = model.materials.as_slice() else { panic!("two materials") };
    assert_eq!((paint.name.as_str(), paint.reflectance.as_slice()), ("white paint", &[0.8, 0.7, 0.6][..]));
    assert_eq!((&paint.emission[..], &lamp.reflectance[..]), (&[0.0; 3][..], &[0.0; 3][..]));
    assert_eq!(lamp.emission, [10.0 * PI, 20.0 * PI, 30.0 * PI]);
    assert!(model.surfaces.iter().all(|surface| surface.sides == Sides::Open));
    assert_eq!(model.surfaces[1].material, Some(1));
    assert_eq!(model.surfaces[1].place, Some(FilePlace::Line(20)));
    // All corners name the one normal, which two sides have, one of them reversed.
    let expected = [
        "normals of vertices are left out: faces are flat",
        "normals of vertices that point to the back of their face are left out: the order of corners tells the front",
    ];
    assert_eq!(notes(&model), expected);
    assert_eq!([model.notes[0].count, model.notes[1].count], [4, 1]);
}

#[test]
fn odd_texts_are_read() {
    let model = read("a.obj", odd().as_bytes(), &NoFiles).unwrap();
    assert_cube(&model, DVec3::splat(0.5), true);
    let expected = [
        "points are left out",
        "lines are left out",
        "free-form curves and surfaces are left out",
        "12 coplanar triangles were merged to 6 polygons",
    ];
    assert_eq!(notes(&model), expected);
    assert_eq!((model.notes[1].count, model.notes[1].place), (2, Some(FilePlace::Line(21))));
    assert_eq!(names(&model)[0], "polygon-1");
    assert_cube(&from(&text().replace('\n', "\r")).unwrap(), DVec3::splat(0.5), true);
    // Vertices below the face; five corners are kept.
    let model = from("f 1 2 3 4 5\nv 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n").unwrap();
    assert!(matches!(&model.surfaces[0].shape, Shape::Polygon { outline, .. } if outline.len() == 5));
}

#[test]
fn four_corners_off_their_plane_are_a_patch() {
    let warped = |z: f64| from(&format!("o a\nv 0 0 0\nv 1 0 0\nv 1 1 {z}\nv 0 1 0\nf 1 2 3 4\n")).unwrap();
    let Shape::Quad(corners) = &warped(0.1).surfaces[0].shape else { panic!("a patch") };
    assert_eq!(corners[2].to_array(), [1.0, 1.0, 0.1]);
    assert!(matches!(warped(1e-5).surfaces[0].shape, Shape::Polygon { .. }));
}

#[test]
fn materials_come_from_several_files() {
    let files = Memory::of([
        ("a b.mtl", "newmtl one\nKd 0.1\n"),
        ("c.mtl", "newmtl one\nKd 0.9\nnewmtl two\nKD 0.2 0.2 \\\n 0.2\n"),
        (
            "d.mtl",
            "newmtl three\nKd 0.3\nKs 1 1 1\nmap_Kd -s 1 1 1 wood.png\nbump b.png\nd -halo 0.5\nTr 0.5\n",
        ),
    ]);
    let text = format!(
        "mtllib a b.mtl\nusemtl one\n{TRIANGLE}mtllib c.mtl d.mtl\nusemtl two\nf 1 2 3\nusemtl three\nf 1 2 3\n"
    );
    let model = read("a.obj", text.as_bytes(), &files).unwrap();
    assert_eq!(model.bands, ["grey"]);
    let values: Vec<f64> = model.materials.iter().map(|material| material.reflectance[0]).collect();
    assert!(values.iter().zip([0.1, 0.2, 0.15]).all(|(a, b)| (a - b).abs() < 1e-15), "{values:?}");
    let expected = [
        "the material 'one' is described again with other values: the first ones are taken",
        "textures are left out: their mean reflectance is taken for 0.5",
        "textures are left out",
        "transparency is left out",
        "specular reflection is left out",
    ];
    assert_eq!(notes(&model), expected);
    let unknown = from(&format!("usemtl wood\n{TRIANGLE}")).unwrap();
    assert_eq!(unknown.materials[0].reflectance, [0.5]);
    assert_eq!(notes(&unknown), ["materials that no file describes reflect 0.5"]);
}

/// The only material of a text of materials with one named `a`, and what is noted of it.
#[track_caller]
fn material(mtl: &str) -> (Vec<f64>, Vec<f64>, Vec<String>) {
    let files = Memory::of([("b.mtl", format!("newmtl a\n{mtl}\n").as_bytes())]);
    let text = format!("mtllib b.mtl\nusemtl a\n{TRIANGLE}");
    let mut model = read("a.obj", text.as_bytes(), &files).unwrap();
    let told = notes(&model).into_iter().map(str::to_owned).collect();
    let material = model.materials.remove(0);
    (material.reflectance, material.emission, told)
}

#[test]
fn textures_are_told_with_the_number_that_stands_for_them() {
    let half = "textures are left out: their mean reflectance is taken for 0.5".to_owned();
    // Textures are multiplied by Kd, which is 1 where they stand alone.
    assert_eq!(material("map_Kd wood.png"), (vec![0.5], vec![0.0], vec![half.clone()]));
    assert_eq!(material("map_Kd wood.png\nKd 0.8 0.8 0.8"), (vec![0.4], vec![0.0], vec![half]));
    assert_eq!(material("bump b.png\nKd 0.8").0, [0.8]);
    assert_eq!(material("Kd .800 .797 .799").0, [0.8, 0.797, 0.799], "a hue as it is written");
    let dark = vec!["textures of emission are left out: what they make shine is dark".to_owned()];
    for mtl in ["map_Ke tube.png", "Ke 5 5 5\nmap_Ke tube.png"] {
        assert_eq!(material(mtl), (vec![0.0], vec![0.0], dark.clone()), "{mtl}");
    }
}

#[test]
fn names_hold_number_signs() {
    let files = Memory::of([(
        "dup #1.mtl",
        b"newmtl Material #25\nKd .9 .1 .1\nnewmtl Material #26\nKd .1 .9 .1\nKe 5 5 5\n",
    )]);
    let text = format!(
        "mtllib dup #1.mtl\no box #1\nusemtl Material #25\n{TRIANGLE}o box #2\nusemtl Material #26 # lamp\nf 3 2 1\n"
    );
    let model = read("a.obj", text.as_bytes(), &files).unwrap();
    assert_eq!(names(&model), ["box #1", "box #2"]);
    let found: Vec<(f64, f64)> =
        model.materials.iter().map(|own| (own.reflectance[0], own.emission[0])).collect();
    assert_eq!(found, [(0.9, 0.0), (0.1, 5.0 * PI)]);
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

#[test]
fn models_without_their_material_files_are_read() {
    let text = format!("mtllib gone.mtl\nusemtl wood\n{TRIANGLE}");
    let model = read("a.obj", text.as_bytes(), &Memory::default()).unwrap();
    assert_eq!((model.materials[0].name.as_str(), model.materials[0].reflectance[0]), ("wood", 0.5));
    let missing = "the material file 'gone.mtl' cannot be read: no such file";
    assert_eq!(notes(&model), [missing, "materials that no file describes reflect 0.5"]);
    assert_eq!(model.notes[0].place, Some(FilePlace::Line(1)));
}

#[test]
fn long_chains_of_continued_lines_take_no_quadratic_time() {
    let text = format!("{TRIANGLE}f 1 2{}3\n", " \\\n".repeat(1_000_000));
    assert_eq!(from(&text).unwrap().surfaces.len(), 2);
}

#[test]
fn broken_files_are_refused() {
    let refused = |text: &str, said: &str, cure: &str| assert_refusal(from(text), said, cure);
    refused("", "a.obj: the file holds no faces (f)", "polygons");
    refused("v 1 2 3\nhello world\n", "a.obj:2: 'hello' is no statement of OBJ", "take the line out");
    refused("v 1 2\n", "a.obj:1: the vertex has 2 coordinates, it takes 3", "x, y and z");
    refused("\nv 1 2 1e999\n", "a.obj:2: z is 1e999", "finite");
    refused("v 1 2 NaN\n", "a.obj:1: z is NaN", "finite");
    refused("v 1 2 x\n", "a.obj:1: z is 'x', which is no number", "number");
    let face = |corners: &str| format!("{TRIANGLE}f {corners}\n");
    refused(&face("1 2"), "a.obj:5: a face has 2 corners, 3 are the least", "three");
    refused(&face("1 2 4"), "a.obj:5: the face has the vertex 4; 3 are listed", "correct the number");
    refused(&face("1 2 0"), "a.obj:5: the face has the vertex 0", "from 1 on");
    refused(&face("1 2 -4"), "a.obj:5: the face has the vertex -4; 3 are listed above it", "list the vertex");
    refused(&face("1 2 /3"), "a.obj:5: the corner '/3' has no number of a vertex", "v//vn");
    refused(
        &face("1 2 9999999999999999999999"),
        "a.obj:5: the corner '9999999999999999999999' has no number of a vertex",
        "v/vt",
    );
    refused("v 1e60 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj:4: a coordinate is beyond 1e50", "scale");
    refused("v \0\n", "a.obj: byte 2: this is not a text: it holds a zero byte", "UTF-8");
    let with = |mtl: &str| {
        let text = format!("mtllib b.mtl\nusemtl a\n{TRIANGLE}");
        read("a.obj", text.as_bytes(), &Memory::of([("b.mtl", mtl.as_bytes())]))
    };
    assert_refusal(with("Kd 1 1 1\n"), "b.mtl:1: 'Kd' stands before the first material", "newmtl NAME");
    let refused = |kd: &str, said: &str, cure: &str| {
        assert_refusal(with(&format!("newmtl a\n\n{kd}\n")), &format!("b.mtl:3: {said}"), cure);
    };
    refused("Kd 1 1", "Kd has 2 numbers", "red, green and blue");
    refused("Kd 1 1 -0.5", "Kd is -0.5, below 0", "correct");
    refused("Ke inf", "Ke is inf", "finite");
    refused("Ke 1e308", "Ke is beyond 1e50", "correct");
    refused("Kd spectral a.rfl", "Kd is given as 'spectral'", "red, green and blue");
}
