//! `--exposure`: how much light is white.

use std::str::FromStr;

use radiosity_reading::exposure::Exposure;
use radiosity_request::ranges::{Finite, Number, Positive};

/// Keyword of the exposure in files of pictures.
pub(crate) const EXPOSURE: &str = "Exposure";

/// Forms that are accepted.
const FORM: &str = "expected auto, exposure values such as -6.5EV, or a factor above 0, such as 0.01";

/// Largest exposure value, either way: 2^±1000 are numbers still.
const MOST: f64 = 1000.0;

/// The exposure that was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TypedExposure {
    /// Chosen for the picture.
    Auto,
    /// Fixed.
    Fixed(Exposure),
}

impl TypedExposure {
    /// The exposure, unless it is to be chosen.
    pub(crate) fn fixed(typed: Option<Self>) -> Option<Exposure> {
        match typed? {
            Self::Auto => None,
            Self::Fixed(exposure) => Some(exposure),
        }
    }
}

impl FromStr for TypedExposure {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == "auto" {
            return Ok(Self::Auto);
        }
        let factor = match text.strip_suffix("EV").or_else(|| text.strip_suffix("ev")) {
            Some(values) => {
                let values = values.trim_end().parse::<Number<Finite>>().map(f64::from);
                values.ok().filter(|values| values.abs() <= MOST).map(f64::exp2)
            }
            None => text.parse::<Number<Positive>>().map(f64::from).ok(),
        };
        factor.map(|factor| Self::Fixed(Exposure::fixed(factor))).ok_or(FORM)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_and_exposure_values_are_told_apart() {
        let factor = |text: &str| TypedExposure::fixed(text.parse().ok()).map(|exposure| exposure.factor());
        assert_eq!(factor("0.125"), Some(0.125));
        assert_eq!(factor("-3EV"), Some(0.125));
        assert_eq!(factor("+2 EV"), Some(4.0));
        assert_eq!(factor("0ev"), Some(1.0));
        assert_eq!("auto".parse(), Ok(TypedExposure::Auto));
        for wrong in ["0", "-3", "EV", "1e4EV", "nanEV", "automatic", "3 stops"] {
            assert_eq!(wrong.parse::<TypedExposure>(), Err(FORM), "{wrong}");
        }
    }
}
