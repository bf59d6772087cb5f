//! Tracks: polylines by the length along them.

/// A polyline of at least two points with the length of way to each.
#[derive(Clone, Debug)]
pub(crate) struct Track<'a> {
    points: &'a [[f64; 2]],
    ways: Vec<f64>,
}

impl<'a> Track<'a> {
    /// The track through `points`.
    pub(crate) fn new(points: &'a [[f64; 2]]) -> Self {
        let steps = points.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]));
        let ways = steps.scan(0.0, |way, step| {
            *way += step;
            Some(*way)
        });
        Self { points, ways: std::iter::once(0.0).chain(ways).collect() }
    }

    /// Its points.
    pub(crate) fn points(&self) -> &'a [[f64; 2]] {
        self.points
    }

    /// The length of the whole.
    pub(crate) fn length(&self) -> f64 {
        self.ways.last().copied().unwrap_or(0.0)
    }

    /// The point at a way from 0 to the whole length.
    pub(crate) fn at(&self, way: f64) -> [f64; 2] {
        let next = self.ways.partition_point(|other| *other < way).clamp(1, self.points.len() - 1);
        let [from, to] = [self.ways[next - 1], self.ways[next]];
        let part = if to > from { ((way - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        [0, 1].map(|k| self.points[next - 1][k] + part * (self.points[next][k] - self.points[next - 1][k]))
    }

    /// The piece between two ways.
    pub(crate) fn between(&self, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let inner =
            self.points.iter().zip(&self.ways).filter(|(_, way)| (from..to).contains(*way) && **way > from);
        let inner = inner.map(|(point, _)| *point);
        std::iter::once(self.at(from)).chain(inner).chain([self.at(to)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_are_measured_along_the_line() {
        let track = Track::new(&[[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]]);
        assert_eq!((track.length(), track.at(5.0), track.at(0.0)), (7.0, [3.0, 2.0], [0.0, 0.0]));
        assert_eq!(track.between([1.0, 4.0]), [[1.0, 0.0], [3.0, 0.0], [3.0, 1.0]]);
        assert_eq!(track.between([3.0, 7.0]), [[3.0, 0.0], [3.0, 4.0]]);
    }
}
