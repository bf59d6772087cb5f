//! Polylines by the length along them.

/// A polyline of at least two points with the length along it up to each.
#[derive(Clone, Debug)]
pub(crate) struct Polyline<'a> {
    points: &'a [[f64; 2]],
    lengths: Vec<f64>,
}

impl<'a> Polyline<'a> {
    /// The polyline through `points`.
    pub(crate) fn new(points: &'a [[f64; 2]]) -> Self {
        let steps = points.windows(2).map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]));
        let lengths = steps.scan(0.0, |length, step| {
            *length += step;
            Some(*length)
        });
        Self { points, lengths: std::iter::once(0.0).chain(lengths).collect() }
    }

    /// Its points.
    pub(crate) fn points(&self) -> &'a [[f64; 2]] {
        self.points
    }

    /// The length of the whole.
    pub(crate) fn length(&self) -> f64 {
        self.lengths.last().copied().unwrap_or(0.0)
    }

    /// The point at a length along it, from 0 to the whole.
    pub(crate) fn at(&self, length: f64) -> [f64; 2] {
        let next = self.lengths.partition_point(|other| *other < length).clamp(1, self.points.len() - 1);
        let [from, to] = [self.lengths[next - 1], self.lengths[next]];
        let part = if to > from { ((length - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        [0, 1].map(|k| self.points[next - 1][k] + part * (self.points[next][k] - self.points[next - 1][k]))
    }

    /// The piece between two lengths along it.
    pub(crate) fn between(&self, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let inner = self
            .points
            .iter()
            .zip(&self.lengths)
            .filter(|(_, length)| (from..to).contains(*length) && **length > from);
        let inner = inner.map(|(point, _)| *point);
        std::iter::once(self.at(from)).chain(inner).chain([self.at(to)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_measured_along_the_line() {
        let polyline = Polyline::new(&[[0.0, 0.0], [3.0, 0.0], [3.0, 4.0]]);
        assert_eq!((polyline.length(), polyline.at(5.0), polyline.at(0.0)), (7.0, [3.0, 2.0], [0.0, 0.0]));
        assert_eq!(polyline.between([1.0, 4.0]), [[1.0, 0.0], [3.0, 0.0], [3.0, 1.0]]);
        assert_eq!(polyline.between([3.0, 7.0]), [[3.0, 0.0], [3.0, 4.0]]);
    }
}
