//! The least gap between two flat sheets that the rules of transport tell from none.
//!
//! Shadows pass over the ends of segments, and outlines over what is as near to their planes as 1e-9 of the distance that light
//! goes: of what lies on a large sheet, about its extent. Contours of two small sheets tell smaller gaps apart, but what lies
//! between them must not be passed over either. Measured with plates, pictures and boxes over floors: row sums hold from
//! about 4e-9 of the larger extent on (`tests/rounded/gaps.rs`).

/// Least gap as a part of the smaller and of the larger extent of two sheets, and the largest part of the smaller that is taken
/// for none: their view factor is 1 less about four times that.
const OF_SMALLER: f64 = 2e-8;
const OF_LARGER: f64 = 4e-9;
const MOST: f64 = 1e-5;

/// Gaps that carry nothing to the sides, in multiples of the least: sheets that were set apart, several on each other, too.
const CLOSED: f64 = 4.0;

/// The gap between sheets with these extents up to which one covers the other: what they see past each other is below 1e-4
/// of what they exchange, and of sheets of like sizes below 1e-6 (scene length).
pub(crate) fn closed(a: f64, b: f64) -> f64 {
    CLOSED * least(a, b)
}

/// The least gap between sheets with these extents (scene length).
pub(super) fn least(a: f64, b: f64) -> f64 {
    let (small, large) = (a.min(b), a.max(b));
    (OF_SMALLER * small).max(OF_LARGER * large).min(MOST * small)
}
