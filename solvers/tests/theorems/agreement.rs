//! All methods find the same solution.

use proptest::prelude::*;
use radiosity_solvers::method::{Method, Needs};
use radiosity_solvers::{Dense, Granularity, Operator, Settings, Sweep};

use crate::exact::norm;
use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{dominant, enclosure, partition, positive_definite};

/// Relative difference allowed between any method and the known solution.
const AGREEMENT: f64 = 1e-10;

/// Solves A x = A t by `method` and compares with t.
fn finds(method: &Method, a: &Dense, truth: &[f64], settings: &Settings<'_>) -> Result<(), TestCaseError> {
    let mut b = vec![0.0; truth.len()];
    a.apply(truth, &mut b);
    let mut x = vec![0.0; truth.len()];
    let solved = method.solver.solve(a, &b, &mut x, settings, &mut |_| ());
    prop_assert!(solved.is_ok(), "{}: {:?}", method.name, solved);
    let difference: Vec<f64> = x.iter().zip(truth).map(|(x, truth)| x - truth).collect();
    let error = norm(&difference) / norm(truth);
    prop_assert!(error < AGREEMENT, "{}: {error:e}", method.name);
    Ok(())
}

/// Every way to run the relaxations; other methods take no notice.
fn variants(tolerance: f64) -> [Settings<'static>; 4] {
    let block = Settings::default().with_tolerance(tolerance).with_max_iterations(1_000_000);
    let coefficient = block.clone().with_granularity(Granularity::Coefficient);
    [block.clone().with_sweep(Sweep::Symmetric), block.clone().with_relaxation(1.2), coefficient, block]
}

/// Known properties of a system: symmetric and positive definite, dominant, of eigenvalues within 1 of 1.
#[derive(Clone, Copy, Default)]
struct System {
    symmetric: bool,
    dominant: bool,
    near_identity: bool,
}

/// Whether `method` is sure to converge on a system of which this much is known, with these settings.
fn suits(method: &Method, system: System, settings: &Settings<'_>) -> bool {
    let System { symmetric, dominant, near_identity } = system;
    match method.needs {
        Needs::Inverse => true,
        Needs::PositiveDefinite => symmetric,
        Needs::PositiveDefiniteOrDominant => symmetric || (dominant && settings.relaxation == 1.0),
        Needs::Dominant => dominant && settings.relaxation == 1.0,
        Needs::NearIdentity => near_identity && settings.relaxation == 1.0,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn on_dominant_systems(seed: u64, dim in 1..40usize, largest in 1..9usize) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, largest);
        let a = dominant(random, partition);
        let system = System { dominant: true, ..System::default() };
        let truth = random.numbers(dim);
        for settings in variants(1e-14) {
            for method in Method::ALL.iter().filter(|method| suits(method, system, &settings)) {
                finds(method, &a, &truth, &settings)?;
            }
        }
    }

    #[test]
    fn on_positive_definite_systems(seed: u64, dim in 1..30usize, largest in 1..9usize, floor in -2.5..0f64) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, largest);
        let a = positive_definite(random, partition, 10f64.powf(floor));
        let system = System { symmetric: true, ..System::default() };
        let truth = random.numbers(dim);
        for settings in variants(1e-13) {
            for method in Method::ALL.iter().filter(|method| suits(method, system, &settings)) {
                finds(method, &a, &truth, &settings)?;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(40) })]

    #[test]
    fn on_enclosures(seed: u64, dim in 2..24usize, largest in 1..9usize, loss in -3.0..0f64, symmetric: bool) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, largest);
        let a = enclosure(random, partition, [0.2, 1.0 - 10f64.powf(loss)], symmetric);
        let system = System { symmetric, dominant: !symmetric, near_identity: true };
        let truth: Vec<f64> = (0..dim).map(|_| random.unit()).collect();
        for settings in variants(1e-13) {
            for method in Method::ALL.iter().filter(|method| suits(method, system, &settings)) {
                finds(method, &a, &truth, &settings)?;
            }
        }
    }
}

#[test]
fn on_an_enclosure_that_loses_a_thousandth() {
    let random = &mut Random(1);
    for symmetric in [false, true] {
        let partition = partition(random, 12, 4);
        let a = enclosure(random, partition, [0.999, 0.999], symmetric);
        let system = System { symmetric, dominant: true, near_identity: true };
        let truth: Vec<f64> = (0..12).map(|_| random.unit()).collect();
        for settings in variants(1e-13) {
            for method in Method::ALL.iter().filter(|method| suits(method, system, &settings)) {
                finds(method, &a, &truth, &settings).unwrap();
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(50) })]

    #[test]
    fn several_right_hand_sides_are_solved_as_one_by_one(seed: u64, dim in 1..20usize, columns in 0..4usize) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, 5);
        let a = positive_definite(random, partition, 0.1);
        let b = random.numbers(dim * columns);
        let settings = Settings::default();
        for method in Method::ALL {
            let mut together = vec![0.0; b.len()];
            let reports = method.solver.solve_many(&a, &b, &mut together, &settings, &mut |_| ());
            if matches!(method.needs, Needs::Dominant | Needs::NearIdentity) && reports.is_err() {
                continue;
            }
            let reports = reports.unwrap();
            prop_assert_eq!(reports.len(), columns);
            for (column, report) in reports.iter().enumerate() {
                let range = column * dim..(column + 1) * dim;
                let mut alone = vec![0.0; dim];
                let single = method.solver.solve(&a, &b[range.clone()], &mut alone, &settings, &mut |_| ());
                prop_assert_eq!(&alone, &together[range]);
                prop_assert_eq!(&single.unwrap(), report);
            }
        }
    }
}
