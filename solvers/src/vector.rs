//! Sums over slices in a fixed order, so that they give the same bits everywhere.

/// Partial sums, so that the compiler can use vector registers.
const LANES: usize = 8;

/// xᵀ y; both of the same length.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let (x_lanes, x_rest) = x.as_chunks::<LANES>();
    let (y_lanes, y_rest) = y.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (x, y) in x_lanes.iter().zip(y_lanes) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    let rest: f64 = x_rest.iter().zip(y_rest).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}

/// ‖x‖₂, without overflow or underflow of the squares; NaN or infinite if an entry is.
pub(crate) fn norm(x: &[f64]) -> f64 {
    let squares = dot(x, x);
    if squares > 1e-200 && squares < 1e200 {
        return squares.sqrt();
    }
    let largest = x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if squares.is_nan() || largest == 0.0 || largest.is_infinite() {
        return squares;
    }
    largest * x.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt()
}

/// y += a x; both of the same length.
pub(crate) fn add_scaled(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

/// Whether no entry is infinite or NaN.
pub(crate) fn all_finite(x: &[f64]) -> bool {
    // No early exit within a chunk: only then does the test vectorise.
    x.chunks(64).all(|chunk| chunk.iter().fold(true, |finite, x| finite & x.is_finite()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn norms_neither_overflow_nor_underflow() {
        for scale in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
            assert!((norm(&[3.0 * scale, -4.0 * scale]) / (5.0 * scale) - 1.0).abs() < 1e-15, "{scale}");
        }
        assert_eq!(norm(&[]), 0.0);
        assert_eq!(norm(&[0.0, -0.0]), 0.0);
        assert_eq!(norm(&[1.0, f64::NEG_INFINITY]), f64::INFINITY);
        assert!(norm(&[1.0, f64::NAN, 2.0]).is_nan());
    }

    #[test]
    fn one_number_in_many_may_spoil_them() {
        for place in [0, 63, 64, 150] {
            for wrong in [f64::NAN, f64::INFINITY] {
                let mut x = [1.0; 151];
                assert!(all_finite(&x));
                x[place] = wrong;
                assert!(!all_finite(&x));
            }
        }
    }
}
