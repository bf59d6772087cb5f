//! Whether means err as their standard errors say.
//!
//! With the standard error s of eight independent shifts, t = (M − exact)/s has Student's distribution of seven
//! degrees of freedom, and t² is F(1, 7): its mean is 7/5, its variance 2·7²·6/(5²·3).

/// Values that |t| exceeds with the probabilities 0.9, 0.8, …, 0.1 (tables of Student's distribution, ν = 7).
const DECILES: [f64; 9] = [0.1303, 0.2632, 0.4015, 0.5491, 0.7111, 0.8960, 1.1192, 1.4149, 1.8946];

/// χ² of nine degrees of freedom that is exceeded once in a thousand times.
const CHI_SQUARED: f64 = 27.88;

/// Mean and variance of F(1, 7).
const MEAN: f64 = 7.0 / 5.0;
const VARIANCE: f64 = 2.0 * 49.0 * 6.0 / (25.0 * 3.0);

/// Standard deviations that a mean of many may be off.
const FAR: f64 = 4.0;

/// |t| that one reading in 10⁵ exceeds (ν = 7).
const FARTHEST: f64 = 11.2;

/// Asserts that quotients t are those of chance.
#[track_caller]
pub(super) fn assert_fair(quotients: &[f64]) {
    let count = quotients.len() as f64;
    let mean = quotients.iter().sum::<f64>() / count;
    let square = quotients.iter().map(|own| own * own).sum::<f64>() / count;
    let largest = quotients.iter().fold(0.0_f64, |largest, own| largest.max(own.abs()));
    let chi = chi_squared(quotients);
    let told = format!(
        "{count} readings: mean {mean:.3}, mean square {square:.2}, χ² {chi:.1}, largest {largest:.1}"
    );
    println!("{told}");
    assert!(mean.abs() < FAR * (MEAN / count).sqrt(), "{told}");
    assert!((square - MEAN).abs() < FAR * (VARIANCE / count).sqrt(), "{told}");
    assert!(chi < CHI_SQUARED, "{told}");
    assert!(largest < FARTHEST, "{told}");
}

/// χ² of the numbers of |t| between deciles.
fn chi_squared(quotients: &[f64]) -> f64 {
    let mut counts = [0.0; DECILES.len() + 1];
    quotients.iter().for_each(|own| counts[DECILES.partition_point(|end| *end < own.abs())] += 1.0);
    let expected = quotients.len() as f64 / counts.len() as f64;
    counts.iter().map(|own| (own - expected) * (own - expected) / expected).sum()
}
