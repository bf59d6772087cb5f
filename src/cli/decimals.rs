//! Numbers with a fixed count of decimals.

/// `number` with `places` decimals; what rounds to 0 has no sign.
pub(crate) fn decimals(number: f64, places: usize) -> String {
    let text = format!("{number:.places$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|digit| matches!(digit, '0' | '.')) => digits.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounds_to_zero_has_no_sign() {
        assert_eq!(decimals(-1e-12, 3), "0.000");
        assert_eq!(decimals(-0.0, 2), "0.00");
        assert_eq!(decimals(-0.006, 2), "-0.01");
        assert_eq!(decimals(f64::NEG_INFINITY, 2), "-inf");
    }
}
