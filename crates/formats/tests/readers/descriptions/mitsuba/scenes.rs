//! Whole scenes.

use std::f64::consts::PI;

use glam::DVec3;
use radiosity_formats::model::{Shape, Sides};
use radiosity_photometry::file_place::FilePlace;

use super::{beside, notes, read, right};
use crate::measures::{assert_cube, named, polygon};

const ROOM: &str = include_str!("../../../fixtures/room.xml");

/// Reflectance, exitance and sides of the surface `name` of the room.
fn values(name: &str) -> (Vec<f64>, Vec<f64>, Sides) {
    let room = read(ROOM).expect("the room is right");
    let surface = named(&room, name);
    let material = &room.materials[surface.material.expect("all surfaces have materials")];
    (material.reflectance.clone(), material.emission.clone(), surface.sides)
}

#[test]
fn the_room_has_its_surfaces() {
    let room = read(ROOM).expect("the room is right");
    let names: Vec<&str> = room.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    let expected = [
        "floor", "ceiling", "left", "box-1", "box-2", "box-3", "box-4", "box-5", "box-6", "ball", "pipe",
        "lamp",
    ];
    assert_eq!(names, expected);
    assert_eq!(room.bands, ["r", "g", "b"]);
    assert_eq!(polygon(named(&room, "floor")), DVec3::new(0.0, 0.0, 16.0));
    assert_eq!(polygon(named(&room, "ceiling")), DVec3::new(0.0, 0.0, -16.0));
    assert_eq!(polygon(named(&room, "left")), DVec3::new(16.0, 0.0, 0.0));
    assert_eq!(named(&room, "floor").place, Some(FilePlace::Line(37)));
    let ball = Shape::Sphere { center: DVec3::new(-1.0, 0.0, 0.5), radius: 0.5, inward: false };
    assert_eq!(named(&room, "ball").shape, ball);
    let base = DVec3::new(0.0, 1.0, 0.0);
    let pipe = Shape::Cylinder { base, axis: 4.0 * DVec3::Z, radius: 0.1, inward: true };
    assert_eq!(named(&room, "pipe").shape, pipe);
    let center = DVec3::new(0.0, 0.0, 3.9);
    assert_eq!(
        named(&room, "lamp").shape,
        Shape::Disk { center, normal: -DVec3::Z, radius: 0.25, inner: 0.0 }
    );
}

#[test]
fn the_room_has_its_materials() {
    let none = vec![0.0; 3];
    let near = |found: (Vec<f64>, Vec<f64>, Sides), reflectance: [f64; 3], sides: Sides| {
        assert!(found.0.iter().zip(reflectance).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        assert_eq!((found.1, found.2), (none.clone(), sides));
    };
    near(values("floor"), [0.2, 0.3, 0.4], Sides::Front);
    near(values("ceiling"), [0.8; 3], Sides::Both);
    near(values("left"), [1.0, 0.0, 0.0], Sides::Front);
    // 500 to 600 nm: the mean from 0.1 to 0.3.
    near(values("box-1"), [0.3, 0.2, 0.1], Sides::Front);
    near(values("ball"), [0.0; 3], Sides::Front);
    near(values("pipe"), [0.5; 3], Sides::Front);
    assert_eq!(values("lamp"), (none.clone(), vec![10.0 * PI, 10.0 * PI, 5.0 * PI], Sides::Front));
}

#[test]
fn the_room_says_what_is_left_out() {
    let room = read(ROOM).expect("the room is right");
    let told = [
        ("checkerboards are even: the mean of their two colours", 1),
        ("of bsdfs of type 'plastic': specular reflection is left out", 1),
        (
            "spectra become red, green and blue by their means over 600 to 700, 500 to 600 and 400 to 500 nm",
            1,
        ),
        ("of bsdfs of type 'conductor': they are black", 1),
        ("emitters of type 'constant' are left out", 1),
    ];
    assert_eq!(notes(&room), told);
}

#[test]
fn a_cube_is_six_squares_that_look_outwards() {
    let cube = |flip: &str| {
        let text = format!(
            "<shape type=\"cube\">{flip}<transform name=\"to_world\"><translate x=\"1\" y=\"1\" z=\"1\"/>\
             <scale value=\"0.5\"/></transform></shape>"
        );
        right(&text)
    };
    assert_cube(&cube(""), DVec3::splat(0.5), true);
    assert_cube(&cube("<boolean name=\"flip_normals\" value=\"true\"/>"), DVec3::splat(0.5), false);
}

#[test]
fn six_rectangles_are_a_cube_too() {
    let turns = [
        "<rotate x=\"1\" angle=\"0\"/>",
        "<rotate x=\"1\" angle=\"90\"/>",
        "<rotate x=\"1\" angle=\"180\"/>",
        "<rotate x=\"1\" angle=\"-90\"/>",
        "<rotate y=\"1\" angle=\"90\"/>",
        "<rotate y=\"1\" angle=\"-90\"/>",
    ];
    let room = |flip: &str| {
        let sides = turns.map(|turn| {
            format!(
                "<shape type=\"rectangle\">{flip}<transform name=\"to_world\"><translate z=\"1\"/>{turn}\
                 <scale value=\"0.5\"/></transform></shape>"
            )
        });
        right(&sides.concat())
    };
    assert_cube(&room(""), DVec3::ZERO, true);
    assert_cube(&room("<boolean name=\"flip_normals\" value=\"true\"/>"), DVec3::ZERO, false);
}

/// The cube of an OBJ is the cube of Mitsuba, whatever its own materials.
#[test]
fn meshes_are_read_and_merged() {
    let obj = "mtllib none.mtl\nusemtl a\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
               f 1 4 3\nusemtl b\nf 1 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";
    let text = "<path value=\"meshes\"/>\n<shape type=\"obj\" id=\"box\"><string name=\"filename\" value=\"box.obj\"/>\
                <transform name=\"to_world\"><scale value=\"0.5\"/></transform></shape>";
    let model = beside(text, &[("meshes/box.obj", obj)]).expect("the box is right");
    assert_cube(&model, DVec3::ZERO, true);
    assert_eq!((model.surfaces[0].name.as_str(), model.materials[0].name.as_str()), ("box-1", "default"));
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

/// Mitsuba finds normals that a mesh does not state from its corners once they are placed; those that it
/// states, and what an instance places, it turns as the surface is.
#[test]
fn mirrored_meshes_keep_their_fronts_where_they_state_normals() {
    let corners = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
    let bare = format!("{corners}f 1 2 3 4\n");
    let stated = format!("{corners}vn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
    let ply = |normals: &str, zeros: &str| {
        let rows = ["-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0"].map(|row| format!("{row}{zeros}\n")).concat();
        format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n{normals}\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n{rows}4 0 1 2 3\n"
        )
    };
    let normals = "property float nx\nproperty float ny\nproperty float nz\n";
    let files = [
        ("bare.obj", bare),
        ("stated.obj", stated),
        ("bare.ply", ply("", "")),
        ("stated.ply", ply(normals, " 0 0 1")),
    ];
    let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
    let mirror = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
    let shape = |name: &str, inner: &str| {
        let kind = &name[name.len() - 3..];
        format!("<shape type=\"{kind}\"><string name=\"filename\" value=\"{name}\"/>{inner}</shape>")
    };
    let front = |text: &str| polygon(&beside(text, &files).expect("the square is right").surfaces[0]).z;
    for ending in ["obj", "ply"] {
        let [bare, stated] = ["bare", "stated"].map(|name| format!("{name}.{ending}"));
        assert_eq!(front(&shape(&bare, "")), 4.0);
        assert_eq!(front(&shape(&bare, mirror)), -4.0);
        assert_eq!(front(&shape(&stated, mirror)), 4.0);
        let faces = format!("{mirror}<boolean name=\"face_normals\" value=\"true\"/>");
        assert_eq!(front(&shape(&stated, &faces)), -4.0);
        let group = shape(&bare, "");
        let instance = format!(
            "<shape type=\"shapegroup\" id=\"g\">{group}</shape><shape type=\"instance\"><ref id=\"g\"/>{mirror}</shape>"
        );
        assert_eq!(front(&instance), 4.0);
    }
}
