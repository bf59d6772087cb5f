//! The affine map under every flat shape: X(u, v) = m + u a + v b.
//!
//! With n = a × b the dual vectors a* = b × n / n², b* = n × a / n² read the parameters off a point: u = (x −
//! m) · a*, v = (x − m) · b*. The area element is |n|, a constant.

use crate::{Aabb, Foot, Hit, Jet, Ray, Rect};
use glam::DVec3;

/// X(u, v) = center + u · du + v · dv.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    pub(super) center: DVec3,
    pub(super) du: DVec3,
    pub(super) dv: DVec3,
    dual: [DVec3; 2],
    normal: DVec3,
    area: f64,
}

impl Affine {
    /// The tangents must span a plane.
    pub(super) fn new(center: DVec3, du: DVec3, dv: DVec3) -> Affine {
        let cross = du.cross(dv);
        let scale = 1.0 / cross.length_squared();
        let dual = [scale * dv.cross(cross), scale * cross.cross(du)];
        Affine { center, du, dv, dual, normal: cross.normalize(), area: cross.length() }
    }

    pub(super) fn point(&self, u: f64, v: f64) -> DVec3 {
        self.center + u * self.du + v * self.dv
    }

    pub(super) fn jet(&self, u: f64, v: f64) -> Jet {
        Jet { position: self.point(u, v), du: self.du, dv: self.dv, normal: self.normal, area: self.area }
    }

    pub(super) fn bounds(&self, rect: &Rect) -> Aabb {
        Aabb::around(rect.corners().map(|[u, v]| self.point(u, v)))
    }

    /// The parameters of the foot of `point` on the plane.
    pub(super) fn parameters(&self, point: DVec3) -> [f64; 2] {
        self.dual.map(|dual| (point - self.center).dot(dual))
    }

    /// Where the ray's line meets the plane; `None` for parallel rays.
    pub(super) fn meet(&self, ray: &Ray) -> Option<Hit> {
        let t = (self.center - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        let [u, v] = self.parameters(ray.at(t));
        t.is_finite().then_some(Hit { t, u, v })
    }

    /// The nearest point over [−1, 1]²: the foot on the plane, or the best on the four sides of a skew
    /// parallelogram.
    pub(super) fn nearest(&self, point: DVec3) -> Foot {
        let foot = |[u, v]: [f64; 2]| Foot { u, v, distance: self.point(u, v).distance(point) };
        let [u, v] = self.parameters(point);
        if u.abs() <= 1.0 && v.abs() <= 1.0 {
            return foot([u, v]);
        }
        let along = |start: DVec3, d: DVec3| ((point - start).dot(d) / d.length_squared()).clamp(-1.0, 1.0);
        let sides = [-1.0, 1.0].into_iter().flat_map(|side| {
            [[along(self.point(0.0, side), self.du), side], [side, along(self.point(side, 0.0), self.dv)]]
        });
        sides.map(foot).min_by(|a, b| a.distance.total_cmp(&b.distance)).expect("four sides")
    }
}
