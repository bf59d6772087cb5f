//! Sums and norms of coefficients.

use radiosity_core::norm;
use radiosity_elements::Element;

/// x + y.
pub(super) fn sum(x: &[f64], y: &[f64]) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x + y).collect()
}

/// ‖x − y‖₂.
pub(crate) fn distance(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}

/// ‖x − y‖₂ / ‖y‖₂; 0 where they are the same, infinite where y alone is zero.
pub(crate) fn relative_distance(x: &[f64], y: &[f64]) -> f64 {
    match distance(x, y) {
        0.0 => 0.0,
        distance => distance / norm(y),
    }
}

/// The numbers that `write` appends for each element, one element after the other.
pub(super) fn per_element(elements: &[Element], write: impl Fn(usize, &mut Vec<f64>)) -> Vec<f64> {
    let mut all = Vec::new();
    (0..elements.len()).for_each(|i| write(i, &mut all));
    all
}
