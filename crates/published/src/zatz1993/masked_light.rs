//! Direct light as the paper keeps it: polynomials without shadows times shadow masks.
//!
//! For a receiver i and the emitters h,
//!
//! ```text
//! D_i(x) = Σ_{h masked for i} M_{i←h}(x) Σ_k (G°_ih e_h)_k φ_k(x) + Σ_{h not masked} Σ_k (G_ih e_h)_k φ_k(x)
//! ```
//!
//! with G° without visibility and G with it (Zatz 1993, eq. 29). D with its masks takes the place of exact
//! direct light in `light::first_bounce`. The light that an emitter reflects is not part of it; its shadows
//! are in the blocks.
//!
//! A pair is masked if something may stand between the two elements and hides, somewhere, more of the
//! unshadowed light than the accuracy of shadows times all arriving light.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::num::NonZeroUsize;

use radiosity_elements::coating::Coating;
use radiosity_elements::frame::{Frame, duals};
use radiosity_elements::{Element, Elements};
use radiosity_geom::{COINCIDENT, DVec2, DVec3, Surface};
use radiosity_kernel::{Accuracy, Blocks};
use radiosity_light::direct::DirectLight;
use radiosity_light::emitters::{Emitters, Radiances};
use radiosity_light::point_lights::PointLights;
use radiosity_transport as transport;
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::Ranks;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::zatz1993::mask::Mask;
use crate::zatz1993::transfers::{self, PaperRules};

/// Rays along each direction of an emitter's patch, at centres of equal parts, in a plain average: 256 in
/// all, each of which counts 0.4 %.
const RAYS: usize = 16;

/// Resolution of masks, and the average that they sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Masking {
    /// Cells along each side of an element; masks are sampled at their corners.
    pub cells: NonZeroUsize,
    /// The average that is sampled.
    pub average: Average,
}

impl Default for Masking {
    /// 40 cells along each side, of which each tells the part of the light that arrives.
    fn default() -> Self {
        Self { cells: const { NonZeroUsize::new(40).expect("40 is not 0") }, average: Average::Weighted }
    }
}

/// The value of a mask at its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Average {
    /// The part of the emitter's light that arrives.
    Weighted,
    /// The part of the emitter's area that is seen, as in Zatz 1993.
    Plain,
}

/// Direct light with masks.
#[derive(Clone, Debug)]
pub struct MaskedLight {
    /// The masked emitters of each receiver.
    masked: Vec<Vec<MaskedEmitter>>,
    /// Light of the other emitters in the raw polynomials of each receiver, per band.
    plain: Vec<Vec<Vec<f64>>>,
}

/// An emitter that is masked for a receiver.
#[derive(Clone, Debug)]
struct MaskedEmitter {
    /// Exitance per band (W m⁻²).
    exitance: Vec<f64>,
    mask: Mask,
    /// Raw coefficients on the receiver of its irradiance without shadows, per unit of exitance.
    unshadowed: Vec<f64>,
}

/// The data from which masks are made.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// The elements.
    pub elements: &'a Elements,
    /// One coating per band.
    pub coatings: &'a [&'a Coating],
    /// The scene with all obstacles.
    pub visibility: &'a Visibility,
    /// The scene without obstacles.
    pub open: &'a Visibility,
    /// Accuracy of the blocks.
    pub accuracy: Accuracy,
    /// The rules of 1993 instead of those that keep the accuracy.
    pub rules: Option<PaperRules>,
}

impl Setting<'_> {
    /// The blocks between the elements as far as they are wanted.
    fn blocks(
        &self,
        visibility: &Visibility,
        wanted: &(dyn Fn(usize, usize) -> bool + Sync),
        work: &Work<'_>,
    ) -> Blocks {
        let demand = transport::Demand::all(self.elements, visibility, self.accuracy).of(wanted);
        match self.rules {
            Some(rules) => transfers::assemble(demand, rules, rules.extra_points(), work),
            None => transport::assemble(demand, None, work),
        }
    }
}

impl MaskedLight {
    /// The masked light of a scene.
    pub fn new(setting: &Setting, how: Masking, ranks: &Ranks) -> Self {
        let work = Work::among(ranks);
        let Setting { elements, coatings, visibility, open, accuracy, .. } = *setting;
        let list = elements.list();
        let eps = accuracy.shadow_eps;
        let (radiances, points) = (Radiances::default(), PointLights::default());
        let sources =
            Emitters { elements: list, coatings: coatings.to_vec(), radiances: &radiances, points: &points };
        let lights = [visibility, open].map(|v| DirectLight::within(&sources, v, eps));
        let masks = |i: usize| {
            check_interrupt();
            Receiver::new(setting, &lights, i).masks(how)
        };
        let masks: Vec<Vec<(usize, Mask)>> = (0..list.len()).into_par_iter().map(masks).collect();
        let is_masked = |i: usize, h: usize| masks[i].iter().any(|(other, _)| *other == h);
        let either = |i: usize, h: usize| is_masked(i, h) || is_masked(h, i);
        let emits = |i: usize| coatings.iter().any(|coating| coating.exitance[i] > 0.0);
        let free = setting.blocks(open, &either, &work);
        let sends = |i: usize, h: usize| emits(i) && !is_masked(h, i) || emits(h) && !is_masked(i, h);
        let rest = setting.blocks(visibility, &sends, &work);
        let mut light = Self::dark(list, coatings.len());
        for emitter in (0..list.len()).filter(|i| emits(*i)) {
            let exitance: Vec<f64> = coatings.iter().map(|coating| coating.exitance[emitter]).collect();
            let [unshadowed, shadowed] = [&free, &rest].map(|blocks| arriving(list, emitter, blocks));
            for (receiver, masks) in masks.iter().enumerate() {
                match masks.iter().find(|(other, _)| *other == emitter) {
                    Some((_, mask)) => light.masked[receiver].push(MaskedEmitter {
                        exitance: exitance.clone(),
                        mask: mask.clone(),
                        unshadowed: unshadowed[receiver].clone(),
                    }),
                    None => light.add_plain(receiver, &exitance, &shadowed[receiver]),
                }
            }
        }
        light
    }

    fn dark(list: &[Element], bands: usize) -> Self {
        let dark: Vec<Vec<f64>> = list.iter().map(|element| vec![0.0; element.basis.len()]).collect();
        Self { masked: list.iter().map(|_| Vec::new()).collect(), plain: vec![dark; bands] }
    }

    /// Adds light of an emitter that needs no mask; `raw` are coefficients per unit of exitance.
    fn add_plain(&mut self, receiver: usize, exitance: &[f64], raw: &[f64]) {
        for (plain, exitance) in self.plain.iter_mut().zip(exitance) {
            plain[receiver].iter_mut().zip(raw).for_each(|(sum, part)| *sum += exitance * part);
        }
    }

    /// Σ f x over `parts` x of the light, each with its factor f; None if there are none.
    pub fn together<'a>(parts: impl Iterator<Item = (f64, &'a Self)>) -> Option<Self> {
        parts.map(|(factor, part)| part.times(factor)).reduce(Self::plus)
    }

    fn times(&self, factor: f64) -> Self {
        let dimmed = |emitter: &MaskedEmitter| MaskedEmitter {
            exitance: emitter.exitance.iter().map(|exitance| factor * exitance).collect(),
            ..emitter.clone()
        };
        let masked = self.masked.iter().map(|emitters| emitters.iter().map(dimmed).collect()).collect();
        let scaled = |raw: &Vec<f64>| raw.iter().map(|value| factor * value).collect();
        let plain = self.plain.iter().map(|band| band.iter().map(scaled).collect()).collect();
        Self { masked, plain }
    }

    fn plus(mut self, other: Self) -> Self {
        self.masked.iter_mut().zip(other.masked).for_each(|(own, more)| own.extend(more));
        let raws = self.plain.iter_mut().flatten().zip(other.plain.iter().flatten());
        raws.for_each(|(own, more)| own.iter_mut().zip(more).for_each(|(sum, value)| *sum += value));
        self
    }

    /// Whether no light is masked.
    pub fn is_plain(&self) -> bool {
        self.masked.iter().all(Vec::is_empty)
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
        let lit = masked.map(|emitter| {
            emitter.exitance[band] * emitter.mask.at(coordinates) * value(&emitter.unshadowed)
        });
        value(&self.plain[band][receiver]) + lit.sum::<f64>()
    }
}

/// Raw coefficients on each element of the irradiance from one emitter of exitance 1.
fn arriving(list: &[Element], emitter: usize, blocks: &Blocks) -> Vec<Vec<f64>> {
    let starts = blocks.starts();
    let mut sent = vec![0.0; blocks.dim()];
    sent[starts[emitter]..starts[emitter + 1]].copy_from_slice(&list[emitter].constant);
    let arriving = blocks.apply(&sent);
    let own = |(i, element): (usize, &Element)| element.basis.to_raw(&arriving[starts[i]..starts[i + 1]]);
    list.iter().enumerate().map(own).collect()
}

/// An element whose masks are being made.
struct Receiver<'a> {
    setting: &'a Setting<'a>,
    /// Direct light with all obstacles, and without obstacles.
    lights: &'a [DirectLight<'a>; 2],
    index: usize,
    /// Visible and unshadowed irradiance from each emitter at the nodes visited so far.
    known: RefCell<BTreeMap<[u64; 2], Option<Vec<Arriving>>>>,
}

/// Irradiance at a node from an emitter of exitance 1.
#[derive(Clone, Copy, Debug)]
struct Arriving {
    emitter: usize,
    seen: f64,
    unshadowed: f64,
}

impl<'a> Receiver<'a> {
    fn new(setting: &'a Setting<'a>, lights: &'a [DirectLight<'a>; 2], index: usize) -> Self {
        Self { setting, lights, index, known: RefCell::new(BTreeMap::new()) }
    }

    fn element(&self) -> &'a Element {
        &self.setting.elements.list()[self.index]
    }

    /// The masks it needs, by emitter.
    fn masks(&self, how: Masking) -> Vec<(usize, Mask)> {
        let masks = self.lights[0].emitters().filter_map(|emitter| {
            let blockers = self.blockers(emitter);
            if blockers.is_empty() {
                return None;
            }
            let weighted = Mask::new(how.cells, &|place| self.weighted(emitter, place))?;
            if !self.is_needed(emitter) {
                return None;
            }
            Some((
                emitter,
                match how.average {
                    Average::Weighted => weighted,
                    Average::Plain => Mask::new(how.cells, &|place| self.plain(emitter, &blockers, place))?,
                },
            ))
        });
        masks.collect()
    }

    fn blockers(&self, emitter: usize) -> Vec<usize> {
        let other = &self.setting.elements.list()[emitter];
        let surfaces = [self.element().surface, other.surface];
        self.setting.visibility.candidates(&self.element().hull, &other.hull, surfaces)
    }

    /// Whether an emitter needs a mask: at some visited node more of its light is hidden than the accuracy of
    /// shadows times all unshadowed light, but not all of it at all nodes.
    fn is_needed(&self, emitter: usize) -> bool {
        let known = self.known.borrow();
        let power = |other: usize| self.setting.coatings.iter().map(|c| c.exitance[other]).sum::<f64>();
        let (mut hidden, mut seen, mut all, mut nodes) = (0.0f64, 0.0f64, 0.0, 0.0);
        for arriving in known.values().flatten() {
            nodes += 1.0;
            all += arriving.iter().map(|one| power(one.emitter) * one.unshadowed).sum::<f64>();
            for one in arriving.iter().filter(|one| one.emitter == emitter) {
                hidden = hidden.max(power(emitter) * (one.unshadowed - one.seen));
                seen = seen.max(one.seen);
            }
        }
        seen > 0.0 && hidden * nodes > self.setting.accuracy.shadow_eps * all
    }

    fn weighted(&self, emitter: usize, place: [f64; 2]) -> Option<f64> {
        let mut known = self.known.borrow_mut();
        let at = || self.point(place).map(|(position, normal)| self.arriving(position, normal));
        let arriving = known.entry(place.map(f64::to_bits)).or_insert_with(at).as_ref()?;
        let one = arriving.iter().find(|one| one.emitter == emitter)?;
        Some(if one.unshadowed > 0.0 { (one.seen / one.unshadowed).clamp(0.0, 1.0) } else { 1.0 })
    }

    fn arriving(&self, position: DVec3, normal: DVec3) -> Vec<Arriving> {
        let [seen, unshadowed] =
            self.lights.each_ref().map(|light| light.factors(self.index, position, normal));
        let both = seen.into_iter().zip(unshadowed);
        both.map(|((emitter, seen), (_, unshadowed))| Arriving { emitter, seen, unshadowed }).collect()
    }

    fn plain(&self, emitter: usize, blockers: &[usize], place: [f64; 2]) -> Option<f64> {
        let (x, _) = self.point(place)?;
        let place = |k: usize| (k as f64 + 0.5) / RAYS as f64;
        let (mut seen, mut all) = (0.0, 0.0);
        for patch in &self.setting.elements.list()[emitter].patches {
            for k in 0..RAYS * RAYS {
                let node = patch.node(place(k / RAYS), place(k % RAYS));
                all += node.area;
                seen +=
                    if self.setting.visibility.free(blockers, x, node.position) { node.area } else { 0.0 };
            }
        }
        Some(seen / all)
    }

    /// Point and normal at coordinates in [−1, 1]²; None where the element does not reach.
    fn point(&self, [a, b]: [f64; 2]) -> Option<(DVec3, DVec3)> {
        let element = self.element();
        match (element.basis.frame(), element.plane) {
            (Frame::Plane { origin, first, second }, Some(plane)) => {
                let [along, across] = duals([*first, *second]);
                let position = origin + a * along + b * across;
                let extent = along.length().max(across.length());
                element.covers(position, COINCIDENT * extent).then_some((position, plane.normal))
            }
            (Frame::Parameters { center, half }, _) => {
                let parameters = *center + *half * DVec2::new(a, b);
                let shape: &dyn Surface = self.setting.elements.shape(element.surface);
                let jet = shape.jet(parameters.x, parameters.y);
                Some((jet.position, jet.normal))
            }
            (Frame::Plane { .. }, None) => None,
        }
    }
}
