//! Light of far flat lamps over the cells of a grid, read by rays.

use std::f64::consts::PI;

use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::reading::grid::{Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::{Scene, SceneBuilder, Work};
use radiosity_test_support::scenes::{material, typed};

use super::by_rays::solved;

/// Exitance of the lamp of [`screened_lamp`], and its height over the floor.
const EXITANCE: f64 = 3.0;
const HEIGHT: f64 = 2.0;

/// A square lamp of the side .4 over a black floor, and half-way between both a screen that ends at x = `edge`.
fn screened_lamp(edge: f64) -> Scene {
    let mut builder = SceneBuilder::new("screen", ["grey"]);
    let glow = builder.material("glow", material(0.0, EXITANCE));
    let black = builder.material("black", material(0.0, 0.0));
    let square = |corner: DVec3, along: DVec3, across: DVec3| {
        Parallelogram::new(corner, along, across).expect("a parallelogram")
    };
    builder.surface("floor", square(DVec3::new(-0.5, -0.5, 0.0), DVec3::X, DVec3::Y), &black);
    builder.surface("lamp", square(DVec3::new(-0.2, -0.2, HEIGHT), 0.4 * DVec3::Y, 0.4 * DVec3::X), &glow);
    let corner = DVec3::new(edge - 6.0, -3.0, 0.5 * HEIGHT);
    builder.surface("screen", square(corner, 6.0 * DVec3::X, 6.0 * DVec3::Y), &black);
    builder.build().expect("a scene")
}

/// The mean irradiance of that floor, by midpoints of cells on both: a line from x to y crosses the plane of the screen
/// half-way.
fn of_screened_lamp(edge: f64) -> f64 {
    const N: usize = 40;
    let place = |k: usize| (k as f64 + 0.5) / N as f64 - 0.5;
    let mut sum = 0.0;
    for (a, b) in (0..N).flat_map(|a| (0..N).map(move |b| (place(a), 0.4 * place(b)))) {
        if 0.5 * (a + b) < edge {
            continue;
        }
        for (c, d) in (0..N).flat_map(|c| (0..N).map(move |d| (place(c), 0.4 * place(d)))) {
            let square = (a - b).powi(2) + (c - d).powi(2) + HEIGHT * HEIGHT;
            sum += (HEIGHT / square).powi(2);
        }
    }
    EXITANCE * 0.16 * sum / (std::f64::consts::PI * (N as f64).powi(4))
}

/// Light of a far lamp over a patch: exact where nothing or all of it is hidden, and else as well known as is told.
#[test]
fn a_far_lamp_behind_a_screen_lights_a_cell_as_is_told() {
    for (edge, eps) in [(-3.0, 2e-2), (3.0, 2e-2), (-0.1, 1e-2), (0.0, 5e-3), (0.12, 5e-3)] {
        let scene = screened_lamp(edge);
        let (outcome, visibility) = solved(&scene);
        let reader = Reader::by(GatherMethod::Rays, &outcome.solution, &visibility, ReadMode::Gather, eps);
        let cells = grid(&reader, [1, 1], Rates::default(), &Work::alone());
        let floor = scene.surface_named("floor").expect("it is there");
        let cell = cells.iter().find(|cell| cell.surface == floor).expect("a cell");
        let (found, exact) = (cell.irradiance[0], of_screened_lamp(edge));
        let told = cell.uncertainty.deviation.expect("rays know it").absolute;
        match edge {
            3.0 => assert_eq!((found, exact), (0.0, 0.0)),
            // Midpoints err by as much.
            -3.0 => assert!((found / exact - 1.0).abs() < 2e-4, "{found} {exact}"),
            _ => {
                assert!(
                    (found - exact).abs() < 3.0 * told + 2e-3 * exact,
                    "{edge}: {found} ± {told}, {exact}"
                );
                assert!(told < eps * exact, "{edge}: {found} ± {told}");
            }
        }
    }
}

/// Light of a far lamp over a wall that its plane cuts: what is behind the lamp gets none.
#[test]
fn a_lamp_sends_nothing_to_the_part_of_a_cell_behind_it() {
    // The middle of the upper cell is before the lamp, below its plane, and then behind it.
    for height in [2.4, 2.1] {
        let text = format!(
            "bands = [\"grey\"]\n[materials.black]\nreflectance = 0\n[materials.lamp]\nreflectance = 0\nemission = 1000\n\
             [[surfaces]]\nname = \"wall\"\nmaterial = \"black\"\n\
             quad = {{ vertices = [[0, 0, 0], [0, 4, 0], [0, 4, 3], [0, 0, 3]] }}\n\
             [[surfaces]]\nname = \"lamp\"\nmaterial = \"lamp\"\n\
             parallelogram = {{ origin = [1.5, 1.5, {height}], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}\n"
        );
        let scene = typed(&text);
        let (outcome, visibility) = solved(&scene);
        let reader = Reader::by(GatherMethod::Rays, &outcome.solution, &visibility, ReadMode::Gather, 5e-3);
        let cells = grid(&reader, [2, 2], Rates::default(), &Work::alone());
        let wall = scene.surface_named("wall").expect("it is there");
        for cell in cells.iter().filter(|cell| cell.surface == wall) {
            let middle = cell.position + scene.middle;
            let exact = on_wall_cell(height, [middle.y, middle.z]);
            let told = cell.uncertainty.deviation.expect("rays know it").absolute;
            let found = cell.irradiance[0];
            assert!(
                (found - exact).abs() < 3.0 * told + 2e-3 * exact,
                "{height}, {middle}: {found} ± {told}, {exact}"
            );
        }
    }
}

/// Mean irradiance of a cell of 2 × 1.5 about a point of that wall, by midpoints.
fn on_wall_cell(height: f64, [y, z]: [f64; 2]) -> f64 {
    const N: usize = 24;
    let place = |k: usize| (k as f64 + 0.5) / N as f64;
    let mut sum = 0.0;
    for (a, b) in (0..4 * N).flat_map(|a| (0..4 * N).map(move |b| (a, b))) {
        let step = |k: usize| (k as f64 + 0.5) / (4 * N) as f64 - 0.5;
        let drop = height - (z + 1.5 * step(b));
        if drop <= 0.0 {
            continue;
        }
        for (c, d) in (0..N).flat_map(|c| (0..N).map(move |d| (place(c), place(d)))) {
            let (off, aside) = (1.5 + c, 1.5 + d - (y + 2.0 * step(a)));
            sum += off * drop / (off * off + aside * aside + drop * drop).powi(2);
        }
    }
    1000.0 * sum / (PI * (16 * N * N * N * N) as f64)
}

/// A ball of the radius 0.2 hangs 2 over a floor and beside a post, on a thin stalk that covers little of it.
const BALL: &str = "bands = [\"grey\"]\n[materials.black]\nreflectance = 0\n[materials.lamp]\nreflectance = 0\n\
    emission = 1000\n[[surfaces]]\nname = \"floor\"\nmaterial = \"black\"\n\
    parallelogram = { origin = [-0.5, -0.5, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }\n\
    [[surfaces]]\nname = \"post\"\nmaterial = \"black\"\n\
    cylinder = { base = [1.2, 0, 1.5], axis = [0, 0, 1], radius = 0.3 }\n\
    [[surfaces]]\nname = \"lamp\"\nmaterial = \"lamp\"\nsphere = { center = [0, 0, 2], radius = 0.2 }\n\
    [[surfaces]]\nname = \"stalk\"\nmaterial = \"black\"\n\
    cylinder = { base = [0, 0, 3], axis = [0, 0, -0.8], radius = 0.006 }\n";

/// Irradiance from that ball at a point with the normal `normal`, by midpoints of latitude and longitude.
fn of_ball(point: DVec3, normal: DVec3) -> f64 {
    const N: usize = 48;
    let mut sum = 0.0;
    for (a, b) in (0..N).flat_map(|a| (0..2 * N).map(move |b| (a, b))) {
        // Even steps of z are even steps of area.
        let z = -1.0 + 2.0 * (a as f64 + 0.5) / N as f64;
        let (s, c) = (PI * (b as f64 + 0.5) / N as f64).sin_cos();
        let out = DVec3::new((1.0 - z * z).sqrt() * c, (1.0 - z * z).sqrt() * s, z);
        let step = DVec3::new(0.0, 0.0, 2.0) + 0.2 * out - point;
        sum += step.dot(normal).max(0.0) * (-step.dot(out)).max(0.0) / step.length_squared().powi(2);
    }
    1000.0 * 4.0 * 0.2 * 0.2 * sum / (2 * N * N) as f64
}

/// Light of a ball over a floor and over the cells of a round post, which turns away from it, as well known as is told,
/// and on the floor exact but for what the stalk covers.
#[test]
fn a_far_ball_lights_flat_and_curved_cells() {
    let scene = typed(BALL);
    let (outcome, visibility) = solved(&scene);
    let eps = 2e-2;
    let reader = Reader::by(GatherMethod::Rays, &outcome.solution, &visibility, ReadMode::Gather, eps);
    let cells = grid(&reader, [4, 1], Rates::default(), &Work::alone());
    let mut compared = 0;
    for cell in &cells {
        let name = scene.surfaces[cell.surface].name.as_str();
        if !["floor", "post"].contains(&name) {
            continue;
        }
        const N: usize = 24;
        let shape = outcome.solution.elements().shape(cell.surface);
        let points = (0..N * N).map(|k| {
            let share = |k: usize| (k as f64 + 0.5) / N as f64;
            let u = -1.0 + 0.5 * (cell.index[0] as f64 + share(k / N));
            let jet = shape.jet(u, -1.0 + 2.0 * share(k % N));
            of_ball(jet.position + scene.middle, jet.normal)
        });
        let exact = points.sum::<f64>() / (N * N) as f64;
        let told = cell.uncertainty.deviation.expect("rays know it").absolute;
        let found = cell.irradiance[0];
        let most = if name == "floor" { 2e-3 * exact } else { 3.0 * told + 5e-3 * exact };
        assert!((found - exact).abs() <= most, "{name} {:?}: {found} ± {told}, {exact}", cell.index);
        compared += 1;
    }
    assert_eq!(compared, 8);
}
