//! Patches apart of which parts lie behind each other's tangent planes (horizons): iterated integration over
//! what each point sees.
//!
//! Definition. With the raw polynomials L_k of the outer patch p and L_l of the inner patches q, the moments
//! are
//!
//! ```text
//! M_kl = ∫_p L_k(x) W_l(x) dA_x ,     W_l(x) = Σ_q ∫_{q(x)} κ(x, y) L_l(y) dA_y ,
//! q(x) = { y ∈ q : h₁ > 0, h₂ > 0, h₃ > 0 } ,     h₁ = n_x·(y − x) ,     h₂ = n_y·(x − y) ,
//! ```
//!
//! with κ = h₁ h₂ / (π |y − x|⁴) and h₃ the height over the cone of a ball (`view`), 1 without a ball.
//! Clipped where h₁ or h₂ changes sign, κ has a kink of first order, max(0, s), at which a tensor rule of n
//! points per direction errs like n⁻². Hence W is integrated over exactly q(x) (`part`, `line`), and the
//! kinks of W are found by comparing rules on p.
//!
//! Of an inner element on a sphere, over a rectangle of longitude and latitude, q(x) is known without a
//! search (`zone_part`). Of flat inner patches W is known in closed form, however near they are
//! (`flat_part`): there the outer patch may touch them.
//!
//! κ vanishes linearly at a horizon. Where a horizon starts to leave q, what it cuts off is ∫₀ˢ t dt: W has a
//! kink of about second order, max(0, s)², at which n points err like n⁻³. If all q lie in one plane they
//! share one horizon, which leaves all of them at once: W ∝ max(0, h₂(x)) has a kink of first order, and
//! rules on p run only over the part before that plane (`front`).
//!
//! Formula. First, while a corner of p sees nothing, p is halved along and across in turn, 16 times at the
//! most, and halves that face no q are dropped, until both halves in both directions face some.
//!
//! Second, unless a corner still sees nothing, three rules on p are tried, of
//!
//! ```text
//! n_m = min( max( ⌈r_m n⌉ , 3 + 2m ) , 64 ) ,     r = 0.35, 0.55, 1 ,     m = 0, 1, 2
//! ```
//!
//! points in a direction in which the unclipped kernel needs n. The first one is taken that differs from the
//! one before by ½ of the tolerance at the most; its error is 0.3 of the difference, about ϱ/(1 − ϱ) with the
//! ratio ϱ = (3/5)³ of n⁻³.
//!
//! Third, if no rule was taken, p is a cell, and cells are halved, the worst first (`cell`, `queue`), until
//! the errors of all open cells sum to ¾ of the tolerance at the most, or the evaluations exceed the budget,
//! or the cells fill 8 · 10⁶ numbers. A cell is settled earlier whose error is at most ¼ of the tolerance
//! times its share of the parameters of p. Where W is a closed form, the error of a cell contains what its
//! rules may miss between their outermost points and its sides (`margin`); elsewhere 0.02 of what the second
//! points beyond the start of W carry. Of a single outer function the sums times either coordinate
//! have to agree too (`carried`).
//!
//! Range of use. The patches p and q are apart: the caller halves pairs of gap/extent < ¼
//! ([`SMALLEST_RATIO`](crate::rules::far::SMALLEST_RATIO)), except where κ is constant or W a closed form,
//! and gives the numbers of points. Nothing stands between them but one ball, outside which all patches lie.
//!
//! Error. [`Cut::error`] is that of the rule taken second, or the sum over all cells, in the norm max |T_ka|
//! |T_lb| |δM_ab| of the block's entries (`estimates::entry_norm`). It is no bound. The rules for W count as
//! exact: their points are numbered for the accuracy asked of the pair, and roots known to 1e-9 err by 1e-18
//! at a horizon, where κ vanishes, and by 1e-9 at the cone of the ball, where it does not.
//!
//! References: S. Xiang, F. Bornemann, *SIAM J. Numer. Anal.* 50 (2012) 2581–2587 (Gauss rules at kinks: n⁻²
//! and n⁻³); M. Dowell, P. Jarratt, *BIT* 11 (1971) 168–174 (roots).

mod carried;
mod cell;
mod queue;
mod view;
mod line;
mod front;
mod margin;
mod part;
mod zone_part;
mod flat_part;
mod swept_part;

use std::sync::Arc;

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::{Node, Patch, plane_of};
use radiosity_elements::rule::MOST_POINTS;
use radiosity_geom::Plane;
use radiosity_work::interruption::check_interrupt;

use crate::contact::orientation::{Facing, facing};
use crate::estimates::entry_norm::EntryNorm;
use crate::irradiance::swept::Swept;
use crate::rules::zone::Zone;
use crate::tolerances::{ERROR_OF_FINER_RULE, MOST_TRIMS, SHARE_OF_CLIMB};
use carried::Carried;
use cell::{Cell, DIRECTIONS, Whole};
use flat_part::FlatPart;
pub use front::Front;
use front::Nodes;
use part::Part;
use queue::Queue;
use swept_part::SweptPart;
pub use view::Ball;
use view::View;
use zone_part::ZonePart;

/// Points of the rules tried on an outer patch, relative to those that the unclipped kernel needs. The last
/// one is as good as the kernel allows; two coarser ones before it end sooner where little is asked. More of
/// them would be computed in vain where none is taken.
const RUNGS: [f64; 3] = [0.35, 0.55, 1.0];
/// Fewest points of these rules: W, clipped, may need many points where the kernel needs few.
const FEWEST: usize = 3;
/// Fewest points of halves of cells where W is a closed form: it is smooth on cells that shrink
/// geometrically toward a contact, and more points there gain more digits than more cells.
const FEWEST_OF_CLOSED: usize = 7;
/// Points that each of these rules has more than the one before at the least: no rule is compared with
/// itself.
const STEP: usize = 2;

/// Share of the tolerance for settled cells, to each its share of the patch; three quarters are left for the
/// cells that are worst. With a larger value these are halved more often; with a smaller one small cells that
/// do not matter stay open.
const SETTLED: f64 = 0.25;
/// Most numbers stored for open cells (64 MB), and about how many sets of moments each cell holds.
const MOST_NUMBERS: usize = 8_000_000;
const WHOLES: usize = 4;

/// Error of a patch of which only corners see anything, relative to what it would carry if all points saw as
/// much: a part of a twentieth of the patch about a corner. An arbitrary choice: with a smaller value light
/// that no rule sees is missed; with a larger one cells are halved about corners that see next to nothing.
const CORNER: f64 = 0.05;
/// Error of a Gauss rule where W begins like the square of the distance, wherever between two of its points that
/// is, over what the second of the points beyond carries. Measured on powers from 1.5 to 2.5: with a larger value
/// cells are halved too often, without it a quarter of the differences of rules are small by chance.
const MISSED_AT_HORIZON: f64 = 0.02;
/// Points along each direction of the outer patch from which it is told whether it lies before a flat or a swept part.
const LOOKS: usize = 3;
const CORNERS: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

/// The result for a pair of patches.
#[derive(Debug)]
pub struct Cut {
    /// Moments in the raw polynomials, row-major, outer functions by inner functions.
    pub moments: Vec<f64>,
    /// Estimate of the largest error of the block's entries.
    pub error: f64,
    /// Evaluations of the kernel and of heights.
    pub samples: u64,
}

/// An outer patch.
pub struct Side<'a> {
    /// The patch.
    pub patch: &'a Patch,
    /// The polynomials of its element.
    pub basis: &'a AreaBasis,
    /// Points along and across.
    pub points: [usize; 2],
    /// A ball between it and the inner patches, if any; all patches lie outside it.
    pub ball: Option<Ball>,
}

/// An inner patch.
pub struct InnerPatch {
    /// The patch.
    pub patch: Patch,
    /// Points along and across by depth: of itself, of its quarters, and so on as deep as points are given.
    pub points: Arc<[[usize; 2]]>,
}

/// The inner element, or parts of it.
pub enum Inner<'a> {
    /// Patches.
    Patches(&'a [InnerPatch]),
    /// All of an element on a sphere, with the points of a sector along and across.
    Zone(&'a Zone<'a>, [usize; 2]),
    /// Flat patches in one plane, however near, with the error allowed of the irradiance.
    Flat(&'a [Patch], f64),
    /// A part of a surface of revolution that carries a constant, however near, with its plane if it lies in
    /// one.
    Swept(&'a Swept, Option<Plane>),
    /// A whole ball that carries a constant, however near.
    Ball(&'a Zone<'a>),
}

impl Inner<'_> {
    /// Whether the irradiance is known in closed form, however near the inner element is.
    fn is_closed(&self) -> bool {
        matches!(self, Self::Flat(..) | Self::Swept(..) | Self::Ball(_))
    }
}

/// A part of the inner element under integration.
enum InnerPart<'a> {
    Patch(Box<Part<'a>>),
    Zone(ZonePart<'a>),
    Flat(Box<FlatPart<'a>>),
    Swept(SweptPart<'a>),
}

impl InnerPart<'_> {
    /// Whether a part of the outer patch may face it.
    fn may_face(&self, outer: &Patch) -> bool {
        match self {
            Self::Patch(part) => facing(outer, part.patch(), false, 0.0) != Facing::Away,
            Self::Zone(part) => part.may_be_faced_by(outer),
            Self::Flat(part) => part.may_be_faced_by(outer),
            Self::Swept(_) => true,
        }
    }

    fn may_be_seen_from(&self, x: &View) -> bool {
        match self {
            Self::Patch(part) => part.may_be_seen_from(x),
            Self::Zone(part) => part.is_seen_from(&x.node),
            Self::Flat(part) => part.may_be_seen_from(&x.node),
            Self::Swept(part) => part.is_seen_from(&x.node),
        }
    }

    /// Adds W_l(x) to `out`; returns the number of evaluations.
    fn seen_from(&mut self, x: &View, out: &mut [f64]) -> u64 {
        match self {
            Self::Patch(part) => part.seen_from(x, out),
            Self::Zone(part) => part.seen_from(&x.node, out),
            Self::Flat(part) => part.seen_from(&x.node, out),
            Self::Swept(part) => part.seen_from(&x.node, out),
        }
    }
}

/// The moments of an outer patch with inner ones apart from it, to `tolerance` in the block's entries, with
/// about `budget` evaluations.
pub fn integrate(
    outer: &Side,
    basis: &AreaBasis,
    inner: &Inner,
    norm: &EntryNorm,
    tolerance: f64,
    budget: u64,
) -> Cut {
    let part = |InnerPatch { patch, points }: &InnerPatch| {
        InnerPart::Patch(Box::new(Part::new(patch.clone(), basis, Arc::clone(points), 0)))
    };
    let (parts, front): (Vec<InnerPart>, Option<Front>) = match inner {
        Inner::Patches(patches) => {
            let all: Vec<Patch> = patches.iter().map(|inner| inner.patch.clone()).collect();
            (patches.iter().map(part).collect(), plane_of(&all).map(Front::of))
        }
        Inner::Zone(zone, points) => (vec![InnerPart::Zone(ZonePart::new(zone, basis, *points))], None),
        // The sum over a whole ball is a closed form, without points.
        Inner::Ball(zone) => (vec![InnerPart::Zone(ZonePart::new(zone, basis, [1; 2]))], None),
        Inner::Flat(patches, eps) => {
            let part = |patch: &Patch| {
                let part = FlatPart::new(patch, basis, *eps);
                InnerPart::Flat(Box::new(part.before(&outer.patch.cell_nodes(LOOKS))))
            };
            let front = plane_of(patches).map(Front::of).filter(|front| front.hides_points_of(outer.patch));
            (patches.iter().map(part).collect(), front)
        }
        Inner::Swept(swept, plane) => {
            let front = plane.map(Front::of).filter(|front| front.hides_points_of(outer.patch));
            let part = SweptPart::new(swept, basis.constant(), &outer.patch.cell_nodes(LOOKS));
            (vec![InnerPart::Swept(part)], front)
        }
    };
    let is_closed = inner.is_closed();
    let mut job = Job {
        outer,
        is_closed,
        fewest: if is_closed { outer.points.map(|n| n.min(FEWEST_OF_CLOSED)) } else { [FEWEST; 2] },
        front,
        columns: basis.len(),
        left: vec![0.0; outer.basis.len()],
        inner: parts,
        norm,
        tolerance,
        budget,
        cut: Cut { moments: vec![0.0; outer.basis.len() * basis.len()], error: 0.0, samples: 0 },
    };
    if let Some(patch) = job.seeing() {
        // Where a corner sees nothing W ends within the patch, and two rules may miss the same; so they may
        // what is smooth but for kinks along lines, unless both directions are asked.
        let (whole, agrees) = match is_closed || job.has_dark_corner(&patch) {
            true => (job.whole(patch, rungs(outer.points)[1]), false),
            false => job.climb(patch),
        };
        if agrees {
            job.cut.moments = whole.carried.moments;
        } else {
            job.refine(whole);
        }
    }
    job.cut
}

struct Job<'a> {
    outer: &'a Side<'a>,
    /// Whether W is a closed form.
    is_closed: bool,
    /// Fewest points of the halves of cells along and across.
    fewest: [usize; 2],
    /// The plane of the inner patches, if they lie in one.
    front: Option<Front>,
    columns: usize,
    /// Values of the outer polynomials at a point.
    left: Vec<f64>,
    inner: Vec<InnerPart<'a>>,
    norm: &'a EntryNorm,
    tolerance: f64,
    budget: u64,
    cut: Cut,
}

/// Sums over the points of a rule.
struct Sums {
    carried: Carried,
    /// W_l(x) at each point in turn.
    seen: Vec<f64>,
}

impl Job<'_> {
    /// The outer patch without halves that see nothing: if only a corner sees something, few points would
    /// miss it. None if all is dark.
    fn seeing(&self) -> Option<Patch> {
        let mut patch = self.outer.patch.clone();
        let inner = |half: &Patch| self.inner.iter().any(|part| part.may_face(half));
        let (mut kept, mut trims) = (0, 0);
        while kept < DIRECTIONS.len() && trims < MOST_TRIMS && self.has_dark_corner(&patch) {
            let [first, second] = patch.halves(DIRECTIONS[trims % DIRECTIONS.len()]);
            trims += 1;
            match [inner(&first), inner(&second)] {
                [true, true] => kept += 1,
                [false, false] => return None,
                [sees, _] => (patch, kept) = (if sees { first } else { second }, 0),
            }
        }
        Some(patch)
    }

    fn has_dark_corner(&self, patch: &Patch) -> bool {
        let corners = CORNERS.map(|(s, t)| patch.node(s, t));
        // What lies behind the plane gets no points of a rule.
        let mut views = corners
            .into_iter()
            .filter(|x| self.front.as_ref().is_none_or(|front| front.height(x) > 0.0))
            .map(|node| View { node, ball: None });
        views.any(|x| !self.inner.iter().any(|part| part.may_be_seen_from(&x)))
    }

    /// Tries rules of few points on the outer patch, as W is often much smoother than the kernel. Returns the
    /// moments by the first rule that agrees with the one before, and true; else those by the last, which has
    /// the full number of points.
    fn climb(&mut self, patch: Patch) -> (Whole, bool) {
        let [first, others @ ..] = rungs(self.outer.points);
        let mut whole = self.whole(patch, first);
        for points in others {
            let finer = self.whole(whole.patch.clone(), points);
            let difference =
                finer.carried.difference(&whole.carried, &finer.patch, self.outer.basis, self.norm);
            whole = finer;
            if difference <= SHARE_OF_CLIMB * self.tolerance {
                self.cut.error += ERROR_OF_FINER_RULE * difference;
                return (whole, true);
            }
        }
        (whole, false)
    }

    /// Adds a part of the outer patch that needs more than one rule.
    fn refine(&mut self, whole: Whole) {
        let most_cells = MOST_NUMBERS / (WHOLES * whole.carried.numbers());
        let mut cell = Cell::new(whole);
        (0..DIRECTIONS.len()).for_each(|direction| self.look(&mut cell, direction));
        let mut queue = Queue::default();
        queue.push(cell);
        loop {
            self.halve(&mut queue, most_cells);
            let is_spent = self.cut.samples > self.budget || queue.len() >= most_cells;
            if is_spent || !self.look_again(&mut queue) || self.is_enough(&queue) {
                break;
            }
        }
        queue.into_cells().for_each(|cell| self.add(cell));
    }

    /// Halves the worst cells until the sum of errors, partly inherited from larger cells, is small enough.
    fn halve(&mut self, queue: &mut Queue, most_cells: usize) {
        while !self.is_enough(queue) && self.cut.samples <= self.budget && queue.len() < most_cells {
            let Some(mut cell) = queue.pop() else { break };
            if let Some(other) = cell.told_by_much_larger() {
                self.look(&mut cell, other);
            }
            let (direction, is_known) = cell.worse();
            for mut cell in if is_known { cell.cut(direction) } else { vec![cell] } {
                self.look(&mut cell, direction);
                if self.is_settled(&cell)
                    && let Some(other) = cell.told_by_larger()
                {
                    self.look(&mut cell, other);
                }
                if self.is_settled(&cell) {
                    self.add(cell);
                } else {
                    queue.push(cell);
                }
            }
        }
    }

    /// Computes the errors that cells inherited from larger ones; whether there were any.
    fn look_again(&mut self, queue: &mut Queue) -> bool {
        let mut any = false;
        for mut cell in std::mem::take(queue).into_cells() {
            if let Some(direction) = cell.told_by_larger() {
                self.look(&mut cell, direction);
                any = true;
            }
            queue.push(cell);
        }
        any
    }

    fn is_enough(&self, queue: &Queue) -> bool {
        queue.error() <= (1.0 - SETTLED) * self.tolerance
    }

    fn is_settled(&self, cell: &Cell) -> bool {
        cell.error() <= SETTLED * cell.share() * self.tolerance
    }

    fn add(&mut self, cell: Cell) {
        self.cut.error += cell.error();
        self.cut.moments.iter_mut().zip(cell.moments()).for_each(|(m, s)| *m += s);
    }

    /// Computes the halves of a cell in one direction.
    fn look(&mut self, cell: &mut Cell, direction: usize) {
        let halves =
            cell.halves(direction, self.fewest[direction]).map(|(patch, points)| self.whole(patch, points));
        cell.look(direction, halves, self.outer.basis, self.norm);
        if cell.is_dark() {
            let missed = self.at_corners(cell.patch());
            cell.miss(CORNER * missed);
        }
    }

    /// The largest entry of a patch if all its points saw as much as its best corner.
    fn at_corners(&mut self, patch: &Patch) -> f64 {
        let zeros = vec![0.0; self.outer.basis.len() * self.columns];
        let corner = |(s, t)| {
            let node: Node = patch.node(s, t);
            let sums = self.sums([WeightedNode { node, weight: node.area }]);
            self.norm.difference(&sums.carried.moments, &zeros)
        };
        CORNERS.map(corner).into_iter().fold(0.0, f64::max)
    }

    fn whole(&mut self, patch: Patch, points: [usize; 2]) -> Whole {
        let Nodes { nodes, is_tensor, .. } = self.nodes(&patch, points);
        let sums = self.sums(nodes.iter().copied());
        let missed = match (is_tensor, self.is_closed) {
            (true, true) => self.in_margins(&patch, points, &nodes, &sums.seen),
            (true, false) => self.beside_horizons(points, &nodes, &sums.seen),
            (false, _) => [0.0; 2],
        };
        let is_dark = sums.seen.iter().all(|w| *w == 0.0);
        Whole { patch, points, carried: sums.carried, is_dark, missed }
    }

    /// Estimates of what a tensor rule misses where W begins along either direction: [`MISSED_AT_HORIZON`] of what the
    /// second points carry that see something.
    fn beside_horizons(
        &mut self,
        [along, across]: [usize; 2],
        nodes: &[WeightedNode],
        seen: &[f64],
    ) -> [f64; 2] {
        let columns = self.columns;
        let zeros = vec![0.0; self.outer.basis.len() * columns];
        let w = |node: usize| &seen[node * columns..(node + 1) * columns];
        let is_lit = |node: usize| w(node).iter().any(|w| *w != 0.0);
        let lines = [(across, 1, along, across), (along, across, across, 1)];
        lines.map(|(lines, next_line, points, next)| {
            let mut carried = Carried::nothing(self.outer.basis.len(), columns);
            for (line, k) in (0..lines).flat_map(|line| (1..points).map(move |k| (line * next_line, k))) {
                let [first, second] = [k - 1, k].map(|k| is_lit(line + k * next));
                let beyond = match [first, second] {
                    [false, true] => (k + 1).min(points - 1),
                    [true, false] => k.saturating_sub(2),
                    _ => continue,
                };
                let node = line + beyond * next;
                self.add_product(&nodes[node], w(node), &mut carried);
            }
            MISSED_AT_HORIZON * self.norm.difference(&carried.moments, &zeros)
        })
    }

    /// Estimates of what a tensor rule misses in the margins, by the direction across them (`margin`).
    fn in_margins(
        &mut self,
        patch: &Patch,
        points: [usize; 2],
        nodes: &[WeightedNode],
        seen: &[f64],
    ) -> [f64; 2] {
        let margin::Margins { places, corners } = margin::margins(points, nodes);
        let mut largest = seen.iter().step_by(self.columns).fold(0.0f64, |most, w| most.max(w.abs()));
        let sides: Vec<Vec<f64>> =
            places.iter().map(|place| self.off(patch, points, seen, place.at, &mut largest)).collect();
        let mut at_corners = Vec::new();
        for corner in &corners {
            let mut off = self.off(patch, points, seen, corner.at, &mut largest);
            for k in corner.beside {
                off.iter_mut().zip(&sides[k]).for_each(|(off, beside)| *off -= beside);
            }
            at_corners.push(off);
        }
        let mut missed = [0.0; 2];
        for (place, off) in places.iter().zip(&sides) {
            let node = patch.node(place.at[0], place.at[1]);
            missed[place.direction] += self.carried(WeightedNode { node, weight: place.area }, off, largest);
        }
        for (corner, off) in corners.iter().zip(&at_corners) {
            let node = patch.node(corner.at[0], corner.at[1]);
            let both = self.carried(WeightedNode { node, weight: corner.area }, off, largest);
            missed.iter_mut().for_each(|missed| *missed += 0.5 * both);
        }
        missed
    }

    /// Difference of W at a place from the polynomials through its values at the points of a tensor rule.
    fn off(
        &mut self,
        patch: &Patch,
        points: [usize; 2],
        seen: &[f64],
        at: [f64; 2],
        largest: &mut f64,
    ) -> Vec<f64> {
        let mut off = vec![0.0; self.columns];
        self.add_seen(patch.node(at[0], at[1]), &mut off);
        *largest = largest.max(off[0].abs());
        let through = margin::interpolated(points, seen, self.columns, at);
        off.iter_mut().zip(&through).for_each(|(w, through)| *w -= through);
        off
    }

    /// Entries that a difference of W makes at a point of this weight, as far as it counts.
    fn carried(&mut self, point: WeightedNode, off: &[f64], largest: f64) -> f64 {
        let mut carried = Carried::nothing(self.outer.basis.len(), self.columns);
        let zeros = carried.moments.clone();
        self.add_product(&point, off, &mut carried);
        self.norm.difference(&carried.moments, &zeros) * margin::share(off[0].abs(), largest)
    }

    /// Sums over the points of a rule.
    fn sums(&mut self, nodes: impl IntoIterator<Item = WeightedNode>) -> Sums {
        let columns = self.columns;
        let mut sums = Sums { carried: Carried::nothing(self.outer.basis.len(), columns), seen: Vec::new() };
        for node in nodes {
            check_interrupt();
            let start = sums.seen.len();
            sums.seen.resize(start + columns, 0.0);
            self.add_seen(node.node, &mut sums.seen[start..]);
            self.add_product(&node, &sums.seen[start..], &mut sums.carried);
        }
        sums
    }

    /// Adds W_l(x) to `out`.
    fn add_seen(&mut self, node: Node, out: &mut [f64]) {
        let x = View { node, ball: self.outer.ball };
        self.cut.samples += self.inner.iter_mut().map(|part| part.seen_from(&x, out)).sum::<u64>();
    }

    /// Adds the products of the outer polynomials at a point and of W there.
    fn add_product(&mut self, point: &WeightedNode, seen: &[f64], carried: &mut Carried) {
        let basis = self.outer.basis;
        basis.raw(basis.frame().coordinates(&point.node), &mut self.left);
        carried.add(basis, point, &self.left, seen);
    }

    /// Points of a rule on a part of the outer patch: a tensor rule, or a rule on what
    /// lies before the plane of the inner patches.
    fn nodes(&mut self, part: &Patch, points: [usize; 2]) -> Nodes {
        let nodes = match &self.front {
            Some(front) => front.nodes(part, points),
            None => Nodes::of(part, points),
        };
        self.cut.samples += nodes.evaluations;
        nodes
    }
}

/// Points along and across of the rules tried, each with more than the one before.
fn rungs(most: [usize; 2]) -> [[usize; 2]; RUNGS.len()] {
    std::array::from_fn(|k| {
        let points = |n: usize| ((RUNGS[k] * n as f64).ceil() as usize).max(FEWEST + STEP * k);
        most.map(|n| points(n).min(MOST_POINTS))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_rule_is_compared_with_itself() {
        for n in 1..=MOST_POINTS {
            let [first, second, last] = rungs([n, 1]);
            assert!((0..2).all(|k| first[k] < second[k] && second[k] < last[k]), "{n} points");
            assert!(last[0] >= n);
        }
    }
}
