//! Scenes made in code as trees: they are those of their texts, and what is wrong is told with the same
//! words.

use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use radiosity::geom::DVec3;
use radiosity::reading::files::solution_file::{SolutionFile, read};
use radiosity::scene::{FaultKind, Notation, Scene, SceneError, Source, Tree};
use radiosity::solve::Options;
use radiosity_test_support::scenes::EVERY_SHAPE;
use radiosity_test_support::scenes::parsed;
use radiosity_test_support::solved::{outcome_of, solved_of};
use serde_json::{Value, json};

/// A value of JSON as a tree; lists of points as such.
fn tree(value: &Value) -> Tree {
    match value {
        Value::Null => Tree::foreign("null"),
        Value::Bool(flag) => Tree::flag(*flag),
        Value::Number(number) => Tree::number(number.as_f64().unwrap()),
        Value::String(text) => Tree::text(text),
        Value::Array(items) => match points(items) {
            Some(points) => Tree::points(points),
            None => Tree::list(items.iter().map(tree)),
        },
        Value::Object(entries) => Tree::table(entries.iter().map(|(key, item)| (key, tree(item)))),
    }
}

fn points(items: &[Value]) -> Option<Vec<DVec3>> {
    let point = |item: &Value| match item.as_array()?.as_slice() {
        [x, y, z] => Some(DVec3::new(x.as_f64()?, y.as_f64()?, z.as_f64()?)),
        _ => None,
    };
    let points: Option<Vec<DVec3>> = items.iter().map(point).collect();
    points.filter(|points| !points.is_empty())
}

/// The built-in scenes and one of every shape, as values of JSON.
fn rooms() -> Vec<Value> {
    let built_in = radiosity::language::builtins()
        .iter()
        .map(|scene| scene.name)
        .map(|name| radiosity::language::source(name, &[]).unwrap().text().into_owned());
    let texts = built_in.chain([EVERY_SHAPE.to_owned()]);
    texts.map(|text| serde_json::to_value(toml::from_str::<toml::Value>(&text).unwrap()).unwrap()).collect()
}

/// The scene of a tree that messages call `room`.
fn read_tree(tree: Tree) -> Result<Scene, SceneError> {
    radiosity::language::read(&Source::of_tree("room", tree)?)
}

/// All that a scene holds, but where it stands in a text.
fn held(scene: &Scene) -> String {
    let mut scene = scene.clone();
    scene.source = None;
    scene.surfaces.iter_mut().for_each(|own| own.place = None);
    scene.luminaires.iter_mut().for_each(|own| own.place = None);
    if let Some(animation) = &mut scene.animation {
        animation.movers.iter_mut().for_each(|own| own.place = None);
    }
    format!("{scene:?}")
}

/// Many surfaces take long, and show nothing that few do not.
const SOLVED: usize = 50;

#[test]
fn a_tree_makes_the_scene_of_its_text_to_the_last_bit() {
    let mut solved = 0;
    for room in rooms() {
        let of_text = radiosity::language::read(&Source::new("room", &room.to_string())).unwrap();
        let of_tree = read_tree(tree(&room)).unwrap();
        assert_eq!(held(&of_tree), held(&of_text));
        if of_text.surfaces.len() <= SOLVED && of_text.emits() {
            let options = Options { order: 0, subdivide: Some(1), eps: 0.1, ..Options::default() };
            let bits = |scene: &Scene| -> Vec<u64> {
                let solution = outcome_of(scene, &options).solution;
                (0..scene.surfaces.len()).map(|own| solution.mean_irradiance(0, own).to_bits()).collect()
            };
            assert_eq!(bits(&of_tree), bits(&of_text));
            solved += 1;
        }
    }
    assert!(solved >= 5, "only {solved} were solved");
}

#[test]
fn the_text_of_a_tree_makes_the_same_scene() {
    for room in rooms() {
        let scene = read_tree(tree(&room)).unwrap();
        for notation in [Notation::Json, Notation::Toml] {
            let text = radiosity::language::text(&scene, notation).unwrap();
            assert_eq!(held(&parsed(&Source::new("room", &text))), held(&scene));
        }
    }
}

#[test]
fn a_solution_of_a_tree_is_read_back() {
    let source = Source::of_tree("desk.csv", tree(&desk())).unwrap().set([("width", 3.0)]);
    let solved = solved_of(parsed(&source), Options::default());
    let text = serde_json::to_string(&SolutionFile::new(&solved)).unwrap();
    let again = read(&Source::new("a.json", &text)).unwrap();
    assert_eq!(held(&again.scene), held(&solved.scene));
    assert!((again.scene.surfaces[0].shape.area() - 3.0).abs() < 1e-12);
    assert_eq!(serde_json::to_string(&SolutionFile::new(&again)).unwrap(), text);
}

/// A scene with a value of most kinds.
fn desk() -> Value {
    json!({
        "bands": ["lm"],
        "variables": {"width": 2},
        "camera": {"eye": [1, 1, 1], "target": [0, 0, 0]},
        "materials": {"wood": {"reflectance": 0.4}, "glow": {"reflectance": 0, "emission": [100]}},
        "planes": {"the desk": {"origin": [0, 0, 1], "edges": [[1, 0, 0], [0, 1, 0]], "spacing": 0.5}},
        "parts": {"chair": {"surfaces": [
            {"name": "seat", "material": "wood", "disk": {"center": [0, 0, 0.4], "normal": [0, 0, 1], "radius": 0.2}}
        ]}},
        "surfaces": [
            {"name": "desk", "material": "wood",
             "parallelogram": {"origin": [0, 0, 0], "edge1": ["=width", 0, 0], "edge2": [0, 1, 0]}},
            {"name": "shelf", "material": "wood", "polygon": {
                "vertices": [[0, 0, 1], [4, 0, 1], [4, 4, 1], [0, 4, 1]],
                "holes": [[[1, 1, 1], [1, 2, 1], [2, 2, 1]]]}},
            {"material": "glow", "triangle": {"vertices": [[0, 0, 2], [0, 1, 2], [1, 0, 2]]}}
        ],
        "instances": [{"part": "chair", "name": "mine", "transform": {"translate": [0, 0, 5]}}],
        "frames": 3,
        "motion": [{"name": "lift", "surfaces": ["shelf"], "translate": {"points": [[0, 0, 0], [0, 0, 0.1]]}}]
    })
}

#[test]
fn faults_are_found_by_names() {
    let told = |pointer: &str, value: Value| {
        let mut room = desk();
        *room.pointer_mut(pointer).unwrap() = value;
        read_tree(tree(&room)).unwrap_err().to_string()
    };
    for (pointer, value, expected) in [
        ("/bands/0", json!(1), "bands[0]: expected a text in quotes, found a number"),
        ("/variables/width", json!("=3 / 0"), "variable \"width\": the formula"),
        ("/camera/eye/2", json!(null), "camera, eye[2]: expected a number, found null"),
        ("/materials/wood/reflectance", json!(1.5), "material \"wood\", reflectance: the reflectance is 1.5"),
        (
            "/materials/glow/emission/0",
            json!([1]),
            "material \"glow\", emission[0]: expected a number, found a list",
        ),
        ("/planes/the desk/spacing", json!(true), "plane \"the desk\", spacing: expected"),
        (
            "/planes/the desk/edges/1",
            json!([0, 1]),
            "plane \"the desk\", edges[1]: a point takes 3 numbers, found 2",
        ),
        (
            "/parts/chair/surfaces/0/disk/radius",
            json!("a"),
            "surface \"seat\", disk.radius: expected a number",
        ),
        ("/parts/chair/surfaces/0/disk/radius", json!(-1), "surface \"mine.seat\", disk.radius: "),
        ("/parts/chair/surfaces", json!(7), "part \"chair\", surfaces: expected a list, found a number"),
        ("/surfaces/0/material", json!("stone"), "surface \"desk\", material: unknown material \"stone\""),
        (
            "/surfaces/0/parallelogram/edge1/0",
            json!("=depth"),
            "surface \"desk\", parallelogram.edge1[0]: there is no",
        ),
        (
            "/surfaces/1/polygon/vertices/2/1",
            json!(1e31),
            "surface \"shelf\", polygon.vertices[2][1]: the number is 1e31",
        ),
        ("/surfaces/1/polygon/vertices/2", json!([4, 4, 3]), "surface \"shelf\", polygon.vertices"),
        (
            "/surfaces/1/polygon/vertices",
            json!([[0, 0, 1], [1, 0, 1]]),
            "surface \"shelf\", polygon.vertices: ",
        ),
        ("/surfaces/1/polygon/holes/0", json!([[1, 1, 1]]), "surface \"shelf\", polygon.holes[0]: "),
        (
            "/surfaces/2",
            json!({"name": "desk", "sphere": {"center": [9, 9, 9], "radius": 1}}),
            "surfaces[2].name: the name \"desk\" is given twice",
        ),
        (
            "/surfaces/2/triangle",
            json!({"corners": []}),
            "surface \"surface-3\", triangle: unknown key \"corners\"",
        ),
        (
            "/surfaces/2/triangle/vertices",
            json!([[0, 0, 2]]),
            "surface \"surface-3\", triangle.vertices: a triangle takes 3",
        ),
        ("/surfaces/2", json!(["a"]), "surface \"surface-3\": expected a table, found a list"),
        ("/instances/0/part", json!("stool"), "instances[0].part: unknown part \"stool\""),
        ("/instances/0/transform/translate", json!(1), "instance 1, transform.translate: expected a list"),
        ("/frames", json!(0.5), "frames: 0.5 is not a whole number"),
        ("/motion/0/surfaces/0", json!("lamp"), "motion \"lift\", surfaces[0]: unknown surface \"lamp\""),
        (
            "/motion/0/translate/points/1",
            json!([0, 1]),
            "motion \"lift\", translate.points[1]: a point takes",
        ),
    ] {
        let message = told(pointer, value);
        assert!(message.starts_with(&format!("room: {expected}")), "{message}\ninstead of {expected}");
    }
    assert!(read_tree(tree(&desk())).is_ok());
}

#[test]
fn points_are_read_as_lists_of_lists() {
    let outline = vec![DVec3::ZERO, DVec3::X, DVec3::new(1.0, f64::NAN, 0.0)];
    let surface = |key, value| Tree::table([("name", Tree::text("a")), (key, value)]);
    let room = |surface| Tree::table([("surfaces", Tree::list([surface]))]);
    let told = |surface| read_tree(room(surface)).unwrap_err().to_string();
    let polygon = Tree::table([("vertices", Tree::points(outline.clone()))]);
    let expected = "room: surface \"a\", polygon.vertices[2][1]: NaN is not a finite number";
    assert_eq!(told(surface("polygon", polygon)), expected);
    let expected = "room: surface \"a\", group: expected a text in quotes, found a list";
    assert_eq!(told(surface("group", Tree::points(outline))), expected);
    let twice = Tree::table([("radius", Tree::number(1.0)), ("radius", Tree::number(2.0))]);
    let expected = "room: surfaces[0].disk: the key \"radius\" stands twice";
    assert_eq!(told(surface("disk", twice)), expected);
    let deep = (0..100).fold(Tree::number(1.0), |inner, _| Tree::list([inner]));
    let fault = read_tree(deep).unwrap_err().fault;
    assert!(
        fault.kind == FaultKind::TooMany && fault.to_string().contains("are nested more than"),
        "{fault}"
    );
}

/// Values that are put in place of another one.
const EXTREMES: [&str; 18] = [
    "0", "-0.0", "1", "-1", "0.5", "360", "1e-15", "1e15", "1e30", "-1e31", "1e-300", "\"1\"", "\"=1/0\"",
    "\"\"", "[]", "{}", "null", "true",
];

/// A change of the value at a place, which a number in [0, 1) chooses.
#[derive(Clone, Debug)]
enum Damage {
    Set(f64, usize),
    /// Puts another value of the tree in its place.
    Copy(f64, f64),
    Drop(f64),
    /// Repeats an item, or renames a key.
    Repeat(f64),
}

fn damage() -> impl Strategy<Value = Damage> {
    let at = || 0.0..1.0;
    prop_oneof![
        3 => (at(), 0..EXTREMES.len()).prop_map(|(at, k)| Damage::Set(at, k)),
        2 => (at(), at()).prop_map(|(at, from)| Damage::Copy(at, from)),
        1 => at().prop_map(Damage::Drop),
        1 => at().prop_map(Damage::Repeat),
    ]
}

/// The pointers to all values within `value`.
fn pointers(value: &Value, at: &str, found: &mut Vec<String>) {
    let inner: Vec<(String, &Value)> = match value {
        Value::Array(items) => items.iter().enumerate().map(|(k, item)| (k.to_string(), item)).collect(),
        Value::Object(entries) => entries.iter().map(|(key, item)| (key.clone(), item)).collect(),
        _ => Vec::new(),
    };
    for (key, item) in inner {
        let own = format!("{at}/{key}");
        found.push(own.clone());
        pointers(item, &own, found);
    }
}

fn damaged(mut room: Value, damage: &Damage) -> Value {
    let mut all = Vec::new();
    pointers(&room, "", &mut all);
    let chosen = |at: f64| all.get((at * all.len() as f64) as usize).cloned().unwrap_or_default();
    let (Damage::Set(at, _) | Damage::Copy(at, _) | Damage::Drop(at) | Damage::Repeat(at)) = *damage;
    let (pointer, other) =
        (chosen(at), if let Damage::Copy(_, from) = damage { chosen(*from) } else { String::new() });
    let Some((parent, key)) = pointer.rsplit_once('/') else { return room };
    let new = match damage {
        Damage::Set(_, k) => Some(serde_json::from_str(EXTREMES[*k]).unwrap()),
        Damage::Copy(..) => room.pointer(&other).cloned(),
        Damage::Drop(_) | Damage::Repeat(_) => None,
    };
    let repeats = matches!(damage, Damage::Repeat(_));
    match (room.pointer_mut(parent), new) {
        (Some(Value::Array(items)), None) => {
            let item = items.remove(key.parse().unwrap());
            items.extend(std::iter::repeat_n(item, if repeats { 2 } else { 0 }));
        }
        (Some(Value::Object(entries)), None) => {
            let item = entries.remove(key).unwrap();
            entries.extend(repeats.then(|| (format!("{key}s"), item)));
        }
        (_, Some(new)) => *room.pointer_mut(&pointer).unwrap() = new,
        _ => {}
    }
    room
}

/// A message without the place, and the cure as far as it names no line.
fn words(error: &SceneError) -> (String, Option<String>) {
    let names_line = error.fault.kind == FaultKind::DuplicateName;
    (error.fault.to_string(), error.cure().filter(|_| !names_line))
}

/// Whether the part that a tree's error names is that of the text's error, or in it.
fn is_within(tree: Option<&str>, text: Option<&str>) -> bool {
    text.is_none_or(|text| tree.is_some_and(|tree| tree == text || tree.starts_with(&format!("{text}, "))))
}

/// Damages rooms `cases` times.
fn run(cases: u32) {
    let rooms: Vec<Value> =
        rooms().into_iter().chain([desk()]).filter(|room| room.to_string().len() < 20_000).collect();
    let refused = Cell::new(0);
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new(config)
        .run(&(0..rooms.len(), prop::collection::vec(damage(), 1..3)), |(k, damages)| {
            let room = damages.iter().fold(rooms[k].clone(), damaged);
            let texts = radiosity::language::read(&Source::new("room.json", &room.to_string()));
            match (
                texts,
                Source::of_tree("room.json", tree(&room))
                    .and_then(|source| radiosity::language::read(&source)),
            ) {
                (Ok(of_text), Ok(of_tree)) => prop_assert_eq!(held(&of_text), held(&of_tree)),
                (Err(of_text), Err(of_tree)) => {
                    refused.set(refused.get() + 1);
                    prop_assert_eq!(words(&of_text), words(&of_tree));
                    prop_assert!(of_tree.place.is_none());
                    prop_assert!(
                        is_within(of_tree.owner.as_deref(), of_text.owner.as_deref()),
                        "{} {}",
                        of_text,
                        of_tree
                    );
                }
                (of_text, of_tree) => prop_assert!(false, "{:?} {:?}", of_text.err(), of_tree.err()),
            }
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert!((cases / 5..cases).contains(&refused.get()), "{} of {cases} were refused", refused.get());
}

#[test]
fn what_is_wrong_is_told_with_the_words_of_texts() {
    run(400);
}

#[test]
#[ignore = "takes minutes: a hundred times as many trees"]
fn whatever_is_wrong_is_told_with_the_words_of_texts() {
    run(50_000);
}
