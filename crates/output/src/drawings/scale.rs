//! Scales: from numbers to colours, with labels at round numbers.

use colorous::Gradient;

use super::nice_numbers::{multiples, ratios};
use super::picture::Colour;
use super::tick::Tick;

/// A range of numbers mapped to perceptually uniform colours; numbers outside take the colours of the ends.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    gradient: Gradient,
    reversed: bool,
    range: [f64; 2],
    steps: Steps,
}

/// Least number of a scale of equal ratios over the greatest, where it is chosen. Chosen.
pub const DEEPEST: f64 = 1e-4;

/// The quantity that is equal between neighbouring colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Steps {
    Differences,
    Ratios,
}

impl Scale {
    /// Scale for magnitudes: viridis, dark for the low end. Its lightness ascends, so that it can be read in
    /// grey and by the colour-blind.
    ///
    /// # Panics
    /// If `range` does not ascend.
    pub fn sequential(range: [f64; 2]) -> Self {
        assert!(range[0] < range[1], "a range ascends");
        Self { gradient: colorous::VIRIDIS, reversed: false, range, steps: Steps::Differences }
    }

    /// Scale for magnitudes with equal ratios instead of equal differences between neighbouring colours.
    ///
    /// # Panics
    /// If `range` does not ascend from a number above 0.
    pub fn logarithmic(range: [f64; 2]) -> Self {
        assert!(range[0] > 0.0, "logarithms are of positive numbers");
        Self { steps: Steps::Ratios, ..Self::sequential(range) }
    }

    /// Scale for signed numbers from −`size` to `size`: blue, white for zero, red.
    ///
    /// # Panics
    /// If `size` is not positive.
    pub fn diverging(size: f64) -> Self {
        assert!(size > 0.0, "a scale has a size");
        let range = [-size, size];
        Self { gradient: colorous::RED_BLUE, reversed: true, range, steps: Steps::Differences }
    }

    /// Least and greatest number.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The place of a number on the scale, from 0 to 1.
    pub(super) fn place(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let part = match self.steps {
            Steps::Differences => (value - low) / (high - low),
            Steps::Ratios => (value.max(low) / low).ln() / (high / low).ln(),
        };
        part.clamp(0.0, 1.0)
    }

    /// The colour of a number.
    pub(crate) fn colour(&self, value: f64) -> Colour {
        self.colour_at(self.place(value))
    }

    /// The colour at a place from 0 to 1.
    pub(super) fn colour_at(&self, place: f64) -> Colour {
        self.gradient.eval_continuous(if self.reversed { 1.0 - place } else { place }).as_array()
    }

    /// The scale over another range; one with equal ratios is cut off at a ten-thousandth of its upper end.
    ///
    /// # Panics
    /// If `range` does not ascend.
    #[must_use]
    pub(super) fn over(&self, [low, high]: [f64; 2]) -> Self {
        assert!(low < high, "a range ascends");
        let low = if self.steps == Steps::Ratios { low.max(DEEPEST * high) } else { low };
        Self { range: [low, high], ..*self }
    }

    /// Round numbers over the range, 3 to 9 of them, with the text of each.
    pub(super) fn ticks(&self) -> Vec<Tick> {
        match self.steps {
            Steps::Differences => multiples(self.range),
            Steps::Ratios => ratios(self.range),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_take_what_lies_outside() {
        let scale = Scale::diverging(2.0);
        assert_eq!(scale.colour(-9.0), scale.colour(-2.0));
        assert_eq!(scale.colour(9.0), scale.colour(2.0));
        let [[low_red, _, low_blue], [high_red, _, high_blue]] = [-2.0, 2.0].map(|x| scale.colour(x));
        assert!(low_blue > low_red && high_red > high_blue, "negative is blue, positive is red");
        let scale = Scale::logarithmic([1.0, 100.0]);
        assert_eq!(
            [-1.0, 0.0, 1.0, 10.0, 100.0, 1e9].map(|x| scale.place(x)),
            [0.0, 0.0, 0.0, 0.5, 1.0, 1.0]
        );
    }

    /// Light of an sRGB code, IEC 61966-2-1.
    fn linear(code: u8) -> f64 {
        let x = f64::from(code) / 255.0;
        if x <= 0.040_45 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    }

    /// Lightness L* of linear light in sRGB's primaries (CIE 1976).
    fn lightness([red, green, blue]: [f64; 3]) -> f64 {
        let luminance = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        if luminance > 216.0 / 24389.0 { 116.0 * luminance.cbrt() - 16.0 } else { luminance * 24389.0 / 27.0 }
    }

    /// Colours that a viewer without red (protanopia), green (deuteranopia) or blue cones (tritanopia) sees:
    /// Machado, Oliveira and Fernandes 2009, severity 1.
    const DICHROMATS: [[[f64; 3]; 3]; 3] = [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    #[test]
    fn magnitudes_ascend_in_lightness_for_every_viewer_and_in_grey() {
        let scale = Scale::sequential([0.0, 1.0]);
        let colours = (0..=64).map(|k| scale.colour(f64::from(k) / 64.0).map(linear)).collect::<Vec<_>>();
        let seen_by = |view: &[[f64; 3]; 3], colour: &[f64; 3]| -> [f64; 3] {
            view.map(|row| row.iter().zip(colour).map(|(a, b)| a * b).sum())
        };
        let as_printed = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for view in DICHROMATS.iter().chain([&as_printed]) {
            let shades: Vec<f64> = colours.iter().map(|colour| lightness(seen_by(view, colour))).collect();
            assert!(shades.windows(2).all(|pair| pair[0] < pair[1]), "{shades:?}");
            assert!(shades[64] - shades[0] > 70.0, "most of the way from black to white is used");
        }
    }
}
