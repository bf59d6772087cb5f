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
use radiosity_kernel::rules::horizon::{InnerPatch, Side};
use radiosity_work::interruption::check_interrupt;

use crate::pair::curved::constant::constant;
use crate::pair::curved::points::quartered;
use crate::pair::job::{Job, State, Task};

/// Share of the block's error for the horizons of one outer part: three spend all of it. With a larger value
/// blocks of many outer parts may miss their accuracy, with a smaller one each takes more samples.
const HORIZON_SHARE: f64 = 0.3;

/// Largest share, relative to the block's scale, of parts that are attempted before they are halved or cut at
/// horizons: a rule that errs by half of such a part errs by a hundredth of the block. With a larger value
/// more attempts fail.
pub(super) const SMALL_PART: f64 = 0.02;
/// A part of the inner element of a fan.
pub(super) struct InnerPart {
    pub part: Patch,
    /// Its distance from the outer part (scene length); where the kernel is constant, at least a quarter of
    /// the extent of that.
    pub gap: f64,
}

impl Job<'_> {
    /// Sorts the inner parts of a fan. Touching and negligible parts become pairs; parts all wholly visible
    /// and apart take tensor rules; near ones are halved, or the outer part is, if it is longer. The rest is
    /// cut at its horizons together.
    pub(in crate::pair) fn fan(&mut self, outer: &Patch, inner: Vec<Patch>) {
        let reach = outer.longest().1;
        let mut open: VecDeque<Patch> = inner.into();
        let (mut clipped, mut near, mut whole) = (Vec::new(), Vec::new(), Vec::new());
        while let Some(part) = open.pop_front() {
            check_interrupt();
            self.budget.looks += 1;
            if self.budget.overdrawn(&self.moments) {
                let seen = clipped.into_iter().chain(whole).map(|seen: InnerPart| seen.part);
                let rest = near.into_iter().chain(seen).chain(open).chain([part]).collect();
                return self.tasks.push_front(Task::Fan(outer.clone(), rest));
            }
            let (p, q) = (outer, &part);
            let share = self.budget.share(p, q);
            let gap = gap(p, q);
            let touching = gap <= self.tolerance && Contact::of(p, q, self.tolerance).touches();
            let facing = facing(p, q, touching, self.budget.slight(share));
            if facing == Facing::Away {
                continue;
            }
            let blockers = self.between(p, q);
            self.partly_hidden |= !blockers.is_empty();
            if !blockers.is_empty() && constant(p, q).is_some() {
                // The kernel is constant: no contact makes it singular.
                clipped.push(InnerPart { part, gap: gap.max(SMALLEST_RATIO * reach) });
                continue;
            }
            if touching || self.budget.neglects(share) {
                let state = State { touching: true, levels: self.budget.accuracy.shadow_levels(), blockers };
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), state));
                continue;
            }
            let close = gap < SMALLEST_RATIO * reach.max(part.longest().1);
            if close || facing != Facing::Wholly {
                let state = State { touching: false, levels: 0, blockers: blockers.clone() };
                let spent = if close { self.spent() } else { self.budget.horizons_spent() };
                if (spent || share <= SMALL_PART * self.budget.scale)
                    && self.attempt(p, q, Some(&Contact::Apart(gap)), &state)
                {
                    continue;
                }
            }
            if close {
                self.kind = self.kind.max(PairKind::Split);
                if reach > part.longest().1 {
                    near.push(part);
                } else {
                    open.extend(part.halves(part.longest().0));
                }
            } else if facing == Facing::Wholly && blockers.is_empty() {
                whole.push(InnerPart { part, gap });
            } else {
                clipped.push(InnerPart { part, gap });
            }
        }
        if near.is_empty() && clipped.is_empty() {
            return whole.iter().for_each(|seen| self.apart(outer, seen));
        }
        self.cut_or_halve(outer, near, clipped, whole);
    }

    /// Cuts the inner parts of a fan at their horizons together; where some are near, halves the outer part
    /// instead.
    fn cut_or_halve(
        &mut self,
        outer: &Patch,
        mut near: Vec<Patch>,
        mut clipped: Vec<InnerPart>,
        whole: Vec<InnerPart>,
    ) {
        // Beside parts cut by horizons, wholly visible ones are treated the same way: the sum of all is
        // smoother than any of them.
        clipped.extend(whole);
        if near.is_empty() {
            return self.horizon(outer, &clipped);
        }
        near.extend(clipped.into_iter().map(|clipped| clipped.part));
        let halves = outer.halves(outer.longest().0);
        self.tasks.extend(halves.map(|half| Task::Fan(half, near.clone())));
    }

    /// The ball of fans, if it may stand between these two patches.
    pub(super) fn between(&self, p: &Patch, q: &Patch) -> Vec<usize> {
        let between = |surface: &usize| self.visibility.reaches(*surface, &p.hull(), &q.hull());
        self.ball.map(|ball| ball.surface).filter(between).into_iter().collect()
    }

    /// An inner part that the outer part sees wholly, by a tensor rule.
    fn apart(&mut self, outer: &Patch, inner: &InnerPart) {
        let InnerPart { part, gap } = inner;
        let points = self.points(outer, part).apart(outer, part, *gap);
        self.moments.tensor(outer, part, points, None);
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
        let outer = Side { patch: outer, basis: &self.elements[0].basis, points, ball };
        let may_err = self.budget.may_err();
        let budget = self.budget.left_for_horizons();
        let basis = &self.elements[1].basis;
        let cut = horizon::integrate(&outer, basis, &sides, &self.norm, HORIZON_SHARE * may_err, budget);
        self.budget.horizons += cut.samples;
        self.moments.add_raw(&cut.moments, cut.samples);
        self.error += cut.error;
        self.unresolved |= cut.error > may_err;
    }
}
