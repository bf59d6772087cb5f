//! Which method is fastest for how many unknowns, what residual does it leave, and what does our care cost?
//!
//! A table of residuals and of interleaved overheads comes first, on standard output; criterion's times
//! follow. Run with `cargo bench -p radiosity-benches --bench solvers`; `README.md` keeps the figures.

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use faer::MatRef;
use faer::linalg::solvers::Solve;
use nalgebra::{DMatrix, DVector};
use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Partition, Report, Settings};
use radiosity_test_support::random::Random;
use radiosity_test_support::systems::enclosure;

/// Unknowns of the systems.
const SIZES: [usize; 4] = [100, 500, 1000, 2000];

/// Unknowns up to which the unblocked elimination of the yardstick is worth waiting for.
const SMALL: usize = 1000;

/// Blocks of ten unknowns, half to nine tenths of what arrives sent on, symmetrised.
fn system(dim: usize) -> (Dense, Vec<f64>) {
    let random = &mut Random(dim as u64);
    let a = enclosure(random, Partition::new(&vec![10; dim / 10]), [0.5, 0.9], true);
    (a, (0..dim).map(|_| random.unit()).collect())
}

fn solve(name: &str, a: &Dense, b: &[f64], threads: usize) -> Report {
    let mut x = vec![0.0; b.len()];
    let settings = Settings::default().with_threads(threads);
    let method = Method::named(name).expect("a name from the list");
    method.solver.solve(a, b, &mut x, &settings, &mut |_| ()).expect("a well-conditioned system")
}

fn nalgebra_lu(a: &Dense, b: &[f64]) {
    let matrix = DMatrix::from_column_slice(b.len(), b.len(), a.values());
    black_box(matrix.lu().solve(&DVector::from_column_slice(b)));
}

/// faer by its high-level interface, on the threads of the process.
fn faer_lu(a: &Dense, b: &[f64]) {
    let factored = MatRef::from(a).partial_piv_lu();
    black_box(factored.solve(MatRef::from_column_major_slice(b, b.len(), 1)));
}

fn timed(run: impl FnOnce()) -> Duration {
    let started = Instant::now();
    run();
    started.elapsed()
}

/// Shortest times of two functions that take turns, so that both meet the same disturbances.
fn duel(rounds: usize, mut one: impl FnMut(), mut other: impl FnMut()) -> (Duration, Duration) {
    let mut best = (Duration::MAX, Duration::MAX);
    for _ in 0..rounds {
        best.0 = best.0.min(timed(&mut one));
        best.1 = best.1.min(timed(&mut other));
    }
    best
}

#[expect(clippy::print_stdout, reason = "the tables are what the benchmark is for")]
fn tables() {
    println!("residual (iterations, products) of each method, and its time");
    for dim in SIZES {
        let (a, b) = system(dim);
        for method in Method::ALL {
            let mut report = None;
            let time = timed(|| report = Some(solve(method.name, &a, &b, 1)));
            let Report { residual, iterations, work, method: chosen, .. } = report.expect("just solved");
            println!(
                "{dim:>5} {:>12} {residual:.1e} ({iterations}, {work:.1}) {time:.2?} {chosen}",
                method.name
            );
        }
    }
    faer::set_global_parallelism(faer::Par::Seq);
    println!("shortest time of lu and of faer and nalgebra called directly, one thread, taking turns");
    for dim in SIZES {
        let (a, b) = system(dim);
        let (ours, theirs) = duel(40_000 / dim, || drop(solve("lu", &a, &b, 1)), || faer_lu(&a, &b));
        println!("{dim:>5} faer {ours:.2?} {theirs:.2?} {:.3}", ours.div_duration_f64(theirs));
        if dim <= SMALL {
            let (ours, theirs) = duel(40_000 / dim, || drop(solve("lu", &a, &b, 1)), || nalgebra_lu(&a, &b));
            println!("{dim:>5} nalgebra {ours:.2?} {theirs:.2?} {:.3}", ours.div_duration_f64(theirs));
        }
    }
}

fn bench(criterion: &mut Criterion) {
    tables();
    let mut group = criterion.benchmark_group("solve");
    group.sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    for dim in SIZES {
        let (a, b) = system(dim);
        for threads in [1, 2] {
            let shared = a.clone().with_threads(threads);
            for method in Method::ALL {
                let id = BenchmarkId::new(format!("{} on {threads}", method.name), dim);
                group.bench_function(id, |bencher| bencher.iter(|| solve(method.name, &shared, &b, threads)));
            }
        }
        if dim <= SMALL {
            group.bench_function(BenchmarkId::new("nalgebra lu", dim), |bencher| {
                bencher.iter(|| nalgebra_lu(&a, &b));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
