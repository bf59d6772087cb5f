//! Residuals in double-double arithmetic, and how far a residual in doubles may be from them.

use radiosity_solvers::Operator;

/// s + e = a + b exactly (Knuth).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// The entries of `a`, column by column.
pub(crate) fn entries(a: &dyn Operator) -> Vec<f64> {
    let partition = a.partition();
    let dim = partition.dim();
    let mut values = vec![0.0; dim * dim];
    for block in 0..partition.len() {
        let range = partition.range(block);
        a.entries(block, &mut values[range.start * dim..range.end * dim]);
    }
    values
}

/// ‖b − A x‖₂ / ‖b‖₂ to some 30 digits before the final rounding, and a bound of what evaluating it in
/// doubles, in any order, may add: (n + 8) ε ‖ |A| |x| + |b| ‖₂ / ‖b‖₂.
pub(crate) fn residual(a: &dyn Operator, b: &[f64], x: &[f64]) -> (f64, f64) {
    let dim = b.len();
    let values = entries(a);
    let mut high = b.to_vec();
    let mut low = vec![0.0; dim];
    let mut sizes: Vec<f64> = b.iter().map(|b| b.abs()).collect();
    for (column, x) in values.chunks_exact(dim).zip(x) {
        for i in 0..dim {
            let product = -column[i] * x;
            let error = (-column[i]).mul_add(*x, -product);
            let (sum, carry) = two_sum(high[i], product);
            high[i] = sum;
            low[i] += carry + error;
            sizes[i] += product.abs();
        }
    }
    let r: Vec<f64> = high.iter().zip(&low).map(|(high, low)| high + low).collect();
    let scale = norm(b);
    let rounding = (dim as f64 + 8.0) * f64::EPSILON * norm(&sizes) / scale;
    (norm(&r) / scale, rounding)
}

/// ‖x‖₂, without overflow.
pub(crate) fn norm(x: &[f64]) -> f64 {
    let largest = x.iter().fold(f64::MIN_POSITIVE, |largest, x| x.abs().max(largest));
    largest * x.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt()
}
