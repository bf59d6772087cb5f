//! The block of a pair under way: a queue of pairs of parts, and the sums so far.
//!
//! Each pair of parts is narrowed to the blockers between them and classified by its contact. Then either a rule
//! sums it, or it is halved, and the parts are put into the queue: flat ones at its front, so that few are held;
//! others at its end, so that all parts are refined alike until the samples are spent. What no rule covers is
//! summed roughly, and counts as error.

use std::collections::VecDeque;

use radiosity_elements::Element;
use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::{COINCIDENT, DVec3, polygon_area, touching};
use radiosity_kernel::contact::clip::{Facet, match_contact};
use radiosity_kernel::contact::gap::gap;
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::estimates::entry_norm::EntryNorm;
use radiosity_kernel::moments::Moments;
use radiosity_kernel::rules::common_edge::EdgePair;
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::horizon::{Ball, Front};
use radiosity_kernel::rules::zone::Zone;
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;

use crate::occlusion::sampled::{SampledVisibility, SummedPoints};
use crate::pair::budget::Budget;
use crate::pair::size;
use crate::pair::tolerance::Tolerance;
use crate::tolerances::BELOW_ESTIMATE;

/// A part of the block to do.
pub(super) enum Task {
    /// Half of a patch with itself.
    Same(Patch, State),
    Pair(Patch, Patch, State),
    /// Parts of one element as seen from one part of the other, with nothing or one ball in between.
    Fan(Patch, Vec<Patch>),
}

#[derive(Clone)]
pub(super) struct State {
    /// Whether the patches may touch.
    pub touching: bool,
    /// Halvings left before visibility is sampled.
    pub levels: u32,
    pub blockers: Vec<usize>,
}

/// A ball that stands between two elements.
#[derive(Clone, Copy, Debug)]
pub(super) struct BallBlocker {
    pub surface: usize,
    pub ball: Ball,
}

/// The inner element of fans on a sphere, and its sectors.
pub(super) struct InnerZone<'a> {
    pub zone: Zone<'a>,
    pub sectors: Vec<Patch>,
}

pub(super) struct Job<'a> {
    pub visibility: &'a Visibility,
    /// Errors allowed; the samples of a flat pair are not limited.
    pub budget: Budget,
    pub elements: [&'a Element; 2],
    /// Whether both elements are flat: then no horizon cuts their parts.
    pub are_flat: bool,
    pub degrees: [usize; 2],
    /// Extent of the larger element (scene length).
    pub size: f64,
    /// Points nearer than this coincide (scene length).
    pub tolerance: f64,
    /// The fronts of both planes, the one that cuts the first element first, if both elements are planar and
    /// one has curved sides.
    pub fronts: Option<[Front; 2]>,
    /// The ball that stands between in fans.
    pub ball: Option<BallBlocker>,
    /// The inner element of fans, if it lies on a sphere and nothing stands between.
    pub inner: Option<InnerZone<'a>>,
    pub moments: Moments<'a>,
    pub norm: EntryNorm,
    pub tasks: VecDeque<Task>,
    pub kind: PairKind,
    pub partly_hidden: bool,
    pub unresolved: bool,
    pub error: f64,
    /// First entry of what rules carry that tell their errors.
    pub told: f64,
}

impl<'a> Job<'a> {
    pub(super) fn new(elements: [&'a Element; 2], visibility: &'a Visibility, errors: Tolerance) -> Self {
        let Tolerance { accuracy, shadow_error, .. } = errors;
        let [receiver, emitter] = elements;
        let unit = (receiver.area * emitter.area).sqrt();
        let are_flat = elements.iter().all(|element| element.plane.is_some());
        let (size, tolerance) = if are_flat {
            let [small, size] = [f64::min, f64::max].map(|of| of(receiver.extent, emitter.extent));
            (size, touching(small, size))
        } else {
            let size = receiver.bounds().diagonal().max(emitter.bounds().diagonal());
            (size, COINCIDENT * size)
        };
        Self {
            visibility,
            budget: Budget { accuracy, shadow_error, unit, scale: 1.0, row: 1.0, horizons: 0, looks: 0 },
            elements,
            are_flat,
            degrees: elements.map(|element| element.basis.total_degree()),
            size,
            tolerance,
            fronts: None,
            ball: None,
            inner: None,
            moments: Moments::new(&receiver.basis, &emitter.basis),
            norm: EntryNorm::of([&receiver.basis, &emitter.basis]),
            tasks: VecDeque::new(),
            kind: PairKind::Separated,
            partly_hidden: false,
            unresolved: false,
            error: 0.0,
            told: 0.0,
        }
    }

    /// Does the tasks of the queue, until it is empty or the samples are spent.
    pub(super) fn run(&mut self) {
        while let Some(task) = self.tasks.pop_front() {
            check_interrupt();
            if !self.are_flat && self.budget.overdrawn(&self.moments) {
                self.tasks.push_front(task);
                return self.leave();
            }
            match task {
                Task::Same(patch, state) => self.same(&patch, state),
                Task::Pair(p, q, state) if self.are_flat => self.flat(&p, &q, state),
                Task::Pair(p, q, state) => self.curved(&p, &q, state),
                Task::Fan(outer, inner) => self.fan(&outer, inner),
            }
            // As κ ≥ 0, the sum so far bounds the first entry from below, except for its own error.
            self.budget.scale = self.budget.scale.max(BELOW_ESTIMATE * self.first_entry(&self.moments));
        }
    }

    pub(super) fn finish(self) -> Block {
        let mut block = Block::of(self.moments, self.kind, self.partly_hidden);
        (block.report.unresolved, block.report.error) = (self.unresolved, self.error);
        block.report.told = if self.partly_hidden { 0.0 } else { self.told };
        block
    }

    /// The first entry of a block with these moments.
    pub(super) fn first_entry(&self, moments: &Moments) -> f64 {
        self.norm.first_entry(moments.values())
    }

    /// The state of a pair with those of its blockers that reach between its parts; None where one of them
    /// hides all.
    pub(super) fn narrowed(&self, p: &Patch, q: &Patch, mut state: State) -> Option<State> {
        if !state.blockers.is_empty() {
            let (hull_p, hull_q) = (p.hull(), q.hull());
            state.blockers = self.visibility.narrow(&state.blockers, &hull_p, &hull_q);
            if self.visibility.hidden(&state.blockers, &hull_p, &hull_q) {
                return None;
            }
        }
        Some(state)
    }

    /// The contact of a pair, told to its state for its parts.
    pub(super) fn contact(&self, p: &Patch, q: &Patch, state: &mut State) -> Contact {
        let contact = match state.touching {
            false => Contact::Apart(gap(p, q)),
            true if self.are_flat => Contact::of_flat(p, q, self.tolerance),
            true => Contact::of(p, q, self.tolerance),
        };
        state.touching = contact.gap() <= 0.0;
        contact
    }

    /// Whether two parts are nearer than the tensor rule allows.
    pub(super) fn is_near(p: &Patch, q: &Patch, gap: f64) -> bool {
        gap < SMALLEST_RATIO * p.longest().1.max(q.longest().1)
    }

    /// Whether points of the two elements see each other past these blockers.
    pub(super) fn sees<'b>(&self, blockers: &'b [usize]) -> impl Fn(DVec3, DVec3) -> bool + use<'a, 'b> {
        let (visibility, own) = (self.visibility, self.elements.map(|element| element.surface));
        move |x, y| visibility.free_between(own, blockers, x, y)
    }

    /// Samples what two parts apart see of each other. Returns true if what is hidden was subtracted, so that
    /// the unobstructed part has yet to be added. Errors of parts have either sign, so that their variances
    /// add: each part gets its share.
    pub(super) fn scatter(&mut self, p: &Patch, q: &Patch, summed: SummedPoints, blockers: &[usize]) -> bool {
        let area = |patch: &Patch| match self.are_flat {
            true => polygon_area(&patch.polygon()),
            false => size::area(patch),
        };
        let scale = self.norm.first();
        let limit = self.budget.shadow_error / scale * (area(p) * area(q)).sqrt() / self.budget.unit;
        let sees = self.sees(blockers);
        let found = SampledVisibility::new([p, q], self.moments.bases(), &sees, limit, summed);
        found.add_to(&mut self.moments);
        self.error += scale * found.error;
        found.hidden
    }

    /// Halves a pair towards the case of a rule: at a cut, at a tip, or across the longest extent; both sides
    /// together along a common edge that is as long (0.999 allows for rounding).
    pub(super) fn halve(&mut self, p: &Patch, q: &Patch, contact: &Contact, state: &State) {
        match contact {
            Contact::Edge { p: a, q: b, matched: true } => {
                let edge_pair = EdgePair::of(a, b);
                if edge_pair.length >= 0.999 * edge_pair.depths[0].max(edge_pair.depths[1]) {
                    return self.product(&a.halves(Direction::Along), &b.halves(Direction::Along), state);
                }
            }
            Contact::Cut(places) => {
                let [parts_p, parts_q] = parts([p, q], *places, |patch, at| patch.cut(at.direction, at.at));
                return self.product(&parts_p, &parts_q, state);
            }
            Contact::Tip(directions) => {
                let [parts_p, parts_q] = parts([p, q], *directions, Patch::halves);
                return self.product(&parts_p, &parts_q, state);
            }
            _ => {}
        }
        self.queue(Patch::halve_longer(p, q).to_vec(), state);
    }

    pub(super) fn product(&mut self, receivers: &[Patch], emitters: &[Patch], state: &State) {
        let pairs = receivers.iter().flat_map(|p| emitters.iter().map(move |q| [p.clone(), q.clone()]));
        self.queue(pairs.collect(), state);
    }

    /// Puts the parts of a pair into the queue; flat ones that may touch are cut at their contact.
    fn queue(&mut self, pairs: Vec<[Patch; 2]>, state: &State) {
        if !self.are_flat || !state.touching {
            return self.put(pairs, state);
        }
        let matched = |[p, q]: &[Patch; 2]| match_contact(&Facet::of(p), &Facet::of(q), self.tolerance);
        self.put(patches(&pairs.iter().flat_map(matched).collect::<Vec<_>>()), state);
    }

    /// Puts pairs of parts into the queue as they are.
    pub(super) fn put(&mut self, pairs: Vec<[Patch; 2]>, state: &State) {
        let tasks = pairs.into_iter().map(|[p, q]| Task::Pair(p, q, state.clone()));
        if self.are_flat {
            tasks.rev().for_each(|task| self.tasks.push_front(task));
        } else {
            self.tasks.extend(tasks);
        }
    }
}

/// Either patch as it is, or in the two parts of the cut that is given for it.
fn parts<T>(pair: [&Patch; 2], cuts: [Option<T>; 2], cut: fn(&Patch, T) -> [Patch; 2]) -> [Vec<Patch>; 2] {
    let [p, q] = cuts;
    [(pair[0], p), (pair[1], q)]
        .map(|(patch, place)| place.map_or_else(|| vec![patch.clone()], |place| cut(patch, place).to_vec()))
}

/// The pairs of patches of pairs of facets.
pub(super) fn patches(facets: &[(Facet, Facet)]) -> Vec<[Patch; 2]> {
    let of = |facet: &Facet| Patch::of_polygon(&facet.corners, facet.normal);
    let mut pairs = Vec::new();
    for (p, q) in facets {
        let emitters = of(q);
        for p in of(p) {
            pairs.extend(emitters.iter().map(|q| [p.clone(), q.clone()]));
        }
    }
    pairs
}
