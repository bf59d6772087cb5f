//! First hits of rays, against all surfaces asked one by one; boxes do not leak, and no surface hides itself.

use proptest::prelude::*;
use radiosity_geom::shapes::{Bilinear, Cylinder, Disk, FULL_TURN, Parallelogram, Polygon, Sphere, Triangle};
use radiosity_geom::{DVec3, Encounter, Flipped, Motion, Placed, Ray, RayTree, Surface};
use radiosity_test_support::gallery::gallery;
use radiosity_test_support::random::Random;
use std::sync::Arc;

type Shape = Arc<dyn Surface>;

/// A surface of every kind, in random places of a ball of three times their size; every third with its other
/// side.
fn crowd(random: &mut Random, scale: f64, away: DVec3) -> Vec<Shape> {
    let place = |(k, exhibit): (usize, radiosity_test_support::gallery::Exhibit)| {
        let (axis, angle) = (random.direction(), random.between(-3.0, 3.0));
        let motion =
            Motion::new(away + scale * random.vector(-4.0, 4.0), axis, angle, scale).expect("a motion");
        let front: Shape = Arc::new(Placed::new(exhibit.surface, motion));
        let back = (k % 3 == 0).then(|| -> Shape { Arc::new(Flipped::new(Box::new(front.clone()))) });
        std::iter::once(front).chain(back)
    };
    gallery().into_iter().enumerate().flat_map(place).collect()
}

/// The lowest t of all surfaces.
fn first(surfaces: &[Shape], ray: &Ray) -> Option<f64> {
    surfaces.iter().filter_map(|s| s.intersect(ray)).map(|hit| hit.t).min_by(f64::total_cmp)
}

/// Surface, parameters and side belong to the place on the ray.
fn assert_consistent(surfaces: &[Shape], ray: &Ray, met: &Encounter, size: f64) {
    let jet = surfaces[met.surface].jet(met.hit.u, met.hit.v);
    assert!(jet.position.distance(ray.at(met.hit.t)) <= 1e-7 * size, "{ray:?} {met:?}");
    let cosine = jet.normal.dot(ray.direction.normalize());
    assert!(met.front == (cosine < 0.0) || cosine.abs() < 1e-12, "{ray:?} {met:?}");
}

fn box_faces(corner: DVec3, edges: [DVec3; 3], kind: usize) -> Vec<Shape> {
    let mut faces: Vec<Shape> = Vec::new();
    for k in 0..3 {
        let [across, a, b] = [0, 1, 2].map(|step| edges[(k + step) % 3]);
        // Fronts inside.
        for (start, a, b) in [(corner, a, b), (corner + across, b, a)] {
            let corners = [start, start + a, start + a + b, start + b];
            let [p, q, r, s] = corners;
            match kind {
                0 => faces.push(Arc::new(Parallelogram::new(start, a, b).expect("a face"))),
                1 => faces.push(Arc::new(Polygon::new(corners.to_vec(), vec![]).expect("a face"))),
                2 => faces.push(Arc::new(Bilinear::new(corners).expect("a face"))),
                _ => {
                    for half in [[p, q, r], [r, s, p]] {
                        faces.push(Arc::new(Triangle::new(half).expect("half a face")));
                    }
                }
            }
        }
    }
    faces
}

/// Three edges of a box with right angles, right-handed.
fn edges(random: &mut Random) -> [DVec3; 3] {
    let a = random.direction();
    let b = a.cross(random.direction()).normalize();
    [random.between(0.5, 3.0) * a, random.between(0.5, 3.0) * b, random.between(0.5, 3.0) * a.cross(b)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn agrees_with_all_surfaces_asked_one_by_one(
        seed in any::<u64>(), power in -6i32..6, far in prop::bool::ANY, level in prop::bool::ANY,
    ) {
        let mut random = Random(seed);
        let scale = 10.0_f64.powi(power);
        let away = if far { 1e3 * scale * random.direction() } else { DVec3::ZERO };
        let surfaces = crowd(&mut random, scale, away);
        let tree = RayTree::new(surfaces.clone());
        for _ in 0..100 {
            // Some start outside of all, some run along an axis.
            let origin = away + scale * random.vector(-12.0, 12.0);
            let target = away + scale * random.vector(-5.0, 5.0);
            let mut direction = target - origin;
            if level {
                direction.z = 0.0;
                direction.x *= f64::from(random.between(-1.0, 1.0) < 0.0);
            }
            for range in [[0.0, f64::INFINITY], [0.2, 0.9], [-0.5, 1.0]] {
                let ray = Ray { origin, direction, range };
                let (met, expected) = (tree.nearest(&ray), first(&surfaces, &ray));
                let t = met.map(|met| met.hit.t);
                let agree = match (t, expected) {
                    (Some(t), Some(expected)) => (t - expected).abs() <= 1e-9,
                    (t, expected) => t == expected,
                };
                prop_assert!(agree, "{ray:?}: {met:?}, {expected:?}");
                met.iter().for_each(|met| assert_consistent(&surfaces, &ray, met, 10.0 * scale));
            }
        }
    }

    /// A first hit stays the same, to the bit, unless a surface that has moved comes before it.
    #[test]
    fn what_moves_changes_what_is_met_only_where_it_comes_before_it(seed in any::<u64>(), share in 0.02..0.5_f64) {
        let mut random = Random(seed);
        let before = crowd(&mut random, 1.0, DVec3::ZERO);
        let moves: Vec<bool> = before.iter().map(|_| random.between(0.0, 1.0) < share).collect();
        let mut moved = |shape: &Shape| -> Shape {
            let motion = Motion::new(random.vector(-1.0, 1.0), random.direction(), 1.0, 1.0).expect("a motion");
            Arc::new(Placed::new(Box::new(shape.clone()), motion))
        };
        let after: Vec<Shape> =
            before.iter().zip(&moves).map(|(shape, moves)| if *moves { moved(shape) } else { shape.clone() }).collect();
        let changed = after.iter().zip(&moves).filter(|(_, moves)| **moves).map(|(shape, _)| shape.clone());
        let [old, new, changed] = [before, after.clone(), changed.collect()].map(RayTree::new);
        for k in 0..400 {
            let own = k % after.len();
            if moves[own] || old.start_on(own)[1] != new.start_on(own)[1] {
                continue;
            }
            let jet = after[own].jet(random.between(-0.9, 0.9), random.between(-0.9, 0.9));
            let direction = jet.normal + 0.9 * random.direction();
            let [was, is] = [&old, &new].map(|tree| tree.nearest_from(own, jet.position, direction));
            let end = was.map_or(f64::INFINITY, |met| met.hit.t);
            let reach = old.reach().max(new.reach());
            let may_change = was.is_some_and(|met| moves[met.surface])
                || changed.may_come_before(jet.position, direction, end, reach);
            prop_assert!(may_change || was == is, "{was:?} {is:?}");
        }
    }

    #[test]
    fn closed_boxes_do_not_leak(seed in any::<u64>(), kind in 0usize..4, shift in -3.0..3.0_f64) {
        let mut random = Random(seed);
        let (corner, edges) = (10.0_f64.powf(shift) * random.direction(), edges(&mut random));
        let faces = box_faces(corner, edges, kind);
        let tree = RayTree::new(faces.clone());
        let regions: Vec<_> = faces.iter().map(|face| face.region().expect("it is flat")).collect();
        let at = |x: [f64; 3]| corner + x[0] * edges[0] + x[1] * edges[1] + x[2] * edges[2];
        for k in 0..200 {
            // A place on an edge, or a corner, of the box.
            let mut rim = [0, 1, 2].map(|_| random.between(-1.0, 1.0).signum() * 0.5 + 0.5);
            if k % 4 > 0 {
                rim[k % 3] = random.between(0.0, 1.0);
            }
            let inside = at([0, 1, 2].map(|_| random.between(0.01, 0.99)));
            let ray = Ray::new(inside, at(rim) - inside);
            let met = tree.nearest(&ray);
            prop_assert!(met.is_some_and(|met| met.front && (met.hit.t - 1.0).abs() < 1e-6), "{ray:?} {met:?}");
            // From there, as from each face that it lies on. A ray all but within another of these leaves it
            // by more than the tolerance at seams before it gets behind it, for the roundings of the place.
            let own: Vec<usize> = (0..faces.len()).filter(|k| regions[*k].contains(at(rim))).collect();
            let direction = random.direction();
            let is_steep = own.iter().all(|k| regions[*k].normal().dot(direction).abs() > 1e-3);
            for own in own.into_iter().filter(|k| is_steep && regions[*k].normal().dot(direction) > 0.0) {
                let met = tree.nearest_from(own, at(rim), direction);
                let is_kept = met.is_some_and(|met| met.front && met.surface != own);
                prop_assert!(is_kept, "{own} {rim:?} {direction} {met:?}");
            }
        }
    }

    #[test]
    fn rays_leave_the_surface_that_they_start_on(seed in any::<u64>()) {
        let mut random = Random(seed);
        let surfaces = crowd(&mut random, 1.0, DVec3::ZERO);
        let tree = RayTree::new(surfaces.clone());
        for (own, surface) in surfaces.iter().enumerate() {
            for _ in 0..20 {
                let jet = surface.jet(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
                let is_on_it = surface.region().is_none_or(|region| region.contains(jet.position));
                let direction = jet.normal + random.direction();
                let ray = Ray::new(jet.position, direction);
                if !is_on_it || jet.area < 1e-3 || jet.normal.dot(direction.normalize()) < 1e-2 {
                    continue;
                }
                let met = tree.nearest_from(own, jet.position, direction);
                // A trifle away from the surface, it is one among others.
                let expected = first(&surfaces, &Ray { range: [1e-5, f64::INFINITY], ..ray });
                let t = met.map(|met| met.hit.t);
                let agree = match (t, expected) {
                    (Some(t), _) if t < 1e-5 => true,
                    (Some(t), Some(expected)) => (t - expected).abs() <= 1e-9,
                    (t, expected) => t == expected,
                };
                prop_assert!(agree, "{own} {ray:?} {met:?} {expected:?}");
                prop_assert!(surface.region().is_none() || met.is_none_or(|met| met.surface != own));
            }
        }
    }
}

#[test]
fn hollow_things_meet_themselves_and_full_ones_do_not() {
    let ball: Shape = Arc::new(Sphere::new(DVec3::X, 2.0, DVec3::Z, [-2.0, 2.0], FULL_TURN).expect("a ball"));
    let dome: Shape = Arc::new(Flipped::new(Box::new(ball.clone())));
    let (full, sheet) = (RayTree::new(vec![ball.clone()]), RayTree::new(vec![ball.clone(), dome]));
    let mut random = Random(5);
    for _ in 0..2000 {
        let jet = ball.jet(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let outward = (jet.normal + 0.999 * random.direction()).normalize();
        assert_eq!(full.nearest_from(0, jet.position, outward), None);
        assert_eq!(sheet.nearest_from(0, jet.position, outward), None);
        let chord = 4.0 * jet.normal.dot(outward);
        let inside = sheet.nearest_from(1, jet.position, -outward).expect("the dome is closed");
        assert!(
            inside.front && inside.surface == 1 && (inside.hit.t - chord).abs() < 1e-12,
            "{inside:?} {chord}"
        );
    }
}

#[test]
fn of_two_sides_the_front_is_met() {
    let up: Shape = Arc::new(Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y).expect("a square"));
    let down: Shape = Arc::new(Flipped::new(Box::new(up.clone())));
    let middle = DVec3::new(0.3, 0.4, 0.0);
    for surfaces in [[up.clone(), down.clone()], [down, up]] {
        let tree = RayTree::new(surfaces.to_vec());
        for direction in [DVec3::Z, -DVec3::Z] {
            let met = tree.nearest(&Ray::new(middle - 7.0 * direction, direction)).expect("it is in the way");
            let normal = surfaces[met.surface].jet(0.0, 0.0).normal;
            assert!(met.front && normal.dot(direction) < 0.0 && met.hit.t == 7.0);
        }
        for (own, surface) in surfaces.iter().enumerate() {
            let normal = surface.jet(0.0, 0.0).normal;
            assert_eq!(tree.nearest_from(own, middle, normal), None);
        }
    }
}

/// A can: light from the rim of its bottom stays inside.
#[test]
fn rims_of_curved_walls_do_not_leak() {
    let wall = Cylinder::new(DVec3::ZERO, 2.0 * DVec3::Z, 1.0, FULL_TURN).expect("a wall");
    let surfaces: Vec<Shape> = vec![
        Arc::new(Flipped::new(Box::new(wall))),
        Arc::new(Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a bottom")),
        Arc::new(Disk::new(2.0 * DVec3::Z, -DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a lid")),
    ];
    let tree = RayTree::new(surfaces.clone());
    let mut random = Random(11);
    for _ in 0..5000 {
        let rim = surfaces[1].jet(random.between(-1.0, 1.0), -1.0).position;
        let direction = DVec3::Z + 0.99 * random.direction();
        let met = tree.nearest_from(1, rim, direction).expect("the can is closed");
        assert!(met.front, "{rim} {direction} {met:?}");
    }
}

/// From the foot of a box on a floor, light does not get into the box; past its edges it does not stick to
/// its sides.
#[test]
fn creases_block_one_way_only() {
    let floor: Shape = Arc::new(
        Parallelogram::new(DVec3::new(-9.0, -9.0, 0.0), 18.0 * DVec3::X, 18.0 * DVec3::Y).expect("a floor"),
    );
    // Fronts outside: left-handed edges.
    let sides = box_faces(DVec3::ZERO, [DVec3::Y, DVec3::X, DVec3::Z], 0);
    let surfaces: Vec<Shape> = std::iter::once(floor).chain(sides).collect();
    let tree = RayTree::new(surfaces.clone());
    let foot = DVec3::new(1.0, 0.5, 0.0);
    let into = tree.nearest_from(0, foot, DVec3::new(-0.3, 0.1, 0.8)).expect("a side");
    assert!(into.front && into.hit.t.abs() < 1e-12);
    assert_eq!(tree.nearest_from(0, foot, DVec3::new(0.3, 0.1, 0.8)), None);
    let is_top = |k: &usize| surfaces[*k].jet(0.0, 0.0).normal == DVec3::Z && *k > 0;
    let top = (0..surfaces.len()).find(is_top).expect("a top");
    assert_eq!(tree.nearest_from(top, DVec3::new(1.0, 0.5, 1.0), DVec3::new(-0.3, 0.1, 0.8)), None);
}

/// Along edges and within the planes of faces, at the coordinates of the faces and a trifle beside them.
#[test]
fn rays_along_the_faces_of_a_level_box_agree() {
    for kind in 0..4 {
        let faces = box_faces(DVec3::ZERO, [DVec3::X, DVec3::Y, DVec3::Z], kind);
        let tree = RayTree::new(faces.clone());
        let places = [0.0, -0.0, 1e-12, 1e-8, 0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-8];
        for (k, [y, z]) in places.iter().flat_map(|y| places.map(|z| [*y, z])).enumerate() {
            for [x, step] in [[-2.0, 1.0], [0.5, 1.0], [0.5, -1.0], [2.0, -1.0]] {
                let turn = |v: [f64; 3]| DVec3::from_array([0, 1, 2].map(|axis| v[(axis + k) % 3]));
                let ray = Ray::new(turn([x, y, z]), turn([step, 0.0, 0.0]));
                assert_eq!(tree.nearest(&ray).map(|met| met.hit.t), first(&faces, &ray), "{ray:?}");
            }
        }
    }
}

#[test]
fn nothing_is_met_where_nothing_is() {
    assert_eq!(RayTree::new(vec![]).nearest(&Ray::new(DVec3::ZERO, DVec3::X)), None);
    let ball: Shape =
        Arc::new(Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a ball"));
    let tree = RayTree::new(vec![ball; 300]);
    let met = tree.nearest(&Ray::new(-3.0 * DVec3::X, DVec3::X)).expect("300 balls in one place");
    assert_eq!((met.surface, met.hit.t, met.front), (0, 2.0, true));
    assert_eq!(tree.nearest(&Ray::new(-3.0 * DVec3::X, DVec3::Y)), None);
}
