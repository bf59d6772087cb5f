//! Random systems of known kinds.

use radiosity_solvers::{Dense, Operator, Partition};

use crate::random::Random;

/// Block sizes 1..=largest that fill `dim` unknowns.
pub fn partition(random: &mut Random, dim: usize, largest: usize) -> Partition {
    let mut sizes = Vec::new();
    let mut left = dim;
    while left > 0 {
        let size = (1 + random.below(largest)).min(left);
        sizes.push(size);
        left -= size;
    }
    Partition::new(&sizes)
}

/// The matrix with entries `entry(i, j)`.
pub fn matrix(partition: Partition, symmetric: bool, mut entry: impl FnMut(usize, usize) -> f64) -> Dense {
    let dim = partition.dim();
    let mut values = Vec::with_capacity(dim * dim);
    for j in 0..dim {
        for i in 0..dim {
            values.push(entry(i, j));
        }
    }
    Dense::new(partition, values, symmetric).unwrap()
}

/// Strictly diagonally dominant by rows and by columns.
pub fn dominant(random: &mut Random, partition: Partition) -> Dense {
    let dim = partition.dim() as f64;
    matrix(partition, false, |i, j| random.signed() / dim + if i == j { 2.2 } else { 0.0 })
}

/// Symmetric with eigenvalues in [floor, 1 + floor]: floor·I + C Cᵀ / ‖C‖².
pub fn positive_definite(random: &mut Random, partition: Partition, floor: f64) -> Dense {
    let dim = partition.dim();
    let factor = random.numbers(dim * dim);
    let square = factor.iter().map(|c| c * c).sum::<f64>();
    let product =
        |i: usize, j: usize| (0..dim).map(|k| factor[i * dim + k] * factor[j * dim + k]).sum::<f64>();
    matrix(partition, true, |i, j| product(i.min(j), i.max(j)) / square + if i == j { floor } else { 0.0 })
}

/// A doubly stochastic symmetric matrix: a closed world of equal shares, column by column.
pub fn exchange(random: &mut Random, dim: usize) -> Vec<f64> {
    let mut values = vec![0.0; dim * dim];
    for j in 0..dim {
        for i in 0..=j {
            // Many small exchanges and a few large ones; nothing is exchanged with oneself.
            let value = if i == j { 0.0 } else { random.unit().powi(6) + 1e-3 };
            values[j * dim + i] = value;
            values[i * dim + j] = value;
        }
    }
    for _ in 0..60 {
        let sums: Vec<f64> =
            values.chunks_exact(dim).map(|column| column.iter().sum::<f64>().max(1e-300).sqrt()).collect();
        for j in 0..dim {
            for i in 0..dim {
                values[j * dim + i] /= sums[i] * sums[j];
            }
        }
    }
    values
}

/// I − √ρ F √ρ (symmetric) or I − ρ F, with F an exchange and shares ρ_i in [lowest, highest] sent on.
pub fn enclosure(
    random: &mut Random,
    partition: Partition,
    [lowest, highest]: [f64; 2],
    symmetric: bool,
) -> Dense {
    let dim = partition.dim();
    let exchange = exchange(random, dim);
    let shares: Vec<f64> = (0..dim).map(|_| lowest + (highest - lowest) * random.unit()).collect();
    matrix(partition, symmetric, |i, j| {
        let share = if symmetric { (shares[i] * shares[j]).sqrt() } else { shares[i] };
        f64::from(u8::from(i == j)) - share * exchange[j * dim + i]
    })
}

/// A matrix with its rows multiplied by `rows` and columns by `columns`.
pub fn scaled(a: &Dense, rows: &[f64], columns: &[f64], symmetric: bool) -> Dense {
    let dim = rows.len();
    let values = a.values().to_vec();
    matrix(a.partition().clone(), symmetric, |i, j| values[j * dim + i] * (rows[i] * columns[j]))
}
