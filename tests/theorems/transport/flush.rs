//! Flat things that lie flush on a floor hide what is under them, and a floor cuts what passes through it.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::elements::rule::UnitRule;
use radiosity::geom::shapes::{Cone, FULL_TURN, Sphere};
use radiosity::geom::{DVec3, Surface};
use radiosity::kernel::irradiance::visible_polygon::irradiance;
use radiosity::visibility::Shadows;
use radiosity_test_support::scenes::grey;
use radiosity_test_support::shapes::{ball, disk, faces, plate, tube};
use radiosity_test_support::solved::factors_of;

/// Edges of a room.
const ROOM: [f64; 3] = [2.0, 2.5, 2.0];
const FLOOR: usize = 4;

/// A thing whose footprint is a disk.
#[derive(Clone, Copy, Debug)]
enum Thing {
    /// A cone with its tip on top.
    Cone,
    /// A cone without its tip, open on top.
    Collar,
    /// The top of a ball.
    Cap,
    /// A wall with a lid on top.
    Can,
    /// A disk at this height.
    Disk,
}

impl Thing {
    fn shapes(self, base: DVec3, radius: f64, height: f64) -> Vec<Arc<dyn Surface>> {
        let axis = height * DVec3::Z;
        let cone = |top: f64| Cone::new(base, axis, radius, top, FULL_TURN).expect("a cone");
        let lid = Arc::new(disk(base + axis, DVec3::Z, radius));
        match self {
            Self::Cone => vec![Arc::new(cone(0.0))],
            Self::Collar => vec![Arc::new(cone(0.5 * radius))],
            Self::Cap => {
                let whole = (radius * radius + height * height) / (2.0 * height);
                let center = base + (height - whole) * DVec3::Z;
                vec![Arc::new(cap(center, whole, whole - height))]
            }
            Self::Can => vec![Arc::new(tube(base, axis, radius)), lid],
            Self::Disk => vec![lid],
        }
    }

    /// Part of the disk that it covers.
    fn share(self) -> f64 {
        if matches!(self, Self::Collar) { 0.75 } else { 1.0 }
    }
}

/// The part of a ball above a height over its centre.
fn cap(center: DVec3, radius: f64, from: f64) -> Sphere {
    Sphere::new(center, radius, DVec3::Z, [from, radius], FULL_TURN).expect("a part of a ball")
}

/// Rows of walls add up to 1 in a closed room, that of the floor to the part that is not covered: what is under the
/// thing sees its back alone.
#[test]
fn flat_things_hide_the_floor_under_them() {
    let [x, y, z] = ROOM;
    let eps = 1e-3;
    for thing in [Thing::Cone, Thing::Collar, Thing::Cap, Thing::Can, Thing::Disk] {
        for (place, radius) in [([0.9, 1.1], 0.4), ([0.42, 2.05], 0.4), ([1.0, 1.25], 0.95)] {
            for flatness in [1e-3, 1e-4, 1e-6] {
                let (mut builder, grey) = grey();
                let walls = faces(DVec3::ZERO, [x * DVec3::X, y * DVec3::Y, z * DVec3::Z]);
                for (k, wall) in walls.into_iter().enumerate() {
                    builder.surface(format!("wall {k}"), wall, &grey);
                }
                let base = DVec3::new(place[0], place[1], 0.0);
                for (k, part) in thing.shapes(base, radius, flatness * radius).into_iter().enumerate() {
                    builder.surface(format!("part {k}"), part, &grey);
                }
                let scene = builder.build().expect("the scene is valid");
                let found = factors_of(&scene, Shadows::Auto, eps, eps);
                let covered = thing.share() * PI * radius * radius / (x * y);
                // Light from beside the thing enters under a disk, and meets the walls of a collar.
                let slack = eps + 8.0 * flatness;
                for wall in 0..6 {
                    let right = if wall == FLOOR { 1.0 - covered } else { 1.0 };
                    let off = found.row(wall).into_iter().sum::<f64>() - right;
                    println!("{thing:?} {flatness:.0e} at {place:?}, wall {wall}: off by {off:.1e}");
                    assert!(
                        off.abs() <= slack,
                        "{thing:?} {flatness:.0e} at {place:?}, wall {wall}: off by {off:.1e}"
                    );
                }
            }
        }
    }
}

/// A wall sees a ball that sinks into a floor as it sees the part above.
#[test]
fn a_ball_that_sinks_into_a_floor_shines_from_above_it() {
    const EPS: f64 = 1e-2;
    let (radius, middle) = (0.237, DVec3::new(0.6, 0.6, 0.0));
    let wall = [DVec3::ZERO, 1.2 * DVec3::Y, DVec3::new(0.0, 1.2, 1.9), 1.9 * DVec3::Z];
    let (around, along) = (UnitRule::of(64), UnitRule::of(24));
    for step in 0..30 {
        let height = -0.22 + 0.015 * f64::from(step);
        let center = middle + height * DVec3::Z;
        let low = (-height).max(-radius);
        let mut right = 0.0;
        for (t, weight) in along.iter().flat_map(|t| around.iter().map(move |s| (t, s))).map(|(t, s)| {
            let ((sin, cos), z) = ((TAU * s.0).sin_cos(), low + (radius - low) * t.0);
            let across = (radius * radius - z * z).max(0.0).sqrt();
            (DVec3::new(across * cos, across * sin, z), s.1 * t.1)
        }) {
            right += weight * (radius - low) / (2.0 * radius) * irradiance(center + t, t / radius, &wall);
        }
        let (mut builder, grey) = grey();
        builder.surface("floor", plate(DVec3::ZERO, 1.2 * DVec3::X, 1.2 * DVec3::Y), &grey);
        builder.surface("wall", plate(wall[0], 1.2 * DVec3::Y, 1.9 * DVec3::Z), &grey);
        builder.surface("ball", ball(center, radius), &grey);
        let found = factors_of(&builder.build().expect("the scene is valid"), Shadows::Auto, EPS, EPS);
        let (off, told) = (found.factor(2, 1) - right, found.errors[2]);
        println!("{height:.3}: {right:.5}, off by {off:.1e}, told {told:.1e}");
        assert!(off.abs() <= EPS * right, "{height}: off by {off:.1e}, told {told:.1e}");
    }
}
