//! View factors that an inner corner hides in part, at high accuracies.
//!
//! `cargo run --release -p radiosity-studies --bin inner_corner` prints the errors of the factor from an end
//! of the L-shaped room of View3D's examples to the wall 3 away, against Gauss rules on the two smooth parts
//! of the wall. Terms are evaluations of the kernel, or of logarithms in contours; seconds are of wall time.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;

use radiosity::Work;
use radiosity::kernel::Accuracy;
use radiosity::solve::view_factors::{Options, ViewFactors};

const ROOM: &str = "crates/formats/tests/fixtures/l-room.vs3";

/// Ends of the two legs, and the walls that face them.
const PAIRS: [[&str; 2]; 2] = [["east-end", "west"], ["north-end", "south"]];

/// The factor of either pair.
const EXACT: f64 = 0.098_670_742_689_263_7;

const ACCURACIES: [f64; 5] = [1e-5, 1e-6, 1e-7, 1e-8, 1e-11];

fn main() -> Result<(), Box<dyn Error>> {
    let scene = radiosity::load(ROOM)?;
    let pair = |[from, to]: [&str; 2]| {
        Ok::<_, Box<dyn Error>>([scene.surface_named(from)?, scene.surface_named(to)?])
    };
    let pairs = PAIRS.into_iter().map(pair).collect::<Result<Vec<_>, _>>()?;
    println!("| ε | error | terms | s |");
    println!("| --- | --- | --- | --- |");
    for eps in ACCURACIES {
        let accuracy = Accuracy { eps, shadow_eps: eps };
        let options = Options { accuracy, threads: 0, ..Options::default() };
        let factors =
            ViewFactors::of_pairs(&scene, &|i, j| pairs.contains(&[i, j]), &options, &Work::alone())?;
        let errors = pairs.iter().map(|[i, j]| (factors.factor(*i, *j) / EXACT - 1.0).abs());
        let worst = errors.fold(0.0, f64::max);
        println!("| {eps:.0e} | {worst:.0e} | {} | {:.3} |", factors.samples, factors.elapsed.as_secs_f64());
    }
    Ok(())
}
