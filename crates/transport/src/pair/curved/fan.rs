//! Fans: all parts of one element as seen from one part of the other, with nothing or one ball in between.
//!
//! They are integrated together, because their sum is smooth where a horizon passes from one part to the
//! next.

use std::collections::VecDeque;

use radiosity_elements::patch::Patch;
use radiosity_kernel::PairKind;
use radiosity_kernel::contact::gap::gap;
use radiosity_kernel::contact::orientation::{Facing, facing};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::horizon;
use radiosity_kernel::rules::horizon::{Cut, Inner, InnerPatch, Side};
use radiosity_work::interruption::check_interrupt;

use crate::pair::curved::constant::constant;
use crate::pair::curved::points::quartered;
use crate::pair::job::{InnerZone, Job, State, Task};
use crate::pair::size::area;

/// Largest share of the block's error for the horizons of one outer part, which is else its share of the
/// area: with a larger value blocks of many outer parts may miss their accuracy, with a smaller one each
/// takes more samples.
const HORIZON_SHARE: f64 = 0.3;

/// Largest share, relative to the block's scale, of parts that are attempted before they are halved or cut at
/// horizons: a rule that errs by half of such a part errs by a hundredth of the block. With a larger value
/// more attempts fail.
pub(super) const SMALL_PART: f64 = 0.02;
/// Least gap of the sectors of an element on a sphere, over their extent, for the rule over all that is seen of
/// it: it takes more points instead of halves, about twice as many per direction there as at
/// [`SMALLEST_RATIO`].
const LEAST_GAP_OF_SECTORS: f64 = 0.1;

/// An element on a sphere before an outer part that sees some of it partly.
enum ZoneBefore {
    /// It is apart.
    Apart,
    /// Its sectors are apart over their extents, but near over that of the outer part.
    NearLongPart,
}

/// A part of the inner element of a fan.
pub(super) struct InnerPart {
    pub part: Patch,
    /// Its distance from the outer part (scene length); where the kernel is constant, at least a quarter of
    /// the extent of that.
    pub gap: f64,
}

/// The parts of the inner element of a fan, while they are sorted.
#[derive(Default)]
struct InnerParts {
    open: VecDeque<Patch>,
    /// Parts that are near a longer outer part.
    near: Vec<Patch>,
    /// Parts that a horizon or a ball may cut.
    clipped: Vec<InnerPart>,
    /// Parts that the outer part sees wholly.
    whole: Vec<InnerPart>,
}

impl Job<'_> {
    /// Sorts the inner parts of a fan. Parts all wholly visible and apart take tensor rules; where some are
    /// near, the outer part is halved; the rest is cut at its horizons together. Beside parts cut by horizons,
    /// wholly visible ones are treated alike: the sum of all is smoother than any of them.
    pub(in crate::pair) fn fan(&mut self, outer: &Patch, inner: Vec<Patch>) {
        match self.zone_before(outer, &inner) {
            Some(ZoneBefore::Apart) => return self.horizon_of_zone(outer, &inner),
            Some(ZoneBefore::NearLongPart) => {
                let halves = outer.halves(outer.longest().0);
                return self.tasks.extend(halves.map(|half| Task::Fan(half, inner.clone())));
            }
            None => {}
        }
        let mut parts = InnerParts { open: inner.into(), ..InnerParts::default() };
        while let Some(part) = parts.open.pop_front() {
            check_interrupt();
            self.budget.looks += 1;
            if self.budget.overdrawn(&self.moments) {
                let InnerParts { open, mut near, clipped, whole } = parts;
                near.extend(clipped.into_iter().chain(whole).map(|seen| seen.part));
                near.extend(open.into_iter().chain([part]));
                return self.tasks.push_front(Task::Fan(outer.clone(), near));
            }
            self.sort(outer, part, &mut parts);
        }
        let InnerParts { mut near, mut clipped, whole, .. } = parts;
        if near.is_empty() && clipped.is_empty() {
            return whole.iter().for_each(|seen| self.apart(outer, &seen.part, seen.gap));
        }
        clipped.extend(whole);
        if near.is_empty() {
            return self.horizon(outer, &clipped);
        }
        near.extend(clipped.into_iter().map(|clipped| clipped.part));
        let halves = outer.halves(outer.longest().0);
        self.tasks.extend(halves.map(|half| Task::Fan(half, near.clone())));
    }

    /// Position of the inner element before an outer part, if it lies on a sphere and those of its sectors that
    /// the part may see are apart from it; None where the part sees all of them wholly, or where `inner` does
    /// not hold all that it may see.
    fn zone_before(&mut self, outer: &Patch, inner: &[Patch]) -> Option<ZoneBefore> {
        let InnerZone { sectors, zone } = self.inner.as_ref()?;
        self.budget.looks += sectors.len() as u64;
        let distance = zone.distance(outer);
        let (mut is_cut, mut least) = (false, f64::INFINITY);
        for part in sectors {
            check_interrupt();
            let facing = facing(outer, part, false, self.budget.slight(self.budget.share(outer, part)));
            if facing == Facing::Away {
                continue;
            }
            let gap = gap(outer, part).max(distance);
            if gap < LEAST_GAP_OF_SECTORS * part.longest().1 || !inner.contains(part) {
                return None;
            }
            is_cut |= facing == Facing::Partly;
            least = least.min(gap);
        }
        let is_apart = least >= SMALLEST_RATIO * outer.longest().1;
        is_cut.then_some(if is_apart { ZoneBefore::Apart } else { ZoneBefore::NearLongPart })
    }

    /// An outer part with all that it sees of an inner element on a sphere.
    fn horizon_of_zone(&mut self, outer: &Patch, inner: &[Patch]) {
        let Some(InnerZone { zone, .. }) = &self.inner else { return };
        let distance = zone.distance(outer);
        let mut points = [1; 4];
        for part in inner {
            let gap = gap(outer, part).max(distance);
            let counts = self.points(outer, part).apart(outer, part, gap);
            points = std::array::from_fn(|k| points[k].max(counts[k]));
        }
        let [s, t, along, across] = points;
        let may_err = self.horizons_may_err(outer);
        let outer = Side { patch: outer, basis: &self.elements[0].basis, points: [s, t], ball: None };
        let inner = Inner::Zone(zone, [along, across]);
        let budget = self.budget.left_for_horizons();
        let cut = horizon::integrate(&outer, &self.elements[1].basis, &inner, &self.norm, may_err, budget);
        self.take(cut);
    }

    /// Error allowed of the horizons of an outer part.
    fn horizons_may_err(&self, outer: &Patch) -> f64 {
        let share = area(outer) / self.elements[0].area;
        share.min(HORIZON_SHARE) * self.budget.may_err()
    }

    /// Adds moments that were cut at horizons.
    pub(super) fn take(&mut self, cut: Cut) {
        self.budget.horizons += cut.samples;
        self.moments.add_raw(&cut.moments, cut.samples);
        self.error += cut.error;
        self.unresolved |= cut.error > self.budget.may_err();
    }

    /// Sorts an inner part. Touching and negligible parts become pairs; near ones are halved, unless the outer
    /// part is longer; small ones are attempted.
    fn sort(&mut self, outer: &Patch, part: Patch, parts: &mut InnerParts) {
        let (reach, extent) = (outer.longest().1, part.longest().1);
        let share = self.budget.share(outer, &part);
        let gap = gap(outer, &part);
        let touching = gap <= self.tolerance && Contact::of(outer, &part, self.tolerance).touches();
        let facing = facing(outer, &part, touching, self.budget.slight(share));
        if facing == Facing::Away {
            return;
        }
        let blockers = self.between(outer, &part);
        self.partly_hidden |= !blockers.is_empty();
        if !blockers.is_empty() && constant(outer, &part).is_some() {
            // The kernel is constant: no contact makes it singular.
            return parts.clipped.push(InnerPart { part, gap: gap.max(SMALLEST_RATIO * reach) });
        }
        if touching || self.budget.neglects(share) {
            let state = State { touching: true, levels: self.budget.accuracy.shadow_levels(), blockers };
            return self.tasks.push_back(Task::Pair(outer.clone(), part, state));
        }
        let is_free = facing == Facing::Wholly && blockers.is_empty();
        let close = gap < SMALLEST_RATIO * reach.max(extent);
        if close || facing != Facing::Wholly {
            let state = State { touching: false, levels: 0, blockers };
            let spent = if close { self.spent() } else { self.budget.horizons_spent() };
            if (spent || share <= SMALL_PART * self.budget.scale)
                && self.attempt(outer, &part, Some(&Contact::Apart(gap)), &state)
            {
                return;
            }
        }
        if close {
            self.kind = self.kind.max(PairKind::Split);
        }
        match close {
            true if reach > extent => parts.near.push(part),
            true => parts.open.extend(part.halves(part.longest().0)),
            false if is_free => parts.whole.push(InnerPart { part, gap }),
            false => parts.clipped.push(InnerPart { part, gap }),
        }
    }

    /// The ball of fans, if it may stand between these two patches.
    pub(super) fn between(&self, p: &Patch, q: &Patch) -> Vec<usize> {
        let between = |surface: &usize| self.visibility.reaches(*surface, &p.hull(), &q.hull());
        self.ball.map(|ball| ball.surface).filter(between).into_iter().collect()
    }

    /// Inner parts apart from an outer part, cut at their horizons together: where a horizon passes from one
    /// to the next, their sum stays smooth.
    pub(super) fn horizon(&mut self, outer: &Patch, inner: &[InnerPart]) {
        let mut points = [1; 2];
        let mut sides = Vec::new();
        for InnerPart { part, gap } in inner {
            let counts = self.points(outer, part).apart(outer, part, *gap);
            for (most, count) in points.iter_mut().zip(&counts) {
                *most = *count.max(most);
            }
            let eps = self.budget.part_eps(outer, part);
            let most = &counts[2..];
            let pieces = match &self.fronts {
                Some([_, front]) if front.cuts(part) => front.parts(part, [most[0], most[1]], eps),
                _ => vec![part.clone()],
            };
            sides.extend(pieces.into_iter().map(|patch| {
                let points = quartered(&patch, self.degrees[1], *gap, eps);
                InnerPatch { patch, points }
            }));
        }
        if sides.is_empty() {
            return;
        }
        let ball = self.ball.map(|between| between.ball);
        let may_err = self.horizons_may_err(outer);
        let outer = Side { patch: outer, basis: &self.elements[0].basis, points, ball };
        let budget = self.budget.left_for_horizons();
        let basis = &self.elements[1].basis;
        let inner = Inner::Patches(&sides);
        let cut = horizon::integrate(&outer, basis, &inner, &self.norm, may_err, budget);
        self.take(cut);
    }
}
