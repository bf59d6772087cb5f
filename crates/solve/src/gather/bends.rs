//! How strongly light bends over elements.
//!
//! ```text
//! b = max over the bands of  ρ ( Σ_highest h_k² / A )^½ / Ē        without a unit
//! ```
//!
//! over the coefficients h_k of the polynomials of the highest degree on an element of the area A, with the mean
//! irradiance Ē of all surfaces. What polynomials cannot follow is about as large: all of the light on an element that
//! has constants alone.

use crate::solution::Solution;
use crate::system::Coefficients;

/// Light that elements send on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SentLight {
    /// All that they reflect.
    All,
    /// Light that they reflect for the second time or later.
    Again,
}

/// Parts of the polynomials of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Polynomials of the highest degree.
    Highest,
    /// All but the constant.
    Varying,
}

/// The bend of this light on each element, over the `usual` light per band (W m⁻²); of all that varies, if that is the
/// `part`.
pub(super) fn bends(solution: &Solution, usual: &[f64], light: SentLight, part: Part) -> Vec<f64> {
    let list = solution.elements().list();
    let mut bends = vec![0.0_f64; list.len()];
    for (band, usual) in solution.bands().iter().zip(usual) {
        let Coefficients { irradiance, direct, .. } = &band.coefficients;
        let left_out = |k: usize| if light == SentLight::Again { direct[k] } else { 0.0 };
        let mut end = 0;
        for (index, (element, bend)) in list.iter().zip(&mut bends).enumerate() {
            let start = end;
            end += element.basis.len();
            let counted = match part {
                Part::Highest => end - (element.basis.order() + 1)..end,
                Part::Varying => start + 1..end,
            };
            let square: f64 = counted.map(|k| (irradiance[k] - left_out(k)).powi(2)).sum();
            let own = band.coating.reflectance[index] * (square / element.area).sqrt();
            *bend = bend.max(own / usual.max(f64::MIN_POSITIVE));
        }
    }
    bends
}
