//! Segments of a picture's plane, in pixels.

/// The straight line between two points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    /// One end.
    pub from: [f64; 2],
    /// The other end.
    pub to: [f64; 2],
}

impl Segment {
    /// Distance of a point from it.
    pub(crate) fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let Self { from, to } = self;
        let along = [to[0] - from[0], to[1] - from[1]];
        let length2 = (along[0] * along[0] + along[1] * along[1]).max(f64::MIN_POSITIVE);
        let [dx, dy] = [x - from[0], y - from[1]];
        let t = ((dx * along[0] + dy * along[1]) / length2).clamp(0.0, 1.0);
        (dx - t * along[0]).hypot(dy - t * along[1])
    }

    /// Least and greatest x, and least and greatest y, of the points nearer to the segment than `reach`.
    pub(crate) fn bounds(&self, reach: f64) -> [[f64; 2]; 2] {
        let Self { from, to } = self;
        [0, 1].map(|k| [from[k].min(to[k]) - reach, from[k].max(to[k]) + reach])
    }
}
