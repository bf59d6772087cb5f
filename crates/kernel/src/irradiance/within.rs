//! Irradiance at a point through what lies within a convex window, a polygon or a disk, and within a convex outline
//! of arcs and segments.
//!
//! The border of what lies within both is made of the parts of the outline inside the window and the parts of the
//! window's border within the outline. Each has its term ([`crate::irradiance::outline`]), in whatever order. The
//! outline is cut where it passes the window's border, and that border at these places, so that parts join to
//! rounding. Which parts count is told by places amid them: of the outline against the window, of the window's border
//! against the thing itself.
//!
//! A closed border starts as often as it ends at each of its places: with g a function of directions,
//!
//! ```text
//! Σ_parts g(end) − g(start) = 0 ,     g(u) = (1 + c·u) u ,   c fixed, along no axis of symmetry.
//! ```
//!
//! Where an outline and the window's border fall on each other, a part may count twice or not at all, and the sum is
//! not 0. Then windows move by 10⁻⁹ of their distance, and kites take the place of an outline that is open for all
//! that.

use core::f64::consts::TAU;

use radiosity_geom::{COINCIDENT, DVec3, area_vector};
use radiosity_visibility::round_outline::RoundOutline;
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::Coverage;
use smallvec::{SmallVec, smallvec};

use crate::irradiance::lambert;
use crate::irradiance::outline::{Arc, Piece};

/// Largest sum over a closed border, and how far its light may lie below none.
const CLOSED: f64 = 1e-10;

/// Distance by which windows move, over theirs from the point, and how often they do.
pub(super) const MOVED: f64 = 1e-9;
pub(super) const MOVES: usize = 2;

/// c of the header.
const UNEVEN: DVec3 = DVec3::new(0.31, 0.17, 0.43);

/// Corners of kites: they miss 7e-10 of the shadow of something far.
const KITES: usize = 128;

/// Places that tell of a part of the outline whether it lies inside: one may lie on a border that is touched.
const PLACES: [f64; 3] = [0.5, 0.31, 0.77];

/// The common part of a window and an outline.
#[derive(Clone, Copy, Debug)]
pub struct Within {
    /// Irradiance from it at exitance 1.
    pub irradiance: f64,
    /// How much of the window lies within the outline.
    pub coverage: Coverage,
}

impl Within {
    /// No common part.
    pub(super) const NONE: Self = Self { irradiance: 0.0, coverage: Coverage::Clear };
}

/// A convex bound of a view, relative to the point. Its border runs as the outline does.
pub(super) trait Window {
    /// Where a piece of the outline passes the border, as parts of the piece; cuts the border there.
    fn cut(&mut self, piece: &Piece) -> SmallVec<[f64; 8]>;

    /// Positive for directions inside, negative outside, 1 about at the most.
    fn depth(&self, direction: DVec3) -> f64;

    /// The parts of the border between its cuts.
    fn parts(&mut self) -> SmallVec<[Piece; 8]>;
}

/// The part of a convex polygon, all of it beyond a round thing, within kites that stand for its outline.
pub(super) fn by_kites(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Within {
    let part = shadow.kites(polygon, KITES);
    if part.len() < 3 {
        return Within::NONE;
    }
    let coverage = if part[..] == *polygon { Coverage::Hidden } else { Coverage::Mixed };
    Within { irradiance: lambert::polygon(n, &part), coverage }
}

/// The common part of the outline of a round thing and a window, all of it beyond the thing and above the horizon of
/// the unit normal `n`; None where its border is not closed. `window` makes the window to a sense of the outline:
/// 1 where that runs anticlockwise as seen from the point, else -1.
pub(super) fn within<W: Window>(
    n: DVec3,
    shadow: &RoundShadow,
    window: impl FnOnce(f64) -> W,
) -> Option<Within> {
    let pieces = pieces(&shadow.outline);
    let turn = sense_of(&pieces).signum();
    let mut window = window(turn);
    let mut border = Border { n, light: 0.0, open: DVec3::ZERO };
    let mut has_outline = false;
    for piece in &pieces {
        for range in inside(piece, &mut window) {
            has_outline = true;
            border.add(&piece.part(range));
        }
    }
    let (mut any, mut all) = (false, true);
    for part in window.parts() {
        let is_hidden = shadow.holds(part.amid());
        any |= is_hidden;
        all &= is_hidden;
        if is_hidden {
            border.add(&part);
        }
    }
    let light = turn * border.light / TAU;
    let coverage = match (has_outline || any, has_outline || !all) {
        (false, _) => Coverage::Clear,
        (true, false) => Coverage::Hidden,
        (true, true) => Coverage::Mixed,
    };
    let is_closed = border.open.length() <= CLOSED && light >= -CLOSED;
    is_closed.then_some(Within { irradiance: light.max(0.0), coverage })
}

/// The pieces of an outline, joined end to end.
fn pieces(outline: &RoundOutline) -> SmallVec<[Piece; 4]> {
    let arc = |k: usize| {
        let rim = outline.rims[k % outline.rims.len()];
        Arc { center: rim.center, axes: rim.axes, angles: rim.angles }
    };
    let mut pieces = SmallVec::new();
    for k in 0..outline.rims.len() {
        let [own, next] = [arc(k), arc(k + 1)];
        if own.angles[0] != own.angles[1] {
            pieces.push(Piece::Arc(own));
        }
        if outline.rims.len() > 1 {
            pieces.push(Piece::Segment([own.ends()[1], next.ends()[0]]));
        }
    }
    pieces
}

/// Positive where an outline runs anticlockwise as seen from the point.
fn sense_of(pieces: &[Piece]) -> f64 {
    let places: SmallVec<[DVec3; 12]> =
        pieces.iter().flat_map(|piece| [0.0, 1.0 / 3.0, 2.0 / 3.0].map(|part| piece.at(part))).collect();
    area_vector(&places).dot(places.iter().sum())
}

/// A sum along a border.
struct Border {
    n: DVec3,
    /// 2π of the irradiance.
    light: f64,
    /// Σ g(end) − g(start).
    open: DVec3,
}

impl Border {
    fn add(&mut self, part: &Piece) {
        let [start, end] = [0.0, 1.0].map(|end| {
            let direction = part.at(end).normalize_or_zero();
            (1.0 + UNEVEN.dot(direction)) * direction
        });
        self.open += end - start;
        self.light += part.integral(self.n);
    }
}

/// The parts of a piece inside a window, as ranges of 0 to 1; cuts the window's border where the piece passes it.
fn inside(piece: &Piece, window: &mut impl Window) -> SmallVec<[[f64; 2]; 4]> {
    let mut places: SmallVec<[f64; 12]> = smallvec![0.0, 1.0];
    places.extend(window.cut(piece));
    places.sort_by(f64::total_cmp);
    let mut found: SmallVec<[[f64; 2]; 4]> = SmallVec::new();
    for ends in places.windows(2).filter(|ends| ends[0] < ends[1]) {
        if !is_inside(piece, [ends[0], ends[1]], window) {
            continue;
        }
        match found.last_mut() {
            Some([_, last]) if *last == ends[0] => *last = ends[1],
            _ => found.push([ends[0], ends[1]]),
        }
    }
    found
}

/// Whether a part of a piece lies inside a window: by the first of a few places that does not lie on the border.
fn is_inside(piece: &Piece, [from, to]: [f64; 2], window: &impl Window) -> bool {
    let depth = |part: f64| window.depth(piece.at(from + part * (to - from)).normalize_or_zero());
    let told = PLACES.into_iter().map(depth).find(|depth| depth.abs() > COINCIDENT);
    told.is_some_and(|depth| depth > 0.0)
}
