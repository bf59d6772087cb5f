//! Rooms whose curved walls are convex: nothing hides anything there, which is found before any ray.

use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::solve::view_factors::Options;
use radiosity::visibility::Shadows;
use radiosity::{ViewFactors, Work};
use radiosity_test_support::scenes::typed;

fn room(surfaces: &[&str]) -> Scene {
    let surface = |shape: &&str| format!("[[surfaces]]\nmaterial = \"grey\"\n{shape}\n");
    let all: String = surfaces.iter().map(surface).collect();
    typed(&format!("materials.grey = {{ reflectance = 0.5 }}\n{all}"))
}

fn factors(scene: &Scene, eps: f64) -> ViewFactors {
    let accuracy = Accuracy { eps, shadow_eps: eps };
    let options = Options { subdivide: None, accuracy, shadows: Shadows::Auto, threads: 2 };
    ViewFactors::new(scene, &options, &Work::alone()).expect("the surfaces have areas")
}

/// F between two coaxial discs (Howell, C-41).
fn coaxial([from, to]: [f64; 2], distance: f64) -> f64 {
    let [a, b] = [from, to].map(|radius| radius / distance);
    let s = 1.0 + (1.0 + b * b) / (a * a);
    0.5 * (s - (s * s - 4.0 * (to / from).powi(2)).sqrt())
}

const BOTTOM: &str = "disk = { center = [0,0,0], normal = [0,0,1], radius = 1 }";

/// Cans, frusta and domes: no ray, and errors that fall with what is asked.
#[test]
fn no_ray_is_sent_where_walls_are_convex() {
    let lid = |radius: f64| format!("disk = {{ center = [0,0,2], normal = [0,0,-1], radius = {radius} }}");
    let wall = "flip = true\ncylinder = { base = [0,0,0], axis = [0,0,2], radius = 1 }";
    let halves = ["0, 180", "180, 360"].map(|angle| {
        format!("flip = true\ncylinder = {{ base = [0,0,0], axis = [0,0,2], radius = 1, angle = [{angle}] }}")
    });
    let slope = "flip = true\ncone = { base = [0,0,0], axis = [0,0,2], radius1 = 1, radius2 = 0.5 }";
    let dome = "flip = true\nsphere = { center = [0,0,0], radius = 1, axis = [0,0,1], z = [0,1] }";
    // Each with F from the bottom to the second surface.
    let rooms = [
        ("can", room(&[BOTTOM, &lid(1.0), wall]), coaxial([1.0, 1.0], 2.0)),
        ("halves", room(&[BOTTOM, &lid(1.0), &halves[0], &halves[1]]), coaxial([1.0, 1.0], 2.0)),
        ("frustum", room(&[BOTTOM, &lid(0.5), slope]), coaxial([1.0, 0.5], 2.0)),
        ("dome", room(&[BOTTOM, dome]), 1.0),
    ];
    for (name, room, exact) in rooms {
        for eps in [1e-2, 1e-4, 1e-6, 1e-8] {
            let found = factors(&room, eps);
            assert_eq!(found.rays, 0, "{name}, {eps}");
            let off = |value: f64, exact: f64| (value - exact).abs();
            let openness = found.row_sums().iter().map(|sum| off(*sum, 1.0)).fold(0.0, f64::max);
            let worst = openness.max(off(found.factor(0, 1), exact));
            assert!(worst <= 3.0 * eps, "{name}, {eps}: off by {worst:.1e}");
        }
    }
}

/// A disc that reaches out of a tube halfway up is seen from the bottom as far as the tube reaches.
#[test]
fn walls_hide_what_reaches_out() {
    let tube = "flip = true\ncylinder = { base = [0,0,0], axis = [0,0,2], radius = 1 }";
    let disc = "disk = { center = [0,0,1], normal = [0,0,-1], radius = 1.3 }";
    let found = factors(&room(&[BOTTOM, disc, tube]), 1e-3);
    let exact = coaxial([1.0, 1.0], 1.0);
    assert!((found.factor(0, 1) - exact).abs() < 3e-3, "{} {exact}", found.factor(0, 1));
    assert!(coaxial([1.0, 1.3], 1.0) - exact > 0.1, "a tube that hid nothing would not be noticed");
}
