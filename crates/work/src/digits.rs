//! Numbers as texts: with few digits, with decimals, in columns, with powers of ten.

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
pub fn column(values: &[f64]) -> Vec<String> {
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
pub fn error(value: f64) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

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
