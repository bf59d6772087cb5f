//! Dented balls, seen from within: spheres of triangles from an icosahedron, each corner of which is moved
//! inwards by up to a tenth of the radius, at random.

use std::collections::HashMap;
use std::fmt::Write;

use glam::DVec3;
use radiosity_test_support::random::Random;

use crate::family::{FACTOR_STAGES, Family, of_factors};

/// Balls of triangles quartered more and more often.
pub(crate) const FAMILY: Family = Family {
    name: "balls",
    stages: FACTOR_STAGES,
    sizes: &[80, 320, 1_280],
    measure: |surfaces| of_factors(&ball(surfaces)),
};

/// Largest dent (radii).
const DENT: f64 = 0.1;
/// The golden section.
const GOLDEN: f64 = 1.618_033_988_749_895;

/// The text of a ball of so many triangles.
fn ball(triangles: usize) -> String {
    let (mut corners, mut faces) = icosahedron();
    while faces.len() < triangles {
        faces = quartered(&mut corners, &faces);
    }
    let mut random = Random(triangles as u64);
    corners.iter_mut().for_each(|corner| *corner *= 1.0 - DENT * random.unit());
    let mut text = String::new();
    for [a, b, c] in faces {
        // Fronts are inside.
        let corners = [a, c, b].map(|corner| corners[corner].to_array());
        writeln!(text, "[[surfaces]]\ntriangle = {{ vertices = {corners:?} }}").expect("a text takes all");
    }
    text
}

/// The corners and faces of an icosahedron, fronts outside.
fn icosahedron() -> (Vec<DVec3>, Vec<[usize; 3]>) {
    let corners: Vec<DVec3> = (0..12)
        .map(|corner| {
            let [first, second] = [corner & 1, corner >> 1 & 1].map(|bit| 1.0 - 2.0 * bit as f64);
            let mut point = [0.0; 3];
            (point[corner / 4], point[(corner / 4 + 1) % 3]) = (first, second * GOLDEN);
            DVec3::from_array(point).normalize()
        })
        .collect();
    let is_edge = |a: usize, b: usize| corners[a].dot(corners[b]) > 0.4 && a != b;
    let mut faces = Vec::new();
    for (a, b, c) in (0..12).flat_map(|a| (0..a).flat_map(move |b| (0..b).map(move |c| (a, b, c)))) {
        if is_edge(a, b) && is_edge(b, c) && is_edge(c, a) {
            let is_out = corners[a].cross(corners[b]).dot(corners[c]) > 0.0;
            faces.push(if is_out { [a, b, c] } else { [a, c, b] });
        }
    }
    (corners, faces)
}

/// Each face in four, new corners on the unit sphere.
fn quartered(corners: &mut Vec<DVec3>, faces: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut middles: HashMap<[usize; 2], usize> = HashMap::new();
    let mut middle = |a: usize, b: usize| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            corners.push((corners[a] + corners[b]).normalize());
            corners.len() - 1
        })
    };
    let mut parts = Vec::with_capacity(4 * faces.len());
    for &[a, b, c] in faces {
        let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
        parts.extend([[a, x, z], [b, y, x], [c, z, y], [x, y, z]]);
    }
    parts
}
