//! The factors D_0, D_1, … of the coefficients before the first step, times the units of the steps.

use super::step::steps;
use crate::double::Double;
use crate::math::sqrt;

/// Below this the square is taken 2⁵¹² times larger: its second half would lose bits below 2⁻¹⁰²².
const SMALL: f64 = power_of_two(-512);

/// D_n, n = 0, 1, …, each within 1.1 ulp: the squares follow their recurrence in two floats.
pub(super) struct Scales {
    n: usize,
    low: usize,
    high: usize,
    /// D_n²/(2n + a + b + 1)/`root`².
    square: Double,
    root: f64,
}

impl Scales {
    pub(super) fn new(a: u8, b: u8) -> Scales {
        let (low, high) = (a.min(b) as usize, a.max(b) as usize);
        // 2^−|a−b| min!/(2 max! (a + b)!) · Π unit², factor by factor.
        let mut square = Double::new(0.5 * power_of_two(low as i32 - high as i32));
        for (j, step) in (1..).zip(steps(a, b)) {
            let unit = step.unit();
            square = square.mul(Double::ratio(unit * unit, (j * (low + j)) as f64));
        }
        Scales { n: 0, low, high, square, root: 1.0 }
    }
}

impl Iterator for Scales {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let sum = self.low + self.high;
        let scale = self.root * sqrt(self.square.hi * (2 * self.n + sum + 1) as f64);
        self.n += 1;
        let (above, below) = (self.n * (self.n + self.low), (self.n + self.high) * (self.n + sum));
        self.square = self.square.mul(Double::ratio(above as f64, below as f64));
        if self.square.hi < SMALL {
            self.square = self.square.scale(power_of_two(512));
            self.root *= power_of_two(-256);
        }
        Some(scale)
    }
}

/// 2ᵉ for −1022 ≤ e ≤ 1023.
const fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((1023 + e) as u64) << 52)
}
