//! Direct light at a point: what each emitter sends without shadows, times the part of it that rays find visible.
//!
//! ```text
//! D(x) = Σ_l E₀ U_l v_l ,     v_l = Σ_k w_k κ(x, y_k) V(x, y_k) / Σ_k w_k κ(x, y_k) ,     U_l = ∫ κ dA      W m⁻²
//! ```
//!
//! U_l of a flat emitter is exact (Lambert's formula), that of a curved one is the mean of w_k κ times its area. The
//! points y_k are a Kronecker sequence on the emitter. Outside of penumbrae V is 1 or 0 for all of them, and D exact;
//! within, rays are doubled until E₀ U_l n^(−3/4), about the error behind a straight edge, is small enough.

use std::f64::consts::PI;

use crate::elements::Element;
use crate::elements::coating::Coating;
use crate::light::lamps::{Lamp, Lamps};
use crate::light::receiver_point::ReceiverPoint;
use crate::sampling::kronecker;
use crate::sampling::shift::{number_of, shift, shifted};
use crate::sampling::spread::Place;
use crate::visibility::Visibility;

/// Rays to an emitter that sends all direct light, before they are compared; fewer to weaker ones, but some. Chosen.
const FIRST: f64 = 24.0;
const FEWEST: u64 = 4;

/// Rays to a curved emitter, at least: half of its points may face away. Chosen.
const FEWEST_TO_CURVED: u64 = 32;

/// Most rays to an emitter. Chosen.
const MOST: u64 = 1024;

/// Direct light by rays.
#[derive(Debug)]
pub(crate) struct Penumbra<'a> {
    elements: &'a [Element],
    visibility: &'a Visibility,
    lamps: Lamps,
    /// Accuracy relative to the light without shadows.
    eps: f64,
}

impl<'a> Penumbra<'a> {
    /// The direct light of `elements` with one coating per band, to the accuracy `eps` of what emitters send without
    /// shadows.
    pub(crate) fn new(
        elements: &'a [Element],
        coatings: &[&Coating],
        visibility: &'a Visibility,
        eps: f64,
    ) -> Self {
        let lamps = Lamps::new(elements, coatings, &vec![1.0; coatings.len()]);
        Self { elements, visibility, lamps, eps }
    }

    /// Each emitting element that may send light to a point, and the irradiance from it over its exitance; with `rough` times
    /// the error.
    pub(crate) fn factors(&self, vantage: &ReceiverPoint, rough: f64) -> Vec<(usize, f64)> {
        let bounds: Vec<f64> = self.lamps.list().iter().map(|lamp| lamp.bound(vantage)).collect();
        let all: f64 = bounds.iter().sum();
        let some = self.lamps.list().iter().zip(bounds).filter(|(_, bound)| *bound > 0.0);
        some.map(|(lamp, bound)| {
            (lamp.element, self.factor(vantage, lamp, bound / all, rough * self.eps * all))
        })
        .collect()
    }

    /// Irradiance from an emitter over its exitance; of what all send it sends about the part `share`. It may err by
    /// `tolerance` over its brightness.
    fn factor(&self, vantage: &ReceiverPoint, lamp: &Lamp, share: f64, tolerance: f64) -> f64 {
        let whole = self.without_shadows(vantage, lamp);
        if whole == Some(0.0) {
            return 0.0;
        }
        let position = vantage.position.to_array();
        let offset = shift(number_of(position.into_iter().chain([lamp.element as f64])));
        let (mut sums, mut sent) = (Sums::default(), 0);
        let fewest = if whole.is_some() { FEWEST } else { FEWEST_TO_CURVED };
        let mut now = ((FIRST * share) as u64).max(fewest);
        loop {
            for index in sent..sent + now {
                let place = lamp.spread.point(shifted(kronecker::point(index), &offset));
                self.add(vantage, &place, &mut sums);
            }
            sent += now;
            let size = whole.unwrap_or(sums.all * lamp.area / sent as f64);
            let error = lamp.brightness * size * (sent as f64).powf(-0.75);
            let is_known = (sums.seen == 0.0 || sums.seen == sums.all) && whole.is_some();
            if is_known || error <= tolerance || sent >= MOST {
                return if sums.all > 0.0 { size * sums.seen / sums.all } else { 0.0 };
            }
            now = sent;
        }
    }

    /// U_l of a flat emitter.
    fn without_shadows(&self, vantage: &ReceiverPoint, lamp: &Lamp) -> Option<f64> {
        let element = &self.elements[lamp.element];
        element.plane?;
        let nothing = || [].iter();
        Some(element.patches.iter().map(|patch| vantage.factor(&patch.polygon(), nothing())).sum())
    }

    fn add(&self, vantage: &ReceiverPoint, place: &Place, sums: &mut Sums) {
        let Place { node, weight } = place;
        let step = node.position - vantage.position;
        let cosines = [vantage.normal.dot(step), -node.normal.dot(step)];
        let is_below = vantage.ground.is_some_and(|ground| ground.dot(step) <= 0.0);
        if is_below || cosines.iter().any(|cosine| *cosine <= 0.0) {
            return;
        }
        let value = weight * cosines[0] * cosines[1] / (PI * step.length_squared().powi(2));
        sums.all += value;
        if self.visibility.is_free(vantage.surface, vantage.position, node.position) {
            sums.seen += value;
        }
    }
}

/// Σ w κ over all rays, and over those that arrive.
#[derive(Default)]
struct Sums {
    all: f64,
    seen: f64,
}
