//! Disks, rings, cylinders and cones that see polygons past a horizon: as exact as asked, and the same
//! however a scene lists its surfaces.

use std::f64::consts::TAU;
use std::fmt::Debug;
use std::sync::Arc;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use radiosity::scene::SceneBuilder;
use radiosity::solve::view_factors::ViewFactors;
use radiosity::visibility::Shadows;
use radiosity_geom::shapes::{Cone, FULL_TURN};
use radiosity_geom::{DVec3, Surface};
use radiosity_test_support::random::seeded;
use radiosity_test_support::scenes::material;
use radiosity_test_support::shapes::{ball, disk, plate, tube};
use radiosity_test_support::solved::factors_of;

use crate::transport::turned::{
    disks_over_a_floor, polygon_surface, rings_beside_polygons, tubes_beside_polygons,
};

type Shape = Arc<dyn Surface>;

/// Relative accuracies asked of each factor.
const ACCURACIES: [f64; 3] = [1e-3, 1e-4, 1e-6];
/// Largest difference of the factors of two listings, relative.
const SAME: f64 = 1e-12;

/// Largest relative difference where shadows of curved things are found by rays: sums over their hits are
/// kept in single precision.
const SAME_BY_RAYS: f64 = 1e-6;
/// Factors below this are not looked at: of so small ones less is asked.
const SMALLEST: f64 = 1e-6;
/// Error of the reference of tubes.
const TUBE_ERROR: f64 = 1e-5;

/// The factors of `shapes` listed in the given order, each named by its place among them.
fn factors(shapes: &[Shape], order: &[usize], eps: f64) -> ViewFactors {
    let mut builder = SceneBuilder::new("horizons", ["grey"]);
    let white = builder.material("white", material(0.5, 1.0));
    for index in order {
        builder.surface(format!("{index}"), Arc::clone(&shapes[*index]), &white);
    }
    let scene = builder.build().expect("the scene is valid");
    factors_of(&scene, Shadows::Auto, eps, 3e-3)
}

/// F from shape i to shape j.
fn factor(found: &ViewFactors, i: usize, j: usize) -> f64 {
    let place = |index: usize| found.names.iter().position(|name| *name == index.to_string());
    found.factor(place(i).expect("it is listed"), place(j).expect("it is listed"))
}

/// Compares the factor of two shapes in both listings with each other and, if it is known, with the exact
/// one: it may be off by the accuracy asked and `slack`.
fn compare(shapes: &[Shape; 2], exact: f64, slack: f64) -> Result<(), TestCaseError> {
    for eps in ACCURACIES {
        let listings = [[0, 1], [1, 0]].map(|order| factors(shapes, &order, eps));
        let [first, second] = listings.each_ref().map(|found| factor(found, 0, 1));
        prop_assert!(
            (first - second).abs() <= SAME * first,
            "{eps:e}: {first} listed first, {second} second"
        );
        prop_assert!((first - exact).abs() <= (eps + slack) * exact, "{eps:e}: {first} for {exact}");
        prop_assert!(listings[0].left_in_blocks <= eps, "{eps:e}: {:e} reached", listings[0].left_in_blocks);
    }
    Ok(())
}

/// Tries so many random cases.
fn each<T: Debug>(
    cases: u32,
    strategy: impl Strategy<Value = T>,
    check: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let seeded = seeded(cases, 6);
    TestRunner::new(seeded).run(&strategy, check).unwrap_or_else(|why| panic!("{why}"));
}

#[test]
fn rings_see_polygons_past_their_horizons_as_exactly_as_asked() {
    each(60, rings_beside_polygons(), |(ring, polygon)| {
        let exact = ring.exchange(&polygon) / ring.area();
        prop_assume!(exact > SMALLEST);
        compare(&[ring.surface(), polygon_surface(&polygon)], exact, 0.0)
    });
}

#[test]
fn disks_see_a_floor_past_their_horizons_as_exactly_as_asked() {
    each(40, disks_over_a_floor(), |(disk, floor)| {
        let exact = disk.exchange(&floor) / disk.area();
        prop_assume!(exact > SMALLEST);
        compare(&[disk.surface(), polygon_surface(&floor)], exact, 0.0)
    });
}

#[test]
fn tubes_see_polygons_past_their_horizons_as_exactly_as_asked() {
    each(30, tubes_beside_polygons(), |(tube, polygon)| {
        let exact = tube.exchange(&polygon) / tube.area();
        prop_assume!(exact > SMALLEST);
        compare(&[tube.surface(), polygon_surface(&polygon)], exact, TUBE_ERROR)
    });
}

/// Irradiance at `x`, over π times the radiance, from what it sees above its horizon of a convex polygon: Lambert's
/// form.
fn lambert(x: DVec3, n: DVec3, corners: &[DVec3; 4]) -> f64 {
    let mut seen = Vec::new();
    for k in 0..4 {
        let [a, b] = [corners[k], corners[(k + 1) % 4]].map(|corner| corner - x);
        let [above, next] = [a, b].map(|corner| corner.dot(n));
        seen.extend((above > 0.0).then_some(a));
        seen.extend((above * next < 0.0).then(|| a + above / (above - next) * (b - a)));
    }
    let side = |k: usize| {
        let [a, b] = [seen[k], seen[(k + 1) % seen.len()]];
        let across = a.cross(b);
        if across.length() > 0.0 {
            across.length().atan2(a.dot(b)) * across.dot(n) / across.length()
        } else {
            0.0
        }
    };
    ((0..seen.len()).map(side).sum::<f64>() / TAU).abs()
}

/// F of a cone, whose tip points away, to a rectangle before it, by the midpoint rule around it and along it.
fn of_cone(base: DVec3, axis: DVec3, radius: f64, corners: &[DVec3; 4]) -> f64 {
    const AROUND: usize = 3000;
    const ALONG: usize = 600;
    let [one, other] = [axis.any_orthogonal_vector().normalize(), axis.normalize()];
    let third = one.cross(other);
    let front = (corners[1] - corners[0]).cross(corners[3] - corners[0]);
    let mut sum = 0.0;
    for k in 0..AROUND {
        let (sin, cos) = (TAU * (k as f64 + 0.5) / AROUND as f64).sin_cos();
        let out = cos * one + sin * third;
        let n = (axis.length() * out + radius * other).normalize();
        for j in 0..ALONG {
            let from_tip = (j as f64 + 0.5) / ALONG as f64;
            let x = base + (1.0 - from_tip) * axis + from_tip * radius * out;
            if front.dot(x - corners[0]) > 0.0 {
                sum += from_tip * lambert(x, n, corners);
            }
        }
    }
    2.0 * sum / (AROUND * ALONG) as f64
}

/// A cone 6 mm beside a rectangle, whose first rule and its halves around the axis agree by chance: all parts of it
/// inherited that, and erred by 8e-4 for 4e-6 told.
#[test]
fn halves_that_agree_by_chance_are_looked_at_again() {
    let base = DVec3::new(0.043_147_534_001_594_13, -0.071_718_376_932_461_44, -0.055_204_771_316_107_105);
    let (axis, radius) = (-2.0 * base, 0.131_310_033_572_094_67);
    let origin = DVec3::new(-0.028_924_769_559_970_96, 0.160_089_820_400_648_8, 0.149_812_654_182_144_76);
    let edge1 = DVec3::new(0.170_039_799_938_434_88, 0.0, -0.240_191_567_358_438_47);
    let edge2 = DVec3::new(0.027_435_792_115_641_2, -0.157_510_705_982_938_9, 0.019_422_732_670_436_61);
    let corners = [origin, origin + edge1, origin + edge1 + edge2, origin + edge2];
    let right = of_cone(base, axis, radius, &corners);
    let cone = Cone::new(base, axis, radius, 0.0, FULL_TURN).expect("a cone");
    let shapes: [Shape; 2] = [Arc::new(cone), Arc::new(plate(origin, edge1, edge2))];
    for eps in [1e-3, 1e-5, 1e-6] {
        let found = factors(&shapes, &[0, 1], eps);
        let off = (found.factor(0, 1) - right).abs();
        assert!(
            off <= 3.0 * found.errors[0] + 3e-6 * right,
            "{eps:e}: {off:e} off, {:e} told",
            found.errors[0]
        );
    }
}

/// A room with a plate, two panels that stand on the floor, a ball, and a post with a lid, which hide each
/// other from it.
fn room() -> Vec<Shape> {
    let [x, y, z] = [4.0 * DVec3::X, 3.0 * DVec3::Y, 2.5 * DVec3::Z];
    let side = |origin, a, b| -> Shape { Arc::new(plate(origin, a, b)) };
    let post = DVec3::new(1.2, 1.1, 0.0);
    vec![
        side(DVec3::ZERO, x, y),
        side(z, y, x),
        side(DVec3::ZERO, z, x),
        side(y, x, z),
        side(DVec3::ZERO, y, z),
        side(x, z, y),
        side(DVec3::new(1.0, 0.9, 1.7), 0.8 * DVec3::Y, DVec3::new(0.9, 0.0, 0.1)),
        side(2.0 * DVec3::X, 1.3 * DVec3::Y, 2.0 * DVec3::Z),
        side(2.1 * DVec3::X, 1.8 * DVec3::Z, 1.1 * DVec3::Y),
        Arc::new(ball(DVec3::new(2.9, 1.8, 0.9), 0.5)),
        Arc::new(tube(post, DVec3::Z, 0.3)),
        Arc::new(disk(post + DVec3::Z, DVec3::Z, 0.3)),
    ]
}

#[test]
fn factors_do_not_depend_on_the_order_of_the_surfaces() {
    let shapes = room();
    let count = shapes.len();
    let listed = factors(&shapes, &(0..count).collect::<Vec<_>>(), 1e-3);
    let reversed: Vec<usize> = (0..count).rev().collect();
    let mixed: Vec<usize> = (0..count).map(|k| (5 * k + 3) % count).collect();
    for order in [reversed, mixed] {
        let other = factors(&shapes, &order, 1e-3);
        for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
            let [first, second] = [&listed, &other].map(|found| factor(found, i, j));
            assert!(
                (first - second).abs() <= SAME_BY_RAYS * first,
                "{order:?}: {i} to {j}: {first} and {second}"
            );
        }
    }
}
