//! The rounding of coordinates, inferred from the coordinates.
//!
//! A number of single precision with more than a few decimals was rounded to single precision: of numbers in
//! double precision one in 2²⁹ is one by chance. 0.5 and 5 400 000 may have been typed and say nothing.

use glam::DVec3;

use crate::tolerances::{ROUNDOFF_OF_DOUBLE, ROUNDOFF_OF_SINGLE};

/// Multiples of one over this number may have been typed. A number of single precision that has more than
/// three decimals, such as 0.0625, is taken for a rounded one where all others are of single precision too;
/// with a larger value fewer are, and fewer models of single precision are known as such.
const PLAIN: f64 = 1000.0;

/// Largest rounding error (their unit of length) along the unit vector `direction` of `points` given in one
/// precision; each coordinate is taken to be rounded as its largest value is. Without a direction, along any.
pub fn coordinate_rounding(points: &[DVec3], direction: Option<DVec3>) -> f64 {
    let largest = points.iter().fold(DVec3::ZERO, |largest, x| largest.max(x.abs()));
    let along = direction.map_or(DVec3::ONE, DVec3::abs);
    largest.dot(along) * unit_roundoff(points)
}

/// Unit roundoff, 2⁻²⁴ or 2⁻⁵³, of the precision that `points` are given in.
pub fn unit_roundoff(points: &[DVec3]) -> f64 {
    let coordinates = || points.iter().flat_map(|x| x.to_array());
    let is_single = coordinates().all(|x| f64::from(x as f32) == x) && !coordinates().all(is_plain);
    if is_single { ROUNDOFF_OF_SINGLE } else { ROUNDOFF_OF_DOUBLE }
}

fn is_plain(x: f64) -> bool {
    (x * PLAIN).round() / PLAIN == x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_numbers_of_single_precision_were_rounded_to_it() {
        let third = f64::from(1.0f32 / 3.0);
        let of = |x: f64| {
            coordinate_rounding(&[DVec3::new(x, 4.0, 0.0), DVec3::new(0.5, 0.0, 2.25)], Some(DVec3::Y))
        };
        assert_eq!(of(0.125), 4.0 * ROUNDOFF_OF_DOUBLE);
        assert_eq!(of(third), 4.0 * ROUNDOFF_OF_SINGLE);
        assert_eq!(of(1.0 / 3.0), 4.0 * ROUNDOFF_OF_DOUBLE);
        // Map coordinates in whole metres.
        assert_eq!(of(5_400_001.0), 4.0 * ROUNDOFF_OF_DOUBLE);
    }

    #[test]
    fn what_is_level_is_not_rounded_upwards() {
        let far = f64::from(1e5f32 / 3.0);
        let floor = [DVec3::new(far, far, 0.0), DVec3::new(-far, 0.0, 0.0)];
        assert_eq!(coordinate_rounding(&floor, Some(DVec3::Z)), 0.0);
        assert!(coordinate_rounding(&floor, None) > 1e-3);
    }
}
