//! The terms of the series at pairs of points, and the square of the bound of the first one left out.

use radiosity_elements::patch::Node;
use radiosity_geom::{DVec3, Motion};
use radiosity_kernel::moments::tensor::{LANES, Lanes, Terms, Tile};

use super::motion::RelativeMotion;
use super::point_pair::{PointPair, Quotient};
use super::power_series::quotient;

/// φ_0 … φ_N along a motion, then b²_{N+1}.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Samples {
    /// Where the emitter is at the centre of the expansion.
    pub place: Motion,
    pub motion: RelativeMotion,
    /// N.
    pub orders: usize,
}

impl Terms for Samples {
    fn count(&self) -> usize {
        self.orders + 2
    }

    #[inline]
    fn write(&mut self, tile: &Tile, node: &Node, out: &mut [Lanes]) {
        let [position, normal] = [self.place.point(node.position), self.place.direction(node.normal)];
        let moved = Node { position, normal, ..*node };
        match self.motion {
            RelativeMotion::Translation(direction) => {
                self.expand(tile, &moved, out, |pair, r2| pair.translated(direction, r2));
            }
            RelativeMotion::Rotation { axis, centre } => {
                self.expand(tile, &moved, out, |pair, r2| pair.turned(axis, centre, r2));
            }
        }
    }
}

impl Samples {
    #[inline(always)]
    fn expand<const M: usize>(
        &self,
        tile: &Tile,
        node: &Node,
        out: &mut [Lanes],
        quotient_of: impl Fn(&PointPair, f64) -> Quotient<M>,
    ) {
        let (mut numerator, mut a, mut b) = ([[0.0; LANES]; M], [0.0; LANES], [0.0; LANES]);
        let (terms, rest) = out.split_at_mut(self.orders + 1);
        for lane in 0..LANES {
            let [x, y, z, r2] = tile.offset(node, lane);
            let pair = PointPair {
                receiver: tile.point(lane),
                offset: DVec3::new(x, y, z),
                receiver_normal: tile.normal(lane),
                emitter_normal: node.normal,
            };
            let of_pair = quotient_of(&pair, r2);
            for (row, value) in numerator.iter_mut().zip(of_pair.numerator) {
                row[lane] = value;
            }
            (a[lane], b[lane]) = (of_pair.a, of_pair.b);
            rest[0][lane] = of_pair.bound(self.orders + 1).powi(2);
        }
        quotient(&numerator, &a, &b, terms);
    }
}
