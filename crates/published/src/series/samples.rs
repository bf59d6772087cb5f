//! The terms of the series at pairs of points, and the square of the bound of the first one left out.

use radiosity_elements::patch::Node;
use radiosity_geom::DVec3;
use radiosity_kernel::moments::tensor::{LANES, Lanes, Terms, Tile};

use super::point_pair::PointPair;
use super::power_series::quotient;

/// φ_0 … φ_N along a direction, then b²_{N+1}.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Samples {
    /// Displacement of the emitter at the centre of the expansion (scene length).
    pub shift: DVec3,
    /// Displacement per unit of p.
    pub direction: DVec3,
    /// N.
    pub orders: usize,
}

impl Terms for Samples {
    fn count(&self) -> usize {
        self.orders + 2
    }

    #[inline]
    fn write(&mut self, tile: &Tile, node: &Node, out: &mut [Lanes]) {
        let displaced = Node { position: node.position + self.shift, ..*node };
        let (mut numerator, mut a, mut b) = ([[0.0; LANES]; 3], [0.0; LANES], [0.0; LANES]);
        let (terms, rest) = out.split_at_mut(self.orders + 1);
        for lane in 0..LANES {
            let [x, y, z, r2] = tile.offset(&displaced, lane);
            let pair = PointPair {
                offset: DVec3::new(x, y, z),
                receiver_normal: tile.normal(lane),
                emitter_normal: node.normal,
            };
            let of_pair = pair.quotient(self.direction, r2);
            for (row, value) in numerator.iter_mut().zip(of_pair.numerator) {
                row[lane] = value;
            }
            (a[lane], b[lane]) = (of_pair.a, of_pair.b);
            rest[0][lane] = of_pair.bound(self.orders + 1).powi(2);
        }
        quotient(&numerator, &a, &b, terms);
    }
}
