//! Two rooms as published, where they are at hand: `shared/scenes/mgf`.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use glam::DVec3;
use radiosity_formats::colour::to_grey;
use radiosity_formats::mgf;
use radiosity_formats::model::{Model, Shape};
use radiosity_photometry::files::{Folder, Reach};
use serde_json::Value;

use crate::measures::{area, vector};

/// The folder of the rooms; none, and a line that says so, where it is missing.
fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/scenes/mgf");
    if !folder.exists() {
        let _ = writeln!(std::io::stdout(), "skipped: {} is missing", folder.display());
        return None;
    }
    Some(folder)
}

fn room(folder: &Path, name: &str) -> Model {
    let path = folder.join(format!("{name}.mgf"));
    let bytes = fs::read(&path).expect("the room can be read");
    let model = mgf::read(name, &bytes, &Folder::of_scene(&path, Reach::Inside));
    let mut model = model.unwrap_or_else(|refusal| panic!("{refusal}"));
    to_grey(&mut model);
    model
}

/// Reflectance and exitance, to six digits; a reflectance of 1 as prepared scenes have it.
fn key(reflectance: f64, emission: f64) -> (i64, i64) {
    let reflectance = if reflectance > 0.99 { 0.99 } else { reflectance };
    ((1e6 * reflectance).round() as i64, (1e3 * emission).round() as i64)
}

fn keyed(model: &Model, index: usize) -> (i64, i64) {
    let material = &model.materials[model.surfaces[index].material.expect("MGF has materials")];
    key(material.reflectance[0], material.emission[0])
}

fn point(value: &Value) -> DVec3 {
    let number = |k: usize| value[k].as_f64().expect("a number");
    DVec3::new(number(0), number(1), number(2))
}

fn points(value: &Value) -> Vec<DVec3> {
    value.as_array().expect("a list").iter().map(point).collect()
}

/// The shape of a surface of a prepared scene.
fn prepared(surface: &Value) -> Shape {
    let number = |kind: &str, field: &str| surface[kind][field].as_f64().expect("a number");
    let vector = |kind: &str, field: &str| point(&surface[kind][field]);
    let kind = |kind: &str| !surface[kind].is_null();
    if kind("cylinder") {
        let [base, axis] = ["base", "axis"].map(|field| vector("cylinder", field));
        Shape::Cylinder { base, axis, radius: number("cylinder", "radius"), inward: false }
    } else if kind("cone") {
        let [base, axis] = ["base", "axis"].map(|field| vector("cone", field));
        Shape::Cone {
            base,
            axis,
            radii: ["radius1", "radius2"].map(|field| number("cone", field)),
            inward: false,
        }
    } else if kind("sphere") {
        Shape::Sphere {
            center: vector("sphere", "center"),
            radius: number("sphere", "radius"),
            inward: false,
        }
    } else if kind("disk") {
        let inner =
            surface["disk"]["inner_radius"].as_f64().or(surface["disk"]["inner"].as_f64()).unwrap_or(0.0);
        let [center, normal] = ["center", "normal"].map(|field| vector("disk", field));
        Shape::Disk { center, normal, radius: number("disk", "radius"), inner }
    } else {
        let part = if kind("polygon") { &surface["polygon"] } else { &surface["triangle"] };
        let holes = part["holes"].as_array().map_or(Vec::new(), |holes| holes.iter().map(points).collect());
        Shape::Polygon { outline: points(&part["vertices"]), holes }
    }
}

/// A piece of a prepared scene: its material's key and its area.
type Piece = ((i64, i64), f64);

/// The pieces of a prepared scene by the numbers in their names.
fn pieces(folder: &Path, name: &str) -> BTreeMap<usize, Piece> {
    let text = fs::read_to_string(folder.join(format!("{name}.json"))).expect("the scene can be read");
    let scene: Value = serde_json::from_str(&text).expect("the scene is right");
    let piece = |surface: &Value| {
        let word = |field: &str| surface[field].as_str().expect("a word").to_owned();
        let number = word("name").rsplit('-').next().and_then(|number| number.parse().ok());
        let value = |field: &str| scene["materials"][word("material")][field].as_f64().expect("a number");
        let key = key(value("reflectance"), value("emission"));
        (number.expect("names end with numbers"), (key, area(&prepared(surface))))
    };
    scene["surfaces"].as_array().expect("a list").iter().map(piece).collect()
}

/// Into how many pieces the prepared scenes cut a surface: quads into triangles, outlines that touch
/// themselves too.
fn count_of_pieces(shape: &Shape) -> usize {
    match shape {
        Shape::Quad(_) => 2,
        Shape::Polygon { outline, .. } if touches_itself(outline) => outline.len() - 2,
        _ => 1,
    }
}

/// Whether an outline comes to a point twice.
fn touches_itself(outline: &[DVec3]) -> bool {
    (0..outline.len()).any(|k| outline[..k].contains(&outline[k]))
}

/// Normal, a point and the corners of the surrounding box of a flat shape.
fn plane(shape: &Shape) -> Option<(DVec3, DVec3, [DVec3; 2])> {
    match shape {
        Shape::Polygon { outline, .. } => {
            let corners = [
                outline.iter().copied().reduce(DVec3::min).expect("points"),
                outline.iter().copied().reduce(DVec3::max).expect("points"),
            ];
            Some((vector(outline).normalize(), outline[0], corners))
        }
        Shape::Disk { center, normal, radius, .. } => {
            Some((normal.normalize(), *center, [*center - *radius, *center + *radius]))
        }
        _ => None,
    }
}

/// Whether two shapes lie in one plane, at one place of it.
fn are_coincident(one: &Shape, other: &Shape) -> bool {
    let (Some((normal, at, [low, high])), Some((other_normal, other_at, [other_low, other_high]))) =
        (plane(one), plane(other))
    else {
        return false;
    };
    let overlap = high.min(other_high) - low.max(other_low);
    normal.cross(other_normal).length() < 1e-6
        && (other_at - at).dot(normal).abs() < 1e-6
        && overlap.min_element() > -1e-9
        && overlap.to_array().iter().filter(|length| **length > 1e-6).count() >= 2
}

/// Every surface of the room is in the prepared scene with its material and its area, but for the coincident
/// ones.
fn assert_prepared(folder: &Path, name: &str, coincident: usize) {
    let model = room(folder, name);
    let pieces = pieces(folder, name);
    let (mut number, mut missing, mut told) = (1, 0, 0);
    for (index, surface) in model.surfaces.iter().enumerate() {
        let next = number + count_of_pieces(&surface.shape);
        let own: Vec<Piece> = pieces.range(number..next).map(|(_, piece)| *piece).collect();
        number = next;
        told += own.len();
        if own.is_empty() {
            missing += 1;
            let is_partner =
                |other: usize| other != index && are_coincident(&surface.shape, &model.surfaces[other].shape);
            assert!((0..model.surfaces.len()).any(is_partner), "{name}: {surface:?}");
            continue;
        }
        let total: f64 = own.iter().map(|(_, area)| area).sum();
        let both = match surface.shape {
            // The prepared scene cuts along one of two diagonals.
            Shape::Quad([a, b, c, d]) => {
                [Shape::Quad([a, b, c, d]), Shape::Quad([b, c, d, a])].map(|quad| area(&quad))
            }
            ref shape => [area(shape); 2],
        };
        assert!(both.iter().any(|own| (own - total).abs() < 1e-9 * own), "{name}: {surface:?}, {total}");
        assert!(own.iter().all(|(key, _)| *key == keyed(&model, index)), "{name}: {surface:?}");
    }
    assert_eq!((missing, told), (coincident, pieces.len()), "{name}");
}

fn count(model: &Model, is_kind: impl Fn(&Shape) -> bool) -> usize {
    model.surfaces.iter().filter(|surface| is_kind(&surface.shape)).count()
}

#[test]
fn the_soda_shop_reads_as_it_was_prepared() {
    let Some(folder) = folder() else { return };
    let model = room(&folder, "soda");
    let counts = [
        count(&model, |shape| matches!(shape, Shape::Polygon { .. })),
        count(&model, |shape| matches!(shape, Shape::Cylinder { .. })),
        count(&model, |shape| matches!(shape, Shape::Cone { .. })),
        count(&model, |shape| matches!(shape, Shape::Sphere { .. })),
        count(&model, |shape| matches!(shape, Shape::Disk { .. })),
    ];
    assert_eq!(counts, [331, 575, 461, 274, 70]);
    assert_prepared(&folder, "soda", 45);
}

#[test]
fn the_classroom_reads_as_it_was_prepared() {
    let Some(folder) = folder() else { return };
    let model = room(&folder, "classroom");
    assert_eq!(model.surfaces.len(), 5250);
    assert_eq!(count(&model, |shape| matches!(shape, Shape::Polygon { .. } | Shape::Quad(_))), 5250);
    assert_prepared(&folder, "classroom", 39);
}
