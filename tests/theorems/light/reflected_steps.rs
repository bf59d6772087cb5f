//! Light that a floor reflects from a patch with sharp borders, against quadrature that is cut there.
//!
//! ```text
//! S(x) = ρ/π ∫_P E(y) cos θ cos θ' / d² dA_y
//! ```
//!
//! over the patch P that the sun lights through a window, where E = I sin e and Lambert's formula tells S, or the
//! disk below a spot, E = I d(γ) cos³ γ / h².

use std::f64::consts::{PI, TAU};

use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::solve::Options;
use radiosity::solve::gather::Gather;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

/// Accuracy of readings by default.
const EPS: f64 = 1.25e-3;

/// Reflectance, width and depth of the floor, one of whose corners is the origin.
const REFLECTANCE: f64 = 0.5;
const FLOOR: [f64; 2] = [4.0, 6.0];

fn scene_of(more: &str) -> String {
    let [width, depth] = FLOOR;
    format!(
        "bands = [\"lm\"]\nmaterials.grey = {{ reflectance = {REFLECTANCE} }}\nmaterials.black = {{ reflectance = 0 }}\n\
         {more}\n[[surfaces]]\nname = \"floor\"\nmaterial = \"grey\"\n\
         parallelogram = {{ origin = [0, 0, 0], edge1 = [{width}, 0, 0], edge2 = [0, {depth}, 0] }}\n"
    )
}

/// A sensor in the room that faces all of the floor, from above or from a wall.
fn sensor(random: &mut Random) -> [V; 2] {
    let [across, along, height] =
        [random.between(0.1, 3.9), random.between(0.1, 5.9), random.between(1.0, 3.0)];
    match random.below(3) {
        0 => [V::new(across, along, height), -V::Z],
        1 => [V::new(0.0, along, height), V::X],
        _ => [V::new(across, 6.0, height), -V::Y],
    }
}

/// The light at sensors (lx) that is gathered by cells.
fn gathered(text: &str, parts: usize, sensors: &[[V; 2]]) -> Vec<f64> {
    let scene = typed(text);
    let options = Options { subdivide: Some(parts), ..Options::default() };
    let (outcome, visibility) = (outcome_of(&scene, &options), options.visibility(&scene));
    let gather = Gather::new(&outcome.solution, &visibility, EPS);
    let reflected = |[x, n]: &[V; 2]| {
        let receiver = ReceiverPoint::free(*x, *n);
        let around = gather.reflection().around(&receiver.site());
        gather.reflection().irradiance(&receiver, &around, &[0.0])[0]
    };
    sensors.iter().map(reflected).collect()
}

/// The part of what a convex polygon radiates that arrives (Lambert's formula).
pub(super) fn factor(corners: &[V], x: V, n: V) -> f64 {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let side = |(a, b): (&V, &V)| {
        let [a, b] = [*a - x, *b - x].map(V::normalize);
        a.angle_between(b) * n.dot(a.cross(b).normalize())
    };
    sides.map(side).sum::<f64>().abs() / TAU
}

/// The largest relative error of some sensors.
fn largest_error(found: &[f64], exact: &[f64]) -> f64 {
    let errors = found.iter().zip(exact).map(|(found, exact)| (found / exact - 1.0).abs());
    errors.fold(0.0, f64::max)
}

/// The sun's patch is the window's shadow along its rays; the sky is black but for 1 part in 10⁷.
#[test]
fn the_patch_of_the_sun_is_cut_at_its_borders() {
    let random = &mut Random(5);
    let (mut worst, mut judged) = (0.0_f64, 0);
    for case in 0..15 {
        let [elevation, azimuth] = [random.between(25.0, 65.0), random.between(165.0, 195.0)];
        let [left, sill] = [random.between(0.3, 1.5), random.between(0.8, 1.2)];
        let [right, head] = [left + random.between(0.3, 2.0), sill + random.between(0.2, 1.2)];
        let [sine, turn] = [f64::sin(elevation.to_radians()), f64::to_radians(azimuth)];
        let towards =
            V::new(turn.sin(), turn.cos(), 0.0) * f64::cos(elevation.to_radians()) + V::new(0.0, 0.0, sine);
        let text = scene_of(&format!(
            "[sky]\nsun = {{ elevation = {elevation}, azimuth = {azimuth}, illuminance = 60000 }}\n\
             model = \"uniform\"\nilluminance = 1e-3\nground = 0\n[[surfaces]]\nname = \"window\"\nmaterial = \"black\"\n\
             opening = true\n\
             quad = {{ vertices = [[{left}, 0, {sill}], [{left}, 0, {head}], [{right}, 0, {head}], [{right}, 0, {sill}]] }}\n"
        ));
        let corners = [[left, sill], [left, head], [right, head], [right, sill]].map(|[x, z]| {
            let corner = V::new(x, 0.0, z);
            corner - towards * (z / sine)
        });
        let inside = |y: &V| y.x > 0.0 && y.x < FLOOR[0] && y.y > 0.0 && y.y < FLOOR[1];
        if !corners.iter().all(inside) {
            continue;
        }
        judged += 1;
        let sensors: Vec<[V; 2]> = (0..8).map(|_| sensor(random)).collect();
        let found = gathered(&text, 1 + case % 3, &sensors);
        let exact: Vec<f64> =
            sensors.iter().map(|[x, n]| REFLECTANCE * 60000.0 * sine * factor(&corners, *x, *n)).collect();
        worst = worst.max(largest_error(&found, &exact));
    }
    assert!(judged > 5, "{judged}");
    assert!(worst < 1.2e-2, "{worst:e}");
}

/// The disk below a spot, small or large beside the floor.
#[test]
fn the_disk_of_a_spot_is_cut_at_its_border() {
    let random = &mut Random(6);
    let mut worst: f64 = 0.0;
    for case in 0..15 {
        let [angle, edge, height] = [random.between(10.0, 40.0), 1.0, random.between(1.5, 2.9)];
        let [inner, outer] = [-1.0, 1.0].map(|side| f64::to_radians(0.5 * (angle + side * edge)));
        let radius = height * outer.tan();
        let middle = [0, 1].map(|k| random.between(radius, FLOOR[k] - radius));
        let [x, y] = middle;
        let text = scene_of(&format!(
            "[[luminaires]]\nposition = [{x}, {y}, {height}]\nspot = {{ angle = {angle}, edge = {edge} }}\nintensity = 1000\n"
        ));
        // Rings of equal width in the tangent, within the edge and in it.
        let light = |gamma: f64| match gamma <= inner {
            true => 1.0,
            false => 0.5 * (1.0 + (PI * (gamma - inner) / (outer - inner)).cos()),
        };
        let from = |[at, n]: &[V; 2]| {
            let disk = |[low, high]: [f64; 2], rings: usize| {
                let width = (high - low) / rings as f64;
                let ring = |k: usize| {
                    let r = low + (k as f64 + 0.5) * width;
                    let gamma = (r / height).atan();
                    let lit = 1000.0 * light(gamma) * gamma.cos().powi(3) / (height * height);
                    let turn = |j: usize| {
                        let (sin, cos) = (TAU * (j as f64 + 0.5) / 256.0).sin_cos();
                        let step = V::new(x + r * cos, y + r * sin, 0.0) - *at;
                        n.dot(step).max(0.0) * -step.z / step.length_squared().powi(2)
                    };
                    lit * r * width * (0..256).map(turn).sum::<f64>() * TAU / 256.0
                };
                (0..rings).map(ring).sum::<f64>()
            };
            let edge = [inner, outer].map(|angle| height * angle.tan());
            REFLECTANCE / PI * (disk([0.0, edge[0]], 128) + disk(edge, 32))
        };
        let sensors: Vec<[V; 2]> = (0..8).map(|_| sensor(random)).collect();
        let found = gathered(&text, 1 + case % 3, &sensors);
        let exact: Vec<f64> = sensors.iter().map(from).collect();
        worst = worst.max(largest_error(&found, &exact));
    }
    assert!(worst < 1.2e-2, "{worst:e}");
}
