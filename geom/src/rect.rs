//! Rectangles in the parameter domain.

use crate::COINCIDENT;

/// A rectangle of parameters, `u[0] ≤ u ≤ u[1]` and `v[0] ≤ v ≤ v[1]`, inside [−1, 1]².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Lowest and highest u.
    pub u: [f64; 2],
    /// Lowest and highest v.
    pub v: [f64; 2],
}

impl Rect {
    /// The whole parameter domain [−1, 1]².
    pub const FULL: Rect = Rect { u: [-1.0, 1.0], v: [-1.0, 1.0] };

    /// The middle of the rectangle, `[u, v]`.
    pub fn center(&self) -> [f64; 2] {
        [0.5 * (self.u[0] + self.u[1]), 0.5 * (self.v[0] + self.v[1])]
    }

    /// Half the width and half the height, `[du, dv]`.
    pub fn half_extent(&self) -> [f64; 2] {
        [0.5 * (self.u[1] - self.u[0]), 0.5 * (self.v[1] - self.v[0])]
    }

    /// The corners counter-clockwise from `[u[0], v[0]]`.
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let (u, v) = (self.u, self.v);
        [[u[0], v[0]], [u[1], v[0]], [u[1], v[1]], [u[0], v[1]]]
    }

    /// The point at local coordinates `s, t` ∈ [−1, 1]², corner to corner.
    pub fn at(&self, s: f64, t: f64) -> [f64; 2] {
        let mix = |range: [f64; 2], s: f64| 0.5 * ((1.0 - s) * range[0] + (1.0 + s) * range[1]);
        [mix(self.u, s), mix(self.v, t)]
    }

    /// Whether `u, v` lies in the rectangle or on its border.
    pub fn contains(&self, u: f64, v: f64) -> bool {
        (self.u[0]..=self.u[1]).contains(&u) && (self.v[0]..=self.v[1]).contains(&v)
    }

    /// Whether the rectangles have more in common than borders.
    pub fn overlaps(&self, other: &Rect) -> bool {
        let meet = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]) > COINCIDENT;
        meet(self.u, other.u) && meet(self.v, other.v)
    }

    /// The halves of lower and higher u.
    pub fn split_u(&self) -> [Rect; 2] {
        let middle = self.center()[0];
        [Rect { u: [self.u[0], middle], v: self.v }, Rect { u: [middle, self.u[1]], v: self.v }]
    }

    /// The halves of lower and higher v.
    pub fn split_v(&self) -> [Rect; 2] {
        let middle = self.center()[1];
        [Rect { u: self.u, v: [self.v[0], middle] }, Rect { u: self.u, v: [middle, self.v[1]] }]
    }

    /// The four quarters: low v first, low u first.
    pub fn quarters(&self) -> [Rect; 4] {
        let [low, high] = self.split_v();
        let ([a, b], [c, d]) = (low.split_u(), high.split_u());
        [a, b, c, d]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_tile_the_rectangle() {
        let rect = Rect { u: [-0.5, 0.25], v: [0.0, 1.0] };
        let area = |r: &Rect| 4.0 * r.half_extent()[0] * r.half_extent()[1];
        let quarters = rect.quarters();
        assert_eq!(quarters.iter().map(area).sum::<f64>(), area(&rect));
        let [u, v] = rect.center();
        assert!(quarters.iter().all(|q| q.corners().contains(&[u, v])));
    }

    #[test]
    fn local_corners_are_the_corners() {
        let rect = Rect { u: [-0.3, 0.7], v: [0.1, 0.2] };
        let at = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(s, t)| rect.at(s, t));
        assert_eq!(at, rect.corners());
    }
}
