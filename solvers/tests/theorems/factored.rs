//! Matrices that are factored once and solve often.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use radiosity_solvers::cholesky::Cholesky;
use radiosity_solvers::lu::Lu;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Factored, Operator, Partition, Settings, SolveError, Stop};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{dominant, matrix, positive_definite};

#[test]
fn factors_find_what_the_method_finds_for_every_right_hand_side() {
    let random = &mut Random(41);
    let settings = Settings::default().with_condition(true);
    for dim in [1, 7, 130] {
        let a = positive_definite(random, Partition::points(dim), 0.2);
        let both: [(&str, Factored<'_>); 2] = [
            ("lu", Lu.factor(&a, &settings).unwrap()),
            ("cholesky", Cholesky.factor(&a, &settings).unwrap()),
        ];
        for (name, factored) in &both {
            for _ in 0..3 {
                let b = random.numbers(dim);
                let (mut x, mut y) = (vec![0.0; dim], vec![0.0; dim]);
                let report = factored.solve(&b, &mut x).unwrap();
                let solver = Method::named(name).unwrap().solver;
                let once = solver.solve(&a, &b, &mut y, &settings, &mut |_| ()).unwrap();
                assert_eq!(x, y, "{name} of {dim}");
                assert_eq!(report, once, "{name} of {dim}");
            }
        }
    }
}

#[test]
fn cholesky_factors_only_what_is_symmetric_and_positive_definite() {
    let settings = Settings::default();
    let unsymmetric = dominant(&mut Random(43), Partition::points(5));
    let refused = Cholesky.factor(&unsymmetric, &settings).map(|_| ());
    assert_eq!(refused, Err(SolveError::NotSymmetric { method: "cholesky" }));
    // The eigenvalue below 0 shows in the last column only, whichever panel that is in.
    for dim in [2, 60, 1025, 1100] {
        let a = matrix(Partition::points(dim), true, |i, j| match i == j {
            true if i == dim - 1 => -1.0,
            true => 1.0,
            false => 0.0,
        });
        let refused = Cholesky.factor(&a, &settings).map(|_| ());
        assert_eq!(refused, Err(SolveError::NotPositiveDefinite { method: "cholesky" }), "{dim}");
        assert!(Lu.factor(&a, &settings).is_ok(), "{dim}");
    }
}

#[test]
fn lu_needs_its_interchanges_in_every_panel() {
    // Zeros on the diagonal: the rows of a cyclic shift, plus a little.
    let random = &mut Random(47);
    for dim in [2, 50, 1023, 1025, 1500] {
        let noise = random.numbers(997);
        let a = matrix(Partition::points(dim), false, |i, j| match (i == j, (i + 1) % dim == j) {
            (true, _) => 0.0,
            (false, true) => 1.0,
            (false, false) => 0.5 * noise[(31 * i + 17 * j) % 997] / dim as f64,
        });
        let b = random.numbers(dim);
        let mut x = vec![0.0; dim];
        let report = Lu.factor(&a, &Settings::default()).unwrap().solve(&b, &mut x).unwrap();
        assert_eq!(report.iterations, 0, "{dim}: it was refined");
        let (truth, rounding) = crate::exact::residual(&a, &b, &x);
        assert!(truth <= rounding + 1e-13, "{dim}: {truth:e}");
    }
}

#[test]
fn lengths_are_asked_at_every_solve() {
    let a = dominant(&mut Random(53), Partition::points(4));
    let factored = Lu.factor(&a, &Settings::default()).unwrap();
    for (rows, unknowns) in [(3, 4), (4, 5), (0, 4)] {
        let solved = factored.solve(&vec![1.0; rows], &mut vec![0.0; unknowns]);
        assert!(matches!(solved, Err(SolveError::DimensionMismatch { expected: 4, .. })));
    }
}

#[test]
fn every_solve_asks_the_flag_and_the_time() {
    let a = dominant(&mut Random(59), Partition::points(4));
    let cancel = AtomicBool::new(false);
    let factored = Lu.factor(&a, &Settings::default().with_cancel(&cancel)).unwrap();
    let mut x = [0.0; 4];
    assert!(factored.solve(&[1.0; 4], &mut x).is_ok());
    cancel.store(true, Ordering::Relaxed);
    let solved = factored.solve(&[1.0; 4], &mut x);
    assert!(matches!(solved, Err(SolveError::Cancelled { .. })), "{solved:?}");
    for (name, solver) in [("lu", Method::LU.solver), ("cholesky", Method::CHOLESKY.solver)] {
        let a = positive_definite(&mut Random(61), Partition::points(4), 0.5);
        let pause = Duration::from_millis(40);
        let settings = Settings::default().with_time_budget(pause);
        let mut steps = 0;
        let solved = solver.solve_many(&a, &[1.0; 12], &mut [0.0; 12], &settings, &mut |_| {
            // The first column takes all the time; none is left for the others.
            std::thread::sleep(pause);
            steps += 1;
        });
        let is_late = matches!(solved, Err(SolveError::NotConverged { stop: Stop::Time, .. }));
        assert!(is_late && steps == 1, "{name}: {solved:?} after {steps} steps");
    }
}

/// A matrix of which the lower triangle is read as that of a symmetric one.
struct Lower<'a>(&'a Dense);

impl Operator for Lower<'_> {
    fn partition(&self) -> &Partition {
        self.0.partition()
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.0.shoot(column, x, y);
    }

    fn dense(&self) -> Option<&[f64]> {
        self.0.dense()
    }

    fn symmetric(&self) -> bool {
        true
    }
}

#[test]
fn refinement_reaches_what_the_factors_miss() {
    // The factors are those of L + D + Lᵀ, the matrix is L + D + 0.9 Lᵀ.
    let dim = 30;
    let a = matrix(Partition::points(dim), false, |i, j| match i.cmp(&j) {
        std::cmp::Ordering::Equal => 1.0,
        std::cmp::Ordering::Greater => 0.3 / dim as f64,
        std::cmp::Ordering::Less => 0.27 / dim as f64,
    });
    let mut x = vec![0.0; dim];
    let b = Random(67).numbers(dim);
    let report = Cholesky.factor(&Lower(&a), &Settings::default()).unwrap().solve(&b, &mut x).unwrap();
    assert!(report.iterations > 1, "{report:?}");
    assert!(report.history.is_sorted_by(|before, after| after < before), "{report:?}");
    let (truth, rounding) = crate::exact::residual(&a, &b, &x);
    assert!(truth <= 1e-10 + rounding, "{truth:e}");
}

#[test]
fn cholesky_reads_the_lower_triangle_alone() {
    for (dim, threads) in [(70, 1), (1100, 1), (2100, 2)] {
        let entry = |i: usize, j: usize| if i == j { 1.5 } else { ((i * j) % 7) as f64 / (8 * dim) as f64 };
        let a = matrix(Partition::points(dim), true, entry);
        let spoilt = matrix(Partition::points(dim), false, |i, j| if i < j { 1e300 } else { entry(i, j) });
        let settings = Settings::default().with_threads(threads).with_tolerance(1e300);
        let b = Random(71).numbers(dim);
        let (mut x, mut y) = (vec![0.0; dim], vec![0.0; dim]);
        Cholesky.factor(&a, &settings).unwrap().solve(&b, &mut x).unwrap();
        // The first solution, before the product with the whole matrix says that it is none.
        let _ = Cholesky.factor(&Lower(&spoilt), &settings).unwrap().solve(&b, &mut y);
        assert_eq!(x, y, "{dim}");
    }
}
