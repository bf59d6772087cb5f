//! Operations on vectors; sums run in a fixed order, so that they give the same bits everywhere.

pub(crate) use radiosity_core::{dot, norm};

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
