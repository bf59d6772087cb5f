//! Points of a pixel at which it is sampled: a square lattice of n = S² + 1 points that is turned, so that no two of
//! them lie in one column or one row.
//!
//! ```text
//! x_k = (k + ½)/n ,     y_k = frac(½ + S (k − (n − 1)/2)/n) ,     k = 0 … n − 1
//! ```
//!
//! from the left upper corner, in pixels. Its steps (1, S)/n and (S, −1)/n are equally long and at right angles, and
//! the points are symmetric about the middle. The share of a pixel beside an edge along an axis errs by 1/(2 n) at
//! most; on S × S points in rows and columns by 1/(2 S). With S = 1 the middle is the only point.
//!
//! Reference: R. Cook, *Stochastic sampling in computer graphics*, ACM Transactions on Graphics 5 (1986), of what
//! regular grids do to edges along them.

/// The corners of the unit square.
const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];

/// The points at which a pixel is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelGrid {
    points: Vec<[f64; 2]>,
}

impl PixelGrid {
    /// The grid of about `side` points along each side of a pixel.
    pub fn new(side: u32) -> Self {
        if side <= 1 {
            return Self { points: vec![[0.5; 2]] };
        }
        let side = i64::from(side);
        let count = side * side + 1;
        // In halves of a step, exactly.
        let point = |k: i64| {
            let halves = [2 * k + 1, (count + side * (2 * k + 1 - count)).rem_euclid(2 * count)];
            halves.map(|halves| halves as f64 / (2 * count) as f64)
        };
        Self { points: (0..count).map(point).collect() }
    }

    /// The points, in pixels from the left upper corner of the pixel.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The four points nearest to the corners of the pixel, and the others.
    pub(crate) fn outer_and_inner(&self) -> [Vec<[f64; 2]>; 2] {
        let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let is_outer = |point: &[f64; 2]| {
            CORNERS.iter().any(|corner| {
                self.points.iter().all(|other| apart(*point, *corner) <= apart(*other, *corner))
            })
        };
        let (outer, inner) = self.points.iter().partition(|point| is_outer(point));
        [outer, inner]
    }

    /// Points before the corners of the pixel, as near to its sides as the points of the grid.
    pub(crate) fn corners(&self) -> [[f64; 2]; 4] {
        let inwards = 0.5 / self.points.len() as f64;
        CORNERS.map(|corner| corner.map(|at| inwards + at * (1.0 - 2.0 * inwards)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_and_row_holds_one_point() {
        for side in 2..=64 {
            let grid = PixelGrid::new(side);
            let count = grid.points().len();
            assert_eq!(count, (side * side + 1) as usize);
            for axis in 0..2 {
                let mut steps: Vec<f64> =
                    grid.points().iter().map(|point| point[axis] * count as f64 - 0.5).collect();
                steps.sort_by(f64::total_cmp);
                assert!(
                    steps.iter().enumerate().all(|(k, at)| (at - k as f64).abs() < 1e-9),
                    "{side}: {steps:?}"
                );
            }
        }
        assert_eq!(PixelGrid::new(1).points(), [[0.5; 2]]);
    }

    #[test]
    fn points_are_symmetric_about_the_middle() {
        for side in [2, 3, 4, 7] {
            let grid = PixelGrid::new(side);
            let holds = |wanted: [f64; 2]| {
                grid.points().iter().any(|own| (own[0] - wanted[0]).hypot(own[1] - wanted[1]) < 1e-12)
            };
            assert!(grid.points().iter().all(|[x, y]| holds([1.0 - x, 1.0 - y])), "{side}");
        }
    }

    /// No point is nearer to another one, or to one of the next pixels, than a step.
    #[test]
    fn points_keep_their_distance_across_pixels() {
        for side in [2, 3, 4, 7] {
            let grid = PixelGrid::new(side);
            let step = 1.0 / (grid.points().len() as f64).sqrt();
            for (index, own) in grid.points().iter().enumerate() {
                for other in &grid.points()[index + 1..] {
                    let [x, y] = [0, 1].map(|axis| own[axis] - other[axis]).map(|by: f64| by - by.round());
                    assert!(x.hypot(y) > step - 1e-12, "{side}: {own:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn four_points_are_outer_ones() {
        for side in 2..=9 {
            let [outer, inner] = PixelGrid::new(side).outer_and_inner();
            assert_eq!([outer.len(), inner.len()], [4, (side * side) as usize - 3], "{side}");
        }
    }
}
