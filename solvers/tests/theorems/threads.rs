//! The number of threads changes no bit.

use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Operator, Partition, Settings};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, matrix, partition};

#[test]
fn of_products_and_iterations() {
    let random = &mut Random(13);
    let partition = partition(random, 301, 20);
    let alone = enclosure(random, partition, [0.3, 0.9], true);
    let b = random.numbers(301);
    for threads in [2, 3, 7] {
        let shared = alone.clone().with_threads(threads);
        for method in Method::ALL {
            let (mut x, mut y) = (vec![0.0; 301], vec![0.0; 301]);
            let first = method.solver.solve(&alone, &b, &mut x, &Settings::default(), &mut |_| ());
            let settings = Settings::default().with_threads(threads);
            let second = method.solver.solve(&shared, &b, &mut y, &settings, &mut |_| ());
            assert_eq!(x, y, "{} on {threads}", method.name);
            assert_eq!(first, second, "{} on {threads}", method.name);
        }
    }
}

/// Unknowns of factorisations on several threads: a last panel of one column twice (n = 1024 k + 1), and one
/// of 452.
const LARGE: [usize; 3] = [2049, 2500, 3073];

/// 3/2 I plus a symmetric matrix of row sums below 1.
fn large(dim: usize, random: &mut Random) -> Dense {
    let entries = random.numbers(4096);
    matrix(Partition::points(dim), true, |i, j| {
        let (low, high) = (i.min(j), i.max(j));
        entries[(low * 31 + high * 17) % 4096] / dim as f64 + if i == j { 1.5 } else { 0.0 }
    })
}

#[test]
fn of_large_factorisations() {
    let random = &mut Random(17);
    for dim in LARGE {
        let a = large(dim, random);
        let truths = random.numbers(3 * dim);
        let mut b = vec![0.0; 3 * dim];
        a.apply_many(&truths, &mut b);
        for name in ["lu", "cholesky"] {
            let solve = |columns: usize, threads: usize| {
                let mut x = vec![0.0; columns * dim];
                let settings = Settings::default().with_threads(threads).with_tolerance(1e-13);
                let solver = Method::named(name).unwrap().solver;
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| {
                    solver.solve_many(&a, &b[..x.len()], &mut x, &settings, &mut |_| ()).unwrap()
                });
                x
            };
            let alone = solve(3, 1);
            assert!(alone.iter().zip(&truths).all(|(x, truth)| (x - truth).abs() < 1e-10));
            assert_eq!(alone[..dim], solve(1, 1), "{name} of {dim}, one column alone");
            for threads in [2, 3] {
                assert_eq!(alone, solve(3, threads), "{name} of {dim} on {threads} threads");
                assert_eq!(
                    alone[..dim],
                    solve(1, threads),
                    "{name} of {dim} on {threads} threads, one column"
                );
            }
        }
    }
}
