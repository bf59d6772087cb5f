//! The lattices of nodes of one surface.
//!
//! ```text
//! u_i = −1 + 2 i/(m 2^l) ,     v_j = −1 + 2 j/(n 2^l) ,     l = 0, 1, …
//! ```
//!
//! with m × n cells of about one side at first; narrow ones are divided into two, and further when the others are as
//! narrow. Nodes of a lattice are nodes of all finer ones. A node outside of
//! the open part of a flat surface lies at the nearest point of its border.

use radiosity_elements::Elements;

use super::extent::Extent;
use super::fit::weight;
use super::open_part::{OpenPart, open_place};
use crate::pictures::eye::SeenPlace;

/// Side of the first cells over the diagonal of the scene: light in a room varies over some parts of it. Chosen.
const FIRST: f64 = 1.0 / 16.0;

/// Fewest first cells along a parameter of a flat surface: fits to its corners alone leave little, whatever lies
/// between. Measured under a backrest of 50 × 6 cm: with one light was 14 % too bright. And of a curved one, on which
/// light varies with the normal. Chosen.
const FEWEST_FLAT: usize = 2;
const FEWEST_CURVED: usize = 4;

/// A node of the lattices of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct NodeIndex {
    /// Index of the surface.
    pub surface: usize,
    /// Place in its finest lattice.
    finest: [u32; 2],
}

/// The lattices of a surface.
pub(super) struct Lattice {
    surface: usize,
    /// Cells of the first lattice along u and along v.
    cells: [usize; 2],
    /// Halvings of longer cells after which those along u and along v are divided further than into two.
    later: [u32; 2],
    /// Longest side of these (scene length).
    side: f64,
    /// The open part of a flat surface; None of a curved one.
    open: Option<OpenPart>,
}

impl Lattice {
    /// The finest level. Chosen: no picture shows a thousandth of a first cell.
    pub(super) const FINEST: u32 = 12;

    /// The lattices of a surface in a scene of this diagonal.
    pub(super) fn of(elements: &Elements, surface: usize, diagonal: f64) -> Self {
        let shape = elements.shape(surface);
        let lengths = Extent::of(shape).lengths;
        let open = shape.region().map(|_| OpenPart::of(elements, surface));
        let fewest = if open.is_some() { FEWEST_FLAT } else { FEWEST_CURVED };
        let cells = lengths.map(|length| ((length / (FIRST * diagonal)).ceil() as usize).max(fewest));
        let sides: [f64; 2] = std::array::from_fn(|axis| lengths[axis] / cells[axis] as f64);
        let side = sides[0].max(sides[1]);
        let later = sides.map(|own| (side / own).log2().clamp(0.0, f64::from(Self::FINEST)) as u32);
        Self { surface, cells, later, side, open }
    }

    /// Longest side of the cells of a level (scene length).
    pub(super) fn side(&self, level: u32) -> f64 {
        self.side / f64::from(1_u32 << level)
    }

    /// The four nodes of the cell that holds these parameters.
    pub(super) fn about(&self, parameters: [f64; 2], level: u32) -> impl Iterator<Item = NodeIndex> + use<> {
        self.nodes(parameters, level, [0, 1])
    }

    /// The nodes of that cell and of those beside it.
    pub(super) fn around(&self, parameters: [f64; 2], level: u32) -> impl Iterator<Item = NodeIndex> + use<> {
        self.nodes(parameters, level, [-1, 2])
    }

    /// Nodes from `steps[0]` to `steps[1]` of the first one of the cell that holds these parameters, both ways.
    fn nodes(
        &self,
        parameters: [f64; 2],
        level: u32,
        steps: [i64; 2],
    ) -> impl Iterator<Item = NodeIndex> + use<> {
        let halvings = self.halvings(level);
        let surface = self.surface;
        let counts: [i64; 2] = std::array::from_fn(|axis| (self.cells[axis] << halvings[axis]) as i64);
        let at = self.steps(parameters, level);
        let first: [i64; 2] = std::array::from_fn(|axis| (at[axis] as i64).clamp(0, counts[axis] - 1));
        let side = steps[0]..=steps[1];
        let all = side.clone().flat_map(move |j| side.clone().map(move |i| [first[0] + i, first[1] + j]));
        all.filter(move |at| (0..2).all(|axis| (0..=counts[axis]).contains(&at[axis]))).map(move |at| {
            NodeIndex {
                surface,
                finest: std::array::from_fn(|axis| (at[axis] as u32) << (Self::FINEST - halvings[axis])),
            }
        })
    }

    /// Halvings of the first cells along u and along v in a level. Fits need three nodes along each.
    fn halvings(&self, level: u32) -> [u32; 2] {
        self.later.map(|later| level.saturating_sub(later).max(level.min(1)))
    }

    /// Parameters in steps of a lattice from its first node.
    fn steps(&self, parameters: [f64; 2], level: u32) -> [f64; 2] {
        let halvings = self.halvings(level);
        std::array::from_fn(|axis| {
            0.5 * (1.0 + parameters[axis]) * (self.cells[axis] << halvings[axis]) as f64
        })
    }

    /// The weight of a node at some parameters in the fit at others, by the cells of a level.
    pub(super) fn weight(&self, own: [f64; 2], other: [f64; 2], level: u32) -> f64 {
        let (own, other) = (self.steps(own, level), self.steps(other, level));
        weight([own[0] - other[0], own[1] - other[1]])
    }

    /// The place of a node; None where no open place is near.
    pub(super) fn place(&self, elements: &Elements, node: NodeIndex, diagonal: f64) -> Option<SeenPlace> {
        let own: [f64; 2] = std::array::from_fn(|axis| {
            let count = self.cells[axis] << Self::FINEST;
            -1.0 + 2.0 * f64::from(node.finest[axis]) / count as f64
        });
        open_place(elements, self.surface, self.open.as_ref(), own, f64::INFINITY, diagonal)
    }
}
