//! Round numbers: ends and ticks of scales, levels of isolines, with their texts.

use super::tick::Tick;
use radiosity_work::digits::short;

/// Mantissas of round ends of a range.
const ENDS: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// Part of a number by which rounding may make it miss a round one.
const SLACK: f64 = 1e-9;

/// The least of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `size`; 1 for zero.
pub fn round_above(size: f64) -> f64 {
    if size <= 0.0 {
        return 1.0;
    }
    let round = ENDS.map(|x| x * power_below(size));
    round.into_iter().find(|x| *x >= size * (1.0 - 1e-12)).unwrap_or(size)
}

/// The greatest of these numbers that is not above `size` > 0.
pub fn round_below(size: f64) -> f64 {
    let round = ENDS.map(|x| x * power_below(size));
    round.into_iter().rev().find(|x| *x <= size * (1.0 + 1e-12)).unwrap_or(size)
}

/// A range of round ends around one that ascends or is a single number: multiples of a power of ten that is
/// at most half as wide.
pub fn round_around([low, high]: [f64; 2]) -> [f64; 2] {
    let step = if high > low { power_below(0.5 * (high - low)) } else { 1.0 };
    let [first, last] = [(low / step + SLACK).floor(), (high / step - SLACK).ceil()];
    [first * step, last.max(first + 1.0) * step]
}

/// Multiples of 1, 2 or 5 times a power of ten in a range that ascends, 3 to 9 of them, with the text of
/// each.
pub(crate) fn multiples([low, high]: [f64; 2]) -> Vec<Tick> {
    let step = [1.0, 2.0, 5.0, 10.0].map(|x| x * power_below((high - low) / 8.0));
    let step = step.into_iter().find(|step| (high - low) / step <= 8.0 * (1.0 + SLACK)).unwrap_or(step[3]);
    let slack = SLACK * step;
    let first = ((low - slack) / step).ceil();
    let multiples = (0..9).map(|k| first + f64::from(k)).take_while(|k| k * step <= high + slack);
    multiples.map(|k| Tick { value: k * step, text: label(k * step, step) }).collect()
}

/// Mantissas of numbers that follow each other in about equal ratios, finest first.
const RATIOS: [&[f64]; 4] = [
    &[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0],
    &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
    &[1.0, 2.0, 5.0],
    &[1.0],
];

/// Round numbers in about equal ratios in a range of positive numbers that ascends, 3 to 9 of them, with the
/// text of each. In a range of less than about a factor of 2 they are multiples.
pub(super) fn ratios([low, high]: [f64; 2]) -> Vec<Tick> {
    let powers = low.log10().floor() as i32..=high.log10().floor() as i32;
    let within = |mantissas: &'static [f64], every: usize| -> Vec<f64> {
        let all = powers
            .clone()
            .step_by(every)
            .flat_map(|power| mantissas.iter().map(move |x| x * 10f64.powi(power)));
        all.filter(|x| (low * (1.0 - SLACK)..=high * (1.0 + SLACK)).contains(x)).collect()
    };
    let fine = RATIOS.into_iter().map(|mantissas| within(mantissas, 1));
    let coarse = (2..).map(|every| within(RATIOS[3], every));
    let chosen = fine.chain(coarse).find(|numbers| numbers.len() <= 9).unwrap_or_default();
    match chosen.len() {
        0..3 => multiples([low, high]),
        _ => chosen.into_iter().map(|value| Tick { value, text: short(value) }).collect(),
    }
}

fn power_below(size: f64) -> f64 {
    10f64.powi(size.log10().floor() as i32)
}

/// `value`, a multiple of `step`, with just enough digits to differ from its neighbours.
fn label(value: f64, step: f64) -> String {
    let digits = -(step * (1.0 + SLACK)).log10().floor();
    // Without the −0 of rounding.
    let value = value + 0.0;
    if (-5.0..=4.0).contains(&digits) {
        format!("{value:.*}", digits.max(0.0) as usize)
    } else if value == 0.0 {
        "0".to_owned()
    } else {
        let leading = (value.abs() * (1.0 + SLACK)).log10().floor();
        let more = (leading + digits).max(0.0) as usize;
        format!("{value:.more$e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(ticks: Vec<Tick>) -> Vec<String> {
        ticks.into_iter().map(|tick| tick.text).collect()
    }

    #[test]
    fn multiples_are_round_and_told_apart() {
        let texts = |range| texts(multiples(range));
        assert_eq!(texts([0.0, 1.2]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2"]);
        assert_eq!(texts([0.0, 8.0]), ["0", "1", "2", "3", "4", "5", "6", "7", "8"]);
        assert_eq!(texts([-300.0, 300.0]), ["-300", "-200", "-100", "0", "100", "200", "300"]);
        assert_eq!(
            texts([0.0, 4e-9]),
            ["0", "5e-10", "1.0e-9", "1.5e-9", "2.0e-9", "2.5e-9", "3.0e-9", "3.5e-9", "4.0e-9"]
        );
    }

    #[test]
    fn ratios_are_as_dense_as_there_is_room() {
        let texts = |range| texts(ratios(range));
        assert_eq!(texts([1.0, 8.0]), ["1", "1.5", "2", "3", "5", "7"]);
        assert_eq!(texts([0.1, 100.0]), ["0.1", "1", "10", "100"]);
        assert_eq!(texts([0.15, 100.0]), ["0.2", "0.5", "1", "2", "5", "10", "20", "50", "100"]);
        assert_eq!(texts([1e-5, 1.0]), ["1e-5", "0.0001", "0.001", "0.01", "0.1", "1"]);
        assert_eq!(texts([1e-20, 1.0]).len(), 7);
        assert_eq!(texts([1.0, 1.1]), ["1.00", "1.02", "1.04", "1.06", "1.08", "1.10"]);
    }

    #[test]
    fn round_numbers_lie_on_their_side() {
        assert_eq!(round_above(0.0), 1.0);
        assert_eq!(round_above(1.0), 1.0);
        assert_eq!(round_above(9.1), 10.0);
        assert!((round_above(0.0123) - 0.015).abs() < 1e-15);
        assert_eq!(round_below(1.0), 1.0);
        assert_eq!(round_below(9.1), 8.0);
        assert!((round_below(0.0123) - 0.012).abs() < 1e-15);
    }
}
