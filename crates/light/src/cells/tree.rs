//! The tree of cells of an element, with its radiosity.
//!
//! A tree is at least so fine that its points see every polynomial. Where the radiosity varies, it has all
//! cells of [`EVEN`] levels; below them cells are divided while the bilinear function of a cell misses its
//! quarters by δ (in multiples of the scale) and
//!
//! ```text
//! δ > BENT ε         for a cell in a corner of the patch ;
//! δ w > BENT ε       for one at its border, of the width w = 2^−level ;
//! δ w² > BEYOND ε    for the others :
//! ```
//!
//! a cell fills much of the view of a receiver on another surface that lies beside it in a corner, or along
//! an edge, however small it is; the share of such receivers is about w along an edge. Other cells fill about
//! w² of any view. So shadow edges end at the width that the accuracy asks for; corners of three surfaces, in
//! which light depends on the direction to the corner alone, have cells down to
//! [`MOST_QUARTERINGS_OF_FIELD`], few of them; before a luminaire near a surface cells are as small as its
//! light peaks.

use radiosity_elements::Element;
use radiosity_elements::patch::Node;
use radiosity_geom::{Aabb, DVec3, Plane};
use radiosity_scene::Radiance;
use radiosity_work::interruption::check_interrupt;
use smallvec::smallvec;

use crate::cells::border::Border;
use crate::cells::cell::{Cell, POINTS};
use crate::occluders::Sender;
use crate::tolerances::MOST_QUARTERINGS_OF_FIELD;

/// Levels of quarters below the patches of an element that are all made where the field varies, so that no
/// small shadow is overlooked: down to a sixteenth of a patch. Each further one takes four times the cells.
const EVEN: usize = 4;

/// Multiple of the accuracy by which the bilinear function of a cell in a corner or at the border of a patch
/// may miss its quarters: see the head of this file. Few receivers lie beside such a cell. With a smaller
/// value corners and borders have many more cells.
const BENT: f64 = 10.0;

/// Multiple of the accuracy for other cells. With 10 here too, 2 % of the power was lost of a luminaire 5 cm
/// below a ceiling 4 m wide.
const BEYOND: f64 = 1.0;

/// A field jumps in a cell where its bilinear function misses the quarters by more than this part of its
/// variation, as it does at a step; it misses a bend by less.
const JUMP: f64 = 0.5;

/// A cell whose field varies by less than this multiple of the accuracy is not divided for that: its bilinear
/// function follows most of a variation. With a larger value small shadows are overlooked; with a smaller one
/// all cells of slowly varying fields are made.
const FINE: f64 = 30.0;

/// An element as a sender of light.
#[derive(Debug)]
pub(crate) struct Tree {
    /// The cells that cover the element, one per patch.
    roots: Vec<Cell>,
    scale: Vec<f64>,
    /// Index of its surface.
    pub(crate) surface: usize,
    /// The element's plane, if it is flat.
    pub(crate) plane: Option<Plane>,
    /// Bounding box of the element.
    pub(crate) bounds: Aabb,
    /// Angular distribution of its light, if it is no diffuse emitter: the field is then multiplied by the
    /// light towards the receiver.
    pub(crate) radiance: Option<Radiance>,
}

/// A field over an element: writes the value of each channel at a node of a patch.
pub(crate) type Field<'a> = &'a dyn Fn(&Node, &mut [f64]);

impl Tree {
    /// The tree of an element of exitance 1 in one channel, whose brightness is `brightness` > 0 times the
    /// scale.
    pub(crate) fn uniform(element: &Element, brightness: f64) -> Self {
        Self::grown(element, &[1.0 / brightness], |bare, scale| {
            with_field(bare, scale, &|_, out| out.fill(1.0))
        })
    }

    /// The tree of an element that spreads its light so, if it is no diffuse emitter.
    pub(crate) fn spread(self, radiance: Option<Radiance>) -> Self {
        Self { radiance, ..self }
    }

    /// The zenith of the sky behind it, if it is an opening.
    pub(crate) fn zenith(&self) -> Option<DVec3> {
        self.radiance.as_ref()?.zenith()
    }

    /// The radiance of an opening to a sky; None of other emitters.
    pub(crate) fn opening(&self) -> Option<&Radiance> {
        self.radiance.as_ref().filter(|own| own.zenith().is_some())
    }

    /// Whether, from one of `points` or a point between them, the horizon may cross the element, behind which
    /// a jumps there.
    pub(crate) fn meets_horizon(&self, points: &[DVec3]) -> bool {
        let Some(zenith) = self.zenith() else { return false };
        let heights = |some: &[DVec3]| {
            let heights = some.iter().map(|x| x.dot(zenith));
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)))
        };
        let ((own_low, own_high), (low, high)) = (heights(&self.bounds.corners()), heights(points));
        low < own_high && high > own_low
    }

    /// The element as a sender of light, for lists of occluders.
    pub(crate) fn sender(&self) -> Sender {
        Sender { surface: self.surface, plane: self.plane, bounds: self.bounds }
    }

    /// The tree of an element with `field`, whose channels have the positive `scale`; it resolves the field
    /// to about the accuracy `eps` relative to the scale.
    pub(crate) fn new(element: &Element, scale: &[f64], eps: f64, field: Field<'_>) -> Self {
        // ⌈N/4⌉ quarterings: the 2 × 2 points per cell then see every polynomial of the element.
        let least = element.basis.total_degree().div_ceil(4);
        Self::grown(element, scale, |bare, scale| {
            let growth = Growth { field, scale, least, rough: FINE * eps, bent: BENT * eps };
            growth.of(bare)
        })
    }

    fn grown(element: &Element, scale: &[f64], grow: impl Fn(Cell, &[f64]) -> Cell) -> Self {
        Self {
            roots: element.patches.iter().map(|patch| grow(Cell::bare(patch.clone()), scale)).collect(),
            scale: scale.to_vec(),
            surface: element.surface,
            plane: element.plane,
            bounds: element.bounds(),
            radiance: None,
        }
    }

    /// The cells that cover the element, one per patch.
    pub(crate) fn roots(&self) -> &[Cell] {
        &self.roots
    }

    /// The scale of each channel.
    pub(crate) fn scale(&self) -> &[f64] {
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
    /// Limit BENT ε.
    bent: f64,
}

impl Growth<'_> {
    fn of(&self, bare: Cell) -> Cell {
        let cell = with_field(bare, self.scale, self.field);
        self.divided(cell, Border::WHOLE, 0, false)
    }

    /// The cell with the quarters that it needs; `bends` says whether the bilinear function of the cell above
    /// misses it.
    fn divided(&self, mut cell: Cell, border: Border, level: usize, bends: bool) -> Cell {
        let varies = level < EVEN && cell.spread > self.rough;
        if level == MOST_QUARTERINGS_OF_FIELD || !(level < self.least || varies || bends) {
            return cell;
        }
        let quarters = cell.bare_quarters().map(|quarter| with_field(quarter, self.scale, self.field));
        let misfit = cell.misfit(&quarters, self.scale);
        let jumps = misfit > JUMP * cell.spread;
        let borders = border.of_quarters(cell.directions());
        let width = 0.5f64.powi(level as i32 + 1);
        let mut index = 0;
        let quarters = quarters.map(|mut quarter| {
            let border = borders[index];
            index += 1;
            if jumps {
                quarter.mark_rough();
            }
            let seen = match border.touched() {
                0 => BENT / BEYOND * width * width,
                1 => width,
                _ => 1.0,
            };
            self.divided(quarter, border, level + 1, misfit * seen > self.bent)
        });
        cell.divide(quarters, self.scale);
        cell
    }
}

fn with_field(bare: Cell, scale: &[f64], field: Field<'_>) -> Cell {
    let mut values = smallvec![0.0; POINTS * scale.len()];
    check_interrupt();
    for (node, out) in bare.nodes.iter().zip(values.chunks_exact_mut(scale.len())) {
        field(node, out);
    }
    bare.with_values(values, scale)
}
