//! Which of two faces in one plane lies on the other.
//!
//! Their sizes tell: the smaller was laid on the larger, as a mat on a desk or a picture on a wall.

use std::cmp::Ordering;

/// Part by which areas that are equal within rounding may differ: copies of a sheet, and a part against the
/// whole. Rounding in single precision leaves some 10⁻⁷. With a larger value a sheet would count as within
/// another that it stands out of; with a smaller one rounded copies would count as different.
pub const SAME_AREA: f64 = 1e-6;

/// The order of two faces in one plane with these areas (of one unit), lower ones first: `Greater` where the first
/// lies on the other, `Equal` where areas are the same to [`SAME_AREA`] and do not tell. Areas are compared in steps,
/// so that the order is one of any number of faces.
pub fn layer_order(area: f64, other: f64) -> Ordering {
    let [own, other] = [area, other].map(|area| -(area.log2() / SAME_AREA).round());
    own.total_cmp(&other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smaller_lies_on_the_larger() {
        assert_eq!(layer_order(1.0, 4.0), Ordering::Greater);
        assert_eq!(layer_order(3.0, 3.0 - 1e-5), Ordering::Less);
        assert_eq!(layer_order(1.0, 1.0 + 1e-7), Ordering::Equal);
        assert_eq!(layer_order(0.0, 1.0), Ordering::Greater);
        let mut areas = [2.0, 0.5, 8.0, 1.0];
        areas.sort_by(|a, b| layer_order(*a, *b));
        assert_eq!(areas, [8.0, 2.0, 1.0, 0.5]);
    }
}
