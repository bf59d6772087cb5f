//! Shares of all emitters in the light that rays are spread for.

/// A share of an element below this one is not looked at. Chosen.
const LEAST: f64 = 1e-3;

/// Share of each element in the light that is known beforehand, of each light group in each band: what it
/// emits, and reflects of luminaires; 0 where nothing shines.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LightShares(Vec<Vec<f64>>);

impl LightShares {
    /// The shares for the power of each element, of each group in each band.
    pub(super) fn of(powers: Vec<Vec<f64>>) -> Self {
        let shares = |own: Vec<f64>| {
            let all: f64 = own.iter().sum();
            own.into_iter().map(|power| if all > 0.0 { power / all } else { 0.0 }).collect()
        };
        Self(powers.into_iter().map(shares).collect())
    }

    /// Whether any share has grown by more than a factor since `before`.
    pub(super) fn exceed(&self, before: &Self, factor: f64) -> bool {
        let grows = |(own, before): (&Vec<f64>, &Vec<f64>)| {
            let mut pairs = own.iter().zip(before);
            own.len() != before.len() || pairs.any(|(own, before)| *own > LEAST && *own > factor * before)
        };
        self.0.len() != before.0.len() || self.0.iter().zip(&before.0).any(grows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lamps_that_take_over_are_seen_and_those_that_are_dimmed_together_are_not() {
        let shares = |powers: &[f64]| LightShares::of(vec![powers.to_vec()]);
        let before = shares(&[8.0, 2.0, 0.0]);
        assert!(!shares(&[0.8, 0.2, 0.0]).exceed(&before, 1.01));
        assert!(!shares(&[7.0, 3.0, 0.0]).exceed(&before, 2.0));
        assert!(shares(&[4.0, 6.0, 0.0]).exceed(&before, 2.0));
        assert!(shares(&[8.0, 2.0, 0.1]).exceed(&before, 2.0));
        assert!(!shares(&[0.0, 0.0, 0.0]).exceed(&before, 2.0));
        assert!(shares(&[1.0, 0.0, 0.0]).exceed(&shares(&[0.0; 3]), 2.0));
        assert!(LightShares::of(vec![]).exceed(&before, 2.0));
    }
}
