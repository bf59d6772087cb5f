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
//!
//! The light of the sun and of luminaires has steps: the border of a sun's patch, the edge of a spot, shadows.
//! A step that enters a cell from beside it crosses the border of the cell. So a cell beside a step, whose points and
//! quarters see none, is asked along its border too; where beams may light a small part of a patch, so are all
//! cells of some levels, until they are narrower than the beams. A cell that is not divided further beside a step
//! takes its mean from more points: where a step runs along the sides of cells, four points would err in one
//! direction in a whole row of them.

use radiosity_elements::Element;
use radiosity_elements::patch::Node;
use radiosity_elements::sampling::kronecker;
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

/// Points for the mean of a cell beside a step, in which no step is found. Chosen.
const ASKED: u64 = 8;

/// Points for the mean of a cell in which a step is found. Measured with patches of the sun beside quadrature: with 8
/// the light of a small patch erred by up to 1.3 %.
const SETTLED: u64 = 32;

/// Points along each side of a cell at which a step is looked for. Chosen: the part of a lit disk that enters a cell
/// unseen, between two of these points, is below 0.3 % of it if the disk is as wide as the cell.
const ALONG_A_SIDE: usize = 4;

/// Distance of these points from the border, over the width of the cell. Chosen: the border of a patch may touch
/// another surface, and a step in the strip outside these points lights or shades 1 % of the cell.
const INSET: f64 = 0.01;

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

/// Steps of a field over an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Steps {
    /// None but at corners and edges: the light of surfaces.
    Nowhere,
    /// Edges of shadows: the light of points.
    Shadows,
    /// Borders of what the sun or a narrow beam lights, too; so many levels of cells are all made for them.
    Beams(usize),
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

    /// The radiance of an opening to a sky; None of other emitters.
    pub(crate) fn opening(&self) -> Option<&Radiance> {
        self.radiance.as_ref().filter(|own| own.is_of_opening())
    }

    /// The zenith of the sky behind it, if it is an opening.
    pub(crate) fn zenith(&self) -> Option<DVec3> {
        self.opening()?.zenith()
    }

    /// Whether it is an opening in which one of `points`, or a point between them, may see the horizon.
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
    /// to about the accuracy `eps` relative to the scale, and its `steps`.
    pub(crate) fn new(element: &Element, scale: &[f64], steps: Steps, eps: f64, field: Field<'_>) -> Self {
        // ⌈N/4⌉ quarterings: the 2 × 2 points per cell then see every polynomial of the element.
        let of_beams = if let Steps::Beams(levels) = steps { levels } else { 0 };
        let least = element.basis.total_degree().div_ceil(4).max(of_beams);
        let has_steps = steps != Steps::Nowhere;
        Self::grown(element, scale, |bare, scale| {
            let (rough, bent) = (FINE * eps, BENT * eps);
            let growth = Growth { field, scale, least, of_beams, has_steps, rough, bent };
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
    /// Levels that are asked along their borders in any case.
    of_beams: usize,
    /// Whether the field has steps anywhere.
    has_steps: bool,
    /// Variation over the scale above which a cell is divided.
    rough: f64,
    /// Limit BENT ε.
    bent: f64,
}

impl Growth<'_> {
    fn of(&self, bare: Cell) -> Cell {
        let cell = with_field(bare, self.scale, self.field);
        self.divided(cell, Border::WHOLE, 0, Above { bends: false, has_step: false })
    }

    /// The cell with the quarters that it needs below a cell of which is known how it follows the field.
    fn divided(&self, mut cell: Cell, border: Border, level: usize, above: Above) -> Cell {
        if self.suffices(&cell, level, above) {
            if above.has_step {
                self.settle(&mut cell);
            }
            return cell;
        }
        let quarters = cell.bare_quarters().map(|quarter| with_field(quarter, self.scale, self.field));
        let misfit = self.misfit(&cell, &quarters, level, above);
        let mut borders = border.of_quarters(cell.directions()).into_iter();
        let quarters = quarters.map(|mut quarter| {
            let border = borders.next().expect("there are four");
            if misfit.jumps {
                quarter.mark_rough();
            }
            let bends = misfit.size * seen(&border, level + 1) > self.bent;
            self.divided(quarter, border, level + 1, Above { bends, has_step: misfit.is_step })
        });
        cell.divide(quarters, self.scale);
        cell
    }

    /// Whether a cell needs no quarters.
    fn suffices(&self, cell: &Cell, level: usize, above: Above) -> bool {
        let varies = level < EVEN && cell.field.spread > self.rough;
        level == MOST_QUARTERINGS_OF_FIELD || !(level < self.least || varies || above.bends)
    }

    /// How a cell misses its quarters, or the field along its border if a step may be there.
    fn misfit(&self, cell: &Cell, quarters: &[Cell; 4], level: usize, above: Above) -> Misfit {
        let mut size = cell.misfit(quarters, self.scale);
        let is_asked = above.has_step || level < self.of_beams;
        if is_asked && size <= self.bent {
            let at_border = self.misfit_at_border(cell);
            size = size.max(if at_border > JUMP * cell.field.spread { at_border } else { 0.0 });
        }
        let jumps = size > JUMP * cell.field.spread;
        Misfit { size, jumps, is_step: self.has_steps && (jumps || size > self.bent) }
    }

    /// Gives a cell beside a step its mean by more points.
    fn settle(&self, cell: &mut Cell) {
        let mut sum = Residuals::none(self.scale.len());
        (0..ASKED).for_each(|k| self.add_residual(cell, kronecker::point(k), &mut sum));
        if sum.largest > self.bent {
            (ASKED..SETTLED).for_each(|k| self.add_residual(cell, kronecker::point(k), &mut sum));
        }
        if sum.area > 0.0 {
            let means: Vec<f64> = sum.of_channels.iter().map(|residual| residual / sum.area).collect();
            cell.shift(&means, self.scale);
        }
    }

    /// Adds the difference of the field from the bilinear function of a cell at a place.
    fn add_residual(&self, cell: &Cell, place: [f64; 2], sum: &mut Residuals) {
        let node = cell.node(place);
        let mut values = vec![0.0; self.scale.len()];
        (self.field)(&node, &mut values);
        sum.area += node.area;
        for (channel, (value, scale)) in values.iter().zip(self.scale).enumerate() {
            let residual = value - cell.bilinear(place, channel);
            sum.of_channels[channel] += node.area * residual;
            sum.largest = sum.largest.max(residual.abs() / scale);
        }
    }

    /// Largest difference of the field along the border of a cell from its bilinear function, over the channel's
    /// scale.
    fn misfit_at_border(&self, cell: &Cell) -> f64 {
        let mut sum = Residuals::none(self.scale.len());
        let inwards = |place: f64| place + INSET * (1.0 - 2.0 * place);
        for k in 0..ALONG_A_SIDE {
            let part = k as f64 / ALONG_A_SIDE as f64;
            let places = [[part, 0.0], [1.0, part], [1.0 - part, 1.0], [0.0, 1.0 - part]];
            places.iter().for_each(|place| self.add_residual(cell, place.map(inwards), &mut sum));
        }
        sum.largest
    }
}

/// Differences of a field from the bilinear function of a cell at some places.
struct Residuals {
    /// Sum of the area elements there.
    area: f64,
    /// Sum per channel, by area.
    of_channels: Vec<f64>,
    /// The largest, over the scale of its channel.
    largest: f64,
}

impl Residuals {
    /// No differences yet.
    fn none(channels: usize) -> Self {
        Self { area: 0.0, of_channels: vec![0.0; channels], largest: 0.0 }
    }
}

/// How a cell misses the field.
#[derive(Clone, Copy)]
struct Misfit {
    /// Largest difference, over the channel's scale.
    size: f64,
    /// Whether the field jumps.
    jumps: bool,
    /// Whether a step may be in the cell.
    is_step: bool,
}

/// How the cell above one follows the field.
#[derive(Clone, Copy)]
struct Above {
    /// Whether its bilinear function misses it.
    bends: bool,
    /// Whether a step may be in it.
    has_step: bool,
}

/// Part of a view that a cell of this level may fill, where corners count [`BENT`] and others [`BEYOND`].
fn seen(border: &Border, level: usize) -> f64 {
    let width = 0.5f64.powi(level as i32);
    match border.touched() {
        0 => BENT / BEYOND * width * width,
        1 => width,
        _ => 1.0,
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
