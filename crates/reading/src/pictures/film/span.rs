//! Spans of frames, and polynomials in time through values in five of them.
//!
//! ```text
//! p(t) = f_0 + Σ_k ℓ_k(t) (f_k − f_0) ,     ℓ_k(t) = Π_{j≠k} (t − t_j)/(t_k − t_j)
//! ```
//!
//! (Lagrange). Equal values give themselves, to the bit.

/// Frames from one to another, counted from the first of a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Span {
    /// The first frame.
    pub first: usize,
    /// The last frame.
    pub last: usize,
}

/// Frames of a span in which values are known.
pub(super) const POINTS: usize = 5;

/// The points through which others are predicted, to see how smooth values are; and these.
pub(super) const EVEN: [usize; 3] = [0, 2, 4];
pub(super) const ODD: [usize; 2] = [1, 3];

impl Span {
    /// Five frames of the span, about evenly; None where they would be all.
    pub(super) fn points(self) -> Option<[usize; POINTS]> {
        let length = self.last - self.first;
        let steps = POINTS - 1;
        (length > steps).then(|| std::array::from_fn(|k| self.first + (k * length + steps / 2) / steps))
    }

    /// The half that holds a frame.
    pub(super) fn half(self, frame: usize) -> Self {
        let middle = self.first + (self.last - self.first).div_ceil(2);
        let [first, last] = if frame <= middle { [self.first, middle] } else { [middle, self.last] };
        Self { first, last }
    }

    /// All frames.
    pub(super) fn frames(self) -> impl Iterator<Item = usize> {
        self.first..=self.last
    }
}

/// The values ℓ_k of Lagrange's polynomials for these frames in another one.
pub(super) fn weights<const N: usize>(points: [usize; N], at: usize) -> [f64; N] {
    std::array::from_fn(|k| {
        let others = (0..N).filter(|j| *j != k);
        let part = |j: usize| (at as f64 - points[j] as f64) / (points[k] as f64 - points[j] as f64);
        others.map(part).product()
    })
}

/// The polynomial of these weights through some values.
pub(super) fn interpolated<const N: usize>(weights: [f64; N], values: [f64; N]) -> f64 {
    let steps = weights.iter().zip(values).map(|(weight, value)| weight * (value - values[0]));
    values[0] + steps.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_degree_four_are_met_and_equal_values_stay() {
        for last in [5, 6, 7, 11, 16] {
            let span = Span { first: 0, last };
            let points = span.points().expect("it has more frames");
            assert!(points.is_sorted_by(|a, b| a < b) && points[4] == last, "{points:?}");
            let f = |t: usize| (t as f64 / 8.0 - 1.0).powi(4) - t as f64;
            for frame in span.frames() {
                let found = interpolated(weights(points, frame), points.map(f));
                assert!((found - f(frame)).abs() < 1e-12, "{last} {frame}: {found}");
                assert_eq!(interpolated(weights(points, frame), [0.1; 5]), 0.1);
                let half = span.half(frame);
                assert!(half.frames().any(|own| own == frame) && half.last - half.first < last);
            }
        }
        assert_eq!(Span { first: 3, last: 7 }.points(), None);
    }
}
