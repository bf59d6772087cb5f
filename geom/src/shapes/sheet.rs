//! Sheets of bicubic patches as graphs: which lines meet one no more than once, or twice.
//!
//! In the affine frame (a, b, h) of its mean tangents and normal ([`super::sheared`]) a sheet X(s, t) is moved along a line of
//! direction w onto h = 0: its points come to (a, b) − (w_a, w_b) h/w_h. The derivative of that by s and t differs from the
//! unit matrix, in the maximum norm, by at most
//!
//! ```text
//! β + σ max(|w_a|, |w_b|)/|w_h| ,     β = max(|a_s − 1| + |a_t|, |b_s| + |b_t − 1|) ,     σ = |h_s| + |h_t|
//! ```
//!
//! (each term at its largest over the differences of the control points; β no less than the sums of |a_s − 1|, |b_s| and of
//! |a_t|, |b_t − 1| either). Below 1 the map is one-to-one, and no line along w meets the sheet twice: one that is known to meet
//! it in an end of a ray meets it nowhere else.
//!
//! Over (a, b) the height has the second derivative, along e = (w_a, w_b) of maximum norm 1,
//!
//! ```text
//! fᵀ (∇²h − h_a ∇²a − h_b ∇²b) f ,     f = e + O(δ) ,     δ = β/(1 − β) ,     |h_a|, |h_b| ≤ σ/(1 − β) ,
//! ```
//!
//! ∇ by s and t. Where its sign is certain, the height over the line has no third zero: a line that meets the sheet in both
//! ends of a ray meets it nowhere else.

use super::sheared::frame;
use crate::Aabb;
use glam::{DMat3, DVec2, DVec3, Vec3Swizzles};

/// How many times its doubt a curvature has to be for its sign to be certain, a little beyond the border as well.
const CERTAIN: f64 = 1.5;

/// A sheet as a graph over its mean plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    /// From space to (a, b, h).
    frame: DMat3,
    /// β and σ.
    bend: f64,
    slope: f64,
    /// ∇²h by s twice, by s and t, and by t twice, each in the middle of its range.
    curvature: [f64; 3],
    /// How far the second derivative along any e may be off that; infinite where nothing is known.
    doubt: f64,
}

impl Sheet {
    /// The sheet with the control points `points[i][j]`, i along s.
    pub(super) fn of(points: &[[DVec3; 4]; 4]) -> Self {
        let frame = frame(points);
        let local = points.map(|row| row.map(|x| frame * (x - points[0][0])));
        let (bend, slope) = bend_and_slope(&local);
        let ranges = second_derivatives(&local);
        let sum = |of: &dyn Fn(&Aabb) -> f64| of(&ranges[0]) + 2.0 * of(&ranges[1]) + of(&ranges[2]);
        let most = |range: &Aabb| range.min.abs().max(range.max.abs());
        let (steepness, turn) = (slope / (1.0 - bend), bend / (1.0 - bend));
        let oblique = steepness * sum(&|range| most(range).x + most(range).y);
        let all = sum(&|range| most(range).z) + oblique;
        let doubt = sum(&|range| 0.5 * (range.max.z - range.min.z)) + oblique + (2.0 + turn) * turn * all;
        let doubt = if bend < 1.0 { doubt } else { f64::INFINITY };
        Self { frame, bend, slope, curvature: ranges.map(|range| range.center().z), doubt }
    }

    /// Whether no line along `direction` meets it more than once.
    pub(super) fn is_met_once(&self, direction: DVec3) -> bool {
        let along = (self.frame * direction).abs();
        self.slope * along.x.max(along.y) < (1.0 - self.bend) * along.z
    }

    /// Whether no line along `direction` meets it more than twice.
    pub(super) fn is_met_twice_at_most(&self, direction: DVec3) -> bool {
        let along = (self.frame * direction).xy();
        let size = along.abs().max_element();
        let [ss, st, tt] = self.curvature;
        let value = along.x * along.x * ss + 2.0 * along.x * along.y * st + along.y * along.y * tt;
        value.abs() > CERTAIN * self.doubt * size * size
    }
}

/// β and σ from control points in the frame.
fn bend_and_slope(local: &[[DVec3; 4]; 4]) -> (f64, f64) {
    let (mut by_s, mut by_t) = (DVec3::ZERO, DVec3::ZERO);
    for (i, j) in (0..3).flat_map(|i| (0..4).map(move |j| (i, j))) {
        by_s = by_s.max((3.0 * (local[i + 1][j] - local[i][j]) - DVec3::X).abs());
        by_t = by_t.max((3.0 * (local[j][i + 1] - local[j][i]) - DVec3::Y).abs());
    }
    let (rows, columns) = (by_s + by_t, DVec2::new(by_s.x + by_s.y, by_t.x + by_t.y));
    (rows.xy().max(columns).max_element(), rows.z)
}

/// Ranges of X_ss, X_st and X_tt by the second differences of the control points.
fn second_derivatives(local: &[[DVec3; 4]; 4]) -> [Aabb; 3] {
    let ss = (0..2)
        .flat_map(|i| (0..4).map(move |j| 6.0 * (local[i + 2][j] - 2.0 * local[i + 1][j] + local[i][j])));
    let st = (0..3).flat_map(|i| {
        (0..3).map(move |j| 9.0 * (local[i + 1][j + 1] - local[i + 1][j] - local[i][j + 1] + local[i][j]))
    });
    let tt = (0..4)
        .flat_map(|i| (0..2).map(move |j| 6.0 * (local[i][j + 2] - 2.0 * local[i][j + 1] + local[i][j])));
    [Aabb::around(ss), Aabb::around(st), Aabb::around(tt)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(height: impl Fn(f64, f64) -> f64) -> Sheet {
        let third = |k: usize| k as f64 / 3.0;
        Sheet::of(&std::array::from_fn(|i| {
            std::array::from_fn(|j| DVec3::new(third(i), third(j), height(third(i), third(j))))
        }))
    }

    #[test]
    fn flat_sheets_are_met_once_but_along() {
        let flat = sheet(|x, _| 0.3 * x);
        assert!(flat.is_met_once(DVec3::Z) && flat.is_met_once(DVec3::new(1.0, 1.0, 0.5)));
        assert!(!flat.is_met_once(DVec3::new(1.0, 0.0, 0.3)));
    }

    /// The control heights x² and x y stand for parabolas that bend along x alone, and along both diagonals.
    #[test]
    fn bent_sheets_are_met_twice_along_their_bend() {
        let (bowl, saddle) = (sheet(|x, _| 0.1 * x * x), sheet(|x, y| 0.1 * x * y));
        assert!(bowl.is_met_twice_at_most(DVec3::X));
        assert!(!bowl.is_met_twice_at_most(DVec3::Y));
        assert!(saddle.is_met_twice_at_most(DVec3::X + DVec3::Y));
        assert!(saddle.is_met_twice_at_most(DVec3::X - DVec3::Y));
        assert!(!saddle.is_met_twice_at_most(DVec3::X));
    }
}
