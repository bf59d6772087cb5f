//! The quadrature rule of a cell, and its expected error.
//!
//! The rule depends on whether cell and blockers are flat, and whether there are blockers:
//!
//! ```text
//! cell \ blockers         none                    flat                      curved
//! flat, even field        Lambert                 Lambert, visible pieces   lines
//! flat                    Gauss, near: Lambert    pieces, dim: points       lines
//! curved                  Gauss                   Gauss · lines             Gauss · lines
//! ```
//!
//! A straight cell, as of a tube along its axis, whose front is seen everywhere counts as flat unless
//! blockers are curved. On the inside of a whole ball the kernel between points that see each other is
//! constant. A cell that can send no more than the tolerance is left to its visible points.

use std::f64::consts::{FRAC_1_PI, PI};
use std::iter;

use radiosity_elements::patch::Node;
use radiosity_geom::{DVec3, Plane};
use radiosity_kernel::kernel;

use crate::blockers::{BlockerRange, CurvedPiece};
use crate::cells::cell::{Cell, Field, POINTS};
use crate::lines::line_quadrature::LineQuadrature;
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::COSINE_OF_CELL;
use crate::traversal::Pass;
use crate::traversal::Traversal;

/// A curved cell of larger width over distance is divided: rules of four points tell nothing of it.
const NEAR: f64 = 1.5;

/// Relative error assumed for a near cell of the point's own smooth surface, where κ is bounded. An
/// assumption: a smaller one lets large parts of a bent surface pass, a larger one divides down to cells that
/// carry nothing.
const NEAR_OWN: f64 = 0.1;

/// Factor on the error of a curved cell: the errors of its neighbours have the same sign, and those of some
/// twenty cells add up. With a smaller value light from curved surfaces may miss its accuracy.
const CURVED: f64 = 20.0;

/// Factors on the error of a cell of an opening to a sky that nothing hides, and behind flat blockers: radiance bends
/// alike in all of them, so that their errors add up; at the edges of shadows they do in part. Measured before 20
/// windows under two clear skies: the largest of 500 errors was 1.1 ε with 5 for the former, and is 0.5 ε with this;
/// behind a bar the largest of 24 was 1.0 ε with 1 for the latter.
const OF_SKY: f64 = 20.0;
const OF_SKY_IN_PART: f64 = 4.0;

/// (1 − cos ϑ)²/AREA_RULE bounds the relative error of two-point rules for the area of a piece of a ball of
/// width ϑ: for ∫ cos φ dφ it is ϑ⁴/4320 ≈ (1 − cos ϑ)²/1080.
const AREA_RULE: f64 = 500.0;

/// Lambert's formula is not tried if its error, with Gauss's F, exceeds so many tolerances: its own F may be
/// smaller than that of Gauss's rule, though not by more. With a smaller value cells are divided that the
/// formula would do for.
const HOPELESS: f64 = 1.5;

/// Contribution, in multiples of the tolerance, of a flat cell behind flat blockers up to which its points
/// decide what is visible: whatever they say ([`SHADED`]), and if all of them agree ([`AGREED`]). Shadow
/// edges cross cells at random places, so the errors cancel. Chosen: in rooms with boxes gathered light was
/// then right to two tolerances, with 4 and 12 to ten, in the same time.
const SHADED: f64 = 1.0;
const AGREED: f64 = 4.0;

/// Error of a curved cell across its silhouette or the horizon, over its largest contribution, since the part
/// that is seen may be anything from none to all: an estimate. With a larger value more cells are divided
/// along silhouettes.
const SILHOUETTE_ERROR: f64 = 0.25;

/// Width over distance above which line quadrature is not trusted: a cell as wide as twice its distance is
/// seen under 90°, and lines are far apart at its far end.
const WIDE: f64 = 2.0;

/// Part of the variation of a field over a cell that its bilinear interpolant misses: an estimate for fields
/// that are smooth in the cell. With a larger value more cells are divided behind blockers.
const LINEAR: f64 = 0.1;

/// The rule for a cell, with its expected error.
pub(super) struct Estimate {
    /// Weight of each Gauss point; they add up to the form factor F of the cell.
    pub(super) weights: [f64; POINTS],
    /// Expected error; infinite where the weights leave shadows out.
    pub(super) error: f64,
}

/// A cell as the point sees it.
#[derive(Clone, Copy)]
struct SeenCell<'c> {
    cell: &'c Cell,
    /// The field on it.
    field: &'c Field,
    /// The blockers before it.
    before: BlockerRange,
    /// Weights of the Gauss rule, without blockers.
    weights: [f64; POINTS],
    /// Width over distance.
    width: f64,
}

impl Traversal<'_> {
    /// The rule for a cell with this field and the blockers `before` it.
    pub(super) fn estimate(&self, pass: &Pass, cell: &Cell, field: &Field, before: BlockerRange) -> Estimate {
        if field.is_uniform() && cell.is_flat() && self.shadows.are_flat(before) {
            let factor = self.receiver.factor(&cell.hull, self.shadows.volumes(before));
            return Estimate { weights: scaled(cell, [0.0; POINTS], factor), error: 0.0 };
        }
        let weights = self.weights(cell);
        let width = 2.0 * cell.radius / self.distance(cell);
        let seen = SeenCell { cell, field, before, weights, width };
        match (self.is_like_flat(cell), before.is_empty()) {
            (true, true) => self.clear_flat(pass, &seen),
            (true, false) if self.shadows.are_flat(before) => self.hidden_flat(pass, &seen),
            (true, false) if cell.is_flat() => self.by_lines(pass, &seen),
            _ if pass.dome.is_some() && before.is_empty() => self.under_dome(pass, cell, field),
            _ => self.curved(pass, &seen),
        }
    }

    /// Whether Lambert's formula holds for a cell: it is flat, or straight and its front is seen everywhere.
    pub(super) fn is_like_flat(&self, cell: &Cell) -> bool {
        cell.is_straight && cell.samples.iter().all(|tangent| self.is_before(tangent))
    }

    /// Whether a curved cell turns its back to the receiver at all of its samples.
    fn is_behind(&self, cell: &Cell) -> bool {
        !cell.samples.iter().any(|tangent| self.is_before(tangent))
    }

    fn is_before(&self, tangent: &Plane) -> bool {
        tangent.height(self.receiver.position) > 0.0
    }

    /// No blockers: the Gauss rule far away, Lambert's formula near by.
    fn clear_flat(&self, pass: &Pass, seen: &SeenCell) -> Estimate {
        let SeenCell { cell, field, weights, width, .. } = *seen;
        let alike = if pass.tree.opening().is_some() { OF_SKY } else { 1.0 };
        let sum: f64 = weights.iter().sum();
        let error = alike * sum * gauss_error(field, width);
        let overlooks =
            || self.receiver.clears(cell.center, cell.radius) || self.receiver.overlooks(&cell.hull);
        if width < 1.0 && error <= pass.tolerance && overlooks() {
            return Estimate { weights, error };
        }
        let by_form = alike * lambert_error(field, width);
        if width < 1.0 && sum * by_form > HOPELESS * pass.tolerance {
            return Estimate { weights, error: sum * by_form };
        }
        let factor = self.receiver.factor(&cell.hull, iter::empty());
        Estimate { weights: scaled(cell, weights, factor), error: factor * by_form }
    }

    /// Flat blockers: Lambert's formula for the visible pieces, or the visible points of a cell that sends
    /// little.
    fn hidden_flat(&self, pass: &Pass, seen: &SeenCell) -> Estimate {
        let SeenCell { cell, field, before, weights, width } = *seen;
        if width >= 1.0 || field.spread == 0.0 {
            return self.pieces(pass, seen);
        }
        let sum: f64 = weights.iter().sum();
        let geometry = sum * gauss_error(field, width);
        let at_stake = sum * field.brightness;
        if at_stake > SHADED * pass.tolerance {
            let visible = self.visible(pass, cell, weights, before);
            let is_sure = at_stake <= AGREED * pass.tolerance && self.agrees(pass, seen, &visible);
            if is_sure && geometry <= pass.tolerance {
                return Estimate { weights: visible, error: geometry };
            }
            return self.pieces(pass, seen);
        }
        if geometry > pass.tolerance {
            return Estimate { weights, error: f64::INFINITY };
        }
        Estimate {
            weights: self.visible(pass, cell, weights, before),
            error: geometry.max(at_stake / SHADED),
        }
    }

    /// Lambert's formula for the visible pieces of a flat cell behind flat blockers.
    fn pieces(&self, pass: &Pass, seen: &SeenCell) -> Estimate {
        let SeenCell { cell, field, before, weights, .. } = *seen;
        let factor = self.receiver.factor(&cell.hull, self.shadows.volumes(before));
        let visible = if field.spread == 0.0 { weights } else { self.visible(pass, cell, weights, before) };
        let alike = if pass.tree.opening().is_some() { OF_SKY_IN_PART } else { 1.0 };
        let error = alike * factor * (field.spread + field.detail);
        Estimate { weights: scaled(cell, visible, factor), error }
    }

    /// Whether the points of a cell, its corners and its centre are all visible, or all hidden.
    fn agrees(&self, pass: &Pass, seen: &SeenCell, visible: &[f64; POINTS]) -> bool {
        let SeenCell { cell, before, weights, .. } = seen;
        let hides = |y: &DVec3| self.shadows.hide(*before, *y, pass.tree.surface);
        let mut others = cell.hull.iter().chain([&cell.center]);
        match visible.iter().any(|weight| *weight > 0.0) {
            true => weights == visible && !others.any(hides),
            false => others.all(hides),
        }
    }

    /// Curved blockers before a flat cell: line quadrature.
    fn by_lines(&self, pass: &Pass, seen: &SeenCell) -> Estimate {
        let SeenCell { cell, field, before, weights, width } = *seen;
        let Some(spans) = self.shadows.hidden_spans(before, &cell.hull, &cell.hull, None) else {
            return Estimate { weights: [0.0; POINTS], error: 0.0 };
        };
        if spans.is_empty() {
            return self.clear_flat(pass, seen);
        }
        let factor = self.receiver.factor(&cell.hull, iter::empty());
        let stake = factor * field.brightness;
        if width < 1.0 && stake <= pass.tolerance {
            return Estimate { weights: self.visible(pass, cell, weights, before), error: pass.tolerance };
        }
        let shares = LineQuadrature::new(self.receiver, &spans).shares(pass.tolerance / stake);
        let sum: f64 = shares.iter().sum();
        let weights = match cell.is_parallelogram() {
            true => shares.map(|share| factor * share),
            false => scaled(cell, weights, factor * sum),
        };
        let form = match cell.is_parallelogram() {
            true => field.detail + LINEAR * field.spread,
            false => field.detail + field.spread,
        };
        let near = if width > WIDE { stake } else { 0.0 };
        Estimate { weights, error: near.max(factor * sum * form) }
    }

    /// A curved cell: the Gauss rule times the visible part by line quadrature.
    fn curved(&self, pass: &Pass, seen: &SeenCell) -> Estimate {
        let SeenCell { cell, field, before, weights, width } = *seen;
        let whole: f64 = weights.iter().sum();
        let stake = whole * field.brightness;
        if self.most_from(seen) <= pass.tolerance {
            return Estimate { weights: self.visible(pass, cell, weights, before), error: pass.tolerance };
        }
        if cell.bend < COSINE_OF_CELL || (width > NEAR && !pass.own) {
            return Estimate { weights, error: f64::INFINITY };
        }
        if self.is_behind(cell) {
            return Estimate { weights, error: 0.0 };
        }
        let near = if width > NEAR { NEAR_OWN * stake } else { CURVED * whole * gauss_error(field, width) };
        let form = near + self.border(cell, field) + self.misplaced(seen);
        if before.is_empty() {
            return Estimate { weights, error: form };
        }
        if form > pass.tolerance {
            return Estimate { weights, error: f64::INFINITY };
        }
        if stake <= pass.tolerance {
            return Estimate { weights: self.visible(pass, cell, weights, before), error: form };
        }
        let piece = CurvedPiece { surface: pass.tree.surface, parameters: cell.parameters() };
        let Some(spans) = self.shadows.hidden_spans(before, &cell.outline(), &cell.hull, Some(piece)) else {
            return Estimate { weights: self.visible(pass, cell, weights, before), error: form };
        };
        if spans.is_empty() {
            return Estimate { weights, error: form };
        }
        let shares = LineQuadrature::new(self.receiver, &spans).shares(pass.tolerance / stake);
        let share = shares.iter().sum::<f64>().clamp(0.0, 1.0);
        let partial =
            if share > 0.0 && share < 1.0 { 0.5 * stake * cell.warp + whole * field.spread } else { 0.0 };
        Estimate { weights: weights.map(|weight| share * weight), error: form.max(partial) }
    }

    /// The constant kernel of a ball's inside: the error is that of areas and field.
    fn under_dome(&self, pass: &Pass, cell: &Cell, field: &Field) -> Estimate {
        let weights = cell.nodes.map(|node| pass.dome.unwrap_or(0.0) * node.area);
        let whole: f64 = weights.iter().sum();
        let turn = 1.0 - cell.bend;
        Estimate { weights, error: whole * (field.brightness * turn * turn / AREA_RULE + field.detail) }
    }

    /// Upper bound of what a cell can send; infinite for a near one.
    fn most_from(&self, seen: &SeenCell) -> f64 {
        let SeenCell { cell, field, width, .. } = *seen;
        if width >= 1.0 {
            return f64::INFINITY;
        }
        let nearest = self.distance(cell) - cell.radius;
        field.brightness * cell.area() / (PI * nearest * nearest)
    }

    /// Error of a curved cell whose points miss its area or its place; a near one has that of its near rule.
    fn misplaced(&self, seen: &SeenCell) -> f64 {
        let SeenCell { cell, field, weights, width, .. } = *seen;
        if width > NEAR {
            return 0.0;
        }
        let of_field =
            weights.iter().sum::<f64>() * field.spread * cell.moments.offset(cell.area(), cell.radius);
        field.brightness * cell.moments.error_at(self.distance(cell)) + of_field
    }

    /// Error of a curved cell that is seen in part, at its silhouette or the horizon.
    fn border(&self, cell: &Cell, field: &Field) -> f64 {
        let facing = |tangent: &Plane| {
            (self.receiver.position - tangent.point).normalize_or_zero().dot(tangent.normal)
        };
        let cosines = || cell.samples.iter().map(facing);
        let (low, high) = cosines().fold((f64::MAX, f64::MIN), |(low, high), c| (low.min(c), high.max(c)));
        if low >= 0.0 && self.receiver.overlooks(&cell.hull) {
            return 0.0;
        }
        let distance = self.distance(cell);
        SILHOUETTE_ERROR * field.brightness * high * cell.area() / (PI * distance * distance)
    }

    /// Weights of the Gauss rule with the kernel, without blockers.
    pub(super) fn weights(&self, cell: &Cell) -> [f64; POINTS] {
        let ReceiverPoint { position, normal, ground, .. } = *self.receiver;
        if ground.is_none() && cell.is_flat() {
            return self.weights_of_flat(cell);
        }
        let here = Node { position, normal, area: 1.0, parameters: Default::default() };
        let under = |y: &Node| ground.is_some_and(|ground| (y.position - position).dot(ground) <= 0.0);
        std::array::from_fn(|k| {
            let there = &cell.nodes[k];
            if under(there) { 0.0 } else { there.area * kernel(&here, there) }
        })
    }

    /// As [`Traversal::weights`] for a flat cell, whose points share one normal.
    fn weights_of_flat(&self, cell: &Cell) -> [f64; POINTS] {
        let ReceiverPoint { position, normal, .. } = *self.receiver;
        let (out, [x, y, z]) = (cell.nodes[0].normal, &cell.lanes);
        let mut weights = [0.0; POINTS];
        for (k, weight) in weights.iter_mut().enumerate() {
            let [dx, dy, dz] = [x[k] - position.x, y[k] - position.y, z[k] - position.z];
            let arriving = normal.x * dx + normal.y * dy + normal.z * dz;
            let leaving = -(out.x * dx + out.y * dy + out.z * dz);
            let square = dx * dx + dy * dy + dz * dz;
            let value = cell.nodes[k].area * (arriving * leaving * FRAC_1_PI / (square * square));
            *weight = if arriving > 0.0 && leaving > 0.0 { value } else { 0.0 };
        }
        weights
    }

    /// The weights of the visible points; 0 for hidden ones.
    pub(super) fn visible(
        &self,
        pass: &Pass,
        cell: &Cell,
        weights: [f64; POINTS],
        before: BlockerRange,
    ) -> [f64; POINTS] {
        let hidden = |k: usize| self.shadows.hide(before, cell.nodes[k].position, pass.tree.surface);
        std::array::from_fn(|k| if weights[k] > 0.0 && hidden(k) { 0.0 } else { weights[k] })
    }

    /// Distance from the point to the centre of a cell.
    pub(super) fn distance(&self, cell: &Cell) -> f64 {
        cell.center.distance(self.receiver.position)
    }
}

/// Error over F of the Gauss rule for a cell of `width` w = h/r without blockers: 0.02 B w⁴ + 0.05 ΔB
/// w³ + δB.
///
/// A square of even B seen face on has 0.0083 w⁴ = 2 · 72/4320 · (side/r)⁴, as ∂⁴κ/∂s⁴ = 72 κ for κ ∝
/// (1 + s²)⁻². Both constants were measured when the rule was written, without a record.
fn gauss_error(field: &Field, width: f64) -> f64 {
    let square = width * width;
    field.brightness * 0.02 * square * square + field.spread * 0.05 * square * width + field.detail
}

/// Error over F of Lambert's formula with B̄ from the four points: ΔB min(1, 0.3 w²) + δB; 0.3 as in
/// [`gauss_error`].
fn lambert_error(field: &Field, width: f64) -> f64 {
    field.spread * (0.3 * width * width).min(1.0) + field.detail
}

/// `weights` scaled to the sum `factor`; in proportion to area where all of them vanish.
fn scaled(cell: &Cell, weights: [f64; POINTS], factor: f64) -> [f64; POINTS] {
    let areas = cell.nodes.map(|node| node.area);
    let by = if weights.iter().any(|w| *w > 0.0) { weights } else { areas };
    let sum: f64 = by.iter().sum();
    by.map(|w| if sum > 0.0 { w * factor / sum } else { 0.0 })
}
