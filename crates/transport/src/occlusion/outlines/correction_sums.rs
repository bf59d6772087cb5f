//! Sums of one occlusion correction over cells of the outer element, which are halved until two levels agree.

use core::f64::consts::FRAC_1_PI;
use std::borrow::Cow;

use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{Aabb, DVec2, DVec3, clip_polygon, polygon_area};
use radiosity_kernel::contact::gap::point_to_polygon;
use radiosity_kernel::irradiance::ball::ball;
use radiosity_kernel::irradiance::visible_polygon::{inside_any, irradiance, irradiance_seen};
use radiosity_kernel::irradiance::within_polygon::hidden_by_round;
use radiosity_kernel::moments::{Moments, Side};
use radiosity_kernel::rules::far;
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::zone::Zone;
use radiosity_visibility::blocker_shadow::BlockerShadow;
use radiosity_visibility::bounding_ball::Ball;
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::{Corners, Coverage, cut_at_horizon};
use radiosity_work::interruption::check_interrupt;

use crate::occlusion::outlines::cell_cut::CellCut;
use crate::occlusion::outlines::correction::{Correction, Facets, InnerShape, Rims};
use crate::tolerances::{AGREED_BY_LEVELS, MOST_HALVINGS_OF_INNER, MOST_HALVINGS_OF_OUTER};

/// Most cells of one patch of the outer element; what is left then counts as error. The worst patches of the
/// built-in scenes, and of the rooms with slits in `tests/stress`, take a tenth of it.
const MOST_CELLS: u64 = 1 << 16;

/// Width over length below which a hidden polygon is a rounding error: collinear edges of shadows leave such
/// slivers.
const SLIVER: f64 = 1e-13;

/// Differences of two levels below this part of the entry are rounding.
const ROUNDING: f64 = 1e-15;

/// Halvings before a cell counts as wholly visible or wholly hidden because all its points are: few points
/// may miss the edge of a shadow. Two make it a quarter as long; more take four times the cells each.
const SURE: usize = 2;

/// Safety factor on a cell's maximal contribution, which is estimated from its corners and middle: the kernel
/// varies little between them in cells that its rules may be used on.
const CARRIED: f64 = 1.2;

/// Place next to a side of a cell, as a part of its length, where a jump between the side and the points of the rule is
/// looked for. A smaller value is spent on jumps along sides; a larger one leaves as much unseen.
const NEXT_TO_SIDE: f64 = 1e-3;

/// Part of a cell between a side and the outermost points of a rule of two; those of more leave less.
const OUTERMOST: f64 = 0.2;

/// An occlusion correction.
#[derive(Debug)]
pub(super) struct Occlusion {
    /// S_kl, row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Whether anything is hidden.
    pub hides: bool,
    /// Whether everything is hidden from every point of the rule.
    pub dark: bool,
    /// Estimate of the largest error, from cells left at the smallest size, and from those on which two levels agree
    /// where kinks are curved or a blocker passes through the outer element.
    pub error: f64,
    /// Terms of the rules.
    pub samples: u64,
}

/// The correction from one cell of the outer element.
struct CellSum {
    values: Vec<f64>,
    /// Points of the rule along and across the cell.
    points: [usize; 2],
    /// Part of the inner element that is hidden from all points of the rule together.
    shadow: HiddenShare,
}

impl CellSum {
    /// The largest difference from the sum of a cell's parts.
    fn difference(&self, parts: &[Self]) -> f64 {
        let fine = |k: usize| parts.iter().map(|part| part.values[k]).sum::<f64>();
        let differences = self.values.iter().enumerate().map(|(k, value)| (value - fine(k)).abs());
        differences.fold(0.0, f64::max)
    }
}

/// Part of the inner element that is hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum HiddenShare {
    Nothing,
    Part,
    Everything,
}

impl HiddenShare {
    fn and(self, other: Self) -> Self {
        if self == other { self } else { Self::Part }
    }
}

/// The running sums of one correction.
pub(super) struct CorrectionSums<'a> {
    correction: &'a Correction<'a>,
    moments: Moments<'a>,
    /// Raw functions of the inner element at one point.
    row: Vec<f64>,
    hides: bool,
    dark: bool,
    error: f64,
    /// Sum of the squared differences of two levels on cells on which these agree.
    squares: f64,
    samples: u64,
    /// Cells that may still be halved.
    left: u64,
}

impl<'a> CorrectionSums<'a> {
    pub(super) fn new(correction: &'a Correction<'a>) -> Self {
        Self {
            correction,
            moments: Moments::new(&correction.pair[0].basis, &correction.pair[1].basis),
            row: vec![0.0; correction.inner.basis.len()],
            hides: false,
            dark: true,
            error: 0.0,
            squares: 0.0,
            samples: 0,
            left: 0,
        }
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.moments.add_raw(other.moments.values(), 0);
        self.hides |= other.hides;
        self.dark &= other.dark;
        self.error += other.error;
        self.squares += other.squares;
        self.samples += other.samples;
    }

    pub(super) fn finish(self) -> Occlusion {
        let Self { correction, hides, dark, samples, moments, .. } = self;
        let is_smooth = !correction.is_round && !correction.is_cut;
        let agreed = if is_smooth { 0.0 } else { self.squares.sqrt() / AGREED_BY_LEVELS };
        let error = self.error + agreed;
        Occlusion { values: moments.into_block(), hides, dark: dark && hides, error, samples }
    }

    /// Adds a patch of the outer element with an error up to `limit`.
    pub(super) fn add(&mut self, patch: &Patch, bodies: &[usize], limit: f64) {
        self.left = MOST_CELLS;
        self.visit(patch, bodies, None, limit, MOST_HALVINGS_OF_OUTER);
    }

    /// Adds a cell of the outer element with an error up to `limit`. `coarse` are its moments by one rule, if
    /// known.
    fn visit(&mut self, cell: &Patch, blockers: &[usize], coarse: Option<CellSum>, limit: f64, depth: usize) {
        check_interrupt();
        let blockers =
            self.correction.visibility.narrow_bodies(blockers, &cell.hull(), self.correction.edges.inner());
        if blockers.is_empty() {
            self.dark = false;
            return;
        }
        let coarse = coarse.unwrap_or_else(|| self.sum(cell, &blockers, [self.correction.points; 2]));
        let cut = CellCut::of(cell);
        let parts = cut.parts(cell);
        let points = cut.points(self.correction.points, coarse.points);
        let sums: Vec<CellSum> = parts.iter().map(|part| self.sum(part, &blockers, points)).collect();
        let agreed = self.agreed(limit, depth);
        let mut difference = coarse.difference(&sums) * self.correction.unit;
        if difference <= agreed {
            difference = difference.max(self.beside_jumps(&parts, &sums, &blockers));
        }
        let shadow = sums.iter().map(|sum| sum.shadow).fold(coarse.shadow, HiddenShare::and);
        let is_sure = shadow == HiddenShare::Part || depth + SURE <= MOST_HALVINGS_OF_OUTER;
        let is_told = is_sure && difference <= agreed;
        self.left = self.left.saturating_sub(parts.len() as u64);
        let is_last = depth == 0 || self.left == 0;
        if is_last && difference > agreed {
            self.error += difference;
        }
        let may_miss = is_told && !is_last && self.may_miss(cell, &blockers);
        if is_told && !may_miss {
            self.squares += difference * difference;
        }
        let entries = self.correction.outer.basis.len() * self.correction.inner.basis.len();
        let share = limit / (parts.len() as f64).sqrt();
        for (index, (part, sum)) in parts.iter().zip(sums).enumerate() {
            let is_done = is_last || is_told && !(may_miss && self.may_miss(part, &blockers));
            if is_done {
                self.moments.add_raw(&sum.values[..entries], 0);
            } else {
                // No part takes the cells that later ones may need.
                let cells_left = self.left;
                self.left = cells_left.div_ceil((parts.len() - index) as u64);
                let own = self.left;
                self.visit(part, &blockers, Some(sum), share, depth - 1);
                self.left += cells_left - own;
            }
        }
    }

    /// Difference of two levels up to which they agree. The first two, of few points, may agree by chance: they
    /// have to agree better.
    fn agreed(&self, limit: f64, depth: usize) -> f64 {
        let agreed = if depth == MOST_HALVINGS_OF_OUTER { limit } else { AGREED_BY_LEVELS * limit };
        agreed.max(ROUNDING * self.correction.limit.entry)
    }

    /// Estimate of what is hidden or seen between the sides of cells and their points, which are all hidden or all
    /// seen: where corners are not, the hidden part jumps.
    fn beside_jumps(&mut self, cells: &[Patch], sums: &[CellSum], blockers: &[usize]) -> f64 {
        if !self.correction.is_cut {
            return 0.0;
        }
        let pure = cells.iter().zip(sums).filter(|(_, sum)| sum.shadow != HiddenShare::Part);
        let mut unseen = 0.0;
        for (cell, sum) in pure {
            if self.changes_at_corners(cell, sum.shadow, blockers) {
                unseen += OUTERMOST * self.most(cell);
            }
        }
        unseen
    }

    fn changes_at_corners(&mut self, cell: &Patch, shadow: HiddenShare, blockers: &[usize]) -> bool {
        let ends = [NEXT_TO_SIDE, 1.0 - NEXT_TO_SIDE];
        let mut corners = ends.into_iter().flat_map(|s| ends.map(|t| cell.node(s, t)));
        let mut row = vec![0.0; self.correction.inner.basis.len()];
        corners.any(|x| self.hidden(&x, blockers, &mut row) != shadow)
    }

    /// Whether the rule on a cell may have missed shadows that matter.
    fn may_miss(&self, cell: &Patch, blockers: &[usize]) -> bool {
        CARRIED * self.most(cell) > self.correction.limit.error
            && self.correction.edges.may_be_passed_over(
                cell,
                blockers,
                self.correction.points as f64,
                self.correction.accuracy,
            )
    }

    /// Maximal contribution of a cell to an entry, estimated from the unobstructed irradiance at its corners
    /// and middle.
    fn most(&self, cell: &Patch) -> f64 {
        let nodes =
            [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[s, t]| cell.node(s, t));
        let seen = |x: &Node| -> f64 {
            match &self.correction.inner_shape {
                InnerShape::Flat(Facets { polygons, .. }) => {
                    polygons.iter().map(|polygon| irradiance(x.position, x.normal, polygon)).sum()
                }
                InnerShape::Round(rims) => {
                    let (disk, hole) = rims.seen_from(x.position);
                    disk.irradiance(x.normal) - hole.map_or(0.0, |hole| hole.irradiance(x.normal))
                }
                InnerShape::OfSphere(zone) => zone.kernel() * self.correction.inner.area,
            }
        };
        nodes.iter().map(seen).fold(0.0, f64::max) * nodes[0].area * self.correction.constants
    }

    /// Moments of what is hidden from a cell, receiver's raw functions by emitter's. If the outer element has
    /// constants only, the moments with its two coordinates follow: one number may agree on two levels by
    /// chance, three hardly do.
    fn sum(&mut self, cell: &Patch, blockers: &[usize], points: [usize; 2]) -> CellSum {
        let (own, other) = (self.correction.outer.basis.len(), self.correction.inner.basis.len());
        let witnesses = if own == 1 { 2 * other } else { 0 };
        let (mut sum, mut shadow) = (vec![0.0; own * other + witnesses], None);
        let (mut left, mut right) = (vec![0.0; own], vec![0.0; other]);
        let [along, across] = points.map(UnitRule::of);
        for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
            check_interrupt();
            let x = cell.node(s, t);
            right.fill(0.0);
            let found = self.hidden(&x, blockers, &mut right);
            shadow = Some(shadow.map_or(found, |other| found.and(other)));
            if found == HiddenShare::Nothing {
                continue;
            }
            let coordinates = self.correction.outer.basis.frame().coordinates(&x);
            self.correction.outer.basis.raw(coordinates, &mut left);
            let weight = ws * wt * x.area;
            let (rows, columns) = match self.correction.side {
                Side::Receiver => (&left, &right),
                Side::Emitter => (&right, &left),
            };
            let (moments, witnesses) = sum.split_at_mut(own * other);
            for (row, l) in moments.chunks_exact_mut(columns.len()).zip(rows) {
                row.iter_mut().zip(columns).for_each(|(value, r)| *value += weight * l * r);
            }
            for (row, place) in witnesses.chunks_exact_mut(other).zip(coordinates) {
                row.iter_mut().zip(&right).for_each(|(value, r)| *value += weight * left[0] * place * r);
            }
        }
        CellSum { values: sum, points, shadow: shadow.unwrap_or(HiddenShare::Nothing) }
    }

    /// Adds ∫ κ(x, y) R_l(y) dA_y over what is hidden from x to `out`; returns how much is hidden.
    fn hidden(&mut self, x: &Node, blockers: &[usize], out: &mut [f64]) -> HiddenShare {
        if let Some(hidden) = self.hidden_by_ball(x, blockers) {
            out[0] += hidden;
            (self.dark, self.hides) = (false, true);
            self.samples += 1;
            return HiddenShare::Part;
        }
        let Correction { visibility, inner_shape, ball, ball_corners, has_frusta, .. } = self.correction;
        let shadows = || visibility.shadows(blockers, x.position, ball, *ball_corners);
        let (any, everything) = match inner_shape {
            InnerShape::Flat(facets) if *has_frusta => self.hidden_by_each(facets, x, blockers, out),
            InnerShape::Flat(facets) => self.hidden_of_facets(facets, x, &shadows(), out),
            InnerShape::Round(rims) => self.hidden_of_rims(rims, x, blockers, out),
            InnerShape::OfSphere(zone) => (self.hidden_of_sphere(zone, x, &shadows(), out), false),
        };
        self.dark &= everything;
        self.hides |= any;
        match (any, everything) {
            (false, _) => HiddenShare::Nothing,
            (true, true) => HiddenShare::Everything,
            (true, false) => HiddenShare::Part,
        }
    }

    /// Within a whole sphere that carries a constant, the integral over what a single ball hides: every ray to the ball
    /// would go on to the sphere. None elsewhere.
    fn hidden_by_ball(&self, x: &Node, blockers: &[usize]) -> Option<f64> {
        let Correction { visibility, inner, inner_shape, constant, .. } = self.correction;
        let InnerShape::OfSphere(zone) = inner_shape else { return None };
        let (center, radius) = visibility.only_ball(blockers)?;
        let is_constant = zone.is_whole() && inner.basis.len() == 1;
        let seen = if is_constant { ball(x.position, x.normal, center, radius) } else { None };
        seen.map(|seen| constant * seen)
    }

    /// Whether anything is hidden by round things apart of a flat element that carries a constant, and whether
    /// all is: through their outlines.
    fn hidden_by_each(
        &mut self,
        facets: &Facets,
        x: &Node,
        blockers: &[usize],
        out: &mut [f64],
    ) -> (bool, bool) {
        let constant = self.correction.constant;
        let shadows = self.round_shadows(x, blockers);
        let (mut any, mut everything) = (false, true);
        for polygon in &facets.polygons {
            let Some(polygon) = self.seen_from(x, polygon, facets.normal) else { continue };
            let mut seen: Corners = polygon.iter().map(|corner| corner - x.position).collect();
            cut_at_horizon(x.normal, &mut seen);
            let mut all = false;
            for shadow in &shadows {
                let found = hidden_by_round(x.normal, &seen, shadow);
                any |= found.coverage != Coverage::Clear;
                all |= found.coverage == Coverage::Hidden;
                out[0] += constant * found.irradiance;
                self.samples += seen.len() as u64;
            }
            everything &= all;
        }
        (any, everything)
    }

    /// Whether anything is hidden by round things apart of a disk or a ring that carries a constant, and whether
    /// all is: through their outlines.
    fn hidden_of_rims(&mut self, rims: &Rims, x: &Node, blockers: &[usize], out: &mut [f64]) -> (bool, bool) {
        let (disk, hole) = rims.seen_from(x.position);
        let (mut any, mut everything) = (false, false);
        for shadow in self.round_shadows(x, blockers) {
            let found = disk.hidden(x.normal, &shadow);
            let beside = hole.map(|hole| hole.hidden(x.normal, &shadow));
            let is_beside = beside.is_some_and(|beside| beside.irradiance >= found.irradiance);
            any |= found.coverage != Coverage::Clear && !is_beside;
            everything |= found.coverage == Coverage::Hidden;
            let through_hole = beside.map_or(0.0, |beside| beside.irradiance);
            out[0] += self.correction.constant * (found.irradiance - through_hole).max(0.0);
            self.samples += 1;
        }
        (any, everything)
    }

    /// The shadows of round things from a point.
    fn round_shadows(&self, x: &Node, blockers: &[usize]) -> Vec<RoundShadow<'a>> {
        let Correction { visibility, .. } = self.correction;
        blockers.iter().filter_map(|body| visibility.round_shadow(*body, x.position)).collect()
    }

    /// Whether anything is hidden, and whether all is that the point would see.
    fn hidden_of_facets(
        &mut self,
        facets: &Facets,
        x: &Node,
        shadows: &[BlockerShadow],
        out: &mut [f64],
    ) -> (bool, bool) {
        let (mut any, mut everything) = (false, true);
        for (polygon, ball) in facets.polygons.iter().zip(&facets.balls) {
            let Some(polygon) = self.seen_from(x, polygon, facets.normal) else { continue };
            let (hidden, all) = inside_any(&polygon, ball, shadows);
            everything &= all;
            any |= !hidden.is_empty();
            hidden.into_iter().for_each(|seen| self.gather(x, seen, facets.normal, out));
        }
        (any, everything)
    }

    /// Whether anything is hidden.
    fn hidden_of_sphere(
        &mut self,
        zone: &Zone,
        x: &Node,
        shadows: &[BlockerShadow],
        out: &mut [f64],
    ) -> bool {
        let view = zone.view(x.position).map(|corner| corner + x.position);
        let (hidden, _) = inside_any(&view, &Ball::around(&view), shadows);
        for seen in &hidden {
            self.samples += zone.seen_through(x.position, seen, zone.kernel(), out);
        }
        !hidden.is_empty()
    }

    /// The part of a polygon of the inner element that a point sees without blockers.
    fn seen_from<'p>(&self, x: &Node, polygon: &'p [DVec3], normal: DVec3) -> Option<Cow<'p, [DVec3]>> {
        if self.correction.outer.plane.is_some() {
            return Some(Cow::Borrowed(polygon));
        }
        let is_before = (x.position - polygon[0]).dot(normal) > 0.0;
        let above = clip_polygon(polygon, x.position, x.normal);
        (is_before && above.len() > 2).then_some(Cow::Owned(above))
    }

    /// Adds the integral over a hidden polygon, given by its corners relative to x.
    fn gather(&mut self, x: &Node, seen: Corners, normal: DVec3, out: &mut [f64]) {
        if out.len() == 1 {
            self.samples += seen.len() as u64;
            out[0] += self.correction.constant * irradiance_seen(x.normal, seen);
            return;
        }
        let polygon: Corners = seen.iter().map(|a| a + x.position).collect();
        for patch in Patch::of_polygon(&polygon, normal) {
            let corners = patch.polygon();
            let length = Aabb::around(corners.iter().copied()).diagonal();
            if polygon_area(&corners) > SLIVER * length * length {
                self.gauss(x, &patch, normal, out, MOST_HALVINGS_OF_INNER);
            }
        }
    }

    fn gauss(&mut self, x: &Node, patch: &Patch, normal: DVec3, out: &mut [f64], depth: usize) {
        let [along, across] = patch.extents();
        let [a, b, c, d] = patch.corners();
        let gap = point_to_polygon(x.position, &[a, b, c, d][..if patch.is_triangle() { 3 } else { 4 }]);
        if gap < SMALLEST_RATIO * along.max(across) && depth > 0 {
            let direction = if along >= across { Direction::Along } else { Direction::Across };
            return patch
                .halves(direction)
                .iter()
                .for_each(|half| self.gauss(x, half, normal, out, depth - 1));
        }
        let basis = &self.correction.inner.basis;
        let degree = basis.total_degree() + usize::from(!patch.is_parallelogram());
        let rule = |extent: f64| {
            let ratio = (gap / extent).max(SMALLEST_RATIO);
            let rho = 2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt();
            UnitRule::of(far::points(degree, self.correction.accuracy, rho))
        };
        let (first, second) = (rule(along), rule(across));
        let area = [(b - a).cross(d - a), (b - a).cross(c - b), (c - d).cross(d - a)].map(|n| n.length());
        let height = (x.position - a).dot(normal) * FRAC_1_PI;
        for (s, ws) in first.iter() {
            let (start, across) = (a + (b - a) * s, (d - a) * (1.0 - s) + (c - b) * s);
            for (t, wt) in second.iter() {
                let y = start + across * t;
                let offset = y - x.position;
                let square = offset.length_squared();
                // The area element is linear in s and t.
                let stretch = area[0] + (area[1] - area[0]) * s + (area[2] - area[0]) * t;
                let weight = ws * wt * stretch * height * offset.dot(x.normal) / (square * square);
                basis.raw(basis.frame().locate(y, DVec2::ZERO), &mut self.row);
                out.iter_mut().zip(&self.row).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        self.samples += (first.nodes.len() * second.nodes.len()) as u64;
    }
}
