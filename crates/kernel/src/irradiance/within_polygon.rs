//! Irradiance at a point through a convex polygon within a convex outline of arcs and segments.
//!
//! The border of what lies within both is made of the parts of the outline inside the polygon and the parts of
//! its sides within the outline. Each has its term ([`crate::irradiance::outline`]), in whatever order. The
//! outline is cut where it passes the planes of the sides, and the sides at these places, so that parts join to
//! rounding. Which parts count is told by places amid them: of the outline against the sides, of a side against
//! the thing itself.
//!
//! A closed border starts as often as it ends at each of its places: with g a function of directions,
//!
//! ```text
//! Σ_parts g(end) − g(start) = 0 ,     g(u) = (1 + c·u) u ,   c fixed, along no axis of symmetry.
//! ```
//!
//! Where an outline and a side fall on each other, a part may count twice or not at all, and the sum is not 0.
//! Then corners move by 10⁻⁹ of their distance, and kites take the place of an outline that is open for all that.

use core::f64::consts::TAU;

use radiosity_geom::{COINCIDENT, DVec3, area_vector};
use radiosity_visibility::round_outline::RoundOutline;
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::{Corners, Coverage};
use smallvec::{SmallVec, smallvec};

use crate::irradiance::lambert;
use crate::irradiance::outline::{Arc, Piece};

/// Largest sum over a closed border, and how far its light may lie below none.
const CLOSED: f64 = 1e-10;

/// Distance by which corners move, over theirs from the point, and how often they do.
const MOVED: f64 = 1e-9;
const MOVES: usize = 2;

/// c of the header.
const UNEVEN: DVec3 = DVec3::new(0.31, 0.17, 0.43);

/// Corners of kites: they miss 7e-10 of the shadow of something far.
const KITES: usize = 128;

/// Places that tell of a part of the outline whether it lies inside: one may lie on a side that is touched.
const PLACES: [f64; 3] = [0.5, 0.31, 0.77];

/// Sine of the angle between the ends of a side below which it has no plane.
const NO_SIDE: f64 = 1e-14;

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
    let found = (0..=MOVES).find_map(|moves| within(n, &moved(&beyond, moves), shadow));
    let found = found.unwrap_or_else(|| by_kites(n, &beyond, shadow));
    match found.coverage {
        Coverage::Hidden if beyond[..] != *polygon => Within { coverage: Coverage::Mixed, ..found },
        _ => found,
    }
}

/// The corners of a polygon after so many moves, each in a direction of its own.
fn moved(polygon: &[DVec3], moves: usize) -> Corners {
    let step = |k: usize| {
        let angle = 1.0 + 2.4 * k as f64 + 0.7 * moves as f64;
        DVec3::new(angle.cos(), angle.sin(), (1.3 * angle).cos())
    };
    let size = if moves == 0 { 0.0 } else { MOVED };
    polygon.iter().enumerate().map(|(k, corner)| corner + size * corner.length() * step(k)).collect()
}

/// The part of a convex `polygon`, all of it beyond a round thing, within kites that stand for its outline.
fn by_kites(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Within {
    let part = shadow.kites(polygon, KITES);
    if part.len() < 3 {
        return Within { irradiance: 0.0, coverage: Coverage::Clear };
    }
    let coverage = if part[..] == *polygon { Coverage::Hidden } else { Coverage::Mixed };
    Within { irradiance: lambert::polygon(n, &part), coverage }
}

/// The part of a convex `polygon`, all of it beyond a round thing, within its outline; None where its border is
/// not closed.
fn within(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Option<Within> {
    let pieces = pieces(&shadow.outline);
    let turn = sense_of(&pieces).signum();
    let mut sides = sides(polygon, turn);
    let mut border = Border { n, light: 0.0, open: DVec3::ZERO };
    let mut has_outline = false;
    for piece in &pieces {
        for range in inside(piece, &mut sides) {
            has_outline = true;
            border.add(&piece.part(range));
        }
    }
    let (mut any, mut all) = (false, true);
    for side in &mut sides {
        for [from, to] in side.parts() {
            let is_hidden = shadow.holds(from.normalize_or_zero() + to.normalize_or_zero());
            any |= is_hidden;
            all &= is_hidden;
            if is_hidden {
                border.add(&Piece::Segment([from, to]));
            }
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

/// A side of a polygon, in the sense of the outline.
struct Side {
    ends: [DVec3; 2],
    /// Normal of its plane through the point, of length 1 and on the polygon's side.
    inward: DVec3,
    /// Places of the outline on it, and the parts of its length before them.
    cuts: SmallVec<[(f64, DVec3); 4]>,
}

/// The sides of a polygon in the sense of an outline, without those of no length.
fn sides(polygon: &[DVec3], turn: f64) -> SmallVec<[Side; 8]> {
    let sense = turn * area_vector(polygon).dot(polygon[0]);
    let side = |k: usize| {
        let ends = [polygon[k], polygon[(k + 1) % polygon.len()]];
        Side::of(if sense < 0.0 { [ends[1], ends[0]] } else { ends }, turn)
    };
    (0..polygon.len()).filter_map(side).collect()
}

impl Side {
    fn of(ends: [DVec3; 2], turn: f64) -> Option<Self> {
        let [a, b] = ends;
        let across = turn * a.cross(b);
        let is_long = across.length() > NO_SIDE * a.length() * b.length();
        is_long.then(|| Self { ends, inward: across.normalize_or_zero(), cuts: SmallVec::new() })
    }

    /// Cuts it at a place in its plane, if that lies between its ends.
    fn cut(&mut self, place: DVec3) {
        let [a, b] = self.ends;
        let across = a.cross(b);
        let [before, after] = [a.cross(place).dot(across), place.cross(b).dot(across)];
        if before > 0.0 && after > 0.0 {
            self.cuts.push((before / (before + after), place));
        }
    }

    /// The parts between its cuts.
    fn parts(&mut self) -> SmallVec<[[DVec3; 2]; 4]> {
        self.cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [first, last] = self.ends;
        let mut from = first;
        let ends = self.cuts.iter().map(|(_, place)| *place).chain([last]);
        ends.map(|to| [std::mem::replace(&mut from, to), to]).collect()
    }
}

/// The parts of a piece inside all sides, as ranges of 0 to 1; cuts the sides where it passes them.
fn inside(piece: &Piece, sides: &mut [Side]) -> SmallVec<[[f64; 2]; 4]> {
    let mut places: SmallVec<[f64; 12]> = smallvec![0.0, 1.0];
    for side in &mut *sides {
        for place in piece.crossings(side.inward) {
            side.cut(piece.at(place));
            places.push(place);
        }
    }
    places.sort_by(f64::total_cmp);
    let mut found: SmallVec<[[f64; 2]; 4]> = SmallVec::new();
    for ends in places.windows(2).filter(|ends| ends[0] < ends[1]) {
        if !is_inside(piece, [ends[0], ends[1]], sides) {
            continue;
        }
        match found.last_mut() {
            Some([_, last]) if *last == ends[0] => *last = ends[1],
            _ => found.push([ends[0], ends[1]]),
        }
    }
    found
}

/// Whether a part of a piece lies inside all sides: by the first of a few places that lies on none.
fn is_inside(piece: &Piece, [from, to]: [f64; 2], sides: &[Side]) -> bool {
    let depth = |part: f64| {
        let place = piece.at(from + part * (to - from));
        let heights = sides.iter().map(|side| side.inward.dot(place));
        heights.fold(f64::INFINITY, f64::min) / place.length()
    };
    let told = PLACES.into_iter().map(depth).find(|depth| depth.abs() > COINCIDENT);
    told.is_some_and(|depth| depth > 0.0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::Surface;
    use radiosity_geom::shapes::{Cone, Disk, FULL_TURN};
    use radiosity_visibility::frustum::Frustum;

    use super::*;

    /// Strips of a rectangle.
    const STRIPS: usize = 2000;

    /// The solid of revolution over `axis`, or a disk where `radii` are its only size; None where it has none.
    fn frustum(base: DVec3, axis: DVec3, height: f64, radii: [f64; 2]) -> Option<Frustum> {
        let disk = |place: DVec3, radius: f64| {
            Disk::new(place, axis, radius, 0.0, FULL_TURN).expect("a disk").meridian().expect("it is whole")
        };
        if height == 0.0 {
            return Frustum::of(&disk(base, radii[0]), std::iter::empty());
        }
        let wall = Cone::new(base, height * axis, radii[0], radii[1], FULL_TURN).expect("a cone");
        Frustum::of(&wall.meridian().expect("it is whole"), std::iter::once((1, disk(base, radii[0]))))
    }

    /// The rectangle from `low` to `high` of the wall x = 0, as seen from `eye`.
    fn wall([low, high]: [[f64; 2]; 2], eye: DVec3) -> [DVec3; 4] {
        let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
        corners.map(|[y, z]| DVec3::new(0.0, y, z) - eye)
    }

    /// Places on the circles at the ends of a solid, relative to `eye`.
    fn rims(base: DVec3, axis: DVec3, height: f64, radii: [f64; 2], eye: DVec3) -> Vec<DVec3> {
        const PLACES: usize = 24;
        let (first, second) = axis.any_orthonormal_pair();
        let circle = |end: usize| {
            let center = base + end as f64 * height * axis - eye;
            let radius = radii[end];
            (0..PLACES).map(move |k| {
                let (sin, cos) = (TAU * k as f64 / PLACES as f64).sin_cos();
                center + radius * (cos * first + sin * second)
            })
        };
        (0..if height == 0.0 { 1 } else { 2 }).flat_map(circle).collect()
    }

    /// A place amid the convex hull of `places`, from 0 to 1, on the line across at `s`.
    fn amid(places: &[[f64; 2]], s: f64) -> Option<f64> {
        let pairs = (0..places.len()).flat_map(|i| (0..i).map(move |j| [places[i], places[j]]));
        let crossing = pairs.filter(|[a, b]| (a[0] < s) != (b[0] < s));
        let heights = crossing.map(|[a, b]| a[1] + (b[1] - a[1]) * (s - a[0]) / (b[0] - a[0]));
        let [low, high] =
            heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)]);
        let [low, high] = [low.max(0.0), high.min(1.0)];
        (low <= high).then_some(0.5 * (low + high))
    }

    /// Irradiance at the origin from what is hidden of a rectangle by a solid between such `rims`: by strips of it,
    /// each hidden from one place to another. Thin shadows are found by those of the rims, and wide ones by looks
    /// along a strip.
    fn by_strips(n: DVec3, rectangle: &[DVec3; 4], shadow: &RoundShadow, rims: &[DVec3]) -> f64 {
        const LOOKS: usize = 64;
        let [a, b, _, d] = *rectangle;
        let place = |s: f64, t: f64| a + s * (b - a) + t * (d - a);
        let cast = |rim: &DVec3| {
            let offset = *rim * (a.x / rim.x) - a;
            [b - a, d - a].map(|side| offset.dot(side) / side.length_squared())
        };
        let cast: Vec<[f64; 2]> = rims.iter().map(cast).collect();
        let strip = |k: usize| {
            let [low, middle, high] = [0.0, 0.5, 1.0].map(|part| (k as f64 + part) / STRIPS as f64);
            let is_hidden = |t: &f64| shadow.holds(place(middle, *t));
            let looks = || (0..=LOOKS).map(|k| k as f64 / LOOKS as f64).find(is_hidden);
            let Some(hidden) = amid(&cast, middle).filter(is_hidden).or_else(looks) else { return 0.0 };
            let border = |end: f64| {
                let (mut inside, mut outside) = (hidden, end);
                for _ in 0..30 {
                    let middle = 0.5 * (inside + outside);
                    *(if is_hidden(&middle) { &mut inside } else { &mut outside }) = middle;
                }
                if is_hidden(&end) { end } else { inside }
            };
            let [from, to] = [0.0, 1.0].map(border);
            lambert::polygon(n, &[place(low, from), place(high, from), place(high, to), place(low, to)])
        };
        (0..STRIPS).map(strip).sum()
    }

    /// Sides that pass through the place where an outline's only arc begins, and sides that an arc touches from
    /// within or from without.
    #[test]
    fn sides_may_pass_joints_and_touch_arcs() {
        let n = -DVec3::X;
        let (base, axis, height, radii) = (DVec3::new(0.0, 1.0, 0.75), DVec3::X, 1.0, [0.5, 0.0]);
        let cone = frustum(base, axis, height, radii).expect("a cone");
        let ranges = [[0.0, 1.0], [1.0, 2.0]];
        let quarters = ranges.iter().flat_map(|y| ranges.map(|z| [[y[0], z[0]], [y[1], z[1]]]));
        let without = [
            [[0.0, 0.0], [0.5, 2.0]],
            [[1.5, 0.0], [2.0, 2.0]],
            [[0.0, 0.0], [2.0, 0.25]],
            [[0.0, 1.25], [2.0, 2.0]],
        ];
        let within = [
            [[0.5, 0.0], [2.0, 2.0]],
            [[0.0, 0.0], [1.5, 2.0]],
            [[0.0, 0.25], [2.0, 2.0]],
            [[0.5, 0.25], [1.5, 1.25]],
        ];
        let rectangles: Vec<[[f64; 2]; 2]> = quarters.chain(without).chain(within).collect();
        for eye in [[0.9, 0.4], [1.0, 0.75], [0.3, 1.7], [1.123, 0.931]].map(|[y, z]| DVec3::new(2.0, y, z)) {
            let shadow = RoundShadow::of_frustum(&cone, eye).expect("the point lies outside");
            let rims = rims(base, axis, height, radii, eye);
            for rectangle in &rectangles {
                let seen = wall(*rectangle, eye);
                let found = hidden_by_round(n, &seen, &shadow).irradiance;
                let right = by_strips(n, &seen, &shadow, &rims);
                assert!((found - right).abs() < 3e-5, "{eye}, {rectangle:?}: {found} for {right}");
            }
        }
    }

    proptest! {
        /// In round numbers, too, things hide of rectangles what they hide in strips.
        #[test]
        fn round_numbers_are_as_any(
            base in prop::array::uniform3(0..=8i32),
            eye in prop::array::uniform2(1..16i32),
            axis in prop::sample::select(vec![DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z]),
            radius in prop::sample::select(vec![0.125, 0.25, 0.5]),
            share in prop::sample::select(vec![0.0, 0.5, 1.0]),
            height in prop::sample::select(vec![0.0, 1e-6, 1e-3, 0.25, 0.5, 1.0]),
            rectangle in prop::sample::select(vec![
                [[0, 0], [2, 2]],
                [[0, 0], [1, 1]],
                [[1, 0], [2, 1]],
                [[0, 1], [2, 2]],
            ]),
        ) {
            let base = 0.25 * DVec3::from_array(base.map(f64::from));
            let eye = DVec3::new(2.0, 0.125 * f64::from(eye[0]), 0.125 * f64::from(eye[1]));
            let across = radius * (1.0 - axis.x.abs());
            let ends = [base.x, base.x + axis.x * height];
            let [low, high] = [ends[0].min(ends[1]) - across, ends[0].max(ends[1]) + across];
            prop_assume!(low >= 0.0 && high < 2.0);
            let radii = [radius, share * radius];
            let Some(body) = frustum(base, axis, height, radii) else { return Ok(()) };
            let Some(shadow) = RoundShadow::of_frustum(&body, eye) else { return Ok(()) };
            let n = -DVec3::X;
            let seen = wall(rectangle.map(|corner: [i32; 2]| corner.map(f64::from)), eye);
            let found = hidden_by_round(n, &seen, &shadow).irradiance;
            let right = by_strips(n, &seen, &shadow, &rims(base, axis, height, radii, eye));
            // Half a strip is missed where the outline runs along it; kites stand for parts of arcs.
            prop_assert!((found - right).abs() < 1e-4, "{found} for {right}");
            let kites = by_kites(n, &seen, &shadow).irradiance;
            prop_assert!((found - kites).abs() < 1e-5, "{found} for {kites} by kites");
        }
    }
}
