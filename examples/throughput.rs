//! How many kernel samples a second the blocks take, pair kind by pair kind, on one core.
//!
//! `cargo run --release --example throughput`

#![allow(clippy::print_stdout, reason = "the table is what it is for")]

use std::time::Instant;

use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::scene::Scene;
use radiosity::solve::in_threads;
use radiosity::visibility::{Shadows, Visibility};

fn main() {
    println!(
        "{:<28} {:>5} {:>6} {:>9} {:>11} {:>11} {:>9} {:>10}",
        "empty box", "order", "eps", "pairs", "samples", "distinct", "ms", "ns/sample"
    );
    for (cuts, order, eps) in
        [(1, 4, 1e-4), (1, 8, 1e-4), (2, 4, 1e-4), (5, 4, 1e-3), (5, 6, 1e-3), (5, 8, 1e-4), (16, 0, 1e-3)]
    {
        measure(cuts, order, eps);
    }
}

fn measure(cuts: usize, order: usize, eps: f64) {
    let scene = Scene::builtin("empty-box").expect("the scene is built in");
    let visibility = Visibility::new(&scene, Shadows::Off);
    let how = Discretization::uniform(order, cuts);
    let elements = Elements::new(&scene, &how).expect("a box has area");
    let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
    let assemble = || Blocks::assemble(&elements, &visibility, accuracy, &|_, _| {});
    let (blocks, seconds) = in_threads(1, || {
        let warm = assemble();
        let start = Instant::now();
        let blocks = assemble();
        drop(warm);
        (blocks, start.elapsed().as_secs_f64())
    })
    .expect("one thread can be started");
    println!(
        "{:<28} {order:>5} {eps:>6.0e} {:>9} {:>11} {:>11} {:>9.2} {:>10.2}",
        format!("{cuts} x {cuts} a wall"),
        blocks.pairs.total,
        blocks.samples,
        blocks.distinct,
        1e3 * seconds,
        1e9 * seconds / blocks.distinct as f64
    );
}
