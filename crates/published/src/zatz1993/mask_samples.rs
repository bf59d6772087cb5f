//! Samples of shadow masks: the light that arrives at nodes of a receiver, with and without obstacles.

use std::cell::RefCell;
use std::collections::BTreeMap;

use radiosity_elements::Element;
use radiosity_elements::frame::{Frame, duals};
use radiosity_geom::{COINCIDENT, DVec2, DVec3, Surface};
use radiosity_light::direct::DirectLight;

use crate::zatz1993::mask::Mask;
use crate::zatz1993::mask_setting::Setting;
use crate::zatz1993::masking::{Average, Masking};
use crate::zatz1993::solid_angle::solid_angle;

/// Rays along each direction of an emitter's patch, at centres of equal parts, in a plain average: 256 in
/// all, each of which counts 0.4 %.
const RAYS: usize = 16;

/// An element whose masks are being made.
pub(super) struct Receiver<'a> {
    setting: &'a Setting<'a>,
    /// Direct light with all obstacles, and without obstacles.
    lights: &'a [DirectLight<'a>; 2],
    index: usize,
    /// Visible and unshadowed irradiance from each emitter at the nodes visited so far.
    known: RefCell<BTreeMap<[u64; 2], Option<Vec<Arriving>>>>,
}

/// The mask of an emitter on a receiver.
pub(super) struct SampledMask {
    pub(super) emitter: usize,
    pub(super) mask: Mask,
    pub(super) is_chosen: bool,
    /// Whether the mask holds the cosine at the receiver, too.
    pub(super) takes_cosine: bool,
}

/// Irradiance at a node from an emitter of exitance 1.
#[derive(Clone, Copy, Debug)]
struct Arriving {
    emitter: usize,
    seen: f64,
    unshadowed: f64,
}

impl<'a> Receiver<'a> {
    pub(super) fn new(setting: &'a Setting<'a>, lights: &'a [DirectLight<'a>; 2], index: usize) -> Self {
        Self { setting, lights, index, known: RefCell::new(BTreeMap::new()) }
    }

    fn element(&self) -> &'a Element {
        &self.setting.elements.list()[self.index]
    }

    /// The masks of all emitters that need one, or of those chosen.
    pub(super) fn masks(&self, how: Masking) -> Vec<SampledMask> {
        let emitters = self.lights[0].emitters();
        match self.setting.chosen {
            [] => emitters.filter_map(|emitter| self.automatic(emitter, how)).collect(),
            _ => emitters.filter_map(|emitter| self.chosen(emitter, how)).collect(),
        }
    }

    /// The mask of an emitter, if its light needs one.
    fn automatic(&self, emitter: usize, how: Masking) -> Option<SampledMask> {
        let blockers = self.blockers(emitter);
        if blockers.is_empty() && !self.takes_cosine(how) {
            return None;
        }
        let weighted = self.sampled(emitter, &blockers, Masking { average: Average::Weighted, ..how })?;
        if !(self.is_needed(emitter) || self.takes_cosine(how) && self.has_horizon(emitter)) {
            return None;
        }
        let mask = match how.average {
            Average::Weighted => weighted,
            Average::Plain => self.sampled(emitter, &blockers, how)?,
        };
        Some(SampledMask { emitter, mask, is_chosen: false, takes_cosine: self.takes_cosine(how) })
    }

    /// The mask of an emitter, if it was chosen for this receiver and the two see each other.
    fn chosen(&self, emitter: usize, how: Masking) -> Option<SampledMask> {
        let [own, other] = [self.index, emitter].map(|index| self.setting.elements.list()[index].surface);
        let pair = self.setting.chosen.iter().rfind(|pair| pair.is_of(own, other))?;
        let how = Masking { cells: pair.cells.unwrap_or(how.cells), ..how };
        let mask = self.sampled(emitter, &self.blockers(emitter), how)?;
        let takes_cosine = self.takes_cosine(how);
        self.is_lit(emitter).then_some(SampledMask { emitter, mask, is_chosen: true, takes_cosine })
    }

    fn sampled(&self, emitter: usize, blockers: &[usize], how: Masking) -> Option<Mask> {
        match how.average {
            Average::Weighted => Mask::quadtree(how.cells, &|place| self.weighted(emitter, place)),
            Average::Plain => Mask::uniform(how.cells, &|place| self.plain(emitter, blockers, place)),
        }
    }

    /// Whether masks hold the cosine at the receiver, too: where it is curved.
    fn takes_cosine(&self, how: Masking) -> bool {
        how.average == Average::Weighted && self.element().plane.is_none()
    }

    /// Whether the emitter sets behind the receiver's own horizon: some visited nodes get light of it, others
    /// would get none without obstacles.
    fn has_horizon(&self, emitter: usize) -> bool {
        let known = self.known.borrow();
        let own = || known.values().flatten().flatten().filter(|one| one.emitter == emitter);
        own().any(|one| one.seen > 0.0) && own().any(|one| one.unshadowed == 0.0)
    }

    fn blockers(&self, emitter: usize) -> Vec<usize> {
        let other = &self.setting.elements.list()[emitter];
        let surfaces = [self.element().surface, other.surface];
        self.setting.visibility.candidates(&self.element().hull, &other.hull, surfaces)
    }

    /// Whether light of the emitter arrives at some visited node where nothing is in its way; at all nodes
    /// where none was visited.
    fn is_lit(&self, emitter: usize) -> bool {
        let known = self.known.borrow();
        let mut arriving = known.values().flatten().flatten().filter(|one| one.emitter == emitter).peekable();
        arriving.peek().is_none() || arriving.any(|one| one.unshadowed > 0.0)
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
        let whole = match self.element().plane {
            Some(_) => one.unshadowed,
            None => solid_angle(&self.setting.elements.list()[emitter], self.point(place)?.0),
        };
        Some(if whole > 0.0 { (one.seen / whole).clamp(0.0, 1.0) } else { 1.0 })
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
