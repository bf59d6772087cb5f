//! Round numbers: ends and ticks of scales, levels of isolines, with their texts.

use super::mark::Mark;

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
pub(crate) fn multiples([low, high]: [f64; 2]) -> Vec<Mark> {
    let step = [1.0, 2.0, 5.0, 10.0].map(|x| x * power_below((high - low) / 8.0));
    let step = step.into_iter().find(|step| (high - low) / step <= 8.0 * (1.0 + SLACK)).unwrap_or(step[3]);
    let slack = SLACK * step;
    let first = ((low - slack) / step).ceil();
    let multiples = (0..9).map(|k| first + f64::from(k)).take_while(|k| k * step <= high + slack);
    multiples.map(|k| Mark { value: k * step, text: label(k * step, step) }).collect()
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
pub(super) fn ratios([low, high]: [f64; 2]) -> Vec<Mark> {
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
        _ => chosen.into_iter().map(|value| Mark { value, text: short(value) }).collect(),
    }
}

/// `value` with as few digits as tell it to twelve.
pub fn short(value: f64) -> String {
    let value: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-4..1e6).contains(&value.abs());
    if plain { format!("{}", value + 0.0) } else { format!("{value:e}") }
}

/// `value` with three digits or all those before its point: 0.0123, 12.3, 12345.
pub fn three_digits(value: f64) -> String {
    let leading = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    match leading {
        _ if value == 0.0 => "0".to_owned(),
        -4.0..=2.0 => format!("{value:.*}", (2.0 - leading) as usize),
        3.0..=6.0 => format!("{value:.0}"),
        _ => format!("{value:.2e}"),
    }
}

/// `number` with `places` decimals; what rounds to 0 has no sign.
pub fn decimals(number: f64, places: usize) -> String {
    let text = format!("{number:.places$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|digit| matches!(digit, '0' | '.')) => digits.to_owned(),
        _ => text,
    }
}

/// `number` to so many digits, at least 1, without zeros behind them.
pub fn significant(number: f64, digits: usize) -> String {
    let text = format!("{number:.*e}", digits - 1);
    let value: f64 = text.parse().expect("a number was written");
    // Without the −0 of rounding.
    let value = value + 0.0;
    let is_handy = value == 0.0 || (1e-3..1e7).contains(&value.abs());
    if is_handy { value.to_string() } else { format!("{value:e}") }
}

/// `values` of one column, all with the decimals that give the largest four digits; with powers of ten where
/// that is far from 1.
pub(crate) fn column(values: &[f64]) -> Vec<String> {
    let largest = values.iter().fold(0.0, |largest, value| f64::max(largest, value.abs()));
    match largest {
        0.0 => vec!["0".to_owned(); values.len()],
        1e-3..1e7 => {
            let places = (3.0 - largest.log10().floor()).max(0.0) as usize;
            values.iter().map(|value| decimals(*value, places)).collect()
        }
        _ => values.iter().map(|value| power_of_ten(*value, 3)).collect(),
    }
}

/// An error to two digits: 0.25, 1.2·10⁻⁴.
pub(crate) fn error(value: f64) -> String {
    if (0.01..1e4).contains(&value.abs()) { significant(value, 2) } else { power_of_ten(value, 2) }
}

/// `value` to so many digits, with a power of ten: 1.2·10⁻⁴.
fn power_of_ten(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:.*e}", digits - 1);
    match text.split_once('e') {
        Some((mantissa, "0")) => mantissa.to_owned(),
        Some((mantissa, power)) => format!("{mantissa}·10{}", raised(power)),
        None => text,
    }
}

/// Digits and sign as superscripts.
fn raised(power: &str) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |character: char| match character.to_digit(10) {
        Some(digit) => RAISED[digit as usize],
        None => '⁻',
    };
    power.chars().map(raise).collect()
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

    fn texts(marks: Vec<Mark>) -> Vec<String> {
        marks.into_iter().map(|mark| mark.text).collect()
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

    #[test]
    fn figures_have_three_digits() {
        for (value, text) in
            [(0.0, "0"), (281.4, "281"), (12.345, "12.3"), (0.0123, "0.0123"), (12345.6, "12346")]
        {
            assert_eq!(three_digits(value), text);
        }
        assert_eq!([three_digits(1.5e-7), three_digits(2e9)], ["1.50e-7", "2.00e9"]);
    }

    #[test]
    fn what_rounds_to_zero_has_no_sign() {
        assert_eq!(decimals(-1e-12, 3), "0.000");
        assert_eq!(decimals(-0.0, 2), "0.00");
        assert_eq!(decimals(-0.006, 2), "-0.01");
        assert_eq!(decimals(f64::NEG_INFINITY, 2), "-inf");
    }

    #[test]
    fn columns_have_the_digits_of_their_largest_number() {
        assert_eq!(column(&[279.95, 3.0, -0.001]), ["279.9", "3.0", "0.0"]);
        assert_eq!(column(&[0.5, 0.01234]), ["0.5000", "0.0123"]);
        assert_eq!(column(&[31_415.9, 2.0]), ["31416", "2"]);
        assert_eq!(column(&[1.5e-6, 0.0]), ["1.50·10⁻⁶", "0"]);
        assert_eq!(column(&[0.0, 0.0]), ["0", "0"]);
        assert_eq!(power_of_ten(-123.0, 2), "-1.2·10²");
        assert_eq!(power_of_ten(1.23, 2), "1.2");
        assert_eq!(significant(1234.567, 5), "1234.6");
        assert_eq!([0.253, 1.25e-4, 0.0].map(error), ["0.25", "1.3·10⁻⁴", "0"]);
    }
}
