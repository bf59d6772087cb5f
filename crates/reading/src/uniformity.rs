//! Figures of the sensors of a plane: extremes, mean, and uniformity as EN 12464-1 has it (U0) and to the
//! maximum (Ud).
//!
//! ```text
//! U0 = min E / mean E ,     Ud = min E / max E
//! ```

use serde::Serialize;

use radiosity_work::digits::three_digits;

/// Part of the greatest value that is told as 0. Chosen.
const ROUNDING: f64 = 1e-9;

/// Mean, extremes and uniformity of irradiances, or of illuminances.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Uniformity {
    /// Mean over the sensors (unit of exitance).
    pub mean: f64,
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
    /// Least over mean; none in the dark.
    pub u0: Option<f64>,
    /// Least over greatest; none in the dark.
    pub ud: Option<f64>,
}

impl Uniformity {
    /// The figures of at least one value.
    pub fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let count = values.clone().count();
        let mean = values.clone().sum::<f64>() / count as f64;
        let min = values.clone().fold(f64::INFINITY, f64::min);
        let max = values.fold(f64::NEG_INFINITY, f64::max);
        let over = |whole: f64| (whole > 0.0).then(|| min / whole);
        Self { mean, min, max, u0: over(mean), ud: over(max) }
    }

    /// The figures in one line, with values in `unit`.
    pub fn text(&self, unit: &str) -> String {
        let rounding = ROUNDING * self.max;
        let [mean, min, max] = [self.mean, self.min, self.max]
            .map(|value| three_digits(if value.abs() < rounding { 0.0 } else { value }));
        let [u0, ud] =
            [self.u0, self.ud].map(|part| part.map_or_else(|| "–".to_owned(), |part| format!("{part:.2}")));
        format!("mean {mean} {unit}, min {min}, max {max}, U0 {u0}, Ud {ud}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_of_three_sensors() {
        let figures = Uniformity::of([100.0, 300.0, 200.0].into_iter());
        let expected = Uniformity { mean: 200.0, min: 100.0, max: 300.0, u0: Some(0.5), ud: Some(1.0 / 3.0) };
        assert_eq!(figures, expected);
        assert_eq!(Uniformity::of([0.0, 0.0].into_iter()).u0, None);
    }
}
