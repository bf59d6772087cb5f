//! Row sums that agree with what is known of them.
//!
//! Factors d_i are found with
//!
//! ```text
//! Σ_j d_i (A_i F_ij) d_j = R_i   for all i ,
//! ```
//!
//! for given sums R_i, and G_ij becomes d_i G_ij d_j, which is symmetric still. The d are found by turns, d_i
//! ← d_i √(R_i / Σ_j A_i F_ij) (the damped iteration of R. Sinkhorn, P. Knopp, *Pacific J. Math.* 21 (1967)
//! 343-348, for symmetric matrices); a row that nothing enters keeps d_i = 1. Smoothing by least squares is
//! in M. E. Larsen, J. R. Howell, *J. Heat Transfer* 108 (1986) 239-242.

use serde::{Deserialize, Serialize};

/// Most turns. Each takes a quarter or more off what is missing; elements that few rays reach are the slow ones.
const TURNS: usize = 120;

/// Largest relative error of a row sum at which the turns end, over that of the pairs that are known beside those by
/// rays, and where these are known badly: far below what is left of sampling. Where few pairs are left to rays, sums
/// tell them as well as the others are known.
const OF_KNOWN: f64 = 1e-3;
const SETTLED: f64 = 1e-6;

/// Bounds of a factor: an element whose sum is farther off was reached by too few rays to tell.
const FACTORS: [f64; 2] = [0.2, 5.0];

/// Exchange A_i F_ij of two elements, i ≤ j.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Exchange {
    pub row: u32,
    pub column: u32,
    pub amount: f64,
}

/// The factors d for the row sums `wanted`, beside pairs known to the relative error `known`.
pub(super) fn factors(exchanges: &[Exchange], wanted: &[f64], known: f64) -> Vec<f64> {
    let settled = SETTLED.min(OF_KNOWN * known);
    let mut d = vec![1.0; wanted.len()];
    for _ in 0..TURNS {
        let sums = row_sums(exchanges, &d);
        let mut worst: f64 = 0.0;
        for ((d, sum), wanted) in d.iter_mut().zip(&sums).zip(wanted) {
            if *sum > 0.0 && *wanted > 0.0 {
                worst = worst.max((wanted / sum - 1.0).abs());
                *d = (*d * (wanted / sum).sqrt()).clamp(FACTORS[0], FACTORS[1]);
            }
        }
        if worst <= settled {
            break;
        }
    }
    d
}

/// Σ_j d_i (A_i F_ij) d_j.
pub(super) fn row_sums(exchanges: &[Exchange], d: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; d.len()];
    for Exchange { row, column, amount } in exchanges {
        let (i, j) = (*row as usize, *column as usize);
        let exchanged = d[i] * amount * d[j];
        sums[i] += exchanged;
        if i != j {
            sums[j] += exchanged;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exchange(row: u32, column: u32, amount: f64) -> Exchange {
        Exchange { row, column, amount }
    }

    #[test]
    fn rows_sum_to_what_is_wanted() {
        let exchanges = [exchange(0, 1, 0.5), exchange(0, 2, 0.4), exchange(1, 2, 0.45), exchange(2, 2, 0.1)];
        let wanted = [1.0, 1.1, 0.9];
        for (known, least) in [(1e-3, 2e-6), (1e-6, 2e-9), (1.0, 2e-6)] {
            let d = factors(&exchanges, &wanted, known);
            for (sum, wanted) in row_sums(&exchanges, &d).iter().zip(wanted) {
                assert!((sum / wanted - 1.0).abs() < least, "{sum} beside {known:e}");
            }
        }
    }

    #[test]
    fn what_nothing_reaches_is_left_alone() {
        let d = factors(&[exchange(0, 1, 0.5)], &[0.5, 0.5, 1.0], 1e-3);
        assert_eq!(d[2], 1.0);
        assert!((d[0] - 1.0).abs() < 1e-6 && (d[1] - 1.0).abs() < 1e-6);
    }
}
