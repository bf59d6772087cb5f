//! Southwell shoots what it should, in the order it should, and touches nothing else.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use radiosity_solvers::method::Method;
use radiosity_solvers::{Dense, Granularity, Operator, Partition, Report, Settings, SolveError, Step};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, matrix, partition};

/// Logs which block columns are shot, and refuses all other access but to diagonal blocks already due.
struct Counting {
    matrix: Dense,
    shots: Mutex<Vec<usize>>,
}

impl Counting {
    fn new(matrix: Dense) -> Self {
        Self { matrix, shots: Mutex::new(Vec::new()) }
    }

    fn shots(&self) -> Vec<usize> {
        self.shots.lock().unwrap().clone()
    }

    fn columns(&self) -> Vec<usize> {
        let mut columns = self.shots();
        columns.sort_unstable();
        columns.dedup();
        columns
    }
}

impl Operator for Counting {
    fn partition(&self) -> &Partition {
        self.matrix.partition()
    }

    fn apply(&self, _: &[f64], _: &mut [f64]) {
        unreachable!("a product needs every column");
    }

    fn gather(&self, _: usize, _: &[f64], _: &mut [f64]) {
        unreachable!("a row crosses every column");
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.shots.lock().unwrap().push(column);
        self.matrix.shoot(column, x, y);
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        self.matrix.diagonal(block, out);
    }
}

fn southwell(
    a: &dyn Operator,
    b: &[f64],
    settings: &Settings<'_>,
    observer: &mut dyn FnMut(&Step<'_>),
) -> (Vec<f64>, Result<Report, SolveError>) {
    let mut x = vec![0.0; b.len()];
    let solved = Method::named("southwell").unwrap().solver.solve(a, b, &mut x, settings, observer);
    (x, solved)
}

/// I − K of the worked example, K = (0 ½ 0; ¼ 0 ½; 0 ¼ 0).
fn example() -> Counting {
    let rows = [[1.0, -0.5, 0.0], [-0.25, 1.0, -0.5], [0.0, -0.25, 1.0]];
    Counting::new(matrix(Partition::points(3), false, |i, j| rows[i][j]))
}

#[test]
fn the_order_is_that_worked_by_hand() {
    // r: (8,0,4) → shoot 0 → (0,2,4) → 2 → (0,4,0) → 1 → (2,0,1) → 0 → (0,½,1) → 2 → (0,1,0).
    let a = example();
    let mut largest: Vec<f64> = Vec::new();
    let settings = Settings::default().with_shots(5).with_tolerance(0.0);
    let (x, _) = southwell(&a, &[8.0, 0.0, 4.0], &settings, &mut |step| {
        largest.push(step.unshot.unwrap().iter().fold(0.0, |most, r| most.max(r.abs())));
    });
    assert_eq!(a.shots()[..5], [0, 2, 1, 0, 2]);
    assert_eq!(largest, [8.0, 4.0, 4.0, 2.0, 1.0, 1.0]);
    assert_eq!(x, [10.0, 4.0, 5.0]);
}

#[test]
fn a_measure_changes_the_order() {
    // Weights (1,3,1): measures (8,0,4) → shoot 0, r (0,2,4), measures (0,6,4) → 1, r (1,0,4½) → 2.
    let a = example();
    let settings = Settings::default().with_shots(3).with_tolerance(0.0).with_measure(&[1.0, 3.0, 1.0]);
    let (x, _) = southwell(&a, &[8.0, 0.0, 4.0], &settings, &mut |_| ());
    assert_eq!(a.shots()[..3], [0, 1, 2]);
    assert_eq!(x, [8.0, 2.0, 4.5]);
}

#[test]
fn overshooting_shoots_ahead() {
    // ω = 1½: shoot 12 from 0, r (-4,3,4); the tie of 0 and 2 goes to 0, -6: r (2,1½,4) → 2.
    let a = example();
    let settings = Settings::default().with_shots(3).with_tolerance(0.0).with_relaxation(1.5);
    let (x, _) = southwell(&a, &[8.0, 0.0, 4.0], &settings, &mut |_| ());
    assert_eq!(a.shots()[..3], [0, 0, 2]);
    assert_eq!(x, [6.0, 0.0, 6.0]);
}

#[test]
fn each_shot_is_the_largest_by_definition() {
    let random = &mut Random(11);
    for case in 0..100 {
        let partition = partition(random, 20, 6);
        let a = Counting::new(enclosure(random, partition.clone(), [0.1, 0.9], false));
        let b = random.numbers(20);
        let weights: Vec<f64> = (0..20).map(|_| 0.1 + random.unit()).collect();
        let granularity = if case % 2 == 0 { Granularity::Block } else { Granularity::Coefficient };
        let mut steps: Vec<Vec<f64>> = Vec::new();
        let settings = Settings::default().with_measure(&weights).with_granularity(granularity);
        let (_, solved) = southwell(&a, &b, &settings, &mut |step| steps.push(step.x.to_vec()));
        assert!(solved.is_ok());
        let items: Vec<_> = match granularity {
            Granularity::Block => (0..partition.len()).map(|block| partition.range(block)).collect(),
            Granularity::Coefficient => (0..20).map(|l| l..l + 1).collect(),
        };
        for pair in steps.windows(2) {
            let mut r = vec![0.0; 20];
            a.matrix.apply(&pair[0], &mut r);
            r.iter_mut().zip(&b).for_each(|(r, b)| *r = b - *r);
            let measure = |item: &std::ops::Range<usize>| -> f64 {
                item.clone().map(|l| weights[l] * r[l].abs()).sum()
            };
            let largest = items.iter().map(measure).fold(0.0, f64::max);
            let shot =
                items.iter().find(|item| pair[0][(*item).clone()] != pair[1][(*item).clone()]).unwrap();
            assert!(measure(shot) >= largest * (1.0 - 1e-6) - 1e-13, "{} of {largest}", measure(shot));
        }
    }
}

/// The share of its power that each patch of the sphere sends on.
const SENT_ON: f64 = 0.3;

/// The inside of a sphere, cut into patches whose areas fall geometrically: the share of j's power that
/// reaches i is exactly A_i / Σ A. The unknowns are powers; each patch holds `size` of them, of equal area;
/// one patch emits 1.
fn sphere(patches: usize, size: usize) -> (Dense, Vec<f64>) {
    let areas: Vec<f64> = (0..patches).map(|patch| 0.7f64.powi(patch as i32)).collect();
    let total: f64 = areas.iter().sum();
    let a = matrix(Partition::new(&vec![size; patches]), false, |i, j| {
        f64::from(u8::from(i == j)) - SENT_ON * areas[i / size] / total / size as f64
    });
    let mut b = vec![0.0; patches * size];
    b[..size].fill(1.0 / size as f64);
    (a, b)
}

/// Two parallel square plates of `side`² equal square patches each, at a distance of one patch width. The
/// share cos² A / π r² (A = 1, between centres) of the light of patch j reaches patch i of the other plate.
/// The patch in the middle of one plate emits 1; light that misses the plates is lost.
fn plates(side: usize) -> (Dense, Vec<f64>) {
    let across = |i: usize, j: usize| {
        let apart = |i: usize, j: usize| i.abs_diff(j).pow(2) as f64;
        1.0 + apart(i / side % side, j / side % side) + apart(i % side, j % side)
    };
    let plate = |i: usize| i / (side * side);
    let a = matrix(Partition::points(2 * side * side), true, |i, j| match (i == j, plate(i) == plate(j)) {
        (true, _) => 1.0,
        (false, true) => 0.0,
        (false, false) => -0.2 / (std::f64::consts::PI * across(i, j).powi(2)),
    });
    let mut b = vec![0.0; 2 * side * side];
    b[(side + 1) * side / 2] = 1.0;
    (a, b)
}

/// Shoots until 1 % of the total is unshot, and holds that this takes under a quarter of the block columns.
fn needs_few_columns((matrix, b): (Dense, Vec<f64>)) {
    let partition = matrix.partition().clone();
    let a = Counting::new(matrix);
    let cancel = AtomicBool::new(false);
    let settings = Settings::default().with_cancel(&cancel).with_tolerance(0.0);
    let mut unshot = f64::INFINITY;
    let (x, solved) = southwell(&a, &b, &settings, &mut |step| {
        let mut sent = vec![0.0; b.len()];
        a.matrix.apply(step.x, &mut sent);
        unshot = b.iter().zip(&sent).map(|(b, sent)| (b - sent).abs()).sum();
        cancel.store(unshot <= 0.01, Ordering::Relaxed);
    });
    assert!(matches!(solved, Err(SolveError::Cancelled { .. })));
    assert!(unshot <= 0.01 && unshot > 0.0);
    let lit = |block: &usize| x[partition.range(*block)].iter().any(|x| *x != 0.0);
    let used: Vec<usize> = (0..partition.len()).filter(lit).collect();
    assert_eq!(a.columns(), used, "a column was touched that was not shot");
    assert!(4 * used.len() < partition.len(), "{} of {} block columns", used.len(), partition.len());
}

#[test]
fn an_emitter_among_unequal_patches_needs_few_columns() {
    needs_few_columns(sphere(64, 3));
}

#[test]
fn an_emitter_close_to_what_it_lights_needs_few_columns() {
    needs_few_columns(plates(24));
}

#[test]
fn a_solved_system_reports_the_columns_it_used() {
    // Two worlds that exchange nothing; only the first is lit.
    let a = Counting::new(matrix(Partition::new(&[2; 6]), true, |i, j| match (i == j, i / 6 == j / 6) {
        (true, _) => 1.0,
        (false, true) => -0.1,
        (false, false) => 0.0,
    }));
    let mut b = vec![0.0; 12];
    b[0] = 1.0;
    let (_, solved) = southwell(&a, &b, &Settings::default(), &mut |_| ());
    assert_eq!(solved.unwrap().columns, 3);
    assert_eq!(a.columns(), [0, 1, 2]);
}
