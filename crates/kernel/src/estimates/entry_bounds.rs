//! Bounds of the entries of a block from balls around its elements.
//!
//! With balls of radii R_i and R_j around two elements, d the distance of their centres and h_i the height of
//! j's centre over the plane of i, the distance and both cosines of the kernel lie in known intervals:
//!
//! ```text
//! |G_kl| ≤ sup κ √(A_i A_j) ,   sup κ ≤ (h_i + R_j)(h_j + R_i) / π(d − R_i − R_j)⁴ ,
//!  G_00  ≥ inf κ √(A_i A_j) ,   inf κ ≥ (h_i − R_j)(h_j − R_i) / π(d + R_i + R_j)⁴ ,
//! ```
//!
//! because ∫|φ_k| dA ≤ √A. These bounds tell before integration which blocks are small compared with the
//! largest of their row, and need a lower relative accuracy.

use core::f64::consts::FRAC_1_PI;

use radiosity_elements::Element;
use radiosity_geom::{DVec3, Plane};

/// A block's error may be ε times this share of the largest entry of its row: a hundred such blocks together
/// may err as much as the largest one alone. With a larger value rows of many blocks would err by more; with
/// a smaller one small blocks would take more points than they are worth.
pub const ROW_SHARE: f64 = 1e-2;
/// Smallest scale of a block with a curved element. Entries of G are at most 1: what is smaller than this is
/// nothing beside them, and rules would take points to resolve it.
pub const SMALLEST_ENTRY: f64 = 1e-8;
/// Largest relative error ever allowed of a block. A rule that errs by more than half tells nothing of a
/// block, and costs as little as one that errs by half.
const LOOSEST: f64 = 0.5;

/// The ball around an element, and its plane where it has one.
#[derive(Clone, Copy, Debug)]
pub struct EntryBounds {
    center: DVec3,
    radius: f64,
    area: f64,
    plane: Option<Plane>,
}

impl EntryBounds {
    /// The bounds of an element.
    pub fn of(element: &Element) -> Self {
        let bounds = element.bounds();
        let center = 0.5 * (bounds.min + bounds.max);
        let radius = element.hull.iter().map(|point| point.distance(center)).fold(0.0, f64::max);
        Self { center, radius, area: element.area, plane: element.plane }
    }

    /// Whether the balls are nearer than half the larger radius: the kernel may then vary too much for a
    /// coarse estimate.
    pub fn is_near(&self, other: &Self) -> bool {
        let gap = self.center.distance(other.center) - self.radius - other.radius;
        gap < 0.5 * self.radius.max(other.radius)
    }

    /// Lower bound of the largest entry and upper bound of all entries of the block of two elements.
    pub fn entries(&self, other: &Self) -> [f64; 2] {
        let d = other.center - self.center;
        let (distance, sum) = (d.length(), self.radius + other.radius);
        // Balls that (nearly) touch: no upper bound. Within 1 % of their radii the bound, which grows with
        // the fourth power of one over the gap, is far above the largest entry.
        if distance <= 1.01 * sum {
            return [0.0, f64::INFINITY];
        }
        // Range of heights of a ball over a plane; a curved element may face anywhere.
        let heights = |reach: &Self, ball: &Self| {
            reach.plane.map_or([0.0, distance + sum], |plane| {
                let height = plane.height(ball.center);
                [height - ball.radius, height + ball.radius]
            })
        };
        let (ours, theirs) = (heights(self, other), heights(other, self));
        let bound = |side: usize, distance: f64| {
            let cosines = ours[side].max(0.0) * theirs[side].max(0.0);
            (self.area * other.area).sqrt() * FRAC_1_PI * cosines / distance.powi(4)
        };
        [bound(0, distance + sum), bound(1, distance - sum)]
    }
}

/// ε of a block relative to its own largest entry, loosened in steps of powers of two, so that congruent
/// pairs agree; at most by 2⁶⁰ and up to `LOOSEST`.
///
/// `least` is a lower bound of the scale of the error, [`ROW_SHARE`] times the largest entry of the weaker of
/// both rows; `entry` is an upper bound of the block's own entries.
pub fn relaxed(eps: f64, least: f64, entry: f64) -> f64 {
    let factor = least / entry;
    if factor >= 2.0 { (eps * factor.log2().floor().min(60.0).exp2()).min(LOOSEST).max(eps) } else { eps }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(z: f64, up: f64) -> EntryBounds {
        let center = DVec3::Z * z;
        EntryBounds {
            center,
            radius: 0.5f64.sqrt(),
            area: 1.0,
            plane: Some(Plane { point: center, normal: DVec3::Z * up }),
        }
    }

    /// Parallel unit squares at distance 3: F = 0.0316 by the closed form.
    #[test]
    fn bounds_hold_the_factor_of_parallel_squares() {
        let z = 3.0f64;
        let (x, root) = (1.0 / z, (1.0 + 1.0 / (z * z)).sqrt());
        let exact = 2.0 / (std::f64::consts::PI * x * x)
            * (((1.0 + x * x).powi(2) / (1.0 + 2.0 * x * x)).sqrt().ln()
                + 2.0 * x * root * (x / root).atan()
                - 2.0 * x * x.atan());
        let [low, high] = square(0.0, 1.0).entries(&square(z, -1.0));
        assert!(0.0 < low && low < exact && exact < high, "{low} {exact} {high}");
        assert_eq!(square(0.0, 1.0).entries(&square(1.0, -1.0)), [0.0, f64::INFINITY]);
    }

    /// The centre of the ball need not lie in the element's plane.
    #[test]
    fn heights_are_measured_from_the_plane() {
        let mut raised = square(0.0, 1.0);
        raised.center.z = 0.5;
        let [low, high] = raised.entries(&square(5.0, -1.0));
        let [least, most] = square(0.0, 1.0).entries(&square(5.0, -1.0));
        assert!(low > least && high > most, "the same heights, a shorter distance");
    }

    #[test]
    fn only_small_blocks_are_relaxed() {
        assert_eq!(relaxed(1e-4, 2e-3, 0.1), 1e-4);
        assert_eq!(relaxed(1e-4, 2e-3, f64::INFINITY), 1e-4);
        assert_eq!(relaxed(1e-4, 2e-3, 2e-4), 8e-4);
        assert_eq!(relaxed(1e-4, 2e-3, 0.0), LOOSEST);
    }
}
