//! Spectra: values at wavelengths, their means over the bands red, green and blue.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::{number, short};

use super::element::{Element, words};

/// Wavelengths of red, green and blue, nm. Chosen: thirds of the visible range.
const BANDS: [[f64; 2]; 3] = [[600.0, 700.0], [500.0, 600.0], [400.0, 500.0]];

/// The pairs of an attribute: `400:0.5, 700:0.6`.
///
/// # Errors
/// Words that are no pairs of numbers.
pub(super) fn pairs(element: &Element, attribute: &str) -> Result<Vec<[f64; 2]>, Refusal> {
    let pair = |word: &str| {
        let Some((wavelength, value)) = word.split_once(':') else {
            return Err(element.refusal(
                format!("the spectrum holds '{}'", short(word)),
                "write one number, or pairs: 400:0.5, 700:0.6",
            ));
        };
        let parsed = number(wavelength, "a wavelength").and_then(|x| Ok([x, number(value, "a value")?]));
        parsed.map_err(|fault| element.at(fault))
    };
    words(element.required(attribute)?).map(pair).collect()
}

/// Means over red, green and blue of a spectrum that is linear between its values and 0 beyond them. Of a
/// band that is partly beyond them the mean is that of the rest.
///
/// # Errors
/// No values, wavelengths that do not grow.
pub(super) fn bands(pairs: &[[f64; 2]], element: &Element) -> Result<[f64; 3], Refusal> {
    if pairs.is_empty() || !pairs.windows(2).all(|pair| pair[0][0] < pair[1][0]) {
        return Err(element.refusal(
            "the spectrum has no values, or its wavelengths do not grow",
            "write pairs in the order of their wavelengths: 400:0.5, 700:0.6",
        ));
    }
    Ok(BANDS.map(|band| mean(pairs, band)))
}

fn mean(pairs: &[[f64; 2]], [low, high]: [f64; 2]) -> f64 {
    if let [[wavelength, value]] = *pairs {
        return if (low..=high).contains(&wavelength) { value } else { 0.0 };
    }
    let (mut sum, mut width) = (0.0, 0.0);
    for pair in pairs.windows(2) {
        let ([x0, y0], [x1, y1]) = (pair[0], pair[1]);
        let (from, to) = (x0.max(low), x1.min(high));
        if to > from {
            let middle = ((from + to) / 2.0 - x0) / (x1 - x0);
            sum += (to - from) * (y0 + middle * (y1 - y0));
            width += to - from;
        }
    }
    if width > 0.0 { sum / width } else { 0.0 }
}
