//! Dither: even numbers in [0, 1) that belong to the pixels of a picture.
//!
//! ```text
//! u(x, y) = fract(52.9829189 fract(0.06711056 x + 0.00583715 y))
//! ```
//!
//! An encoded value e becomes ⌊e + u⌋: e on the average, so that walls whose light changes slowly show no
//! bands. Whole numbers, black and white among them, stay. Neighbours get different u: the noise has no
//! coarse grain.
//!
//! Reference: J. Jimenez, *Next generation post processing in Call of Duty: Advanced Warfare*, SIGGRAPH 2014
//! (interleaved gradient noise).

/// u at the middle of the pixel in this column and row.
pub(super) fn dither(column: u32, row: u32) -> f64 {
    let [x, y] = [column, row].map(|at| f64::from(at) + 0.5);
    (52.982_918_9 * (0.067_110_56 * x + 0.005_837_15 * y).fract()).fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_have_all_numbers_evenly() {
        for [left, top] in [[0, 0], [301, 77], [4000, 2900]] {
            let mut numbers: Vec<f64> = (0..32 * 32).map(|k| dither(left + k % 32, top + k / 32)).collect();
            numbers.sort_by(f64::total_cmp);
            let count = numbers.len() as f64;
            for (k, number) in numbers.into_iter().enumerate() {
                assert!((0.0..1.0).contains(&number));
                assert!((number - (k as f64 + 0.5) / count).abs() < 0.05, "{k}: {number}");
            }
        }
    }
}
