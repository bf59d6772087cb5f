//! The cells of an element with its radiosity.
//!
//! A tree is as fine as the radiosity varies, and so fine that the points of its cells see every polynomial.

use radiosity_geom::{Aabb, DVec3};
use smallvec::smallvec;

use crate::elements::Element;
use crate::elements::patch::Node;
use crate::light::hierarchy::cell::{Cell, POINTS};

/// Levels of quarters below the patches of an element.
const DEEPEST: usize = 4;

/// Variation of the field, relative to its scale, below which a cell is not divided, in multiples of the accuracy asked.
const FINE: f64 = 30.0;

/// An element as an emitter.
#[derive(Debug)]
pub struct Tree {
    /// The cells that cover the element, one a patch.
    roots: Vec<Cell>,
    scale: Vec<f64>,
    /// Index of its surface.
    pub surface: usize,
    /// A point and the unit normal of its plane, where it is flat.
    pub plane: Option<(DVec3, DVec3)>,
    /// Bounding box of the element.
    pub bounds: Aabb,
}

/// A field over an element: writes the channels at a node of a patch.
pub(crate) type Field<'a> = &'a dyn Fn(&Node, &mut [f64]);

impl Tree {
    /// An element with the constant 1 in a single channel, that counts as `brightness` (positive) times the scale.
    pub fn uniform(element: &Element, brightness: f64) -> Self {
        Self::grown(element, &[1.0 / brightness], |bare, scale| {
            with_field(bare, scale, &|_, out| out.fill(1.0))
        })
    }

    /// An element with `field`, whose channels are measured by `scale` (positive), kept so finely that differences of `eps`
    /// times that are followed.
    pub fn new(element: &Element, scale: &[f64], eps: f64, field: Field<'_>) -> Self {
        // So many quarterings that 2 × 2 points a cell see every polynomial of the element.
        let least = element.basis.total_degree().div_ceil(4);
        Self::grown(element, scale, |bare, scale| {
            let growth = Growth { field, scale, least, rough: FINE * eps };
            growth.of(bare, 0)
        })
    }

    fn grown(element: &Element, scale: &[f64], grow: impl Fn(Cell, &[f64]) -> Cell) -> Self {
        Self {
            roots: element.patches.iter().map(|patch| grow(Cell::bare(patch.clone()), scale)).collect(),
            scale: scale.to_vec(),
            surface: element.surface,
            plane: element.plane,
            bounds: element.bounds(),
        }
    }

    /// The cells that cover the element, one a patch.
    pub fn roots(&self) -> &[Cell] {
        &self.roots
    }

    /// The scale of each channel.
    pub fn scale(&self) -> &[f64] {
        &self.scale
    }
}

/// How cells are divided for a field.
struct Growth<'a> {
    field: Field<'a>,
    scale: &'a [f64],
    /// Levels that are divided anyhow.
    least: usize,
    /// Variation over the scale above which a cell is divided.
    rough: f64,
}

impl Growth<'_> {
    fn of(&self, bare: Cell, level: usize) -> Cell {
        let mut cell = with_field(bare, self.scale, self.field);
        if level < DEEPEST && (level < self.least || cell.spread > self.rough) {
            let quarters = cell.bare_quarters().map(|quarter| self.of(quarter, level + 1));
            cell.divide(quarters, self.scale);
        }
        cell
    }
}

fn with_field(bare: Cell, scale: &[f64], field: Field<'_>) -> Cell {
    let mut values = smallvec![0.0; POINTS * scale.len()];
    for (node, out) in bare.nodes.iter().zip(values.chunks_exact_mut(scale.len())) {
        field(node, out);
    }
    bare.with_values(values, scale)
}
