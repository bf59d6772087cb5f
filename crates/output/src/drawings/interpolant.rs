//! Smooth values between the samples of a grid.
//!
//! Catmull and Rom's cubics in both directions (1974): the slope at a sample is that between its neighbours.
//! They pass through the samples, are smooth, and are exact where the values are linear. Beyond the outermost
//! samples the line through the last two goes on. No value leaves the range of the samples.

/// Samples at (i, j), i from 0 to n − 1 and j from 0 to m − 1.
#[derive(Clone, Debug)]
pub(crate) struct Interpolant<'a> {
    counts: [usize; 2],
    samples: &'a [f64],
    range: [f64; 2],
}

impl<'a> Interpolant<'a> {
    /// The interpolant through `samples`, j fastest.
    ///
    /// # Panics
    /// If there are not n · m samples, at least one.
    pub(crate) fn new(counts: [usize; 2], samples: &'a [f64]) -> Self {
        assert!(!samples.is_empty() && samples.len() == counts[0] * counts[1], "a sample for each place");
        let extend = |[low, high]: [f64; 2], x: &f64| [low.min(*x), high.max(*x)];
        let range = samples.iter().fold([f64::INFINITY, f64::NEG_INFINITY], extend);
        Self { counts, samples, range }
    }

    /// The value at (i, j), which need not be whole.
    pub(crate) fn at(&self, [i, j]: [f64; 2]) -> f64 {
        let along = |row: usize| cubic(|k| self.samples[row * self.counts[1] + k], self.counts[1], j);
        cubic(along, self.counts[0], i).clamp(self.range[0], self.range[1])
    }
}

/// The value at `x` of the cubics through `count` samples at 0, 1, ….
fn cubic(sample: impl Fn(usize) -> f64, count: usize, x: f64) -> f64 {
    let last = count - 1;
    if last == 0 {
        return sample(0);
    }
    let left = x.floor().clamp(0.0, (last - 1) as f64) as usize;
    let t = x - left as f64;
    let [b, c] = [sample(left), sample(left + 1)];
    // Beyond the ends stands the sample that goes on in a line.
    let a = if left == 0 { 2.0 * b - c } else { sample(left - 1) };
    let d = if left + 1 == last { 2.0 * c - b } else { sample(left + 2) };
    let [from, to] = [0.5 * (c - a), 0.5 * (d - b)];
    if t < 0.0 {
        return b + t * from;
    }
    if t > 1.0 {
        return c + (t - 1.0) * to;
    }
    let rise = c - b;
    b + t * (from + t * ((3.0 * rise - 2.0 * from - to) + t * (from + to - 2.0 * rise)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_values_are_exact_also_beyond_the_outermost_samples() {
        let linear = |i: f64, j: f64| 3.0 - 2.0 * i + 0.5 * j;
        for counts in [[5, 4], [2, 2], [1, 3], [3, 1]] {
            let places = (0..counts[0]).flat_map(|i| (0..counts[1]).map(move |j| [i as f64, j as f64]));
            let samples: Vec<f64> = places.map(|[i, j]| linear(i, j)).collect();
            let interpolant = Interpolant { range: [-1e9, 1e9], ..Interpolant::new(counts, &samples) };
            for step in 0..50 {
                let at =
                    |count: usize| if count == 1 { 0.0 } else { f64::from(step) * 0.02 * count as f64 - 0.5 };
                let [i, j] = counts.map(at);
                assert!((interpolant.at([i, j]) - linear(i, j)).abs() < 1e-12, "{counts:?} at {i}, {j}");
            }
        }
    }

    #[test]
    fn samples_are_met_and_their_range_is_kept() {
        let samples = [0.0, 0.0, 10.0, 10.0, 3.0, 7.0];
        let interpolant = Interpolant::new([1, 6], &samples);
        for (j, sample) in samples.iter().enumerate() {
            assert_eq!(interpolant.at([0.0, j as f64]), *sample);
        }
        let all = (0..600).map(|k| interpolant.at([0.0, f64::from(k) * 0.01 - 0.5]));
        assert!(all.into_iter().all(|value| (0.0..=10.0).contains(&value)));
    }
}
