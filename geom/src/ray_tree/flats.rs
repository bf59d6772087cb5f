//! Four flat surfaces side by side, and which of them a ray may hit.
//!
//! A flat surface lies in its plane n · x = d within |u| ≤ 1, |v| ≤ 1, u + v ≤ s, for two functions u, v
//! affine in x that do not change along n: a parallelogram less a corner. Triangles and parallelograms are
//! that, other quadrilaterals nearly: of the parallelograms over two sides of it that hold the quadrilateral
//! the one is taken that has the least beside it. Everything else takes a rectangle around it.
//!
//! The ray o + t w meets the plane at t = h/c, h = d − n · o, c = n · w. All is multiplied by c, so that no
//! division arises and roundings stay in bounds: |c u(o) + h u(w)| ≤ |c|, and so on, where the left side is
//! off by a few roundings times |∇u|. What passes may miss by that; what does not pass certainly misses.

use super::frame::{Frame, Ray32};
use crate::{PlanarRegion, Surface};
use glam::{DVec3, Vec4};

/// Surfaces side by side.
pub(super) const WIDTH: usize = 4;

/// Roundings of the left sides, per unit of |∇u|: |c| ≤ √3 times u(o), off by 12 · 2⁻²⁴, and |h| ≤ 2 √3 times
/// u(w), off by 5 · 2⁻²⁴, with those of c and h less than 2⁻¹⁸; and twice that for u + v.
const ROUNDING: f64 = 1.0 / (1u32 << 17) as f64;

/// The functions of one flat surface.
#[derive(Clone, Copy, Debug)]
struct Sheet {
    normal: DVec3,
    height: f64,
    /// Gradients of u and v.
    slopes: [DVec3; 2],
    /// u and v at the origin.
    shifts: [f64; 2],
    most: f64,
    /// Twice the largest distance of a corner from the plane (units of the frame).
    depth: f64,
}

/// Four flat surfaces.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(super) struct Flats {
    normal: [Vec4; 3],
    height: Vec4,
    slope_u: [Vec4; 3],
    shift_u: Vec4,
    slope_v: [Vec4; 3],
    shift_v: Vec4,
    most: Vec4,
    /// Room for the roundings of c u and c v.
    room: Vec4,
    /// Room for the roundings of c t.
    room_along: Vec4,
    surfaces: [u32; WIDTH],
}

impl Flats {
    /// Up to four surfaces, by their places in `surfaces`, which have a region.
    pub(super) fn new<S: Surface>(surfaces: &[S], places: &[u32], frame: &Frame) -> Flats {
        let sheets: Vec<Sheet> = places
            .iter()
            .map(|place| Sheet::new(surfaces[*place as usize].region().expect("it is flat"), frame))
            .collect();
        let lane = |value: &dyn Fn(&Sheet) -> f64, none: f32| -> Vec4 {
            Vec4::from_array(std::array::from_fn(|k| sheets.get(k).map_or(none, |sheet| value(sheet) as f32)))
        };
        let vector =
            |value: &dyn Fn(&Sheet) -> DVec3| [0, 1, 2].map(|axis| lane(&|sheet| value(sheet)[axis], 0.0));
        Flats {
            normal: vector(&|s| s.normal),
            height: lane(&|s| s.height, 0.0),
            slope_u: vector(&|s| s.slopes[0]),
            shift_u: lane(&|s| s.shifts[0], 0.0),
            slope_v: vector(&|s| s.slopes[1]),
            shift_v: lane(&|s| s.shifts[1], 0.0),
            most: lane(&|s| s.most, 0.0),
            // Nothing passes where nothing is.
            room: lane(&|s| s.steepest() * (ROUNDING + s.depth), -1.0),
            room_along: lane(&|s| ROUNDING + s.depth, 0.0),
            surfaces: std::array::from_fn(|k| places.get(k).copied().unwrap_or(0)),
        }
    }

    /// Which surface is the k-th.
    pub(super) fn surface(&self, k: usize) -> usize {
        self.surfaces[k] as usize
    }

    /// Which of the four the ray may hit before `end`, as bits.
    #[inline]
    pub(super) fn may_be_hit(&self, ray: &Ray32, end: f32) -> u32 {
        let Ray32 { origin, direction, .. } = ray;
        let dot = |a: &[Vec4; 3], x: &[Vec4; 3]| a[0] * x[0] + a[1] * x[1] + a[2] * x[2];
        let closing = dot(&self.normal, direction);
        let gap = self.height - dot(&self.normal, origin);
        let across = |slope: &[Vec4; 3], shift: Vec4| {
            (dot(slope, origin) + shift) * closing + gap * dot(slope, direction)
        };
        let (u, v) = (across(&self.slope_u, self.shift_u), across(&self.slope_v, self.shift_v));
        let speed = closing.abs();
        let sign = Vec4::ONE.copysign(closing);
        let (ahead, room) = (gap * sign, self.room);
        let limit = speed + room;
        let inside =
            u.abs().cmple(limit) & v.abs().cmple(limit) & ((u + v) * sign).cmple(self.most * speed + room);
        let from = ahead.cmpge(-self.room_along);
        (inside & from & ahead.cmple(end * speed + self.room_along)).bitmask()
    }
}

impl Sheet {
    fn new(region: &PlanarRegion, frame: &Frame) -> Sheet {
        let corners: Vec<DVec3> = region.outer().iter().map(|x| frame.place(*x)).collect();
        let normal = region.normal();
        let origin = corners[0];
        let height = normal.dot(origin);
        let depth = corners.iter().map(|x| (normal.dot(*x) - height).abs()).fold(0.0, f64::max);
        let flat: Vec<DVec3> = corners.iter().map(|x| *x - (normal.dot(*x) - height) * normal).collect();
        let [center, a, b] = parallelogram(&flat, region);
        let cross = a.cross(b);
        let scale = 1.0 / cross.length_squared();
        let slopes = [scale * b.cross(cross), scale * cross.cross(a)];
        let shifts = slopes.map(|slope| -slope.dot(center));
        let [u, v] = [0, 1].map(|k| move |x: &DVec3| slopes[k].dot(*x) + shifts[k]);
        let most = flat.iter().map(|x| u(x) + v(x)).fold(f64::MIN, f64::max);
        Sheet { normal, height, slopes, shifts, most, depth: 2.0 * depth }
    }

    fn steepest(&self) -> f64 {
        // Room for what the surfaces count as hits beyond their borders comes with the roundings.
        2.0 + self.slopes[0].length().max(self.slopes[1].length())
    }
}

/// Middle and half sides of a parallelogram around the outline `flat`.
fn parallelogram(flat: &[DVec3], region: &PlanarRegion) -> [DVec3; 3] {
    let n = flat.len();
    let over = |k: usize| {
        let (p, e, f) = (flat[k], flat[(k + 1) % n] - flat[k], flat[(k + n - 1) % n] - flat[k]);
        around(flat, p, e, f)
    };
    let area = |frame: &([DVec3; 3], f64)| frame.1;
    let candidates = if n <= 4 { 0..n } else { 0..0 };
    let best = candidates.map(over).filter(|x| x.1.is_finite()).min_by(|a, b| area(a).total_cmp(&area(b)));
    let [x, y] = region.axes();
    best.unwrap_or_else(|| around(flat, flat[0], x, y)).0
}

/// The smallest parallelogram around points along `e` and `f`, as its middle and half sides, and the area
/// that is left of it without the corner of highest u and v.
fn around(flat: &[DVec3], p: DVec3, e: DVec3, f: DVec3) -> ([DVec3; 3], f64) {
    let cross = e.cross(f);
    let scale = 1.0 / cross.length_squared();
    let [a, b] = [scale * f.cross(cross), scale * cross.cross(e)];
    let range = |slope: DVec3| {
        let places = flat.iter().map(|x| (*x - p).dot(slope));
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let ([u0, u1], [v0, v1]) = (range(a), range(b));
    let (half_u, half_v) = (0.5 * (u1 - u0), 0.5 * (v1 - v0));
    let center = p + 0.5 * (u0 + u1) * e + 0.5 * (v0 + v1) * f;
    let sum = |x: &DVec3| ((*x - center).dot(a)) / half_u + (*x - center).dot(b) / half_v;
    let most = flat.iter().map(sum).fold(f64::MIN, f64::max);
    let rest = 4.0 - 0.5 * (2.0 - most).max(0.0).powi(2);
    ([center, half_u * e, half_v * f], rest * half_u * half_v * cross.length())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Polygon;
    use crate::{Ray, Rect};
    use proptest::prelude::*;

    proptest! {
        /// Whoever is hit passes; most of those that are missed do not.
        #[test]
        fn what_is_hit_passes(
            sides in 3usize..7, tilt in prop::array::uniform3(-1.0..1.0_f64), size in -4.0..0.0_f64,
            rays in prop::collection::vec(prop::array::uniform5(-1.0..1.0_f64), 50),
        ) {
            let turn = glam::DQuat::from_scaled_axis(DVec3::from_array(tilt));
            let size = 10.0_f64.powf(size);
            let middle = 0.5 * DVec3::from_array(tilt);
            // Not regular: the corners lie on an ellipse at uneven angles.
            let corner = |k: usize| {
                let (sin, cos) = (1.7 * (k as f64 + 0.2 * (k % 2) as f64) * 3.6 / sides as f64).sin_cos();
                middle + size * (turn * DVec3::new(cos, 0.6 * sin, 0.0))
            };
            let Ok(polygon) = Polygon::new((0..sides).map(corner).collect(), vec![]) else { return Ok(()) };
            let frame = Frame::around(&polygon.bounds(&Rect::FULL).grow(DVec3::ONE).grow(-DVec3::ONE));
            let flats = Flats::new(std::slice::from_ref(&polygon), &[0], &frame);
            let mut wrong = 0;
            for [x, y, z, u, v] in rays {
                let origin = DVec3::new(x, y, z);
                let ray = Ray { origin, direction: 2.0 * (polygon.jet(u, v).position - origin), range: [0.0, 1.0] };
                let ray32 = frame.ray(&ray).expect("it starts within the frame");
                let may_be_hit = flats.may_be_hit(&ray32, ray32.end(1.0));
                let is_hit = polygon.intersect(&ray).is_some();
                prop_assert!(may_be_hit == 1 || !is_hit, "{ray:?}");
                prop_assert!(may_be_hit <= 1, "what is not there is not hit");
                wrong += u32::from(may_be_hit == 1 && !is_hit && sides == 3);
            }
            prop_assert!(wrong <= 10 || size < 1e-3, "{wrong}");
        }
    }
}
