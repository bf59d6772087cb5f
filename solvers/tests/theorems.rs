//! What holds for every method on every system.

use proptest::prelude::*;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Operator, Partition, Settings};

/// Strictly diagonally dominant by rows and columns: every method converges.
fn dominant(sizes: &[usize], entries: &[f64]) -> Dense {
    let partition = Partition::new(sizes);
    let dim = partition.dim();
    let values = (0..dim * dim)
        .map(|place| {
            let entry = entries[place % entries.len()] / dim as f64;
            if place % (dim + 1) == 0 { 2.0 + entry } else { 0.9 * entry }
        })
        .collect();
    Dense::new(partition, values, false).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

    #[test]
    fn all_methods_agree(
        sizes in prop::collection::vec(0..5usize, 1..9),
        entries in prop::collection::vec(-1.0..1.0f64, 97),
    ) {
        let a = dominant(&sizes, &entries);
        let dim = a.partition().dim();
        let truth: Vec<f64> = (0..dim).map(|i| 1.0 + i as f64).collect();
        let mut b = vec![0.0; dim];
        a.apply(&truth, &mut b);
        let settings = Settings { tolerance: 1e-13, ..Settings::default() };
        for method in Method::ALL {
            let mut x = vec![0.0; dim];
            let report = method.solver.solve(&a, &b, &mut x, &settings, &mut |_| ()).unwrap();
            prop_assert!(report.residual <= 1e-13);
            for (x, truth) in x.iter().zip(&truth) {
                prop_assert!((x - truth).abs() < 1e-10, "{}: {x} {truth}", method.name);
            }
        }
    }
}
