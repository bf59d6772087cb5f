//! Elements that glow: they reflect much more than most, as the inside of a lampshade does.
//!
//! ```text
//! g = mean over the bands of  ρ Ē_j / Ē  >  GLOWING ,     Ē_j the mean irradiance of the element, Ē of all surfaces
//! ```
//!
//! Of n cosine-distributed rays those that meet an element of the form factor F bring F g ± g (F/n)^½ of the light that
//! surfaces send on the whole. Where F is small and g large no ray may meet it: then its light is missed, and the
//! rays agree on that. So rays are aimed at such elements as at emitters.

use radiosity_light::lamps::Lamps;

use crate::solution::Solution;

/// Radiosity over the usual irradiance from which an element glows. Chosen: of the light of one of that radiosity which
/// brings 1 % of a reading, 500 rays find nothing in a quarter of the readings. In rooms the reveals of bright windows
/// have 7, the insides of lampshades 20 to 40, lit walls and ceilings up to 4.
const GLOWING: f64 = 4.0;

/// The elements that glow as targets of rays, beside the `usual` irradiance per band (W m⁻²).
pub(super) fn glowing(solution: &Solution, usual: &[f64]) -> Lamps {
    let list = solution.elements().list();
    let mut glow = vec![0.0; list.len()];
    for (band, usual) in solution.bands().iter().zip(usual) {
        let mut rest = band.coefficients.irradiance.as_slice();
        for (index, (element, glow)) in list.iter().zip(&mut glow).enumerate() {
            let (own, others) = rest.split_at(element.basis.len());
            rest = others;
            let sum: f64 = own.iter().zip(&element.constant).map(|(held, one)| held * one).sum();
            let sent = band.coating.reflectance[index] * sum / element.area;
            *glow += sent / (usual.max(f64::MIN_POSITIVE) * solution.bands().len() as f64);
        }
    }
    Lamps::by(list, |element| if glow[element] > GLOWING { glow[element] } else { 0.0 })
}
