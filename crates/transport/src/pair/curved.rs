//! Blocks of elements of which at least one is curved, and of a curved element with itself.
//!
//! Definition.
//!
//! ```text
//! G_kl = Σ_{p, q} ∫_p ∫_q φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_y dA_x        over parts p of i and q of j .
//! ```
//!
//! The receiver is the outer element, as ordered by `schedule::order`. Elements are cut into sectors, which
//! turn by a quarter circle at most ([`radiosity_kernel::contact::sectors`]), and flat parts are clipped by
//! the plane of the other element, if it has one. Then, part by part, breadth first, with g the gap and H the
//! longest extent of either part:
//!
//! * parts that face away from each other are dropped ([`radiosity_kernel::contact::orientation`]);
//! * a part with itself: convex → nothing, concave → [`radiosity_kernel::rules::identical`], else its halves
//!   with themselves and with each other;
//! * a constant kernel (two parts of the inside of one sphere) → κ ∫ φ_k dA ∫ φ_l dA, exact;
//! * all of an element on a sphere at once, where its sectors are apart by a tenth of their extents, and by
//!   H/4 of the other part → [`radiosity_kernel::rules::horizon`];
//! * apart, g ≥ H/4 → tensor rules until two agree (`apart`), or [`radiosity_kernel::rules::horizon`] where a
//!   horizon may cut the pair;
//! * near or touching, without a common edge or corner, where a closed form tells what each point of one
//!   element sees of the other → that over all parts at once ([`closed_form`]);
//! * touching → cut or halved until a rule covers the contact ([`radiosity_kernel::contact::patches`]), then
//!   [`radiosity_kernel::rules::common_edge`], [`radiosity_kernel::rules::common_edge::unequal_speed`] or
//!   [`radiosity_kernel::rules::common_vertex`];
//! * near, 0 < g < H/4, or a contact without a rule, or touching and cut by a horizon → halved;
//! * with blockers → sampled: large parts apart as for flat pairs ([`crate::occlusion::sampled`]), others by
//!   the rules of their contacts after a few halvings; a single ball, outside which both elements lie, is
//!   left to [`radiosity_kernel::rules::horizon`].
//!
//! Of an element with itself half of all pairs of parts are summed, H, and the block is H + Hᵀ; where a ball
//! stands between them all ordered pairs, and the block is ½ (H + Hᵀ).
//!
//! Formula. As ∫ κ dA ≤ 1 on either side, a pair of parts carries at most s of the first entry,
//!
//! ```text
//! s = min(A_p, A_q) / √(A_i A_j) ,     S = max( coarse G_00 , least , ½ G_00 of the parts summed so far ) ,
//! ```
//!
//! and errors are measured against S, with `least` that of the caller, or of the smallest entry that counts,
//! if that is larger. Pairs of s < 1e-3 ε S are left out, and so is the whole block where three times the
//! coarse G_00 and the largest κ times √(A_i A_j) are below ε S and neither area is 100 times the other one
//! or more. The rules of a pair get the accuracy min(1e-2, ε max(1, S/(4 s))). Pairs of s ≤ S/50 that are
//! near or cut by a horizon, and touching ones that no rule covers, are first attempted if they carry at most
//! S/4: by the rule that suits them best, with n and n + 2 points, n = 4 + ⌈½ N min(1, √s)⌉ for the larger
//! degree N. They are kept if both sums differ by at most 0.03 β⁻⁶ ε S, with β as below.
//!
//! Range of use. Any pair of elements. Contacts and horizons are refined until they took
//!
//! ```text
//! 5·10⁵ w D β²   and   10⁶ w D β³   samples ,
//! D = min(d², d⁴/16) ,     d = max(2, −log₁₀ ε) ,     β = max(1, −¼ log₁₀ ε) ,
//! ```
//!
//! with w = S/(¼ of the largest entry of the row), from ¼ to 1. Attempts are kept after that. When all
//! samples, and 1000 for each look at two parts of a fan, exceed twice the sum of both, what is left is
//! summed by 1 to 4 points per direction. Blocks whose error stays too large are carried by rays
//! (`unreached`).
//!
//! Error. `BlockReport::error` adds up, in entries of the block: s of pairs left out, or the coarse G_00 of a
//! block left out; the differences of attempts, twice those of near parts, and at least 0.1 of what an
//! attempt carries that missed its accuracy; three times what trials of contact rules missed;
//! [`Cut::error`](radiosity_kernel::rules::horizon::Cut::error) of horizons, allowed ε S together, and 0.3 ε
//! S each; the error of sampled visibility; 0.1 of what is summed roughly in the end; of tensor rules on
//! parts apart the difference of two, as far as it is left (`apart`). Other rules whose numbers of points
//! follow from the accuracy add nothing; `BlockReport::told` is what all others carry. The block is
//! `unresolved` where an attempt or a trial missed its accuracy, a horizon errs by more than ε S, or anything
//! was left.
//!
//! References: S. A. Sauter, C. Schwab, *Boundary Element Methods*, Springer 2011, chapter 5 (contacts); L.
//! N. Trefethen, *Approximation Theory and Approximation Practice*, SIAM 2013, chapter 19 (numbers of
//! points).

mod plane_clip;
mod points;
mod attempt;
mod apart;
mod closed_form;
mod constant;
mod fan;
mod same_element;
mod pair;

use std::f64::consts::FRAC_1_SQRT_2;

use radiosity_elements::Element;
use radiosity_elements::patch::{Patch, plane_of};
use radiosity_kernel::PairKind;
use radiosity_kernel::blocks::block::{Block, add_transpose, take_symmetric_part};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::contact::sectors::sectors;
use radiosity_kernel::estimates::coarse::{largest_kernel, scale};
use radiosity_kernel::estimates::entry_bounds::SMALLEST_ENTRY;
use radiosity_kernel::rules::horizon::{Ball, Front};
use radiosity_kernel::rules::zone::Zone;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;

use crate::occlusion::outside_ball::lies_outside;
use crate::pair::job::{BallBlocker, InnerZone, Job, State, Task};
use crate::pair::size::area;
use crate::pair::tolerance::Tolerance;
use crate::tolerances::ABOVE_ESTIMATE;
use attempt::DOUBT;
use constant::constant;

/// Ratio of areas below which a coarse estimate is trusted to find a block negligible: on an element that is
/// much larger few of its nodes are near the other one.
const LARGEST_AREA_RATIO: f64 = 100.0;
/// Smallest scale of the block of a surface with itself: what it sends to others is larger, and errors of
/// less show nowhere.
const SMALLEST_OWN_SCALE: f64 = 5e-3;

/// Samples, about, for all parts left when the samples are spent: 2 ms at 10 ns each.
const LEFT_SAMPLES: f64 = 2e5;
/// Fewest points per direction for each part that is left: one tells its size at least.
const FEWEST_LEFT: usize = 1;
/// Most points per direction for each part that is left, however few there are.
const MOST_LEFT: usize = 4;

/// The block between two elements. `blockers` are the surfaces that may stand between them, their own
/// included.
pub(crate) fn block(
    receiver: &Element,
    emitter: &Element,
    blockers: &[usize],
    visibility: &Visibility,
    tolerance: Tolerance,
) -> Block {
    let mut job = Job::new([receiver, emitter], visibility, tolerance);
    let parts = [sectors(receiver), sectors(emitter)];
    let planes = [plane_of(&parts[0]), plane_of(&parts[1])];
    let [receivers, emitters] = plane_clip::clipped(parts, planes, job.tolerance);
    if let [Some(first), Some(second)] = planes {
        job.fronts = Some([Front::of(second), Front::of(first)]);
    }
    let rough = scale(&receivers, &emitters, job.budget.unit);
    job.budget.scale = rough.max(tolerance.least).max(job.smallest_scale());
    job.budget.row = tolerance.row;
    if job.carries_nothing(rough, [&receivers, &emitters]) {
        return job.finish();
    }
    job.ball = job.ball_between(blockers);
    let emitters = match blockers.is_empty() {
        true => job.by_closed_form([&receivers, &emitters], tolerance.least.max(job.smallest_scale())),
        false => emitters,
    };
    if blockers.is_empty() {
        let zone = Zone::of(emitter, tolerance.accuracy.eps);
        job.inner = zone.map(|zone| InnerZone { zone, sectors: emitters.clone() });
    }
    if blockers.is_empty() || job.ball.is_some() {
        job.tasks.extend(receivers.into_iter().map(|part| Task::Fan(part, emitters.clone())));
    } else {
        job.sectors(&receivers, &emitters, blockers);
    }
    job.run();
    job.finish()
}

/// The block of a curved element with itself. `blockers` are the surfaces within its hull.
pub(crate) fn self_block(
    element: &Element,
    blockers: &[usize],
    visibility: &Visibility,
    tolerance: Tolerance,
) -> Block {
    let mut job = Job::new([element, element], visibility, tolerance);
    let parts = sectors(element);
    let rough = scale(&parts, &parts, job.budget.unit);
    job.budget.scale = rough.max(tolerance.least).max(job.smallest_scale());
    job.budget.row = tolerance.row;
    job.kind = PairKind::Same;
    if job.carries_nothing(rough, [&parts; 2]) {
        return job.finish();
    }
    job.ball = job.ball_between(blockers).filter(|_| parts.iter().all(|p| constant(&parts[0], p).is_some()));
    if job.ball.is_some() {
        job.tasks.extend(parts.iter().map(|part| Task::Fan(part.clone(), parts.clone())));
        job.run();
        // The fans hold both orders of each pair: half the sum of block and transpose.
        let mut block = job.finish();
        take_symmetric_part(&mut block.values, element.basis.len());
        return block;
    }
    // Half of all pairs are summed and then mirrored: entries on the diagonal double, the deviation grows by
    // √2.
    job.budget.shadow_error *= FRAC_1_SQRT_2;
    for (index, part) in parts.iter().enumerate() {
        job.tasks.push_back(Task::Same(part.clone(), job.state(part, part, blockers)));
        job.sectors(std::slice::from_ref(part), &parts[index + 1..], blockers);
    }
    job.run();
    let mut block = job.finish();
    add_transpose(&mut block.values, element.basis.len());
    // The error stands in both halves.
    block.report.error *= 2.0;
    block.report.told *= 2.0;
    block
}

impl Job<'_> {
    fn smallest_scale(&self) -> f64 {
        let [a, b] = self.elements.map(|element| element.surface);
        if a == b { SMALLEST_OWN_SCALE } else { SMALLEST_ENTRY }
    }

    /// Whether the whole block is below its allowed error, as of a nearly flat surface with itself. Elements
    /// of very different sizes are excluded, where a coarse estimate may miss corners that alone see each
    /// other.
    fn carries_nothing(&mut self, rough: f64, [receivers, emitters]: [&[Patch]; 2]) -> bool {
        let [a, b] = self.elements.map(|element| element.area);
        let may_err = self.budget.may_err();
        let nothing = rough > 0.0
            && a.max(b) < LARGEST_AREA_RATIO * a.min(b)
            && ABOVE_ESTIMATE * rough < may_err
            && self.budget.unit * largest_kernel(receivers, emitters) < may_err;
        if nothing {
            self.error += rough;
        }
        nothing
    }

    /// The only blocker, if it is a ball and both elements lie outside it.
    fn ball_between(&self, blockers: &[usize]) -> Option<BallBlocker> {
        let (center, radius) = self.visibility.only_ball(blockers)?;
        let are_outside = self.elements.iter().all(|element| lies_outside(element, center, radius));
        are_outside.then_some(BallBlocker { surface: blockers[0], ball: Ball { center, radius } })
    }

    /// The state of a pair of sectors: being a sector counts as the halvings that would make a part of the
    /// same size.
    fn state(&self, p: &Patch, q: &Patch, blockers: &[usize]) -> State {
        let halved = -(area(p) * area(q) / (self.budget.unit * self.budget.unit)).log2();
        let levels = self.budget.accuracy.shadow_levels().saturating_sub(halved.max(0.0) as u32);
        State { touching: true, levels, blockers: blockers.to_vec() }
    }

    fn sectors(&mut self, receivers: &[Patch], emitters: &[Patch], blockers: &[usize]) {
        for p in receivers {
            for q in emitters {
                self.tasks.push_back(Task::Pair(p.clone(), q.clone(), self.state(p, q, blockers)));
            }
        }
    }

    /// Sums all parts that are left, by as few points as the block can still afford.
    pub(in crate::pair) fn leave(&mut self) {
        let mut left = Vec::new();
        for task in std::mem::take(&mut self.tasks) {
            match task {
                Task::Same(patch, state) => left.push((patch.clone(), patch, state.blockers, 0.5)),
                Task::Pair(p, q, state) => left.push((p, q, state.blockers, 1.0)),
                Task::Fan(outer, inner) => {
                    for part in inner {
                        let blockers = self.between(&outer, &part);
                        left.push((outer.clone(), part, blockers, 1.0));
                    }
                }
            }
        }
        self.unresolved |= !left.is_empty();
        let each = LEFT_SAMPLES / left.len().max(1) as f64;
        let n = (each.sqrt().sqrt() as usize).clamp(FEWEST_LEFT, MOST_LEFT);
        for (p, q, blockers, factor) in left {
            check_interrupt();
            let mut part = self.tentative(&p, &q, Some(&Contact::Apart(0.0)), n, &blockers);
            part.scale(factor);
            self.error += DOUBT * self.first_entry(&part);
            self.moments.merge(&part, true);
        }
    }
}
