//! Two points with their normals: the kernel between them, its series along a motion, and what bounds its
//! terms.

use core::f64::consts::FRAC_1_PI;

use radiosity_geom::{DVec3, Motion};

use super::motion::RelativeMotion;
use super::power_series::quotient;
use super::remainder::{gegenbauer_bound, tail};

/// Least |r(π)|/r in bounds: below it nothing of a numerator of degree 4 is divided.
const LEAST_RATE: f64 = 1e-3;

/// A point of the receiver and one of the emitter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointPair {
    /// x, a point of the receiver.
    pub receiver: DVec3,
    /// r = y − x (scene length), from the receiver to the emitter; not zero.
    pub offset: DVec3,
    /// Unit normal n_x of the receiver's front.
    pub receiver_normal: DVec3,
    /// Unit normal n_y of the emitter's front.
    pub emitter_normal: DVec3,
}

/// (N₀ + N₁t + …)/(1 + A t + B t²)², M terms above: the kernel of a pair of points along a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quotient<const M: usize> {
    /// N₀, N₁, …; κ(0) first.
    pub numerator: [f64; M],
    /// A.
    pub a: f64,
    /// B ≥ A²/4.
    pub b: f64,
}

/// Quadratic polynomials of the variable t, each from its constant term on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heights {
    /// Of the emitter's point over the receiver's plane, times 1 + t² where it turns.
    pub arriving: [f64; 3],
    /// Of the receiver's point over the emitter's plane, times −1 − t² where it turns.
    pub leaving: [f64; 3],
}

impl PointPair {
    /// κ of the pair with the emitter at `place`, negative where one side faces away and positive where both
    /// do.
    pub fn kernel(&self, place: &Motion) -> f64 {
        let r = place.point(self.receiver + self.offset) - self.receiver;
        let r2 = r.length_squared();
        -FRAC_1_PI * place.direction(self.emitter_normal).dot(r) * self.receiver_normal.dot(r) / (r2 * r2)
    }

    /// Writes φ_0 … φ_{m−1}, m = `out.len()`, along `motion`.
    pub fn series(&self, motion: &RelativeMotion, out: &mut [f64]) {
        let r2 = self.offset.length_squared();
        match *motion {
            RelativeMotion::Translation(direction) => self.translated(direction, r2).write(out),
            RelativeMotion::Rotation { axis, centre } => self.turned(axis, centre, r2).write(out),
        }
    }

    /// Bound of what the powers above t^N, N = `orders`, add to κ at p along `motion`; infinite where the
    /// series diverges.
    pub fn remainder(&self, motion: &RelativeMotion, orders: usize, p: f64) -> f64 {
        let (r2, step) = (self.offset.length_squared(), motion.variable(p).abs());
        match *motion {
            RelativeMotion::Translation(direction) => self.translated(direction, r2).remainder(orders, step),
            RelativeMotion::Rotation { axis, centre } => {
                self.turned(axis, centre, r2).remainder(orders, step)
            }
        }
    }

    /// n_x·r′ and n_y·r′ along `motion`.
    #[inline(always)]
    pub(super) fn heights(&self, motion: &RelativeMotion) -> Heights {
        let [x, y] = [self.receiver_normal, self.emitter_normal];
        let (arriving, leaving) = (x.dot(self.offset), y.dot(self.offset));
        match *motion {
            RelativeMotion::Translation(direction) => Heights {
                arriving: [arriving, x.dot(direction), 0.0],
                leaving: [leaving, y.dot(direction), 0.0],
            },
            RelativeMotion::Rotation { axis, centre } => {
                let (v, u) = (self.receiver - centre, self.receiver + self.offset - centre);
                let arriving_after = arriving - 2.0 * (x.dot(u) - axis.dot(u) * axis.dot(x));
                let leaving_after = leaving + 2.0 * (y.dot(v) - axis.dot(v) * axis.dot(y));
                Heights {
                    arriving: [arriving, 2.0 * x.dot(axis.cross(u)), arriving_after],
                    leaving: [leaving, 2.0 * y.dot(axis.cross(v)), leaving_after],
                }
            }
        }
    }

    /// The kernel along a translation, with r² given.
    #[inline(always)]
    pub(crate) fn translated(&self, direction: DVec3, r2: f64) -> Quotient<3> {
        let inverse = 1.0 / r2;
        let factor = -FRAC_1_PI * inverse * inverse;
        let Heights { arriving: [x0, x1, _], leaving: [y0, y1, _] } =
            self.heights(&RelativeMotion::Translation(direction));
        let numerator = [factor * y0 * x0, factor * (y1 * x0 + y0 * x1), factor * y1 * x1];
        let a = 2.0 * direction.dot(self.offset) * inverse;
        Quotient { numerator, a, b: direction.length_squared() * inverse }
    }

    /// The kernel along a rotation, with r² given.
    #[inline(always)]
    pub(crate) fn turned(&self, axis: DVec3, centre: DVec3, r2: f64) -> Quotient<5> {
        let inverse = 1.0 / r2;
        let factor = -FRAC_1_PI * inverse * inverse;
        let Heights { arriving: [x0, x1, x2], leaving: [y0, y1, y2] } =
            self.heights(&RelativeMotion::Rotation { axis, centre });
        let numerator = [
            factor * (y0 * x0),
            factor * (y1 * x0 + y0 * x1),
            factor * (y2 * x0 + y1 * x1 + y0 * x2),
            factor * (y2 * x1 + y1 * x2),
            factor * (y2 * x2),
        ];
        let (v, u) = (self.receiver - centre, self.receiver + self.offset - centre);
        let after = self.offset - 2.0 * (u - axis.dot(u) * axis);
        let a = 4.0 * self.offset.dot(axis.cross(v)) * inverse;
        Quotient { numerator, a, b: after.length_squared() * inverse }
    }
}

impl<const M: usize> Quotient<M> {
    fn write(&self, out: &mut [f64]) {
        // One lane: each number is an array of one.
        let (rows, _) = out.as_chunks_mut::<1>();
        quotient(&self.numerator.map(|x| [x]), &[self.a], &[self.b], rows);
    }

    /// √B, and a little where it is nearly 0.
    #[inline(always)]
    fn rate(&self) -> f64 {
        if M > 3 { self.b.sqrt().max(LEAST_RATE) } else { self.b.sqrt() }
    }

    /// Bound of what the powers above N = `orders` add up to at `step`.
    fn remainder(&self, orders: usize, step: f64) -> f64 {
        let first = self.bound(orders + 1) * step.powi(orders as i32 + 1);
        first * tail(orders, M - 1, self.rate() * step)
    }

    /// An upper bound of |φ_n|, n ≥ 1, that falls from order to order like the terms of the series at least
    /// ([`super::remainder`]).
    #[inline(always)]
    pub(crate) fn bound(&self, n: usize) -> f64 {
        // cos² of the angle of the roots.
        let cosine2 = 0.25 * self.a * self.a / self.b;
        let sine2 = (1.0 - cosine2).max(0.0);
        let rate = self.rate();
        let of = |back: usize| self.numerator[back].abs() * gegenbauer_bound(n.saturating_sub(back), sine2);
        let sum = (1..M).fold(of(0), |sum, back| sum * rate + of(back));
        rate.powi(n as i32 + 1 - M as i32) * sum
    }
}
