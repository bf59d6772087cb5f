//! View3D inputs read and written.

use glam::DVec3;
use radiosity_formats::model::{Material, Model, Shape, Sides, Surface};
use radiosity_formats::vs3;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;
use radiosity_test_support::mutations::break_often;

use crate::measures::{assert_cube, named, polygon, vector};
use crate::memory::Memory;
use crate::promises::assert_promised;

pub(crate) fn read(text: &str) -> Result<Model, Refusal> {
    vs3::read("room.vs3", text.as_bytes(), &NoFiles)
}

fn near(found: DVec3, expected: [f64; 3]) {
    assert!((found - DVec3::from_array(expected)).length() < 1e-12, "{found} instead of {expected:?}");
}

#[test]
fn a_unit_cube_is_six_squares_that_face_its_middle() {
    let model = read(include_str!("../../fixtures/cube.vs3")).expect("the cube is right");
    assert_cube(&model, DVec3::splat(0.5), false);
    assert_eq!(model.title.as_deref(), Some("Unit cube from inside"));
    assert_eq!(model.bands, ["grey"]);
    assert_eq!(model.materials.len(), 1);
    assert_eq!(model.materials[0].reflectance, [0.1]);
    assert_eq!(model.surfaces[0].name, "floor");
    assert_eq!(model.surfaces[0].place, Some(FilePlace::Line(14)));
    assert!(model.surfaces.iter().all(|surface| surface.sides == Sides::Front));
    assert!(model.notes.is_empty(), "{:?}", model.notes);
}

#[test]
fn an_obstruction_is_black() {
    let model = read(include_str!("../../fixtures/square-between.vs3")).expect("the squares are right");
    near(polygon(named(&model, "bottom")), [0.0, 0.0, 1.0]);
    near(polygon(named(&model, "top")), [0.0, 0.0, -1.0]);
    let between = named(&model, "between");
    near(polygon(between), [0.0, 0.0, 0.25]);
    assert_eq!(between.material.map(|index| model.materials[index].reflectance.clone()), Some(vec![0.0]));
}

/// The vectors of a closed room add up to nothing, and its volume is a third of the sum of corner · vector.
#[test]
fn the_l_shaped_room_is_closed_in_both_geometries() {
    let room = read(include_str!("../../fixtures/l-room.vs3")).expect("the room is right");
    near(room.surfaces.iter().map(polygon).sum(), [0.0; 3]);
    let volume = |surface: &Surface| {
        let Shape::Polygon { outline, .. } = &surface.shape else { unreachable!() };
        -outline[0].dot(vector(outline)) / 3.0
    };
    assert!((room.surfaces.iter().map(volume).sum::<f64>() - 15.0).abs() < 1e-12);
    let notes: Vec<(&str, usize)> = room.notes.iter().map(|note| (note.text.as_str(), note.count)).collect();
    assert_eq!(
        notes,
        [
            ("the combining of surfaces in the output is left out", 4),
            ("encl=1, which adjusts view factors to an enclosure, is left out", 1)
        ]
    );
    let planes = read(include_str!("../../fixtures/l-room-3a.vs3")).expect("the room is right");
    for surface in &planes.surfaces[..8] {
        let twin = named(&room, &surface.name);
        assert_eq!(polygon(surface), polygon(twin), "{}", surface.name);
        let (Shape::Polygon { outline: a, .. }, Shape::Polygon { outline: b, .. }) =
            (&surface.shape, &twin.shape)
        else {
            unreachable!()
        };
        assert!(a.iter().all(|corner| b.contains(corner)), "{a:?} {b:?}");
    }
    near(polygon(&planes.surfaces[8]), [0.0, 0.0, 1.0]);
}

#[test]
fn what_lies_on_a_base_is_cut_from_it() {
    let model = read(include_str!("../../fixtures/window.vs3")).expect("odd, but right");
    let names: Vec<&str> = model.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["wall", "door", "pane", "cover", "wall-2", "surface-6", "obstruction-7"]);
    // 18 of the wall, 2 of the door, 1 of the triangle in front of it.
    near(polygon(&model.surfaces[0]), [0.0, 15.0, 0.0]);
    near(polygon(&model.surfaces[1]), [0.0, 2.0 - 0.48, 0.0]);
    near(polygon(&model.surfaces[2]), [0.0, 0.48, 0.0]);
    near(polygon(&model.surfaces[3]), [0.0, -1.0, 0.0]);
    near(polygon(&model.surfaces[6]), [0.0, -0.5 + 0.02, 0.0]);
    let reflectances: Vec<f64> =
        model.surfaces.iter().filter_map(|s| s.material).map(|m| model.materials[m].reflectance[0]).collect();
    assert_eq!(reflectances, [0.1, 0.5, 0.5, 0.0, 0.877, 0.0, 0.0]);
    let notes: Vec<&str> = model.notes.iter().map(|note| note.text.as_str()).collect();
    assert_eq!(
        notes,
        [
            "a black surface takes the place of a masking or null surface",
            "the combining of surfaces in the output is left out",
            "encl=1, which adjusts view factors to an enclosure, is left out",
            "coordinate transformations (X) are left out"
        ]
    );
}

/// A triangle and what a change of its lines is refused for: line, part of the cause, part of the cure.
#[test]
fn broken_inputs_are_refused_with_line_cause_and_cure() {
    let right = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 0 1 0\nS 1 1 2 3 0 0 0 0.9 a\nE\n";
    assert!(read(right).is_ok());
    let cases = [
        ("F 3", "F 2", Some(1), "the geometry is '2'", "write F 3"),
        ("V 2 1 0 0", "V 2 1 0", Some(3), "a vertex has 3 words", "write V, its number"),
        ("V 2 1 0 0", "V 2 1e999 0 0", Some(3), "x is 1e999", "finite"),
        ("V 2 1 0 0", "V 2 1e200 0 0", Some(5), "a coordinate is beyond 1e50", "smaller"),
        ("V 2 1 0 0", "V 2 l 0 0", Some(3), "x is 'l'", "write a number"),
        ("V 2", "V 3", Some(3), "the number of a vertex is '3', it has to be 2", "from 1"),
        ("V 2", "W 2", Some(3), "a line begins with 'W'", "T, C, F, V, S"),
        ("S 1", "S 2", Some(5), "the number of a surface is '2'", "from 1"),
        (
            "1 2 3 0 0 0 0.9 a",
            "1 2 3",
            Some(5),
            "a surface lacks some of its four vertices",
            "0 for a triangle",
        ),
        ("1 2 3 0 0 0 0.9 a", "1 2 3 0 0 0", Some(5), "a surface lacks its base", "base (0 for none)"),
        ("1 2 3 0 0", "1 2 4 0 0", Some(5), "there is no vertex 4", "from 1 to 3"),
        ("1 2 3 0 0", "1 0 3 0 0", Some(5), "there is no vertex 0", "only the fourth"),
        ("1 2 3 0 0", "1 -2 3 0 0", Some(5), "a vertex is '-2'", "number that it has"),
        ("0 0 0.9", "0 0 1.1", Some(5), "the emittance is 1.1", "from 0 to 1"),
        ("0 0 0.9", "-1 0 0.9", Some(5), "the base is '-1'", "number"),
        ("0 0 0 0.9", "0 1 0 0.9", Some(5), "the base 1 is neither", "behind its base"),
        ("S 1 1 2 3 0 0 0 0.9 a", "M 1 1 2 3 0 0 0 0.9 a", Some(5), "has no base", "number of the surface"),
        ("S 1 1 2 3 0 0 0 0.9 a\nE", "S 1 R 0 0 0.9 a\n0 0 0 0", Some(5), "has 4 numbers", "origin, azimuth"),
        ("S 1 1 2 3 0 0 0 0.9 a", "S 1 R 0 0 0.9 a\n0 0 0 x", Some(6), "'x'", "write a number"),
        ("S 1 1 2 3 0 0 0 0.9 a", "", None, "there are no surfaces", "begin with S"),
        ("E\n", "V 4 0 1 1\nS 2 1 2 4 0 1 0 0.9 b", Some(7), "not lie in the plane of its base 1", "base 0"),
    ];
    for (from, to, line, cause, cure) in cases {
        let text = right.replacen(from, to, 1);
        let refusal = read(&text).expect_err(&text);
        assert_eq!(refusal.file, "room.vs3");
        assert_eq!(refusal.place, line.map(FilePlace::Line), "{refusal}");
        assert!(refusal.cause.contains(cause), "{refusal}");
        assert!(refusal.cure.contains(cure), "{refusal}: {}", refusal.cure);
    }
    let refusal = vs3::read("room.vs3", b"V 1\0", &NoFiles).expect_err("no text");
    assert!(refusal.cause.contains("zero byte"));
}

fn surfaces_of(model: &Model) -> Vec<(&str, DVec3, Option<f64>)> {
    let reflectance = |surface: &Surface| surface.material.map(|index| model.materials[index].reflectance[0]);
    model
        .surfaces
        .iter()
        .map(|surface| (surface.name.as_str(), polygon(surface), reflectance(surface)))
        .collect()
}

#[test]
fn written_inputs_read_as_they_were() {
    for text in [include_str!("../../fixtures/cube.vs3"), include_str!("../../fixtures/square-between.vs3")] {
        let model = read(text).expect("the input is right");
        let written = vs3::write::write(&model).expect("all is flat");
        let again = read(&written).expect("what is written is right");
        assert_eq!(surfaces_of(&model), surfaces_of(&again), "{written}");
        assert_eq!(model.title, again.title);
    }
}

#[test]
fn holes_backs_colours_and_names_are_written_in_the_words_of_view3d() {
    let square = |low: f64, high: f64| -> Vec<DVec3> {
        [[low, low], [high, low], [high, high], [low, high]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec()
    };
    let surface = |name: &str, sides, holes| Surface {
        name: name.to_owned(),
        material: Some(0),
        shape: Shape::Polygon { outline: square(0.0, 3.0), holes },
        sides,
        file: None,
        place: None,
    };
    let model = Model {
        bands: ["r", "g", "b"].map(str::to_owned).to_vec(),
        materials: vec![Material {
            name: "red".to_owned(),
            reflectance: vec![1.0, 0.0, 0.0],
            emission: vec![0.0; 3],
        }],
        surfaces: vec![
            surface("frame, of wood", Sides::Open, vec![square(1.0, 2.0)]),
            surface("!sheet", Sides::Both, Vec::new()),
        ],
        ..Model::default()
    };
    let text = vs3::write::write(&model).expect("all is flat");
    let again = read(&text).expect("what is written is right");
    let (frame, sheets): (Vec<_>, Vec<_>) =
        surfaces_of(&again).into_iter().partition(|(name, ..)| name.starts_with("frame__of_wood#"));
    near(frame.iter().map(|(_, vector, _)| *vector).sum(), [0.0, 0.0, 8.0]);
    assert_eq!(again.notes[0].count, frame.len() - 1, "{text}");
    // 1 − 0.7874 of luminance.
    assert!(frame.iter().all(|(_, _, reflectance)| *reflectance == Some(0.2126)));
    let sheets: Vec<(&str, [f64; 3])> =
        sheets.iter().map(|(name, area, _)| (*name, area.to_array())).collect();
    assert_eq!(sheets, [("_sheet", [0.0, 0.0, 9.0]), ("_sheet:back", [0.0, 0.0, -9.0])]);
}

#[test]
fn curved_and_crossing_surfaces_are_not_written() {
    let mut model = read(include_str!("../../fixtures/cube.vs3")).expect("the cube is right");
    if let Shape::Polygon { outline, .. } = &mut model.surfaces[1].shape {
        outline.swap(1, 2);
    }
    let refusal = vs3::write::write(&model).expect_err("its outline crosses itself");
    assert!(
        refusal.cause.contains("\"ceiling\" crosses itself") && refusal.cure.contains("repair"),
        "{refusal}"
    );
    model.surfaces[0].shape = Shape::Sphere { center: DVec3::ZERO, radius: 1.0, inward: false };
    let refusal = vs3::write::write(&model).expect_err("a sphere is curved");
    assert!(
        refusal.cause.contains("\"floor\" is a sphere") && refusal.cure.contains("polygons"),
        "{refusal}"
    );
}

fn break_vs3(cases: u32) {
    for text in
        [&include_bytes!("../../fixtures/window.vs3")[..], include_bytes!("../../fixtures/l-room-3a.vs3")]
    {
        break_often(cases, text, &[], |bytes| {
            let found = vs3::read("broken", bytes, &Memory::default());
            assert_promised(&found);
            let Ok(model) = found else { return };
            if let Ok(text) = vs3::write::write(&model) {
                let again = vs3::read("again", text.as_bytes(), &Memory::default());
                assert!(again.is_ok_and(|again| again.surfaces.len() >= model.surfaces.len()), "{text}");
            }
        });
    }
}

#[test]
fn broken_view3d_inputs_are_read_or_refused() {
    break_vs3(256);
}

#[test]
#[ignore = "takes a minute"]
fn ten_thousand_broken_view3d_inputs_are_read_or_refused() {
    break_vs3(10_000);
}
