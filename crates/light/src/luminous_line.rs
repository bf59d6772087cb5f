//! Light of a luminaire that is an even line, at a point.
//!
//! ```text
//! E(x) = s ½ ∫ d(ω) cos θ V / r² dt ,   −1 ≤ t ≤ 1        W m⁻²
//! ```
//!
//! over the points p + t h of the line, with the relative intensity d of the luminaire and its strength s,
//! the distance r of x from the point and the direction ω towards x. Halving Gauss rules integrate it to
//! [`ACCURACY`] of itself. Where rays to points evenly spaced by their angle differ in V, bisection finds the
//! border between; what hides a part of the line between two neighbours alone is missed: at most about
//! 1/[`RAYS`] of its light.

use std::f64::consts::FRAC_PI_2;

use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;
use radiosity_scene::Luminaire;
use radiosity_visibility::Visibility;
use smallvec::{SmallVec, smallvec};

use crate::receiver_point::ReceiverPoint;
use crate::tolerances::MOST_HALVINGS_OF_LINE;

/// Accuracy of the integral, relative to itself: that of direct light, which is coarser, is left to its
/// shadows. The integrand is smooth, so that a few more halvings reach it.
const ACCURACY: f64 = 1e-6;

/// Points of a Gauss rule. Fewer are halved more often, more are more than a smooth part needs.
const POINTS: usize = 8;

/// Rays to a line, between which a blocker that hides less than 1/32 of it may be missed. More take time in
/// proportion.
const RAYS: usize = 32;

/// Halvings of the step between two rays: a border is then right to 1/(32 · 2¹⁴) = 2e-6 of the line's angle.
const HALVINGS: usize = 14;

/// Distance from a line's axis over half its length below which all angles to it are one, to nine digits.
const ON_AXIS: f64 = 1e-9;

/// d cos θ / r² of the light that a luminaire sends from a point of it; 0 below the horizon of the receiver.
pub(super) fn irradiance(luminaire: &Luminaire, from: DVec3, receiver: &ReceiverPoint) -> f64 {
    let step = from - receiver.position;
    let square = step.length_squared();
    let direction = step / square.sqrt();
    let cosine = receiver.normal.dot(direction);
    if cosine > 0.0 && square > 0.0 { luminaire.relative(-direction) * cosine / square } else { 0.0 }
}

/// A luminaire that is a line, as a point sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct LuminousLine<'a> {
    luminaire: &'a Luminaire,
    receiver: &'a ReceiverPoint,
    half: DVec3,
    /// Place t of the foot of the perpendicular from the point, and its length over half the line's.
    foot: f64,
    away: f64,
}

/// A part of the line, by its ends t.
type Span = [f64; 2];

impl<'a> LuminousLine<'a> {
    pub(super) fn new(luminaire: &'a Luminaire, half: DVec3, receiver: &'a ReceiverPoint) -> Self {
        let step = receiver.position - luminaire.position;
        let (length, along) = (half.length(), step.dot(half) / half.length_squared());
        let away = (step - along * half).length() / length;
        Self { luminaire, receiver, half, foot: along, away }
    }

    /// E over the strength.
    pub(super) fn irradiance(&self, visibility: &Visibility) -> f64 {
        let Some(above) = self.above() else { return 0.0 };
        let seen = if visibility.casts() { self.seen(above, visibility) } else { smallvec![above] };
        let parts: SmallVec<[Span; 4]> = seen.into_iter().flat_map(|span| self.cut_at_foot(span)).collect();
        let rough: SmallVec<[f64; 4]> = parts.iter().map(|span| self.by_rule(*span)).collect();
        let tolerance = ACCURACY * rough.iter().sum::<f64>();
        parts
            .iter()
            .zip(rough)
            .map(|(span, rough)| self.integral(*span, rough, tolerance, MOST_HALVINGS_OF_LINE))
            .sum()
    }

    fn at(&self, t: f64) -> DVec3 {
        self.luminaire.position + t * self.half
    }

    /// ½ d cos θ / r².
    fn density(&self, t: f64) -> f64 {
        0.5 * irradiance(self.luminaire, self.at(t), self.receiver)
    }

    /// The part above the horizons of the point.
    fn above(&self) -> Option<Span> {
        let mut span = [-1.0, 1.0];
        for horizon in [Some(self.receiver.normal), self.receiver.ground].into_iter().flatten() {
            let [low, high] = span.map(|t: f64| (self.at(t) - self.receiver.position).dot(horizon));
            let crossing = || span[0] + (span[1] - span[0]) * low / (low - high);
            span = match (low > 0.0, high > 0.0) {
                (true, true) => span,
                (true, false) => [span[0], crossing()],
                (false, true) => [crossing(), span[1]],
                (false, false) => return None,
            };
        }
        Some(span)
    }

    /// The place at a part `s` of the angle from one end of a span to the other.
    fn place(&self, [low, high]: Span, s: f64) -> f64 {
        if self.away < ON_AXIS {
            return low + s * (high - low);
        }
        let angle = |t: f64| (t - self.foot).atan2(self.away);
        let angle = angle(low) + s * (angle(high) - angle(low));
        (self.foot + self.away * angle.clamp(-FRAC_PI_2, FRAC_PI_2).tan()).clamp(low, high)
    }

    /// The parts of a span that the point sees.
    fn seen(&self, span: Span, visibility: &Visibility) -> SmallVec<[Span; 2]> {
        let is_seen = |s: f64| {
            visibility.is_free(self.receiver.surface, self.receiver.position, self.at(self.place(span, s)))
        };
        let ray = |k: usize| (k as f64 + 0.5) / RAYS as f64;
        let mut spans = SmallVec::new();
        let mut start = is_seen(ray(0)).then_some(span[0]);
        for k in 1..RAYS {
            if is_seen(ray(k)) == start.is_some() {
                continue;
            }
            let border = self.place(span, border([ray(k - 1), ray(k)], start.is_some(), is_seen));
            match start.take() {
                Some(start) => spans.push([start, border]),
                None => start = Some(border),
            }
        }
        spans.extend(start.map(|start| [start, span[1]]));
        spans
    }

    fn cut_at_foot(&self, [low, high]: Span) -> SmallVec<[Span; 2]> {
        match low < self.foot && self.foot < high {
            true => smallvec![[low, self.foot], [self.foot, high]],
            false => smallvec![[low, high]],
        }
    }

    fn by_rule(&self, [low, high]: Span) -> f64 {
        let value = |(s, weight): (f64, f64)| weight * self.density(low + s * (high - low));
        (high - low) * UnitRule::of(POINTS).iter().map(value).sum::<f64>()
    }

    /// The integral over a span of which a rule says `rough`.
    fn integral(&self, [low, high]: Span, rough: f64, tolerance: f64, depth: u32) -> f64 {
        let middle = 0.5 * (low + high);
        let halves = [[low, middle], [middle, high]].map(|span| (span, self.by_rule(span)));
        let sum = halves[0].1 + halves[1].1;
        if (sum - rough).abs() <= tolerance || depth == 0 {
            return sum;
        }
        halves.into_iter().map(|(span, rough)| self.integral(span, rough, 0.5 * tolerance, depth - 1)).sum()
    }
}

/// Where between two places what is seen at one, as `before` says, is not at the other, or the other way
/// round.
fn border([mut low, mut high]: Span, before: bool, is_seen: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if is_seen(middle) == before { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
