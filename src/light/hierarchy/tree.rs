//! The tree of cells of an element, with its radiosity.
//!
//! A tree is as fine as the radiosity varies, and at least so fine that its points see every polynomial.

use std::sync::Arc;

use radiosity_geom::{Aabb, DVec3};
use smallvec::smallvec;

use crate::elements::Element;
use crate::elements::patch::Node;
use crate::light::hierarchy::cell::{Cell, POINTS};
use crate::scene::Outlook;

/// Most levels of quarters below the patches of an element. Chosen; not tuned.
const DEEPEST: usize = 4;

/// A cell whose field varies by less than this multiple of the accuracy is not divided. Chosen; not tuned.
const FINE: f64 = 30.0;

/// An element as a sender of light.
#[derive(Debug)]
pub struct Tree {
    /// The cells that cover the element, one per patch.
    roots: Vec<Cell>,
    scale: Vec<f64>,
    /// Index of its surface.
    pub surface: usize,
    /// A point of the element's plane and the unit normal, if it is flat.
    pub plane: Option<(DVec3, DVec3)>,
    /// Bounding box of the element.
    pub bounds: Aabb,
    /// What it sees, if it is an opening to a sky: the field is then multiplied by the light towards the receiver.
    pub outlook: Option<Arc<Outlook>>,
}

/// A field over an element: writes the value of each channel at a node of a patch.
pub(crate) type Field<'a> = &'a dyn Fn(&Node, &mut [f64]);

impl Tree {
    /// The tree of an element of exitance 1 in one channel, whose brightness is `brightness` > 0 times the scale.
    pub fn uniform(element: &Element, brightness: f64) -> Self {
        Self::grown(element, &[1.0 / brightness], |bare, scale| {
            with_field(bare, scale, &|_, out| out.fill(1.0))
        })
    }

    /// The tree of an opening that sees this, if it is one.
    pub fn seeing(self, outlook: Option<Arc<Outlook>>) -> Self {
        Self { outlook, ..self }
    }

    /// The tree of an element with `field`, whose channels have the positive `scale`; it resolves the field to about
    /// the accuracy `eps` relative to the scale.
    pub fn new(element: &Element, scale: &[f64], eps: f64, field: Field<'_>) -> Self {
        // ⌈N/4⌉ quarterings: the 2 × 2 points per cell then see every polynomial of the element.
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
            outlook: None,
        }
    }

    /// The cells that cover the element, one per patch.
    pub fn roots(&self) -> &[Cell] {
        &self.roots
    }

    /// The scale of each channel.
    pub fn scale(&self) -> &[f64] {
        &self.scale
    }
}

/// The rule by which cells are divided for a field.
struct Growth<'a> {
    field: Field<'a>,
    scale: &'a [f64],
    /// Levels that are divided in any case.
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
