//! Error of a block's power series, and its cost beside integrals.
//!
//! `cargo run --release -p radiosity-studies --bin series`
//!
//! Four pairs of quads, each along four directions and about four axes: the largest error of an entry relative
//! to the largest entry, worst and median, and the bound that is told. Then the time of an expansion to N
//! orders on one core, in integrals of the same block, and that of the series in three variables, which holds
//! for any displacement: how far, and after how many frames of a path that bends it is repaid. At last frames
//! of rooms in which something moves: CPU a frame and numbers of blocks, one after the other and by series.

#![allow(clippy::print_stdout, reason = "the tables are what it is for")]

mod displacement;
mod frames;

use std::hint::black_box;
use std::time::Instant;

use radiosity::elements::{Discretization, Elements};
use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::published::series::{BlockSeries, MovedPair, RelativeMotion, Settings};
use radiosity::solve::in_threads;
use radiosity::visibility::Visibility;
use radiosity::{Material, Scene, SceneBuilder, Work};
use radiosity::{
    kernel::Accuracy,
    transport::{Demand, assemble},
};

use displacement::DisplacementBlock;

/// Polynomials of total degree 4: blocks of 15 × 15.
const DEGREE: usize = 4;
const ORDERS: [usize; 5] = [2, 4, 6, 8, 12];
const STEPS: [f64; 6] = [0.05, 0.1, 0.2, 0.3, 0.4, 0.5];
/// Accuracy that chooses the points of the rules, so that only powers left out are seen.
const PRECISE: f64 = 1e-15;
const USUAL: f64 = 1e-4;
/// One precise integral.
const PRECISE_ONE: Settings = Settings { orders: 0, tolerance: PRECISE };

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
const NAMES: [&str; 4] =
    ["lamp over a floor", "nearer to its corner", "lamp beside a wall", "askew before a wall"];
const DIRECTIONS: [[f64; 3]; 4] = [[1., 0., 0.], [0., 0., -1.], [0.6, 0.8, 0.], [0.48, 0.64, -0.6]];

/// Axes: upright and level through the middle of the room, level along the lamp's side, and askew beside it.
const AXES: [[[f64; 3]; 2]; 4] = [
    [[0., 0., 1.], [0.5, 0.5, 0.5]],
    [[0., 1., 0.], [0.5, 0.5, 1.0]],
    [[1., 0., 0.], [0.5, 0.3, 0.95]],
    [[0.48, 0.64, -0.6], [0.9, 0.2, 0.7]],
];

fn main() {
    let done = in_threads(1, || {
        truncation(&DIRECTIONS.map(translation));
        println!();
        truncation(&AXES.map(rotation));
        println!();
        let motions = [("along x", translation([1., 0., 0.])), ("about its side", rotation(AXES[2]))];
        costs(&motions);
        println!();
        displacements();
    });
    done.expect("one thread can be started");
    println!();
    frames::frames();
}

fn translation(direction: [f64; 3]) -> RelativeMotion {
    RelativeMotion::Translation(DVec3::from_array(direction))
}

fn rotation(line: [[f64; 3]; 2]) -> RelativeMotion {
    let [axis, centre] = line.map(DVec3::from_array);
    RelativeMotion::Rotation { axis, centre }
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

fn pair(elements: &Elements, motion: RelativeMotion) -> MovedPair<'_> {
    MovedPair::new(&elements.list()[0], &elements.list()[1], motion).expect("quads are flat")
}

/// The p at which the variable of a series is the part h of that at `convergence`.
fn part(motion: &RelativeMotion, convergence: f64, h: f64) -> f64 {
    match motion {
        RelativeMotion::Translation(_) => h * convergence,
        RelativeMotion::Rotation { .. } => 2.0 * (h * (0.5 * convergence).tan()).atan(),
    }
}

fn largest(block: &[f64]) -> f64 {
    block.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Error of the series to each of [`ORDERS`] and its bound at each of [`STEPS`], relative to the largest
/// entry; None where part of the pair ceases to be seen before.
fn errors(elements: &Elements, motion: RelativeMotion) -> Option<Vec<Vec<[f64; 2]>>> {
    let pair = pair(elements, motion);
    let expand = |centre: f64, orders: usize| {
        BlockSeries::new(&pair, centre, Settings { orders, tolerance: PRECISE }).ok()
    };
    let convergence = expand(0.0, 0)?.convergence();
    let of_order = |orders: usize| {
        let series = expand(0.0, orders)?;
        let at = |h: &f64| {
            let p = part(&motion, convergence, *h);
            let exact = expand(p, 0)?.terms()[0].clone();
            let missed: Vec<f64> = series.sum(p).iter().zip(&exact).map(|(x, y)| x - y).collect();
            Some([largest(&missed), series.remainder(p)].map(|error| error / largest(&exact)))
        };
        STEPS.iter().map(at).collect()
    };
    ORDERS.iter().map(|orders| of_order(*orders)).collect()
}

fn truncation(motions: &[RelativeMotion]) {
    let mut found = Vec::new();
    for quads in &PAIRS {
        let elements = cut(quads);
        for motion in motions {
            found.extend(errors(&elements, *motion));
        }
    }
    println!("{} of {} motions", found.len(), PAIRS.len() * motions.len());
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

/// Seconds of one integral of the pair.
fn integral(quads: &[Quad; 2], elements: &Elements) -> f64 {
    let visibility = Visibility::open(&scene(quads));
    let accuracy = Accuracy { eps: 0.5 * USUAL, shadow_eps: 3e-3 };
    seconds(|| {
        black_box(assemble(Demand::all(elements, &visibility, accuracy), None, &Work::alone()));
    })
}

fn costs(motions: &[(&str, RelativeMotion)]) {
    println!("| pair | moved | integral, µs | N | samples | range | expansion | sum | repaid after |");
    println!("|{}", " --- |".repeat(9));
    for (name, quads) in NAMES.into_iter().zip(&PAIRS) {
        let elements = cut(quads);
        let integral = integral(quads, &elements);
        for (way, motion) in motions {
            let pair = pair(&elements, *motion);
            for orders in ORDERS {
                cost([name, way], integral, &pair, Settings { orders, tolerance: USUAL });
            }
        }
    }
}

fn cost([name, way]: [&str; 2], integral: f64, pair: &MovedPair, settings: Settings) {
    let Ok(series) = BlockSeries::new(pair, 0.0, settings) else { return };
    let expansion = seconds(|| {
        black_box(BlockSeries::new(pair, 0.0, settings).expect("it was expanded before"));
    });
    let frame = seconds(|| {
        black_box(series.at(black_box(0.5 * series.range().to)).expect("in the range"));
    });
    println!(
        "| {name} | {way} | {:.1} | {} | {} | {:.2} | {:.1} | 1/{:.0} | {:.0} |",
        1e6 * integral,
        settings.orders,
        series.samples(),
        series.radius() / series.convergence(),
        expansion / integral,
        integral / frame,
        (expansion / (integral - frame)).ceil()
    );
}

/// Total degrees of series in three variables.
const DEGREES: [usize; 3] = [2, 3, 4];
/// Frames of one turn around a circle whose radius is 0.3 of the distance.
const ROUND: [usize; 3] = [100, 400, 1600];

fn displacements() {
    println!("| pair | N | terms | samples | range over distance | expansion | frames in one range | gain |");
    println!("|{}", " --- |".repeat(8));
    // The other lamps do not see all of their walls.
    for (name, quads) in NAMES.into_iter().zip(&PAIRS).take(2) {
        let elements = cut(quads);
        let integral = integral(quads, &elements);
        for degree in DEGREES {
            displacement(name, integral, &elements, degree);
        }
    }
}

fn displacement(name: &str, integral: f64, elements: &Elements, degree: usize) {
    let ends = [&elements.list()[0], &elements.list()[1]];
    let distance = BlockSeries::new(&pair(elements, translation([1., 0., 0.])), 0.0, PRECISE_ONE);
    let distance = distance.expect("they face each other").convergence();
    let block = DisplacementBlock::new(ends, degree, 0.5, PRECISE);
    let share = reach(&block, elements, distance);
    let usual = || DisplacementBlock::new(ends, degree, share, 0.5 * USUAL);
    let expansion = seconds(|| {
        black_box(usual());
    });
    let block = usual();
    let sum = seconds(|| {
        black_box(block.at(black_box(DVec3::new(0.01, 0.02, -0.01))));
    });
    let [inside, gains]: [Vec<String>; 2] = {
        let inside = ROUND.map(|frames| {
            let step = std::f64::consts::TAU * 0.3 / frames as f64;
            1.0 + (2.0 * share / step).floor()
        });
        let gain = |frames: &f64| frames * integral / (expansion + frames * sum);
        [
            inside.iter().map(|n| format!("{n}")).collect(),
            inside.iter().map(|n| format!("{:.1}", gain(n))).collect(),
        ]
    };
    println!(
        "| {name} | {degree} | {} | {} | {share:.3} | {:.1} | {} | {} |",
        (degree + 1) * (degree + 2) * (degree + 3) / 6,
        block.samples,
        expansion / integral,
        inside.join(", "),
        gains.join(", ")
    );
}

/// The displacement over `distance` at which the largest error in any of the directions is [`USUAL`].
fn reach(block: &DisplacementBlock, elements: &Elements, distance: f64) -> f64 {
    let ways: Vec<DVec3> = DIRECTIONS.iter().map(|way| DVec3::from_array(*way)).collect();
    let error = |h: f64| {
        let of = |way: &DVec3| {
            let exact = BlockSeries::new(
                &pair(elements, RelativeMotion::Translation(*way)),
                h * distance,
                PRECISE_ONE,
            );
            let exact = exact.ok()?.terms()[0].clone();
            let missed: Vec<f64> =
                block.at(h * distance * *way).iter().zip(&exact).map(|(x, y)| x - y).collect();
            Some(largest(&missed) / largest(&exact))
        };
        ways.iter().filter_map(of).fold(0.0, f64::max)
    };
    let (mut low, mut high) = (0.0, 0.5);
    for _ in 0..12 {
        let middle = 0.5 * (low + high);
        *(if error(middle) <= USUAL { &mut low } else { &mut high }) = middle;
    }
    low
}
