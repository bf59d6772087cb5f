//! Newell's teapot: 32 bicubic patches that share edges.

use crate::random::Random;
use crate::scenes::Teapot;
use radiosity_geom::{Adjacency, Bvh, DVec3, Patch, Ray, RayTree, Rect, Seam, Surface};
use std::sync::Arc;

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

/// Borders with the same control points, forwards or backwards, read off the table alone.
fn seams_of_table(teapot: &Teapot, a: usize, b: usize) -> Vec<(usize, usize, bool)> {
    let (p, q) = (border_points(&teapot.points(a)), border_points(&teapot.points(b)));
    let mut seams = Vec::new();
    for (i, j) in (0..16).map(|k| (k / 4, k % 4)).filter(|(i, _)| p[*i][0] != p[*i][3]) {
        let mut turned = q[j];
        turned.reverse();
        if p[i] == q[j] || p[i] == turned {
            seams.push((i, j, p[i] == turned));
        }
    }
    seams
}

fn all_seams(teapot: &Teapot) -> Vec<(usize, usize, Seam)> {
    let surfaces = teapot.surfaces();
    let patches: Vec<Patch> = surfaces.iter().map(|s| Patch::whole(s)).collect();
    let mut all = Vec::new();
    for a in 0..32 {
        for b in a + 1..32 {
            let seams = match Adjacency::of(&patches[a], &patches[b]) {
                Adjacency::Edges(seams) => seams,
                _ => Vec::new(),
            };
            let found: Vec<_> = seams.iter().map(|s| (s.borders[0], s.borders[1], s.reversed)).collect();
            assert_eq!(
                found,
                seams_of_table(teapot, a, b),
                "patches {a} and {b}: {:?}",
                Adjacency::of(&patches[a], &patches[b])
            );
            all.extend(seams.into_iter().map(|s| (a, b, s)));
        }
    }
    all
}

#[test]
fn the_graph_of_seams_is_that_of_the_control_points() {
    let teapot = Teapot::load();
    let seams = all_seams(&teapot);
    assert!(seams.iter().all(|(_, _, seam)| seam.matched && seam.reversed));
    // Four patches to a ring: rim, body above, body below, lid above, lid below, bottom; two and two for
    // handle and spout.
    let smooth = seams.iter().filter(|(_, _, seam)| seam.bend < 1e-3).count();
    assert!(smooth >= 24, "{smooth} of {} seams are smooth", seams.len());
}

/// Rays through points of the seams, and beside them by many roundings, hit one of the two patches there.
#[test]
fn seams_are_watertight() {
    let teapot = Teapot::load();
    let surfaces = teapot.surfaces();
    let mut random = Random(7);
    for (a, b, seam) in all_seams(&teapot) {
        let border = Patch::whole(&surfaces[a]).borders()[seam.borders[0]];
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
