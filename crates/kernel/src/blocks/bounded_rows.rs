//! Rows of constants that sum to 1 at the most.
//!
//! No more arrives than is sent. Where errors of blocks say otherwise, light that is reflected without loss grows
//! between them, and its system has no solution. Factors 0 < d_i ≤ 1 are found with
//!
//! ```text
//! s_i = Σ_j d_i G_ij d_j c_j / c_i ≤ 1 ,     s_i = 1 where d_i < 1 ,
//! ```
//!
//! and d_i G_ij d_j is symmetric still. The d are found by turns, d_i ← min(1, d_i / √s_i) (the damped iteration of R.
//! Sinkhorn, P. Knopp, *Pacific J. Math.* 21 (1967) 343-348), and at last d_i ← d_i / max(1, s_i), after which no row
//! is above 1.

use crate::blocks::Blocks;

/// Most turns. Each halves about what is too much.
const TURNS: usize = 30;

/// Excess of rows over 1 at which the turns end. Chosen: the last step then takes hardly more than is too much.
const SETTLED: f64 = 1e-4;

/// Excess of rows over 1 that is rounding.
const ROUNDING: f64 = 1e-14;

/// Makes rows of blocks between constants sum to 1 at the most, `ones` the coefficients of the constant 1. Returns by
/// how much each was above.
pub fn bound_rows(blocks: &mut Blocks, ones: &[f64]) -> Vec<f64> {
    let sums = |blocks: &Blocks, d: &[f64]| -> Vec<f64> {
        let sent: Vec<f64> = d.iter().zip(ones).map(|(d, one)| d * one).collect();
        let arrived = blocks.apply(&sent).into_iter().zip(d).zip(ones);
        arrived.map(|((arrived, d), one)| d * arrived / one).collect()
    };
    let mut d = vec![1.0; ones.len()];
    let mut now = sums(blocks, &d);
    let excess: Vec<f64> = now.iter().map(|sum| (sum - 1.0).max(0.0)).collect();
    if largest(&now) <= 1.0 + ROUNDING {
        return excess;
    }
    for _ in 0..TURNS {
        if largest(&now) <= 1.0 + SETTLED {
            break;
        }
        d.iter_mut()
            .zip(&now)
            .filter(|(_, sum)| **sum > 0.0)
            .for_each(|(d, sum)| *d = (*d / sum.sqrt()).min(1.0));
        now = sums(blocks, &d);
    }
    d.iter_mut().zip(&now).for_each(|(d, sum)| *d /= sum.max(1.0));
    blocks.change(|row, column, values| values.iter_mut().for_each(|value| *value *= d[row] * d[column]));
    excess
}

fn largest(sums: &[f64]) -> f64 {
    sums.iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use radiosity_work::ranks::Ranks;

    use super::*;

    /// Exchanges A_i F_ij of elements of these areas as blocks.
    fn blocks(areas: &[f64], exchanges: &[(usize, usize, f64)]) -> (Blocks, Vec<f64>) {
        let mut blocks = Blocks::empty((0..=areas.len()).collect(), true, Ranks::alone());
        for (i, j, exchange) in exchanges {
            blocks.push(*i, *j, &[exchange / (areas[*i] * areas[*j]).sqrt()]);
        }
        (blocks, areas.iter().map(|area| area.sqrt()).collect())
    }

    fn sums(blocks: &Blocks, ones: &[f64]) -> Vec<f64> {
        blocks.apply(ones).iter().zip(ones).map(|(arrived, one)| arrived / one).collect()
    }

    /// A pocket of two plates that see each other more than wholly, one of which sees a third plate a little.
    #[test]
    fn rows_above_one_are_made_to_sum_to_one_and_no_more_is_taken() {
        let areas = [2.0, 2.5, 40.0];
        let (mut blocks, ones) = blocks(&areas, &[(0, 1, 2.6), (1, 2, 0.2), (0, 2, 0.1)]);
        let excess = bound_rows(&mut blocks, &ones);
        let wanted = [2.7 / 2.0 - 1.0, 2.8 / 2.5 - 1.0, 0.0];
        assert!(excess.iter().zip(wanted).all(|(own, wanted)| (own - wanted).abs() < 1e-12), "{excess:?}");
        let sums = sums(&blocks, &ones);
        assert!(sums.iter().all(|sum| *sum <= 1.0 + 1e-14), "{sums:?}");
        assert!(sums[0] > 1.0 - 1e-3, "{sums:?}");
        // The third row was below 1: it keeps what the others do not lose.
        assert!((0.5..=1.0).contains(&(sums[2] * 40.0 / 0.3)), "{sums:?}");
    }

    #[test]
    fn rows_below_one_keep_every_bit() {
        let (mut blocks, ones) = blocks(&[1.0, 3.0], &[(0, 1, 0.9), (1, 1, 2.0)]);
        let before: Vec<f64> = blocks.first_entries().iter().map(|entry| entry.value).collect();
        assert_eq!(bound_rows(&mut blocks, &ones), [0.0; 2]);
        let after: Vec<f64> = blocks.first_entries().iter().map(|entry| entry.value).collect();
        assert_eq!(before, after);
    }
}
