//! The reader of Radiance scenes.

use std::f64::consts::PI;

use glam::DVec3;
use radiosity_formats::model::{Model, Shape, Sides};
use radiosity_formats::rad;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;

use super::assert_refused;
use crate::measures::{area, assert_cube, named, notes, vector};
use crate::memory::Memory;

pub(crate) fn read(text: &str) -> Result<Model, Refusal> {
    read_with(text, &[])
}

fn read_with(text: &str, files: &[(&'static str, &'static str)]) -> Result<Model, Refusal> {
    rad::read("room.rad", text.as_bytes(), &Memory::of(files.iter().copied()))
}

fn right(text: &str) -> Model {
    read(text).unwrap_or_else(|refusal| panic!("{refusal}"))
}

/// A scene with primitives of all types of Radiance that the reader tells apart, most of them once.
pub(crate) const ALL: &str = "\
# materials
void plastic white 0 0 5 .8 .8 .8 .05 0
void metal steel 0 0 5 .5 .6 .7 .9 .1
void trans curtain 0 0 7 .8 .8 .8 .1 0 .5 .2
void glass pane 0 0 3 .9 .9 .9
void light lamp 0 0 3 10 20 30
void glow sky 0 0 4 1 1 1 0
void spotlight spot 0 0 7 1 1 1 30 0 0 -1
void illum window 1 void 0 3 2 2 2
void colorpict picture 7 red green blue a.hdr picture.cal u v 0 0
picture plastic printed 0 0 5 .5 .5 .5 0 0
printed brightfunc dirt 2 dirty dirt.cal 0 0
void alias chalk white
void mixfunc blend 4 white steel half mix.cal 0 0
void antimatter cut 1 void 0 0
void mirror glossy 1 void 0 3 1 1 1
void BRTDfunc measured 10 0 0 0 0 0 0 0 0 0 . 0 9 .3 .3 .3 .1 .1 .1 0 0 0
void mist fog 0 0 3 .1 .1 .1
# surfaces
chalk polygon floor 0 0 12
    0 0 0   2 0 0   2 1 0   0 1 0
steel sphere ball 0 0 4 1 2 3 .5
steel bubble inside 0 0 4 1 2 3 .5
steel sphere negative 0 0 4 1 2 3 -.5
curtain cylinder post 0 0 7 0 0 0 0 0 2 .1
curtain tube pipe 0 0 7 0 0 0 0 0 2 .1
pane cone hat 0 0 8 0 0 0 0 0 1 .5 0
pane cup bowl 0 0 8 0 0 0 0 0 1 .2 .5
pane cone drum 0 0 8 0 0 0 0 0 1 .5 .5
lamp ring disk 0 0 8 0 0 3 0 0 -1 0 .5
spot ring annulus 0 0 8 0 0 3 0 0 -1 .5 .25
sky polygon above 0 0 9 0 0 9 0 1 9 1 0 9
window polygon opening 0 0 9 0 0 0 0 0 1 0 1 0
dirt polygon poster 0 0 9 0 0 0 0 0 1 0 1 0
blend polygon blended 0 0 9 0 0 0 0 0 1 0 1 0
measured polygon sample 0 0 9 0 0 0 0 0 1 0 1 0
glossy polygon reflector 0 0 9 0 0 0 0 0 1 0 1 0
cut sphere bite 0 0 4 0 0 0 1
void sphere ghost 0 0 4 0 0 0 1
sky source sun 0 0 4 0 0 1 180
white instance tree 1 tree.oct 0 0
white mesh bush 1 bush.rtm 0 0
";

#[test]
fn a_box_of_genbox_is_a_unit_cube() {
    let white = "void plastic white 0 0 5 .5 .5 .5 0 0\n";
    assert_cube(&right(&format!("{white}!genbox white box 1 1 1\n")), DVec3::splat(0.5), true);
    assert_cube(&right(&format!("{white}!genbox white box 1 1 1 -i | xform -I\n")), DVec3::splat(0.5), true);
    assert_cube(
        &right(&format!("{white}!genbox white box 2 2 2 | xform -n a -mx -s .5 -t 1 0 0\n")),
        DVec3::splat(0.5),
        true,
    );
    let inside = right(&format!("{white}!genbox white 'my box' 1 2 3 -i"));
    for surface in &inside.surfaces {
        let Shape::Polygon { outline, .. } = &surface.shape else { panic!("a polygon") };
        let middle = outline.iter().sum::<DVec3>() / 4.0;
        assert!(vector(outline).dot(middle - DVec3::new(0.5, 1.0, 1.5)) < 0.0);
    }
    assert_eq!(inside.surfaces[0].name, "my box");
    let total: f64 = inside.surfaces.iter().map(|surface| area(&surface.shape)).sum();
    assert!((total - 22.0).abs() < 1e-12);
}

#[test]
fn all_surfaces_are_read() {
    let model = right(ALL);
    let shape = |name: &str| &named(&model, name).shape;
    assert!((area(shape("floor")) - 2.0).abs() < 1e-15);
    assert_eq!(named(&model, "floor").place, Some(FilePlace::Line(20)));
    assert!(matches!(shape("ball"), Shape::Sphere { radius: 0.5, inward: false, .. }));
    assert!(matches!(shape("inside"), Shape::Sphere { inward: true, .. }));
    assert!(matches!(shape("negative"), Shape::Sphere { radius: 0.5, inward: true, .. }));
    assert!(matches!(shape("post"), Shape::Cylinder { inward: false, .. }));
    assert!(matches!(shape("pipe"), Shape::Cylinder { inward: true, .. }));
    assert!(matches!(shape("hat"), Shape::Cone { radii: [0.5, 0.0], inward: false, .. }));
    assert!(matches!(shape("bowl"), Shape::Cone { radii: [0.2, 0.5], inward: true, .. }));
    assert!(matches!(shape("drum"), Shape::Cylinder { radius: 0.5, .. }));
    assert!(matches!(shape("disk"), Shape::Disk { radius: 0.5, inner: 0.0, .. }));
    assert!(matches!(shape("annulus"), Shape::Disk { radius: 0.5, inner: 0.25, .. }));
    assert_eq!(model.surfaces.len(), 17);
    assert_eq!(
        notes(&model),
        [
            "specular reflection is left out",
            "transmission of trans materials is left out",
            "transmission through glass is left out: glass is black",
            "spotlights shine in all directions of their front",
            "patterns and textures are left out",
            "mixtures of materials are left out: the first of them counts",
            "mirrors and prisms are black",
            "antimatter is left out: what it cuts stays whole",
            "surfaces without a material (void) are left out",
            "light from afar (source) is left out",
            "instances of octrees are left out",
            "compiled meshes are left out",
        ]
    );
}

#[test]
fn cones_and_cups_of_radii_below_zero_are_one_another() {
    let cone = |kind: &str, radii: &str| {
        let text = format!("void plastic w 0 0 5 .5 .5 .5 0 0\nw {kind} s 0 0 8 0 0 0 0 0 1 {radii}");
        let Shape::Cone { radii, inward, .. } = right(&text).surfaces[0].shape else { panic!("a cone") };
        (radii, inward)
    };
    // As in Radiance's cone.c, with a warning.
    assert_eq!(cone("cone", "-2 -1"), ([2.0, 1.0], true));
    assert_eq!(cone("cup", "-2 0"), ([2.0, 0.0], false));
}

#[test]
fn the_diffuse_part_of_materials_stays() {
    let model = right(ALL);
    assert_eq!(model.bands, ["r", "g", "b"]);
    let coat = |name: &str| {
        let surface = named(&model, name);
        (&model.materials[surface.material.expect("one")], surface.sides)
    };
    let near = |values: &[f64], expected: [f64; 3]| {
        assert!(values.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{values:?} {expected:?}");
    };
    near(&coat("floor").0.reflectance, [0.76; 3]);
    near(&coat("ball").0.reflectance, [0.05, 0.06, 0.07]);
    near(&coat("post").0.reflectance, [0.36; 3]);
    near(&coat("hat").0.reflectance, [0.0; 3]);
    near(&coat("disk").0.emission, [10.0 * PI, 20.0 * PI, 30.0 * PI]);
    near(&coat("disk").0.reflectance, [0.0; 3]);
    near(&coat("opening").0.emission, [2.0 * PI; 3]);
    near(&coat("poster").0.reflectance, [0.5; 3]);
    near(&coat("blended").0.reflectance, [0.76; 3]);
    near(&coat("sample").0.reflectance, [0.3; 3]);
    near(&coat("reflector").0.reflectance, [0.0; 3]);
    assert_eq!([coat("floor").1, coat("disk").1, coat("above").1], [Sides::Both, Sides::Front, Sides::Front]);
    assert_eq!(coat("floor").0.name, "white");
}

#[test]
fn xform_places_files_in_arrays_with_other_names_and_modifiers() {
    let files = [
        (
            "lib/ball.rad",
            "void plastic blue 0 0 5 .1 .1 .9 0 0\nblue sphere ball 0 0 4 0 0 0 1\n!xform -n in -t 0 0 5 dot.rad\n",
        ),
        ("lib/dot.rad", "blue polygon dot 0 0 9 0 0 0 1 0 0 0 1 0\n"),
    ];
    let text = "void plastic red 0 0 5 .9 .1 .1 0 0\n\
                !xform -n row -m red -a 2 -t 10 0 0 -i 1 -s 2 lib/ball.rad\n\
                !xform -I lib/ball.rad | xform -e -mz\n";
    let model = read_with(text, &files).expect("they are there");
    let names: Vec<&str> = model.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["row.0.ball", "row.0.in.dot", "row.1.ball", "row.1.in.dot", "ball", "in.dot"]);
    let material = |k: usize| model.materials[model.surfaces[k].material.expect("one")].name.as_str();
    assert_eq!([material(0), material(3), material(4)], ["red", "red", "blue"]);
    assert!(matches!(
        model.surfaces[2].shape,
        Shape::Sphere { center, radius: 2.0, inward: false } if center == DVec3::new(20.0, 0.0, 0.0)
    ));
    assert!(matches!(model.surfaces[4].shape, Shape::Sphere { inward: true, .. }));
    let Shape::Polygon { outline, .. } = &model.surfaces[3].shape else { panic!("a polygon") };
    assert_eq!((outline[0], vector(outline).z), (DVec3::new(20.0, 0.0, 10.0), 2.0));
    let Shape::Polygon { outline, .. } = &model.surfaces[5].shape else { panic!("a polygon") };
    // Mirrored, its front looks down; turned over, up.
    assert_eq!((outline[0].z, vector(outline).z), (-5.0, 0.5));
}

#[test]
fn odd_but_legal_texts_are_read() {
    let text = "\u{feff}#dos\r\n\r\nvoid plastic\r\n\"a b\" 0 0 5 # five\r\n .5 .5 .5\r\n0 0\r\n'a b'\tring x 0\r\n0\r\n8 0 0 0 0 0 2 1 0\r\n!genbox 'a b' y 1 1 \\\r\n 1\r\n'a b' polygon p\r\n0 0 9 0 0 0 0 0 0 0 0 0";
    let model = right(text);
    assert_eq!((model.surfaces.len(), model.bands.len()), (8, 1));
    assert_eq!((model.materials[0].name.as_str(), model.materials[0].reflectance[0]), ("a b", 0.5));
    assert_eq!(model.surfaces[0].place, Some(FilePlace::Line(7)));
    assert_eq!(model.surfaces[7].place, Some(FilePlace::Line(12)));
}

#[test]
fn what_is_wrong_is_refused_with_a_cure() {
    let told = [
        ("m polygon p 0 0 9 0 0 0 1 0 0 0 1 0", "the modifier 'm' is not defined", "define it above"),
        ("void alias a b", "the modifier 'b' is not defined", "define it above"),
        ("void mixfunc a 0 0 0", "names no material", "first text"),
        ("w polygon p 0 0 6 0 0 0 1 0 0", "the polygon 'p' has 6 numbers", "count"),
        ("w polygon p 0 0 10 0 0 0 1 0 0 0 1 0 0", "has 10 numbers", "count"),
        ("w sphere s 0 0 3 1 1 1", "the sphere 's' has 3 numbers, 4", "count"),
        ("w sphere s 0 0 4 1 1 1 0", "a sphere has no radius", "give it one"),
        ("w sphere s 0 0 4 1 1 1 x", "'x', which is no number", "write a number"),
        ("w sphere s 0 0 4 1 1 1 nan", "a number is nan", "finite"),
        ("w cylinder s 0 0 7 0 0 0 0 0 0 1", "a cylinder has no axis", "part its ends"),
        ("w cone s 0 0 8 0 0 0 0 0 1 -1 1", "radii of both signs", "alike"),
        ("w ring s 0 0 8 0 0 0 0 0 1 -1 1", "a radius below 0", "0 or more"),
        ("w ring s 0 0 8 0 0 0 0 0 0 1 2", "a disk has no axis", "take it out"),
        ("w ring s 0 0 8 0 0 0 0 0 1 2 2", "a disk has no radius", "take it out"),
        ("void plastic p 0 0 3 1 1 1", "the plastic 'p' has 3 numbers, 4", "count"),
        ("void light p 0 0 3 1 -1 1", "the light 'p' has -1, below 0", "0 or more"),
        ("w cube c 0 0 0", "'cube' is no type of Radiance", "correct it"),
        ("w sphere s 0 0", "the file ends where the number of numbers", "complete"),
        ("w sphere s 0 0 4.5 1", "'4.5' is no number of numbers", "how many follow"),
        ("w sphere s 0 0 4000 1", "4000 numbers are announced", "how many follow"),
        ("!gensky 6 21 12", "the command '!gensky 6 21 12' is not run", "put what it prints"),
        ("!xform a.rad | psign", "is not run", "put what it prints"),
        ("!xform -t 1 0 0", "an xform names no file", "name one"),
        ("!xform -f x a.rad", "xform -f is not followed", "-rx"),
        ("!xform a.rad", "'a.rad' cannot be read", "beside the scene"),
        ("!genbox w b 1 1", "a genbox lacks arguments", "x y z"),
        ("!genbox w b 1 1 0", "a box has no volume", "above 0"),
        ("!genbox w b 1 1 1 -r .1", "genbox -r is not followed", "rounded"),
        (&format!("!genbox w b 1 1 1{}", " |xform".repeat(100_000)), "more than 32 stages", "join"),
        ("!genbox z b 1 1 1", "the modifier 'z' is not defined", "define it above"),
        ("!xform room.rad", "includes itself", "take one"),
    ];
    for (line, cause, cure) in told {
        let text = format!("void plastic w 0 0 5 .5 .5 .5 0 0\n\n{line}");
        assert_refused(read(&text), "room.rad", 3, [cause, cure]);
    }
}
