//! The pairs of a scene whose light is masked: chosen in the scene, or found.
//!
//! Where the scene chooses no pairs, a pair is masked if something may stand between the two elements and
//! hides, somewhere, more of the unshadowed light than the accuracy of shadows times all arriving light.
//! Chosen pairs are masked whatever they need, and no others.
//!
//! An emitter may reflect as well. With r_h = b_h − e_h, the light of the whole system (Zatz 1993, eq. 29) is
//!
//! ```text
//! E_i = Σ_{h masked for i} M_{i←h} G°_ih (e_h + r_h) + Σ_{h not masked} G_ih (e_h + r_h) .
//! ```
//!
//! The rest of the solution carries r_h of all pairs: what h reflects of direct light by the first bounce,
//! what it reflects of other light by the blocks. So the masked light of a known r is that of emission and
//! reflection, less these two of the masked pairs: D = Σ M G° (e + r) + Σ_{not masked} G e − Σ_{masked} G r.
//! Found anew from the r of each solution, it converges to the light of eq. 29.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::coating::Coating;
use radiosity_elements::{Element, Elements};
use radiosity_kernel::Blocks;
use radiosity_kernel::block_columns::{BlockColumns, ByColumn};
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
use crate::zatz1993::mask_setting::Setting;
use crate::zatz1993::masked_light::{MaskedEmitter, MaskedLight};
use crate::zatz1993::masking::Masking;
use crate::zatz1993::solid_angle;

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
    /// Its block of G, row by row, where the emitter reflects: what the mask stands for of reflected light.
    shadowed: Option<Vec<f64>>,
}

impl MaskedPairs {
    /// The masked pairs of a scene.
    pub fn new(setting: &Setting, how: Masking, ranks: &Ranks) -> Self {
        let work = Work::among(ranks);
        let list = setting.elements.list();
        let masks = masks(setting, how);
        let is_masked = |i: usize, h: usize| masks[i].iter().any(|own| own.emitter == h);
        let is_plain = |i: usize, h: usize| masks[i].iter().any(|own| own.emitter == h && !own.takes_cosine);
        let either = |i: usize, h: usize| is_plain(i, h) || is_plain(h, i);
        let open = setting.blocks(setting.open, &either, &work);
        let emits = |i: usize| setting.emits(i);
        let reflects = |i: usize| setting.reflects(i);
        // What of an emitter's light a receiver takes by a block with shadows.
        let takes = |i: usize, h: usize| if is_masked(i, h) { reflects(h) } else { emits(h) };
        let sends = |i: usize, h: usize| takes(i, h) || takes(h, i);
        let rest = setting.blocks(setting.visibility, &sends, &work);
        let (all_open, all_shadowed) = (open.gathered(), rest.gathered());
        let [open, shadowed] = [&all_open, &all_shadowed].map(|blocks| ByColumn::of(blocks));
        let pair = |receiver: usize, own: SampledMask| {
            check_interrupt();
            let SampledMask { emitter, mask, is_chosen, takes_cosine } = own;
            let open = match takes_cosine {
                true => solid_angle::block(&list[receiver], &list[emitter], &mask),
                false => block(list, &open, receiver, emitter),
            };
            let shadowed = reflects(emitter).then(|| block(list, &shadowed, receiver, emitter));
            Pair { emitter, is_chosen, mask: Arc::new(mask), open, shadowed }
        };
        let of_receiver = |(receiver, own): (usize, Vec<SampledMask>)| {
            own.into_iter().map(|mask| pair(receiver, mask)).collect()
        };
        let pairs = masks.into_par_iter().enumerate().map(of_receiver).collect();
        Self { pairs, rest }
    }

    /// Whether light that an emitter reflects goes through a mask.
    pub fn reflect(&self) -> bool {
        self.pairs.iter().flatten().any(|pair| pair.shadowed.is_some())
    }

    /// The emitters that reflect, ascending.
    pub fn reflecting(&self) -> Vec<usize> {
        let reflecting = self.pairs.iter().flatten().filter(|pair| pair.shadowed.is_some());
        let reflecting: BTreeSet<usize> = reflecting.map(|pair| pair.emitter).collect();
        reflecting.into_iter().collect()
    }

    /// The light that elements of these `coatings` emit, one for each band, and through masks that of the
    /// radiosity that they reflect, if it is known: less what reaches the receivers of it otherwise.
    pub fn light(
        &self,
        elements: &Elements,
        coatings: &[&Coating],
        reflected: Option<&ReflectedLight<'_>>,
    ) -> MaskedLight {
        let starts = elements.starts();
        let ones = elements.constant();
        let emitted: Vec<Vec<f64>> = coatings.iter().map(|own| own.emitted(&starts, &ones)).collect();
        let sent = Sent { starts: &starts, emitted: &emitted, reflected };
        let of_receiver = |(receiver, pairs): (usize, &Vec<Pair>)| {
            pairs.iter().filter_map(|pair| pair.light(&elements.list()[receiver].basis, &sent)).collect()
        };
        let masked = self.pairs.iter().enumerate().map(of_receiver).collect();
        let plain = (0..coatings.len()).map(|band| self.plain(elements, &sent, band)).collect();
        MaskedLight { masked, plain }
    }

    /// Raw coefficients on each receiver of emitted light that is not masked, less what blocks carry of
    /// reflected light that is.
    fn plain(&self, elements: &Elements, sent: &Sent<'_>, band: usize) -> Vec<Vec<f64>> {
        let Sent { starts, emitted, .. } = *sent;
        let (list, emitted) = (elements.list(), &emitted[band]);
        let mut plain = vec![0.0; emitted.len()];
        for emitter in 0..list.len() {
            let own = starts[emitter]..starts[emitter + 1];
            if emitted[own.clone()].iter().all(|value| *value == 0.0) {
                continue;
            }
            let mut alone = vec![0.0; emitted.len()];
            alone[own.clone()].copy_from_slice(&emitted[own]);
            let arriving = self.rest.apply(&alone);
            let is_masked = |receiver: usize| self.pairs[receiver].iter().any(|pair| pair.emitter == emitter);
            for k in (0..list.len()).filter(|i| !is_masked(*i)).flat_map(|i| starts[i]..starts[i + 1]) {
                plain[k] += arriving[k];
            }
        }
        for (receiver, pair) in
            self.pairs.iter().enumerate().flat_map(|(i, own)| own.iter().map(move |p| (i, p)))
        {
            let own = starts[receiver]..starts[receiver + 1];
            let otherwise = sent.otherwise(pair, band, own.clone()).into_iter().flatten();
            plain[own].iter_mut().zip(otherwise).for_each(|(sum, otherwise)| *sum -= otherwise);
        }
        list.iter().enumerate().map(|(i, own)| own.basis.to_raw(&plain[starts[i]..starts[i + 1]])).collect()
    }
}

/// Coefficients of the radiosity that elements send, per band.
#[derive(Clone, Copy)]
struct Sent<'a> {
    starts: &'a [usize],
    emitted: &'a [Vec<f64>],
    reflected: Option<&'a ReflectedLight<'a>>,
}

/// Radiosity that elements reflect, and the ways in which it reaches receivers beside masks.
#[derive(Clone, Debug)]
pub struct ReflectedLight<'a> {
    /// Coefficients of all that they reflect, per band.
    pub all: Vec<Vec<f64>>,
    /// Coefficients of what they reflect of light that was reflected before, per band: blocks carry it.
    pub again: Vec<Vec<f64>>,
    /// Coefficients of the irradiance from each emitter that reflects direct light, per band.
    pub once: &'a BTreeMap<usize, Vec<Vec<f64>>>,
}

impl<'a> Sent<'a> {
    fn emitted(&self, element: usize, band: usize) -> &'a [f64] {
        &self.emitted[band][self.starts[element]..self.starts[element + 1]]
    }

    fn reflected(&self, element: usize, band: usize) -> Option<&'a [f64]> {
        Some(&self.reflected?.all[band][self.starts[element]..self.starts[element + 1]])
    }

    /// Coefficients, on a receiver whose coefficients are `own`, of the light that an emitter reflects there
    /// beside its mask.
    fn otherwise(&self, pair: &Pair, band: usize, own: Range<usize>) -> Option<Vec<f64>> {
        let (block, ReflectedLight { again, once, .. }) = (pair.shadowed.as_ref()?, self.reflected?);
        let again = &again[band][self.starts[pair.emitter]..self.starts[pair.emitter + 1]];
        let once = &once.get(&pair.emitter)?[band][own];
        Some(product(block, again).iter().zip(once).map(|(again, once)| again + once).collect())
    }
}

impl Pair {
    /// The light of the emitter on a receiver of this basis; None if it is dark.
    fn light(&self, basis: &AreaBasis, sent: &Sent<'_>) -> Option<MaskedEmitter> {
        let Self { emitter, is_chosen, ref mask, ref open, ref shadowed } = *self;
        let of_band = |band: usize| match sent.reflected(emitter, band).filter(|_| shadowed.is_some()) {
            None => sent.emitted(emitter, band).to_vec(),
            Some(reflected) => {
                sent.emitted(emitter, band).iter().zip(reflected).map(|(own, more)| own + more).collect()
            }
        };
        let all: Vec<Vec<f64>> = (0..sent.emitted.len()).map(of_band).collect();
        if all.iter().flatten().all(|value| *value == 0.0) {
            return None;
        }
        let unshadowed = all.iter().map(|sent| basis.to_raw(&product(open, sent))).collect();
        Some(MaskedEmitter { emitter, is_chosen, mask: Arc::clone(mask), unshadowed })
    }
}

/// The block of a pair, row by row; zeros where there is none.
fn block(list: &[Element], columns: &ByColumn<'_>, receiver: usize, emitter: usize) -> Vec<f64> {
    let column = columns.column(emitter).into_iter();
    let own = column.filter(|block| block.row == receiver).map(|block| block.values.into_owned()).next();
    own.unwrap_or_else(|| vec![0.0; list[receiver].basis.len() * list[emitter].basis.len()])
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
    let lights = [visibility, open].map(|v| DirectLight::within(&sources, v, accuracy.shadow_eps));
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
