//! A model of another program → the tree of a scene.

use radiosity_formats::model::{Camera, Model, Shape, Sides, Surface};
use radiosity_geom::DVec3;
use radiosity_scene::{Notation, Tree};

/// A model in this language.
pub fn model_text(model: &Model, notation: Notation) -> String {
    notation.text(tree(model).top())
}

/// The tree of a model.
fn tree(model: &Model) -> Tree {
    let mut entries = Vec::new();
    entries.extend(model.title.as_ref().map(|title| ("title", Tree::text(title))));
    entries.push(("bands", Tree::list(model.bands.iter().map(Tree::text))));
    entries.extend(model.unit.as_ref().map(|unit| ("unit", Tree::text(unit))));
    entries.extend(model.camera.as_ref().map(|camera| ("camera", camera_tree(camera))));
    if !model.materials.is_empty() {
        entries.push(("materials", materials(model)));
    }
    entries.push(("surfaces", Tree::list(model.surfaces.iter().map(|own| surface(own, model)))));
    Tree::table(entries)
}

fn camera_tree(camera: &Camera) -> Tree {
    let mut entries = vec![
        ("eye", point(camera.eye)),
        ("target", point(camera.target)),
        ("up", point(camera.up)),
        ("fov", Tree::number(camera.fov)),
    ];
    if let Some([width, height]) = camera.size {
        entries.push(("width", Tree::number(f64::from(width))));
        entries.push(("height", Tree::number(f64::from(height))));
    }
    Tree::table(entries)
}

fn materials(model: &Model) -> Tree {
    let entries = model.materials.iter().map(|material| {
        let mut own = vec![("reflectance", per_band(&material.reflectance))];
        if material.emission.iter().any(|value| *value != 0.0) {
            own.push(("emission", per_band(&material.emission)));
        }
        (material.name.as_str(), Tree::table(own))
    });
    Tree::table(entries)
}

/// One number where all bands have the same.
fn per_band(values: &[f64]) -> Tree {
    match values.iter().all(|value| *value == values[0]) {
        true => Tree::number(values[0]),
        false => Tree::list(values.iter().map(|value| Tree::number(*value))),
    }
}

fn surface(surface: &Surface, model: &Model) -> Tree {
    let mut entries = vec![("name", Tree::text(&surface.name))];
    entries
        .extend(surface.material.map(|material| ("material", Tree::text(&model.materials[material].name))));
    let ShapeEntry { key, fields, flip } = shape(&surface.shape);
    if flip {
        entries.push(("flip", Tree::flag(true)));
    }
    if surface.sides == Sides::Both {
        entries.push(("two_sided", Tree::flag(true)));
    }
    entries.push((key, Tree::table(fields)));
    Tree::table(entries)
}

/// A shape in the table of its surface.
struct ShapeEntry {
    key: &'static str,
    fields: Vec<(&'static str, Tree)>,
    /// Whether the surface is to be flipped.
    flip: bool,
}

fn shape(shape: &Shape) -> ShapeEntry {
    let number = |value: &f64| Tree::number(*value);
    match shape {
        Shape::Polygon { outline, holes } => polygon(outline, holes),
        Shape::Quad(corners) => {
            ShapeEntry { key: "quad", fields: vec![("vertices", points(corners))], flip: false }
        }
        Shape::Disk { center, normal, radius, inner } => {
            let placed = [("center", point(*center)), ("normal", point(*normal)), ("radius", number(radius))];
            let hole = (*inner > 0.0).then(|| ("inner_radius", number(inner)));
            ShapeEntry { key: "disk", fields: placed.into_iter().chain(hole).collect(), flip: false }
        }
        Shape::Cylinder { base, axis, radius, inward } => {
            let fields = vec![("base", point(*base)), ("axis", point(*axis)), ("radius", number(radius))];
            ShapeEntry { key: "cylinder", fields, flip: *inward }
        }
        Shape::Cone { base, axis, radii: [first, second], inward } => {
            let radii = [("radius1", number(first)), ("radius2", number(second))];
            let ends = [("base", point(*base)), ("axis", point(*axis))];
            ShapeEntry { key: "cone", fields: ends.into_iter().chain(radii).collect(), flip: *inward }
        }
        Shape::Sphere { center, radius, inward } => {
            let fields = vec![("center", point(*center)), ("radius", number(radius))];
            ShapeEntry { key: "sphere", fields, flip: *inward }
        }
        Shape::Torus { center, axis, major, minor, inward } => {
            let radii = [("major", number(major)), ("minor", number(minor))];
            let placed = [("center", point(*center)), ("axis", point(*axis))];
            ShapeEntry { key: "torus", fields: placed.into_iter().chain(radii).collect(), flip: *inward }
        }
    }
}

/// A flat piece. Convex outlines of four corners are quads, whose parameters run along their sides.
fn polygon(outline: &[DVec3], holes: &[Vec<DVec3>]) -> ShapeEntry {
    let key = match outline {
        [_, _, _] if holes.is_empty() => "triangle",
        [a, b, c, d] if is_convex([*a, *b, *c, *d]) => "quad",
        _ => "polygon",
    };
    let holes = (!holes.is_empty()).then(|| ("holes", Tree::list(holes.iter().map(|hole| points(hole)))));
    ShapeEntry {
        key,
        fields: [("vertices", points(outline))].into_iter().chain(holes).collect(),
        flip: false,
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

/// Least area of the triangle at a corner, as a part of the outline's: others stay polygons. A corner that is
/// nearly straight makes a patch whose tangents nearly vanish there; with a larger value sound quads would
/// stay polygons.
const LEAST_TURN: f64 = 0.05;

fn points(points: &[DVec3]) -> Tree {
    Tree::points(points.to_vec())
}

fn point(point: DVec3) -> Tree {
    Tree::list(point.to_array().map(Tree::number))
}
