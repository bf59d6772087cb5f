//! Parts and their instances: names, places, arrays, parts within parts, and what is refused.

use radiosity::scene::{Scene, SceneError, Source};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;

/// A table of a top and two legs of one length, which is a part of its own.
const TABLE: &str = r#"materials.wood = { reflectance = 0.5 }
[[parts.leg.surfaces]]
name = "post"
material = "wood"
cylinder = { base = [0, 0, 0], axis = [0, 0, 1], radius = 0.1 }
[[parts.table.surfaces]]
name = "top"
material = "wood"
two_sided = true
parallelogram = { origin = [-1, -1, 1], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }
[[parts.table.surfaces]]
material = "wood"
disk = { center = [0, 0, 2], normal = [0, 0, -1], radius = 0.2 }
[[parts.table.instances]]
part = "leg"
name = "left"
transform = { translate = [-0.5, 0, 0], scale = 0.5 }
[[parts.table.instances]]
part = "leg"
transform = { translate = [0.5, 0, 0], scale = 0.5 }
"#;

fn read(rest: &str) -> Result<Scene, SceneError> {
    radiosity::language::read(&Source::new("room.toml", &format!("{TABLE}{rest}\n")))
}

fn scene(rest: &str) -> Scene {
    read(rest).unwrap_or_else(|error| panic!("{rest}: {error}"))
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.surfaces.iter().map(|surface| surface.name.as_str()).collect()
}

/// The middle of a surface's parameters, in the coordinates of the file.
fn middle(scene: &Scene, name: &str) -> DVec3 {
    scene.surfaces[scene.surface_named(name).unwrap()].shape.jet(0.0, 0.0).position + scene.middle
}

#[test]
fn instances_are_surfaces_with_names_and_places_of_their_own() {
    let scene = scene(
        "[[surfaces]]\nname = \"floor\"\nmaterial = \"wood\"\n\
         parallelogram = { origin = [-9,-9,-1], edge1 = [18,0,0], edge2 = [0,18,0] }\n\
         [[instances]]\npart = \"table\"\nname = \"desk\"\n\
         transform = { scale = 2, rotate = [0, 0, 1, 90], translate = [0, 0, 5] }\n\
         [[instances]]\npart = \"leg\"\n",
    );
    let desk = ["desk.top", "desk.top:back", "desk.surface-2", "desk.left.post", "desk.leg-2.post"];
    assert_eq!(names(&scene), [&["floor"][..], &desk, &["leg-2.post"]].concat());
    assert!(middle(&scene, "desk.top").distance(DVec3::new(0.0, 0.0, 7.0)) < 1e-12);
    // The leg is halved and put at x = −½ in the table, which is doubled, turned by a quarter and lifted by
    // 5.
    let leg = &scene.surfaces[scene.surface_named("desk.left.post").unwrap()].shape;
    let bounds = leg.bounds(&radiosity_geom::Rect::FULL);
    assert!((bounds.min - DVec3::new(-0.1, -1.1, 5.0)).abs().max_element() < 1e-3, "{bounds:?}");
    assert!((bounds.max - DVec3::new(0.1, -0.9, 6.0)).abs().max_element() < 1e-3, "{bounds:?}");
    let place = scene.surfaces[4].place.as_ref().expect("it was read");
    assert_eq!(place.line, 2, "a surface of a part stands where the part does");
}

#[test]
fn arrays_are_rows_in_up_to_three_directions() {
    let row = scene("[[instances]]\npart = \"leg\"\nname = \"a\"\narray = { count = 3, step = [1, 0, 0] }");
    assert_eq!(names(&row), ["a[0].post", "a[1].post", "a[2].post"]);
    let one = middle(&row, "a[0].post");
    assert!(middle(&row, "a[2].post").distance(one + 2.0 * DVec3::X) < 1e-12);
    // The steps are not turned or scaled.
    let block = scene(
        "[[instances]]\npart = \"leg\"\nname = \"a\"\ntransform = { scale = 0.5, rotate = [0, 0, 1, 90] }\n\
         array = { count = [2, 3, 2], step = [[1, 0, 0], [0.5, 2, 0], [0, 0, 3]] }",
    );
    assert_eq!(block.surfaces.len(), 12);
    assert_eq!(names(&block)[..3], ["a[0,0,0].post", "a[0,0,1].post", "a[0,1,0].post"]);
    let moved = middle(&block, "a[1,2,1].post") - middle(&block, "a[0,0,0].post");
    assert!(moved.distance(DVec3::new(2.0, 4.0, 3.0)) < 1e-12);
}

#[test]
fn json_says_the_same_and_variables_count_copies() {
    let text = TABLE.replacen(
        "[[parts",
        "variables = { n = 4 }\n[[instances]]\npart = \"leg\"\narray = { count = \"=n\", step = [\"=n\", 0, 0] }\n[[parts",
        1,
    );
    let json = serde_json::to_string(&toml::from_str::<toml::Value>(&text).unwrap()).unwrap();
    let [one, other] = [
        radiosity::language::read(&Source::new("room", &text)),
        radiosity::language::read(&Source::new("room", &json)),
    ]
    .map(Result::unwrap);
    assert_eq!(names(&one), names(&other));
    assert!(
        (middle(&one, "leg-1[3].post") - middle(&one, "leg-1[0].post")).distance(12.0 * DVec3::X) < 1e-12
    );
}

#[test]
fn every_instance_emits_the_flux() {
    let lamp = "[[parts.lamp.surfaces]]\nname = \"bulb\"\nmaterial = \"wood\"\nflux = 10\n\
                sphere = { center = [0, 0, 0], radius = 1 }\n\
                [[instances]]\npart = \"lamp\"\ntransform = { scale = 0.1 }\narray = { count = 3, step = [1, 0, 0] }\n";
    let scene = scene(lamp);
    for bulb in &scene.surfaces {
        assert!((bulb.exitance(0) * bulb.shape.area() - 10.0).abs() < 1e-12);
    }
    let banded = typed(&format!("{TABLE}{}", lamp.replace("= 10", "= [1, 2, 3]")));
    assert_eq!(banded.bands, ["r", "g", "b"], "lists in parts count as well");
}

#[test]
fn wrong_instances_are_refused_where_they_stand() {
    let leg = "[[instances]]\npart = \"leg\"\n";
    for (rest, message, cure) in [
        (
            "[[instances]]\npart = \"lag\"",
            "room.toml:22:8: unknown part \"lag\"",
            "did you mean \"leg\"? parts",
        ),
        (
            "[[instances]]\nname = \"a\"",
            "instance 1: the key \"part\" is missing",
            "the name of one of [parts.…]",
        ),
        (
            &format!("{leg}surfaces = 1"),
            "instance 1: unknown key \"surfaces\"",
            "part, name, transform, array",
        ),
        (
            "[parts.chair]\nlegs = 4",
            "part \"chair\": unknown key \"legs\"",
            "surfaces, luminaires, instances",
        ),
        (
            &format!("{leg}name = \"a\"\n{leg}name = \"a\""),
            "room.toml:26:8: the name \"a\" is given twice",
            "which stands on line 23",
        ),
        (
            &format!("{leg}array = {{ count = 2 }}"),
            "instance 1: the key \"step\" is missing",
            "one for each number",
        ),
        (
            &format!("{leg}array = {{ count = [2, 2], step = [[1, 0, 0]] }}"),
            "step takes as many vectors as count has numbers, 2, found 1",
            "give as many",
        ),
        (
            &format!("{leg}array = {{ count = [], step = [] }}"),
            "count takes 1 to 3 numbers, found 0",
            "give 1 to 3",
        ),
        (
            &format!("{leg}array = {{ count = 0, step = [1,0,0] }}"),
            "the number of copies is 0, outside",
            "count",
        ),
        (
            &format!("{leg}array = {{ count = 1.5, step = [1,0,0] }}"),
            "1.5 is not a whole number",
            "give 0, 1",
        ),
        (
            &format!("{leg}array = {{ count = 2, step = [0,0,0] }}"),
            "surface \"leg-1[1].post\": coincides with surface \"leg-1[0].post\"",
            "remove one",
        ),
        (&format!("{leg}transform = {{ scale = -1 }}"), "instance 1: `scale` is -1; it must be greater", ""),
        (
            "[[parts.a.instances]]\npart = \"b\"\n[[parts.b.instances]]\npart = \"a\"",
            "room.toml:24:8: the part contains itself: a → b → a",
            "take one of these",
        ),
        ("[[parts.a.instances]]\npart = \"a\"", "the part contains itself: a → a", "take one of these"),
        (
            &format!("{leg}array = {{ count = [1000, 1000], step = [[1,0,0],[0,1,0]] }}"),
            "room.toml:22:8: the instances make more than 1000000 surfaces",
            "make fewer copies",
        ),
    ] {
        let error = read(rest).expect_err(rest);
        assert!(error.to_string().contains(message), "{rest}: {error}");
        assert!(error.cure().unwrap_or_default().contains(cure), "{rest}: {:?}", error.cure());
    }
}

/// A chain of parts, each of which holds the next `copies` times; the last is the leg.
fn chain(length: usize, copies: usize) -> String {
    let part = |k: usize| {
        let next = if k + 1 == length { "leg".to_owned() } else { format!("p{}", k + 1) };
        format!(
            "[[parts.p{k}.instances]]\npart = \"{next}\"\narray = {{ count = {copies}, step = [0, 3, 0] }}\n"
        )
    };
    (0..length).map(part).collect::<String>() + "[[instances]]\npart = \"p0\"\n"
}

#[test]
fn parts_are_nested_to_a_depth_and_a_number() {
    assert_eq!(scene(&chain(31, 1)).surfaces.len(), 1);
    for length in [32, 33, 20_000] {
        let error = read(&chain(length, 1)).unwrap_err();
        assert!(error.to_string().contains("parts are nested more than 32 deep"), "{length}: {error}");
    }
    // 2³⁰ copies are counted, not made.
    let error = read(&chain(30, 2)).unwrap_err();
    assert!(error.to_string().contains("more than 1000000 surfaces"), "{error}");
}
