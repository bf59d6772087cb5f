//! Irradiance at a point through an outline of segments and arcs of circles.
//!
//! All light that x gets from a surface of exitance 1 comes through the outline of what x sees of it,
//!
//! ```text
//! E = 1/(2π) | ∮ n·(p × dp)/|p|² | ,     p from x along the outline, as far as n·p > 0 .
//! ```
//!
//! Where the outline dives below the horizon of the normal n, what is seen ends at the horizon, up to where
//! the outline comes up again. There n·(p × dp)/|p|² is the angle about n.
//!
//! A segment has Lambert's term ([`lambert::side`]). On an arc p = c + r (cos ψ a + sin ψ b), with a along
//! the part of c in the plane of the circle and m = a × b,
//!
//! ```text
//! n·(p × p′) = A + B cos ψ + C sin ψ ,    A = r² n_m ,  B = r (n_m c_a − c_m n_a) ,  C = −r c_m n_b ,
//! |p|² = P + Q cos ψ ,    P = ½ (far + near) ,  Q = ½ (far − near) = 2 r c_a ,   far, near = (c_a ± r)² + c_m² ,
//! ∫ = (A − B) J + B (Δψ − near J)/Q + C/Q · ln(|p₀|²/|p₁|²) ,
//! J = 2/√(near far) · Δ atan(√(near/far) tan ½ψ) .
//! ```
//!
//! No digits cancel however near x is to the circle; near its axis, where Q is small, the integrand has no
//! peak and goes by points, and on it by ∫ (A + B cos ψ + C sin ψ)/P. 0 ≤ E ≤ 1.
//!
//! Reference: P. Moon, *The scientific basis of illuminating engineering* (1936), for the contour integral.

use std::f64::consts::{PI, TAU};

use radiosity_core::gauss::{Legendre, Rule};
use radiosity_geom::{COINCIDENT, DVec2, DVec3, ROUNDING};
use smallvec::SmallVec;

use crate::irradiance::lambert;

/// Q/P up to which an arc goes by points.
const NEARLY_EVEN: f64 = 0.05;
/// Points of a turn for these: poles at cos ψ = −P/Q leave less than rounding.
const POINTS: usize = 32;

/// Half the angle (rad) of an arc that only touches a plane: it goes beyond by half its square, 5e-13 radii.
const TOUCHING: f64 = 1e-6;

/// A part of an outline, relative to the point that sees it.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// A straight one, from the first to the second.
    Segment([DVec3; 2]),
    /// One of a circle.
    Arc(Arc),
}

/// An arc of a circle, center + cos ψ · a + sin ψ · b with a and b of `axes`.
#[derive(Clone, Copy, Debug)]
pub struct Arc {
    /// Centre of the circle.
    pub center: DVec3,
    /// Two radii at a right angle.
    pub axes: [DVec3; 2],
    /// ψ at its ends, a turn apart at most.
    pub angles: [f64; 2],
}

/// Irradiance from what lies within a closed outline, above the horizon of the unit normal `n`; negative
/// where the outline runs clockwise as seen against its front. The pieces follow each other end to end.
pub fn within(n: DVec3, pieces: &[Piece]) -> f64 {
    let mut sum = Sum { n, ends: None, value: 0.0 };
    for piece in pieces {
        match piece {
            Piece::Segment(ends) => sum.segment(*ends),
            Piece::Arc(arc) => sum.arc(arc),
        }
    }
    if let Some([first, last]) = sum.ends {
        sum.value += between(n, last, first);
    }
    sum.value / TAU
}

/// n·(p × dp)/|p|² along a segment.
pub(super) fn between(n: DVec3, from: DVec3, to: DVec3) -> f64 {
    lambert::side(n, from.normalize_or_zero(), to.normalize_or_zero())
}

/// The sum over pieces so far.
struct Sum {
    n: DVec3,
    /// Where the parts above the horizon begin, and where the last one ends.
    ends: Option<[DVec3; 2]>,
    value: f64,
}

impl Sum {
    /// Adds a part above the horizon, and the way along the horizon to where it starts.
    fn part(&mut self, [from, to]: [DVec3; 2], value: f64) {
        let first = match self.ends {
            Some([first, last]) => {
                self.value += between(self.n, last, from);
                first
            }
            None => from,
        };
        self.value += value;
        self.ends = Some([first, to]);
    }

    fn segment(&mut self, [a, b]: [DVec3; 2]) {
        let [low, high] = [a, b].map(|end| self.n.dot(end));
        let horizon = || a + (b - a) * (low / (low - high));
        let ends = match [low >= 0.0, high >= 0.0] {
            [true, true] => [a, b],
            [true, false] => [a, horizon()],
            [false, true] => [horizon(), b],
            [false, false] => return,
        };
        self.part(ends, between(self.n, ends[0], ends[1]));
    }

    fn arc(&mut self, arc: &Arc) {
        let [first, last] = arc.angles;
        let mut parts = arc.above(self.n);
        if first > last {
            parts.reverse();
        }
        for [low, high] in parts {
            let angles = if first > last { [high, low] } else { [low, high] };
            self.part(angles.map(|angle| arc.at(angle)), arc.integral(self.n, angles));
        }
    }
}

impl Piece {
    /// The place after a part of it.
    pub(super) fn at(&self, part: f64) -> DVec3 {
        match self {
            Self::Segment([from, to]) => from.lerp(*to, part),
            Self::Arc(arc) => arc.at(arc.angle(part)),
        }
    }

    /// A direction to the midst of it.
    pub(super) fn amid(&self) -> DVec3 {
        match self {
            Self::Segment([from, to]) => from.normalize_or_zero() + to.normalize_or_zero(),
            Self::Arc(_) => self.at(0.5),
        }
    }

    /// The part of it over a range of 0 to 1.
    pub(super) fn part(&self, range: [f64; 2]) -> Self {
        match self {
            Self::Segment(_) => Self::Segment(range.map(|part| self.at(part))),
            Self::Arc(arc) => Self::Arc(Arc { angles: range.map(|part| arc.angle(part)), ..*arc }),
        }
    }

    /// Where it passes a plane through the point with a unit normal, as parts of it: also its ends where they
    /// lie in the plane within rounding, and not where it only touches.
    pub(super) fn crossings(&self, normal: DVec3) -> SmallVec<[f64; 4]> {
        let [low, high] = [0.0, 1.0].map(|end| {
            let place = self.at(end);
            (normal.dot(place), COINCIDENT * place.length())
        });
        let ends = [(low, 0.0), (high, 1.0)];
        let level = ends.into_iter().filter(|((height, least), _)| height.abs() <= *least);
        let mut found: SmallVec<[f64; 4]> = level.map(|(_, part)| part).collect();
        match self {
            Self::Segment(_) if (low.0 > 0.0) != (high.0 > 0.0) => found.push(low.0 / (low.0 - high.0)),
            Self::Segment(_) => {}
            Self::Arc(arc) => found.extend(arc.crossings(normal)),
        }
        found
    }

    /// ∫ n·(p × dp)/|p|² along it, above the horizon.
    pub(super) fn integral(&self, n: DVec3) -> f64 {
        match self {
            Self::Segment([from, to]) => between(n, *from, *to),
            Self::Arc(arc) => arc.integral(n, arc.angles),
        }
    }
}

impl Arc {
    /// Where it begins, and where it ends.
    pub(super) fn ends(&self) -> [DVec3; 2] {
        self.angles.map(|angle| self.at(angle))
    }

    fn at(&self, angle: f64) -> DVec3 {
        let (sin, cos) = angle.sin_cos();
        self.center + cos * self.axes[0] + sin * self.axes[1]
    }

    /// Control points in homogeneous coordinates, as a rational curve of degree 2, of the part of it from so far
    /// before an angle to as far behind it.
    pub(super) fn controls(&self, middle: f64, half: f64) -> [DVec3; 3] {
        let amid = half.cos() * self.center + (self.at(middle) - self.center);
        [self.at(middle - half), amid, self.at(middle + half)]
    }

    /// ψ after a part of it.
    fn angle(&self, part: f64) -> f64 {
        self.angles[0] + part * (self.angles[1] - self.angles[0])
    }

    /// Where it passes a plane through the point, as parts of it.
    fn crossings(&self, normal: DVec3) -> impl Iterator<Item = f64> {
        let [first, last] = self.angles;
        let low = first.min(last);
        let swing = DVec2::from_array(self.axes.map(|axis| normal.dot(axis)));
        let (middle, half) = (swing.y.atan2(swing.x), (-normal.dot(self.center) / swing.length()).acos());
        let roots = [middle - half, middle + half].map(|root| root + TAU * ((low - root) / TAU).ceil());
        let parts = roots.map(|root| (root - first) / (last - first));
        // NaN where it never meets the plane.
        let passes = half > TOUCHING && half < PI - TOUCHING;
        parts.into_iter().filter(move |part| passes && *part > 0.0 && *part < 1.0)
    }

    /// The ranges of its angles above a horizon, in order.
    fn above(&self, n: DVec3) -> Vec<[f64; 2]> {
        let [first, last] = self.angles;
        let (low, high) = (first.min(last), first.max(last));
        let swing = DVec2::from_array(self.axes.map(|axis| n.dot(axis)));
        let (level, reach) = (n.dot(self.center), swing.length());
        match level {
            _ if level >= reach => return vec![[low, high]],
            _ if level <= -reach => return Vec::new(),
            _ => {}
        }
        let (middle, half) = (swing.y.atan2(swing.x), (-level / reach).acos());
        let turns =
            ((low - middle - half) / TAU).ceil() as i32..=((high - middle + half) / TAU).floor() as i32;
        let part = |turn: i32| {
            let about = middle + TAU * f64::from(turn);
            [(about - half).max(low), (about + half).min(high)]
        };
        turns.map(part).filter(|[from, to]| from < to).collect()
    }

    /// ∫ n·(p × p′)/|p|² dψ.
    fn integral(&self, n: DVec3, angles: [f64; 2]) -> f64 {
        let radius = self.axes[0].length();
        let units = self.axes.map(|axis| axis / radius);
        let level = DVec2::from_array(units.map(|unit| self.center.dot(unit)));
        let turned = level.y.atan2(level.x);
        let (sin, cos) = turned.sin_cos();
        let (a, b) = (cos * units[0] + sin * units[1], cos * units[1] - sin * units[0]);
        let m = a.cross(b);
        let (along, over) = (level.length(), self.center.dot(m));
        let (n_a, n_b, n_m) = (n.dot(a), n.dot(b), n.dot(m));
        let ratio = Ratio {
            even: radius * radius * n_m,
            cosine: radius * (n_m * along - over * n_a),
            sine: -radius * over * n_b,
            // A − B, in which digits would cancel.
            rest: radius * (n_m * (radius - along) + over * n_a),
            near: (along - radius).powi(2) + over * over,
            far: (along + radius).powi(2) + over * over,
            swing: 2.0 * radius * along,
        };
        ratio.integral(angles.map(|angle| angle - turned))
    }
}

/// (A + B cos ψ + C sin ψ)/(P + Q cos ψ).
struct Ratio {
    even: f64,
    cosine: f64,
    sine: f64,
    rest: f64,
    near: f64,
    far: f64,
    swing: f64,
}

impl Ratio {
    fn integral(&self, angles @ [first, last]: [f64; 2]) -> f64 {
        if self.swing <= ROUNDING * self.near {
            let ([from, to], [start, end]) = ([first.sin(), last.sin()], [first.cos(), last.cos()]);
            return (self.even * (last - first) + self.cosine * (to - from) - self.sine * (end - start))
                / self.near;
        }
        if self.swing <= NEARLY_EVEN * self.near {
            const RULE: Rule<POINTS> = Legendre::<POINTS>::RULE;
            let half = 0.5 * (last - first);
            return half * RULE.sum(|node| self.at(first + half * (1.0 + node)));
        }
        let [low, high] = angles.map(|angle| self.half_turned(angle));
        let peak = 2.0 / (self.near * self.far).sqrt() * (high - low);
        let even = (last - first - self.near * peak) / self.swing;
        // cos ψ₀ − cos ψ₁, and the logarithm over it.
        let step = 2.0 * (0.5 * (first + last)).sin() * (0.5 * (last - first)).sin();
        let share = step / self.square(last);
        let grown = self.swing * share;
        let log = if grown.abs() > 1e-8 { grown.ln_1p() / grown } else { 1.0 - 0.5 * grown };
        self.rest * peak + self.cosine * even + self.sine * share * log
    }

    fn at(&self, angle: f64) -> f64 {
        let (sin, cos) = angle.sin_cos();
        (self.even + self.cosine * cos + self.sine * sin) / self.square(angle)
    }

    /// |p|².
    fn square(&self, angle: f64) -> f64 {
        self.near + 2.0 * self.swing * (0.5 * angle).cos().powi(2)
    }

    /// atan(√(near/far) tan ½ψ), on through whole turns.
    fn half_turned(&self, angle: f64) -> f64 {
        let turns = (angle / TAU).round();
        let (sin, cos) = (0.5 * (angle - turns * TAU)).sin_cos();
        ((self.near / self.far).sqrt() * sin).atan2(cos) + turns * PI
    }
}
