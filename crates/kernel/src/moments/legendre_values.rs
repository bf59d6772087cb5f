//! Values of the orthonormal Legendre polynomials p_0 … p_n at a point, by recurrences unrolled for the usual
//! lengths.

use radiosity_core::legendre;
use radiosity_elements::basis::HIGHEST_ORDER;

/// p_n(x), n = 0..out.len().
pub(crate) fn polynomials(x: f64, out: &mut [f64]) {
    match out.len() {
        0..=3 => recurrence::<3>(x, out),
        4..=5 => recurrence::<5>(x, out),
        6..=9 => recurrence::<9>(x, out),
        10..=21 => recurrence::<{ HIGHEST_ORDER + 1 }>(x, out),
        22..=42 => recurrence::<{ 2 * HIGHEST_ORDER + 2 }>(x, out),
        _ => legendre::orthonormal(x, out),
    }
}

fn recurrence<const N: usize>(x: f64, out: &mut [f64]) {
    let mut values = [0.0; N];
    legendre::Table::<N>::RECURRENCE.values(x, &mut values);
    out.copy_from_slice(&values[..out.len()]);
}
