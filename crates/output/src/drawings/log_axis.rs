//! Logarithmic axes of charts.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// A logarithmic axis over whole decades, labelled 10ᵏ at each.
#[derive(Clone, Debug)]
pub struct LogAxis {
    lowest: i32,
    highest: i32,
}

impl LogAxis {
    /// The decades that hold `values`, at least one.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let [lowest, highest] = if low <= high { [low.floor() as i32, high.ceil() as i32] } else { [0, 1] };
        Self { lowest, highest: highest.max(lowest + 1) }
    }
}

impl Ranged for LogAxis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value.log10() - f64::from(self.lowest)) / f64::from(self.highest - self.lowest);
        limit.0 + (f64::from(limit.1 - limit.0) * part).round() as i32
    }

    /// The powers of ten are the labelled points, their multiples the light ones.
    fn key_points<H: KeyPointHint>(&self, hint: H) -> Vec<f64> {
        let decades = self.lowest..=self.highest;
        if hint.weight().allow_light_points() {
            let multiples = |k: i32| (1..10).map(move |m| f64::from(m) * 10f64.powi(k));
            let highest = 10f64.powi(self.highest);
            decades.flat_map(multiples).filter(|x| *x <= highest).collect()
        } else {
            decades.map(|k| 10f64.powi(k)).collect()
        }
    }

    fn range(&self) -> Range<f64> {
        10f64.powi(self.lowest)..10f64.powi(self.highest)
    }
}

impl ValueFormatter<f64> for LogAxis {
    fn format_ext(&self, value: &f64) -> String {
        const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let exponent = (value.log10().round() as i32).to_string();
        let raise = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
        "10".chars().chain(exponent.chars().map(raise)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_span_whole_decades_with_raised_exponents() {
        let axis = LogAxis::around([0.02, 3.0, 0.5].into_iter());
        assert_eq!(axis.range(), 0.01..10.0);
        assert_eq!(axis.format_ext(&0.01), "10⁻²");
        assert_eq!(axis.map(&0.1, (0, 300)), 100);
        assert_eq!(LogAxis::around(std::iter::empty()).range(), 1.0..10.0);
    }
}
