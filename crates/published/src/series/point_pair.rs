//! Two points with their normals: the kernel between them, its series along a direction, and what bounds its
//! terms.

use core::f64::consts::FRAC_1_PI;

use radiosity_geom::DVec3;

use super::power_series::quotient;
use super::remainder::{gegenbauer_bound, tail};
use super::span::Span;

/// A point of the receiver and one of the emitter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointPair {
    /// r = y − x (scene length), from the receiver to the emitter; not zero.
    pub offset: DVec3,
    /// Unit normal n_x of the receiver's front.
    pub receiver_normal: DVec3,
    /// Unit normal n_y of the emitter's front.
    pub emitter_normal: DVec3,
}

/// (N₀ + N₁p + N₂p²)/(1 + A p + B p²)²: the kernel of a pair of points along a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quotient {
    /// κ₀ (a, b, c), 1/length² and less by a length per power of p.
    pub numerator: [f64; 3],
    /// A = 2 d·r/r².
    pub a: f64,
    /// B = d²/r².
    pub b: f64,
}

impl PointPair {
    /// κ of the pair with the emitter displaced by `displacement`, negative where one side faces away and
    /// positive where both do.
    pub fn kernel(&self, displacement: DVec3) -> f64 {
        let r = self.offset + displacement;
        let r2 = r.length_squared();
        -FRAC_1_PI * self.emitter_normal.dot(r) * self.receiver_normal.dot(r) / (r2 * r2)
    }

    /// Writes φ_0 … φ_{m−1}, m = `out.len()`, along `direction`.
    pub fn series(&self, direction: DVec3, out: &mut [f64]) {
        let Quotient { numerator, a, b } = self.quotient(direction, self.offset.length_squared());
        // One lane: each number is an array of one.
        let (rows, _) = out.as_chunks_mut::<1>();
        quotient(&numerator.map(|x| [x]), &[a], &[b], rows);
    }

    /// Bound of what the powers above p^N, N = `orders`, add to κ at p along `direction`; infinite where the
    /// series diverges.
    pub fn remainder(&self, direction: DVec3, orders: usize, p: f64) -> f64 {
        let of_pair = self.quotient(direction, self.offset.length_squared());
        let step = p.abs();
        of_pair.bound(orders + 1) * step.powi(orders as i32 + 1) * tail(orders, of_pair.b.sqrt() * step)
    }

    /// The kernel along `direction`, with r² given.
    #[inline(always)]
    pub(crate) fn quotient(&self, direction: DVec3, r2: f64) -> Quotient {
        let inverse = 1.0 / r2;
        let factor = -FRAC_1_PI * inverse * inverse;
        let (arriving, leaving) =
            (self.receiver_normal.dot(self.offset), self.emitter_normal.dot(self.offset));
        let (receiver, emitter) = (self.receiver_normal.dot(direction), self.emitter_normal.dot(direction));
        let numerator = [
            factor * leaving * arriving,
            factor * (emitter * arriving + leaving * receiver),
            factor * emitter * receiver,
        ];
        let a = 2.0 * direction.dot(self.offset) * inverse;
        Quotient { numerator, a, b: direction.length_squared() * inverse }
    }

    /// Whether both sides face each other, and for which p that stays as it is at p = 0.
    pub fn facing(&self, direction: DVec3) -> (bool, Span) {
        let arriving =
            Span::above(self.receiver_normal.dot(self.offset), self.receiver_normal.dot(direction));
        let leaving = Span::above(-self.emitter_normal.dot(self.offset), -self.emitter_normal.dot(direction));
        let both = arriving.common(&leaving);
        if both.contains(0.0) { (true, both) } else { (false, both.beside_zero()) }
    }
}

impl Quotient {
    /// An upper bound of |φ_n|, n ≥ 1, that falls from order to order like the terms of the series at least
    /// ([`super::remainder`]).
    #[inline(always)]
    pub(crate) fn bound(&self, n: usize) -> f64 {
        // cos² of the angle between offset and direction.
        let cosine2 = 0.25 * self.a * self.a / self.b;
        let sine2 = (1.0 - cosine2).max(0.0);
        let per_order = self.b.sqrt();
        let [c0, c1, c2] = self.numerator.map(f64::abs);
        let of = |back: usize| gegenbauer_bound(n.saturating_sub(back), sine2);
        let sum = c0 * of(0) * self.b + c1 * of(1) * per_order + c2 * of(2);
        per_order.powi(n as i32 - 2) * sum
    }
}
