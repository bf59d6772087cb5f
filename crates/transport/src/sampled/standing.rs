//! Rays that stand from scene to scene, with the sums over them.
//!
//! Each scene gets the rays of the one before: as many from each element, with the same numbers, so that
//! frames differ by what has moved and not by noise. The sums over hits are those of the scene before, less
//! the rays that meet something else now, plus what these meet:
//!
//! ```text
//! S′ = S − Σ w φ_k(x) φ_l(y) + Σ w′ φ_k(x′) φ_l(y′)   over the rays that have changed.
//! ```
//!
//! A ray is looked at anew where its element or what it met has changed, or where the box of a surface that
//! has changed lies in its way; it is traced among all surfaces unless those that have changed stay out of
//! it. What a moved surface hid needs no look: the ray met that surface.
//!
//! How many rays each element sends, and which pairs are worth to be carried exactly, is decided once; those
//! whose accuracy rules do not reach in a scene are left to the rays there. Where the cells of
//! an element come to lie on something, or leave it, all rays are sent anew.

use std::collections::HashSet;
use std::sync::Arc;

use radiosity_elements::{Element, Elements};
use radiosity_geom::{Aabb, DVec3};
use radiosity_kernel::Accuracy;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt_at;
use radiosity_work::ranks::{PartName, Ranks};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::kept_blocks::kept_rays::{ChangedSurfaces, RayCounts};
use crate::kept_blocks::{KeptBlocks, KeptHit, LastChange, SceneChange};
use crate::sampled::element_sums::{CountedRay, ElementSums};
use crate::sampled::estimate::Counts;
use crate::sampled::exact_pairs::ExactPairs;
use crate::sampled::hit::{Hit, hit};
use crate::sampled::sender::{Departure, Sender};
use crate::sampled::tally::Tally;

/// Part of the size of a scene by which boxes are widened before rays in single precision.
const ROUNDED: f64 = 1e-6;

/// Components of directions below this one count as it, so that their inverses are finite in single
/// precision.
const LEAST_COMPONENT: f64 = 1e-20;

/// Boxes are joined where the area of both together exceeds their sum by no more than this factor. Chosen.
const JOINED: f64 = 1.5;

/// The rays of a scene, kept for the next one.
#[derive(Debug, Default)]
pub struct StandingRays {
    state: Option<State>,
}

/// The rays of a scene with the sums over them.
#[derive(Debug)]
pub(super) struct State {
    pub elements: Arc<Elements>,
    pub senders: Vec<Sender>,
    /// Rays that each element sent in the pilot round, which do not count.
    pub pilot: Vec<u64>,
    /// All rays that each element sent.
    pub sent: Vec<u64>,
    /// The rays that count of each element, where this rank sends from it.
    pub rays: Vec<ElementRays>,
    pub counts: Counts,
    pub tally: Tally,
    /// Pairs that are carried exactly where rules reach their accuracy.
    pub worth: HashSet<(u32, u32)>,
    /// Those that are, on which no ray counts.
    pub exact: HashSet<(u32, u32)>,
}

/// A ray and what it meets.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct StandingRay {
    met: KeptHit,
    origin: [f32; 3],
    /// Inverse of each component of the direction, finite.
    inverse: [f32; 3],
}

/// The rays of an element that count, by number. Their ways stand component by component, so that many are
/// held against a box at once.
#[derive(Debug, Default)]
pub(super) struct ElementRays {
    met: Vec<KeptHit>,
    origins: [Vec<f32>; 3],
    inverses: [Vec<f32>; 3],
    /// Distances to where they meet something, rounded up.
    ends: Vec<f32>,
}

/// A box in single precision.
struct Box32 {
    min: [f32; 3],
    max: [f32; 3],
}

/// Changes of the sums over the rays of an element.
#[derive(Debug, Serialize, Deserialize)]
struct Redone {
    sums: ElementSums,
    /// Hits that are taken back.
    removed: Vec<Hit>,
    added: Vec<Hit>,
    /// The rays that were looked at, by their place.
    rays: Vec<(u32, StandingRay)>,
    traced: u64,
}

/// The scene that rays stand in, beside the one before.
struct Scenes<'a> {
    before: &'a State,
    elements: &'a Elements,
    visibility: &'a Visibility,
    /// Senders of the elements that have changed.
    senders: Vec<Option<Sender>>,
    change: &'a SceneChange,
    changed: &'a ChangedSurfaces,
    /// Whether any element of each surface has changed.
    recut: Vec<bool>,
    boxes: Vec<Box32>,
    /// The pairs on which no ray counts now.
    exact: &'a ExactPairs,
    /// Whether rays begin or cease to count on a pair of each element.
    recounted: Vec<bool>,
}

/// Whether the same elements have as many functions, and lie on something, in both.
fn are_covered_alike(before: &Elements, now: &Elements) -> bool {
    let mut pairs = before.list().iter().zip(now.list());
    before.starts() == now.starts()
        && pairs.all(|(a, b)| (a.contact.is_some(), a.shaded_by) == (b.contact.is_some(), b.shaded_by))
}

impl StandingRays {
    /// The state of the scene before, moved to that of `elements`, with the exact pairs of this scene; None
    /// where all rays have to be sent anew. `kept` was moved to this scene.
    pub(super) fn moved(
        &mut self,
        elements: &Elements,
        visibility: &Visibility,
        accuracy: Accuracy,
        kept: &mut KeptBlocks,
        work: &Work<'_>,
    ) -> Option<(State, ExactPairs)> {
        let mut state = self.state.take()?;
        let last_change = kept.last_change()?;
        let shared = kept.shared_elements()?;
        if !are_covered_alike(&state.elements, elements) {
            return None;
        }
        let exact = ExactPairs::new(state.worth.clone(), elements, visibility, accuracy, Some(kept), work);
        let scenes = Scenes::new(&state, elements, visibility, &last_change, &exact);
        let redone = scenes.redone(work.ranks);
        let senders = scenes.senders;
        let counts = state.take(elements.list(), senders, redone, work.ranks);
        state.elements = shared;
        state.exact.clone_from(exact.pairs());
        kept.count_rays(counts, work.ranks);
        Some((state, exact))
    }

    /// Keeps the rays of this scene for the next one.
    pub(super) fn keep(&mut self, state: State) {
        self.state = Some(state);
    }
}

impl State {
    /// Takes what was redone, element by element, and the senders of the elements that have changed.
    fn take(
        &mut self,
        list: &[Element],
        senders: Vec<Option<Sender>>,
        redone: Vec<Redone>,
        ranks: &Ranks,
    ) -> RayCounts {
        let starts = self.elements.starts();
        let (mut removed, mut added, mut counts) = (Vec::new(), Vec::new(), RayCounts::default());
        for (element, mut own) in redone.into_iter().enumerate() {
            self.counts.add(element, starts[element], &own.sums);
            removed.append(&mut own.removed);
            added.append(&mut own.added);
            if element % ranks.count() == ranks.number() {
                counts.traced += own.traced;
                counts.recalled += self.rays[element].met.len() as u64 - own.traced;
                own.rays.into_iter().for_each(|(place, ray)| self.rays[element].set(place as usize, ray));
            }
        }
        let held = HeldRows::of(ranks, &starts);
        let counts_here = |hit: &Hit| hit.is_counted_by(ranks.number(), &held);
        if !held.ranks().are_alone() {
            removed.retain(counts_here);
            added.retain(counts_here);
        }
        self.tally.take(self.elements.list(), &removed);
        self.tally.take(list, &added);
        let fresh = self.senders.iter_mut().zip(senders);
        fresh.filter_map(|(own, fresh)| Some((own, fresh?))).for_each(|(own, fresh)| *own = fresh);
        counts
    }
}

impl StandingRay {
    /// A ray as it leaves, and what it meets.
    pub(super) fn new(departure: &Departure, met: KeptHit) -> Self {
        let inverse =
            |x: f64| if x.abs() < LEAST_COMPONENT { x.signum() / LEAST_COMPONENT } else { x.recip() };
        let single = |x: [f64; 3]| x.map(|x| x as f32);
        let origin = single(departure.node.position.to_array());
        Self { met, origin, inverse: single(departure.direction.to_array().map(inverse)) }
    }

    /// Distance to where it meets something (scene length), rounded up.
    fn end(&self) -> f32 {
        self.met.distance() as f32 * (1.0 + 2.0 * f32::EPSILON)
    }
}

impl FromIterator<StandingRay> for ElementRays {
    fn from_iter<I: IntoIterator<Item = StandingRay>>(rays: I) -> Self {
        let mut own = Self::default();
        for ray in rays {
            own.met.push(ray.met);
            own.ends.push(ray.end());
            for k in 0..3 {
                own.origins[k].push(ray.origin[k]);
                own.inverses[k].push(ray.inverse[k]);
            }
        }
        own
    }
}

impl ElementRays {
    fn set(&mut self, place: usize, ray: StandingRay) {
        self.met[place] = ray.met;
        self.ends[place] = ray.end();
        for k in 0..3 {
            self.origins[k][place] = ray.origin[k];
            self.inverses[k][place] = ray.inverse[k];
        }
    }

    /// Marks the rays that may come into a box before they meet something.
    fn mark_into(&self, own: &Box32, marks: &mut [bool]) {
        let count = marks.len();
        let [x, y, z] = self.origins.each_ref().map(|list| &list[..count]);
        let [u, v, w] = self.inverses.each_ref().map(|list| &list[..count]);
        let ends = &self.ends[..count];
        for k in 0..count {
            let (mut enter, mut leave) = (0.0f32, ends[k]);
            for (axis, [origin, inverse]) in
                [[x[k], u[k]], [y[k], v[k]], [z[k], w[k]]].into_iter().enumerate()
            {
                let (a, b) = ((own.min[axis] - origin) * inverse, (own.max[axis] - origin) * inverse);
                let (near, far) = if a < b { (a, b) } else { (b, a) };
                enter = if near > enter { near } else { enter };
                leave = if far < leave { far } else { leave };
            }
            marks[k] |= enter <= leave;
        }
    }
}

/// Boxes that hold all of `boxes`, those of neighbours in the list as one where they are near each other,
/// widened by `margin` (length).
fn joined(boxes: &[Aabb], margin: f64) -> Vec<Box32> {
    let mut joined: Vec<Aabb> = Vec::new();
    for own in boxes {
        match joined.last_mut() {
            Some(last) if last.union(*own).surface() <= JOINED * (last.surface() + own.surface()) => {
                *last = last.union(*own);
            }
            _ => joined.push(*own),
        }
    }
    let single = |x: DVec3| x.as_vec3().to_array();
    let wide = joined.into_iter().map(|own| own.inflate(margin));
    wide.map(|own| Box32 { min: single(own.min), max: single(own.max) }).collect()
}

impl<'a> Scenes<'a> {
    fn new(
        before: &'a State,
        elements: &'a Elements,
        visibility: &'a Visibility,
        LastChange { change, changed }: &'a LastChange,
        exact: &'a ExactPairs,
    ) -> Self {
        let list = elements.list();
        let fresh = |(index, element): (usize, &Element)| {
            change.is_moved(index, element.surface).then(|| Sender::new(element, index as u64))
        };
        let mut recut = changed.surfaces.clone();
        let changed_elements = list.iter().zip(&change.elements).filter(|(_, is_other)| **is_other);
        changed_elements.for_each(|(element, _)| recut[element.surface] = true);
        let mut recounted = vec![false; list.len()];
        let others = before.exact.symmetric_difference(exact.pairs());
        others.flat_map(|(a, b)| [*a, *b]).for_each(|element| recounted[element as usize] = true);
        let bounds = visibility.bounds();
        let size = bounds.min.abs().max(bounds.max.abs()).max_element();
        Self {
            before,
            elements,
            visibility,
            senders: list.par_iter().enumerate().map(fresh).collect(),
            change,
            changed,
            recut,
            boxes: joined(&changed.boxes, ROUNDED * size + 2.0 * changed.reach),
            exact,
            recounted,
        }
    }

    /// The changes of the sums over the rays of all elements, each made by one rank and known to all.
    fn redone(&self, ranks: &Ranks) -> Vec<Redone> {
        let makers: Vec<usize> =
            (0..self.elements.list().len()).map(|element| element % ranks.count()).collect();
        let own = ranks.made(PartName::Rays, &makers, |element| self.of_element(element));
        let mut all: Vec<_> = ranks.all(own).into_iter().map(Vec::into_iter).collect();
        makers.into_iter().map(|rank| all[rank].next().expect("each rank made its elements")).collect()
    }

    fn of_element(&self, element: usize) -> Redone {
        let own = &self.elements.list()[element];
        let is_other = self.recounted[element] || self.change.is_moved(element, own.surface);
        let (mut redone, rays) = (Redone::nothing(own.basis.len()), &self.before.rays[element]);
        let mut marks = vec![is_other; rays.met.len()];
        if !is_other {
            self.boxes.iter().for_each(|own| rays.mark_into(own, &mut marks));
        }
        let pilot = self.before.pilot[element];
        for (place, (met, mark)) in rays.met.iter().zip(marks).enumerate() {
            check_interrupt_at(place as u64);
            if mark || met.surface().is_some_and(|surface| self.recut[surface]) {
                self.redo([element, place], pilot + place as u64, *met, &mut redone);
            }
        }
        redone
    }

    /// Looks at ray number `index` of an element, at its place among those that count.
    fn redo(&self, [element, place]: [usize; 2], index: u64, before: KeptHit, redone: &mut Redone) {
        let State { elements, senders, .. } = self.before;
        let old = senders[element].departure(index);
        let fresh = self.senders[element].as_ref();
        let now = fresh.map_or(old, |sender| sender.departure(index));
        let met = before.encounter();
        let stays = fresh.is_none() && !met.is_some_and(|met| self.changed.surfaces[met.surface]);
        let encounter =
            match stays && !self.changed.may_hide([now.node.position, now.direction], before.distance()) {
                true => met,
                false => {
                    redone.traced += 1;
                    let surface = self.elements.list()[element].surface;
                    self.visibility.nearest_from(surface, now.node.position, now.direction)
                }
            };
        let kept = KeptHit::of(encounter.as_ref());
        let is_recut = met.is_some_and(|met| self.recut[met.surface]);
        if fresh.is_none() && kept == before && !is_recut && !self.recounted[element] {
            return;
        }
        redone.rays.push((place as u32, StandingRay::new(&now, kept)));
        let half = (index % 2) as usize;
        let gone = hit(elements, element, index, &old, met);
        let is_exact = gone.is_some_and(|hit| self.before.exact.contains(&hit.pair()));
        let ray = CountedRay { element: &elements.list()[element], departure: &old, half, sign: -1.0 };
        redone.removed.extend(redone.sums.count(ray, gone, is_exact).map(Hit::taken_back));
        let come = hit(self.elements, element, index, &now, encounter);
        let is_exact = come.is_some_and(|hit| self.exact.holds(hit.pair()));
        let ray = CountedRay { element: &self.elements.list()[element], departure: &now, half, sign: 1.0 };
        redone.added.extend(redone.sums.count(ray, come, is_exact));
    }
}

impl Redone {
    /// No changes, of an element of so many functions.
    fn nothing(functions: usize) -> Self {
        Self {
            sums: ElementSums::nothing(functions),
            removed: Vec::new(),
            added: Vec::new(),
            rays: Vec::new(),
            traced: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use radiosity_elements::Discretization;
    use radiosity_scene::{FrameScenes, Scene, Source};
    use radiosity_visibility::Shadows;

    use super::*;
    use crate::sampled::SampledTransport;
    use crate::sampled::rays::Rays;

    const ACCURACY: Accuracy = Accuracy { eps: 1e-2, shadow_eps: 1e-2 };

    /// A room with a block, through which a ball flies, a plate turns, and a slab slides over the floor.
    const ROOM: &str = r#"
        frames = 9
        camera = { eye = [1, 1, 1], target = [2, 2, 1] }
        materials.grey = { reflectance = 0.5, emission = 1 }
        [[surfaces]]
        name = "room"
        material = "grey"
        box = { origin = [0, 0, 0], size = [4, 3, 2], inward = true }
        [[surfaces]]
        name = "block"
        material = "grey"
        box = { origin = [1, 1, 0.2], size = [0.5, 0.6, 0.7] }
        [[surfaces]]
        name = "ball"
        material = "grey"
        sphere = { center = [0.6, 0.6, 1.4], radius = 0.3 }
        [[surfaces]]
        name = "plate"
        material = "grey"
        two_sided = true
        quad = { vertices = [[2.5, 1, 0.5], [3.5, 1, 0.5], [3.5, 1.2, 1.5], [2.5, 1.2, 1.5]] }
        [[motion]]
        name = "flight"
        surfaces = ["ball"]
        translate = { points = [[0, 0, 0], [2.6, 1.5, -0.5]] }
        [[motion]]
        name = "turn"
        surfaces = ["plate"]
        rotate = { center = [3, 1, 1], axis = [0, 0, 1], angles = [0, 200] }
    "#;

    fn settled<'a>(mut transport: SampledTransport<'a>, work: &Work<'_>) -> SampledTransport<'a> {
        let [pilot, planned] = [4, 24].map(|rays| vec![rays; transport.sent().len()]);
        transport.send(&pilot, &mut |_| true);
        transport.settle(&planned, ACCURACY, work);
        transport.send(&planned, &mut |_| true);
        assert_eq!(transport.exact_pairs(), 0);
        transport
    }

    /// G x of the transport for some x.
    fn product(transport: &SampledTransport<'_>, elements: &Elements) -> Vec<f64> {
        let x: Vec<f64> = (0..elements.coefficients()).map(|k| ((7 * k) % 11) as f64 - 3.0).collect();
        transport.blocks(Rays::All).apply(&x)
    }

    fn placed(frames: &mut FrameScenes<'_>, moment: f64) -> (Scene, Visibility) {
        let still = frames.at(moment).unwrap();
        let visibility = Visibility::new(&still, Shadows::default(), ACCURACY.shadow_eps);
        (still, visibility)
    }

    #[test]
    fn sums_over_standing_rays_are_those_over_rays_sent_anew() {
        let scene = radiosity_language::read(&Source::new("room", ROOM)).unwrap();
        let (mut frames, work) = (FrameScenes::of(&scene), Work::alone());
        let (still, visibility) = placed(&mut frames, 0.0);
        let mut elements = Arc::new(Elements::new(&still, &Discretization::uniform(0, 4)).unwrap());
        let (mut kept, mut standing) = (KeptBlocks::default(), StandingRays::default());
        kept.move_to(&still, &elements, &visibility);
        let transport = SampledTransport::keeping(&elements, &visibility, Some(&mut kept), work.ranks);
        settled(transport, &work).keep_standing(&mut standing, &mut kept);
        for moment in [0.5, 3.0, 7.25, 8.0, 2.0, 0.0] {
            let (still, visibility) = placed(&mut frames, moment);
            elements = Arc::new(elements.moved(&still).unwrap());
            kept.move_to(&still, &elements, &visibility);
            let rays = (&mut standing, &mut kept);
            let transport =
                SampledTransport::standing(&elements, &visibility, ACCURACY, rays.0, rays.1, &work).unwrap();
            let anew = settled(SampledTransport::new(&elements, &visibility, work.ranks), &work);
            let [own, other] = [&transport, &anew].map(|transport| product(transport, &elements));
            let scale = other.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for (own, other) in own.iter().zip(&other) {
                assert!((own - other).abs() <= 1e-5 * scale, "{moment}: {own} for {other}");
            }
            transport.keep_standing(&mut standing, &mut kept);
        }
        let counts = kept.ray_counts();
        assert!(counts.traced > 0 && counts.recalled > counts.traced, "{counts:?}");
    }
}
