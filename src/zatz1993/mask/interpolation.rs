//! Values between the nodes of a mask, and instead of those that are not known.

/// The bilinear interpolant of the corners (0, 0), (0, 1), (1, 0), (1, 1).
pub(super) fn bilinear([c00, c01, c10, c11]: [f64; 4], [a, b]: [f64; 2]) -> f64 {
    (1.0 - a) * ((1.0 - b) * c00 + b * c01) + a * ((1.0 - b) * c10 + b * c11)
}

/// The known value nearest to a place, of places and values; the earliest of equally near ones.
pub(super) fn nearest<'a>(
    place: [f64; 2],
    known: impl Iterator<Item = ([f64; 2], &'a Option<f64>)>,
) -> Option<f64> {
    let mut best: Option<(f64, f64)> = None;
    for (other, value) in known {
        let Some(value) = *value else { continue };
        let distance = (place[0] - other[0]).powi(2) + (place[1] - other[1]).powi(2);
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, value));
        }
    }
    best.map(|(_, value)| value)
}
