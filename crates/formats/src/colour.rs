//! Colours as bands: linear red, green and blue with the primaries and the white of ITU-R BT.709, or one grey
//! band.

use glam::{DMat3, DVec3};

use crate::model::Model;
use crate::tolerances::GREY_OF_NUMBERS;

/// Luminance of linear red, green and blue: Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709-6, item 3.2).
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// Mean reflectance of textures, and reflectance of materials that nothing describes: halfway between black
/// and white, it errs by a half at the most.
pub(crate) const UNKNOWN: f64 = 0.5;

/// Note on materials whose reflectance is a texture.
pub(crate) const TEXTURED: &str = "textures are left out: their mean reflectance is taken for 0.5";

/// Note on materials whose emission is a texture.
pub(crate) const TEXTURED_EMISSION: &str = "textures of emission are left out: what they make shine is dark";

/// The linear value of one that is coded as sRGB, 0 to 1. Source: IEC 61966-2-1:1999, item 5.2.
pub(crate) fn of_srgb(coded: f64) -> f64 {
    if coded <= 0.04045 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
}

/// Linear red, green and blue of a colour with chromaticity `x`, `y` (CIE 1931) and luminance 1, relative to
/// the white of equal energy, x = y = 1/3, which formats that state chromaticities mean by grey. Values below
/// 0, of colours outside the triangle of the primaries, are raised to 0 and the rest scaled so that the
/// luminance stays 1.
pub(crate) fn of_chromaticity(x: f64, y: f64) -> [f64; 3] {
    let white = linear(1.0 / 3.0, 1.0 / 3.0);
    let own = linear(x, y);
    let raised = [0, 1, 2].map(|band| (own[band] / white[band]).max(0.0));
    let sum = luminance(raised);
    raised.map(|value| value / sum)
}

/// Chromaticity of linear red, green and blue, not all 0: the inverse of [`of_chromaticity`].
pub(crate) fn chromaticity([r, g, b]: [f64; 3]) -> [f64; 2] {
    if r == g && g == b {
        return [1.0 / 3.0; 2];
    }
    let white = DVec3::from_array(linear(1.0 / 3.0, 1.0 / 3.0));
    let tristimulus = matrix().inverse() * (DVec3::new(r, g, b) * white);
    [tristimulus.x / tristimulus.element_sum(), tristimulus.y / tristimulus.element_sum()]
}

/// XYZ with Y = 1 → linear red, green and blue.
fn linear(x: f64, y: f64) -> [f64; 3] {
    (matrix() * DVec3::new(x / y, 1.0, (1.0 - x - y) / y)).to_array()
}

/// XYZ → linear red, green and blue. Source: primaries and white of ITU-R BT.709-6, item 1.
fn matrix() -> DMat3 {
    DMat3::from_cols_array_2d(&[
        [3.240_969_941_904_521_4, -0.969_243_636_280_879_8, 0.055_630_079_696_993_61],
        [-1.537_383_177_570_093_5, 1.875_967_501_507_720_7, -0.203_976_958_888_976_57],
        [-0.498_610_760_293_003_3, 0.041_555_057_407_175_61, 1.056_971_514_242_878_6],
    ])
}

/// Luminance of linear red, green and blue.
pub fn luminance(rgb: [f64; 3]) -> f64 {
    rgb.iter().zip(LUMINANCE).map(|(value, weight)| value * weight).sum()
}

/// Luminance to 12 digits: a colour that was made with luminance 0.28 has 0.28 again, not 0.279999999999999.
fn grey(rgb: [f64; 3]) -> f64 {
    let luminance = luminance(rgb);
    format!("{luminance:.11e}").parse().unwrap_or(luminance)
}

/// Values that are grey become their luminance in each band; where all materials are grey, one band `grey`
/// takes the place of red, green and blue.
pub(crate) fn settle(model: &mut Model) {
    if model.bands.len() != 3 {
        return;
    }
    let mut are_grey = true;
    for values in model.values_mut() {
        match is_grey(values, GREY_OF_NUMBERS) {
            true if values.iter().all(|value| *value == values[0]) => {}
            true => *values = vec![grey([values[0], values[1], values[2]]); 3],
            false => are_grey = false,
        }
    }
    if are_grey {
        to_grey(model);
    }
}

/// Whether values, all ≥ 0, lie below the largest by no more than `part` of it.
pub(crate) fn is_grey(values: &[f64], part: f64) -> bool {
    let most = values.iter().copied().fold(0.0, f64::max);
    values.iter().all(|value| most - value <= part * most)
}

/// One band `grey` of the luminances; as it is if the bands are not three.
pub fn to_grey(model: &mut Model) {
    if model.bands.len() != 3 {
        return;
    }
    model.bands = vec!["grey".to_owned()];
    for values in model.values_mut() {
        let [r, g, b] = [values[0], values[1], values[2]];
        *values = vec![if r == g && g == b { r } else { grey([r, g, b]) }];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grey_of_a_colour_is_the_luminance_that_it_was_made_with() {
        for k in 1..100 {
            let stated = f64::from(k) / 100.0;
            let rgb = of_chromaticity(0.4, 0.35 + 1e-3 * f64::from(k)).map(|value| stated * value);
            assert_eq!(grey(rgb), stated);
        }
    }

    #[test]
    fn equal_energy_is_grey_and_all_have_luminance_one() {
        let white = of_chromaticity(1.0 / 3.0, 1.0 / 3.0);
        assert!(white.iter().all(|value| (value - 1.0).abs() < 1e-12), "{white:?}");
        for [x, y] in [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.7, 0.29], [1.0 / 3.0, 1.0 / 3.0]] {
            let rgb = of_chromaticity(x, y);
            assert!((luminance(rgb) - 1.0).abs() < 1e-12 && rgb.iter().all(|value| *value >= 0.0));
        }
    }

    #[test]
    fn chromaticities_are_found_again() {
        for rgb in [[0.2, 0.7, 0.1], [0.9, 0.01, 0.3], [1.0, 0.0, 0.0], [0.0, 0.0, 0.4], [0.5, 0.5, 0.5]] {
            let [x, y] = chromaticity(rgb);
            let again = of_chromaticity(x, y).map(|value| value * luminance(rgb));
            assert!(
                rgb.iter().zip(again).all(|(own, again)| (own - again).abs() < 1e-12),
                "{rgb:?}: {again:?}"
            );
        }
    }
}
