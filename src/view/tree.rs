//! The cells of an element with its radiosity.
//!
//! A tree is as fine as the radiosity varies, and so fine that the points of its cells see every polynomial.

use radiosity_geom::{Aabb, DVec3};

use crate::elements::Element;
use crate::elements::patch::Node;
use crate::view::cell::{Cell, POINTS};

/// Levels of quarters below the patches of an element.
const DEEPEST: usize = 4;

/// Cosine between the normals of a cell of a uniform element below which it is divided beforehand.
const STRAIGHT: f64 = 0.8;

/// Variation of the field, relative to its scale, below which a cell is not divided, in multiples of the accuracy asked.
const FINE: f64 = 30.0;

/// An element as an emitter.
#[derive(Debug)]
pub struct Tree {
    cells: Vec<Cell>,
    /// First of the four quarters of each cell, where the tree has them.
    quarters: Vec<Option<usize>>,
    roots: usize,
    scale: Vec<f64>,
    /// Index of its surface.
    pub surface: usize,
    /// A point and the unit normal of its plane, where it is flat.
    pub plane: Option<(DVec3, DVec3)>,
    /// Bounding box of the element.
    pub bounds: Aabb,
}

/// A field over an element: writes the channels at a node of a patch.
pub type Field<'a> = &'a dyn Fn(&Node, &mut [f64]);

impl Tree {
    /// An element with the constant 1 in a single channel, that counts as `brightness` (positive) times the scale.
    pub fn uniform(element: &Element, brightness: f64) -> Self {
        let mut tree = Self::bare(element, &[1.0 / brightness]);
        let one: Field<'_> = &|_, out| out.fill(1.0);
        for patch in &element.patches {
            tree.push(Cell::bare(patch.clone()), one);
        }
        tree.roots = tree.cells.len();
        let (mut level, mut start) = (0, 0);
        while level < DEEPEST && start < tree.cells.len() {
            let end = tree.cells.len();
            for index in start..end {
                if tree.cells[index].bend < STRAIGHT {
                    tree.divide(index, one);
                }
            }
            (level, start) = (level + 1, end);
        }
        tree
    }

    /// An element with `field`, whose channels are measured by `scale` (positive), kept so finely that differences of `eps`
    /// times that are followed.
    pub fn new(element: &Element, scale: &[f64], eps: f64, field: Field<'_>) -> Self {
        let mut tree = Self::bare(element, scale);
        // So many quarterings that 2 × 2 points a cell see every polynomial of the element.
        let least = element.basis.total_degree().div_ceil(4);
        for patch in &element.patches {
            tree.push(Cell::bare(patch.clone()), field);
        }
        tree.roots = tree.cells.len();
        let (mut level, mut start) = (0, 0);
        while level < DEEPEST && start < tree.cells.len() {
            let end = tree.cells.len();
            for index in start..end {
                if level < least || tree.cells[index].spread > FINE * eps {
                    tree.divide(index, field);
                }
            }
            (level, start) = (level + 1, end);
        }
        tree
    }

    fn bare(element: &Element, scale: &[f64]) -> Self {
        Self {
            cells: Vec::new(),
            quarters: Vec::new(),
            roots: 0,
            scale: scale.to_vec(),
            surface: element.surface,
            plane: element.plane,
            bounds: element.bounds(),
        }
    }

    fn push(&mut self, cell: Cell, field: Field<'_>) {
        let channels = self.scale.len();
        let mut values = vec![0.0; POINTS * channels];
        for (node, out) in cell.nodes.iter().zip(values.chunks_exact_mut(channels)) {
            field(node, out);
        }
        self.cells.push(cell.with_values(values, &self.scale));
        self.quarters.push(None);
    }

    fn divide(&mut self, index: usize, field: Field<'_>) {
        let first = self.cells.len();
        for quarter in self.cells[index].bare_quarters() {
            self.push(quarter, field);
        }
        self.quarters[index] = Some(first);
        let (above, below) = self.cells.split_at_mut(first);
        above[index].look_at(below, &self.scale);
    }

    /// The cells that cover the element, one a patch.
    pub fn roots(&self) -> std::ops::Range<usize> {
        0..self.roots
    }

    /// A cell.
    pub fn cell(&self, index: usize) -> &Cell {
        &self.cells[index]
    }

    /// Index of the first of the four quarters of a cell, which follow each other.
    pub fn quarters(&self, index: usize) -> Option<usize> {
        self.quarters[index]
    }

    /// The scale of each channel.
    pub fn scale(&self) -> &[f64] {
        &self.scale
    }
}
