//! Light through shadow masks, at points.
//!
//! For a receiver i and the emitters h,
//!
//! ```text
//! D_i(x) = Σ_{h masked for i} M_{i←h}(x) Σ_k (G°_ih b_h)_k φ_k(x) + Σ_{h not masked} Σ_k (G_ih e_h)_k φ_k(x)
//! ```
//!
//! with G° without visibility and G with it (Zatz 1993, eq. 29). D with its masks takes the place of exact
//! direct light in `light::first_bounce`; [`MaskedPairs`](super::masked_pairs::MaskedPairs) make it.

use std::sync::Arc;

use radiosity_elements::Element;
use radiosity_geom::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::zatz1993::mask::Mask;

/// Light through masks, and direct light beside it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MaskedLight {
    /// The masked emitters of each receiver.
    pub(super) masked: Vec<Vec<MaskedEmitter>>,
    /// Light of the other emitters in the raw polynomials of each receiver, per band.
    pub(super) plain: Vec<Vec<Vec<f64>>>,
}

/// An emitter that is masked for a receiver.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct MaskedEmitter {
    /// Index of the element.
    pub(super) emitter: usize,
    /// Whether the pair was chosen in the scene.
    pub(super) is_chosen: bool,
    pub(super) mask: Arc<Mask>,
    /// Raw coefficients on the receiver of its irradiance without shadows, per band.
    pub(super) unshadowed: Vec<Vec<f64>>,
}

/// A mask of a pair of elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaskOfPair {
    /// Index of the receiving element.
    pub receiver: usize,
    /// Index of the emitting element.
    pub emitter: usize,
    /// Cells along each side of the receiver, were all as fine as the finest may be.
    pub cells: usize,
    /// Number of nodes that were sampled.
    pub samples: usize,
    /// Mean of the mask over the coordinates of the receiver.
    pub mean: f64,
    /// Whether the pair was chosen in the scene.
    pub is_chosen: bool,
}

impl MaskedLight {
    /// Σ f x over `parts` x of the light, each with its factor f; None if there are none.
    pub fn together<'a>(parts: impl Iterator<Item = (f64, &'a Self)>) -> Option<Self> {
        parts.map(|(factor, part)| part.times(factor)).reduce(Self::plus)
    }

    fn times(&self, factor: f64) -> Self {
        let scaled = |raw: &Vec<f64>| -> Vec<f64> { raw.iter().map(|value| factor * value).collect() };
        let dimmed = |emitter: &MaskedEmitter| MaskedEmitter {
            unshadowed: emitter.unshadowed.iter().map(scaled).collect(),
            ..emitter.clone()
        };
        let masked = self.masked.iter().map(|emitters| emitters.iter().map(dimmed).collect()).collect();
        let plain = self.plain.iter().map(|band| band.iter().map(scaled).collect()).collect();
        Self { masked, plain }
    }

    fn plus(mut self, other: Self) -> Self {
        for (own, more) in self.masked.iter_mut().zip(other.masked) {
            more.into_iter().for_each(|emitter| add_emitter(own, emitter));
        }
        let raws = self.plain.iter_mut().flatten().zip(other.plain.iter().flatten());
        raws.for_each(|(own, more)| add(own, more));
        self
    }

    /// Whether this may be light on these `elements` in so many bands.
    pub fn is_of(&self, elements: &[Element], bands: usize) -> bool {
        let has = |raw: &Vec<f64>, element: &Element| raw.len() == element.basis.len();
        let fits = |(own, element): (&Vec<MaskedEmitter>, &Element)| {
            own.iter().all(|own| {
                let all = own.unshadowed.len() == bands && own.unshadowed.iter().all(|raw| has(raw, element));
                all && own.mask.is_valid() && own.emitter < elements.len()
            })
        };
        let is_whole = |band: &Vec<Vec<f64>>| {
            band.len() == elements.len() && band.iter().zip(elements).all(|(raw, own)| has(raw, own))
        };
        self.masked.len() == elements.len()
            && self.masked.iter().zip(elements).all(fits)
            && self.plain.len() == bands
            && self.plain.iter().all(is_whole)
    }

    /// Whether no light is masked.
    pub fn is_plain(&self) -> bool {
        self.masked.iter().all(Vec::is_empty)
    }

    /// The masks that light goes through, receiver by receiver.
    pub fn masks(&self) -> impl Iterator<Item = MaskOfPair> {
        let of_receiver = |(receiver, own): (usize, &Vec<MaskedEmitter>)| {
            let of_pair = move |MaskedEmitter { emitter, is_chosen, mask, .. }: &MaskedEmitter| MaskOfPair {
                receiver,
                emitter: *emitter,
                cells: mask.cells(),
                samples: mask.samples(),
                mean: mask.mean(),
                is_chosen: *is_chosen,
            };
            own.iter().map(of_pair).collect::<Vec<_>>()
        };
        self.masked.iter().enumerate().flat_map(of_receiver)
    }

    /// Irradiance (W m⁻²) of a band at a point of element `receiver`; `position` matters on flat elements,
    /// `parameters` on curved ones.
    pub fn at(
        &self,
        band: usize,
        elements: &[Element],
        receiver: usize,
        position: DVec3,
        parameters: [f64; 2],
    ) -> f64 {
        let element = &elements[receiver];
        let value = |raw: &[f64]| element.evaluate(raw, position, parameters);
        let coordinates = element.basis.frame().locate(position, DVec2::from_array(parameters));
        let masked = self.masked[receiver].iter();
        let lit = masked.map(|emitter| emitter.mask.at(coordinates) * value(&emitter.unshadowed[band]));
        value(&self.plain[band][receiver]) + lit.sum::<f64>()
    }
}

/// Adds the light of an emitter; that of one whose mask is there already to its light.
fn add_emitter(all: &mut Vec<MaskedEmitter>, new: MaskedEmitter) {
    let is_same = |own: &&mut MaskedEmitter| own.emitter == new.emitter && own.mask == new.mask;
    match all.iter_mut().find(is_same) {
        Some(own) => own.unshadowed.iter_mut().zip(&new.unshadowed).for_each(|(own, more)| add(own, more)),
        None => all.push(new),
    }
}

fn add(own: &mut [f64], more: &[f64]) {
    own.iter_mut().zip(more).for_each(|(sum, value)| *sum += value);
}
