//! Shadow of a ball: the cone of its tangents from a point, beyond the circle in which they touch it.
//!
//! With e the vector from x to the centre, r the radius and E = |e|² − r², the ball hides the points x + a of
//!
//! ```text
//! a·ê > cos α |a| ,   a·ê > E/|e| ,     sin α = r/|e| ,
//! ```
//!
//! since the cone holds nothing outside the ball between the plane of that circle and the ball's far side.
//!
//! A plane polygon is hidden between its sides and arcs of a conic. In place of an arc that turns by δ about ê
//! stands the kite of the tangent plane's triangle: a corner amid, at (δ/2)/sin(δ/2) of the radius, so that it
//! covers the area of the arc's sector. With θ = δ/2 the sides lie off the circle by ρ of mean 0 and mean
//! square θ⁴/270, so that the integral of a smooth function misses ½ θ⁴/270 of itself, 0.18/n⁴ with n corners
//! on a full turn.

use core::f64::consts::TAU;

use radiosity_geom::{DVec3, area_vector, clip_by_heights, quadratic, sides};
use smallvec::SmallVec;

use crate::bounding_ball::Ball;
use crate::round_outline::RoundOutline;
use crate::shadow_volume::{Corners, ShadowVolume};

/// The shadow of a ball from a point.
#[derive(Clone, Debug)]
pub struct ShadowCone {
    eye: DVec3,
    /// Unit vector to the centre.
    axis: DVec3,
    /// Two unit vectors that complete it.
    across: [DVec3; 2],
    sine: f64,
    cosine: f64,
    /// Distance of the plane of the circle of contact from the point (scene length).
    depth: f64,
    /// Corners that stand for the circle.
    corners: usize,
}

impl ShadowCone {
    /// The shadow of a ball from `eye`, whose outline has so many `corners`; None within the ball.
    pub fn over(center: DVec3, radius: f64, eye: DVec3, corners: usize) -> Option<Self> {
        let step = center - eye;
        let distance = step.length();
        let tangent = distance * distance - radius * radius;
        if tangent.is_nan() || tangent <= 0.0 {
            return None;
        }
        let axis = step / distance;
        let first = axis.any_orthonormal_vector();
        let (sine, cosine) = (radius / distance, tangent.sqrt() / distance);
        let depth = tangent / distance;
        Some(Self { eye, axis, across: [first, axis.cross(first)], sine, cosine, depth, corners })
    }

    /// The tip.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// Whether a ball lies wholly outside.
    pub fn misses(&self, ball: &Ball) -> bool {
        let middle = ball.center() - self.eye;
        let along = middle.dot(self.axis);
        let beside = (middle - along * self.axis).length();
        along <= self.depth - ball.radius() || beside * self.cosine - along * self.sine >= ball.radius()
    }

    /// Height of a point inside the cone, negative outside (scene length).
    fn height(&self, a: DVec3) -> f64 {
        a.dot(self.axis) - self.cosine * a.length()
    }

    /// Whether all corners, relative to the tip, are hidden.
    pub fn covers(&self, polygon: &[DVec3]) -> bool {
        polygon.iter().all(|a| self.height(*a) >= 0.0 && a.dot(self.axis) >= self.depth)
    }

    /// Whether a direction lies within the cone.
    pub(crate) fn holds(&self, direction: DVec3) -> bool {
        self.height(direction) >= 0.0
    }

    /// The circle of contact.
    pub(crate) fn outline(&self) -> RoundOutline {
        let scale = self.depth / self.cosine;
        RoundOutline::circle(self.depth * self.axis, self.across.map(|unit| scale * self.sine * unit))
    }

    /// Cuts off the part of a convex polygon before the plane of the circle of contact.
    pub(crate) fn cut(&self, polygon: &mut Corners) {
        let beyond: SmallVec<[f64; 8]> = polygon.iter().map(|a| a.dot(self.axis) - self.depth).collect();
        let mut kept = Corners::new();
        if beyond.iter().any(|h| *h > 0.0) {
            clip_by_heights(polygon, &beyond, |a| kept.push(a));
        }
        *polygon = kept;
    }

    /// The hidden part of a convex polygon, relative to the tip; empty where nothing is.
    pub fn hidden_part(&self, polygon: &[DVec3]) -> Corners {
        let mut beyond = Corners::from_slice(polygon);
        self.cut(&mut beyond);
        if beyond.is_empty() { beyond } else { self.within(&beyond) }
    }

    /// The part of a convex polygon within the cone.
    fn within(&self, polygon: &[DVec3]) -> Corners {
        let normal = area_vector(polygon);
        let turn = normal.dot(polygon[0]).signum();
        let chords: SmallVec<[[DVec3; 2]; 8]> = sides(polygon).filter_map(|side| self.chord(side)).collect();
        let Some([first, _]) = chords.first() else { return self.round(polygon, normal) };
        let mut part = Corners::new();
        let mut last = chords[chords.len() - 1][1];
        if chords.len() == 1 && last == *first {
            return part;
        }
        for [start, end] in &chords {
            if *start != last {
                self.add_arc([last, *start], turn, normal, &mut part);
                part.push(*start);
            }
            part.push(*end);
            last = *end;
        }
        part
    }

    /// The part of a side within the cone. Its ends are the side's own where they lie inside.
    fn chord(&self, [a, b]: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let is_inside = [a, b].map(|x| self.height(x) >= 0.0);
        if is_inside == [true, true] {
            return Some([a, b]);
        }
        // (y·ê)² = cos² α |y|² at y = a + t (b − a).
        let d = b - a;
        let (p, q, square) = (a.dot(self.axis), d.dot(self.axis), self.cosine * self.cosine);
        let square_of_t = q * q - square * d.length_squared();
        let half = p * q - square * a.dot(d);
        let constant = p * p - square * a.length_squared();
        let roots = quadratic(square_of_t, 2.0 * half, constant);
        let at = |t: f64| a + t * d;
        let inner = |t: &f64| *t > 0.0 && *t < 1.0 && at(*t).dot(self.axis) > 0.0;
        let mut found: SmallVec<[f64; 2]> = roots.into_iter().filter(inner).collect();
        found.sort_by(f64::total_cmp);
        match (is_inside, &found[..]) {
            ([true, _], [.., t]) => Some([a, at(*t)]),
            ([_, true], [t, ..]) => Some([at(*t), b]),
            ([false, false], [s, t]) => Some([at(*s), at(*t)]),
            _ => None,
        }
    }

    /// The whole conic, where it lies within a polygon with this `normal`, whose sides all miss the cone.
    fn round(&self, polygon: &[DVec3], normal: DVec3) -> Corners {
        let turn = normal.dot(polygon[0]).signum();
        let is_inside = sides(polygon).all(|[a, b]| turn * a.cross(b).dot(self.axis) > 0.0);
        if !is_inside || polygon.len() < 3 {
            return Corners::new();
        }
        let start = self.direction(0.0, 1.0);
        let start = start * (polygon[0].dot(normal) / start.dot(normal));
        let mut part = Corners::new();
        self.add_arc([start; 2], turn, normal, &mut part);
        part.push(start);
        part
    }

    /// The direction at an angle about the axis, at a multiple of the cone's radius.
    fn direction(&self, angle: f64, radius: f64) -> DVec3 {
        let (sin, cos) = angle.sin_cos();
        self.cosine * self.axis + radius * self.sine * (cos * self.across[0] + sin * self.across[1])
    }

    /// Adds the corners that stand for the arc between two points of the cone in a plane with this `normal`,
    /// without its ends, in the sense of `turn` about the axis; a whole turn where both are one.
    fn add_arc(&self, [from, to]: [DVec3; 2], turn: f64, normal: DVec3, out: &mut Corners) {
        let angle = |a: DVec3| a.dot(self.across[1]).atan2(a.dot(self.across[0]));
        let (start, end) = (angle(from), angle(to));
        let mut whole = turn * (end - start);
        if whole <= 0.0 {
            whole += TAU;
        }
        let kites = (0.5 * self.corners as f64 * whole / TAU).ceil().max(1.0);
        let half = 0.5 * whole / kites;
        let outside = half / half.sin();
        let height = from.dot(normal);
        let count = 2 * kites as usize;
        for k in 1..count {
            let radius = if k % 2 == 1 { outside } else { 1.0 };
            let direction = self.direction(start + turn * half * k as f64, radius);
            out.push(direction * (height / direction.dot(normal)));
        }
    }

    /// A pyramid over the polygon of the same area as the circle of contact that stands for it.
    pub fn pyramid(&self) -> Option<ShadowVolume> {
        let step = TAU / self.corners as f64;
        let radius = (step / step.sin()).sqrt();
        let scale = self.depth / self.cosine;
        let corner = |k: usize| self.eye + scale * self.direction(k as f64 * step, radius);
        ShadowVolume::over(&(0..self.corners).map(corner).collect::<Vec<_>>(), self.eye)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_geom::{Ray, Surface, polygon_area};

    use super::*;

    fn vector(range: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
    }

    /// A square beyond the unit ball about the origin, as seen from `eye`, and the ball's shadow.
    fn case(eye: DVec3, turn: DVec3, corners: usize) -> Option<([DVec3; 4], ShadowCone)> {
        let cone = ShadowCone::over(DVec3::ZERO, 1.0, eye, corners)?;
        let away = -eye.normalize();
        let normal = (away + 0.6 * turn).normalize();
        let (a, b) = normal.any_orthonormal_pair();
        let middle = 2.5 * away + turn;
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[s, t]| middle + 1.3 * (s * a + t * b) - eye);
        let is_outside = square.iter().all(|x| (*x + eye).length() > 1.0)
            && square.iter().all(|x| x.dot(away) > 0.0)
            && middle.dot(normal).abs() > 1.0;
        is_outside.then_some((square, cone))
    }

    proptest! {
        /// Segments from the point to the hidden part meet the ball, and those to the rest of the square do not.
        #[test]
        fn what_is_hidden_lies_behind_the_ball(
            eye in vector(3.0), turn in vector(0.9), s in 0.0..1.0, t in 0.0..1.0,
        ) {
            prop_assume!(eye.length() > 1.2);
            let Some((square, cone)) = case(eye, turn, 256) else { return Ok(()) };
            let ball = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a ball");
            let [a, b, _, d] = square;
            let y = a + s * (b - a) + t * (d - a);
            let is_met = ball.occludes(&Ray::segment(eye, eye + y));
            let hidden = cone.hidden_part(&square);
            let normal = area_vector(&square).normalize();
            let inward = |[p, q]: [DVec3; 2]| normal.cross((q - p).normalize_or_zero()).dot(y - p);
            let depth = sides(&hidden).map(inward).fold(f64::INFINITY, f64::min);
            // Within 1e-3 of its border corners stand for arcs.
            prop_assume!(depth.abs() > 1e-3);
            prop_assert_eq!(hidden.len() > 2 && depth > 0.0, is_met);
        }

        /// With many corners the hidden area is that of many planes; with few it is nearly so.
        #[test]
        fn few_corners_stand_for_the_circle(eye in vector(3.0), turn in vector(0.9)) {
            prop_assume!(eye.length() > 1.5);
            let Some((square, cone)) = case(eye, turn, 24) else { return Ok(()) };
            let planes = ShadowCone { corners: 4000, ..cone.clone() }.pyramid().expect("it has a height");
            let [few, many] = [cone.hidden_part(&square), planes.hidden_part(&square)];
            let [few, many] = [few, many].map(|part| if part.len() > 2 { polygon_area(&part) } else { 0.0 });
            // 0.2/24⁴ = 6e-7 of a smooth function; areas of slanted conics change faster.
            prop_assert!((few - many).abs() <= 1e-4 * (many + 0.1), "{few} for {many}");
        }
    }

    #[test]
    fn within_the_ball_there_is_no_shadow() {
        assert!(ShadowCone::over(DVec3::ZERO, 1.0, 0.9 * DVec3::X, 12).is_none());
    }
}
