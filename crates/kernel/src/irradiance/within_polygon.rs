//! Irradiance at a point through a convex polygon within a convex outline of arcs and segments
//! ([`crate::irradiance::within`]).

use radiosity_geom::{DVec3, area_vector};
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::{Corners, Coverage};
use smallvec::SmallVec;

use crate::irradiance::outline::Piece;
use crate::irradiance::within::{MOVED, MOVES, Window, Within, by_kites, within};

/// Sine of the angle between the ends of a side below which it has no plane.
const NO_SIDE: f64 = 1e-14;

/// The part of a convex `polygon` above the horizon of the unit normal `n` that a round thing hides, relative
/// to the point.
pub fn hidden_by_round(n: DVec3, polygon: &[DVec3], shadow: &RoundShadow) -> Within {
    let mut beyond = Corners::from_slice(polygon);
    shadow.cut(&mut beyond);
    if beyond.len() < 3 {
        return Within::NONE;
    }
    let found =
        (0..=MOVES).find_map(|moves| within(n, shadow, |turn| Sides::of(&moved(&beyond, moves), turn)));
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

/// A polygon in the sense of an outline.
struct Sides(SmallVec<[Side; 8]>);

impl Sides {
    /// The sides of some length.
    fn of(polygon: &[DVec3], turn: f64) -> Self {
        let sense = turn * area_vector(polygon).dot(polygon[0]);
        let side = |k: usize| {
            let ends = [polygon[k], polygon[(k + 1) % polygon.len()]];
            Side::of(if sense < 0.0 { [ends[1], ends[0]] } else { ends }, turn)
        };
        Self((0..polygon.len()).filter_map(side).collect())
    }
}

impl Window for Sides {
    fn cut(&mut self, piece: &Piece) -> SmallVec<[f64; 8]> {
        let mut places = SmallVec::new();
        for side in &mut self.0 {
            for place in piece.crossings(side.inward) {
                side.cut(piece.at(place));
                places.push(place);
            }
        }
        places
    }

    fn depth(&self, direction: DVec3) -> f64 {
        self.0.iter().map(|side| side.inward.dot(direction)).fold(f64::INFINITY, f64::min)
    }

    fn parts(&mut self) -> SmallVec<[Piece; 8]> {
        self.0.iter_mut().flat_map(Side::parts).map(Piece::Segment).collect()
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

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use proptest::prelude::*;
    use radiosity_geom::Surface;
    use radiosity_geom::shapes::{Cone, Disk, FULL_TURN};
    use radiosity_visibility::frustum::Frustum;

    use super::*;
    use crate::irradiance::lambert;

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
