//! Hard systems: a method returns a residual that is true, or an error; never NaN, never without end.
//!
//! The large ones, up to 4000 unknowns, run with
//!
//!   cargo test --release -p radiosity-solvers --test theorems -- --ignored --nocapture

use std::time::{Duration, Instant};

use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Granularity, Preconditioner, Settings, SolveError, Sweep};

use crate::exact;
use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, exchange, matrix, partition, scaled};

/// Kinds of hard systems.
const KINDS: usize = 8;

/// A hard system of dimension `dim`.
fn hard(random: &mut Random, kind: usize, dim: usize) -> Dense {
    let partition = partition(random, dim, 91);
    let symmetric = random.below(2) == 0;
    match kind {
        // ρ up to 1 − 10⁻⁸.
        0 => {
            let loss = 10f64.powf(-8.0 * random.unit());
            enclosure(random, partition, [0.0, 1.0 - loss], symmetric)
        }
        // ρ = 1 − 10⁻⁸ everywhere.
        1 => enclosure(random, partition, [1.0 - 1e-8, 1.0 - 1e-8], symmetric),
        // Entries over 16 orders of magnitude.
        2 => {
            let a = enclosure(random, partition, [0.3, 0.9], symmetric);
            let mut scales = || (0..dim).map(|_| 10f64.powf(8.0 * random.signed())).collect::<Vec<_>>();
            let rows = scales();
            let columns = if symmetric { rows.clone() } else { scales() };
            scaled(&a, &rows, &columns, symmetric)
        }
        // Diagonal blocks of rank one but for rounding, in a system that may have an inverse.
        3 => {
            let parts = random.numbers(dim);
            let weak = exchange(random, dim);
            let blocks: Vec<usize> = (0..partition.len()).flat_map(|b| vec![b; partition.size(b)]).collect();
            matrix(partition, true, |i, j| {
                let (low, high) = (i.min(j), i.max(j));
                let rank_one = parts[low] * parts[high];
                if blocks[i] == blocks[j] { rank_one } else { 0.1 * weak[high * dim + low] }
            })
        }
        // No structure at all.
        4 => matrix(partition, false, |_, _| random.signed()),
        // Symmetric, indefinite.
        5 => {
            let entries = random.numbers(dim * dim);
            matrix(partition, true, |i, j| entries[i.min(j) * dim + i.max(j)])
        }
        // Singular: two equal rows.
        6 => {
            let mut entries = random.numbers(dim * dim);
            (0..dim).for_each(|j| entries[j * dim] = entries[j * dim + dim - 1]);
            matrix(partition, false, |i, j| entries[j * dim + i])
        }
        // Hilbert's matrix.
        _ => matrix(partition, true, |i, j| 1.0 / (i + j + 1) as f64),
    }
}

/// Settings that a caller may think of.
fn settings(random: &mut Random) -> Settings<'static> {
    Settings::default()
        .with_tolerance(if random.below(8) == 0 { 0.0 } else { 10f64.powf(-17.0 * random.unit()) })
        .with_max_iterations(1 + random.below(60))
        .with_time_budget(Duration::from_secs(5))
        .with_granularity(if random.below(2) == 0 { Granularity::Block } else { Granularity::Coefficient })
        .with_sweep(if random.below(2) == 0 { Sweep::Forward } else { Sweep::Symmetric })
        .with_relaxation(if random.below(2) == 0 { 1.0 } else { 0.1 + 1.8 * random.unit() })
        .with_preconditioner(if random.below(2) == 0 { Preconditioner::Block } else { Preconditioner::None })
        .with_restart(1 + random.below(30))
        .with_condition(random.below(4) == 0)
}

/// Runs one method and holds it to its word; returns whether it solved the system.
fn keeps_its_word(method: &Method, a: &Dense, b: &[f64], settings: &Settings<'_>) -> bool {
    let mut x = vec![0.0; b.len()];
    let started = Instant::now();
    let solved = method.solver.solve(a, b, &mut x, settings, &mut |step| assert!(!step.residual.is_nan()));
    assert!(started.elapsed() < HANG, "{} hangs", method.name);
    assert!(x.iter().all(|x| x.is_finite()), "{}: {solved:?}", method.name);
    let claimed = match &solved {
        Ok(report) => report.residual,
        Err(SolveError::NotConverged { residual, .. }) => *residual,
        Err(_) => return false,
    };
    let (truth, rounding) = exact::residual(a, b, &x);
    let honest = (claimed - truth).abs() <= rounding + 1e-12 * truth;
    assert!(honest, "{} claims {claimed:e}, truth {truth:e} ± {rounding:e}", method.name);
    assert_eq!(solved.is_ok(), claimed <= settings.tolerance, "{}", method.name);
    solved.is_ok()
}

/// Longest that one solve may take; some large ones do work of order dim³ on a machine with other things to
/// do.
const HANG: Duration = Duration::from_secs(300);

/// `count` systems of every kind, of dimension 1 to `largest`, the small ones more often.
#[expect(clippy::print_stdout, reason = "how many were solved is the outcome of the measurement")]
fn run(seed: u64, count: usize, largest: usize, methods: &[Method]) {
    let random = &mut Random(seed);
    let mut solved = vec![0; methods.len()];
    for case in 0..count * KINDS {
        let dim = if case == 0 { largest } else { 1 + (random.unit().powi(3) * largest as f64) as usize };
        let a = hard(random, case % KINDS, dim);
        let b = random.numbers(dim);
        let settings = settings(random);
        for (method, solved) in methods.iter().zip(&mut solved) {
            *solved += usize::from(keeps_its_word(method, &a, &b, &settings));
        }
    }
    for (method, solved) in methods.iter().zip(&solved) {
        println!("{:>12}: solved {solved} of {}", method.name, count * KINDS);
        assert!(*solved > 0 || count < 30, "{} solved nothing at all", method.name);
    }
}

#[test]
fn small_systems_by_the_thousand() {
    run(37, 600, 60, Method::ALL);
}

#[test]
fn medium_systems() {
    run(41, 4, 300, Method::ALL);
}

#[test]
#[ignore = "takes minutes"]
fn large_systems() {
    run(43, 3000, 90, Method::ALL);
    run(47, 30, 800, Method::ALL);
    run(53, 2, 4000, Method::ALL);
}
