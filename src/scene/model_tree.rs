//! A model of another program → the tree of a scene.

use radiosity_formats::model::{Camera, Model, Shape, Sides, Surface};
use radiosity_geom::DVec3;

use crate::scene::{
    place::At,
    tree::{Node, Value},
};

/// The tree of a model.
pub(super) fn tree(model: &Model) -> Node {
    let mut entries = Vec::new();
    entries.extend(model.title.as_ref().map(|title| ("title", text(title))));
    entries.push(("bands", list(model.bands.iter().map(|band| text(band)))));
    entries.extend(model.unit.as_ref().map(|unit| ("unit", text(unit))));
    entries.extend(model.camera.as_ref().map(|camera| ("camera", camera_tree(camera))));
    if !model.materials.is_empty() {
        entries.push(("materials", materials(model)));
    }
    entries.push(("surfaces", list(model.surfaces.iter().map(|own| surface(own, model)))));
    table(entries)
}

fn camera_tree(camera: &Camera) -> Node {
    let mut entries = vec![
        ("eye", point(camera.eye)),
        ("target", point(camera.target)),
        ("up", point(camera.up)),
        ("fov", number(camera.fov)),
    ];
    if let Some([width, height]) = camera.size {
        entries.push(("width", number(f64::from(width))));
        entries.push(("height", number(f64::from(height))));
    }
    table(entries)
}

fn materials(model: &Model) -> Node {
    let entries = model.materials.iter().map(|material| {
        let mut own = vec![("reflectance", per_band(&material.reflectance))];
        if material.emission.iter().any(|value| *value != 0.0) {
            own.push(("emission", per_band(&material.emission)));
        }
        (material.name.as_str(), table(own))
    });
    table(entries.collect())
}

/// One number where all bands have the same.
fn per_band(values: &[f64]) -> Node {
    match values.iter().all(|value| *value == values[0]) {
        true => number(values[0]),
        false => list(values.iter().map(|value| number(*value))),
    }
}

fn surface(surface: &Surface, model: &Model) -> Node {
    let mut entries = vec![("name", text(&surface.name))];
    entries.extend(surface.material.map(|material| ("material", text(&model.materials[material].name))));
    let (key, shape, flip) = shape(&surface.shape);
    if flip {
        entries.push(("flip", truth(true)));
    }
    if surface.sides == Sides::Both {
        entries.push(("two_sided", truth(true)));
    }
    entries.push((key, shape));
    table(entries)
}

/// The key of a shape, its value, and whether it is to be flipped.
fn shape(shape: &Shape) -> (&'static str, Node, bool) {
    match shape {
        Shape::Polygon { outline, holes } => {
            let mut entries = vec![("vertices", points(outline))];
            if !holes.is_empty() {
                entries.push(("holes", list(holes.iter().map(|hole| points(hole)))));
            }
            (polygon_key(outline, holes), table(entries), false)
        }
        Shape::Quad(corners) => ("quad", table(vec![("vertices", points(corners))]), false),
        Shape::Disk { center, normal, radius, inner } => {
            let mut entries =
                vec![("center", point(*center)), ("normal", point(*normal)), ("radius", number(*radius))];
            if *inner > 0.0 {
                entries.push(("inner_radius", number(*inner)));
            }
            ("disk", table(entries), false)
        }
        Shape::Cylinder { base, axis, radius, inward } => {
            let entries = vec![("base", point(*base)), ("axis", point(*axis)), ("radius", number(*radius))];
            ("cylinder", table(entries), *inward)
        }
        Shape::Cone { base, axis, radii, inward } => {
            let radii = [("radius1", number(radii[0])), ("radius2", number(radii[1]))];
            let entries = [("base", point(*base)), ("axis", point(*axis))].into_iter().chain(radii);
            ("cone", table(entries.collect()), *inward)
        }
        Shape::Sphere { center, radius, inward } => {
            ("sphere", table(vec![("center", point(*center)), ("radius", number(*radius))]), *inward)
        }
        Shape::Torus { center, axis, major, minor, inward } => {
            let entries = vec![
                ("center", point(*center)),
                ("axis", point(*axis)),
                ("major", number(*major)),
                ("minor", number(*minor)),
            ];
            ("torus", table(entries), *inward)
        }
    }
}

/// Convex outlines of four corners are quads, whose parameters run along their sides.
fn polygon_key(outline: &[DVec3], holes: &[Vec<DVec3>]) -> &'static str {
    match outline {
        [_, _, _] if holes.is_empty() => "triangle",
        [a, b, c, d] if is_convex([*a, *b, *c, *d]) => "quad",
        _ => "polygon",
    }
}

/// Whether four corners turn one way at each of them, clearly.
fn is_convex(corners: [DVec3; 4]) -> bool {
    let turn = |k: usize| {
        let [before, at, after] = [corners[(k + 3) % 4], corners[k], corners[(k + 1) % 4]];
        (at - before).cross(after - at)
    };
    let normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    let least = LEAST_TURN * normal.length_squared();
    (0..4).all(|k| turn(k).dot(normal) > least)
}

/// Least area of the triangle at a corner, as a part of the outline's: others stay polygons. Chosen; not tuned.
const LEAST_TURN: f64 = 0.05;

fn table(entries: Vec<(&str, Node)>) -> Node {
    let entries = entries.into_iter().map(|(key, node)| (At::new(key.to_owned(), &(0..0)), node));
    bare(Value::Table(entries.collect()))
}

fn list(items: impl Iterator<Item = Node>) -> Node {
    bare(Value::List(items.collect()))
}

fn points(points: &[DVec3]) -> Node {
    list(points.iter().map(|own| point(*own)))
}

fn point(point: DVec3) -> Node {
    list(point.to_array().into_iter().map(number))
}

fn text(text: &str) -> Node {
    bare(Value::Text(text.to_owned()))
}

fn number(value: f64) -> Node {
    bare(Value::Number(value))
}

fn truth(value: bool) -> Node {
    bare(Value::Truth(value))
}

fn bare(value: Value) -> Node {
    At::new(value, &(0..0))
}
