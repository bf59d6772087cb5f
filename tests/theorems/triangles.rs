//! Triangles of surfaces: their area, their fronts, their distance from what they stand for, and the edges
//! they share.

use std::collections::BTreeMap;

use radiosity::output::pictures::tessellation::{Triangulation, tessellation};
use radiosity::scene::SceneSurface;
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{builtin, every_shape, typed};

fn corners<'a>(own: &'a Triangulation, triangle: &'a [u32; 3]) -> [DVec3; 3] {
    triangle.map(|corner| own.positions[corner as usize])
}

fn area(own: &Triangulation) -> f64 {
    let triangle = |triangle: &[u32; 3]| {
        let [a, b, c] = corners(own, triangle);
        0.5 * (b - a).cross(c - a).length()
    };
    own.triangles.iter().map(triangle).sum()
}

#[test]
fn area_converges_to_that_of_the_surface() {
    let scene = every_shape();
    let [coarse, fine] = [3e-2, 3e-4].map(|tolerance| tessellation(&scene, tolerance));
    for ((surface, coarse), fine) in scene.surfaces.iter().zip(&coarse).zip(&fine) {
        let exact = surface.shape.area();
        let error = |own: &Triangulation| (area(own) / exact - 1.0).abs();
        let (coarse, fine) = (error(coarse), error(fine));
        if surface.shape.region().is_some() {
            assert!(coarse < 1e-12, "{}: {coarse}", surface.name);
        } else {
            assert!(fine < 2e-3 && fine <= 0.2 * coarse + 1e-12, "{}: {coarse}, {fine}", surface.name);
        }
    }
}

/// The place of the mean parameters of a triangle, and the unit normal there.
fn middle(surface: &SceneSurface, own: &Triangulation, triangle: &[u32; 3]) -> (DVec3, DVec3) {
    let mean =
        |axis: usize| triangle.iter().map(|corner| own.parameters[*corner as usize][axis]).sum::<f64>() / 3.0;
    let jet = surface.shape.jet(mean(0), mean(1));
    (jet.position, jet.normal)
}

#[test]
fn triangles_show_their_fronts_and_lie_within_the_tolerance() {
    const TOLERANCE: f64 = 1e-3;
    let scene = every_shape();
    for (surface, own) in scene.surfaces.iter().zip(tessellation(&scene, TOLERANCE)) {
        let shape = &surface.shape;
        assert!(!own.triangles.is_empty(), "{}", surface.name);
        for (position, [u, v]) in own.positions.iter().zip(&own.parameters) {
            assert!(shape.jet(*u, *v).position.distance(*position) < 1e-9, "{}", surface.name);
        }
        for triangle in &own.triangles {
            let [a, b, c] = corners(&own, triangle);
            let (place, normal) = middle(surface, &own, triangle);
            let distance = place.distance((a + b + c) / 3.0);
            assert!(distance < 1.5 * TOLERANCE, "{}: {distance}", surface.name);
            let cosine = (b - a).cross(c - a).normalize().dot(normal);
            assert!(cosine > 0.9, "{}: {cosine}", surface.name);
        }
    }
}

/// Edges of the triangles that no other triangle has in the other direction.
fn open_edges<'a>(triangulations: impl Iterator<Item = &'a Triangulation>) -> usize {
    let mut edges: BTreeMap<[[u64; 3]; 2], i32> = BTreeMap::new();
    for own in triangulations {
        for triangle in &own.triangles {
            let bits = corners(own, triangle).map(|x| (x + 0.0).to_array().map(f64::to_bits));
            for k in 0..3 {
                let (from, to) = (bits[k], bits[(k + 1) % 3]);
                *edges.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
            }
        }
    }
    assert!(edges.len() >= 18, "{} edges", edges.len());
    edges.values().filter(|count| **count != 0).count()
}

#[test]
fn closed_rooms_of_flat_faces_have_no_cracks() {
    for name in ["furnace-cube", "empty-box"] {
        let scene = builtin(name);
        assert_eq!(open_edges(tessellation(&scene, 1e-3).iter()), 0, "{name}");
    }
}

/// A table is cut out of the floor, whose borders stay whole: the only open edges are those of the table's
/// foot.
#[test]
fn a_body_on_the_floor_cracks_no_edge_of_the_room() {
    let text = r#"surfaces = [
        { name = "room", box = { origin = [0, 0, 0], size = [4, 5, 2.5], inward = true } },
        { name = "table", box = { origin = [1.2, 2.5, 0], size = [1.6, 0.8, 0.7] } },
    ]"#;
    let scene = typed(text);
    let all = tessellation(&scene, 1e-3);
    let room = scene.surfaces.iter().zip(&all).filter(|(surface, _)| surface.name.starts_with("room"));
    assert_eq!(open_edges(room.map(|(_, own)| own)), 4);
}

/// The part of a wall under a sheet is not drawn twice.
#[test]
fn what_a_sheet_covers_is_left_out() {
    let text = r#"
        [[surfaces]]
        quad = { vertices = [[0,0,0],[2,0,0],[2,2,0],[0,2,0]] }
        [[surfaces]]
        quad = { vertices = [[0.5,0.5,0],[1,0.5,0],[1,1.5,0],[0.5,1.5,0]] }"#;
    let scene = typed(text);
    let areas = tessellation(&scene, 1e-3).iter().map(area).collect::<Vec<f64>>();
    assert!((areas[0] - 3.5).abs() < 1e-6 && (areas[1] - 0.5).abs() < 1e-6, "{areas:?}");
}
