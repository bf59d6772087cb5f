//! Direct light of emitting elements by rays, for the coefficients of an element.
//!
//! ```text
//! D(x) ≈ 1/n Σ_k E₀(y_k) κ(x, y_k) V(x, y_k) / q(y_k)        W m⁻²
//! ```
//!
//! at a node x of an element by n rays to points y_k of emitters, of density q (`light::lamps`), the next ones
//! of a Kronecker sequence that runs through all nodes of the element, shifted for each element. One node says
//! little; the coefficients d_k = ∫ φ_k D dA, of a thousand rays each, err by about 1 %, independently of each
//! other, and what surfaces reflect of them adds up over many elements. Near an emitter, where κ/q has peaks, as
//! many cosine-distributed rays go beside those, and the balance heuristic (`super::sent_rays`) divides what both
//! find.
//!
//! Range of use: transport by rays, whose error is of the same kind and larger. Where light is read it is had anew.

use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_light::emitters::Emitters;
use radiosity_light::first_bounce::NumberedNode;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::sent_rays::{LampLight, SentRays};

/// Distance of an emitter, in its radii, from which rays to it have no peaks: there κ varies by less than the square
/// of 2 over it.
const NEAR: f64 = 3.0;

/// Direct light of emitting elements at nodes, by rays.
#[derive(Debug)]
pub(crate) struct DirectByRays<'a> {
    rays: SentRays<'a>,
    coatings: Vec<&'a Coating>,
    /// Rays to emitters from all nodes of an element together.
    per_element: f64,
}

impl<'a> DirectByRays<'a> {
    /// The direct light of `sources`, by at least `rays` to the emitters from all elements together, and one from each
    /// node.
    pub(crate) fn of(
        elements: &'a Elements,
        sources: &Emitters<'a>,
        visibility: &'a Visibility,
        rays: u64,
    ) -> Self {
        let coatings = sources.coatings.clone();
        let brightest = |own: &&Coating| own.exitance.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let scale: Vec<f64> = coatings.iter().map(brightest).collect();
        let per_element = rays as f64 / elements.list().len() as f64;
        let rays = SentRays::among(elements, sources, visibility, &scale);
        Self { rays, coatings, per_element }
    }

    /// Irradiance (W m⁻²) per band at a node of the element `element`.
    pub(crate) fn at(
        &self,
        element: usize,
        &NumberedNode { node, number, count }: &NumberedNode<'_>,
    ) -> Vec<f64> {
        let surface = self.rays.elements.list()[element].surface;
        let receiver = ReceiverPoint::on(surface, node.position, node.normal);
        let mut sums = vec![0.0; self.coatings.len()];
        let shares = self.rays.lamps.seen_from(&receiver);
        if shares.is_empty() {
            return sums;
        }
        let rays = (self.per_element / count as f64).ceil().max(1.0) as u64;
        let is_near = self.rays.lamps.is_near(&receiver, NEAR);
        let [a, b, c] = shift(number_of([element as f64]));
        let [d, e] = shift(number_of([element as f64, 1.0]));
        for index in number as u64 * rays..(number as u64 + 1) * rays {
            let draws = shifted(kronecker::point(index), &[a, b, c, d, e]);
            for LampLight { element, share } in self.rays.direct(&receiver, &shares, draws, is_near) {
                let bands = sums.iter_mut().zip(&self.coatings);
                bands.for_each(|(sum, own)| *sum += share * own.exitance[element]);
            }
        }
        sums.iter_mut().for_each(|sum| *sum /= rays as f64);
        sums
    }
}
