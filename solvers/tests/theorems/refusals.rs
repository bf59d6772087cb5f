//! Every error is provoked, and a lying operator is found out.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use radiosity_solvers::method::{Method, Needs};
use radiosity_solvers::{Dense, Operator, Partition, Report, Settings, SolveError, Stop};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, matrix, positive_definite};

fn dense(dim: usize, values: &[f64], symmetric: bool) -> Dense {
    // Given row by row, for the eye.
    matrix(Partition::points(dim), symmetric, |i, j| values[i * dim + j])
}

fn solve(name: &str, a: &dyn Operator, b: &[f64], settings: &Settings<'_>) -> Result<Report, SolveError> {
    let mut x = vec![0.0; b.len()];
    Method::named(name).unwrap().solver.solve(a, b, &mut x, settings, &mut |_| ())
}

/// Fault of an operator.
#[derive(Clone, Copy, PartialEq)]
enum Lie {
    /// Calls an unsymmetric matrix symmetric.
    Symmetry,
    /// Writes NaN into products.
    Nan,
    /// Does not write the last entry of its output.
    Short,
    /// Says it holds all entries, and holds fewer.
    Size,
    /// Products and columns belong to different matrices.
    Inconsistent,
}

struct Liar {
    truth: Dense,
    lie: Lie,
}

impl Liar {
    fn spoil(&self, y: &mut [f64], before: f64) {
        let Some(last) = y.last_mut() else { return };
        match self.lie {
            Lie::Nan => *last = f64::NAN,
            Lie::Short => *last = before,
            Lie::Symmetry | Lie::Size | Lie::Inconsistent => {}
        }
    }
}

impl Operator for Liar {
    fn partition(&self) -> &Partition {
        self.truth.partition()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let before = y[y.len() - 1];
        self.truth.apply(x, y);
        if self.lie == Lie::Inconsistent {
            y.iter_mut().zip(x).for_each(|(y, x)| *y += 0.5 * x);
        }
        self.spoil(y, before);
    }

    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        let before = y[y.len() - 1];
        self.truth.gather(row, x, y);
        self.spoil(y, before);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.truth.shoot(column, x, y);
        if self.lie == Lie::Nan {
            y[0] = f64::NAN;
        }
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        let before = out[out.len() - 1];
        self.truth.diagonal(block, out);
        self.spoil(out, before);
    }

    fn dense(&self) -> Option<&[f64]> {
        (self.lie == Lie::Size).then(|| &self.truth.values()[1..])
    }

    fn symmetric(&self) -> bool {
        self.lie == Lie::Symmetry || self.truth.symmetric()
    }
}

fn liar(lie: Lie) -> Liar {
    let random = &mut Random(3);
    let partition = Partition::new(&[2, 3, 1, 4]);
    let symmetric = lie != Lie::Symmetry;
    Liar { truth: enclosure(random, partition, [0.5, 0.9], symmetric), lie }
}

#[test]
fn lengths_must_agree() {
    let a = dense(2, &[1.0, 0.0, 0.0, 1.0], true);
    for method in Method::ALL {
        for (rows, unknowns) in [(3, 2), (1, 2), (2, 3), (0, 2), (4, 4)] {
            let (b, mut x) = (vec![1.0; rows], vec![0.0; unknowns]);
            let solved = method.solver.solve(&a, &b, &mut x, &Settings::default(), &mut |_| ());
            assert!(
                matches!(solved, Err(SolveError::DimensionMismatch { expected: 2, .. })),
                "{}",
                method.name
            );
        }
        let (b, mut x) = (vec![1.0; 3], vec![0.0; 3]);
        let solved = method.solver.solve_many(&a, &b, &mut x, &Settings::default(), &mut |_| ());
        assert!(matches!(solved, Err(SolveError::DimensionMismatch { expected: 4, .. })), "{}", method.name);
    }
    let short = Dense::new(Partition::points(2), vec![0.0; 3], false);
    assert!(matches!(short, Err(SolveError::DimensionMismatch { expected: 4, found: 3, .. })));
    let measure = Settings::default().with_measure(&[1.0]);
    let solved = solve("southwell", &a, &[1.0, 1.0], &measure);
    assert!(matches!(solved, Err(SolveError::DimensionMismatch { expected: 2, found: 1, .. })));
}

#[test]
fn numbers_must_be_finite() {
    let entries = vec![1.0, f64::NAN, 0.0, 1.0];
    let built = Dense::new(Partition::points(2), entries, false);
    assert!(matches!(built, Err(SolveError::NonFinite { .. })));
    let a = dense(2, &[1.0, 0.0, 0.0, 1.0], true);
    for method in Method::ALL {
        for wrong in [f64::NAN, f64::INFINITY] {
            let solved = solve(method.name, &a, &[1.0, wrong], &Settings::default());
            assert!(matches!(solved, Err(SolveError::NonFinite { .. })), "{}", method.name);
        }
    }
    let mut guess = [f64::NAN, 0.0];
    let gauss_seidel = Method::named("gauss-seidel").unwrap().solver;
    let solved = gauss_seidel.solve(&a, &[1.0, 1.0], &mut guess, &Settings::default(), &mut |_| ());
    assert_eq!(solved, Err(SolveError::NonFinite { what: "the first guess" }));
}

#[test]
fn a_lying_operator_is_refused() {
    let b = vec![1.0; 10];
    for method in Method::ALL {
        for lie in [Lie::Nan, Lie::Short] {
            if lie == Lie::Short && method.name == "southwell" {
                // It asks for diagonal blocks and columns only, and columns are added, not written.
                continue;
            }
            let solved = solve(method.name, &liar(lie), &b, &Settings::default());
            assert!(matches!(solved, Err(SolveError::NonFinite { .. })), "{}: {solved:?}", method.name);
        }
    }
    for method in Method::ALL.iter().filter(|method| method.storage == "n²") {
        let solved = solve(method.name, &liar(Lie::Size), &b, &Settings::default());
        assert!(matches!(solved, Err(SolveError::DimensionMismatch { expected: 100, found: 99, .. })));
    }
    let claims = solve("cg", &liar(Lie::Symmetry), &b, &Settings::default());
    assert_eq!(claims, Err(SolveError::NotSymmetric { method: "cg" }));
    let inconsistent = solve("lu", &liar(Lie::Inconsistent), &b, &Settings::default());
    assert!(matches!(inconsistent, Err(SolveError::NotConverged { .. })), "{inconsistent:?}");
}

#[test]
fn cholesky_falls_back_to_lu_when_symmetry_was_a_lie() {
    // The lower triangle is that of a positive definite matrix so unlike the true one that refinement
    // diverges.
    let a = Liar { truth: dense(2, &[1.0, 0.9, -0.9, 1.0], false), lie: Lie::Symmetry };
    let report = solve("cholesky", &a, &[1.0, 2.0], &Settings::default()).unwrap();
    assert_eq!(report.method, "lu");
    assert!(report.residual < 1e-15);
}

#[test]
fn singular_matrices_are_named_so() {
    let singular = dense(2, &[1.0, 1.0, 1.0, 1.0], false);
    let nearly = dense(3, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0], false);
    for method in Method::ALL.iter().filter(|method| method.name.starts_with("lu") || method.name == "auto") {
        for (a, b) in [(&singular, &[1.0, 0.0][..]), (&nearly, &[1.0, 0.0, 0.0])] {
            let solved = solve(method.name, a, b, &Settings::default());
            assert!(matches!(solved, Err(SolveError::Singular { .. })), "{}: {solved:?}", method.name);
        }
    }
    let no_diagonal = dense(2, &[0.0, 1.0, 1.0, 0.0], true);
    for name in ["jacobi", "gauss-seidel", "southwell"] {
        let solved = solve(name, &no_diagonal, &[1.0, 2.0], &Settings::default());
        assert!(matches!(solved, Err(SolveError::Singular { .. })), "{name}: {solved:?}");
    }
    assert!(solve("gmres", &no_diagonal, &[1.0, 2.0], &Settings::default()).is_ok());
}

#[test]
fn symmetry_is_required_where_it_is_needed() {
    let a = dense(2, &[1.0, 0.5, 0.0, 1.0], false);
    for method in Method::ALL.iter().filter(|method| method.needs == Needs::PositiveDefinite) {
        let solved = solve(method.name, &a, &[1.0, 1.0], &Settings::default());
        assert_eq!(solved, Err(SolveError::NotSymmetric { method: method.name }));
    }
    let claimed = Dense::new(Partition::points(2), vec![1.0, 0.0, 0.5, 1.0], true);
    assert!(matches!(claimed, Err(SolveError::NotSymmetric { .. })));
}

#[test]
fn indefinite_matrices_are_refused_where_they_must_be() {
    // Eigenvalues 3 and -1; the right-hand side has a part along each.
    let a = dense(2, &[1.0, 2.0, 2.0, 1.0], true);
    for method in Method::ALL.iter().filter(|method| method.needs == Needs::PositiveDefinite) {
        let solved = solve(method.name, &a, &[1.0, 0.0], &Settings::default());
        assert_eq!(solved, Err(SolveError::NotPositiveDefinite { method: method.name }));
    }
    assert!(solve("auto", &a, &[1.0, 0.0], &Settings::default()).unwrap().residual < 1e-15);
}

#[test]
fn an_exhausted_krylov_space_is_a_breakdown() {
    // A e₀ = 0: from b = e₀ there is no direction to go.
    let a = dense(2, &[0.0, 1.0, 0.0, 0.0], false);
    let solved = solve("gmres", &a, &[1.0, 0.0], &Settings::default());
    assert_eq!(solved, Err(SolveError::Breakdown { method: "gmres", iterations: 1 }));
    // rᵀ z underflows to 0 while r is not 0.
    let tiny = dense(1, &[1.0], true);
    let solved = solve("cg", &tiny, &[1e-170], &Settings::default());
    assert_eq!(solved, Err(SolveError::Breakdown { method: "cg", iterations: 0 }));
}

#[test]
fn cancellation_and_time_are_looked_at() {
    let random = &mut Random(5);
    let a = enclosure(random, Partition::new(&[4; 10]), [0.9, 0.999], true);
    let cancel = AtomicBool::new(true);
    let cancelled = Settings::default().with_cancel(&cancel);
    let hurried = Settings::default().with_time_budget(Duration::ZERO).with_tolerance(0.0);
    for method in Method::ALL {
        let solved = solve(method.name, &a, &[1.0; 40], &cancelled);
        assert!(matches!(solved, Err(SolveError::Cancelled { .. })), "{}: {solved:?}", method.name);
        let solved = solve(method.name, &a, &[1.0; 40], &hurried);
        assert!(
            matches!(solved, Err(SolveError::NotConverged { stop: Stop::Time, .. })),
            "{}: {solved:?}",
            method.name
        );
    }
}

/// A matrix that is cancelled when its entries are read.
struct Cancelling<'a> {
    truth: Dense,
    cancel: &'a AtomicBool,
}

impl Operator for Cancelling<'_> {
    fn partition(&self) -> &Partition {
        self.truth.partition()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.truth.apply(x, y);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.truth.shoot(column, x, y);
    }

    fn symmetric(&self) -> bool {
        self.truth.symmetric()
    }

    fn dense(&self) -> Option<&[f64]> {
        self.cancel.store(true, Ordering::Relaxed);
        self.truth.dense()
    }
}

#[test]
fn a_factorisation_that_has_begun_is_cancelled() {
    for dim in [1, 40, 300] {
        for name in ["lu", "cholesky"] {
            let cancel = AtomicBool::new(false);
            let truth = positive_definite(&mut Random(3), Partition::points(dim), 0.1);
            let a = Cancelling { truth, cancel: &cancel };
            let settings = Settings::default().with_cancel(&cancel);
            let solved = solve(name, &a, &vec![1.0; dim], &settings);
            assert!(matches!(solved, Err(SolveError::Cancelled { .. })), "{name}: {solved:?}");
        }
    }
}

#[test]
fn a_long_factorisation_ends_between_its_panels() {
    let dim = 3073;
    let a = matrix(Partition::points(dim), true, |i, j| if i == j { 2.0 } else { 0.5 / dim as f64 });
    let b = vec![1.0; dim];
    for name in ["lu", "cholesky"] {
        let started = Instant::now();
        assert!(solve(name, &a, &b, &Settings::default()).is_ok(), "{name}");
        // The entries are read by then, and most panels are still to come.
        let half = started.elapsed() / 2;
        let solved = solve(name, &a, &b, &Settings::default().with_time_budget(half));
        let Err(SolveError::NotConverged { stop: Stop::Time, residual, .. }) = solved else {
            panic!("{name}: {solved:?}")
        };
        assert_eq!(residual, f64::INFINITY);
        let cancel = AtomicBool::new(false);
        let settings = Settings::default().with_cancel(&cancel);
        let solved = std::thread::scope(|scope| {
            scope.spawn(|| {
                std::thread::sleep(half);
                cancel.store(true, Ordering::Relaxed);
            });
            solve(name, &a, &b, &settings)
        });
        assert!(matches!(solved, Err(SolveError::Cancelled { .. })), "{name}: {solved:?}");
    }
}

/// An identity whose every column takes [`PAUSE`].
struct Slow {
    blocks: Partition,
}

/// Time of a column of [`Slow`].
const PAUSE: Duration = Duration::from_millis(20);

impl Operator for Slow {
    fn partition(&self) -> &Partition {
        &self.blocks
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        std::thread::sleep(PAUSE);
        y[column] += x[0];
    }
}

#[test]
fn the_reading_of_entries_ends_with_its_time() {
    let a = Slow { blocks: Partition::points(500) };
    let started = Instant::now();
    let solved = solve("lu", &a, &[1.0; 500], &Settings::default().with_time_budget(2 * PAUSE));
    assert!(matches!(solved, Err(SolveError::NotConverged { stop: Stop::Time, .. })), "{solved:?}");
    // All columns would take ten seconds.
    assert!(started.elapsed() < 100 * PAUSE);
}

#[test]
fn settings_out_of_range_are_refused() {
    let a = dense(1, &[1.0], true);
    let wrong = [
        Settings::default().with_tolerance(f64::NAN),
        Settings::default().with_tolerance(-1.0),
        Settings::default().with_relaxation(2.0),
        Settings::default().with_relaxation(0.0),
        Settings::default().with_restart(0),
        Settings::default().with_measure(&[0.0]),
    ];
    for settings in &wrong {
        for method in Method::ALL {
            let solved = solve(method.name, &a, &[1.0], settings);
            assert!(matches!(solved, Err(SolveError::Setting { .. })), "{}: {settings:?}", method.name);
        }
    }
}

#[test]
fn too_few_iterations_leave_the_best_iterate_and_its_residual() {
    let random = &mut Random(7);
    let a = positive_definite(random, Partition::new(&[3; 12]), 1e-4);
    let b = random.numbers(36);
    let settings = Settings::default().with_max_iterations(3).with_tolerance(1e-12);
    for name in ["jacobi", "gauss-seidel", "southwell", "cg", "gmres"] {
        let mut x = vec![0.0; 36];
        let solved = Method::named(name).unwrap().solver.solve(&a, &b, &mut x, &settings, &mut |_| ());
        let Err(SolveError::NotConverged { residual, .. }) = solved else { panic!("{name}: {solved:?}") };
        let (truth, rounding) = crate::exact::residual(&a, &b, &x);
        assert!((residual - truth).abs() <= rounding, "{name}: {residual:e} {truth:e}");
        assert!(truth <= 1.0, "{name}: {truth:e} is worse than nothing");
    }
}

#[test]
fn divergence_is_seen_and_undone() {
    // The spectral radius of I − D⁻¹A is 3 for jacobi and richardson, and 9 for gauss-seidel.
    let a = dense(2, &[1.0, 3.0, 3.0, 1.0], true);
    for name in ["jacobi", "richardson", "gauss-seidel", "southwell"] {
        let mut x = vec![0.0; 2];
        let settings = Settings::default().with_max_iterations(usize::MAX);
        let solved =
            Method::named(name).unwrap().solver.solve(&a, &[1.0, 1.0], &mut x, &settings, &mut |_| ());
        let Err(SolveError::NotConverged { residual, stop, .. }) = solved else {
            panic!("{name}: {solved:?}")
        };
        assert_eq!(stop, Stop::Divergence, "{name}");
        assert!(residual <= 1.0, "{name}");
    }
}

#[test]
fn messages_name_the_cure() {
    let a = dense(2, &[1.0, 2.0, 2.0, 1.0], true);
    let settings = Settings::default().with_tolerance(0.0);
    let indefinite = solve("cg", &a, &[1.0, 0.0], &settings).unwrap_err();
    assert!(indefinite.to_string().contains("take lu or gmres"));
    let unknown = Method::named("guass-seidel").unwrap_err();
    assert_eq!(unknown.nearest, Some("gauss-seidel"));
    let message = unknown.to_string();
    assert!(Method::ALL.iter().all(|method| message.contains(method.name)), "{message}");
    assert_eq!(Method::named("xyz").unwrap_err().nearest, None);
}
