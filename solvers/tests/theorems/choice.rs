//! Choice of the method by `auto`, and the methods that follow where the first one fails.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_solvers::method::{Method, Methods, NameTaken};
use radiosity_solvers::{
    BlockSparse, Dense, Operator, Partition, Preconditioner, Report, Settings, SparseBlock,
};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, matrix};

fn auto(a: &Dense, settings: &Settings<'_>) -> Report {
    let dim = a.values().len().isqrt();
    let b = Random(59).numbers(dim);
    let mut x = vec![0.0; dim];
    Method::named("auto").unwrap().solver.solve(a, &b, &mut x, settings, &mut |_| ()).unwrap()
}

/// More unknowns than a direct method is first choice for.
const LARGE: usize = 600;

#[test]
fn large_systems_are_iterated_unless_rounding_decides() {
    for (symmetric, iterative, direct) in [(true, "cg", "cholesky"), (false, "gmres", "lu")] {
        let a = enclosure(&mut Random(61), Partition::new(&[6; LARGE / 6]), [0.3, 0.8], symmetric);
        assert_eq!(auto(&a, &Settings::default()).method, iterative);
        assert_eq!(auto(&a, &Settings::default().with_tolerance(5e-14)).method, direct);
    }
}

#[test]
fn what_defeats_iterations_is_eliminated() {
    // Eigenvalues of both signs, spread evenly: conjugate gradients are not for it, nor few steps of
    // anything.
    let spread = |i: usize| i as f64 - 0.4 * LARGE as f64;
    let symmetric = matrix(Partition::new(&[LARGE]), true, |i, j| if i == j { spread(i) } else { 1.0 });
    assert!(auto(&symmetric, &Settings::default()).method.starts_with("lu"));
    // A cyclic shift: minimal residuals stand still until the last step.
    let shift = matrix(Partition::points(LARGE), false, |i, j| f64::from(u8::from(i == (j + 1) % LARGE)));
    assert!(auto(&shift, &Settings::default()).method.starts_with("lu"));
}

/// Counts how often the entries of a block of columns are asked for.
struct Asked<'a> {
    a: &'a Dense,
    entries: AtomicUsize,
}

impl Operator for Asked<'_> {
    fn partition(&self) -> &Partition {
        self.a.partition()
    }

    fn symmetric(&self) -> bool {
        true
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.a.apply(x, y);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.a.shoot(column, x, y);
    }

    fn entries(&self, block: usize, out: &mut [f64]) {
        self.entries.fetch_add(1, Ordering::Relaxed);
        self.a.entries(block, out);
    }
}

#[test]
fn one_eigenvalue_below_0_needs_no_entries() {
    // Eigenvalues 1, and −1/2 along the vector of ones.
    let entry = |i, j| f64::from(u8::from(i == j)) - 1.5 / LARGE as f64;
    let held = matrix(Partition::new(&[LARGE]), true, entry);
    let a = Asked { a: &held, entries: AtomicUsize::new(0) };
    let b = Random(79).numbers(LARGE);
    let mut x = vec![0.0; LARGE];
    let auto = Method::named("auto").unwrap().solver;
    let settings = Settings::default().with_preconditioner(Preconditioner::None);
    let report = auto.solve(&a, &b, &mut x, &settings, &mut |_| ()).unwrap();
    assert_eq!((report.method, a.entries.into_inner()), ("gmres", 0));
    // (1 − 3/2 m) x = b with the mean m: the mean of x is −2 times that of b.
    let mean = b.iter().sum::<f64>() / LARGE as f64;
    x.iter().zip(&b).for_each(|(x, b)| assert!((x - (b - 3.0 * mean)).abs() <= 1e-6, "{x} {b}"));
}

#[test]
fn almost_nothing_lost_is_no_hindrance() {
    for loss in [1e-2, 1e-5, 1e-8] {
        for dim in [60, LARGE] {
            let a =
                enclosure(&mut Random(67), Partition::new(&vec![6; dim / 6]), [1.0 - loss, 1.0 - loss], true);
            // Rounding of x, which is 1/loss times as large as b, leaves about ε / loss.
            let settings = Settings::default().with_tolerance(1e-8f64.max(1e-14 / loss));
            auto(&a, &settings);
        }
    }
}

#[test]
fn many_right_hand_sides_share_a_factorisation_only_where_the_entries_are_held() {
    let columns = 2;
    let partition = || Partition::new(&[6; LARGE / 6]);
    let held = enclosure(&mut Random(71), partition(), [0.3, 0.8], true);
    let identity: Vec<f64> = (0..36).map(|k| f64::from(u8::from(k % 7 == 0))).collect();
    let blocks: Vec<SparseBlock<'_>> = (0..LARGE / 6).map(|k| SparseBlock::new(k, k, &identity)).collect();
    let thin = BlockSparse::symmetric(partition(), &blocks).unwrap();
    let operators: [(&dyn Operator, &str); 2] = [(&held, "cholesky"), (&thin, "cg")];
    for (a, method) in operators {
        let b = Random(73).numbers(columns * LARGE);
        let mut x = vec![0.0; b.len()];
        let auto = Method::named("auto").unwrap().solver;
        let reports = auto.solve_many(a, &b, &mut x, &Settings::default(), &mut |_| ()).unwrap();
        assert!(
            reports.len() == columns && reports.iter().all(|report| report.method == method),
            "{reports:?}"
        );
    }
}

/// A method that only has names.
static NAMED: Method = Method { name: "mine", aliases: &["own"], ..Method::CG };
static TAKEN: Method = Method { name: "lu", aliases: &[], ..Method::CG };
static TAKEN_ALIAS: Method = Method { name: "yours", aliases: &["shooting"], ..Method::CG };
static TWICE: Method = Method { name: "twice", aliases: &["double", "twice"], ..Method::CG };

#[test]
fn a_name_finds_one_method() {
    let methods = Methods::default().with(&NAMED).unwrap();
    assert_eq!(methods.named("own").unwrap().name, "mine");
    assert_eq!(methods.iter().count(), Method::ALL.len() + 1);
    for (method, name) in [(&TAKEN, "lu"), (&TAKEN_ALIAS, "shooting"), (&NAMED, "mine"), (&TWICE, "twice")] {
        assert_eq!(methods.clone().with(method).err(), Some(NameTaken { name }));
    }
    let unknown = methods.named("min").unwrap_err();
    assert_eq!(unknown.nearest, Some("mine"));
    assert!(unknown.to_string().ends_with("southwell, mine"), "{unknown}");
}
