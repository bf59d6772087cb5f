//! Efficiency of ranks that share the exact blocks of a scene, for any number of them.
//!
//! ```text
//! cargo run --release -p radiosity-studies --bin ranks -- [SCENE …]
//! ```
//!
//! Each block is integrated once, and what it cost is recorded. The rule that shares blocks between ranks
//! (`crates/transport/src/schedule/balance.rs`) is then run for so many ranks, without any process: it sees
//! what it would see. Efficiency is the mean work of a rank over the time that all take, in which ranks wait
//! for each other after each round.

#![allow(clippy::print_stdout, reason = "the table is what it is for")]

use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::transport::{BlockWork, Cost, shared, work};
use radiosity::{Options, Scene};

/// Numbers of ranks.
const RANKS: [usize; 8] = [2, 3, 4, 10, 30, 100, 1000, 10_000];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    if names.is_empty() {
        names = ["cornell-box", "two-boxes", "temple"].map(str::to_owned).to_vec();
    }
    for name in names {
        let scene = radiosity::load(&name)?;
        let costs = costs(&scene)?;
        let Cost { samples, rays } = total(costs.iter().map(BlockWork::cost));
        println!("{name}: {} blocks, {samples} kernel samples, {rays} rays", costs.len());
        println!("{:>7} {:>10} {:>16} {:>13}", "ranks", "efficiency", "samples max/mean", "rays max/mean");
        for ranks in RANKS.into_iter().filter(|ranks| *ranks <= costs.len()) {
            row(ranks, &shared(&costs, ranks));
        }
        let mut dearest: Vec<f64> = costs.iter().map(|own| own.cost().in_samples()).collect();
        dearest.sort_by(|a, b| b.total_cmp(a));
        let all: f64 = dearest.iter().sum();
        let share = |count: usize| 100.0 * dearest.iter().take(count).sum::<f64>() / all;
        println!(
            "the dearest block costs {:.3} % of all, the dearest 1 % {:.1} %\n",
            share(1),
            share(costs.len() / 100)
        );
    }
    Ok(())
}

/// Costs of the blocks of a scene at default accuracy.
fn costs(scene: &Scene) -> Result<Vec<BlockWork>, Box<dyn std::error::Error>> {
    let options = Options::default();
    let visibility = options.visibility(scene);
    let subdivide = Subdivide::Auto { occluded: visibility.any_shadow(), near_layers: false };
    let Options { order, space, layers, .. } = options;
    let elements = Elements::new(scene, &Discretization { order, space, subdivide, layers })?;
    let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
    Ok(work(&elements, &sends, &visibility, options.accuracy()))
}

/// The sum of costs.
fn total(costs: impl Iterator<Item = Cost>) -> Cost {
    let mut sum = Cost::default();
    costs.for_each(|cost| sum += cost);
    sum
}

/// The row of so many ranks, of which each has done so much in each round.
fn row(ranks: usize, rounds: &[Vec<Cost>]) {
    let most = |of: &dyn Fn(&Cost) -> f64, done: &[Cost]| done.iter().map(of).fold(0.0, f64::max);
    let done: Vec<Cost> = (0..ranks).map(|rank| total(rounds.iter().map(|round| round[rank]))).collect();
    let mean = |of: &dyn Fn(&Cost) -> f64| done.iter().map(of).sum::<f64>() / ranks as f64;
    let excess = |of: &dyn Fn(&Cost) -> f64| most(of, &done) / mean(of).max(f64::MIN_POSITIVE);
    let cost = |own: &Cost| own.in_samples();
    let time: f64 = rounds.iter().map(|round| most(&cost, round)).sum();
    println!(
        "{ranks:>7} {:>10.3} {:>16.3} {:>13.3}",
        mean(&cost) / time,
        excess(&|own| own.samples as f64),
        excess(&|own| own.rays as f64)
    );
}
