//! Sensors close to panes of glass before a sky, against quadrature over directions.
//!
//! ```text
//! E = ∫ L(ω) τ(cos θ') cos θ dω ,     tan θ' < r(φ)/h
//! ```
//!
//! at the height h before a pane whose border is r(φ) away in the direction φ along it.

use std::f64::consts::{PI, TAU};

use radiosity::light::direct::DirectLight;
use radiosity::light::penumbra::{Penumbra, RayEffort};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::solve::Options;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::sources::Sources;

/// Accuracy of readings by default.
const EPS: f64 = 1.25e-3;

/// Breadth and height of the pane, which stands at y = 0 and faces −y.
const PANE: [f64; 2] = [2.0, 1.5];

/// Radiance of a sky of 10 000 lx over level ground that reflects a fifth, uniform or overcast, in a unit direction.
fn radiance(is_even: bool, from: V) -> f64 {
    match from.z > 0.0 {
        true if is_even => 1e4 / PI,
        true => 1e4 * 9.0 / (7.0 * PI) * (1.0 + 2.0 * from.z) / 3.0,
        false => 0.2 * 1e4 / PI,
    }
}

/// Part of the light that this many panes of the index 1.52 let through by Fresnel's formulas; all of it without one.
fn transmittance(panes: u32, cosine: f64) -> f64 {
    let within = (1.0 - (1.0 - cosine * cosine) / (1.52 * 1.52)).sqrt();
    let across = ((cosine - 1.52 * within) / (cosine + 1.52 * within)).powi(2);
    let along = ((1.52 * cosine - within) / (1.52 * cosine + within)).powi(2);
    let through = |r: f64| (1.0 - r) / (1.0 + (2.0 * f64::from(panes) - 1.0) * r);
    if panes == 0 { 1.0 } else { 0.5 * (through(across) + through(along)) }
}

/// E at the place (s, t) of the pane at the height h before it.
fn right(panes: u32, is_even: bool, [s, t]: [f64; 2], h: f64, n: V) -> f64 {
    let (turns, rings) = (2000, 400);
    let at_turn = |k: usize| {
        let (sin, cos) = (TAU * (k as f64 + 0.5) / turns as f64).sin_cos();
        let to = |from: f64, side: f64, along: f64| {
            let room = if along > 0.0 { side - from } else { from };
            room / along.abs()
        };
        let border = to(s, PANE[0], cos).min(to(t, PANE[1], sin));
        let least = h / h.hypot(border);
        let at_ring = |j: usize| {
            // Evenly in u², where θ' is wide: cos θ' = u.
            let u = least + (1.0 - least) * (j as f64 + 0.5) / rings as f64;
            let across = (1.0 - u * u).sqrt();
            let into = V::new(across * cos, u, across * sin);
            radiance(is_even, into) * transmittance(panes, u) * into.dot(n).max(0.0)
        };
        (1.0 - least) * (0..rings).map(at_ring).sum::<f64>() / rings as f64
    };
    (0..turns).map(at_turn).sum::<f64>() * TAU / turns as f64
}

/// The largest error of sensors before a pane, over what is right, by cells and by a sum over them for rays.
fn largest(panes: u32, is_even: bool, random: &mut Random) -> f64 {
    let glass =
        if panes == 0 { "opening = true".to_owned() } else { format!("glass = {{ panes = {panes} }}") };
    let model = if is_even { "uniform" } else { "overcast" };
    let scene = typed(&format!(
        "bands = [\"lm\"]\n[sky]\nmodel = \"{model}\"\nilluminance = 10000\nground = 0.2\n[materials.air]\n\
         reflectance = 0\n[[surfaces]]\nname = \"pane\"\nmaterial = \"air\"\n{glass}\n\
         parallelogram = {{ origin = [0, 0, 0], edge1 = [{}, 0, 0], edge2 = [0, 0, {}] }}\n",
        PANE[0], PANE[1]
    ));
    let visibility = Options::default().visibility(&scene);
    let sources = Sources::of(&scene, &visibility);
    let emitters = sources.emitters();
    let direct = DirectLight::within(&emitters, &visibility, EPS);
    let rays = Penumbra::new(&emitters, &visibility, EPS);
    let off = |_| {
        let (place, h) = (PANE.map(|side| side * random.between(0.1, 0.9)), random.power(-6.0, -1.0));
        let n = (V::Y + random.between(0.0, 1.2) * random.direction()).normalize();
        let right = right(panes, is_even, place, h, n);
        let receiver = ReceiverPoint::free(V::new(place[0], -h, place[1]), n);
        let by_cells = direct.irradiance(&receiver, &direct.around(&receiver.site()))[0];
        let estimate = rays.estimate(&receiver, None, 0.0, RayEffort { error_factor: 1.0, sure: true });
        let exitance = |element: usize| emitters.coatings[0].exitance[element];
        let by_rays: f64 = estimate.factors.iter().map(|own| own.value * exitance(own.element)).sum();
        (by_cells / right - 1.0).abs().max((by_rays / right - 1.0).abs())
    };
    (0..15).map(off).fold(0.0, f64::max)
}

#[test]
fn sensors_close_to_panes_see_through_them() {
    let mut random = Random(9);
    for panes in 0..3 {
        for is_even in [true, false] {
            let off = largest(panes, is_even, &mut random);
            assert!(off < EPS, "{panes} panes, even: {is_even}: {off}");
        }
    }
}
