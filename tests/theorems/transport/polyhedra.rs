//! Random closed convex rooms, their faces turned inward.

use proptest::prelude::*;
use radiosity_geom::DVec3;

use crate::transport::flat::{Flat, Outline};

/// Tetrahedra, sheared boxes, prisms and hulls of a few points.
pub(crate) fn rooms() -> impl Strategy<Value = Vec<Flat>> {
    let scaled = (faces(), (-6.0..6.0f64).prop_map(|x| 10f64.powf(x)));
    scaled.prop_map(|(faces, scale)| inward(faces.iter().map(|face| face.map(|p| p * scale)).collect()))
}

fn faces() -> impl Strategy<Value = Vec<Outline>> {
    let unit = || -1.0..1.0f64;
    let point = move || (unit(), unit(), unit()).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    prop_oneof![
        prop::collection::vec(point(), 4..8).prop_filter_map("too flat", hull),
        (0.05..1.0f64, 0.05..1.0f64, unit(), unit(), unit()).prop_map(|(b, c, x, y, z)| {
            parallelepiped([DVec3::X, DVec3::new(x, 1.0, 0.0) * b, DVec3::new(y, z, 1.0) * c])
        }),
        (3..8usize, 0.1..3.0f64, 0.2..1.0f64, unit())
            .prop_map(|(sides, height, squeeze, lean)| prism(sides, height, squeeze, lean)),
    ]
}

fn parallelepiped(edges: [DVec3; 3]) -> Vec<Outline> {
    let faces = (0..3).flat_map(|k| [(k, DVec3::ZERO), (k, edges[k])]);
    faces
        .map(|(k, origin)| Outline::Parallelogram { origin, edges: [edges[(k + 1) % 3], edges[(k + 2) % 3]] })
        .collect()
}

/// An ellipse's regular polygon drawn up along a leaning axis.
fn prism(sides: usize, height: f64, squeeze: f64, lean: f64) -> Vec<Outline> {
    let corner = |k: usize| {
        let angle = std::f64::consts::TAU * (k % sides) as f64 / sides as f64;
        DVec3::new(angle.cos(), squeeze * angle.sin(), 0.0)
    };
    let base: Vec<DVec3> = (0..sides).map(corner).collect();
    let rise = DVec3::new(lean * height, 0.0, height);
    let lid = base.iter().map(|p| p + rise).collect();
    let caps = [base, lid].map(|outer| Outline::Polygon { outer, holes: Vec::new() });
    let wall = |k| Outline::Parallelogram { origin: corner(k), edges: [corner(k + 1) - corner(k), rise] };
    caps.into_iter().chain((0..sides).map(wall)).collect()
}

/// The triangles of the hull of points in general position; None where it is nearly flat or a face is a
/// sliver.
fn hull(points: Vec<DVec3>) -> Option<Vec<Outline>> {
    let n = points.len();
    let triples = (0..n).flat_map(|i| (0..i).flat_map(move |j| (0..j).map(move |k| [i, j, k])));
    let mut faces = Vec::new();
    for triple in triples {
        let [a, b, c] = triple.map(|i| points[i]);
        let normal = (b - a).cross(c - a);
        let heights = || {
            let others = (0..n).filter(|i| !triple.contains(i));
            others.map(|i| (points[i] - a).dot(normal) / normal.length())
        };
        let outside = heights().all(|h| h > 0.0) || heights().all(|h| h < 0.0);
        if outside && (normal.length() < 0.02 || heights().all(|h| h.abs() < 0.02)) {
            return None;
        }
        if outside {
            faces.push(Outline::Triangle([a, b, c]));
        }
    }
    (faces.len() > 3).then_some(faces)
}

fn inward(faces: Vec<Outline>) -> Vec<Flat> {
    let corners: Vec<DVec3> = faces.iter().flat_map(|face| face.loops().concat()).collect();
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let face = |outline: Outline| {
        let front = middle - outline.loops()[0][0];
        Flat::facing(outline, front)
    };
    faces.into_iter().map(face).collect()
}
