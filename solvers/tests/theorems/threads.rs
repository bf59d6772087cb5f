//! The number of threads changes no bit.

use radiosity_solvers::method::Method;
use radiosity_solvers::{Operator, Partition, Settings};

use crate::systems::{Random, enclosure, matrix};

#[test]
fn of_products_and_iterations() {
    let random = &mut Random(13);
    let partition = random.partition(301, 20);
    let alone = enclosure(random, partition, (0.3, 0.9), true);
    let b = random.vector(301);
    for threads in [2, 3, 7] {
        let shared = alone.clone().with_threads(threads);
        for method in Method::ALL {
            let (mut x, mut y) = (vec![0.0; 301], vec![0.0; 301]);
            let first = method.solver.solve(&alone, &b, &mut x, &Settings::default(), &mut |_| ());
            let settings = Settings { threads, ..Settings::default() };
            let second = method.solver.solve(&shared, &b, &mut y, &settings, &mut |_| ());
            assert_eq!(x, y, "{} on {threads}", method.name);
            assert_eq!(first, second, "{} on {threads}", method.name);
        }
    }
}

#[test]
fn of_large_factorisations() {
    let random = &mut Random(17);
    for dim in [2000, 2113] {
        let entries = random.vector(4096);
        let size = dim as f64;
        let a = matrix(Partition::points(dim), true, |i, j| {
            let (low, high) = (i.min(j), i.max(j));
            entries[(low * 31 + high * 17) % 4096] / size + if i == j { 1.5 } else { 0.0 }
        });
        let truth = random.vector(dim);
        let mut b = vec![0.0; dim];
        a.apply(&truth, &mut b);
        for name in ["lu", "cholesky"] {
            let solve = |threads| {
                let mut x = vec![0.0; dim];
                let settings = Settings { threads, tolerance: 1e-13, ..Settings::default() };
                Method::named(name).unwrap().solver.solve(&a, &b, &mut x, &settings, &mut |_| ()).unwrap();
                x
            };
            let alone = solve(1);
            assert!(alone.iter().zip(&truth).all(|(x, truth)| (x - truth).abs() < 1e-10));
            assert_eq!(alone, solve(2), "{name} of {dim} on 2 threads");
            assert_eq!(alone, solve(4), "{name} of {dim} on 4 threads");
        }
    }
}
