//! Shadow masks: what part of an emitter each place of an element sees.
//!
//! Zatz 1993, section 5.1: light from an emitter h is kept without its shadows as a polynomial of the receiver i, and
//! multiplied by a mask wherever it is looked at or sent on:
//!
//! ```text
//! E_i(x) = M_{i←h}(x) Σ_k p_k φ_k(x) ,      p = G°_{ih} b_h      (G°: without visibility)
//!
//! plain:     M = ∬ V du dv / ∬ du dv                 (eq. 28)
//! weighted:  M = ∫ κ V dA_h / ∫ κ dA_h
//! ```
//!
//! The plain mask is the paper's; it ignores cosines and distance, and a finer mask does not converge to the truth. The weighted
//! one is exact at its nodes for a uniform emitter. Both are known at the nodes of a grid over the element's
//! [coordinates](crate::elements::frame) and bilinear in between: of an even one ([`Grid`]), or of a quadtree that is fine
//! at shadow edges alone ([`Quadtree`]). Where something stands on the element there is nothing to see: such nodes take the value
//! of the nearest one that is free, or else the interpolation would darken the rim around it.

mod interpolation;
mod grid;
mod quadtree;

use std::num::NonZeroUsize;

use serde::{Deserialize, Serialize};

pub use grid::Grid;
pub use quadtree::Quadtree;

/// What is known at coordinates in [−1, 1]²: the mask, or None where the element is covered or ends.
pub type Sample<'a> = &'a dyn Fn([f64; 2]) -> Option<f64>;

/// How the nodes of a mask lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Nodes {
    /// At the corners of so many by so many equal cells.
    Even(NonZeroUsize),
    /// At the corners of cells that are halved at shadow edges until there would be at least so many by so many.
    Adaptive(NonZeroUsize),
}

/// A function of an element's coordinates between 0 and 1.
#[derive(Clone, Debug, PartialEq)]
pub enum Mask {
    /// On an even grid.
    Even(Grid),
    /// On a quadtree.
    Adaptive(Quadtree),
}

impl Mask {
    /// The mask of samples at its nodes; None where no node is free.
    pub fn new(nodes: Nodes, sample: Sample<'_>) -> Option<Self> {
        let at = |place: [f64; 2]| sample(place.map(|x| 2.0 * x - 1.0));
        Some(match nodes {
            Nodes::Even(cells) => Self::Even(Grid::new(cells, &at)?),
            Nodes::Adaptive(cells) => Self::Adaptive(Quadtree::new(cells, &at)?),
        })
    }

    /// Its value at coordinates in [−1, 1]²; those outside count as on the rim.
    pub fn at(&self, coordinates: [f64; 2]) -> f64 {
        let place = coordinates.map(|x| (0.5 * (x + 1.0)).clamp(0.0, 1.0));
        match self {
            Self::Even(grid) => grid.at(place),
            Self::Adaptive(tree) => tree.at(place),
        }
    }

    /// Nodes that were sampled.
    pub fn samples(&self) -> usize {
        match self {
            Self::Even(grid) => grid.samples(),
            Self::Adaptive(tree) => tree.samples(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn both(cells: usize) -> [Nodes; 2] {
        let cells = NonZeroUsize::new(cells).expect("more than none");
        [Nodes::Even(cells), Nodes::Adaptive(cells)]
    }

    proptest! {
        #[test]
        fn bilinear_functions_are_kept(
            c in [-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0], cells in 1usize..20, u in -1.0..1.0, v in -1.0..1.0,
        ) {
            let f = |[u, v]: [f64; 2]| c[0] + c[1] * u + c[2] * v + c[3] * u * v;
            for nodes in both(cells) {
                let mask = Mask::new(nodes, &|place| Some(f(place))).expect("all is known");
                prop_assert!((mask.at([u, v]) - f([u, v])).abs() < 1e-14);
            }
        }

        /// Where the shadow's edge does not pass, both tell light from dark; no value leaves the range of the samples.
        #[test]
        fn steps_stay_where_they_are(angle in 0.0..std::f64::consts::TAU, u in -1.0..1.0, v in -1.0..1.0) {
            let (sin, cos) = angle.sin_cos();
            let height = |[u, v]: [f64; 2]| u * cos + v * sin;
            for nodes in both(32) {
                let mask = Mask::new(nodes, &|place| Some(f64::from(height(place) > 0.0))).expect("known");
                let value = mask.at([u, v]);
                prop_assert!((0.0..=1.0).contains(&value));
                // Cells are 1/16 wide.
                if height([u, v]).abs() > 2.0 / 16.0 {
                    prop_assert_eq!(value, f64::from(height([u, v]) > 0.0));
                }
            }
        }
    }

    #[test]
    fn a_quadtree_is_fine_at_the_edge_alone() {
        let step = |[u, v]: [f64; 2]| Some(f64::from(u + 0.5 * v > 0.1));
        let [even, adaptive] = both(64).map(|nodes| Mask::new(nodes, &step).expect("known"));
        assert_eq!(even.samples(), 65 * 65);
        assert!(adaptive.samples() < even.samples() / 3, "{} samples", adaptive.samples());
    }

    /// A lit element on the middle of which something stands: the covered nodes do not darken the rim.
    #[test]
    fn covered_nodes_take_the_nearest_value() {
        let covered = |[u, v]: [f64; 2]| (-0.2..0.5).contains(&u) && (-0.6..0.6).contains(&v);
        for nodes in both(16) {
            let mask = Mask::new(nodes, &|x| (!covered(x)).then_some(0.75)).expect("the rim is free");
            for place in [[-0.21, 0.1], [0.3, 0.1], [-1.0, 1.0], [0.51, 0.61]] {
                assert_eq!(mask.at(place), 0.75);
            }
            assert_eq!(Mask::new(nodes, &|_| None), None);
        }
    }
}
