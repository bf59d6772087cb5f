//! Rays and boxes in single precision, rounded so that no box that a ray meets is missed.
//!
//! The scene is moved and scaled into [−1, 1]³ before it is rounded, so that every coordinate is off by at
//! most 2⁻²⁵ and one margin serves all boxes: [`MARGIN`] is four times the roundings of a box and of an
//! origin. A ray's direction is scaled to a largest coordinate of 1: its parameter then is a length of the
//! same order as the scene. The roundings of a slab test, of a coordinate (2⁻²⁴), one over it (2⁻²⁴), a difference
//! (2⁻²⁴) and a product (2⁻²⁴), are relative to its result and less than [`ROOM`] (Ize, *Robust BVH ray
//! traversal*, JCGT 2(2), 2013).

use crate::slabs::Slabs;
use crate::{Aabb, Ray};
use glam::{DVec3, Vec3, Vec4};

/// Distance by which boxes grow on every side, in units of half the scene.
const MARGIN: f64 = 1.0 / (1u32 << 22) as f64;

/// Factor by which the end of an interval grows.
pub(super) const ROOM: f32 = 1.0 + 1e-6;

/// One over a coordinate of a direction is no larger than this: 0 · ∞ must not arise, nor a number that is
/// not finite.
const STEEPEST: f32 = 1e18;

/// The map x ↦ (x − center) / half of a scene into [−1, 1]³.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    center: DVec3,
    scale: f64,
    bounds: Aabb,
}

/// A box in the frame, lowest and highest coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box32 {
    pub(super) min: [f32; 3],
    pub(super) max: [f32; 3],
}

/// A ray in the frame, each coordinate in all lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray32 {
    pub(super) origin: [Vec4; 3],
    pub(super) direction: [Vec4; 3],
    /// One over the direction.
    pub(super) inverse: [Vec4; 3],
    /// 1 where the direction is negative.
    pub(super) signs: [usize; 3],
    /// Where t = 0 of this ray is on that in space, and how much faster it runs.
    start: f64,
    speed: f64,
}

impl Frame {
    /// The frame of the scene within `bounds`.
    pub(super) fn around(bounds: &Aabb) -> Frame {
        let half = 0.5 * (bounds.max - bounds.min).max_element();
        let far = bounds.min.abs().max(bounds.max.abs()).max_element();
        // A scene that is a point, far away, is as large as the roundings of its coordinates.
        let half = half.max(1e-14 * far).max(f64::MIN_POSITIVE.sqrt());
        Frame { center: bounds.center(), scale: 1.0 / half, bounds: bounds.inflate(1e-7 * half) }
    }

    /// A point in the frame.
    pub(super) fn place(&self, x: DVec3) -> DVec3 {
        self.scale * (x - self.center)
    }

    /// A box in the frame, with its margin.
    pub(super) fn enclose(&self, bounds: &Aabb) -> Box32 {
        let single = |x: DVec3| x.to_array().map(|x| x as f32);
        let (min, max) = (self.place(bounds.min), self.place(bounds.max));
        Box32 { min: single(min - MARGIN), max: single(max + MARGIN) }
    }

    /// A ray in the frame, from its start or where it enters the scene; `None` where it passes by.
    pub(super) fn ray(&self, ray: &Ray) -> Option<Ray32> {
        let [start, end] = ray.range;
        let start = match self.bounds.contains(ray.at(start)) {
            true => start,
            false => Slabs::new(ray).entry(&self.bounds, start, end)?,
        };
        let steepest = ray.direction.abs().max_element();
        let direction = (ray.direction / steepest).as_vec3();
        Some(Ray32 {
            origin: lanes(self.place(ray.at(start)).as_vec3()),
            direction: lanes(direction),
            inverse: lanes(direction).map(|x| x.recip().abs().min(Vec4::splat(STEEPEST)).copysign(x)),
            signs: direction.to_array().map(|x| usize::from(x.is_sign_negative())),
            start,
            speed: self.scale * steepest,
        })
    }
}

fn lanes(x: Vec3) -> [Vec4; 3] {
    x.to_array().map(Vec4::splat)
}

impl Ray32 {
    /// The parameter in the frame of `t` in space, rounded up.
    pub(super) fn end(&self, t: f64) -> f32 {
        ((t - self.start) * self.speed) as f32 * ROOM
    }
}

impl Box32 {
    pub(super) const EMPTY: Box32 = Box32 { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    #[must_use]
    pub(super) fn union(mut self, other: &Box32) -> Box32 {
        for axis in 0..3 {
            self.min[axis] = self.min[axis].min(other.min[axis]);
            self.max[axis] = self.max[axis].max(other.max[axis]);
        }
        self
    }

    /// Half the surface area; 0 of the empty box.
    pub(super) fn half_area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|axis| (self.max[axis] - self.min[axis]).max(0.0));
        x * y + y * z + z * x
    }

    /// Twice the middle.
    pub(super) fn middle(&self) -> [f32; 3] {
        [0, 1, 2].map(|axis| self.min[axis] + self.max[axis])
    }
}
