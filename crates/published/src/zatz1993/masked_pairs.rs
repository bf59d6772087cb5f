//! The pairs of a scene whose light is masked: chosen in the scene, or found.
//!
//! Where the scene chooses no pairs, a pair is masked if something may stand between the two elements and
//! hides, somewhere, more of the unshadowed light than the accuracy of shadows times all arriving light.
//! Chosen pairs are masked whatever they need, and no others.

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::coating::Coating;
use radiosity_elements::{Elements, starts};
use radiosity_kernel::block_columns::{BlockColumns, ByColumn};
use radiosity_kernel::Blocks;
use radiosity_light::direct::DirectLight;
use radiosity_light::emitters::{Emitters, Radiances};
use radiosity_light::point_lights::PointLights;
use radiosity_scene::MaskedPair;
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;

use crate::zatz1993::mask::Mask;
use crate::zatz1993::mask_samples::{Receiver, SampledMask};
use crate::zatz1993::masked_light::{MaskedEmitter, MaskedLight};
use crate::zatz1993::mask_setting::Setting;
use crate::zatz1993::masking::Masking;

/// The pairs of elements whose light is masked, with what takes it from one to the other.
#[derive(Clone, Debug)]
pub struct MaskedPairs {
    /// The pairs of each receiver.
    pairs: Vec<Vec<Pair>>,
    /// G from emitting elements to those on which their light is not masked.
    rest: Blocks,
}

/// A pair of a receiver.
#[derive(Clone, Debug)]
struct Pair {
    emitter: usize,
    is_chosen: bool,
    mask: Arc<Mask>,
    /// Its block of G°, row by row.
    open: Vec<f64>,
}

impl MaskedPairs {
    /// The masked pairs of a scene.
    pub fn new(setting: &Setting, how: Masking, ranks: &Ranks) -> Self {
        let work = Work::among(ranks);
        let list = setting.elements.list();
        let masks = masks(setting, how);
        let is_masked = |i: usize, h: usize| masks[i].iter().any(|own| own.emitter == h);
        let either = |i: usize, h: usize| is_masked(i, h) || is_masked(h, i);
        let open = setting.blocks(setting.open, &either, &work);
        let emits = |i: usize| setting.emits(i);
        let sends = |i: usize, h: usize| emits(i) && !is_masked(h, i) || emits(h) && !is_masked(i, h);
        let rest = setting.blocks(setting.visibility, &sends, &work);
        let open = open.gathered();
        let columns = ByColumn::of(&open);
        let block = |receiver: usize, emitter: usize| {
            let column = columns.column(emitter).into_iter();
            let own = column.filter(|block| block.row == receiver).map(|block| block.values.into_owned());
            let size = list[receiver].basis.len() * list[emitter].basis.len();
            own.last().unwrap_or_else(|| vec![0.0; size])
        };
        let pair = |receiver: usize, SampledMask { emitter, mask, is_chosen }: SampledMask| Pair {
            emitter,
            is_chosen,
            mask: Arc::new(mask),
            open: block(receiver, emitter),
        };
        let of_receiver = |(receiver, own): (usize, Vec<SampledMask>)| {
            own.into_iter().map(|mask| pair(receiver, mask)).collect()
        };
        let pairs = masks.into_iter().enumerate().map(of_receiver).collect();
        Self { pairs, rest }
    }

    /// The light that elements of these `coatings` emit, one for each band.
    pub fn light(&self, elements: &Elements, coatings: &[&Coating]) -> MaskedLight {
        let starts = starts(elements.list());
        let ones = elements.constant();
        let emitted: Vec<Vec<f64>> = coatings.iter().map(|own| own.emitted(&starts, &ones)).collect();
        let of_receiver = |(receiver, pairs): (usize, &Vec<Pair>)| {
            let own = |pair: &Pair| {
                let sent = emitted.iter().map(|all| &all[starts[pair.emitter]..starts[pair.emitter + 1]]);
                pair.light(elements, receiver, sent)
            };
            pairs.iter().filter_map(own).collect()
        };
        let masked = self.pairs.iter().enumerate().map(of_receiver).collect();
        let plain = emitted.iter().map(|emitted| self.plain(elements, &starts, emitted)).collect();
        MaskedLight { masked, plain }
    }

    /// Raw coefficients on each receiver of emitted light that is not masked.
    fn plain(&self, elements: &Elements, starts: &[usize], emitted: &[f64]) -> Vec<Vec<f64>> {
        let list = elements.list();
        let mut plain = vec![0.0; emitted.len()];
        for emitter in 0..list.len() {
            let own = starts[emitter]..starts[emitter + 1];
            if emitted[own.clone()].iter().all(|value| *value == 0.0) {
                continue;
            }
            let mut sent = vec![0.0; emitted.len()];
            sent[own.clone()].copy_from_slice(&emitted[own]);
            let arriving = self.rest.apply(&sent);
            let is_masked = |receiver: usize| self.pairs[receiver].iter().any(|pair| pair.emitter == emitter);
            for k in (0..list.len()).filter(|i| !is_masked(*i)).flat_map(|i| starts[i]..starts[i + 1]) {
                plain[k] += arriving[k];
            }
        }
        list.iter().enumerate().map(|(i, own)| own.basis.to_raw(&plain[starts[i]..starts[i + 1]])).collect()
    }
}

impl Pair {
    /// The light of the emitter, which sends these coefficients in each band; None if it is dark.
    fn light<'a>(
        &self,
        elements: &Elements,
        receiver: usize,
        sent: impl Iterator<Item = &'a [f64]> + Clone,
    ) -> Option<MaskedEmitter> {
        if sent.clone().flatten().all(|value| *value == 0.0) {
            return None;
        }
        let basis = &elements.list()[receiver].basis;
        let arriving = |sent: &[f64]| basis.to_raw(&product(&self.open, sent));
        let unshadowed = sent.map(arriving).collect();
        let Self { emitter, is_chosen, ref mask, .. } = *self;
        Some(MaskedEmitter { emitter, is_chosen, mask: Arc::clone(mask), unshadowed })
    }
}

/// The product of a matrix, row by row, and a vector.
fn product(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    matrix.chunks_exact(vector.len()).map(|row| dot(row, vector)).collect()
}

/// The masks of each receiver.
fn masks(setting: &Setting<'_>, how: Masking) -> Vec<Vec<SampledMask>> {
    let Setting { elements, chosen, visibility, open, accuracy, .. } = *setting;
    let list = elements.list();
    let (radiances, points) = (Radiances::default(), PointLights::default());
    let emitters = setting.emitters();
    let coatings = emitters.iter().map(AsRef::as_ref).collect();
    let sources = Emitters { elements: list, coatings, radiances: &radiances, points: &points };
    let lights =
        [visibility, open].map(|v| DirectLight::within(&sources, v, accuracy.shadow_eps));
    let receives = |index: usize| {
        let is_one = |pair: &MaskedPair| pair.receivers.contains(&list[index].surface);
        chosen.is_empty() || chosen.iter().any(is_one)
    };
    let masks = |index: usize| {
        check_interrupt();
        if receives(index) { Receiver::new(setting, &lights, index).masks(how) } else { Vec::new() }
    };
    (0..list.len()).into_par_iter().map(masks).collect()
}
