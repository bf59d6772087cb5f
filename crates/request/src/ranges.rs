//! Ranges of the numbers that options take, with what is expected where one is refused.

use std::fmt::Display;
use std::ops::RangeInclusive;

use bytesize::ByteSize;

/// Number of graded layers.
pub const LAYERS: RangeInclusive<u64> = 0..=8;

/// Number of reflections that are counted. Chosen: all but 5e-5 of the light of a closed room of reflectance
/// 0.99.
pub const BOUNCES: RangeInclusive<u64> = 0..=1000;

/// Threads: more would bring any machine to a standstill. Chosen.
pub const THREADS: RangeInclusive<u64> = 1..=1024;

/// Number of iterations of a solver.
pub const ITERATIONS: RangeInclusive<u64> = 1..=u32::MAX as u64;

/// Number of cells along a side of a mask.
pub const MASK_CELLS: RangeInclusive<u64> = 1..=1000;

/// Number of pixels along a side of a picture, and of cells along a side of a surface, as in scenes.
pub const PIXELS: RangeInclusive<u64> = 1..=16384;

/// Number of camera rays along a side of a pixel.
pub const SAMPLES: RangeInclusive<u64> = 1..=64;

/// Number of points along a side of a cell.
pub const POINTS: RangeInclusive<u64> = 1..=64;

/// A number above 0.
///
/// # Errors
/// Text of the expected range.
pub fn positive(x: f64) -> Result<f64, &'static str> {
    checked(x, x > 0.0, "expected a number above 0, such as 1e-8")
}

/// A time in seconds.
///
/// # Errors
/// Text of the expected range.
pub fn seconds(x: f64) -> Result<f64, &'static str> {
    checked(x, x > 0.0, "expected seconds, above 0, such as 30")
}

/// A length that is not negative.
///
/// # Errors
/// Text of the expected range.
pub fn not_negative(x: f64) -> Result<f64, &'static str> {
    checked(x, x >= 0.0, "expected a length of 0 or more, such as 1e-6")
}

/// A number between 0 and 1.
///
/// # Errors
/// Text of the expected range.
pub fn fraction(x: f64) -> Result<f64, &'static str> {
    checked(x, x > 0.0 && x < 1.0, "expected a number above 0 and below 1, such as 1e-3")
}

/// A relative accuracy: below 1e-14 rounding decides, and work would never end.
///
/// # Errors
/// Text of the expected range.
pub fn accuracy(x: f64) -> Result<f64, &'static str> {
    let expected = "expected a number from 1e-14, near rounding, to below 1, such as 1e-3";
    checked(x, (1e-14..1.0).contains(&x), expected)
}

/// A number of bytes such as `500M`, `2G` or `1.5GiB`.
///
/// # Errors
/// Text of the expected range.
pub fn bytes(text: &str) -> Result<u64, String> {
    let parsed = text.parse::<ByteSize>().map(|size| size.as_u64()).ok().filter(|size| *size > 0);
    parsed.ok_or_else(|| "expected a number of bytes, such as 500M, 2G or 2GiB".to_owned())
}

fn checked(x: f64, is_inside: bool, expected: &'static str) -> Result<f64, &'static str> {
    if x.is_finite() && is_inside { Ok(x) } else { Err(expected) }
}

/// Message for a number that is no whole number of this range.
pub fn whole(range: &RangeInclusive<impl Display>) -> String {
    format!("expected a whole number from {} to {}", range.start(), range.end())
}
