//! All accesses to an operator speak of one matrix.

use proptest::prelude::*;
use radiosity_solvers::{Dense, Operator, Partition};

use radiosity_test_support::random::Random;
use radiosity_test_support::systems::matrix;

/// Operator with only the functions that it must bring itself; the rest is provided.
struct Bare(Dense);

impl Operator for Bare {
    fn partition(&self) -> &Partition {
        self.0.partition()
    }

    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        self.0.gather(row, x, y);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        self.0.shoot(column, x, y);
    }
}

/// Largest difference of two slices.
fn distance(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    x.iter().zip(y).fold(0.0, |distance, (x, y)| (x - y).abs().max(distance))
}

/// Checks every access to `a` against its entries `a_ij = values[j·dim + i]`.
fn is_matrix(a: &dyn Operator, values: &[f64], x: &[f64]) -> Result<(), TestCaseError> {
    let dim = a.partition().dim();
    let product: Vec<f64> = (0..dim).map(|i| (0..dim).map(|j| values[j * dim + i] * x[j]).sum()).collect();
    let (mut applied, mut gathered, mut shot) = (vec![7.0; dim], vec![7.0; dim], vec![0.0; dim]);
    a.apply(x, &mut applied);
    for block in 0..a.partition().len() {
        let range = a.partition().range(block);
        a.gather(block, x, &mut gathered[range.clone()]);
        a.shoot(block, &x[range.clone()], &mut shot);
        let mut diagonal = vec![7.0; range.len().pow(2)];
        a.diagonal(block, &mut diagonal);
        let square = range.clone().flat_map(|j| range.clone().map(move |i| values[j * dim + i]));
        prop_assert_eq!(diagonal, square.collect::<Vec<_>>());
        let mut entries = vec![7.0; range.len() * dim];
        a.entries(block, &mut entries);
        prop_assert_eq!(&entries, &values[range.start * dim..range.end * dim]);
    }
    for y in [&applied, &gathered, &shot] {
        prop_assert!(distance(y, &product) < 1e-13);
    }
    let pair = [x, &product].concat();
    let mut images = vec![7.0; 2 * dim];
    a.apply_many(&pair, &mut images);
    prop_assert_eq!(&images[..dim], &applied[..]);
    a.apply(&product, &mut applied);
    prop_assert_eq!(&images[dim..], &applied[..]);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn rows_columns_and_products_agree(
        seed: u64,
        sizes in prop::collection::vec(0..8usize, 0..8),
        symmetric: bool,
        threads in 1..4usize,
    ) {
        let random = &mut Random(seed);
        let partition = Partition::new(&sizes);
        let dim = partition.dim();
        let entries = random.numbers(dim * dim);
        let a = matrix(partition, symmetric, |i, j| {
            if symmetric { entries[i.max(j) * dim + i.min(j)] } else { entries[i * dim + j] }
        });
        let a = a.with_threads(threads);
        let x = random.numbers(dim);
        let values = a.values().to_vec();
        is_matrix(&a, &values, &x)?;
        is_matrix(&Bare(a), &values, &x)?;
    }
}
