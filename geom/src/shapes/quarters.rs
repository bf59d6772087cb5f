//! The four quarters of a tile in its frame, as boxes side by side: which of them a ray may meet.

use super::sheared::Local;
use crate::Aabb;

/// Quarters of a tile.
const COUNT: usize = 4;

/// Boxes around the quarters.
#[derive(Clone, Debug)]
pub(super) struct Quarters {
    /// Lowest coordinates: by axis, then by quarter.
    low: [[f64; COUNT]; 3],
    /// Highest coordinates, likewise.
    high: [[f64; COUNT]; 3],
}

impl Quarters {
    /// The boxes of the quarters in the tile's frame.
    pub(super) fn new(boxes: [Aabb; COUNT]) -> Self {
        let of = |pick: fn(&Aabb) -> glam::DVec3| {
            std::array::from_fn(|axis| std::array::from_fn(|k| pick(&boxes[k])[axis]))
        };
        Self { low: of(|bounds| bounds.min), high: of(|bounds| bounds.max) }
    }

    /// Which boxes a ray in the tile's frame enters between two multiples of its direction.
    #[inline]
    pub(super) fn entered(&self, ray: &Local, [start, end]: [f64; 2]) -> [bool; COUNT] {
        let (mut enter, mut leave) = ([start; COUNT], [end; COUNT]);
        for axis in 0..3 {
            let (from, inverse) = (ray.from[axis], ray.inverse[axis]);
            for k in 0..COUNT {
                let a = (self.low[axis][k] - from) * inverse;
                let b = (self.high[axis][k] - from) * inverse;
                enter[k] = larger(smaller(a, b), enter[k]);
                leave[k] = smaller(larger(a, b), leave[k]);
            }
        }
        std::array::from_fn(|k| enter[k] <= leave[k])
    }
}

/// Written such that it becomes one instruction.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
