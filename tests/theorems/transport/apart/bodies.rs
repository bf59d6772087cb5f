//! Plates, disks, rings, balls, cylinders and cones, and what two of them apart exchange, by iterated
//! quadrature:
//!
//! ```text
//! A F = ∫ E(x) dA ,     E(x) = −1/2π ∮ n·(r × dr) / r²
//! ```
//!
//! over the outline of what x sees of the other body above its own horizon: sides and arcs. That of a ball is
//! the circle where tangents from x touch it. Of a cylinder or a cone, E is integrated along what x sees of
//! each line from the base to the top.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::elements::rule::UnitRule;
use radiosity_geom::{DVec3, Surface, clip_polygon};
use radiosity_test_support::random::Random;
use radiosity_test_support::shapes::ball;

use crate::transport::turned::{Ring, Tube, irradiance, normal, polygon_surface};

/// A body, its front outside.
#[derive(Clone, Debug)]
pub(crate) enum Body {
    /// A triangle or a parallelogram.
    Plate(Vec<DVec3>),
    Ring(Ring),
    Tube(Tube),
    Ball {
        center: DVec3,
        radius: f64,
    },
}

/// Kinds of bodies by which random ones are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Rectangle,
    Triangle,
    Disk,
    Ring,
    Cylinder,
    Cone,
    Ball,
}

pub(crate) const KINDS: [Kind; 7] =
    [Kind::Rectangle, Kind::Triangle, Kind::Disk, Kind::Ring, Kind::Cylinder, Kind::Cone, Kind::Ball];

/// A point of a body, with its normal and the area per unit of both parameters.
#[derive(Clone, Copy, Debug)]
struct Place {
    at: DVec3,
    normal: DVec3,
    area: f64,
}

/// Points of the rules that are compared.
const POINTS: usize = 10;
/// Most halvings of a line.
const DEEPEST: usize = 24;
/// Longest part of a line that is dark where all points are: something narrower may be seen between them.
const BLANK: f64 = 0.02;
/// Errors allowed of lines over the outer body, and of what a point sees of a cylinder.
const INNER: f64 = 0.2;
/// Points for parts of an arc or a line as long as twice their distance.
const FIXED: usize = 16;

impl Body {
    /// A body of this kind in a ball of this radius.
    pub(crate) fn random(kind: Kind, center: DVec3, reach: f64, random: &mut Random) -> Self {
        let up = random.direction();
        let x = up.any_orthonormal_vector();
        let on_circle = |angle: f64| center + reach * (angle.cos() * x + angle.sin() * up.cross(x));
        match kind {
            Kind::Rectangle => {
                let (start, half) = (random.between(0.0, TAU), random.between(0.1, 0.9));
                let angles = [half, PI - half, PI + half, -half];
                Self::Plate(angles.map(|angle| on_circle(start + angle)).to_vec())
            }
            Kind::Triangle => {
                let angles = [0.0, 1.0, 2.0].map(|third| TAU / 3.0 * (third + 0.7 * random.unit()));
                Self::Plate(angles.map(on_circle).to_vec())
            }
            Kind::Disk => Self::Ring(Ring { center, normal: up, radius: reach, inner: 0.0 }),
            Kind::Ring => Self::Ring(Ring {
                center,
                normal: up,
                radius: reach,
                inner: reach * random.between(0.1, 0.9),
            }),
            Kind::Cylinder | Kind::Cone => {
                let (sin, cos) = random.between(0.2, 1.3).sin_cos();
                let [low, high] = [1.0, if kind == Kind::Cone { random.pick(&[0.0, 0.3, 0.7]) } else { 1.0 }];
                let radii = [low, high].map(|share| share * reach * cos);
                Self::Tube(Tube { base: center - reach * sin * up, axis: 2.0 * reach * sin * up, radii })
            }
            Kind::Ball => Self::Ball { center, radius: reach },
        }
    }

    pub(crate) fn surface(&self) -> Arc<dyn Surface> {
        match self {
            Self::Plate(corners) => polygon_surface(corners),
            Self::Ring(ring) => ring.surface(),
            Self::Tube(tube) => tube.surface(),
            Self::Ball { center, radius } => Arc::new(ball(*center, *radius)),
        }
    }

    pub(crate) fn area(&self) -> f64 {
        match self {
            Self::Plate(_) => {
                let line =
                    |t: f64| UnitRule::of(2).iter().map(|(s, w)| w * self.place(s, t).area).sum::<f64>();
                line(0.5)
            }
            Self::Ring(ring) => ring.area(),
            Self::Tube(tube) => tube.area(),
            Self::Ball { radius, .. } => 2.0 * TAU * radius * radius,
        }
    }

    /// The point of parameters around, or along a side, and across, both in [0, 1].
    fn place(&self, around: f64, across: f64) -> Place {
        let (sin, cos) = (TAU * around).sin_cos();
        match self {
            Self::Plate(corners) => {
                let [a, b, c] = [corners[0], corners[1], corners[2]];
                if corners.len() == 3 {
                    let at = a + across * (b - a + around * (c - b));
                    return Place {
                        at,
                        normal: normal(corners),
                        area: across * (b - a).cross(c - b).length(),
                    };
                }
                let d = corners[3];
                let at = a + around * (b - a) + across * (d - a);
                Place { at, normal: normal(corners), area: (b - a).cross(d - a).length() }
            }
            Self::Ring(ring) => {
                let x = ring.normal.any_orthonormal_vector();
                let r = ring.inner + (ring.radius - ring.inner) * across;
                let at = ring.center + r * (cos * x + sin * ring.normal.cross(x));
                Place { at, normal: ring.normal, area: TAU * r * (ring.radius - ring.inner) }
            }
            Self::Tube(tube) => {
                let line = Line::of(tube, TAU * around);
                let area = TAU * line.radius(across) * line.edge.length();
                Place { at: line.start + across * line.edge, normal: line.normal, area }
            }
            Self::Ball { center, radius } => {
                let z = 2.0 * across - 1.0;
                let out = (1.0 - z * z).max(0.0).sqrt();
                let normal = DVec3::new(out * cos, out * sin, z);
                Place { at: *center + *radius * normal, normal, area: 2.0 * TAU * radius * radius }
            }
        }
    }

    /// Irradiance of a place from the body, of exitance 1; `tolerance` is that of sums over lines.
    fn irradiance(&self, x: &Place, tolerance: f64) -> f64 {
        match self {
            Self::Plate(corners) => {
                if normal(corners).dot(x.at - corners[0]) <= 0.0 {
                    return 0.0;
                }
                let seen = clip_polygon(corners, x.at, x.normal);
                if seen.len() > 2 { irradiance(x.at, x.normal, &seen) } else { 0.0 }
            }
            Self::Ring(ring) => {
                let whole = Circle { center: ring.center, normal: ring.normal, radius: ring.radius };
                let hole = Circle { radius: ring.inner, ..whole };
                whole.irradiance(x) - if ring.inner > 0.0 { hole.irradiance(x) } else { 0.0 }
            }
            Self::Tube(tube) => irradiance_of_tube(tube, x, tolerance),
            Self::Ball { center, radius } => {
                let away = x.at - *center;
                let normal = away.normalize();
                let share = radius / away.length();
                let circle = Circle {
                    center: *center + share * *radius * normal,
                    normal,
                    radius: radius * (1.0 - share * share).sqrt(),
                };
                circle.irradiance(x)
            }
        }
    }

    /// A rough value of ∫ E dA over this body.
    pub(crate) fn rough_exchange(&self, other: &Self) -> f64 {
        let rule = UnitRule::of(6);
        let nodes = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
        nodes
            .map(|((s, ws), (t, wt))| {
                let x = self.place(s, t);
                ws * wt * x.area * other.irradiance(&x, 1e-3)
            })
            .sum()
    }

    /// ∫ E dA over this body of what it sees of the other one, to an error of about `tolerance`.
    pub(crate) fn exchange(&self, other: &Self, tolerance: f64) -> f64 {
        let line = |across: f64| {
            let at = |around: f64| {
                let x = self.place(around, across);
                if x.area == 0.0 {
                    0.0
                } else {
                    x.area * other.irradiance(&x, INNER * INNER * tolerance / x.area)
                }
            };
            let halves = [0.0, 0.5].map(|start| adaptive(&at, [start, start + 0.5], INNER * tolerance));
            halves.iter().sum::<f64>()
        };
        adaptive(&line, [0.0, 1.0], tolerance)
    }
}

/// ∫ f over a range: the rule on halves is compared with that on the whole.
fn adaptive(f: &dyn Fn(f64) -> f64, ends: [f64; 2], tolerance: f64) -> f64 {
    refined(f, ends, by_rule(f, ends), tolerance, DEEPEST)
}

fn refined(f: &dyn Fn(f64) -> f64, [low, high]: [f64; 2], whole: f64, tolerance: f64, deepest: usize) -> f64 {
    let middle = 0.5 * (low + high);
    let halves = [[low, middle], [middle, high]].map(|ends| (ends, by_rule(f, ends)));
    let sum = halves.iter().map(|(_, value)| value).sum::<f64>();
    let may_hide = sum == 0.0 && whole == 0.0 && high - low > BLANK;
    if deepest == 0 || (sum - whole).abs() <= tolerance && !may_hide {
        return sum;
    }
    halves.into_iter().map(|(ends, value)| refined(f, ends, value, 0.7 * tolerance, deepest - 1)).sum()
}

fn by_rule(f: &dyn Fn(f64) -> f64, [low, high]: [f64; 2]) -> f64 {
    UnitRule::of(POINTS).iter().map(|(s, w)| w * (high - low) * f(low + (high - low) * s)).sum()
}

/// ∫ f over [0, `length`] by rules of a fixed number of points on equal parts, none longer than twice `distance`.
fn composite(length: f64, distance: f64, f: impl Fn(f64) -> f64) -> f64 {
    let parts = (0.5 * length / distance.max(1e-4 * length)).ceil().max(1.0);
    let part = length / parts;
    let rule = UnitRule::of(FIXED);
    (0..parts as usize)
        .map(|k| rule.iter().map(|(s, w)| w * part * f((k as f64 + s) * part)).sum::<f64>())
        .sum()
}

/// A disk by its border.
#[derive(Clone, Copy, Debug)]
struct Circle {
    center: DVec3,
    normal: DVec3,
    radius: f64,
}

impl Circle {
    fn irradiance(&self, x: &Place) -> f64 {
        let Self { center, normal, radius } = *self;
        let height = normal.dot(x.at - center);
        if height <= 0.0 {
            return 0.0;
        }
        let a = normal.any_orthonormal_vector();
        let b = normal.cross(a);
        // Heights over the horizon: middle + reach cos(angle − top).
        let (middle, up) = (x.normal.dot(center - x.at), [a, b].map(|axis| radius * x.normal.dot(axis)));
        let (reach, top) = (up[0].hypot(up[1]), up[1].atan2(up[0]));
        if middle <= -reach {
            return 0.0;
        }
        let half = if middle >= reach { PI } else { (-middle / reach).acos() };
        let at = |angle: f64| radius * (angle.cos() * a + angle.sin() * b) + center - x.at;
        let beside = (x.at - center - height * normal).length() - radius;
        let arc = composite(2.0 * half * radius, height.hypot(beside), |length| {
            let angle = top - half + length / radius;
            let (r, along) = (at(angle), angle.cos() * b - angle.sin() * a);
            x.normal.dot(r.cross(along)) / r.length_squared()
        });
        let (end, start) = (at(top + half), at(top - half));
        let cross = end.cross(start);
        let chord = if half < PI {
            cross.length().atan2(end.dot(start)) * x.normal.dot(cross.normalize_or_zero())
        } else {
            0.0
        };
        -(arc + chord) / TAU
    }
}

/// A line of a cylinder or a cone from its base to its top.
#[derive(Clone, Copy, Debug)]
struct Line {
    start: DVec3,
    edge: DVec3,
    normal: DVec3,
    radii: [f64; 2],
}

impl Line {
    fn of(Tube { base, axis, radii: radii @ [low, high] }: &Tube, angle: f64) -> Self {
        let up = axis.normalize();
        let x = up.any_orthonormal_vector();
        let out = angle.cos() * x + angle.sin() * up.cross(x);
        let slope = (low - high) / axis.length();
        Self {
            start: *base + *low * out,
            edge: *axis + (high - low) * out,
            normal: (out + slope * up).normalize(),
            radii: *radii,
        }
    }

    fn radius(&self, along: f64) -> f64 {
        self.radii[0] + (self.radii[1] - self.radii[0]) * along
    }

    /// ∫ κ ρ dl over what a point sees of it, ρ the radius.
    fn seen(&self, x: &Place) -> f64 {
        let rise = self.normal.dot(x.at - self.start);
        let [low, high] = [0.0, 1.0].map(|t| x.normal.dot(self.start + t * self.edge - x.at));
        if rise <= 0.0 || low <= 0.0 && high <= 0.0 {
            return 0.0;
        }
        let root = low / (low - high);
        let [from, to] = [if low < 0.0 { root } else { 0.0 }, if high < 0.0 { root } else { 1.0 }];
        let length = self.edge.length();
        let foot = ((x.at - self.start).dot(self.edge) / (length * length)).clamp(from, to);
        let distance = (self.start + foot * self.edge - x.at).length();
        composite((to - from) * length, distance, |place| {
            let t = from + place / length;
            let r = self.start + t * self.edge - x.at;
            let square = r.length_squared();
            self.radius(t) * rise * x.normal.dot(r) / (PI * square * square)
        })
    }
}

/// Sums over the lines of a tube that face a point, parted where its horizon passes their ends.
fn irradiance_of_tube(tube: &Tube, x: &Place, tolerance: f64) -> f64 {
    let Tube { base, axis, radii: [low, high] } = tube;
    let up = axis.normalize();
    let (a, away) = (up.any_orthonormal_vector(), x.at - *base);
    let b = up.cross(a);
    let slope = (low - high) / axis.length();
    let [along, across] = [a, b].map(|axis| away.dot(axis));
    let (reach, middle) = (along.hypot(across), across.atan2(along));
    let least = (low - slope * up.dot(away)) / reach;
    if least >= 1.0 {
        return 0.0;
    }
    let half = if least <= -1.0 { PI } else { least.acos() };
    let mut breaks = vec![middle - half, middle, middle + half];
    for (end, radius) in [(*base, *low), (*base + *axis, *high)] {
        let height = x.normal.dot(end - x.at);
        let rise = [a, b].map(|axis| radius * x.normal.dot(axis));
        let (swing, top) = (rise[0].hypot(rise[1]), rise[1].atan2(rise[0]));
        if height.abs() < swing {
            let off = (-height / swing).acos();
            let places = [top - off, top + off]
                .into_iter()
                .flat_map(|place| [-TAU, 0.0, TAU].map(|turn| place + turn));
            breaks.extend(places.filter(|place| (place - middle).abs() < half));
        }
    }
    breaks.sort_by(f64::total_cmp);
    let seen = |angle: f64| Line::of(tube, angle).seen(x);
    breaks
        .windows(2)
        .filter(|ends| ends[1] - ends[0] > 1e-13)
        .map(|ends| adaptive(&seen, [ends[0], ends[1]], tolerance))
        .sum()
}
