//! Kernel samples a second of the blocks, pair kind by pair kind, on one core.
//!
//! `cargo run --release -p radiosity-studies --bin throughput`

#![allow(clippy::print_stdout, reason = "the table is what it is for")]

use std::time::Instant;

use radiosity::Work;
use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::Accuracy;
use radiosity::scene::Source;
use radiosity::solve::in_threads;
use radiosity::transport;
use radiosity::visibility::Visibility;

fn main() {
    println!("| scene | order | ε | pairs | samples in the rules | evaluated | ms | ns each |");
    println!("| --- | --- | --- | --- | --- | --- | --- | ---: |");
    for (cuts, order, eps) in
        [(1, 4, 1e-4), (1, 8, 1e-4), (2, 4, 1e-4), (5, 4, 1e-3), (5, 6, 1e-3), (5, 8, 1e-4), (16, 0, 1e-3)]
    {
        measure(cuts, order, eps);
    }
    for (order, eps) in [(4, 1e-4), (8, 1e-8)] {
        plain(order, eps);
    }
}

fn measure(cuts: usize, order: usize, eps: f64) {
    let scene = radiosity::builtin("empty-box").expect("the scene is built in");
    let visibility = Visibility::open(&scene);
    let how = Discretization::uniform(order, cuts);
    let elements = Elements::new(&scene, &how).expect("a box has area");
    let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
    let assemble = || {
        transport::assemble(transport::Demand::all(&elements, &visibility, accuracy), None, &Work::alone())
    };
    let (blocks, seconds) = in_threads(1, || {
        let warm = assemble();
        let start = Instant::now();
        let blocks = assemble();
        drop(warm);
        (blocks, start.elapsed().as_secs_f64())
    })
    .expect("one thread can be started");
    println!(
        "| empty box, {cuts} × {cuts} a wall | {order} | {eps:.0e} | {} | {} | {} | {:.2} | {:.1} |",
        blocks.statistics.pairs.total,
        blocks.statistics.samples,
        blocks.statistics.distinct,
        1e3 * seconds,
        1e9 * seconds / blocks.statistics.distinct as f64
    );
}

/// Two parallel squares one side apart: nothing but the tensor rule.
fn plain(order: usize, eps: f64) {
    const TIMES: u32 = 200;
    let squares = "bands = [\"grey\"]
[[surfaces]]
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
[[surfaces]]
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }";
    let scene = radiosity::language::read(&Source::new("squares", squares)).expect("the scene is valid");
    let visibility = Visibility::open(&scene);
    let elements = Elements::new(&scene, &Discretization::uniform(order, 1)).expect("squares have area");
    let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
    let (samples, seconds) = in_threads(1, || {
        let start = Instant::now();
        let mut samples = 0;
        for _ in 0..TIMES {
            samples += transport::assemble(
                transport::Demand::all(&elements, &visibility, accuracy),
                None,
                &Work::alone(),
            )
            .statistics
            .distinct;
        }
        (samples, start.elapsed().as_secs_f64())
    })
    .expect("one thread can be started");
    println!(
        "| parallel squares, {TIMES} times | {order} | {eps:.0e} | {TIMES} | {samples} | {samples} | {:.2} | {:.1} |",
        1e3 * seconds,
        1e9 * seconds / samples as f64
    );
}
