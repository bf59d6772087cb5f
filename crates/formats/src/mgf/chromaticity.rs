//! Chromaticities: of spectra, of black bodies, of mixtures.
//!
//! Sources: MGF 2.0, entities `cxy`, `cspec`, `cct`, `cmix`; colour matching functions of the CIE 1931
//! standard observer for 2° (ISO/CIE 11664-1), from 380 to 780 nm.

use crate::colour;
use crate::tolerances::GREY_OF_CHROMATICITIES;
use radiosity_photometry::error::{Refusal, refuse};

/// First and last wavelength, nm, and the distance of the table's lines.
const FIRST: f64 = 380.0;
const LAST: f64 = 780.0;
const STEP: f64 = 10.0;

/// x̄, ȳ, z̄ of the CIE 1931 standard observer every 10 nm.
const OBSERVER: [[f64; 3]; 41] = [
    [0.0014, 0.0000, 0.0065],
    [0.0042, 0.0001, 0.0201],
    [0.0143, 0.0004, 0.0679],
    [0.0435, 0.0012, 0.2074],
    [0.1344, 0.0040, 0.6456],
    [0.2839, 0.0116, 1.3856],
    [0.3483, 0.0230, 1.7471],
    [0.3362, 0.0380, 1.7721],
    [0.2908, 0.0600, 1.6692],
    [0.1954, 0.0910, 1.2876],
    [0.0956, 0.1390, 0.8130],
    [0.0320, 0.2080, 0.4652],
    [0.0049, 0.3230, 0.2720],
    [0.0093, 0.5030, 0.1582],
    [0.0633, 0.7100, 0.0782],
    [0.1655, 0.8620, 0.0422],
    [0.2904, 0.9540, 0.0203],
    [0.4334, 0.9950, 0.0087],
    [0.5945, 0.9950, 0.0039],
    [0.7621, 0.9520, 0.0021],
    [0.9163, 0.8700, 0.0017],
    [1.0263, 0.7570, 0.0011],
    [1.0622, 0.6310, 0.0008],
    [1.0026, 0.5030, 0.0003],
    [0.8544, 0.3810, 0.0002],
    [0.6424, 0.2650, 0.0000],
    [0.4479, 0.1750, 0.0000],
    [0.2835, 0.1070, 0.0000],
    [0.1649, 0.0610, 0.0000],
    [0.0874, 0.0320, 0.0000],
    [0.0468, 0.0170, 0.0000],
    [0.0227, 0.0082, 0.0000],
    [0.0114, 0.0041, 0.0000],
    [0.0058, 0.0021, 0.0000],
    [0.0029, 0.0010, 0.0000],
    [0.0014, 0.0005, 0.0000],
    [0.0007, 0.0002, 0.0000],
    [0.0003, 0.0001, 0.0000],
    [0.0002, 0.0001, 0.0000],
    [0.0001, 0.0000, 0.0000],
    [0.0000, 0.0000, 0.0000],
];

/// Second radiation constant, nm K (CODATA 2018).
const SECOND_RADIATION: f64 = 1.438_776_877e7;

/// Coolest black body that MGF knows, K: its own parser takes no cooler one.
const COOLEST: f64 = 1000.0;

/// Least y: darker colours are none that an eye sees. Of the spectrum's colours the least is 0.0048.
const LEAST_Y: f64 = 1e-3;

/// A colour without its brightness (CIE 1931 x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chromaticity {
    x: f64,
    y: f64,
}

impl Default for Chromaticity {
    /// Grey: equal energy at all wavelengths.
    fn default() -> Self {
        Self { x: 1.0 / 3.0, y: 1.0 / 3.0 }
    }
}

/// A colour of a mixture.
#[derive(Clone, Copy, Debug)]
pub(super) struct MixturePart {
    /// Its part of the brightness, relative to the others.
    pub(super) weight: f64,
    pub(super) colour: Chromaticity,
}

impl Chromaticity {
    /// Entity `cxy`.
    ///
    /// # Errors
    /// Coordinates that no colour has.
    pub(super) fn of_xy(x: f64, y: f64) -> Result<Self, Refusal> {
        match x >= 0.0 && y >= LEAST_Y && x + y <= 1.0 + 1e-6 {
            true => Ok(Self { x, y }),
            false => refuse(
                format!("no colour has the chromaticity {x}, {y}"),
                "write x from 0 and y from 0.001 that sum to 1 at most",
            ),
        }
    }

    /// Entity `cspec`: values at even distances from `first` to `last`, nm; beyond them the spectrum is 0.
    ///
    /// # Errors
    /// Wavelengths in disorder, fewer than two values, values below 0, no light that an eye sees.
    pub(super) fn of_spectrum(first: f64, last: f64, values: &[f64]) -> Result<Self, Refusal> {
        if first >= last || values.len() < 2 {
            return refuse(
                "a spectrum has no range",
                "write the shorter wavelength, the longer one, and two values or more",
            );
        }
        let most = values.iter().copied().fold(0.0, f64::max);
        if values.iter().any(|value| *value < 0.0) {
            return refuse("a spectrum has a value below 0", "write 0 or more");
        }
        let step = (last - first) / (values.len() - 1) as f64;
        Self::of(|wavelength| match (first..=last).contains(&wavelength) {
            true => interpolated(values, (wavelength - first) / step) / most,
            false => 0.0,
        })
    }

    /// Entity `cct`: a black body of so many kelvin (Planck's law).
    ///
    /// # Errors
    /// A body below 1000 K.
    pub(super) fn of_black_body(kelvin: f64) -> Result<Self, Refusal> {
        if kelvin < COOLEST {
            return refuse(
                format!("a black body of {kelvin} K hardly glows"),
                "write 1000 K or more, or a chromaticity by cxy",
            );
        }
        Self::of(|wavelength| {
            let exponent = SECOND_RADIATION / (wavelength * kelvin);
            // Of very hot bodies exp(exponent) − 1 loses all digits; exp_m1 does not.
            (FIRST / wavelength).powi(5) / exponent.exp_m1() * (SECOND_RADIATION / (LAST * kelvin)).exp_m1()
        })
    }

    /// Entity `cmix`: colours by their parts of the brightness.
    ///
    /// # Errors
    /// Parts below 0, or none above.
    pub(super) fn of_mixture(parts: &[MixturePart]) -> Result<Self, Refusal> {
        let most = parts.iter().map(|part| part.weight).fold(0.0, f64::max);
        if most == 0.0 || parts.iter().any(|part| part.weight < 0.0) {
            return refuse("the weights of a mixture are not right", "write weights from 0, one above");
        }
        let mut sum = [0.0; 3];
        for MixturePart { weight, colour: Chromaticity { x, y } } in parts {
            for (total, own) in sum.iter_mut().zip([x / y, 1.0, (1.0 - x - y) / y]) {
                *total += weight / most * own;
            }
        }
        Self::of_tristimulus(sum)
    }

    /// The chromaticity of a spectrum, integrated every nanometre.
    fn of(spectrum: impl Fn(f64) -> f64) -> Result<Self, Refusal> {
        let mut sum = [0.0; 3];
        for nanometre in 0..=(LAST - FIRST) as usize {
            let wavelength = FIRST + nanometre as f64;
            let value = spectrum(wavelength);
            for (band, total) in sum.iter_mut().enumerate() {
                let at = (wavelength - FIRST) / STEP;
                *total += value * interpolated(&OBSERVER.map(|line| line[band]), at);
            }
        }
        Self::of_tristimulus(sum)
    }

    fn of_tristimulus([x, y, z]: [f64; 3]) -> Result<Self, Refusal> {
        let sum = x + y + z;
        match sum > 0.0 && sum.is_finite() {
            true => Self::of_xy(x / sum, y / sum),
            false => refuse(
                "a spectrum has no light that an eye sees",
                "write values above 0 between 380 and 780 nm",
            ),
        }
    }

    /// Red, green and blue of it at brightness 1. What is grey but for the digits that chromaticities have is
    /// grey.
    pub(super) fn bands(&self) -> [f64; 3] {
        let bands = colour::of_chromaticity(self.x, self.y);
        if colour::is_grey(&bands, GREY_OF_CHROMATICITIES) { [1.0; 3] } else { bands }
    }
}

/// Between the values at the whole numbers below and above `at`.
fn interpolated(values: &[f64], at: f64) -> f64 {
    let below = (at.max(0.0) as usize).min(values.len().saturating_sub(2));
    match (values.get(below), values.get(below + 1)) {
        (Some(low), Some(high)) => low + (at - below as f64).clamp(0.0, 1.0) * (high - low),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(weight: f64, colour: Chromaticity) -> MixturePart {
        MixturePart { weight, colour }
    }

    fn near(found: Result<Chromaticity, Refusal>, x: f64, y: f64, tolerance: f64) {
        let found = found.expect("this is a colour");
        assert!((found.x - x).abs() < tolerance && (found.y - y).abs() < tolerance, "{found:?}");
    }

    #[test]
    fn known_lights_have_their_chromaticities() {
        // CIE 015:2018: illuminant E, illuminant A (2856 K), the locus of black bodies at 6500 K, and a line
        // at 600 nm.
        near(Chromaticity::of_spectrum(300.0, 900.0, &[2.0, 2.0]), 1.0 / 3.0, 1.0 / 3.0, 2e-4);
        near(Chromaticity::of_black_body(2856.0), 0.44757, 0.40745, 5e-4);
        near(Chromaticity::of_black_body(6500.0), 0.3135, 0.3237, 5e-4);
        near(Chromaticity::of_spectrum(599.0, 601.0, &[0.0, 1.0, 0.0]), 0.6270, 0.3725, 5e-4);
        assert!(Chromaticity::of_black_body(1e300).is_ok());
    }

    #[test]
    fn a_mixture_of_primaries_is_white() {
        let [r, g, b] = [(0.64, 0.33), (0.3, 0.6), (0.15, 0.06)]
            .map(|(x, y)| Chromaticity::of_xy(x, y).expect("a colour"));
        let white = [part(21.26, r), part(71.52, g), part(7.22, b)];
        near(Chromaticity::of_mixture(&white), 0.3127, 0.3290, 1e-4);
    }

    #[test]
    fn what_is_no_colour_is_refused() {
        let grey = Chromaticity::default();
        let refused = [
            Chromaticity::of_xy(0.5, 0.0),
            Chromaticity::of_xy(0.7, 0.7),
            Chromaticity::of_spectrum(700.0, 400.0, &[1.0, 1.0]),
            Chromaticity::of_spectrum(400.0, 700.0, &[1.0]),
            Chromaticity::of_spectrum(400.0, 700.0, &[1.0, -1.0]),
            Chromaticity::of_spectrum(400.0, 700.0, &[0.0, 0.0]),
            Chromaticity::of_spectrum(1000.0, 2000.0, &[1.0, 1.0]),
            Chromaticity::of_black_body(300.0),
            Chromaticity::of_mixture(&[]),
            Chromaticity::of_mixture(&[part(1.0, grey), part(-1.0, grey)]),
        ];
        for found in refused {
            assert!(found.is_err_and(|fault| !fault.cure.is_empty()));
        }
    }
}
