//! Commands that are refused, with the cure that the message names.

mod methods;
mod animations;
mod conversions;
mod heat;
mod scenes;
mod points;
mod factors;
mod pictures;
mod solutions;
mod studies;

use super::Typed;

/// Commands in the folder of `files`, by what they are for.
pub(super) const ROWS: &[&[Typed]] = &[
    methods::ROWS,
    animations::ROWS,
    conversions::ROWS,
    heat::ROWS,
    scenes::ROWS,
    points::ROWS,
    factors::ROWS,
    pictures::ROWS,
    solutions::ROWS,
    studies::ROWS,
];
