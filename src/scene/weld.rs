//! Corners and planes that agree to the rounding of the input are made to agree, once, when a scene is read.
//!
//! Models come in single precision or with few decimals: corners that are meant to be one miss each other, quadrilaterals
//! are not quite planar, feet hover over floors or reach into them by a trifle. The rules of transport tell touching from
//! apart, so all that is within the tolerance of the input is moved together here:
//!
//! 1. corners nearer to each other than the tolerance become one ([`corners`]);
//! 2. a corner so near to a flat sheet belongs to its plane, and sheets all of whose corners do share a plane ([`planes`]);
//! 3. all corners move as little as possible, in the sense of least squares, until each lies in its planes ([`flatten`]).
//!
//! Flat sheets that lie wholly before each other, however close, are left as they are: the rules hold for every gap, and
//! the sign of the gap says who is in front. What agrees to rounding already does not move, so clean scenes keep their bits.
//!
//! The tolerance is that of the two sheets in question ([`tolerance`]), or the length that was asked for.

mod apart;
mod corners;
mod flatten;
mod forest;
mod planes;
mod sheet;
mod tolerance;

use std::sync::Arc;

use radiosity_geom::{DVec3, Surface};

use corners::Corners;
use planes::Planes;
use sheet::Sheets;

/// What was moved when a scene was read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Welded {
    /// Corners moved, each counted once however many surfaces share it.
    pub corners: usize,
    /// The largest move (scene length).
    pub largest: f64,
}

/// Moves the corners of `shapes` as the module says. Their coordinates were rounded before `middle` was taken off; `asked` is the
/// tolerance (scene length) instead of that of the input.
pub(super) fn weld(shapes: &mut [&mut Arc<dyn Surface>], middle: DVec3, asked: Option<f64>) -> Welded {
    let sheets = Sheets::of(shapes, middle, asked);
    let apart = apart::pairs(&sheets);
    let corners = Corners::merged(&sheets, &apart);
    let planes = Planes::of(&sheets, &corners, &apart);
    let places = flatten::flattened(&corners, &planes, sheets.reach());
    let mut welded = Welded::default();
    for (from, node) in corners.starts() {
        let moved = places[node].distance(from);
        welded.corners += usize::from(moved > 0.0);
        welded.largest = welded.largest.max(moved);
    }
    let place = |x: DVec3| corners.node(x).map_or(x, |node| places[node]);
    for shape in shapes {
        let is_moved = shape.corners().iter().any(|x| place(*x) != *x);
        // A sheet that would collapse stays where it is.
        if let Some(Ok(moved)) = is_moved.then(|| shape.with_corners(&place)).flatten() {
            **shape = Arc::from(moved);
        }
    }
    welded
}
