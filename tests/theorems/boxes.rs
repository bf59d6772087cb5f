//! The shape `box`: six rectangles whose fronts face out, or into a room; faces that are left out; refused
//! ones.

use radiosity::scene::{Scene, SceneError, Source};
use radiosity::visibility::inspection::{Fronts, Inspection};
use radiosity_geom::DVec3;

fn read(surface: &str) -> Result<Scene, SceneError> {
    let text =
        format!("materials.grey = {{ reflectance = 0.5 }}\n[[surfaces]]\nmaterial = \"grey\"\n{surface}\n");
    radiosity::language::read(&Source::new("box.toml", &text))
}

fn scene(surface: &str) -> Scene {
    read(surface).unwrap_or_else(|error| panic!("{surface}: {error}"))
}

/// Name, area and front of each surface.
fn faces(scene: &Scene) -> Vec<(&str, f64, DVec3)> {
    let face = |own: &radiosity::scene::SceneSurface| (own.shape.area(), own.shape.jet(0.0, 0.0).normal);
    let named = scene.surfaces.iter().map(|own| (own.name.as_str(), face(own)));
    named.map(|(name, (area, front))| (name, area, front)).collect()
}

#[test]
fn a_box_is_six_rectangles_with_fronts_outside() {
    for shape in [
        "name = \"crate\"\nbox = { origin = [1, 2, 3], size = [2, 3, 5] }",
        "name = \"crate\"\nbox = { corners = [[3, 2, 8], [1, 5, 3]] }",
    ] {
        let scene = scene(shape);
        let expected = [
            ("crate-left", 15.0, -DVec3::X),
            ("crate-right", 15.0, DVec3::X),
            ("crate-front", 10.0, -DVec3::Y),
            ("crate-back", 10.0, DVec3::Y),
            ("crate-bottom", 6.0, -DVec3::Z),
            ("crate-top", 6.0, DVec3::Z),
        ];
        assert_eq!(faces(&scene), expected);
        assert!(scene.surfaces.iter().all(|surface| surface.kind == "box"));
        let shells = Inspection::of(&scene).shells;
        assert_eq!((shells.len(), shells[0].fronts), (1, Fronts::Outside));
        assert!((shells[0].volume - 30.0).abs() < 1e-12);
    }
}

#[test]
fn the_fronts_of_a_room_face_inward() {
    for room in [
        "box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }",
        "box = { origin = [0, 0, 0], size = [1, 1, 1] }\nflip = true",
        "box = { origin = [0, 0, 0], size = [0.1, 0.1, 0.1], inward = true }\n\
         transform = { scale = 10, rotate = [1, 2, 3, 40], translate = [1e3, 0, 7] }",
    ] {
        let shells = Inspection::of(&scene(room)).shells;
        assert_eq!((shells.len(), shells[0].fronts), (1, Fronts::Inside), "{room}");
        assert!((shells[0].volume - 1.0).abs() < 1e-9, "{room}");
    }
}

#[test]
fn seen_from_the_front_u_runs_right_and_v_up() {
    for inward in [false, true] {
        let scene = scene(&format!("box = {{ origin = [0, 0, 0], size = [2, 3, 5], inward = {inward} }}"));
        for surface in &scene.surfaces {
            let at = |u, v| surface.shape.jet(u, v).position;
            let (along_u, along_v) = (at(1.0, 0.0) - at(-1.0, 0.0), at(0.0, 1.0) - at(0.0, -1.0));
            let normal = surface.shape.jet(0.0, 0.0).normal;
            let up = if normal.z == 0.0 { DVec3::Z } else { DVec3::Y };
            assert!(along_v.normalize().dot(up) > 1.0 - 1e-15, "{}", surface.name);
            assert!(along_u.normalize().dot(up.cross(normal)) > 1.0 - 1e-15, "{}", surface.name);
        }
    }
}

#[test]
fn open_faces_are_left_out() {
    let scene =
        scene("name = \"bin\"\nbox = { origin = [0, 0, 0], size = [1, 1, 2], open = [\"top\", \"left\"] }");
    let names: Vec<&str> = faces(&scene).iter().map(|(name, ..)| *name).collect();
    assert_eq!(names, ["bin-right", "bin-front", "bin-back", "bin-bottom"]);
}

#[test]
fn boxes_that_cannot_be_are_refused_where_they_stand() {
    for (shape, message, cure) in [
        ("origin = [0,0,0]", "4:7: surface \"surface-1\": the key \"size\" is missing", "two corners"),
        (
            "origin = [0,0,0], size = [1,0,1]",
            "4:34: surface \"surface-1\": `size` is 0; it must be greater",
            "",
        ),
        ("origin = [0,0,0], size = [1,1,-2]", "`size` is -2; it must be greater than zero", ""),
        (
            "origin = [0,0,0], size = 1",
            "4:34: surface \"surface-1\": expected a list, found a number",
            "brackets",
        ),
        ("corners = [[0,0,0],[1,1,0]]", "`corners` spans no area", ""),
        ("corners = [[0,0,0],[1e-300,1,1]]", "`corners` spans no area", ""),
        (
            "corners = [[0,0,0],[1,1,1]], size = [1,1,1]",
            "4:45: surface \"surface-1\": \"corners\" and \"size\" are both given",
            "leave one of them out",
        ),
        (
            "corners = [[0,0,0],[1,1,1]], open = [\"topp\"]",
            "4:46: surface \"surface-1\": a box has no face \"topp\"",
            "did you mean \"top\"? faces of a box: left, right, front, back, bottom, top",
        ),
        (
            "corners = [[0,0,0],[1,1,1]], open = [\"left\", \"right\", \"front\", \"back\", \"bottom\", \"top\"]",
            "a box takes at least one face that is not open, found 0",
            "give at least one",
        ),
    ] {
        let error = read(&format!("box = {{ {shape} }}")).expect_err(shape);
        assert!(error.to_string().contains(message), "{shape}: {error}");
        let told = error.cure().unwrap_or_default();
        assert!(told.contains(cure), "{shape}: {told}");
    }
}
