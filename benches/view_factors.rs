//! Cost of the exchange of two polygons, and of that of all cells of a box.

#![expect(clippy::print_stdout, reason = "whole boxes are timed once, and their accuracy told")]

use std::time::Instant;

use criterion::{Criterion, criterion_group, criterion_main};
use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::{Accuracy, polygon_exchange};
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::blocks_of;

type Quad = [DVec3; 4];

/// Cells per direction of a wall.
const CELLS: usize = 16;

fn quad(corners: [[f64; 3]; 4]) -> Quad {
    corners.map(DVec3::from_array)
}

/// Single pairs of unit squares.
fn single_pairs(criterion: &mut Criterion) {
    let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
    let above = |d: f64| quad([[0., 0., d], [0., 1., d], [1., 1., d], [1., 0., d]]);
    let wall = quad([[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]]);
    let tilted = quad([[0.2, 0.3, 1.0], [-0.3, 0.9, 1.1], [0.4, 1.4, 1.2], [0.9, 0.8, 1.1]]);
    let pairs = [
        ("hinge", wall),
        ("parallel, distance 1", above(1.0)),
        ("parallel, distance 0.1", above(0.1)),
        ("parallel, distance 8", above(8.0)),
        ("tilted, distance 1", tilted),
    ];
    for (name, other) in pairs {
        criterion.bench_function(&format!("unit squares, {name}"), |bench| {
            bench.iter(|| polygon_exchange(std::hint::black_box(&floor), std::hint::black_box(&other)));
        });
    }
}

/// The six walls of the unit box, each cut at the given places in both directions; normals point inwards.
fn box_cells(cuts: &[f64]) -> Vec<(usize, Quad)> {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut cells = Vec::new();
    for wall in 0..6 {
        let (normal, mut u, mut v) = (axes[wall % 3], axes[(wall + 1) % 3], axes[(wall + 2) % 3]);
        let origin = if wall < 3 { DVec3::ZERO } else { normal };
        if wall >= 3 {
            (u, v) = (v, u);
        }
        for a in cuts.windows(2) {
            for b in cuts.windows(2) {
                let corner = |s: f64, t: f64| origin + u * s + v * t;
                let corners =
                    [corner(a[0], b[0]), corner(a[1], b[0]), corner(a[1], b[1]), corner(a[0], b[1])];
                cells.push((wall, corners));
            }
        }
    }
    cells
}

/// All pairs of cells on different walls: prints the time per pair and the largest deviation of a row sum
/// from 1.
fn whole_box(name: &str, cuts: &[f64]) {
    let cells = box_cells(cuts);
    let area = |corners: &Quad| (corners[1] - corners[0]).cross(corners[3] - corners[0]).length();
    let mut sums = vec![0.0; cells.len()];
    let mut pairs = 0;
    let start = Instant::now();
    for (i, (wall, p)) in cells.iter().enumerate() {
        for (j, (other, q)) in cells.iter().enumerate().skip(i + 1) {
            if wall != other {
                let exchange = polygon_exchange(p, q);
                sums[i] += exchange / area(p);
                sums[j] += exchange / area(q);
                pairs += 1;
            }
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    let deviation = sums.iter().map(|sum: &f64| (sum - 1.0).abs()).fold(0.0, f64::max);
    println!(
        "{name}: {pairs} pairs in {seconds:.3} s, {:.0} ns per pair, row sums right to {deviation:.1e}",
        1e9 * seconds / f64::from(pairs)
    );
}

/// All 983 040 pairs of a box cut into 1536 cells, evenly and unevenly.
fn whole_boxes(_: &mut Criterion) {
    let even: Vec<f64> = (0..=CELLS).map(|k| k as f64 / CELLS as f64).collect();
    whole_box("box, 16 × 16 even cells per wall", &even);
    let jitter = |k: usize| if k.is_multiple_of(CELLS) { 0.0 } else { 0.3 * (2.4 * (k * k) as f64).sin() };
    let uneven: Vec<f64> = (0..=CELLS).map(|k| (k as f64 + jitter(k)) / CELLS as f64).collect();
    whole_box("box, 16 × 16 uneven cells per wall", &uneven);
}

/// Cost of the even box as a scene: what the blocks take beyond the exchange.
fn assembled_box(_: &mut Criterion) {
    let scene = builtin("empty-box");
    let how = Discretization::uniform(0, CELLS);
    let accuracy = Accuracy { eps: 1e-12, shadow_eps: 3e-3 };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be started");
    for shadows in [Shadows::Off, Shadows::Auto] {
        let visibility = Visibility::new(&scene, shadows, 1e-3);
        let start = Instant::now();
        let elements = Elements::new(&scene, &how).expect("a box has area");
        let cut = start.elapsed();
        let blocks = pool.install(|| blocks_of(&elements, &visibility, accuracy));
        println!(
            "blocks of the empty box, order 0, 16 × 16 cells per wall, {shadows:?}: elements {:.3} s, in all {:.3} s, \
             {} logarithms",
            cut.as_secs_f64(),
            start.elapsed().as_secs_f64(),
            blocks.statistics.distinct
        );
    }
}

criterion_group!(benches, single_pairs, whole_boxes, assembled_box);
criterion_main!(benches);
