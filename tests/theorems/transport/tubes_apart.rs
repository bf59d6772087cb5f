//! Cylinders and cones apart that see each other past their horizons: their factors keep to what is told, against
//! sums over points of this test's own.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Cone, FULL_TURN};
use radiosity::visibility::Shadows;
use radiosity_test_support::scenes::grey;
use radiosity_test_support::solved::factors_of;

/// Points around and along.
const AROUND: usize = 240;
const ALONG: usize = 40;

/// Error of the sums over these, relative.
const OF_SUMS: f64 = 5e-5;

/// A cylinder or a cone, its front outside.
struct Tube {
    base: DVec3,
    axis: DVec3,
    radii: [f64; 2],
}

/// A point with its normal and the area that it stands for.
type Point = (DVec3, DVec3, f64);

impl Tube {
    fn points(&self) -> Vec<Point> {
        let ([low, high], up) = (self.radii, self.axis.normalize());
        let side = self.axis.length().hypot(high - low);
        let (x, y) = up.any_orthonormal_pair();
        let point = |i: usize, j: usize| {
            let (sin, cos) = (TAU * (i as f64 + 0.5) / AROUND as f64).sin_cos();
            let along = (j as f64 + 0.5) / ALONG as f64;
            let (out, radius) = (cos * x + sin * y, low + (high - low) * along);
            let normal = (self.axis.length() * out - (high - low) * up).normalize();
            let area = TAU * radius / AROUND as f64 * side / ALONG as f64;
            (self.base + along * self.axis + radius * out, normal, area)
        };
        (0..AROUND).flat_map(|i| (0..ALONG).map(move |j| point(i, j))).collect()
    }
}

/// F from the first to the second.
fn factor(first: &Tube, second: &Tube) -> f64 {
    let (ours, theirs) = (first.points(), second.points());
    let seen = |(x, n, area): &Point| -> f64 {
        let kernel = |(y, m, weight): &Point| {
            let way = y - x;
            let square = way.length_squared();
            weight * n.dot(way).max(0.0) * -m.dot(way).min(0.0) / (PI * square * square)
        };
        area * theirs.iter().map(kernel).sum::<f64>()
    };
    let area: f64 = ours.iter().map(|(_, _, area)| area).sum();
    ours.iter().map(seen).sum::<f64>() / area
}

#[test]
fn factors_of_tubes_that_see_each_other_past_horizons_keep_to_what_is_told() {
    let tube = |base: [f64; 3], axis: [f64; 3], radii| Tube { base: base.into(), axis: axis.into(), radii };
    let pairs = [
        [
            tube([-0.53, -0.79, -0.21], [-0.13, 0.02, -0.1], [0.038; 2]),
            tube([0.85, 0.66, 0.61], [0.42, -0.43, -0.27], [0.294; 2]),
        ],
        [
            tube([0.78, -0.2, 0.18], [0.46, -0.35, 0.02], [0.093; 2]),
            tube([-0.86, -0.36, 0.65], [0.11, 0.02, -0.17], [0.083; 2]),
        ],
        [
            tube([0.93, 0.12, -0.05], [-0.03, -0.11, -0.05], [0.037, 0.0]),
            tube([0.29, 0.99, -0.59], [0.02, -0.04, -0.15], [0.048, 0.0]),
        ],
    ];
    for [first, second] in &pairs {
        let right = factor(first, second);
        let (mut builder, grey) = grey();
        for (name, Tube { base, axis, radii: [low, high] }) in [("first", first), ("second", second)] {
            let wall = Cone::new(*base, *axis, *low, *high, FULL_TURN).expect("a wall");
            builder.surface(name, Arc::new(wall), &grey);
        }
        let scene = builder.build().expect("the scene is valid");
        for eps in [1e-3, 1e-4] {
            let found = factors_of(&scene, Shadows::Auto, eps, eps);
            let (off, told) = (found.factor(0, 1) / right - 1.0, found.errors[0] / right);
            println!("{eps:.0e}: off by {off:.1e}, told {told:.1e}");
            assert!(off.abs() <= 3.0 * told + OF_SUMS, "{eps:.0e}: off by {off:.1e}, told {told:.1e}");
        }
    }
}
