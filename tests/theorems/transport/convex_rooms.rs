//! Rooms whose curved walls are convex: nothing hides anything there, which is found before any ray.

use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::solve::view_factors::Options;
use radiosity::{ViewFactors, Work};
use radiosity_test_support::scenes::typed;

fn room(surfaces: &[&str]) -> Scene {
    let surface = |shape: &&str| format!("[[surfaces]]\nmaterial = \"grey\"\n{shape}\n");
    let all: String = surfaces.iter().map(surface).collect();
    typed(&format!("materials.grey = {{ reflectance = 0.5 }}\n{all}"))
}

fn factors(scene: &Scene, eps: f64) -> ViewFactors {
    let accuracy = Accuracy { eps, shadow_eps: eps };
    let options = Options { accuracy, threads: 2, ..Options::default() };
    ViewFactors::new(scene, &options, &Work::alone()).expect("the surfaces have areas")
}

/// F between two coaxial discs (Howell, C-41).
fn coaxial([from, to]: [f64; 2], distance: f64) -> f64 {
    let [a, b] = [from, to].map(|radius| radius / distance);
    let s = 1.0 + (1.0 + b * b) / (a * a);
    0.5 * (s - (s * s - 4.0 * (to / from).powi(2)).sqrt())
}

const BOTTOM: &str = "disk = { center = [0,0,0], normal = [0,0,1], radius = 1 }";

/// A bicubic patch, turned over where `flip`, with the control point `at(i, j)` in row i.
fn patch(flip: bool, at: impl Fn(usize, usize) -> [f64; 3]) -> String {
    let net: [[[f64; 3]; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| at(i, j)));
    format!("flip = {flip}\nbezier = {{ points = {net:?} }}")
}

/// The coordinate of a control point, from −1 to 1.
fn place(k: usize) -> f64 {
    2.0 * k as f64 / 3.0 - 1.0
}

/// A barrel vault of length 3 over a floor and two walls, its ends bicubic patches: an extrusion, or a patch.
fn barrel(is_extruded: bool) -> Scene {
    let curve = [[-1.0, 1.0], [-0.5, 1.6], [0.5, 1.6], [1.0, 1.0]];
    let end = |y: f64, flip: bool| {
        patch(flip, |i, j| {
            let t = i as f64 / 3.0;
            [(1.0 - t) * place(j) + t * curve[j][0], y, t * curve[j][1]]
        })
    };
    let roof = match is_extruded {
        true => {
            let curve = curve.map(|[x, z]| [x, 0.0, z]);
            format!("flip = true\nextrusion = {{ curve = {curve:?}, direction = [0,3,0] }}")
        }
        false => patch(true, |i, j| [curve[i][0], j as f64, curve[i][1]]),
    };
    room(&[
        "parallelogram = { origin = [-1,0,0], edge1 = [2,0,0], edge2 = [0,3,0] }",
        "parallelogram = { origin = [-1,0,0], edge1 = [0,3,0], edge2 = [0,0,1] }",
        "parallelogram = { origin = [1,0,0], edge1 = [0,0,1], edge2 = [0,3,0] }",
        &end(0.0, false),
        &end(3.0, true),
        &roof,
    ])
}

/// A sail vault z = 1 + 0.15 (2 − x² − y²) over a square.
fn sail() -> Scene {
    // 1 − x² in Bernstein form of degree three.
    let bulge = |k: usize| 0.15 * [0.0, 4.0 / 3.0, 4.0 / 3.0, 0.0][k];
    let height = |i: usize, j: usize| (1.0 + bulge(j)) * i as f64 / 3.0;
    room(&[
        "parallelogram = { origin = [-1,-1,0], edge1 = [2,0,0], edge2 = [0,2,0] }",
        &patch(false, |i, j| [place(j), -1.0, height(i, j)]),
        &patch(true, |i, j| [place(j), 1.0, height(i, j)]),
        &patch(true, |i, j| [-1.0, place(j), height(i, j)]),
        &patch(false, |i, j| [1.0, place(j), height(i, j)]),
        &patch(true, |i, j| [place(i), place(j), 1.0 + bulge(i) + bulge(j)]),
    ])
}

/// Cans, frusta, domes and vaults: no ray, and errors that fall with what is asked.
#[test]
fn no_ray_is_sent_where_walls_are_convex() {
    let disk = |height: f64, radius: f64| {
        format!("disk = {{ center = [0,0,{height}], normal = [0,0,-1], radius = {radius} }}")
    };
    let lid = |radius: f64| disk(2.0, radius);
    let wall = "flip = true\ncylinder = { base = [0,0,0], axis = [0,0,2], radius = 1 }";
    let halves = ["0, 180", "180, 360"].map(|angle| {
        format!("flip = true\ncylinder = {{ base = [0,0,0], axis = [0,0,2], radius = 1, angle = [{angle}] }}")
    });
    let slope = |radius: f64| {
        format!("flip = true\ncone = {{ base = [0,0,0], axis = [0,0,2], radius1 = 1, radius2 = {radius} }}")
    };
    let dome = "flip = true\nsphere = { center = [0,0,0], radius = 1, axis = [0,0,1], z = [0,1] }";
    let bell = "flip = true\nrevolution = { curve = [[1,0,0],[1,0,0.7],[0.6,0,1.2],[0,0,1.2]], \
                center = [0,0,0], axis = [0,0,1] }";
    let rim = "flip = true\ntorus = { center = [0,0,0], axis = [0,0,1], major = 0.6, minor = 0.4, \
               tube_angle = [0,90] }";
    // Each with F from the first to the second surface, where that has a closed form.
    let rooms = [
        ("can", room(&[BOTTOM, &lid(1.0), wall]), Some(coaxial([1.0, 1.0], 2.0))),
        ("halves", room(&[BOTTOM, &lid(1.0), &halves[0], &halves[1]]), Some(coaxial([1.0, 1.0], 2.0))),
        ("frustum", room(&[BOTTOM, &lid(0.5), &slope(0.5)]), Some(coaxial([1.0, 0.5], 2.0))),
        ("funnel", room(&[BOTTOM, &lid(0.05), &slope(0.05)]), Some(coaxial([1.0, 0.05], 2.0))),
        ("dome", room(&[BOTTOM, dome]), Some(1.0)),
        ("bell", room(&[BOTTOM, bell]), Some(1.0)),
        ("tin", room(&[BOTTOM, &disk(0.4, 0.6), rim]), Some(coaxial([1.0, 0.6], 0.4))),
        ("barrel", barrel(true), None),
        ("barrel of a patch", barrel(false), None),
        ("sail", sail(), None),
    ];
    for (name, room, exact) in rooms {
        for eps in [1e-2, 1e-4, 1e-6, 1e-8] {
            let found = factors(&room, eps);
            assert_eq!(found.rays, 0, "{name}, {eps}");
            let off = |value: f64, exact: f64| (value - exact).abs();
            let openness = found.row_sums().iter().map(|sum| off(*sum, 1.0)).fold(0.0, f64::max);
            let worst = openness.max(exact.map_or(0.0, |exact| off(found.factor(0, 1), exact)));
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

/// A rectangle behind a disc, with its edge in the disc's plane, gets nothing from there; no ray is sent to
/// find it.
#[test]
fn what_lies_behind_a_disc_is_left_out() {
    let found = factors(
        &room(&[
            "parallelogram = { origin = [0,0,0], edge1 = [0.5,0,0], edge2 = [0,1,0] }",
            "cylinder = { base = [0.25,0,0.1], axis = [0,1,0], radius = 0.05 }",
            "disk = { center = [0.25,0,0.1], normal = [0,-1,0], radius = 0.05 }",
            "disk = { center = [0.25,1,0.1], normal = [0,1,0], radius = 0.05 }",
        ]),
        1e-5,
    );
    assert_eq!((found.rays, found.factor(0, 2), found.factor(0, 3)), (0, 0.0, 0.0));
}
