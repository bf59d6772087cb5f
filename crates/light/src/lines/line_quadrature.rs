//! Line quadrature: how much of a planar cell is visible past blockers.
//!
//! ```text
//! shares_k = ∫∫_visible κ N_k ds dt / ∫∫ κ ds dt ,     Σ_k shares_k ≤ 1 ,
//! ```
//!
//! with N_k the bilinear functions of the cell's 2 × 2 points. Along a line the visible parts are known
//! ([`crate::lines::hidden_spans`]), and κ is integrated over each by Gauss's rule. Across lines the
//! integrand is continuous, with bends where the outline meets the border of the cell and roots where it
//! touches a line. It is integrated by Simpson's rule on panels that are halved while two estimates differ by
//! more than the tolerance. If the outline runs along the lines, so that some see all and others nothing,
//! lines of the other direction are taken. The same is done if every line sees all of the cell, or none: a
//! visible or hidden strip beside the edge of a column may lie between two lines.

use std::f64::consts::PI;

use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::lines::hidden_spans::HiddenSpans;
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::MOST_HALVINGS_OF_PANEL;

/// Gauss points on each visible part of a line, where κ is smooth: three err with the sixth power of the
/// angle that the part is seen under. Fewer would be felt in near cells.
const POINTS: usize = 3;

/// Initial panels of a cell: seven lines, between which a blocker that is narrower is missed.
const PANELS: usize = 3;

/// Initial panels of a whole area light, which stands for many cells.
const LAMP_PANELS: usize = 10;

/// Error of the better of two estimates over their difference, where the integrand has a bend: nearly all of
/// it, since halving gains little there. A smooth integrand is off by a fifteenth (Simpson's rule), and is
/// refined more than it needs.
const BEND: f64 = 0.7;

/// Variation of the visible part between lines above which the outline is taken to run along them. An
/// arbitrary choice: both directions are right, and the one whose lines vary less takes fewer panels.
const ALONG: f64 = 0.6;

/// Integrals along a line or over a panel: visible, weighted with each N_k, and unoccluded.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    visible: [f64; 4],
    all: f64,
}

impl Sums {
    fn plus(self, other: Self, factor: f64) -> Self {
        let visible = std::array::from_fn(|k| self.visible[k] + factor * other.visible[k]);
        Self { visible, all: self.all + factor * other.all }
    }

    fn seen(&self) -> f64 {
        self.visible.iter().sum()
    }
}

/// The quadrature of a planar cell by lines.
pub(crate) struct LineQuadrature<'a> {
    receiver: &'a ReceiverPoint,
    spans: &'a HiddenSpans<'a>,
    gauss: &'a UnitRule,
    /// Gauss points of the cell along a side.
    places: &'a [f64],
    /// Whether lines already run in the other direction.
    is_turned: bool,
    /// Whether the lines cross a whole area light, of which only a small part may be visible.
    is_of_lamp: bool,
    room: Vec<[f64; 2]>,
}

impl<'a> LineQuadrature<'a> {
    /// For the polygon of the projection plane of `spans`, seen from `receiver`.
    pub(crate) fn new(receiver: &'a ReceiverPoint, spans: &'a HiddenSpans<'a>) -> Self {
        let places = &UnitRule::of(2).nodes;
        let gauss = UnitRule::of(POINTS);
        Self { receiver, spans, gauss, places, is_turned: false, is_of_lamp: false, room: Vec::new() }
    }

    /// As [`LineQuadrature::new`], for the projection plane of a whole area light.
    pub(crate) fn of_lamp(receiver: &'a ReceiverPoint, spans: &'a HiddenSpans<'a>) -> Self {
        Self { is_of_lamp: true, ..Self::new(receiver, spans) }
    }

    /// The visible shares of the four points, each accurate to about `tolerance`; they sum to 1 without
    /// blockers.
    pub(crate) fn shares(&mut self, tolerance: f64) -> [f64; 4] {
        let sums = self.sums(tolerance);
        if sums.all > 0.0 { sums.visible.map(|visible| visible / sums.all) } else { [0.0; 4] }
    }

    /// Visible and unoccluded irradiance from exitance 1 on the part of the polygon that shines; the first is
    /// accurate to about `tolerance` times the second.
    pub(crate) fn irradiances(&mut self, tolerance: f64) -> [f64; 2] {
        let sums = self.sums(tolerance);
        let plane = self.spans.plane();
        let normal = plane.along.cross(plane.across);
        let factor = normal.dot(plane.origin - plane.eye).abs() / PI;
        [sums.seen(), sums.all].map(|sum| factor * sum)
    }

    fn sums(&mut self, tolerance: f64) -> Sums {
        let (low, high) = self.heights();
        let count = if self.is_of_lamp { LAMP_PANELS } else { PANELS };
        let step = (high - low) / count as f64;
        let lines: Vec<Sums> = (0..=2 * count).map(|k| self.line(low + 0.5 * step * k as f64)).collect();
        let varied = variation(&lines);
        let is_told = varied > 0.0 && varied <= ALONG;
        if !self.is_turned && !is_told {
            let spans = self.spans.transposed();
            let mut turned = LineQuadrature {
                is_turned: true,
                is_of_lamp: self.is_of_lamp,
                ..LineQuadrature::new(self.receiver, &spans)
            };
            let sums = turned.sums(tolerance);
            let [a, b, c, d] = sums.visible;
            return Sums { visible: [a, c, b, d], ..sums };
        }
        let panels = (0..count).map(|k| [lines[2 * k], lines[2 * k + 1], lines[2 * k + 2]]);
        let all: f64 = panels.clone().map(|panel| simpson(step, panel).all).sum();
        let mut sums = Sums { all, ..Sums::default() };
        if lines.iter().any(|line| line.seen() > 0.0) {
            sums.all = 0.0;
            for (k, panel) in panels.enumerate() {
                let start = low + step * k as f64;
                sums =
                    sums.plus(self.panel(start, step, panel, tolerance * all, MOST_HALVINGS_OF_PANEL), 1.0);
            }
        }
        sums
    }

    /// Range of t of the cell.
    fn heights(&self) -> (f64, f64) {
        let heights = || self.spans.plane().outline.iter().map(|[_, t]| *t);
        (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max))
    }

    /// Integral over a panel; a, b, c are the lines at its start, middle and end.
    fn panel(&mut self, low: f64, width: f64, [a, b, c]: [Sums; 3], error: f64, rest: usize) -> Sums {
        let whole = simpson(width, [a, b, c]);
        let half = 0.5 * width;
        let (left, right) = (self.line(low + 0.5 * half), self.line(low + 1.5 * half));
        let halves = [simpson(half, [a, left, b]), simpson(half, [b, right, c])];
        let sum = halves[0].plus(halves[1], 1.0);
        let difference = (sum.seen() - whole.seen()).abs().max((sum.all - whole.all).abs());
        if rest == 0 || BEND * difference <= error {
            return sum;
        }
        let left = self.panel(low, half, [a, left, b], error, rest - 1);
        left.plus(self.panel(low + half, half, [b, right, c], error, rest - 1), 1.0)
    }

    /// Integrals along one line.
    fn line(&mut self, t: f64) -> Sums {
        let mut sums = Sums::default();
        let Some(range) = self.range(t) else { return sums };
        let mut room = std::mem::take(&mut self.room);
        for lit in self.spans.lit(t, range) {
            sums.all += self.over(t, lit).iter().sum::<f64>();
            self.spans.visible(t, lit, &mut room);
            for part in &room {
                let weights = self.over(t, *part);
                sums.visible = std::array::from_fn(|k| sums.visible[k] + weights[k]);
            }
        }
        self.room = room;
        sums
    }

    /// The interval of line `t` within the cell and above the horizons.
    fn range(&self, t: f64) -> Option<[f64; 2]> {
        let plane = self.spans.plane();
        let (mut low, mut high) = crossed(&plane.outline, t)?;
        let ReceiverPoint { position, normal, ground, .. } = *self.receiver;
        for horizon in std::iter::once(normal).chain(ground) {
            let (start, slope) = ((plane.at(0.0, t) - position).dot(horizon), plane.along.dot(horizon));
            match slope {
                _ if slope > 0.0 => low = low.max(-start / slope),
                _ if slope < 0.0 => high = high.min(-start / slope),
                _ if start <= 0.0 => return None,
                _ => {}
            }
        }
        (low < high).then_some([low, high])
    }

    /// ∫ κ N_k ds, except for a constant factor.
    fn over(&self, t: f64, [low, high]: [f64; 2]) -> [f64; 4] {
        let ReceiverPoint { position, normal, .. } = *self.receiver;
        let plane = self.spans.plane();
        let across = shape(t, self.places);
        let mut sums = [0.0; 4];
        for (place, weight) in self.gauss.iter() {
            let s = low + (high - low) * place;
            let y: DVec3 = plane.at(s, t) - position;
            let kernel = weight * (high - low) * y.dot(normal).max(0.0) / y.length_squared().powi(2);
            let along = shape(s, self.places);
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum += kernel * along[k / 2] * across[k % 2];
            }
        }
        sums
    }
}

/// Largest difference between lines of the part that is visible.
fn variation(lines: &[Sums]) -> f64 {
    let parts = || lines.iter().filter(|line| line.all > 0.0).map(|line| line.seen() / line.all);
    parts().fold(f64::NEG_INFINITY, f64::max) - parts().fold(f64::INFINITY, f64::min)
}

/// The linear functions that are 1 at one of two places and 0 at the other.
fn shape(x: f64, places: &[f64]) -> [f64; 2] {
    let far = (x - places[0]) / (places[1] - places[0]);
    [1.0 - far, far]
}

fn simpson(width: f64, [a, b, c]: [Sums; 3]) -> Sums {
    Sums::default().plus(a, width / 6.0).plus(b, 4.0 * width / 6.0).plus(c, width / 6.0)
}

/// Range of s of a convex outline on line `t`.
fn crossed(outline: &[[f64; 2]], t: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for (k, [s, here]) in outline.iter().enumerate() {
        let [next_s, next] = outline[(k + 1) % outline.len()];
        let (below, above) = (here.min(next), here.max(next));
        if t < below || t > above {
            continue;
        }
        let place = if next == *here { 0.0 } else { (t - here) / (next - here) };
        for s in [s + (next_s - s) * place, if next == *here { next_s } else { *s + (next_s - s) * place }] {
            (low, high) = (low.min(s), high.max(s));
        }
    }
    (low < high).then_some((low, high))
}
