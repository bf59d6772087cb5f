//! Transport between curved surfaces against closed forms and independent references.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use proptest::prelude::*;
use radiosity::elements::coating::Coating;
use radiosity::elements::patch::{Direction, Patch};
use radiosity::elements::rule::UnitRule;
use radiosity::elements::{Discretization, Element, Elements};
use radiosity::kernel::irradiance::visible_polygon::irradiance;
use radiosity::kernel::{Accuracy, Blocks, PlacedBlock};
use radiosity::scene::Scene;
use radiosity::solve::system::System;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::shapes::{
    Bezier, Cone, Cylinder, Disk, FULL_TURN, Parallelogram, Sphere, SpherePatch, Torus,
};
use radiosity_geom::{DVec3, Flipped, Motion, Placed, Surface};
use radiosity_solvers::Settings;
use radiosity_solvers::method::Method;
use radiosity_test_support::data::{number, table};
use radiosity_test_support::scenes::shining;
use radiosity_test_support::shapes::inside;
use radiosity_test_support::shapes::{ball, disk, plate};
use radiosity_test_support::solved::{blocks_of, elements_of};

use crate::transport::grazing::{ball_and, lamp_above};

fn scene(shapes: Shapes) -> Scene {
    shining(shapes.into_iter().map(|shape| (shape, 1.0))).build().expect("the scene is valid")
}

type Shapes = Vec<Arc<dyn Surface>>;

struct Transport {
    elements: Elements,
    blocks: Blocks,
}

impl Transport {
    fn new(shapes: Shapes, order: usize, cells: usize, eps: f64, shadows: Shadows) -> Self {
        let scene = scene(shapes);
        let visibility = Visibility::new(&scene, shadows, eps);
        let how = Discretization::uniform(order, cells);
        let elements = Elements::new(&scene, &how).expect("all have area");
        let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: 1e-3 });
        Self { elements, blocks }
    }

    fn unoccluded(shapes: Shapes, order: usize, eps: f64) -> Self {
        Self::new(shapes, order, 1, eps, Shadows::Off)
    }

    /// Form factor from element i to element j: √(A_j / A_i) G_ij^00.
    fn factor(&self, i: usize, j: usize) -> f64 {
        let list = self.elements.list();
        let (row, column) = (i.min(j), i.max(j));
        let found = self.blocks.iter().find(|block| (block.row, block.column) == (row, column));
        found.map_or(0.0, |block| block.values[0] * (list[j].area / list[i].area).sqrt())
    }
}

fn tube(radius: f64, height: f64, angle: [f64; 2]) -> Cylinder {
    Cylinder::new(DVec3::ZERO, height * DVec3::Z, radius, angle).expect("a tube")
}

fn lid(z: f64, up: bool, radius: f64) -> Disk {
    let normal = if up { DVec3::Z } else { -DVec3::Z };
    disk(z * DVec3::Z, normal, radius)
}

/// A plate and a quarter of a tube that meet in an edge, all 15 × 15 entries of order 4, and the tube with
/// itself.
#[test]
fn plate_and_quarter_tube_to_the_accuracy_asked() {
    let data = table("transfers_curved.json");
    let plate = || -> Arc<dyn Surface> { Arc::new(plate(DVec3::ZERO, DVec3::X, DVec3::Y)) };
    // v of the reference runs from the angle π down to π/2: our u, reversed; its u is our v.
    let quarter =
        || inside(Cylinder::new(DVec3::Y, DVec3::X, 1.0, [FRAC_PI_2, PI]).expect("a quarter of a tube"));
    let degrees: Vec<[usize; 2]> = data["index"]
        .as_array()
        .expect("an index")
        .iter()
        .map(|pair| [0, 1].map(|k| pair[k].as_u64().expect("a degree") as usize))
        .collect();
    let scale = 4.0 / FRAC_PI_2.sqrt();
    let expected = |k: usize, l: usize| {
        // Our emitter index l has degrees (a, b) in (angle, height): the reference's (height, angle) is (b,
        // a).
        let [a, b] = degrees[l];
        let place = degrees.iter().position(|pair| *pair == [b, a]).expect("the index is complete");
        let sign = if a % 2 == 0 { 1.0 } else { -1.0 };
        sign * scale * number(&data["M"][k][place])
    };
    for eps in [1e-2, 1e-4, 1e-8, 1e-12] {
        let transport = Transport::unoccluded(vec![plate(), quarter()], 4, eps);
        let found = transport.blocks.iter().find(|block| (block.row, block.column) == (0, 1));
        let PlacedBlock { values, .. } = found.expect("they meet");
        let largest = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
        for (index, value) in values.iter().enumerate() {
            let error = (value - expected(index / 15, index % 15)).abs();
            assert!(error <= eps * largest + 1e-13, "{eps:e} entry {index}: {error:e}");
        }
        let own = transport.factor(1, 1) - number(&data["self_F_cylinder"]);
        assert!(own.abs() <= eps * 0.06 + 1e-13, "{eps:e} self: {own:e}");
    }
}

fn cube_sphere(radius: f64) -> Shapes {
    SpherePatch::cube(DVec3::ZERO, radius).expect("a sphere").into_iter().map(inside).collect()
}

fn can(height: f64) -> Shapes {
    let lids: [Arc<dyn Surface>; 2] = [Arc::new(lid(0.0, true, 1.0)), Arc::new(lid(height, false, 1.0))];
    [inside(tube(1.0, height, FULL_TURN))].into_iter().chain(lids).collect()
}

fn closed_cone() -> Shapes {
    let cone = Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a cone");
    vec![inside(cone), Arc::new(lid(0.0, true, 1.0))]
}

/// Largest |b − 2c| / √area of the furnace: reflectance ½, exitance 1 everywhere, B = 2.
fn furnace_error(transport: &Transport) -> f64 {
    let list = transport.elements.list();
    let coating = Coating::constant(vec![0.5; list.len()], vec![1.0; list.len()]);
    let system = System::new(list, &transport.blocks, &coating);
    let right = system.right_hand_side();
    let mut unknowns = vec![0.0; right.len()];
    let solver = Method::named("cholesky").expect("it is listed").solver;
    let matrix = system.matrix().expect("the matrix is finite");
    solver.solve(&matrix, &right, &mut unknowns, &Settings::default(), &mut |_| {}).expect("it is definite");
    let radiosity = system.coefficients(&unknowns).radiosity;
    let roots = list.iter().flat_map(|e| vec![e.area.sqrt(); e.basis.len()]);
    let constant = list.iter().flat_map(|e| e.constant.clone());
    let errors = radiosity.iter().zip(constant).zip(roots).map(|((b, c), root)| (b - 2.0 * c).abs() / root);
    errors.fold(0.0, f64::max)
}

#[test]
fn furnaces_with_curved_walls_keep_the_accuracy_asked() {
    let rooms: [(&str, Shapes, &[f64]); 4] = [
        ("cube sphere", cube_sphere(1.5), &[1e-4, 1e-8, 1e-12]),
        ("polar sphere", vec![inside(ball(DVec3::X, 0.7))], &[1e-4, 1e-8, 1e-12]),
        ("can", can(2.0), &[1e-4, 1e-8, 1e-12]),
        ("cone", closed_cone(), &[1e-4, 1e-8]),
    ];
    for (name, room, accuracies) in rooms {
        for eps in accuracies {
            let transport = Transport::unoccluded(room.clone(), 2, *eps);
            let error = furnace_error(&transport);
            assert!(error <= 10.0 * eps + 1e-13, "{name} {eps:e}: {error:e}");
            assert_eq!(transport.blocks.statistics.pairs.unresolved, 0, "{name} {eps:e}");
        }
    }
}

/// Coaxial disks of radius 1 at distance h: F = 1 + h²/2 − √((1 + h²/2)² − 1); the side sees the rest.
#[test]
fn lids_and_side_of_a_can() {
    let h = 2.0f64;
    let x = 1.0 + 0.5 * h * h;
    let lids = x - (x * x - 1.0).sqrt();
    for eps in [1e-4, 1e-8] {
        let transport = Transport::unoccluded(can(h), 0, eps);
        assert!((transport.factor(1, 2) - lids).abs() <= eps);
        assert!((transport.factor(1, 0) - (1.0 - lids)).abs() <= eps);
        assert!((transport.factor(0, 0) - (1.0 - (1.0 - lids) / h)).abs() <= eps);
    }
}

/// A ball of any size that a disk of radius a sees whole from distance d: F = ½ (1 − 1/√(1 + (a/d)²)).
#[test]
fn ball_over_a_disk_is_cut_at_its_horizon() {
    let exact = 0.5 * (1.0 - 1.0 / 1.25f64.sqrt());
    for eps in [1e-2, 1e-4, 1e-8] {
        let shapes: [Arc<dyn Surface>; 2] =
            [Arc::new(ball(DVec3::ZERO, 0.5)), Arc::new(lid(2.0, false, 1.0))];
        for order in [0, 2] {
            let transport = Transport::unoccluded(shapes.to_vec(), order, eps);
            assert!((transport.factor(0, 1) - exact).abs() <= eps * exact, "{eps:e}");
            let swapped = Transport::unoccluded(shapes.iter().rev().cloned().collect(), order, eps);
            assert!((swapped.factor(1, 0) - exact).abs() <= eps * exact, "{eps:e}");
        }
        assert_eq!(Transport::unoccluded(shapes.to_vec(), 0, eps).factor(0, 0), 0.0, "a ball is convex");
    }
}

/// Between concentric spheres all that leaves the inner one reaches the outer one: F = 1, and back (r₁/r₂)².
#[test]
fn concentric_spheres() {
    for eps in [1e-2, 1e-4] {
        let shapes =
            vec![Arc::new(ball(DVec3::ZERO, 1.0)) as Arc<dyn Surface>, inside(ball(DVec3::ZERO, 2.0))];
        let transport = Transport::unoccluded(shapes, 0, eps);
        assert!((transport.factor(0, 1) - 1.0).abs() <= eps);
        assert!((transport.factor(1, 0) - 0.25).abs() <= 0.25 * eps);
    }
}

/// With the inner sphere as a blocker the outer one sees the share 1 − (r₁/r₂)² of itself.
#[test]
fn the_inner_of_two_spheres_hides_the_outer_from_itself() {
    let shapes = vec![Arc::new(ball(DVec3::ZERO, 1.0)) as Arc<dyn Surface>, inside(ball(DVec3::ZERO, 2.0))];
    let transport = Transport::new(shapes, 0, 2, 1e-2, Shadows::Rays);
    let count = transport.elements.list().len();
    let outer = count / 2..count;
    let seen: f64 = outer.clone().map(|j| transport.factor(outer.start, j)).sum();
    assert!((seen - 0.75).abs() < 0.02, "{seen}");
}

/// The hole of a ring is seen from within the ring past its other side in part only.
#[test]
fn a_ring_in_a_box_hides_itself() {
    let (p, half) = (DVec3::new, 2.0);
    let wall = |turn: DVec3, angle: f64| -> Arc<dyn Surface> {
        let floor = Parallelogram::new(p(-half, -half, -half), 2.0 * half * DVec3::X, 2.0 * half * DVec3::Y);
        let motion = Motion::new(DVec3::ZERO, turn, angle, 1.0).expect("an axis");
        Arc::new(Placed::new(Box::new(floor.expect("a square")), motion))
    };
    let mut shapes: Shapes = (0..4).map(|k| wall(DVec3::X, FRAC_PI_2 * f64::from(k))).collect();
    shapes.extend([wall(DVec3::Y, FRAC_PI_2), wall(DVec3::Y, -FRAC_PI_2)]);
    let axis = p(0.3, 0.2, 1.0);
    shapes.push(Arc::new(Torus::new(DVec3::ZERO, axis, 1.0, 0.4, FULL_TURN, FULL_TURN).expect("a ring")));
    let transport = Transport::new(shapes, 1, 1, 1e-3, Shadows::Rays);
    for i in 0..7 {
        let sum: f64 = (0..7).map(|j| transport.factor(i, j)).sum();
        assert!((sum - 1.0).abs() < 5e-3, "surface {i}: {sum}");
    }
}

/// F from a ball is the part of the full solid angle that is taken up as seen from its centre. A ball that
/// rests on the floor touches it where no rule holds: what was reached is reported.
#[test]
fn a_ball_on_the_floor_tells_what_it_reached() {
    let floor = Parallelogram::new(DVec3::new(-3.0, -3.0, 0.0), 6.0 * DVec3::X, 6.0 * DVec3::Y);
    let shapes = vec![Arc::new(ball(DVec3::Z, 1.0)) as Arc<dyn Surface>, Arc::new(floor.expect("a square"))];
    let exact = 0.9f64.asin() / PI;
    for eps in [1e-2, 1e-3] {
        let transport = Transport::unoccluded(shapes.clone(), 0, eps);
        let error = (transport.factor(0, 1) / exact - 1.0).abs();
        assert!(error <= 2.0 * eps.max(transport.blocks.statistics.accuracy_reached), "{eps:e}: {error:e}");
        assert!(error < 0.05, "{eps:e}: {error:e}");
    }
}

/// ∫ φ_k E dA of the polynomials of an element, E Lambert's form of a lamp, by many points on ever smaller
/// parts.
fn moments_under(element: &Element, lamp: &[DVec3]) -> Vec<f64> {
    let quarters = |patch: Patch| {
        let halves = patch.halves(Direction::Along);
        halves.iter().flat_map(|half| half.halves(Direction::Across)).collect::<Vec<_>>()
    };
    let parts =
        (0..6).fold(element.patches.clone(), |parts, _| parts.into_iter().flat_map(quarters).collect());
    let (basis, rule) = (&element.basis, UnitRule::of(4));
    let (mut sums, mut raw) = (vec![0.0; basis.len()], vec![0.0; basis.len()]);
    for part in &parts {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let x = part.node(s, t);
            basis.raw(basis.frame().coordinates(&x), &mut raw);
            let weight = ws * wt * x.area * irradiance(x.position, x.normal, lamp);
            sums.iter_mut().zip(&raw).for_each(|(sum, l)| *sum += weight * l);
        }
    }
    let rows = basis.transform().chunks_exact(basis.len());
    rows.map(|row| row.iter().zip(&sums).map(|(t, sum)| t * sum).sum()).collect()
}

/// A unit ball, in 4 × 4 elements of order 6, under a square lamp of constant exitance, of half the width
/// `half`.
fn lit_ball(half: f64) -> Scene {
    ball_and(6, 4, &lamp_above(half))
}

/// Each sees the other in part, through horizons, where few points would do for the kernel alone. Blocks of
/// the lamp with a column of the ball's elements, against Lambert's form; errors in units of the largest
/// entry beside the lamp.
#[test]
fn a_ball_under_a_wide_lamp_is_lit_to_the_accuracy_asked() {
    for half in [1.0, 2.0] {
        let scene = lit_ball(half);
        let elements = elements_of(&scene, 6, 1);
        let (lamp, receivers) = elements.list().split_last().expect("a lamp");
        let outline = lamp.patches[0].corners();
        let exact: Vec<Vec<f64>> =
            receivers[..4].iter().map(|element| moments_under(element, &outline)).collect();
        let entries = exact.iter().flatten().map(|moment| moment.abs() / lamp.area.sqrt());
        let largest = entries.fold(0.0, f64::max);
        let visibility = Visibility::open(&scene);
        for eps in [1e-3, 1e-5] {
            let accuracy = Accuracy { eps, shadow_eps: 1e-3 };
            let blocks = blocks_of(&elements, &visibility, accuracy);
            let found = blocks.iter().filter(|block| block.row < 4 && block.column == receivers.len());
            for PlacedBlock { row: i, values, .. } in found {
                let exact = exact[i].iter().map(|moment| moment / lamp.area.sqrt());
                let errors = values.iter().zip(exact).map(|(value, exact)| (value - exact).abs());
                let error = errors.fold(0.0, f64::max) / largest;
                assert!(error <= eps, "lamp {half}, {eps:e}, element {i}: {error:e}");
            }
        }
    }
}

/// Two curved walls and a lid that meet in edges of unequal length: the edges are cut where the others end.
#[test]
fn unequal_sectors_of_a_can_close_it() {
    let lids: [Arc<dyn Surface>; 2] = [Arc::new(lid(0.0, true, 1.0)), Arc::new(lid(2.0, false, 1.0))];
    let walls = [[0.0, 2.0], [2.0, 2.0 * PI]].map(|angle| inside(tube(1.0, 2.0, angle)));
    for eps in [1e-4, 1e-8] {
        let transport = Transport::unoccluded(walls.iter().chain(&lids).cloned().collect(), 1, eps);
        let error = furnace_error(&transport);
        assert!(error <= 10.0 * eps, "{eps:e}: {error:e}");
    }
}

fn any_shape() -> impl Strategy<Value = Arc<dyn Surface>> {
    let sheet = prop::collection::vec(-0.4..0.4f64, 16).prop_map(|lifts| -> Arc<dyn Surface> {
        let points = std::array::from_fn(|i| {
            std::array::from_fn(|j| DVec3::new(i as f64 / 3.0 - 0.5, j as f64 / 3.0 - 0.5, lifts[4 * i + j]))
        });
        Arc::new(Bezier::new(points).expect("a sheet"))
    });
    let ring = (0.2..0.4f64, 0.5..6.0f64, 0.5..6.0f64).prop_map(|(minor, turn, tube)| -> Arc<dyn Surface> {
        Arc::new(Torus::new(DVec3::ZERO, DVec3::Z, 0.6, minor, [0.0, turn], [0.0, tube]).expect("a ring"))
    });
    let cap = (-0.9..0.0f64, 0.1..0.9f64, 0.5..6.0f64).prop_map(|(low, high, turn)| -> Arc<dyn Surface> {
        Arc::new(Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [low, high], [0.0, turn]).expect("a cap"))
    });
    let tube = (0.3..1.0f64, 0.5..6.0f64).prop_map(|(radius, turn)| -> Arc<dyn Surface> {
        Arc::new(Cylinder::new(DVec3::ZERO, 0.8 * DVec3::Z, radius, [0.0, turn]).expect("a tube"))
    });
    (prop_oneof![sheet, ring, cap, tube], any::<bool>())
        .prop_map(|(shape, flip)| if flip { Arc::new(Flipped::new(Box::new(Shared(shape)))) } else { shape })
}

/// A shared surface where an owned one is asked for.
#[derive(Debug)]
struct Shared(Arc<dyn Surface>);

impl Surface for Shared {
    fn jet(&self, u: f64, v: f64) -> radiosity_geom::Jet {
        self.0.jet(u, v)
    }

    fn bounds(&self, rect: &radiosity_geom::Rect) -> radiosity_geom::Aabb {
        self.0.bounds(rect)
    }

    fn intersect(&self, ray: &radiosity_geom::Ray) -> Option<radiosity_geom::Hit> {
        self.0.intersect(ray)
    }
}

fn posed(shape: Arc<dyn Surface>, at: [f64; 3], axis: [f64; 3], angle: f64) -> Arc<dyn Surface> {
    let axis = DVec3::from_array(axis) + 2.0 * DVec3::Z;
    let motion = Motion::new(DVec3::from_array(at), axis, angle, 1.0).expect("a motion");
    Arc::new(Placed::new(Box::new(Shared(shape)), motion))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// Any two bent pieces apart: finite, 0 ≤ F ≤ 1, and the same whichever is the receiver.
    #[test]
    fn any_two_curved_pieces_exchange_a_share_both_ways_alike(
        first in any_shape(), second in any_shape(),
        at in prop::array::uniform3(-0.5..0.5f64), axis in prop::array::uniform3(-1.0..1.0f64),
        angle in 0.0..6.0f64, distance in 2.2..4.0f64,
    ) {
        let eps = 1e-2;
        let second = posed(second, [at[0], at[1], distance + at[2]], axis, angle);
        let there = Transport::unoccluded(vec![first.clone(), second.clone()], 1, eps);
        let back = Transport::unoccluded(vec![second, first], 1, eps);
        for transport in [&there, &back] {
            prop_assert!(transport.blocks.iter().all(|block| block.values.iter().all(|g| g.is_finite())));
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let factor = transport.factor(i, j);
                prop_assert!((-eps..=1.0 + eps).contains(&factor), "{} {}: {}", i, j, factor);
            }
        }
        let (forward, backward) = (there.factor(0, 1), back.factor(1, 0));
        prop_assert!((forward - backward).abs() <= 2.0 * eps * forward.max(1e-2), "{} {}", forward, backward);
    }
}
