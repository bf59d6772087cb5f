//! How far the 2 × 2 Gauss points of a curved cell miss its area and its place.
//!
//! ```text
//! E = ∫ f(y)·dA_y ≈ f(c)·S + ∇f(c) : M ,     S = ∫ dA_y ,  M = ∫ (y − c) ⊗ dA_y ,     f = (n·r) r / (π r⁴)
//! ```
//!
//! at the distance r = y − x from a receiver x of the normal n, dA along the normal of the cell and c its centre.
//! A rule that misses S by δS and M by δM misses E, for exitance 1, to first order by
//!
//! ```text
//! |δE| ≤ |δS| / (π d²) + √6 |δM| / (π d³) ,     d = |c − x| ,
//! ```
//!
//! since |f| = cos θ/(π r²) and, in the Frobenius norm, |∇f|² = (1 + 5 cos² θ)/(π r³)². A field that varies by ΔB over
//! the cell, of the radius h, adds about F ΔB |δM| / (|S| h).
//!
//! Formula. Of a smooth function of the chart, Gauss's rule errs by +h⁵ f⁗/4320 and Simpson's, of 3 × 3 points, by
//! −h⁵ f⁗/2880: Gauss's errs by ⅖ of their difference. A ring charted by its angle in one cell is missed by 0.08
//! radii, though it is flat and its area is right.
//!
//! Range of use. Curved cells; flat ones have neither error.
//!
//! Reference: P. J. Davis, P. Rabinowitz, *Methods of Numerical Integration*, 2nd ed., 1984, §§ 2.2 and 2.7.

use std::f64::consts::PI;

use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::DVec3;

/// Error of Gauss's rule over its difference from Simpson's.
const GAUSS: f64 = 0.4;

/// Greatest Frobenius norm of ∇f times π r³.
const STEEPEST: f64 = 2.449_489_742_783_178;

/// Weights of Simpson's rule on [0, 1].
const SIMPSON: [f64; 3] = [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0];

/// The nodes of a patch at s, t = 0, ½, 1, index 3 a + b for the a-th s and the b-th t.
#[derive(Debug)]
pub(super) struct Grid([Node; 9]);

impl Grid {
    /// The nodes of a patch.
    pub(super) fn of(patch: &Patch) -> Self {
        Self(std::array::from_fn(|k| patch.node(0.5 * (k / 3) as f64, 0.5 * (k % 3) as f64)))
    }

    /// The nodes at the corners (0,0), (1,0), (1,1), (0,1).
    pub(super) fn corners(&self) -> [Node; 4] {
        [0, 6, 8, 2].map(|k| self.0[k])
    }

    /// The node at the middle.
    pub(super) fn middle(&self) -> &Node {
        &self.0[4]
    }

    /// The nodes, each with its share of the cell's area by Simpson's rule.
    fn weighted(&self) -> impl Iterator<Item = Node> {
        let share = |k: usize| SIMPSON[k / 3] * SIMPSON[k % 3];
        self.0.iter().enumerate().map(move |(k, node)| Node { area: node.area * share(k), ..*node })
    }
}

/// Errors of the moments of a cell by its Gauss points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moments {
    /// |δS| (scene length²).
    area: f64,
    /// |δM| (scene length³).
    place: f64,
}

impl Moments {
    /// Moments without an error, as of a flat cell.
    pub(super) const EXACT: Self = Self { area: 0.0, place: 0.0 };

    /// Moments of a cell about `center` by Gauss points, whose areas are their shares of it.
    pub(super) fn of(points: &[Node], grid: &Grid, center: DVec3) -> Self {
        let (mut area, mut place) = (DVec3::ZERO, [DVec3::ZERO; 3]);
        let mut add = |node: &Node, sign: f64| {
            let (own, from) = (sign * node.area * node.normal, node.position - center);
            area += own;
            place.iter_mut().zip(from.to_array()).for_each(|(row, length)| *row += length * own);
        };
        points.iter().for_each(|node| add(node, GAUSS));
        grid.weighted().for_each(|node| add(&node, -GAUSS));
        let square: f64 = place.iter().map(|row| row.length_squared()).sum();
        Self { area: area.length(), place: square.sqrt() }
    }

    /// Distance by which points miss the middle of a cell of this area, over its radius: the part of the variation of
    /// a field that they miss of its mean.
    pub(crate) fn offset(&self, area: f64, radius: f64) -> f64 {
        if area * radius > 0.0 { self.place / (area * radius) } else { 0.0 }
    }

    /// Bound, to first order, of the error of the irradiance from exitance 1 at this distance.
    pub(crate) fn error_at(&self, distance: f64) -> f64 {
        (self.area + STEEPEST * self.place / distance) / (PI * distance * distance)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_elements::rule::UnitRule;
    use radiosity_geom::Rect;
    use radiosity_geom::shapes::{Disk, FULL_TURN};

    use super::*;

    /// The moments of a sector of a disk of radius 1 about its centre.
    fn sector(angle: f64) -> Moments {
        let disk = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, [0.0, angle]).expect("a sector");
        let patch = Patch::curved(Arc::new(disk), &Rect::FULL);
        let UnitRule { nodes, weights } = UnitRule::of(2);
        let points: Vec<Node> = (0..4)
            .map(|k| {
                let node = patch.node(nodes[k / 2], nodes[k % 2]);
                Node { area: node.area * weights[k / 2] * weights[k % 2], ..node }
            })
            .collect();
        Moments::of(&points, &Grid::of(&patch), DVec3::ZERO)
    }

    /// ∫ r² e^{iφ} dr dφ over an angle α is (α/3) sin(α/2)/(α/2); two points of Gauss have cos(α/√12) in place of the
    /// last quotient.
    #[test]
    fn a_sector_is_missed_by_what_two_points_miss_of_its_angle() {
        for angle in [FULL_TURN[1] - FULL_TURN[0], 2.0, 1.0, 0.5] {
            let (half, found) = (0.5 * angle, sector(angle));
            let missed: f64 = angle / 3.0 * (half.sin() / half - (half / 3.0f64.sqrt()).cos());
            assert!(found.area < 1e-15, "{found:?}");
            assert!((found.place / missed.abs() - 1.0).abs() < 0.15, "{angle}: {} not {missed}", found.place);
        }
    }
}
