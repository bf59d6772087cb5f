//! Repair of what readers find: geometry that a radiosity scene refuses, and reflectances of no material.
//!
//! Each repair touches only what is wrong, and says what it did in one line; a sound model comes out equal to
//! the bit. Outlines are mended first, each by itself; then surfaces in the same place; then fronts, which
//! decide what lies on what; then faces that lie partly on others.

mod record;
mod edit;
mod vertices;
mod slivers;
mod outlines;
mod planes;
mod copies;
mod sheets;
mod coincident;
mod curved;
mod turned;
mod overlaps;
mod disks;
mod mantles;
mod reflectances;

use crate::model::{Model, Shape, Sides};
use crate::tolerances::GREATEST_OF_REPAIR;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
pub use record::{Repair, RepairKind, Repairs};

/// Options of the repair, as the user sets them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Length (the model's unit, ≥ 0) up to which points are one, where it is more than rounding leaves.
    pub tolerance: Option<f64>,
    /// Sides that count, for all surfaces, whatever the format says. Without it, surfaces whose format leaves
    /// it open are one-sided.
    pub sides: Option<Sides>,
    /// Whether fronts that point the wrong way are turned; else they are only reported.
    pub fix_fronts: bool,
}

/// Repairs a model and says what was wrong with it. No surface has [`Sides::Open`] afterwards. Shapes are
/// left as they are where a length is above 1e60.
pub fn repair(model: &mut Model, options: &Options) -> Repairs {
    let mut repairs = Repairs::default();
    let asked = options.tolerance.filter(|length| length.is_finite());
    settle_sides(model, options.sides);
    reflectances::mend(model, &mut repairs);
    if !model.surfaces.iter().all(|surface| is_within_reach(&surface.shape)) {
        return repairs;
    }
    slivers::remove(model, &mut repairs);
    vertices::mend(model, asked, &mut repairs);
    slivers::remove(model, &mut repairs);
    outlines::mend(model, asked, &mut repairs);
    planes::mend(model, &mut repairs);
    coincident::mend(model, &mut repairs);
    curved::mend(model, asked, &mut repairs);
    turned::mend(model, options.fix_fronts, &mut repairs);
    overlaps::mend(model, asked, &mut repairs);
    disks::mend(model, &mut repairs);
    mantles::mend(model, &mut repairs);
    repairs
}

/// Refuses, for those who want no repairs, a model read from `file` that needed some, in words that are `shown` so.
/// None if it needed none: fronts that were left as they are changed nothing.
pub fn refusal(repairs: &Repairs, file: &str, shown: impl Fn(&NoteText) -> String) -> Option<Refusal> {
    let made: Vec<&Repair> =
        repairs.list.iter().filter(|repair| repair.kind != RepairKind::DoubtfulFronts).collect();
    let first = made.first()?;
    let cause = match made.len() {
        1 => shown(&first.text),
        count => format!("{count} repairs are needed; the first: {}", shown(&first.text)),
    };
    let cure = "mend the file, or let it be repaired".to_owned();
    let file = first.file.as_deref().unwrap_or(file);
    Some(Refusal { place: first.place, ..Refusal::new(cause, cure).in_file(file) })
}

fn is_within_reach(shape: &Shape) -> bool {
    let (points, lengths) = shape.numbers();
    points.iter().all(|x| x.abs().max_element() <= GREATEST_OF_REPAIR)
        && lengths.iter().all(|length| *length <= GREATEST_OF_REPAIR)
}

fn settle_sides(model: &mut Model, asked: Option<Sides>) {
    let asked = asked.filter(|sides| *sides != Sides::Open);
    for surface in &mut model.surfaces {
        surface.sides = match (asked, surface.sides) {
            (Some(sides), _) => sides,
            (None, Sides::Open) => Sides::Front,
            (None, sides) => sides,
        };
    }
}
