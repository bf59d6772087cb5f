//! Scales: from numbers to colours, with labels at round numbers.

use colorous::Gradient;

use super::picture::Colour;

/// A range of numbers mapped to perceptually uniform colours; numbers outside take the colours of the ends.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    gradient: Gradient,
    reversed: bool,
    range: [f64; 2],
}

impl Scale {
    /// For magnitudes: viridis, dark for the low end.
    ///
    /// # Panics
    /// If `range` does not ascend.
    pub fn sequential(range: [f64; 2]) -> Self {
        assert!(range[0] < range[1], "a range ascends");
        Self { gradient: colorous::VIRIDIS, reversed: false, range }
    }

    /// For signed numbers from −`size` to `size`: blue, white for zero, red.
    ///
    /// # Panics
    /// If `size` is not positive.
    pub fn diverging(size: f64) -> Self {
        assert!(size > 0.0, "a scale has a size");
        Self { gradient: colorous::RED_BLUE, reversed: true, range: [-size, size] }
    }

    /// Least and greatest number.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The colour of a number.
    pub fn colour(&self, value: f64) -> Colour {
        let [low, high] = self.range;
        let place = ((value - low) / (high - low)).clamp(0.0, 1.0);
        self.gradient.eval_continuous(if self.reversed { 1.0 - place } else { place }).as_array()
    }

    /// Round numbers over the range, 3 to 9 of them, with the text of each.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let [low, high] = self.range;
        let step = [1.0, 2.0, 5.0, 10.0].map(|x| x * power_below((high - low) / 8.0));
        let step = step.into_iter().find(|step| (high - low) / step <= 8.0 * (1.0 + 1e-9)).unwrap_or(step[3]);
        let slack = 1e-9 * step;
        let first = ((low - slack) / step).ceil();
        let multiples = (0..9).map(|k| first + f64::from(k)).take_while(|k| k * step <= high + slack);
        multiples.map(|k| (k * step, label(k * step, step))).collect()
    }
}

/// The least of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `size`; 1 for zero.
pub fn round_above(size: f64) -> f64 {
    if size <= 0.0 {
        return 1.0;
    }
    let power = power_below(size);
    let round = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0].map(|x| x * power);
    round.into_iter().find(|x| *x >= size * (1.0 - 1e-12)).unwrap_or(size)
}

fn power_below(size: f64) -> f64 {
    10f64.powi(size.log10().floor() as i32)
}

/// `value`, a multiple of `step`, with just enough digits to differ from its neighbours.
fn label(value: f64, step: f64) -> String {
    let digits = -(step * (1.0 + 1e-9)).log10().floor();
    // Without the −0 of rounding.
    let value = value + 0.0;
    if (-5.0..=4.0).contains(&digits) {
        format!("{value:.*}", digits.max(0.0) as usize)
    } else if value == 0.0 {
        "0".to_owned()
    } else {
        let leading = (value.abs() * (1.0 + 1e-9)).log10().floor();
        let more = (leading + digits).max(0.0) as usize;
        format!("{value:.more$e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: [f64; 2]) -> Vec<String> {
        Scale::sequential(range).ticks().into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_told_apart() {
        assert_eq!(labels([0.0, 1.2]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2"]);
        assert_eq!(labels([0.0, 8.0]), ["0", "1", "2", "3", "4", "5", "6", "7", "8"]);
        assert_eq!(labels([-300.0, 300.0]), ["-300", "-200", "-100", "0", "100", "200", "300"]);
        assert_eq!(
            labels([0.0, 4e-9]),
            ["0", "5e-10", "1.0e-9", "1.5e-9", "2.0e-9", "2.5e-9", "3.0e-9", "3.5e-9", "4.0e-9"]
        );
    }

    #[test]
    fn ends_take_what_lies_outside() {
        let scale = Scale::diverging(2.0);
        assert_eq!(scale.colour(-9.0), scale.colour(-2.0));
        assert_eq!(scale.colour(9.0), scale.colour(2.0));
        let [[low_red, _, low_blue], [high_red, _, high_blue]] = [-2.0, 2.0].map(|x| scale.colour(x));
        assert!(low_blue > low_red && high_red > high_blue, "negative is blue, positive is red");
    }

    #[test]
    fn round_numbers_are_not_below() {
        assert_eq!(round_above(0.0), 1.0);
        assert_eq!(round_above(1.0), 1.0);
        assert_eq!(round_above(9.1), 10.0);
        assert!((round_above(0.0123) - 0.015).abs() < 1e-15);
    }
}
