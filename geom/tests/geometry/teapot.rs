//! Newell's teapot: 32 bicubic patches that share edges.

use crate::scenes::Teapot;
use radiosity_test_support::random::Random;
use std::sync::Arc;

use radiosity_geom::{Adjacency, Bvh, DVec3, Patch, Ray, RayTree, Rect, Surface};

#[test]
fn areas_agree_with_the_table() {
    let teapot = Teapot::load();
    assert_eq!(teapot.surfaces().len(), 32);
    for (k, (surface, area)) in teapot.surfaces().iter().zip(&teapot.areas).enumerate() {
        // The table's rule is blind to the fold of the spout's lip and to the collapsed edges of the lid:
        // good to 3e-6 there.
        let digits = if (18..24).contains(&k) { 3e-6 } else { 3e-9 };
        assert!(
            (surface.area() - area).abs() < digits * area,
            "patch {k}: {} instead of {area}",
            surface.area()
        );
    }
}

/// The four control points of each border, in the order of `Patch::borders`.
fn border_points(p: &[[DVec3; 4]; 4]) -> [[DVec3; 4]; 4] {
    let column = |j: usize| [p[0][j], p[1][j], p[2][j], p[3][j]];
    let reversed = |mut q: [DVec3; 4]| {
        q.reverse();
        q
    };
    [column(0), p[3], reversed(column(3)), reversed(p[0])]
}

/// The border of patch `a`, by its index, along which patch `b` has the same control points, forwards or
/// backwards, read off the table alone.
fn seams_of_table(teapot: &Teapot, a: usize, b: usize) -> Vec<usize> {
    let (p, q) = (border_points(&teapot.points(a)), border_points(&teapot.points(b)));
    let turned = q.map(|mut points| {
        points.reverse();
        points
    });
    (0..4).filter(|i| p[*i][0] != p[*i][3] && (q.contains(&p[*i]) || turned.contains(&p[*i]))).collect()
}

fn pairs() -> impl Iterator<Item = (usize, usize)> {
    (0..32).flat_map(|a| (a + 1..32).map(move |b| (a, b)))
}

#[test]
fn the_graph_of_seams_is_that_of_the_control_points() {
    let teapot = Teapot::load();
    let surfaces = teapot.surfaces();
    let patches: Vec<Patch> = surfaces.iter().map(|s| Patch::whole(s)).collect();
    for (a, b) in pairs() {
        let found = Adjacency::of(&patches[a], &patches[b]);
        let has_seam = !seams_of_table(&teapot, a, b).is_empty();
        assert_eq!(found == Some(Adjacency::Edge), has_seam, "patches {a} and {b}: {found:?}");
    }
}

/// Rays through points of the seams, and beside them by many roundings, hit one of the two patches there.
#[test]
fn seams_are_watertight() {
    let teapot = Teapot::load();
    let surfaces = teapot.surfaces();
    let mut random = Random(7);
    let seams = |(a, b)| seams_of_table(&teapot, a, b).into_iter().map(move |seam| (a, b, seam));
    for (a, b, seam) in pairs().flat_map(seams) {
        let border = Patch::whole(&surfaces[a]).borders()[seam];
        for _ in 0..400 {
            let w = random.between(-1.0, 1.0);
            let [u, v] = border.parameters(w);
            let normal = surfaces[a].jet(u, v).normal;
            let direction = random.direction();
            if direction.dot(normal).abs() < 0.05 {
                continue;
            }
            let target = border.point(w) + random.between(0.0, 1e-12) * random.direction();
            let ray = Ray { range: [4.9, 5.1], ..Ray::new(target - 5.0 * direction, direction) };
            let near = [a, b]
                .map(|k| surfaces[k].intersect(&ray))
                .into_iter()
                .flatten()
                .any(|hit| (hit.t - 5.0).abs() < 1e-8);
            assert!(near, "patches {a} and {b} at {w} along {direction}");
        }
    }
}

#[test]
fn the_hierarchy_agrees_with_brute_force() {
    let surfaces = Teapot::load().surfaces();
    let boxes: Vec<_> = surfaces.iter().map(|s| s.bounds(&Rect::FULL)).collect();
    let bvh = Bvh::build(&boxes);
    let tree = RayTree::new(surfaces.iter().map(|s| -> Arc<dyn Surface> { Arc::new(s.clone()) }).collect());
    let mut random = Random(3);
    for _ in 0..3000 {
        let ray = Ray::segment(random.vector(-4.0, 4.0), random.vector(-3.0, 3.0));
        let all = surfaces.iter().filter_map(|s| s.intersect(&ray)).map(|hit| hit.t);
        let nearest = all.min_by(f64::total_cmp);
        assert_eq!(tree.nearest(&ray).map(|met| met.hit.t), nearest);
        assert_eq!(bvh.any(&ray, |k| surfaces[k].occludes(&ray)), nearest.is_some());
    }
}
