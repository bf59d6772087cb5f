//! Faults of scene files, with the cure that the message names.

mod surfaces;
mod materials;
mod skies;
mod luminaires;
mod motions;
mod formulas;
mod heat;
mod planes;
mod parts;
mod texts;
mod masks;

use super::Row;

/// Rooms that are refused, and rooms that are right, by kind.
pub(super) const ROWS: &[&[Row]] = &[
    surfaces::ROWS,
    materials::ROWS,
    skies::ROWS,
    luminaires::ROWS,
    motions::ROWS,
    formulas::ROWS,
    heat::ROWS,
    planes::ROWS,
    parts::ROWS,
    texts::ROWS,
    masks::ROWS,
];
