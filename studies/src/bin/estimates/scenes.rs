//! Scenes, and runs of them that are much finer.

use radiosity::scene::{Scene, Source};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity_test_support::walls::walls;

/// A scene, a fine run, and how its light is gathered.
pub(crate) struct Case {
    pub name: String,
    pub scene: Scene,
    pub fine: Fine,
    pub by_rays: bool,
    /// The least accuracy that is asked for.
    pub finest: f64,
}

/// A fine run.
#[derive(Clone, Copy)]
pub(crate) enum Fine {
    /// Exact blocks between so many elements each way of every surface.
    Exact { order: usize, cuts: usize },
    /// Rays between `cuts` elements each way of every surface, or as many as the rays support.
    Rays { rays: u64, cuts: Option<usize> },
}

const MATERIALS: &str = "bands = ['grey']
[materials.lit]
reflectance = 0.5
emission = 1
[materials.wall]
reflectance = 0.5
[materials.white]
reflectance = 0.8
[materials.dark]
reflectance = 0.2
[materials.lamp]
reflectance = 0
emission = 1
";

const RAYS: u64 = 40_000_000;

impl Case {
    /// A case of the list, or a scene file, which is held against many rays.
    pub(crate) fn named(name: &str) -> Self {
        usual().into_iter().chain(others()).find(|case| case.name == name).unwrap_or_else(|| {
            let scene = radiosity::load(name).expect("a scene of the list, or a file");
            Self::round(name, scene, None)
        })
    }

    /// The goal of this accuracy of light, read as the truth is.
    pub(crate) fn goal(&self, accuracy: f64) -> Goal {
        Goal::new(accuracy, Aim::Gathered).read_by(if self.by_rays {
            GatherMethod::Rays
        } else {
            GatherMethod::Cells
        })
    }

    fn flat(name: &str, scene: Scene, order: usize, cuts: usize) -> Self {
        Self { name: name.to_owned(), scene, fine: Fine::Exact { order, cuts }, by_rays: false, finest: 3e-4 }
    }

    fn round(name: &str, scene: Scene, cuts: Option<usize>) -> Self {
        Self {
            name: name.to_owned(),
            scene,
            fine: Fine::Rays { rays: RAYS, cuts },
            by_rays: true,
            finest: 3e-3,
        }
    }

    fn to(self, finest: f64) -> Self {
        Self { finest, ..self }
    }
}

/// Flat things: boxes, plates, things that hover or stand in rooms.
pub(crate) fn usual() -> Vec<Case> {
    let builtin = |name: &str| radiosity::builtin(name).expect("it is built in");
    vec![
        Case::flat("empty-box", builtin("empty-box"), 8, 3),
        Case::flat("long box", scene(&long_box()), 8, 3),
        Case::flat("dark box", scene(&dark_box()), 8, 3),
        Case::flat("flush lamp", scene(&flush_lamp()), 7, 3),
        Case::flat("plates", scene(&plates(1.0)), 8, 2),
        Case::flat("near plates", scene(&plates(0.1)), 8, 3),
        Case::flat("plates, a third between", scene(&shaded()), 4, 8),
        Case::flat("hinge-squares", builtin("hinge-squares"), 8, 3),
        Case::flat("occluder-box", builtin("occluder-box"), 4, 8).to(1e-3),
        Case::flat("two-boxes", builtin("two-boxes"), 4, 6).to(1e-2),
        Case::flat("cornell-box", builtin("cornell-box"), 4, 6).to(3e-3),
        Case::flat("gap under a box", scene(&gap()), 3, 9).to(1e-2),
    ]
}

/// Curved things, whose light is gathered by rays, which takes longer.
fn others() -> Vec<Case> {
    let builtin = |name: &str| radiosity::builtin(name).expect("it is built in");
    vec![
        Case::round("disks", scene(&disks()), Some(8)),
        Case::round("can", scene(&can()), Some(8)),
        Case::round("ball in a room", scene(&ball("[0.5, 0.5, 0.4]", 0.25)), Some(8)),
        Case::round("ball on the floor", scene(&ball("[0.5, 0.5, 0.25]", 0.25)), Some(8)),
        Case::round("ball near the floor", scene(&ball("[0.5, 0.5, 0.26]", 0.25)), Some(8)),
        Case::round("column", scene(&column()), Some(8)),
        Case::round("teapot", builtin("teapot"), Some(8)),
        Case::round("temple", builtin("temple"), None),
    ]
}

fn scene(text: &str) -> Scene {
    radiosity::language::read(&Source::new("case", &format!("{MATERIALS}{text}")))
        .expect("the scene is valid")
}

fn surface(material: &str, rest: &str) -> String {
    format!("[[surfaces]]\nmaterial = '{material}'\n{rest}\n")
}

/// A closed box whose walls are of these materials.
fn closed(size: [f64; 3], materials: [&str; 6]) -> String {
    walls(size).iter().zip(materials).map(|(wall, material)| surface(material, wall)).collect()
}

fn long_box() -> String {
    closed([4.0, 1.0, 0.7], ["wall", "wall", "lit", "wall", "white", "wall"])
}

fn dark_box() -> String {
    closed([1.0; 3], ["dark", "lit", "dark", "dark", "dark", "dark"])
}

/// The white unit cube with a lamp in its ceiling.
fn flush_lamp() -> String {
    let hole = "[0.25, 0.25, 1], [0.25, 0.75, 1], [0.75, 0.75, 1], [0.75, 0.25, 1]";
    let [floor, _, sides @ ..] = walls([1.0; 3]);
    let ceiling =
        format!("quad = {{ vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]], holes = [[{hole}]] }}");
    let lamp = format!("quad = {{ vertices = [{hole}] }}");
    let white = [floor, ceiling].into_iter().chain(sides).map(|wall| surface("white", &wall));
    white.collect::<String>() + &surface("lamp", &lamp)
}

/// Two unit squares face to face.
fn plates(distance: f64) -> String {
    let square =
        |z: f64| format!("parallelogram = {{ origin = [0, 0, {z}], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }}");
    surface("lit", &square(0.0)) + &surface("wall", &format!("flip = true\n{}", square(distance)))
}

fn shaded() -> String {
    let between = "two_sided = true
parallelogram = { origin = [0.3, 0.3, 0.5], edge1 = [0.4, 0, 0], edge2 = [0, 0.4, 0] }";
    plates(1.0) + &surface("wall", between)
}

/// A room with a box that hovers close over its floor.
fn gap() -> String {
    let lamp = "parallelogram = { origin = [0.3, 0.3, 0.999], edge1 = [0, 0.4, 0], edge2 = [0.4, 0, 0] }";
    let side = |origin: &str, a: &str, b: &str| {
        surface("wall", &format!("parallelogram = {{ origin = {origin}, edge1 = {a}, edge2 = {b} }}"))
    };
    let [x, y, z] = ["[0.4, 0, 0]", "[0, 0.4, 0]", "[0, 0, 0.3]"];
    let (low, high) = ("[0.2, 0.3, 0.05]", "[0.2, 0.3, 0.35]");
    closed([1.0; 3], ["white"; 6])
        + &surface("lamp", lamp)
        + &side(low, y, x)
        + &side(high, x, y)
        + &side(low, x, z)
        + &side("[0.2, 0.7, 0.05]", z, x)
        + &side(low, z, y)
        + &side("[0.6, 0.3, 0.05]", y, z)
}

fn disks() -> String {
    surface("lit", "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }")
        + &surface("wall", "disk = { center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }")
}

fn can() -> String {
    disks() + &surface("wall", "flip = true\ncylinder = { base = [0, 0, 0], axis = [0, 0, 1], radius = 1 }")
}

/// A room with a bright ceiling and a ball.
fn ball(center: &str, radius: f64) -> String {
    closed([1.0; 3], ["wall", "lit", "wall", "wall", "white", "wall"])
        + &surface("wall", &format!("sphere = {{ center = {center}, radius = {radius} }}"))
}

/// A room with a bright wall and a column from floor to ceiling.
fn column() -> String {
    closed([2.0, 2.0, 1.0], ["wall", "white", "lit", "wall", "wall", "white"])
        + &surface("wall", "cylinder = { base = [0.9, 1.1, 0], axis = [0, 0, 1], radius = 0.2 }")
}
