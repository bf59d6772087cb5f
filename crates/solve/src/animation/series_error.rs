//! Errors of light that follow from errors of blocks.
//!
//! ```text
//! h = G b + … ,  b = e + S h :     δh = (I − G S)⁻¹ δG b ,     ‖δh‖ ≤ ‖r‖/(1 − max (ρ + τ)) ,     r_i = Σ_j
//! ε_ij ‖b_j‖
//! ```
//!
//! as ‖G‖ ≤ 1. The remainder ε_ij of a series bounds the norm of δG_ij, by Bessel's inequality: Σ_kl
//! δG_kl² ≤ ∫∫ δκ² dA dA. What the rules miss is an estimate and counts like it, that of the series and what
//! a fresh block is allowed: the error reported is the difference from a fresh frame. Without shadows ‖G‖ may
//! exceed 1 by
//! what bodies hide from each other.

use radiosity_core::norm;
use radiosity_elements::Element;
use radiosity_kernel::Remainder;

use crate::solution::{Band, Solution};

/// Bound of ‖δh‖/‖h‖, the largest of any band; None where no block is a sum of a series.
pub(crate) fn series_error(remainders: &[Remainder], solution: &Solution) -> Option<f64> {
    let list = solution.elements().list();
    let bands = solution.bands().iter().map(|band| of_band(remainders, list, band));
    (!remainders.is_empty()).then(|| bands.fold(0.0, f64::max))
}

fn of_band(remainders: &[Remainder], list: &[Element], band: &Band) -> f64 {
    let sizes = sizes(list, band);
    let mut rest = vec![0.0; list.len()];
    for Remainder { places: [i, j], bound } in remainders {
        rest[*i] += bound * sizes[*j];
        rest[*j] += bound * sizes[*i];
    }
    let most = (0..list.len()).map(|element| band.coating.most(element)).fold(0.0, f64::max);
    let [rest, light] = [&rest, &band.coefficients.irradiance].map(|x| norm(x));
    if rest == 0.0 { 0.0 } else { rest / ((1.0 - most) * light) }
}

/// ‖b_j‖ of each element.
fn sizes(list: &[Element], band: &Band) -> Vec<f64> {
    let mut rest = &band.coefficients.radiosity[..];
    let size = |element: &Element| {
        let (own, others) = rest.split_at(element.basis.len());
        rest = others;
        norm(own)
    };
    list.iter().map(size).collect()
}
