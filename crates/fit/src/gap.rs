//! The least gap between two flat sheets that the rules of transport can resolve.
//!
//! Tests of segments ignore their ends, and outlines ignore what is nearer to their planes than 1e-9 of the
//! length of the ray: on a large sheet that length is about its extent. Contours of two small sheets resolve
//! smaller gaps, but blockers between them must not be ignored either. Measured with plates, pictures and
//! boxes over floors: row sums hold from about 4e-9 of the larger extent on
//! (`cargo test --release --test theorems rounded::gaps` asserts it).

/// Least gap as a part of the smaller extent: twenty times the distance within which things touch, so that no
/// blocker between two sheets is taken to touch both. Contours alone would resolve less.
const OF_SMALLER: f64 = 2e-8;

/// Least gap as a part of the larger extent, measured: see the header.
const OF_LARGER: f64 = 4e-9;

/// Largest value of the least gap as a part of the smaller extent: the view factor of the two sheets then is
/// 1 less about 4e-5.
const MOST: f64 = 1e-5;

/// Gaps up to this multiple of the least let no light out. Sheets that were set apart have 1.5 times the
/// least gap, and two on each other 3 times; with a larger value gaps that were meant would count as closed.
const CLOSED: f64 = 4.0;

/// Largest gap (scene length) between sheets with these extents at which one covers the other. What they see
/// past each other is then below 1e-4 of what they exchange, for sheets of like sizes below 1e-6.
pub fn closed(a: f64, b: f64) -> f64 {
    CLOSED * least(a, b)
}

/// The least gap between sheets with these extents (scene length).
pub(super) fn least(a: f64, b: f64) -> f64 {
    let (small, large) = (a.min(b), a.max(b));
    (OF_SMALLER * small).max(OF_LARGER * large).min(MOST * small)
}
