//! Ranges of numbers in files and code; those of materials are in [`Material`](crate::Material).

use crate::fault::Fault;

/// The highest order of a basis: 231 functions an element and 53 361 numbers a block, which grow with its
/// fourth power.
pub const MAX_ORDER: usize = 20;

/// The finest `subdivide`, elements along one parameter: 65 536 on a surface. A larger number is a slip.
pub const MAX_PARTS: usize = 256;

/// Largest width and height of a picture: 268 million pixels in all, some gigabytes of light. A larger number
/// is a slip.
pub const MAX_PIXELS: usize = 16384;

/// Most copies along one step of an array: as many as there may be surfaces in all.
pub const MAX_COPIES: usize = 1_000_000;

/// Largest number: areas and fourth powers of distances stay below the largest f64, since (1e30)⁴ = 1e120.
pub const LARGEST: f64 = 1e30;

/// Checks that `value` is finite and `inside` the `range` of the number that messages call `what`.
pub(super) fn check_range(
    value: f64,
    inside: bool,
    what: &'static str,
    range: &'static str,
) -> Result<(), Fault> {
    match (value.is_finite(), inside) {
        (false, _) => Err(Fault::not_finite(value)),
        (true, false) => Err(Fault::out_of_range(what, value, range)),
        (true, true) => Ok(()),
    }
}

/// As [`check_range`], with the cure of a number outside the range.
pub(super) fn check_range_or(
    value: f64,
    inside: bool,
    what: &'static str,
    range: &'static str,
    cure: &'static str,
) -> Result<(), Fault> {
    check_range(value, inside, what, range)
        .map_err(|fault| if value.is_finite() { fault.cured(cure) } else { fault })
}

/// Checks that a number is finite and at most 1e30 in magnitude, so that it can be computed with.
pub fn check_number(value: f64) -> Result<(), Fault> {
    match value {
        _ if !value.is_finite() => Err(Fault::not_finite(value)),
        _ if value.abs() > LARGEST => Err(Fault::out_of_range("the number", value, "−1e30 ≤ x ≤ 1e30")),
        _ => Ok(()),
    }
}

/// Checks that a factor on light is ≥ 0, finite and at most 1e30.
pub fn check_factor(value: f64) -> Result<(), Fault> {
    check_range(value, value >= 0.0, "the factor", "factor ≥ 0")?;
    check_number(value)
}

/// Checks that 0 ≤ order ≤ [`MAX_ORDER`].
pub fn check_order(order: usize) -> Result<(), Fault> {
    counted(order, 0, MAX_ORDER, "the order", "0 ≤ order ≤ 20")
}

/// Checks the number of elements along one parameter, 1 to 256.
pub fn check_parts(parts: usize) -> Result<(), Fault> {
    counted(parts, 1, MAX_PARTS, "the number of elements", "1 ≤ subdivide ≤ 256")
}

/// Checks the number of copies along one step of an array, 1 to 10⁶.
pub fn check_copies(copies: usize) -> Result<(), Fault> {
    counted(copies, 1, MAX_COPIES, "the number of copies", "1 ≤ count ≤ 1000000")
}

/// Checks the width or the height of a picture, 1 to 16384 pixels.
pub fn check_pixels(pixels: usize) -> Result<(), Fault> {
    counted(pixels, 1, MAX_PIXELS, "the picture's size", "1 ≤ pixels ≤ 16384")
}

/// Checks the vertical angle of view, 0 < fov < 180 degrees.
pub fn check_fov(fov: f64) -> Result<(), Fault> {
    if fov > 0.0 && fov < 180.0 {
        return Ok(());
    }
    Err(Fault::out_of_range("the angle of view", fov, "0 < fov < 180 degrees"))
}

fn counted(
    count: usize,
    least: usize,
    most: usize,
    what: &'static str,
    range: &'static str,
) -> Result<(), Fault> {
    match (least..=most).contains(&count) {
        true => Ok(()),
        false => Err(Fault::out_of_range(what, count as f64, range)),
    }
}
