//! The reader of MGF.

use glam::DVec3;
use radiosity_formats::mgf;
use radiosity_formats::model::{Model, Shape, Sides};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;

use super::assert_refused;
use crate::measures::{area, assert_cube, named, notes, vector};
use crate::memory::Memory;

pub(crate) fn read(text: &str) -> Result<Model, Refusal> {
    read_with(text, &[])
}

fn read_with(text: &str, files: &[(&'static str, &'static str)]) -> Result<Model, Refusal> {
    mgf::read("room.mgf", text.as_bytes(), &Memory::of(files.iter().copied()))
}

fn right(text: &str) -> Model {
    read(text).unwrap_or_else(|refusal| panic!("{refusal}"))
}

/// A scene with all entities of MGF.
pub(crate) const ALL: &str = "\
# A room \\
  of all entities
xf -s 2
m red =
\tc
\t\tcxy 0.6 0.33
\trd 0.3
\tsides 1
m lamp =
\tc warm =
\t\tcct 3000
\ted 1500
m cloth = red
\tsides 2
c green =
\tcspec 400 700 0 0 1 0 0
c both =
\tcmix 0.5 green 0.5 warm
m mixed =
\tc both
\trd .5
\trs .1 .05
\tts .2 0
\ttd .1
\tir 1.5 0
v a =
\tp 0 0 0
\tn 0 0 1
v b = a
\tp 1 0 0
v c =
\tp 1 1 0
v d =
\tp 0 1 .5
v e =
\tp 0 1 0
o things
m red
f a b c
f a b c d
m lamp
o hole
fh a b c e - a b c
o
cyl a 1 b
cyl a -1 b
m cloth
cone a 1 b 2
cone a -1 b 0
cone a 1 b 1
m mixed
sph a 3
sph a -3
ring a 0 1
ring a 1 2
torus a 1 3
torus a -1 -3
prism a b c e 2
o
xf
ies lamp.ies -t 0 0 1
m
f a b c
";

#[test]
fn the_unit_cube_of_the_specification_reads_as_six_squares() {
    let cube = "v cv0 =\n\tp 0 0 0\nv cv1 =\n\tp 0 1 0\nv cv2 =\n\tp 1 1 0\nv cv3 =\n\tp 1 0 0\nprism cv0 cv1 cv2 cv3 1\n";
    assert_cube(&right(cube), DVec3::splat(0.5), true);
    // The same from its front side: mirrored, moved back, and turned by quarters.
    let mirrored = format!("xf -mx -t 1 0 0 -rz 90 -rz 270\n{cube}xf\n");
    assert_cube(&right(&mirrored), DVec3::splat(0.5), true);
    let inside = right(&cube.replace("cv3 1", "cv3 -1"));
    let Shape::Polygon { outline, .. } = &inside.surfaces[0].shape else { panic!("a polygon") };
    let Shape::Polygon { outline: opposite, .. } = &inside.surfaces[5].shape else { panic!("a polygon") };
    assert_eq!((vector(outline).z, outline[0].z), (-1.0, 0.0));
    assert_eq!((vector(opposite).z, opposite[0].z), (1.0, -1.0));
}

#[test]
fn all_entities_are_read() {
    let model = right(ALL);
    assert_eq!(model.bands, ["r", "g", "b"]);
    let shape = |name: &str| &named(&model, name).shape;
    assert!((area(shape("things")) - 2.0).abs() < 1e-12, "a triangle of area 1/2, twice as long");
    assert!(matches!(shape("things-2"), Shape::Quad(corners) if corners[3] == DVec3::new(0.0, 2.0, 1.0)));
    assert!((area(shape("things/hole")) - 2.0).abs() < 1e-12);
    assert_eq!(
        shape("things-3"),
        &Shape::Cylinder { base: DVec3::ZERO, axis: 2.0 * DVec3::X, radius: 2.0, inward: false }
    );
    assert!(matches!(shape("things-4"), Shape::Cylinder { inward: true, radius: 2.0, .. }));
    assert!(matches!(shape("things-5"), Shape::Cone { inward: false, radii: [2.0, 4.0], .. }));
    assert!(matches!(shape("things-6"), Shape::Cone { inward: true, radii: [2.0, 0.0], .. }));
    assert!(matches!(shape("things-7"), Shape::Cylinder { .. }));
    assert!(matches!(shape("things-8"), Shape::Sphere { radius: 6.0, inward: false, .. }));
    assert!(matches!(shape("things-9"), Shape::Sphere { radius: 6.0, inward: true, .. }));
    assert!(matches!(shape("things-10"), Shape::Disk { radius: 2.0, inner: 0.0, .. }));
    assert!(matches!(shape("things-11"), Shape::Disk { radius: 4.0, inner: 2.0, .. }));
    assert!(matches!(shape("things-12"), Shape::Torus { major: 4.0, minor: 2.0, inward: false, .. }));
    assert!(matches!(shape("things-13"), Shape::Torus { major: 4.0, minor: 2.0, inward: true, .. }));
    // Six faces of the prism and one outside all objects.
    assert_eq!(model.surfaces.len(), 21);
    assert!(named(&model, "polygon-21").place == Some(FilePlace::Line(ALL.lines().count())));
    let sides = |name: &str| named(&model, name).sides;
    assert_eq!(
        [sides("things"), sides("things-3"), sides("things-5")],
        [Sides::Front, Sides::Both, Sides::Both]
    );
    assert_eq!(
        notes(&model),
        [
            "normals of vertices are left out: faces are flat",
            "a face of four corners is off its plane: it is a bilinear patch",
            "indices of refraction are left out",
            "specular reflection is left out",
            "diffuse transmission is left out",
            "specular transmission is left out",
            "luminaires with measured light (ies) are left out",
        ]
    );
}

#[test]
fn colours_have_the_reflectance_that_is_written() {
    let model = right(ALL);
    let luminance = |values: &[f64]| 0.2126 * values[0] + 0.7152 * values[1] + 0.0722 * values[2];
    let material = |name: &str| &model.materials[named(&model, name).material.expect("a material")];
    let red = material("things");
    assert!((luminance(&red.reflectance) - 0.3).abs() < 1e-12);
    assert!(red.reflectance[0] > 3.0 * red.reflectance[1] && red.emission == [0.0; 3]);
    let lamp = material("things-3");
    assert!((luminance(&lamp.emission) - 1500.0).abs() < 1e-9);
    assert!(lamp.emission[0] > lamp.emission[1] && lamp.emission[1] > lamp.emission[2]);
    let green = material("things-8");
    assert!((luminance(&green.reflectance) - 0.5).abs() < 1e-12);
    assert!(green.reflectance[1] > green.reflectance[2]);
    assert_eq!(material("polygon-21").reflectance, [0.0; 3]);
    let grey = right("m a =\n rd .25\n ed 3\nv a =\nv b =\n p 1 0 0\nv c =\n p 0 1 0\nf a b c");
    assert_eq!(grey.bands, ["grey"]);
    assert_eq!((grey.materials[0].reflectance[0], grey.materials[0].emission[0]), (0.25, 3.0));
}

#[test]
fn transforms_stack_and_arrays_repeat_what_they_enclose() {
    let text = "xf -t 5 0 0\nv v1 =\n\tp 0 10 0\n\tn 0 0 1\nxf -rx 180\nring v1 0 2\nxf\nxf\nring v1 0 2\n";
    let model = right(text);
    let center = |k: usize| match model.surfaces[k].shape {
        Shape::Disk { center, normal, .. } => (center, normal),
        _ => panic!("a disk"),
    };
    assert_eq!(center(0), (DVec3::new(5.0, -10.0, 0.0), -DVec3::Z), "the example of the specification");
    assert_eq!(center(1), (DVec3::new(0.0, 10.0, 0.0), DVec3::Z));
    let array = "v v0 =\nxf -t 0 0 1\nxf -a 3 -t 1 0 0 -a 4 -t 0 1 0\nxf -a 2 -t 0 0 10\nsph v0 .1\nxf\nxf\nxf\nsph v0 1";
    let model = right(array);
    assert_eq!(model.surfaces.len(), 25);
    let centers: Vec<DVec3> = (0..24)
        .map(|k| match model.surfaces[k].shape {
            Shape::Sphere { center, .. } => center,
            _ => panic!("a sphere"),
        })
        .collect();
    assert_eq!(centers[..3], [DVec3::Z, 11.0 * DVec3::Z, DVec3::Y + DVec3::Z]);
    assert_eq!(centers[23], DVec3::new(2.0, 3.0, 11.0));
    assert!(matches!(model.surfaces[24].shape, Shape::Sphere { center: DVec3::ZERO, .. }));
}

#[test]
fn includes_are_found_beside_the_file_that_names_them() {
    let files = [
        ("parts/leg.mgf", "i ../ball.inc -t 0 0 1\n"),
        ("ball.inc", "v c =\no ball\nsph c 1\no\nxf -t 9 9 9\n"),
    ];
    let model =
        read_with("i parts\\leg.mgf -a 2 -t 5 0 0 -i 1 -s 2\nsph c 1\n", &files).expect("it is there");
    let places: Vec<DVec3> = model
        .surfaces
        .iter()
        .map(|surface| match surface.shape {
            Shape::Sphere { center, .. } => center,
            _ => panic!("a sphere"),
        })
        .collect();
    assert_eq!(places, [DVec3::new(0.0, 0.0, 2.0), DVec3::new(10.0, 0.0, 2.0), DVec3::ZERO]);
    assert_eq!(notes(&model), ["a transform that is not ended ends with its file"]);
    assert_eq!(model.notes[0].count, 2);
    let circle = [("a.mgf", "\ni b.mgf\n"), ("b.mgf", "i ./a.mgf")];
    assert_refused(
        read_with("i a.mgf", &circle),
        "b.mgf",
        1,
        ["'a.mgf' includes itself", "take one include out"],
    );
    assert_refused(read("\ni room.mgf"), "room.mgf", 2, ["includes itself", "take one"]);
    assert_refused(read("i c.mgf"), "room.mgf", 1, ["'c.mgf' cannot be read", "put it beside"]);
    let broken = [("b.mgf", "v a =\n p 1 2\n")];
    assert_refused(read_with("i b.mgf", &broken), "b.mgf", 2, ["p has 2 arguments, 3", "on one line"]);
}

#[test]
fn nested_files_are_counted() {
    let files = (0..40).map(|depth| (format!("f{depth}"), format!("i f{}\n", depth + 1)));
    let found = mgf::read("room.mgf", b"i f0", &Memory::of(files));
    assert_refused(found, "f30", 1, ["more than 32 deep", "join some"]);
}

#[test]
fn files_that_include_one_another_over_and_over_are_given_up() {
    let text = |depth: usize| format!("i g{} -a 50\ni g{}\n", depth + 1, depth + 1);
    let files = (0..20).map(|depth| (format!("g{depth}"), text(depth)));
    let files = files.chain([("g20".to_owned(), "#".to_owned())]);
    let refusal = mgf::read("room.mgf", b"i g0", &Memory::of(files)).expect_err("it is endless");
    assert!(refusal.cause.contains("characters are followed"), "{refusal}");
}

#[test]
fn odd_but_legal_texts_are_read() {
    let text = "\u{feff}# dos\r\n\r\nv a =\r\n  p 0. .0 +0e0\r\nv b =\r\n\tp 1 0 0\r\nv c\t=\r\np 0 1 0\r\n\
                #no blank behind\r\nF a b c\r\nm\\\r\n x =\r\n rd 1\r\nf \\\r\na b\\\r\n c\r\no\r\nm x\r\n sides 2\r\nrs 0 0\r\nf a b c a b c\r\nf a a a";
    let model = right(text);
    assert_eq!(model.surfaces.len(), 3);
    assert_eq!(model.surfaces[0].place, Some(FilePlace::Line(14)));
    assert_eq!((model.materials.len(), model.materials[0].reflectance[0]), (1, 1.0));
    assert_eq!(
        notes(&model),
        ["lines that begin with no word of MGF are left out", "an o that ends no object is left out"]
    );
    let old = right("v a =\rv b =\r\tp 1 0 0\rv c =\r\tp 0 1 0\rf a b c\r");
    assert_eq!(old.surfaces[0].place, Some(FilePlace::Line(6)));
    // A material that is changed after it was used is another of its name.
    let changed = right(
        "v a =\nv b =\n p 1 0 0\nv c =\n p 0 1 0\nm x =\n rd .5\nf a b c\nm x\n rd .25\nf a b c\nm x =\nrd .5\nf a b c",
    );
    let names: Vec<&str> = changed.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["x", "x-2"]);
    assert_eq!(changed.surfaces[2].material, Some(0));
}

#[test]
fn what_is_wrong_is_refused_with_a_cure() {
    let vertices = "v a =\n p 0 0 0\nv b =\n p 1 0 0\nv c =\n p 0 1 0\nv n =\n n 0 0 1\n";
    let told = [
        ("f a b", "a face has 2 vertices", "add some"),
        ("fh a b c - a b", "an outline of a face has 2", "add some"),
        ("fh a b c -", "an outline of a face has 0", "add some"),
        ("f a b z", "the vertex 'z' is not defined", "define it above"),
        ("v z", "the vertex 'z' is not defined", "define it above"),
        ("m stone", "the material 'stone' is not defined", "stone ="),
        ("c a b", "the arguments of a colour", "blanks"),
        ("p 1 2 x", "a number of p is 'x', which is no number", "write a number"),
        ("p 1 2 1e999", "is 1e999", "finite"),
        ("n 1 2", "n has 2 arguments, 3", "backslash"),
        ("sides 3", "3 sides", "sides 1 or sides 2"),
        ("cspec 400", "cspec has 1", "one line"),
        ("cmix 1", "lacks a colour", "weight before each"),
        ("cmix 1 z", "the colour 'z' is not defined", "define it"),
        ("rs", "rs has 0", "one line"),
        ("o a b", "o has 2", "one line"),
        ("sph a", "sph does not have 1", "sph vertex radius"),
        ("sph a 0", "a sphere has no radius", "give it one"),
        ("cyl a 1 a", "a cylinder has no axis", "part its ends"),
        ("cyl a 0 b", "a cylinder has no radius", "give it one"),
        ("cone a 1 b -2", "different signs", "both above 0"),
        ("ring a 0 1", "the vertex of a ring has no normal", "n 0 0 1"),
        ("ring n 2 1", "not in order", "inner"),
        ("ring n -1 1", "not in order", "inner"),
        ("torus a 1 2", "the vertex of a torus has no normal", "n 0 0 1"),
        ("torus n -1 2", "not in order", "one sign"),
        ("prism a b c 0", "a prism has no volume", "a length"),
        ("prism a b a 1", "a prism has no volume", "an end with an area"),
        ("xf", "ends no transform", "take it out"),
        ("xf -q 1", "'-q' is no part of a transform", "-rx"),
        ("xf -a 2 -t 1 0 0", "an array is not ended", "xf alone"),
        ("i", "an include names no file", "behind i"),
        ("rd 1e99\nf a b c", "the material 'unnamed' has a value beyond", "correct its"),
        ("xf -s 1e200 -s 1e200\nsph b 1\nxf", "is beyond 1e50 after transforms", "scale the scene"),
    ];
    for (line, cause, cure) in told {
        let extra = usize::from(line.contains('\n'));
        assert_refused(read(&format!("{vertices}{line}\n")), "room.mgf", 9 + extra, [cause, cure]);
    }
    let colours = [
        ("cxy .9 .9", "no colour has the chromaticity", "sum to 1"),
        ("cspec 400 700 1", "a spectrum has no range", "two values"),
        ("cspec 400 700 0 0", "no light that an eye sees", "between 380 and 780"),
        ("cct 10", "hardly glows", "1000 K"),
    ];
    for (line, cause, cure) in colours {
        assert_refused(read(&format!("{vertices}{line}\nrd .5\nf a b c\n")), "room.mgf", 9, [cause, cure]);
        let unused = right(&format!("{vertices}c odd =\n{line}\nc\nrd .5\nf a b c\n"));
        assert_eq!(notes(&unused), ["faulty colours and materials that no surface has are left out"]);
    }
    let dark = read(&format!("{vertices}rd -1\nf a b c\n"));
    assert_refused(dark, "room.mgf", 9, ["rd is -1, below 0", "0 or more"]);
    let binary = mgf::read("x.mgf", b"v a\0", &Memory::default()).expect_err("zero bytes");
    assert!(binary.cause.contains("no text") || binary.cause.contains("not a text"));
}

#[test]
fn faces_are_curved_only_beyond_rounding() {
    let face =
        |z: f64| right(&format!("v a =\nv b =\n p 1 0 0\nv c =\n p 1 1 0\nv d =\n p 0 1 {z}\nf a b c d"));
    assert!(matches!(face(1e-5).surfaces[0].shape, Shape::Polygon { .. }));
    assert!(matches!(face(1e-3).surfaces[0].shape, Shape::Quad(_)));
}
