//! Matrices that are factored once and solve often.

use radiosity_solvers::cholesky::Cholesky;
use radiosity_solvers::lu::Lu;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Factored, Partition, Settings, SolveError};

use crate::systems::{Random, dominant, matrix, positive_definite};

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
                let b = random.vector(dim);
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
        let noise = random.vector(997);
        let a = matrix(Partition::points(dim), false, |i, j| match (i == j, (i + 1) % dim == j) {
            (true, _) => 0.0,
            (false, true) => 1.0,
            (false, false) => 0.5 * noise[(31 * i + 17 * j) % 997] / dim as f64,
        });
        let b = random.vector(dim);
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
