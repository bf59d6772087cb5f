//! The block of a pair with a curved element under way: parts to do, and the sums so far.

use std::collections::VecDeque;

use radiosity_elements::Element;
use radiosity_elements::patch::{Direction, Patch};
use radiosity_geom::COINCIDENT;
use radiosity_kernel::contact::curved::CurvedContact;
use radiosity_kernel::contact::sectors::sectors;
use radiosity_kernel::estimates::coarse::largest_kernel;
use radiosity_kernel::estimates::entry_bounds::SMALLEST_ENTRY;
use radiosity_kernel::estimates::entry_norm::EntryNorm;
use radiosity_kernel::moments::Moments;
use radiosity_kernel::rules::common_edge::EdgePair;
use radiosity_kernel::rules::horizon::{Ball, Front};
use radiosity_kernel::{PairKind, blocks::block::Block};
use radiosity_visibility::Visibility;

use crate::pair::curved::budget::Budget;
use crate::pair::curved::points::Points;
use crate::pair::curved::size::area;
use crate::pair::tolerance::Tolerance;
use crate::tolerances::ABOVE_ESTIMATE;

/// Largest share, relative to the block's scale, of parts that are attempted before they are halved or cut at
/// horizons: a rule that errs by half of such a part errs by a hundredth of the block. With a larger value
/// more attempts fail.
pub(super) const SMALL_PART: f64 = 0.02;
/// Ratio of areas below which a coarse estimate is trusted to find a block negligible: on an element that is
/// much larger few of its nodes are near the other one.
const LARGEST_AREA_RATIO: f64 = 100.0;
/// Smallest scale of the block of a surface with itself: what it sends to others is larger, and errors of
/// less show nowhere.
const SMALLEST_OWN_SCALE: f64 = 5e-3;

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

pub(super) struct Job<'a> {
    pub visibility: &'a Visibility,
    pub budget: Budget,
    pub elements: [&'a Element; 2],
    pub degrees: [usize; 2],
    pub size: f64,
    /// The fronts of both planes, the one that cuts the first element first, if both elements are planar.
    pub fronts: Option<[Front; 2]>,
    /// The ball that stands between in fans.
    pub ball: Option<BallBlocker>,
    pub moments: Moments<'a>,
    pub norm: EntryNorm,
    pub tasks: VecDeque<Task>,
    pub kind: PairKind,
    pub partly_hidden: bool,
    pub unresolved: bool,
    pub error: f64,
}

impl<'a> Job<'a> {
    pub(super) fn new(
        receiver: &'a Element,
        emitter: &'a Element,
        visibility: &'a Visibility,
        tolerance: Tolerance,
    ) -> Self {
        let Tolerance { accuracy, shadow_error, .. } = tolerance;
        let unit = (receiver.area * emitter.area).sqrt();
        Self {
            visibility,
            budget: Budget { accuracy, shadow_error, unit, scale: 1.0, row: 1.0, horizons: 0, looks: 0 },
            elements: [receiver, emitter],
            degrees: [receiver.basis.total_degree(), emitter.basis.total_degree()],
            size: receiver.bounds().diagonal().max(emitter.bounds().diagonal()),
            fronts: None,
            ball: None,
            moments: Moments::new(&receiver.basis, &emitter.basis),
            norm: EntryNorm::of([&receiver.basis, &emitter.basis]),
            tasks: VecDeque::new(),
            kind: PairKind::Separated,
            partly_hidden: false,
            unresolved: false,
            error: 0.0,
        }
    }

    pub(super) fn surfaces(&self) -> [usize; 2] {
        self.elements.map(|element| element.surface)
    }

    /// The first entry of a block with these moments.
    pub(super) fn first_entry(&self, moments: &Moments) -> f64 {
        self.norm.first_entry(moments.values())
    }

    pub(super) fn smallest_scale(&self) -> f64 {
        let [a, b] = self.surfaces();
        if a == b { SMALLEST_OWN_SCALE } else { SMALLEST_ENTRY }
    }

    /// Whether the whole block is below its allowed error, as of a nearly flat surface with itself. Elements
    /// of very different sizes are excluded, where a coarse estimate may miss corners that alone see each
    /// other.
    pub(super) fn carries_nothing(&mut self, rough: f64, [receivers, emitters]: [&[Patch]; 2]) -> bool {
        let [a, b] = self.elements.map(|element| element.area);
        let may_err = self.budget.may_err();
        let nothing = a.max(b) < LARGEST_AREA_RATIO * a.min(b)
            && ABOVE_ESTIMATE * rough < may_err
            && self.budget.unit * largest_kernel(receivers, emitters) < may_err;
        if nothing {
            self.error += rough;
        }
        nothing
    }

    /// The only blocker, if it is a ball and both elements lie outside it.
    pub(super) fn ball_between(&self, blockers: &[usize]) -> Option<BallBlocker> {
        let (center, radius) = self.visibility.only_ball(blockers)?;
        let outside = |patch: &Patch| {
            let corners = patch.corners();
            let inner = patch.cell_nodes(6);
            let points = corners.iter().copied().chain(inner.iter().map(|x| x.position));
            points.into_iter().all(|x| x.distance(center) >= radius * (1.0 - COINCIDENT))
        };
        let all = self.elements.iter().flat_map(|element| sectors(element)).all(|patch| outside(&patch));
        all.then_some(BallBlocker { surface: blockers[0], ball: Ball { center, radius } })
    }

    /// The ball of fans, if it may stand between these two patches.
    pub(super) fn between(&self, p: &Patch, q: &Patch) -> Vec<usize> {
        let between = |surface: &usize| self.visibility.reaches(*surface, &p.hull(), &q.hull());
        self.ball.map(|ball| ball.surface).filter(between).into_iter().collect()
    }

    /// The data for the numbers of points of a pair of parts.
    pub(super) fn points(&self, p: &Patch, q: &Patch) -> Points {
        Points { degrees: self.degrees, eps: self.budget.part_eps(p, q) }
    }

    pub(super) fn spent(&self) -> bool {
        self.budget.spent(&self.moments)
    }

    pub(super) fn finish(self) -> Block {
        let block = Block::of(self.moments, self.kind, self.partly_hidden);
        Block { unresolved: self.unresolved, error: self.error, ..block }
    }

    /// The state of a pair of sectors: being a sector counts as the halvings that would make a part of the
    /// same size.
    pub(super) fn state(&self, p: &Patch, q: &Patch, blockers: &[usize]) -> State {
        let halved = -(area(p) * area(q) / (self.budget.unit * self.budget.unit)).log2();
        let levels = self.budget.accuracy.shadow_levels().saturating_sub(halved.max(0.0) as u32);
        State { touching: true, levels, blockers: blockers.to_vec() }
    }

    pub(super) fn sectors(&mut self, receivers: &[Patch], emitters: &[Patch], blockers: &[usize]) {
        for p in receivers {
            for q in emitters {
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), self.state(p, q, blockers)));
            }
        }
    }

    pub(super) fn product(&mut self, receivers: &[Patch], emitters: &[Patch], state: &State) {
        for p in receivers {
            for q in emitters {
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), state.clone()));
            }
        }
    }

    /// Halves a pair towards the case of a rule: at a cut, at a tip, or across the longest extent; both sides
    /// together along a common edge that is as long.
    pub(super) fn halve(&mut self, p: &Patch, q: &Patch, contact: &CurvedContact, state: &State) {
        let whole = |patch: &Patch| vec![patch.clone()];
        match contact {
            CurvedContact::Edge { p: a, q: b, matched: true } => {
                let edge_pair = EdgePair::of(a, b);
                if edge_pair.length >= 0.999 * edge_pair.depths[0].max(edge_pair.depths[1]) {
                    return self.product(&a.halves(Direction::Along), &b.halves(Direction::Along), state);
                }
            }
            CurvedContact::Cut([at_p, at_q]) => {
                let parts_p =
                    at_p.map_or_else(|| whole(p), |place| p.cut(place.direction, place.at).to_vec());
                let parts_q =
                    at_q.map_or_else(|| whole(q), |place| q.cut(place.direction, place.at).to_vec());
                return self.product(&parts_p, &parts_q, state);
            }
            CurvedContact::Tip([at_p, at_q]) => {
                let parts_p = at_p.map_or_else(|| whole(p), |direction| p.halves(direction).to_vec());
                let parts_q = at_q.map_or_else(|| whole(q), |direction| q.halves(direction).to_vec());
                return self.product(&parts_p, &parts_q, state);
            }
            _ => {}
        }
        let ((direction_p, extent_p), (direction_q, extent_q)) = (p.longest(), q.longest());
        if extent_p >= extent_q {
            self.product(&p.halves(direction_p), std::slice::from_ref(q), state);
        } else {
            self.product(std::slice::from_ref(p), &q.halves(direction_q), state);
        }
    }
}
