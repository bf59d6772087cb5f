//! Error of a block's power series, and its cost beside integrals.
//!
//! `cargo run --release -p radiosity-studies --bin series`
//!
//! Four pairs of quads, each along four directions: the largest error of an entry relative to the largest
//! entry, worst and median of the sixteen, and the bound that is told. Then the time of an expansion to N
//! orders on one core, in integrals of the same block.

#![allow(clippy::print_stdout, reason = "the tables are what it is for")]

use std::hint::black_box;
use std::time::Instant;

use radiosity::elements::{Discretization, Elements};
use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::published::series::{BlockSeries, Settings, TranslatedPair};
use radiosity::solve::in_threads;
use radiosity::visibility::Visibility;
use radiosity::{Material, Scene, SceneBuilder, Work};
use radiosity::{
    kernel::Accuracy,
    transport::{Demand, assemble},
};

/// Polynomials of total degree 4: blocks of 15 × 15.
const DEGREE: usize = 4;
const ORDERS: [usize; 5] = [2, 4, 6, 8, 12];
const STEPS: [f64; 6] = [0.05, 0.1, 0.2, 0.3, 0.4, 0.5];
/// Accuracy that chooses the points of the rules, so that only powers left out are seen.
const PRECISE: f64 = 1e-15;
const USUAL: f64 = 1e-4;

/// Origin and edges.
type Quad = [[f64; 3]; 3];

/// A lamp over a floor, over a wall's foot, beside a wall and askew before a wall, in lengths of a room of
/// about 1.
const PAIRS: [[Quad; 2]; 4] = [
    [[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], [[0.4, 0.3, 0.95], [0., 0.3, 0.], [0.3, 0., 0.]]],
    [[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], [[0.1, 0.1, 0.5], [0., 0.2, 0.], [0.2, 0., 0.]]],
    [[[0., 0., 0.], [0., 1., 0.], [0., 0., 0.8]], [[0.5, 0.4, 0.95], [0., 0.3, 0.], [0.3, 0., 0.]]],
    [[[0., 0., 0.], [0., 1., 0.], [0., 0., 0.8]], [[0.6, 0.3, 0.2], [0.1, 0.1, 0.4], [0., 0.3, 0.]]],
];
const DIRECTIONS: [[f64; 3]; 4] = [[1., 0., 0.], [0., 0., -1.], [0.6, 0.8, 0.], [0.48, 0.64, -0.6]];

fn main() {
    let done = in_threads(1, || {
        truncation();
        println!();
        costs();
    });
    done.expect("one thread can be started");
}

fn scene(quads: &[Quad; 2]) -> Scene {
    let mut builder = SceneBuilder::new("pair", ["grey"]);
    let material = Material::new(vec![0.5], vec![1.0]).expect("the reflectance is below 1");
    let grey = builder.material("grey", material);
    for (name, quad) in ["receiver", "emitter"].into_iter().zip(quads) {
        let [origin, along, across] = quad.map(DVec3::from_array);
        let shape = Parallelogram::new(origin, along, across).expect("edges are not parallel");
        builder.surface(name, shape, &grey);
    }
    builder.build().expect("the scene is valid")
}

fn cut(quads: &[Quad; 2]) -> Elements {
    Elements::new(&scene(quads), &Discretization::uniform(DEGREE, 1)).expect("quads have area")
}

fn pair(elements: &Elements, direction: DVec3) -> TranslatedPair<'_> {
    TranslatedPair::new(&elements.list()[0], &elements.list()[1], direction).expect("quads are flat")
}

fn largest(block: &[f64]) -> f64 {
    block.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Error of the series to each of [`ORDERS`] and its bound at each of [`STEPS`], relative to the largest
/// entry; None where part of the pair ceases to be seen before.
fn errors(elements: &Elements, direction: DVec3) -> Option<Vec<Vec<[f64; 2]>>> {
    let pair = pair(elements, direction);
    let expand = |centre: f64, orders: usize| {
        BlockSeries::new(&pair, centre, Settings { orders, tolerance: PRECISE }).ok()
    };
    let distance = expand(0.0, 0)?.convergence();
    let of_order = |orders: usize| {
        let series = expand(0.0, orders)?;
        let at = |h: &f64| {
            let p = h * distance;
            let exact = expand(p, 0)?.terms()[0].clone();
            let missed: Vec<f64> = series.sum(p).iter().zip(&exact).map(|(x, y)| x - y).collect();
            Some([largest(&missed), series.remainder(p)].map(|error| error / largest(&exact)))
        };
        STEPS.iter().map(at).collect()
    };
    ORDERS.iter().map(|orders| of_order(*orders)).collect()
}

fn truncation() {
    let mut found = Vec::new();
    for quads in &PAIRS {
        let elements = cut(quads);
        for direction in DIRECTIONS {
            found.extend(errors(&elements, DVec3::from_array(direction)));
        }
    }
    println!("{} of {} motions", found.len(), PAIRS.len() * DIRECTIONS.len());
    println!();
    let head: Vec<String> = ORDERS.iter().map(|orders| format!("N = {orders}")).collect();
    println!("| h | {} |", head.join(" | "));
    println!("| --- |{}", " --- |".repeat(ORDERS.len()));
    for (step, h) in STEPS.iter().enumerate() {
        let cell = |order: usize| {
            let sorted = |which: usize| {
                let mut values: Vec<f64> = found.iter().map(|of| of[order][step][which]).collect();
                values.sort_by(f64::total_cmp);
                values
            };
            let (missed, bounds) = (sorted(0), sorted(1));
            let middle = missed.len() / 2;
            format!("{:.0e}, {:.0e} (≤ {:.0e})", missed[missed.len() - 1], missed[middle], bounds[middle])
        };
        let row: Vec<String> = (0..ORDERS.len()).map(cell).collect();
        println!("| {h} | {} |", row.join(" | "));
    }
}

/// Seconds of one call: the least of some rounds.
fn seconds(mut call: impl FnMut()) -> f64 {
    const ROUNDS: usize = 7;
    const SECONDS: f64 = 0.02;
    let round = || {
        let (start, mut calls) = (Instant::now(), 0);
        while start.elapsed().as_secs_f64() < SECONDS {
            call();
            calls += 1;
        }
        start.elapsed().as_secs_f64() / f64::from(calls)
    };
    std::iter::repeat_with(round).take(ROUNDS).fold(f64::INFINITY, f64::min)
}

fn costs() {
    println!(
        "| pair | samples | integral, µs | N | radius/distance | expansion, integrals | sum, integrals | repaid after |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for (name, quads) in ["floor", "near floor", "wall"].into_iter().zip(&PAIRS) {
        let elements = cut(quads);
        let visibility = Visibility::open(&scene(quads));
        let accuracy = Accuracy { eps: 0.5 * USUAL, shadow_eps: 3e-3 };
        let integral = seconds(|| {
            black_box(assemble(Demand::all(&elements, &visibility, accuracy), None, &Work::alone()));
        });
        let pair = pair(&elements, DVec3::X);
        for orders in ORDERS {
            let settings = Settings { orders, tolerance: USUAL };
            let expand = || BlockSeries::new(&pair, 0.0, settings).expect("the quads face each other");
            let expansion = seconds(|| {
                black_box(expand());
            });
            let series = expand();
            let frame = seconds(|| {
                black_box(series.at(black_box(0.5 * series.radius())).expect("in the range"));
            });
            println!(
                "| {name} | {} | {:.1} | {orders} | {:.2} | {:.1} | 1/{:.0} | {:.0} |",
                series.samples(),
                1e6 * integral,
                series.radius() / series.convergence(),
                expansion / integral,
                integral / frame,
                (expansion / (integral - frame)).ceil()
            );
        }
    }
}
