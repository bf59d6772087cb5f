//! OBJ written and read again.

use std::f64::consts::PI;

use glam::DVec3;
use proptest::prelude::*;
use radiosity_formats::format::Written;
use radiosity_formats::model::{Material, Model, Shape, Sides, Surface};
use radiosity_formats::obj::read;
use radiosity_formats::obj::write::write;
use radiosity_test_support::random::seeded;

use crate::measures::{assert_cube, names};
use crate::memory::Memory;
use crate::meshes::shapes::corner;

fn again(written: &Written) -> Model {
    let materials = written.materials.as_deref().unwrap_or_default();
    read("b.obj", written.text.as_bytes(), &Memory::of([("b.mtl", materials.as_bytes())])).unwrap()
}

fn polygon(name: &str, outline: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> Surface {
    let shape = Shape::Polygon { outline, holes };
    Surface { name: name.to_owned(), material: None, shape, sides: Sides::Open, file: None, place: None }
}

fn rectangle(low: [f64; 2], high: [f64; 2]) -> Vec<DVec3> {
    [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
        .map(|[x, y]| DVec3::new(x, y, 1.5))
        .to_vec()
}

/// Newell's area of an outline, in the direction of z.
fn area(outline: &[DVec3]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a.x * b.y - a.y * b.x).sum::<f64>()
}

/// Whether two sides of an outline cross, ends left out.
fn crosses_itself(outline: &[DVec3]) -> bool {
    let side = |k: usize| [outline[k], outline[(k + 1) % outline.len()]];
    let turn = |[a, b]: [DVec3; 2], c: DVec3| (b - a).truncate().perp_dot((c - a).truncate());
    let parts = |one: [DVec3; 2], other: [DVec3; 2]| turn(one, other[0]) * turn(one, other[1]) < -1e-18;
    let count = outline.len();
    (0..count).any(|i| (0..i).any(|j| parts(side(i), side(j)) && parts(side(j), side(i))))
}

#[test]
fn the_cube_and_its_materials_come_back() {
    let files = crate::meshes::obj::beside();
    let model = read("a.obj", crate::meshes::obj::text().as_bytes(), &files).unwrap();
    let written = write(&model, "b.mtl").unwrap();
    let back = again(&written);
    assert_cube(&back, DVec3::splat(0.5), true);
    assert_eq!(names(&back), names(&model));
    assert_eq!(back.materials[1].name, "lamp");
    assert_eq!(back.materials[0].name, "white_paint", "other programs end names at blanks");
    for (one, other) in model.materials.iter().zip(&back.materials) {
        assert_eq!(one.reflectance, other.reflectance);
        assert!(one.emission.iter().zip(&other.emission).all(|(a, b)| (a - b).abs() <= 1e-15 * a.abs()));
    }
    let shapes =
        |model: &Model| model.surfaces.iter().map(|x| (x.shape.clone(), x.material)).collect::<Vec<_>>();
    assert_eq!(shapes(&back), shapes(&model));
    assert_eq!(written.text.lines().filter(|line| line.starts_with("v ")).count(), 8);
}

#[test]
fn patches_bands_and_odd_names_come_back() {
    let mut warped = [0, 1, 3, 2].map(|number| DVec3::from_array(corner(number)));
    warped[2].z = 0.1 + 0.2;
    let surfaces = vec![
        Surface { material: Some(0), shape: Shape::Quad(warped), ..polygon("a # b\\\n", vec![], vec![]) },
        polygon("plain", rectangle([0.0, 0.0], [1.0 / 3.0, 1e-7]), vec![]),
    ];
    let grey = Material { name: "grey".to_owned(), reflectance: vec![0.3], emission: vec![2.0 * PI] };
    let model = Model { bands: vec!["grey".to_owned()], materials: vec![grey], surfaces, ..Model::default() };
    let written = write(&model, "b.mtl").unwrap();
    assert_eq!(written.materials.as_deref(), Some("newmtl grey\nKd 0.3 0.3 0.3\nKe 2.0 2.0 2.0\n"));
    let back = again(&written);
    assert_eq!(names(&back), ["plain", "a _ b/"]);
    assert_eq!((back.surfaces[0].material, back.surfaces[1].material), (None, Some(0)));
    assert_eq!(back.surfaces[0].shape, model.surfaces[1].shape);
    assert_eq!(back.surfaces[1].shape, model.surfaces[0].shape);
    assert!((back.materials[0].reflectance[0] - 0.3).abs() < 1e-15);
}

#[test]
fn curved_surfaces_and_other_bands_are_refused() {
    let sphere = Shape::Sphere { center: DVec3::ZERO, radius: 1.0, inward: false };
    let mut model = Model {
        surfaces: vec![Surface { shape: sphere, ..polygon("globe", vec![], vec![]) }],
        ..Model::default()
    };
    let refusal = write(&model, "b.mtl").unwrap_err();
    assert_eq!(refusal.cause, "the surface 'globe' is a sphere, which OBJ does not have");
    assert_eq!(refusal.cure, "write the model as toml, json or mgf");
    model.surfaces.clear();
    model.materials.push(Material {
        name: "m".to_owned(),
        reflectance: vec![0.1; 5],
        emission: vec![0.0; 5],
    });
    let refusal = write(&model, "b.mtl").unwrap_err();
    assert_eq!(refusal.cause, "the material 'm' has 5 bands; MTL has 1 or 3");
}

fn bridged(outline: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> Vec<DVec3> {
    let model = Model { surfaces: vec![polygon("a", outline, holes)], ..Model::default() };
    let back = again(&write(&model, "b.mtl").unwrap());
    match &back.surfaces[0].shape {
        Shape::Polygon { outline, .. } => outline.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn holes_are_joined_without_crossing() {
    // A comb around holes: what is nearest is often hidden.
    let mut outline = rectangle([0.0, 0.0], [8.0, 4.0]);
    outline.splice(2..2, [[7.0, 1.0], [7.5, 2.0], [6.5, 3.0]].map(|[x, y]| DVec3::new(x, y, 1.5)));
    let mut holes = vec![rectangle([1.0, 1.0], [2.0, 3.0]), rectangle([3.0, 0.5], [3.5, 3.5])];
    holes.push(rectangle([4.0, 1.9], [6.0, 2.1]));
    // Holes run in any direction.
    holes[1].reverse();
    let whole = area(&outline) - 2.0 - 1.5 - 0.4;
    let ring = bridged(outline, holes);
    assert_eq!(ring.len(), 7 + 3 * 6);
    assert!((area(&ring) - whole).abs() < 1e-12 && !crosses_itself(&ring));
}

proptest! {
    #![proptest_config(seeded(128, 7))]

    #[test]
    fn random_holes_are_joined_without_crossing(
        is_hole in prop::collection::vec(prop::bool::weighted(0.4), 25),
        sizes in prop::collection::vec([0.05..0.95f64, 0.05..0.95, 0.05..0.95, 0.05..0.95], 25),
        is_level: bool,
    ) {
        let outline = rectangle([0.0, 0.0], [5.0, 5.0]);
        let mut holes = Vec::new();
        let mut whole = 25.0;
        for (k, [a, b, c, d]) in sizes.iter().enumerate().filter(|(k, _)| is_hole[*k]) {
            let [x, y] = [(k % 5) as f64, (k / 5) as f64];
            // Diamonds, or rectangles of equal heights, whose corners rays meet.
            let hole = match is_level {
                true => rectangle([x + 0.25, y + 0.25], [x + 0.75, y + 0.75]),
                false => [[x + 0.01, y + a], [x + b, y + 0.01], [x + 0.99, y + c], [x + d, y + 0.99]]
                    .map(|[x, y]| DVec3::new(x, y, 1.5))
                    .to_vec(),
            };
            whole -= area(&hole);
            holes.push(hole);
        }
        let ring = bridged(outline, holes);
        prop_assert!((area(&ring) - whole).abs() < 1e-10);
        prop_assert!(!crosses_itself(&ring));
    }
}
