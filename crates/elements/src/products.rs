//! Products of Legendre polynomials, and the triangular matrix that makes them orthonormal on an element.
//!
//! ```text
//! L_k(a, b) = p_i(a) p_j(b) ,      φ_k = Σ_{l ≤ k} T_kl L_l ,      ∫ φ_k φ_l dA = δ_kl .
//! ```
//!
//! T comes from Gram–Schmidt, twice, on the table √w_a L_k(x_a) of a rule that is exact for the products: the
//! condition number of the element's shape enters once, not squared as it would by a Cholesky factor of the
//! Gram matrix. On a parallelogram that fills its frame T is a multiple of the identity.

use radiosity_core::{dot, legendre, norm};
use radiosity_scene::MAX_ORDER;

use super::columns::{add_scaled, take_out};
use super::space::Space;

/// Writes L_k(a, b) to `out`, in the order of `space`.
pub(crate) fn values(space: Space, order: usize, coordinates: [f64; 2], out: &mut [f64]) {
    // With a constant order all loops are unrolled.
    match order {
        0..=1 => products::<3>(space, order, coordinates, out),
        2 => products::<3>(space, 2, coordinates, out),
        3 => products::<4>(space, 3, coordinates, out),
        4 => products::<5>(space, 4, coordinates, out),
        5..=8 => products::<9>(space, order, coordinates, out),
        _ => products::<{ MAX_ORDER + 1 }>(space, order, coordinates, out),
    }
}

/// Writes p_i(a) p_j(b), i and j ≤ order < N. Inside the element the plain recurrence keeps all digits that
/// quadrature needs, in a fraction of the time of the form that is exact near ±1.
#[inline(always)]
fn products<const N: usize>(space: Space, order: usize, [a, b]: [f64; 2], out: &mut [f64]) {
    let (mut first, mut second) = ([0.0; N], [0.0; N]);
    legendre::Table::<N>::RECURRENCE.values(a, &mut first);
    legendre::Table::<N>::RECURRENCE.values(b, &mut second);
    match space {
        Space::Total => {
            let out = &mut out[..(order + 1) * (order + 2) / 2];
            let mut k = 0;
            for degree in 0..=order {
                for j in 0..=degree {
                    out[k] = first[degree - j] * second[j];
                    k += 1;
                }
            }
        }
        Space::Tensor => {
            for (row, p) in out.chunks_exact_mut(order + 1).zip(&first) {
                row.iter_mut().zip(&second).for_each(|(value, q)| *value = p * q);
            }
        }
    }
}

/// T, row-major, by Gram–Schmidt, two passes per column of a table with a row √w L per point. None where a
/// column depends on those before it.
pub(crate) fn orthonormalise(rows: &[Vec<f64>], count: usize) -> Option<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = (0..count).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let mut transform = vec![0.0; count * count];
    for k in 0..count {
        let (done, rest) = columns.split_at_mut(k);
        let column = &mut rest[0];
        let before = norm(column);
        let mut row = vec![0.0; count];
        row[k] = 1.0;
        for _pass in 0..2 {
            for (j, other) in done.iter().enumerate() {
                let overlap = take_out(column, other);
                add_scaled(&mut row, -overlap, &transform[j * count..(j + 1) * count]);
            }
        }
        let left = norm(column);
        if left.is_nan() || left <= f64::EPSILON * before {
            return None;
        }
        column.iter_mut().for_each(|x| *x /= left);
        for (out, x) in transform[k * count..].iter_mut().zip(&row) {
            *out = x / left;
        }
    }
    Some(transform)
}

/// max |∫ φ_k φ_l dA − δ_kl| of φ = T L, with L from the table and T as rounded.
pub(crate) fn defect(rows: &[Vec<f64>], transform: &[f64]) -> f64 {
    let count = transform.len().isqrt();
    let mut gram = vec![0.0; transform.len()];
    let mut values = vec![0.0; count];
    for row in rows {
        for (k, value) in values.iter_mut().enumerate() {
            *value = dot(&transform[k * count..=k * count + k], &row[..=k]);
        }
        for (line, x) in gram.chunks_exact_mut(count).zip(&values) {
            line.iter_mut().zip(&values).for_each(|(g, y)| *g += x * y);
        }
    }
    gram.iter_mut().step_by(count + 1).for_each(|diagonal| *diagonal -= 1.0);
    // Not a number counts as the largest of defects.
    gram.iter().map(|g| if g.is_nan() { f64::INFINITY } else { g.abs() }).fold(0.0, f64::max)
}
