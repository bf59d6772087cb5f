//! Irradiance at a point through a convex polygon within a convex outline of arcs and segments.
//!
//! The border of what lies within both runs along the outline inside the polygon, and from where a run leaves
//! it along its sides to where the next one enters. Places where the outline passes a side are roots on the
//! outline alone, so that the border is closed to rounding. Each part of it has its term
//! ([`crate::irradiance::outline`]).
//!
//! Where an outline and a side or a corner nearly touch, rounding may tell their order wrong, and a way goes
//! round the polygon the wrong way: few kites that stand for the outline tell that the sum is off by much of
//! the polygon, and many take its place.

use core::f64::consts::TAU;

use radiosity_geom::{DVec3, area_vector};
use radiosity_visibility::round_outline::RoundOutline;
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::{Corners, Coverage};
use smallvec::SmallVec;

use crate::irradiance::lambert;
use crate::irradiance::outline::{Arc, Piece, between};

/// Square of the sine of the angle below which two places of the border are one.
const NO_ANGLE: f64 = 1e-20;

/// Corners of few kites, and the part of the polygon by which they may miss: beside a rim they miss most.
const FEW: usize = 12;
const MISSED_BY_FEW: f64 = 0.2;

/// Corners of many: they miss 7e-10 of the shadow of something far.
const MANY: usize = 128;

/// A part of the outline inside the polygon, and the sides by which it is cut off.
#[derive(Clone, Copy)]
struct Run {
    piece: Piece,
    cuts: [Option<usize>; 2],
}

type Runs = SmallVec<[Run; 8]>;

/// The common part of a polygon and an outline.
#[derive(Clone, Copy, Debug)]
pub struct Within {
    /// Irradiance from it at exitance 1.
    pub irradiance: f64,
    /// How much of the polygon lies within the outline.
    pub coverage: Coverage,
}

/// The part of a convex `polygon` above the horizon of the unit normal `n` that a round thing hides, relative
/// to the point.
pub fn hidden_by_round(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Within {
    let mut beyond = Corners::from_slice(polygon);
    shadow.cut(&mut beyond);
    if beyond.len() < 3 {
        return Within { irradiance: 0.0, coverage: Coverage::Clear };
    }
    let found = within(n, &beyond, shadow);
    let found =
        if is_likely(n, &beyond, shadow, &found) { found } else { by_kites(n, &beyond, shadow, MANY) };
    match found.coverage {
        Coverage::Hidden if beyond[..] != *polygon => Within { coverage: Coverage::Mixed, ..found },
        _ => found,
    }
}

/// Whether a sum is about what few kites tell.
fn is_likely(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow, found: &Within) -> bool {
    let whole = lambert::polygon(n, polygon);
    (found.irradiance - by_kites(n, polygon, shadow, FEW).irradiance).abs() <= MISSED_BY_FEW * whole
}

/// The part of a convex `polygon`, all of it beyond a round thing, within kites of so many `corners`.
fn by_kites(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow, corners: usize) -> Within {
    let part = shadow.kites(polygon, corners);
    if part.len() < 3 {
        return Within { irradiance: 0.0, coverage: Coverage::Clear };
    }
    let coverage = if part[..] == *polygon { Coverage::Hidden } else { Coverage::Mixed };
    Within { irradiance: lambert::polygon(n, &part), coverage }
}

/// The part of a convex `polygon`, all of it beyond a round thing, within its outline.
fn within(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Within {
    let pieces = pieces(&shadow.outline);
    let mut corners = Corners::from_slice(polygon);
    let turn = sense_of(&pieces).signum();
    if turn * area_vector(polygon).dot(polygon[0]) < 0.0 {
        corners.reverse();
    }
    let border = Border { n, corners: &corners, turn };
    let runs: Runs = pieces.iter().flat_map(|piece| border.inside(piece)).collect();
    if runs.is_empty() {
        return match shadow.holds(corners.iter().sum()) {
            true => Within { irradiance: lambert::polygon(n, polygon), coverage: Coverage::Hidden },
            false => Within { irradiance: 0.0, coverage: Coverage::Clear },
        };
    }
    let start = runs.iter().position(|run| run.cuts[0].is_some()).unwrap_or(0);
    let sum: f64 = (0..runs.len())
        .map(|k| {
            let [run, next] = [k, k + 1].map(|k| runs[(start + k) % runs.len()]);
            run.piece.integral(n) + border.way(&run, &next)
        })
        .sum();
    Within { irradiance: sum.abs() / TAU, coverage: Coverage::Mixed }
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

/// The sides of a polygon, in the sense of the outline.
struct Border<'a> {
    n: DVec3,
    corners: &'a [DVec3],
    turn: f64,
}

impl Border<'_> {
    fn side(&self, k: usize) -> [DVec3; 2] {
        [0, 1].map(|step| self.corners[(k + step) % self.corners.len()])
    }

    /// The parts of a piece inside all sides, in order.
    fn inside(&self, piece: &Piece) -> Runs {
        let mut runs = Runs::from_slice(&[Run { piece: *piece, cuts: [None; 2] }]);
        for k in 0..self.corners.len() {
            let [a, b] = self.side(k);
            let inward = self.turn * a.cross(b);
            runs = runs.iter().flat_map(|run| cut(run, inward, k)).collect();
        }
        runs
    }

    /// The way along the sides from the end of a run to the start of the next one.
    fn way(&self, run: &Run, next: &Run) -> f64 {
        let [from, to] = [run.piece.at(1.0), next.piece.at(0.0)];
        let (Some(first), Some(last)) = (run.cuts[1], next.cuts[0]) else { return between(self.n, from, to) };
        let is_one =
            from.cross(to).length_squared() <= NO_ANGLE * from.length_squared() * to.length_squared();
        if first == last || is_one {
            return between(self.n, from, to);
        }
        let (mut sum, mut place, mut side) = (0.0, from, first);
        while side != last {
            let corner = self.side(side)[1];
            sum += between(self.n, place, corner);
            (place, side) = (corner, (side + 1) % self.corners.len());
        }
        sum + between(self.n, place, to)
    }
}

/// The parts of a run on the inner side of a plane through the point.
fn cut(run: &Run, inward: DVec3, side: usize) -> Runs {
    let [start, end] = run.cuts;
    match run.piece {
        Piece::Segment([a, b]) => {
            let [low, high] = [a, b].map(|x| inward.dot(x));
            let crossing = || a + (b - a) * (low / (low - high));
            let of = |ends: [DVec3; 2], cuts: [Option<usize>; 2]| {
                Runs::from_slice(&[Run { piece: Piece::Segment(ends), cuts }])
            };
            match [low >= 0.0, high >= 0.0] {
                [true, true] => of([a, b], run.cuts),
                [true, false] => of([a, crossing()], [start, Some(side)]),
                [false, true] => of([crossing(), b], [Some(side), end]),
                [false, false] => Runs::new(),
            }
        }
        Piece::Arc(arc) => {
            let [first, last] = arc.angles;
            let mut parts = arc.above(inward);
            if first > last {
                parts.iter_mut().for_each(|part| part.reverse());
                parts.reverse();
            }
            let of = |angles: [f64; 2]| {
                let cuts = [(angles[0], first, start), (angles[1], last, end)];
                let cuts = cuts.map(|(angle, own, cut)| if angle == own { cut } else { Some(side) });
                Run { piece: Piece::Arc(Arc { angles, ..arc }), cuts }
            };
            parts.into_iter().map(of).collect()
        }
    }
}
