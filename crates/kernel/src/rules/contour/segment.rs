//! An edge of a polygon, parametrised by arc length.

use radiosity_geom::DVec3;

/// The points `start` + s `direction`, 0 ≤ s ≤ `length`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub start: DVec3,
    pub end: DVec3,
    /// Unit vector from start to end.
    pub direction: DVec3,
    pub length: f64,
}

impl Segment {
    /// The segment from `start` to `end`, which differ.
    pub(super) fn between(start: DVec3, end: DVec3) -> Self {
        let length = start.distance(end);
        Self { start, end, direction: (end - start) / length, length }
    }

    /// This segment in the opposite direction.
    pub(super) fn reversed(&self) -> Self {
        Self { start: self.end, end: self.start, direction: -self.direction, length: self.length }
    }
}

/// Start and end of each edge of a polygon.
pub(super) fn edges(polygon: &[DVec3]) -> impl Iterator<Item = [DVec3; 2]> + Clone + '_ {
    let last = polygon.len() - 1;
    (0..=last).map(move |k| [polygon[k], polygon[if k == last { 0 } else { k + 1 }]])
}

/// The edges of a polygon that have length.
pub(super) fn segments(polygon: &[DVec3]) -> Vec<Segment> {
    edges(polygon)
        .filter(|[start, end]| start != end)
        .map(|[start, end]| Segment::between(start, end))
        .collect()
}
