//! Blocks of elements of which at least one is curved.
//!
//! A patch is first cut until neither its lines nor its normals turn by more than a quarter circle: closed surfaces
//! become sectors. Then, part by part, breadth first:
//!
//! * parts that face away from each other are dropped ([`super::facing`]);
//! * a part with itself: convex → nothing, concave → [`super::same`], else halves with themselves and each other;
//! * where the kernel is constant (two parts of the inside of one sphere) a plain product rule is right at once;
//! * apart: a tensor rule, or [`super::horizon`] where a horizon may run through;
//! * touching: brought to a rule by cuts and halves ([`super::touch`]), then [`super::edge`], [`super::seam`] or
//!   [`super::vertex`];
//! * what blockers may cut is halved a few times and then sampled, as for planar pairs.
//!
//! Contacts that no rule covers, and touching parts with a horizon, are halved until what is left carries nothing or
//! the samples of the block are spent; the rest is summed roughly and counted into the block's error.

use std::collections::VecDeque;
use std::sync::Arc;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::{Direction, Patch};
use crate::elements::rule::{MOST_POINTS, UnitRule};
use crate::visibility::Visibility;

use super::block::{Accuracy, Block, Kind};
use super::edge::{self, LARGEST_ASPECT, Wedge};
use super::facing::{self, Facing, facing};
use super::fineness;
use super::horizon::{self, Ball, Side};
use super::integrand::{Sees, kernel};
use super::moments::Moments;
use super::pair::gap;
use super::reach::SMALLEST_ENTRY;
use super::rough::{largest_kernel, nodes, scale};
use super::sectors::sectors;
use super::separated::{self, SMALLEST_RATIO};
use super::touch::{Touch, collapsed, cut, touch};
use super::yardstick::Yardstick;
use super::{same, seam, trial, vertex};

/// Points closer than this part of the pair's size coincide.
const COINCIDENT: f64 = 1e-9;
/// Parts that carry less than this times ε of the block are left out.
const NEGLIGIBLE: f64 = 1e-3;
/// Samples of one block after which contacts are refined no more, per squared digit of 1/ε.
const CONTACT_SAMPLES: f64 = 5e5;
/// The same for horizons, whose samples are cheaper.
const HORIZON_SAMPLES: f64 = 1e6;
/// Part of the largest entry of its row below which a block gets less of these, and the least part of them it gets.
const SMALL_IN_ROW: f64 = 0.25;
const LEAST_WORTH: f64 = 0.25;
/// Part of the block's error that the horizons of one outer part may make.
const HORIZON_SHARE: f64 = 0.3;
/// Rays of one block after which shadows are sampled by the coarsest rule, times the square of their accuracy.
const RAYS: f64 = 1.0;
/// Most points a direction of the corner rule, which takes their fourth power.
const MOST_CORNER_POINTS: usize = 20;
/// How many times the samples of contacts and horizons together a block may take before what is left is summed at once.
const OVERDRAFT: u64 = 2;
/// Samples, about, of all that is left then, and points a direction of each part of it.
const LEFT_SAMPLES: f64 = 2e5;
const FEWEST_LEFT: usize = 1;
const MOST_LEFT: usize = 4;
/// Points a direction of attempts on parts that no rule covers, for degree 0.
const FEWEST_POINTS: usize = 4;
/// The same where shadows are sampled once the samples are spent.
const POINTS_WHEN_SPENT: usize = 3;
/// Largest part, relative to the block's first entry, that is attempted at all: a horizon may pass large ones unseen.
const LARGEST_ATTEMPT: f64 = 0.25;
/// Parts up to this size are attempted before they are halved for nearness, or cut at their horizons.
const SMALL_PART: f64 = 0.02;
/// Cosine of the angle at a common edge below which two patches go on smoothly: the kernel is bounded there, and plain rules
/// cost a small part of those that know the edge.
const SMOOTH: f64 = -0.99;
/// Part of the block's error that one attempt may make, and the power of the digits by which it falls beyond four of them: ever
/// more parts are attempted.
const ATTEMPT_SHARE: f64 = 0.03;
const MORE_ATTEMPTS: i32 = 6;
/// By how much less two rules may differ than they err on near parts, where both miss the kernel's peak: measured on a ball
/// that lies on a floor.
const PEAKED: f64 = 2.0;
/// Least error of an attempt that was not good enough, as a part of what it carries.
const DOUBT: f64 = 0.1;
/// What of the sum so far counts as a lower bound of the block's first entry.
const FOUND_SHARE: f64 = 0.5;
/// By how much more than by a rough rule a block may carry.
const ROUGHNESS: f64 = 3.0;
/// Ratio of areas up to which a rough rule tells.
const LARGEST_AREA_RATIO: f64 = 100.0;
/// No block of a surface with itself is taken for smaller than this: beside it stands what the surface loses to others.
const SMALLEST_OWN_SCALE: f64 = 5e-3;

/// The block between two elements; `blockers` are the surfaces that may stand between them, their own among them. The error is measured
/// against the block's first entry or `least`, whichever is larger; contacts and horizons are refined the less the
/// smaller it is beside the largest entry of its `row`.
pub(super) fn block(
    receiver: &Element,
    emitter: &Element,
    blockers: &[usize],
    visibility: &Visibility,
    accuracy: Accuracy,
    [least, row]: [f64; 2],
) -> Block {
    let mut job = Job::new(receiver, emitter, visibility, accuracy);
    let (receivers, emitters) = (sectors(receiver), sectors(emitter));
    let rough = scale(&receivers, &emitters, job.unit);
    job.scale = rough.max(least).max(job.smallest_scale());
    job.row = row;
    if job.carries_nothing(rough, [&receivers, &emitters]) {
        return job.finish();
    }
    job.ball = job.ball_between(blockers);
    if blockers.is_empty() || job.ball.is_some() {
        // The horizon of a plane depends on the other point only: it is cut out of the other patch.
        job.swapped = emitters.iter().all(planar) && !receivers.iter().all(planar);
        let (outer, inner) = if job.swapped { (emitters, receivers) } else { (receivers, emitters) };
        job.tasks.extend(outer.into_iter().map(|part| Task::Fan(part, inner.clone())));
    } else {
        job.sectors(&receivers, &emitters, blockers);
    }
    job.run();
    job.finish()
}

/// The block of a curved element with itself; `blockers` are the surfaces that may stand within its hull, `least`
/// and `row` as for [`block`].
pub(super) fn self_block(
    element: &Element,
    blockers: &[usize],
    visibility: &Visibility,
    accuracy: Accuracy,
    [least, row]: [f64; 2],
) -> Block {
    let mut job = Job::new(element, element, visibility, accuracy);
    let parts = sectors(element);
    let rough = scale(&parts, &parts, job.unit);
    job.scale = rough.max(least).max(job.smallest_scale());
    job.row = row;
    job.kind = Kind::Same;
    if job.carries_nothing(rough, [&parts; 2]) {
        return job.finish();
    }
    job.ball = job.ball_between(blockers).filter(|_| parts.iter().all(|p| constant(&parts[0], p).is_some()));
    if job.ball.is_some() {
        job.tasks.extend(parts.iter().map(|part| Task::Fan(part.clone(), parts.clone())));
        job.run();
        // The fans hold both orders of each pair.
        let mut block = job.finish();
        add_transpose(&mut block.values, element.basis.len());
        block.values.iter_mut().for_each(|value| *value *= 0.5);
        return block;
    }
    for (index, part) in parts.iter().enumerate() {
        job.tasks.push_back(Task::Same(part.clone(), job.state(part, part, blockers)));
        job.sectors(std::slice::from_ref(part), &parts[index + 1..], blockers);
    }
    job.run();
    let mut block = job.finish();
    add_transpose(&mut block.values, element.basis.len());
    // Both halves of the sum carry the error.
    block.error *= 2.0;
    block
}

/// H + Hᵀ of a square matrix.
fn add_transpose(values: &mut [f64], count: usize) {
    for k in 0..count {
        for l in 0..=k {
            let sum = values[k * count + l] + values[l * count + k];
            (values[k * count + l], values[l * count + k]) = (sum, sum);
        }
    }
}

/// A part of the block under way.
enum Task {
    /// Half of a patch with itself.
    Same(Patch, State),
    Pair(Patch, Patch, State),
    /// Parts of one side as seen from one part of the other, with nothing in between.
    Fan(Patch, Vec<Patch>),
}

#[derive(Clone)]
struct State {
    /// Whether the patches may touch.
    touching: bool,
    /// Halvings left for visibility.
    levels: u32,
    blockers: Vec<usize>,
}

struct Job<'a> {
    visibility: &'a Visibility,
    accuracy: Accuracy,
    elements: [&'a Element; 2],
    degrees: [usize; 2],
    size: f64,
    /// √(A_i A_j): ∫∫κ over it is the block's first entry.
    unit: f64,
    /// About the block's first entry.
    scale: f64,
    /// About the largest entry of its row.
    row: f64,
    /// Whether the outer parts of fans are the emitter's.
    swapped: bool,
    /// What stands between in fans, with its surface.
    ball: Option<(usize, Ball)>,
    moments: Moments<'a>,
    yardstick: Yardstick,
    tasks: VecDeque<Task>,
    kind: Kind,
    partly_hidden: bool,
    unresolved: bool,
    error: f64,
    /// Samples spent on horizons.
    horizons: u64,
}

impl<'a> Job<'a> {
    fn new(
        receiver: &'a Element,
        emitter: &'a Element,
        visibility: &'a Visibility,
        accuracy: Accuracy,
    ) -> Self {
        Self {
            visibility,
            accuracy,
            elements: [receiver, emitter],
            degrees: [receiver.basis.total_degree(), emitter.basis.total_degree()],
            size: receiver.bounds().diagonal().max(emitter.bounds().diagonal()),
            unit: (receiver.area * emitter.area).sqrt(),
            scale: 1.0,
            row: 1.0,
            swapped: false,
            ball: None,
            moments: Moments::new(&receiver.basis, &emitter.basis),
            yardstick: Yardstick::of([&receiver.basis, &emitter.basis]),
            tasks: VecDeque::new(),
            kind: Kind::Separated,
            partly_hidden: false,
            unresolved: false,
            error: 0.0,
            horizons: 0,
        }
    }

    fn surfaces(&self) -> [usize; 2] {
        self.elements.map(|element| element.surface)
    }

    /// The first entry of a block with these moments.
    fn first_entry(&self, moments: &Moments) -> f64 {
        self.yardstick.first_entry(moments.values())
    }

    fn smallest_scale(&self) -> f64 {
        let [a, b] = self.surfaces();
        if a == b { SMALLEST_OWN_SCALE } else { SMALLEST_ENTRY }
    }

    /// Whether the whole block is smaller than its error may be, as nearly flat surfaces are with themselves. Elements of
    /// very different sizes are not judged by a rough rule, which passes by corners that alone see each other.
    fn carries_nothing(&mut self, rough: f64, [receivers, emitters]: [&[Patch]; 2]) -> bool {
        let [a, b] = self.elements.map(|element| element.area);
        let may_err = self.accuracy.eps * self.scale;
        let nothing = a.max(b) < LARGEST_AREA_RATIO * a.min(b)
            && ROUGHNESS * rough < may_err
            && self.unit * largest_kernel(receivers, emitters) < may_err;
        if nothing {
            self.error += rough;
        }
        nothing
    }

    /// The only blocker, if it is a ball outside of which both elements lie.
    fn ball_between(&self, blockers: &[usize]) -> Option<(usize, Ball)> {
        let (center, radius) = self.visibility.only_ball(blockers)?;
        let outside = |patch: &Patch| {
            let corners = patch.corners();
            let inner = nodes(patch, 6);
            let points = corners.iter().copied().chain(inner.iter().map(|x| x.position));
            points.into_iter().all(|x| x.distance(center) >= radius * (1.0 - COINCIDENT))
        };
        let all = self.elements.iter().flat_map(|element| sectors(element)).all(|patch| outside(&patch));
        all.then_some((blockers[0], Ball { center, radius }))
    }

    /// The blocker of fans, if it may stand between these two patches.
    fn between(&self, p: &Patch, q: &Patch) -> Vec<usize> {
        let between = |surface: &usize| self.visibility.reaches(*surface, &p.hull(), &q.hull());
        self.ball.map(|(surface, _)| surface).filter(between).into_iter().collect()
    }

    fn run(&mut self) {
        while let Some(task) = self.tasks.pop_front() {
            if self.overdrawn() {
                self.tasks.push_front(task);
                return self.leave();
            }
            match task {
                Task::Same(patch, state) => self.same(&patch, state),
                Task::Pair(p, q, state) => self.pair(&p, &q, state),
                Task::Fan(outer, inner) => self.fan(&outer, inner),
            }
            // As κ ≥ 0, what was found so far bounds the first entry from below, but for its own error.
            self.scale = self.scale.max(FOUND_SHARE * self.first_entry(&self.moments));
        }
    }

    /// Sums all that is left by as few points as keep the whole affordable.
    fn leave(&mut self) {
        let mut left = Vec::new();
        for task in std::mem::take(&mut self.tasks) {
            match task {
                Task::Same(patch, state) => left.push((patch.clone(), patch, state.blockers, 0.5)),
                Task::Pair(p, q, state) => left.push((p, q, state.blockers, 1.0)),
                Task::Fan(outer, inner) => {
                    for part in inner {
                        let (p, q) = if self.swapped { (part, outer.clone()) } else { (outer.clone(), part) };
                        let blockers = self.between(&p, &q);
                        left.push((p, q, blockers, 1.0));
                    }
                }
            }
        }
        self.unresolved |= !left.is_empty();
        let each = LEFT_SAMPLES / left.len().max(1) as f64;
        let n = (each.sqrt().sqrt() as usize).clamp(FEWEST_LEFT, MOST_LEFT);
        for (p, q, blockers, factor) in left {
            let mut part = self.tentative(&p, &q, Some(&Touch::Apart(0.0)), n, &blockers);
            part.scale(factor);
            self.error += DOUBT * self.first_entry(&part);
            self.moments.merge(&part, true);
        }
    }

    fn finish(self) -> Block {
        Block {
            samples: self.moments.samples,
            distinct: self.moments.distinct,
            rays: self.moments.rays,
            values: self.moments.into_block(),
            kind: self.kind,
            partly_hidden: self.partly_hidden,
            unresolved: self.unresolved,
            error: self.error,
        }
    }

    /// Whether nothing is looked at closer any more: parts that were queued when the samples were spent take their own.
    fn overdrawn(&self) -> bool {
        self.moments.distinct > OVERDRAFT * (self.most(CONTACT_SAMPLES) + self.most_for_horizons())
    }

    /// Whether contacts may be refined no more.
    fn spent(&self) -> bool {
        self.moments.distinct - self.horizons > self.most(CONTACT_SAMPLES)
    }

    /// Whether horizons may be cut no more.
    fn horizons_spent(&self) -> bool {
        self.horizons > self.most_for_horizons()
    }

    /// Samples that horizons may take: beyond four digits their need grows faster still.
    fn most_for_horizons(&self) -> u64 {
        (self.beyond() * self.most(HORIZON_SAMPLES) as f64) as u64
    }

    /// Digits over four where more are asked, else 1.
    fn beyond(&self) -> f64 {
        (-0.25 * self.accuracy.eps.log10()).max(1.0)
    }

    /// Whether enough rays were cast for the accuracy of shadows: that of n rays is about 1/√n.
    fn shadows_spent(&self) -> bool {
        let enough = self.worth() * RAYS / self.accuracy.shadow_eps.powi(2);
        self.moments.rays as f64 > enough
    }

    /// What part of all samples a block gets that is small beside its row.
    fn worth(&self) -> f64 {
        (self.scale / (SMALL_IN_ROW * self.row)).clamp(LEAST_WORTH, 1.0)
    }

    /// Samples that go with a number for each squared digit; fewer where less than four digits are asked and for a block that
    /// is small beside its row, more beyond four digits.
    fn most(&self, per_digit: f64) -> u64 {
        let digits = -self.accuracy.eps.log10().min(-2.0);
        let squared = (digits * digits).min(digits.powi(4) / 16.0);
        (self.worth() * per_digit * squared * self.beyond().powi(2)) as u64
    }

    /// What two sectors start with: each counts as halved as often as makes its part of its element.
    fn state(&self, p: &Patch, q: &Patch, blockers: &[usize]) -> State {
        let halved = -(area(p) * area(q) / (self.unit * self.unit)).log2();
        let levels = self.accuracy.shadow_levels().saturating_sub(halved.max(0.0) as u32);
        State { touching: true, levels, blockers: blockers.to_vec() }
    }

    fn sectors(&mut self, receivers: &[Patch], emitters: &[Patch], blockers: &[usize]) {
        for p in receivers {
            for q in emitters {
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), self.state(p, q, blockers)));
            }
        }
    }

    fn product(&mut self, receivers: &[Patch], emitters: &[Patch], state: &State) {
        for p in receivers {
            for q in emitters {
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), state.clone()));
            }
        }
    }

    fn same(&mut self, patch: &Patch, mut state: State) {
        let share = area(patch) / self.unit;
        let facing = facing::own(patch);
        if facing == Facing::Away {
            return;
        }
        if share < NEGLIGIBLE * self.accuracy.eps * self.scale {
            self.error += share;
            return;
        }
        let mut doubtful = facing == Facing::Partly;
        if !state.blockers.is_empty() {
            let hull = patch.hull();
            state.blockers = self.visibility.narrow(&state.blockers, &hull, &hull);
            self.partly_hidden |= !state.blockers.is_empty();
            if !state.blockers.is_empty() && self.shadows_spent() {
                if !doubtful && collapsed(patch).is_empty() {
                    return self.roughly(patch, patch, None, &state);
                }
                state.levels = 0;
            }
            doubtful |= !state.blockers.is_empty() && state.levels > 0;
            state.levels = state.levels.saturating_sub(1);
        }
        if state.blockers.is_empty()
            && let Some(value) = constant(patch, patch)
        {
            return self.constant(patch, patch, 0.5 * value);
        }
        let [along, across] = patch.extents();
        let tips = collapsed(patch);
        let direction = match tips.first() {
            Some(side) => Some(if side % 2 == 0 { Direction::Across } else { Direction::Along }),
            _ if along.max(across) > LARGEST_ASPECT * along.min(across) || doubtful => Some(longest(patch).0),
            _ => None,
        };
        match direction {
            Some(direction) => {
                let ready = (doubtful || self.spent()) && tips.is_empty();
                if ready && self.attempt(patch, patch, None, &state) {
                    return;
                }
                let [a, b] = patch.halves(direction);
                self.product(std::slice::from_ref(&a), std::slice::from_ref(&b), &state);
                self.tasks.extend([Task::Same(a, state.clone()), Task::Same(b, state)]);
            }
            None => {
                let eps = self.eps(share);
                let points = same::counts(patch, self.degrees[0], contact_chart(patch, patch, eps), eps);
                let (visibility, blockers, own) = (self.visibility, state.blockers, self.surfaces());
                let free = |x, y| visibility.free_between(own, &blockers, x, y);
                let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
                same::integrate(&mut self.moments, patch, points, sees);
            }
        }
    }

    /// Separates those inner parts that are ready for a tensor rule, that touch the outer part, or that have to be
    /// halved, the outer part with them where it is the longer one; the rest is cut at its horizons as a whole.
    fn fan(&mut self, outer: &Patch, inner: Vec<Patch>) {
        let reach = longest(outer).1;
        let mut open: VecDeque<Patch> = inner.into();
        let (mut clipped, mut near, mut whole) = (Vec::new(), Vec::new(), Vec::new());
        while let Some(part) = open.pop_front() {
            let (p, q) = if self.swapped { (&part, outer) } else { (outer, &part) };
            let share = area(p).min(area(q)) / self.unit;
            let gap = gap(p, q);
            let tolerance = COINCIDENT * self.size;
            let touching = gap <= tolerance && !matches!(touch(p, q, tolerance), Touch::Apart(_));
            let facing = facing(p, q, touching, self.slight(share));
            if facing == Facing::Away {
                continue;
            }
            let blockers = self.between(p, q);
            self.partly_hidden |= !blockers.is_empty();
            if !blockers.is_empty() && constant(p, q).is_some() {
                // Nothing becomes singular, whether they touch or not.
                clipped.push((part, gap.max(SMALLEST_RATIO * reach)));
                continue;
            }
            if touching || share < NEGLIGIBLE * self.accuracy.eps * self.scale {
                let state = State { touching: true, levels: self.accuracy.shadow_levels(), blockers };
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), state));
                continue;
            }
            let close = gap < SMALLEST_RATIO * reach.max(longest(&part).1);
            if close || facing != Facing::Wholly {
                let state = State { touching: false, levels: 0, blockers: blockers.clone() };
                let spent = if close { self.spent() } else { self.horizons_spent() };
                if (spent || share <= SMALL_PART * self.scale)
                    && self.attempt(p, q, Some(&Touch::Apart(gap)), &state)
                {
                    continue;
                }
            }
            if close {
                self.kind = self.kind.max(Kind::Split);
                if reach > longest(&part).1 {
                    near.push(part);
                } else {
                    open.extend(part.halves(longest(&part).0));
                }
            } else if facing == Facing::Wholly && blockers.is_empty() {
                whole.push((part, gap));
            } else {
                clipped.push((part, gap));
            }
        }
        if near.is_empty() && clipped.is_empty() {
            return whole.iter().for_each(|(part, gap)| self.apart(outer, part, *gap));
        }
        // Beside horizons those seen wholly go the same way: the sum of all is smoother than any of them.
        clipped.extend(whole);
        if near.is_empty() {
            return self.horizon(outer, &clipped);
        }
        near.extend(clipped.into_iter().map(|(part, _)| part));
        let halves = outer.halves(longest(outer).0);
        self.tasks.extend(halves.map(|half| Task::Fan(half, near.clone())));
    }

    /// An inner part that the outer one sees wholly, by a tensor rule.
    fn apart(&mut self, outer: &Patch, inner: &Patch, gap: f64) {
        let (p, q) = if self.swapped { (inner, outer) } else { (outer, inner) };
        let points = self.points(p, q, gap);
        self.moments.tensor(p, q, points, None);
    }

    fn pair(&mut self, p: &Patch, q: &Patch, mut state: State) {
        let share = area(p).min(area(q)) / self.unit;
        if share < NEGLIGIBLE * self.accuracy.eps * self.scale {
            self.error += share;
            return;
        }
        if !state.blockers.is_empty() {
            let (hull_p, hull_q) = (p.hull(), q.hull());
            state.blockers = self.visibility.narrow(&state.blockers, &hull_p, &hull_q);
            if self.visibility.hidden(&state.blockers, &hull_p, &hull_q) {
                return;
            }
        }
        let tolerance = COINCIDENT * self.size;
        let contact = if state.touching { touch(p, q, tolerance) } else { Touch::Apart(gap(p, q)) };
        let gap = if let Touch::Apart(gap) = contact { gap } else { 0.0 };
        state.touching = gap <= 0.0;
        let facing = facing(p, q, !matches!(contact, Touch::Apart(_)), self.slight(share));
        if facing == Facing::Away {
            return;
        }
        if !state.blockers.is_empty() {
            let spent = self.shadows_spent();
            if state.levels > 0 && !spent {
                state.levels -= 1;
                return self.halve(p, q, &contact, &state);
            }
            self.partly_hidden = true;
            let is_apart = gap >= SMALLEST_RATIO * longest(p).1.max(longest(q).1);
            if spent && (is_apart || share <= SMALL_PART * self.scale) {
                return self.roughly(p, q, Some(&contact), &state);
            }
        } else if let Some(value) = constant(p, q) {
            return self.constant(p, q, value);
        }
        let small = gap > 0.0 && share <= SMALL_PART * self.scale;
        let near = gap < SMALLEST_RATIO * longest(p).1.max(longest(q).1);
        if small && (near || facing == Facing::Partly) && self.attempt(p, q, Some(&contact), &state) {
            return;
        }
        match facing {
            Facing::Partly if state.blockers.is_empty() => self.clipped(p, q, &contact, gap, &state),
            _ => self.smooth(p, q, &contact, gap, &state),
        }
    }

    /// A pair through which a horizon may run.
    fn clipped(&mut self, p: &Patch, q: &Patch, contact: &Touch, gap: f64, state: &State) {
        let longest = longest(p).1.max(longest(q).1);
        if gap >= SMALLEST_RATIO * longest {
            if self.horizons_spent() && self.attempt(p, q, Some(contact), state) {
                return;
            }
            let (outer, inner) = if self.swapped { (q, p) } else { (p, q) };
            return self.horizon(outer, &[(inner.clone(), gap)]);
        }
        self.kind = self.kind.max(if gap > 0.0 { Kind::Split } else { Kind::Contact });
        if !self.attempt(p, q, Some(contact), state) {
            self.halve(p, q, contact, state);
        }
    }

    /// A pair that sees each other wholly, or whose horizons are left to rays.
    fn smooth(&mut self, p: &Patch, q: &Patch, contact: &Touch, gap: f64, state: &State) {
        let (visibility, blockers, own) = (self.visibility, state.blockers.clone(), self.surfaces());
        let free = |x, y| visibility.free_between(own, &blockers, x, y);
        let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
        match contact {
            Touch::Edge { p: a, q: b, matched } => {
                self.kind = self.kind.max(Kind::Edge);
                let wedge = Wedge::of(a, b);
                if wedge.aspect() > LARGEST_ASPECT && !self.spent() {
                    return self.halve(p, q, contact, state);
                }
                let points = self.edge_points(a, b, *matched, &wedge);
                self.unresolved |= points[2] > MOST_POINTS;
                let rule = if *matched { edge::integrate } else { seam::integrate };
                rule(&mut self.moments, a, b, points.map(|n| n.min(MOST_POINTS)), sees);
            }
            Touch::Vertex(a, b) => {
                self.kind = self.kind.max(Kind::Vertex);
                if vertex::aspect(a, b) > LARGEST_ASPECT && !self.spent() {
                    return self.halve(p, q, contact, state);
                }
                let points = self.corner_points(a, b);
                self.unresolved |= points[1] > MOST_CORNER_POINTS;
                vertex::integrate(&mut self.moments, a, b, points.map(|n| n.min(MOST_CORNER_POINTS)), sees);
            }
            Touch::Apart(_) if gap >= SMALLEST_RATIO * longest(p).1.max(longest(q).1) => {
                let points = self.points(p, q, gap);
                self.moments.tensor(p, q, points, sees);
            }
            _ => {
                self.kind = self.kind.max(if gap > 0.0 { Kind::Split } else { Kind::Contact });
                let by_halving = gap > 0.0 || matches!(contact, Touch::Cut(_) | Touch::Tip(_));
                if by_halving && !self.spent() || !self.attempt(p, q, Some(contact), state) {
                    self.halve(p, q, contact, state);
                }
            }
        }
    }

    /// Points of the tensor rule of a pair apart.
    fn points(&self, p: &Patch, q: &Patch, gap: f64) -> [usize; 4] {
        let eps = self.part_eps(p, q);
        let counts = separated::counts(p, q, self.degrees, gap, eps);
        let charts = [fineness::points(p, eps), fineness::points(q, eps)].concat();
        [0, 1, 2, 3].map(|k| (counts[k] + charts[k]).min(MOST_POINTS))
    }

    /// Points [x, y, angular] of the rule of a common edge.
    fn edge_points(&self, p: &Patch, q: &Patch, matched: bool, wedge: &Wedge) -> [usize; 3] {
        let (eps, exact) = (self.part_eps(p, q), self.exact_degree());
        if eps > trial::COARSEST {
            let [_, _, angular] = edge::counts(p, q, wedge, self.degrees, eps);
            let radial = exact + contact_chart(p, q, eps);
            return [radial, radial, angular + 1];
        }
        let [radial, along, angular] = if matched {
            trial::edge(p, &|u, v| q.node(u, v), eps)
        } else {
            let seam = seam::Seam::new(p, q);
            trial::edge(p, &|u, v| seam.node(u, v), eps)
        };
        [exact + radial - 1, exact + along - 1, angular + self.largest_degree().div_ceil(2)]
    }

    /// Points [x, angular] of the rule of a common corner.
    fn corner_points(&self, p: &Patch, q: &Patch) -> [usize; 2] {
        let (eps, exact, degree) = (self.part_eps(p, q), self.exact_degree(), self.largest_degree());
        if eps > trial::COARSEST {
            let [_, angular] = vertex::counts(p, q, self.degrees, eps);
            let angular = angular.max(separated::points(degree, eps, corner_rate(p, q))) + 1;
            return [exact + contact_chart(p, q, eps), angular];
        }
        let [radial, angular] = trial::vertex(p, q, MOST_CORNER_POINTS, eps);
        [exact + radial - 1, angular + degree.div_ceil(2)]
    }

    fn largest_degree(&self) -> usize {
        self.degrees[0].max(self.degrees[1])
    }

    /// Points that integrate the polynomials of both sides and the area elements of affine charts exactly.
    fn exact_degree(&self) -> usize {
        separated::exact(self.degrees)
    }

    /// Accuracy for a part that carries at most `share` of what a block can: small parts need fewer digits.
    fn eps(&self, share: f64) -> f64 {
        (self.accuracy.eps * (0.25 * self.scale / share).max(1.0)).min(1e-2)
    }

    /// What of the most that a part of so large a `share` can carry may be wrong: blocks that carry little by grazing light allow
    /// less than their accuracy.
    fn slight(&self, share: f64) -> f64 {
        self.accuracy.eps * (self.scale / share).min(1.0)
    }

    fn part_eps(&self, p: &Patch, q: &Patch) -> f64 {
        self.eps(area(p).min(area(q)) / self.unit)
    }

    /// A pair of patches on which the kernel has one value: the product of their own moments.
    fn constant(&mut self, p: &Patch, q: &Patch, value: f64) {
        let side = |patch: &Patch, element: &Element| {
            let basis = &element.basis;
            let (mut sums, mut row) = (vec![0.0; basis.len()], vec![0.0; basis.len()]);
            let [along, across] =
                fineness::points(patch, self.accuracy.eps).map(|n| UnitRule::of(basis.order() / 2 + n + 2));
            for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                basis.raw(basis.frame().coordinates(&node), &mut row);
                sums.iter_mut().zip(&row).for_each(|(sum, l)| *sum += ws * wt * node.area * l);
            }
            (sums, (along.nodes.len() * across.nodes.len()) as u64)
        };
        let ((left, m), (right, n)) = (side(p, self.elements[0]), side(q, self.elements[1]));
        let moments: Vec<f64> = left.iter().flat_map(|l| right.iter().map(move |r| value * l * r)).collect();
        self.moments.add_raw(&moments, false, m + n);
    }

    /// Parts apart from an outer part, cut at their horizons. Together: where a horizon passes from one into the
    /// next, their sum stays smooth.
    fn horizon(&mut self, outer: &Patch, inner: &[(Patch, f64)]) {
        let mut points = [1; 2];
        let mut sides = Vec::new();
        let [first, second] = if self.swapped { [1, 0] } else { [0, 1] };
        for (part, gap) in inner {
            let (p, q) = if self.swapped { (part, outer) } else { (outer, part) };
            let counts = self.points(p, q, *gap);
            for (most, count) in points.iter_mut().zip(&counts[2 * first..]) {
                *most = *count.max(most);
            }
            let eps = self.part_eps(p, q);
            sides.push((part.clone(), quartered_points(part, self.degrees[second], *gap, eps)));
        }
        if sides.is_empty() {
            return;
        }
        let ball = self.ball.map(|(_, ball)| ball);
        let outer = Side { patch: outer, basis: &self.elements[first].basis, points, ball };
        let may_err = self.accuracy.eps * self.scale;
        let turned = self.swapped.then(|| self.yardstick.turned());
        let yardstick = turned.as_ref().unwrap_or(&self.yardstick);
        let budget = self.most_for_horizons().saturating_sub(self.horizons);
        let basis = &self.elements[second].basis;
        let cut = horizon::integrate(&outer, basis, &sides, yardstick, HORIZON_SHARE * may_err, budget);
        self.horizons += cut.samples;
        self.moments.add_raw(&cut.moments, self.swapped, cut.samples);
        self.error += cut.error;
        self.unresolved |= cut.error > may_err;
    }

    /// Tries a part that no rule covers to the accuracy asked, for a horizon through a contact or a contact of another
    /// kind, by the rule that fits best with two numbers of points; their difference is the error. `contact` is None
    /// for a patch with itself. Whether it was good enough, or has to be since the samples are spent.
    fn attempt(&mut self, p: &Patch, q: &Patch, contact: Option<&Touch>, state: &State) -> bool {
        let share = area(p).min(area(q)) / self.unit;
        if !self.spent() && self.carried(p, q, share) > LARGEST_ATTEMPT * self.scale {
            return false;
        }
        let coarsest = self.spent() && !state.blockers.is_empty();
        let n = self.bends(share) + if coarsest { POINTS_WHEN_SPENT } else { FEWEST_POINTS };
        let [coarse, fine] = [n, n + 2].map(|n| self.tentative(p, q, contact, n, &state.blockers));
        let error = self.yardstick.difference(fine.values(), coarse.values());
        let may_err = ATTEMPT_SHARE / self.beyond().powi(MORE_ATTEMPTS) * self.accuracy.eps * self.scale;
        let enough = error <= may_err;
        let kept = enough || self.spent();
        self.moments.merge(&coarse, false);
        self.moments.merge(&fine, kept);
        if kept {
            // Two rules may miss one horizon alike: what was not good enough is doubted by a part of all it carries.
            let doubt = if enough { 0.0 } else { DOUBT * self.first_entry(&fine) };
            let reach = SMALLEST_RATIO * longest(p).1.max(longest(q).1);
            let is_near = matches!(contact, Some(Touch::Apart(gap)) if *gap < reach);
            self.error += doubt.max(if is_near { PEAKED * error } else { error });
            self.unresolved |= !enough;
        }
        kept
    }

    /// What a part of so large a `share` carries at the most.
    fn carried(&self, p: &Patch, q: &Patch, share: f64) -> f64 {
        let rough = scale(std::slice::from_ref(p), std::slice::from_ref(q), self.unit);
        share.min(ROUGHNESS * rough)
    }

    /// A part whose shadows are sampled although the rays are spent.
    fn roughly(&mut self, p: &Patch, q: &Patch, contact: Option<&Touch>, state: &State) {
        let n = POINTS_WHEN_SPENT + self.bends(area(p).min(area(q)) / self.unit);
        let part = self.tentative(p, q, contact, n, &state.blockers);
        self.moments.merge(&part, true);
    }

    /// Points that the polynomials take: on a small part they are nearly those of a lower degree.
    fn bends(&self, share: f64) -> usize {
        (0.5 * self.largest_degree() as f64 * share.sqrt().min(1.0)).ceil() as usize
    }

    fn tentative(
        &self,
        p: &Patch,
        q: &Patch,
        contact: Option<&Touch>,
        n: usize,
        blockers: &[usize],
    ) -> Moments<'a> {
        let mut moments = Moments::new(&self.elements[0].basis, &self.elements[1].basis);
        let own = self.surfaces();
        let free = |x, y| self.visibility.free_between(own, blockers, x, y);
        let sees: Option<Sees> = if blockers.is_empty() { None } else { Some(&free) };
        let plain = [n, n, n + 1, n + 1];
        match contact {
            None => {
                // Half of a patch with itself.
                moments.tensor(p, p, plain, sees);
                moments.scale(0.5);
            }
            Some(Touch::Edge { p, q, matched: true }) if Wedge::of(p, q).cosine > SMOOTH => {
                edge::integrate(&mut moments, p, q, [n; 3], sees);
            }
            Some(Touch::Vertex(p, q)) => vertex::integrate(&mut moments, p, q, [n; 2], sees),
            Some(_) => moments.tensor(p, q, plain, sees),
        }
        moments
    }

    /// Brings a contact nearer to a rule, or halves a pair where it is longest; both sides together along a common
    /// edge.
    fn halve(&mut self, p: &Patch, q: &Patch, contact: &Touch, state: &State) {
        let whole = |patch: &Patch| vec![patch.clone()];
        match contact {
            Touch::Edge { p: a, q: b, matched: true } => {
                let wedge = Wedge::of(a, b);
                if wedge.length >= 0.999 * wedge.depths[0].max(wedge.depths[1]) {
                    return self.product(&a.halves(Direction::Along), &b.halves(Direction::Along), state);
                }
            }
            Touch::Cut([at_p, at_q]) => {
                let parts_p = at_p.map_or_else(|| whole(p), |place| cut(p, place).to_vec());
                let parts_q = at_q.map_or_else(|| whole(q), |place| cut(q, place).to_vec());
                return self.product(&parts_p, &parts_q, state);
            }
            Touch::Tip([at_p, at_q]) => {
                let parts_p = at_p.map_or_else(|| whole(p), |direction| p.halves(direction).to_vec());
                let parts_q = at_q.map_or_else(|| whole(q), |direction| q.halves(direction).to_vec());
                return self.product(&parts_p, &parts_q, state);
            }
            _ => {}
        }
        let ((direction_p, extent_p), (direction_q, extent_q)) = (longest(p), longest(q));
        if extent_p >= extent_q {
            self.product(&p.halves(direction_p), std::slice::from_ref(q), state);
        } else {
            self.product(std::slice::from_ref(p), &q.halves(direction_q), state);
        }
    }
}

/// Points that the charts of two touching patches take: half as many again as of patches apart, since the kernel
/// between them varies with the charts alone.
fn contact_chart(p: &Patch, q: &Patch, eps: f64) -> usize {
    let most = [fineness::points(p, eps), fineness::points(q, eps)].concat().into_iter().max().unwrap_or(0);
    most + most.div_ceil(2)
}

/// Points of the tensor rule on an inner patch and on its quarters, by how often it is quartered: their extents halve,
/// and their charts take about a quarter less points each time.
fn quartered_points(patch: &Patch, degree: usize, gap: f64, eps: f64) -> Arc<[[usize; 2]]> {
    let charts = fineness::points(patch, eps);
    let extents = patch.extents();
    let count = |axis: usize, depth: usize| {
        let ratio = gap / extents[axis] * f64::from(1 << depth);
        let rho = 2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt();
        let chart = (charts[axis] as f64 * 0.75f64.powi(depth as i32)).ceil() as usize;
        (separated::points(degree, eps, rho) + chart).min(MOST_POINTS)
    };
    // A horizon that grazes a quarter's lines clips ever less of ever smaller quarters.
    let deepest = (1 + (-0.5 * eps.log10()).ceil() as usize).min(horizon::DEEPEST);
    (0..=deepest).map(|depth| [0, 1].map(|axis| count(axis, depth))).collect()
}

/// ϱ of the angular variables at a common corner where the patches lean over each other: that of a common edge of
/// the least angle φ between them, 1 + 2 sin(φ/2) = ½ (ϱ + 1/ϱ).
fn corner_rate(p: &Patch, q: &Patch) -> f64 {
    const STEPS: usize = 8;
    let directions = |patch: &Patch| -> Vec<DVec3> {
        let corner = patch.node(0.0, 0.0).position;
        let [along, across] = [(1e-3, 0.0), (0.0, 1e-3)].map(|(s, t)| patch.node(s, t).position - corner);
        let at = |k: usize| {
            let (sin, cos) = (std::f64::consts::FRAC_PI_2 * k as f64 / STEPS as f64).sin_cos();
            cos * along + sin * across
        };
        (0..=STEPS).map(at).collect()
    };
    let (a, b) = (directions(p), directions(q));
    let angles = a.iter().flat_map(|d| b.iter().map(move |e| d.angle_between(*e)));
    let sigma = 1.0 + 2.0 * (0.5 * angles.fold(std::f64::consts::PI, f64::min)).sin().max(0.01);
    sigma + (sigma * sigma - 1.0).sqrt()
}

/// The kernel's value if it is the same for all pairs of points: both on the inside of one sphere.
fn constant(p: &Patch, q: &Patch) -> Option<f64> {
    if p.is_flat() || q.is_flat() {
        return None;
    }
    let (a, b) = (nodes(p, 3), nodes(q, 4));
    let values = a.iter().flat_map(|x| b.iter().map(move |y| kernel(x, y)));
    let [low, high] = values.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], k| [low.min(k), high.max(k)]);
    (low > 0.0 && high - low <= 1e-10 * high).then_some(0.5 * (low + high))
}

fn planar(patch: &Patch) -> bool {
    patch.is_flat() || nodes(patch, 3).windows(2).all(|w| w[0].normal.distance(w[1].normal) <= 1e-12)
}

/// About the area of a patch.
fn area(patch: &Patch) -> f64 {
    let nodes = nodes(patch, 2);
    nodes.iter().map(|x| x.area).sum::<f64>() / nodes.len() as f64
}

fn longest(patch: &Patch) -> (Direction, f64) {
    let [along, across] = patch.extents();
    if along >= across { (Direction::Along, along) } else { (Direction::Across, across) }
}
