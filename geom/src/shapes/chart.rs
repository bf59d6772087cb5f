//! Nearly straight tiles over their mean tangents: whether a ray meets one, and where.
//!
//! In the frame of a tile ([`super::sheared`]) its points are X(s, t) = (a, b, h), with (a, b) about (s, t).
//! A ray through (p, q), with q its height, and with the slope m = (da/dh, db/dh) meets the tile where
//!
//! ```text
//! f(s, t) = (a, b) − p − m (h − q) = 0 .
//! ```
//!
//! The coefficients of the derivatives of a, b and h bound how far that of f differs from the identity, by
//! κ = max (κ_ab + |m| κ_h) in the maximum norm. For κ < 1 there is one zero at most, and it lies within
//! κ/(1 − κ) |f| of (s, t) − f, from any place in the tile; for κ ≤ 0.3 Newton's method finds it. So only
//! steep rays and bent tiles are left in doubt. Compare [`crate::zeros`], which proves the same of the net
//! seen along the ray.

use super::net::sample;
use super::sheared::Local;
use crate::zeros::NEARLY_LINEAR;
use glam::{DMat2, DVec2, DVec3, Vec3Swizzles};

/// A tile in its frame.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    net: [[DVec3; 4]; 4],
    /// κ_ab of a and of b, and κ_h.
    bend: DVec3,
}

/// Meeting of a ray with a tile, as far as the chart can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meeting {
    /// It misses the tile.
    None,
    /// It meets the tile once, at `along` multiples of its direction.
    At { s: f64, t: f64, along: f64 },
    /// The ray may meet the tile or miss it.
    Doubtful,
}

impl Chart {
    /// The tile with control points `net`, in its frame; None if all rays are in doubt.
    pub(super) fn new(net: [[DVec3; 4]; 4]) -> Option<Self> {
        let (mut by_s, mut by_t) = (DVec3::ZERO, DVec3::ZERO);
        for (low, high) in net.iter().zip(&net[1..]).flat_map(|(low, high)| low.iter().zip(high)) {
            by_s = by_s.max((3.0 * (*high - *low) - DVec3::X).abs());
        }
        for pair in net.iter().flat_map(|row| row.windows(2)) {
            by_t = by_t.max((3.0 * (pair[1] - pair[0]) - DVec3::Y).abs());
        }
        let bend = by_s + by_t;
        (bend.xy().max_element() < NEARLY_LINEAR).then_some(Self { net, bend })
    }

    /// Whether rays of slopes up to 3, which are 72° and more from the surface's normal, are not in doubt.
    pub(super) fn is_straight(&self) -> bool {
        self.most_bent(DVec2::splat(3.0)) <= NEARLY_LINEAR
    }

    /// κ for rays of a slope.
    fn most_bent(&self, slope: DVec2) -> f64 {
        (self.bend.xy() + self.bend.z * slope.abs()).max_element()
    }

    /// Where a ray meets the tile, or up to `outside` beyond [0, 1]².
    pub(super) fn meet(&self, ray: &Local, outside: f64) -> Meeting {
        let slope = ray.along.xy() / ray.along.z;
        let bend = self.most_bent(slope);
        if bend.is_nan() || bend > NEARLY_LINEAR {
            return Meeting::Doubtful;
        }
        let (low, high) = (DVec2::splat(-outside), DVec2::splat(1.0 + outside));
        let reach = bend / (1.0 - bend);
        let mut at = ray.from.xy() - slope * ray.from.z;
        at = at.clamp(low, high);
        for _ in 0..12 {
            let here = sample(&self.net, at.x, at.y);
            let rest = here.value - ray.from;
            let f = rest.xy() - rest.z * slope;
            let reach = DVec2::splat(reach * f.abs().max_element());
            if (at - f + reach).cmplt(low).any() || (at - f - reach).cmpgt(high).any() {
                return Meeting::None;
            }
            let [by_s, by_t] = [here.by_s, here.by_t].map(|by| by.xy() - by.z * slope);
            let step = DMat2::from_cols(by_s, by_t).inverse() * f;
            let next = at - step;
            at = next.clamp(low, high);
            // The next step would be of the order of the square of this one.
            if step.abs().max_element() <= 1e-8 {
                if next.distance(at) > outside {
                    return Meeting::None;
                }
                let met = rest - here.by_s * step.x - here.by_t * step.y;
                let along = met.dot(ray.along) / ray.along.length_squared();
                return Meeting::At { s: next.x, t: next.y, along };
            }
        }
        Meeting::None
    }
}
