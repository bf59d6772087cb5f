//! Surfaces as rays meet them.
//!
//! A walk leaves a surface from just before the side that it leaves by, farther off than roundings reach: by
//! 10⁻¹² of the largest coordinate where the surface is flat, by 10⁻⁷ of its size where it is curved. A point
//! that is read, and lies within 10⁻⁶ of a surface's size of it, lies on it, and is read just before the uppermost
//! of such surfaces on its side; surfaces larger than nine tenths of all count as no larger. What lies farther than
//! roundings before it and shows it the front of a sheet of one side is not one of these. Of coplanar faces of one
//! direction the smaller lies on the larger.

use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, Ray, RayTree, Rect, Surface, layer_order};
use radiosity_scene::Scene;

use crate::spread::SpreadPoint;

/// Distance before a flat surface over the largest coordinate. Chosen: a thousand times what rounding moves a hit by.
const BEFORE_FLAT: f64 = 1e-12;

/// Distance before a curved surface over its size, and before a point that is read over the usual size. Chosen: a
/// thousand times what the roots of a ray err by, and a hundred times the overhang at which borders are met.
const BEFORE_CURVED: f64 = 1e-7;

/// Part of the surfaces that are no larger than the usual size.
const USUAL: f64 = 0.9;

/// Distance from a surface over its size within which a point that is read lies on it: as readings are typed.
const ON_SURFACE: f64 = 1e-6;

/// Distance before the front of a sheet of one side over the scene's size from which on a point that is read along
/// a normal towards it sees it: farther than sheets in one plane are set apart.
const SEEN: f64 = 2e-7;

/// Distance from a surface over its size within which other faces cover it or touch it.
const TOUCHING: f64 = 2e-7;

/// Part of that within which faces lie in one plane.
const COPLANAR: f64 = 1e-2;

/// Distance from a point on a lamp over the lamp's size within which a ray towards it meets that point.
const MEETS: f64 = 1e-6;

/// Relative distance along a ray within which the other side of a sheet is looked for.
const SAME_PLACE: f64 = 1e-9;

/// The surfaces of a scene, for rays.
#[derive(Debug)]
pub(crate) struct Rays {
    /// Upper surfaces first ([`layer_order`]): of those that are met at once the first counts.
    tree: RayTree,
    /// Index in the scene by place in the tree.
    order: Vec<usize>,
    shapes: Vec<Arc<dyn Surface>>,
    /// Normals of those that are flat.
    normals: Vec<Option<DVec3>>,
    areas: Vec<f64>,
    other_sides: Vec<Option<usize>>,
    boxes: Bvh,
    /// Diagonals of the surfaces' boxes.
    sizes: Vec<f64>,
    /// Size that nine tenths of the surfaces do not exceed.
    usual_size: f64,
    /// Distance from which on a point sees what it is before (scene length).
    seen_from: f64,
    /// Distance before flat surfaces from which walks leave them (scene length).
    before_flat: f64,
}

/// Place where a ray meets the front of a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// Index of the surface.
    pub(crate) surface: usize,
    /// Its parameters there.
    pub(crate) parameters: [f64; 2],
    pub(crate) point: DVec3,
    /// Unit normal of the front.
    pub(crate) normal: DVec3,
}

/// A surface that a line through a point that is read crosses.
struct Crossed {
    /// Height over the point along its normal (scene length).
    height: f64,
    /// Whether the point sees it.
    is_seen: bool,
    /// Distance before it from which walks leave it (scene length).
    before: f64,
}

impl Place {
    /// A point that is spread over a surface.
    pub(crate) fn on(surface: usize, on: &SpreadPoint) -> Self {
        let parameters = on.parameters.unwrap_or_default();
        Self { surface, parameters, point: on.point, normal: on.normal }
    }
}

impl Rays {
    pub(crate) fn of(scene: &Scene) -> Self {
        let shapes: Vec<Arc<dyn Surface>> =
            scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect();
        let areas: Vec<f64> = shapes.iter().map(|shape| shape.area()).collect();
        let mut order: Vec<usize> = (0..shapes.len()).collect();
        order.sort_by(|a, b| layer_order(areas[*b], areas[*a]).then(a.cmp(b)));
        let tree = RayTree::new(order.iter().map(|k| Arc::clone(&shapes[*k])).collect());
        let boxes: Vec<Aabb> = shapes.iter().map(|shape| shape.bounds(&Rect::FULL)).collect();
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        let sizes: Vec<f64> = boxes.iter().map(Aabb::diagonal).collect();
        Self {
            tree,
            order,
            normals: shapes.iter().map(|shape| shape.region().map(|region| region.normal())).collect(),
            shapes,
            areas,
            other_sides: scene.surfaces.iter().map(|surface| surface.other_side).collect(),
            boxes: Bvh::build(&boxes),
            before_flat: BEFORE_FLAT * bounds.min.abs().max(bounds.max.abs()).max_element(),
            usual_size: usual(&sizes),
            seen_from: SEEN * bounds.diagonal(),
            sizes,
        }
    }

    /// Area of a surface (scene length²).
    pub(crate) fn area(&self, surface: usize) -> f64 {
        self.areas[surface]
    }

    /// The shape of a surface.
    pub(crate) fn shape(&self, surface: usize) -> &Arc<dyn Surface> {
        &self.shapes[surface]
    }

    /// Number of surfaces.
    pub(crate) fn count(&self) -> usize {
        self.shapes.len()
    }

    /// Distance from a surface within which others touch it (scene length).
    pub(crate) fn touching(&self, surface: usize) -> f64 {
        TOUCHING * self.sizes[surface]
    }

    /// Distance before a surface from which walks leave it (scene length).
    fn before(&self, surface: usize) -> f64 {
        match self.normals[surface] {
            Some(_) => self.before_flat,
            None => BEFORE_CURVED * self.sizes[surface],
        }
    }

    /// The point from which a walk leaves a place on a surface by a unit normal of either side.
    #[inline]
    pub(crate) fn left(&self, place: &Place, normal: DVec3) -> DVec3 {
        place.point + self.before(place.surface) * normal
    }

    /// The point from which light is read at `point` along a unit normal: itself where it lies on no surface, else
    /// just before the uppermost of those that it lies on, and a little before itself at the least, as it may lie
    /// on a border, which rays along the surface meet.
    pub(crate) fn read_from(&self, point: DVec3, normal: DVec3) -> DVec3 {
        let reach = ON_SURFACE * self.usual_size;
        let around = Aabb::around([point - reach * normal, point + reach * normal]);
        let height = |surface: usize| {
            let near = ON_SURFACE * self.sizes[surface].min(self.usual_size);
            let across = Ray::segment(point + near * normal, point - near * normal);
            let hit = self.shapes[surface].intersect(&across)?;
            let front = self.normal(surface, [hit.u, hit.v]).dot(normal);
            let height = (1.0 - 2.0 * hit.t) * near;
            let is_seen = self.other_sides[surface].is_none() && height * -front > self.seen_from;
            Some(Crossed { height, is_seen, before: self.before(surface) })
        };
        let near = self.boxes.near(&around);
        let is_on = |surface: &usize| self.distance(*surface, point) <= ON_SURFACE * self.usual_size;
        if !near.iter().any(is_on) {
            return point;
        }
        let crossed: Vec<Crossed> = near.into_iter().filter_map(height).collect();
        let seen = crossed.iter().filter(|other| other.is_seen).map(|other| other.height);
        let seen = seen.fold(f64::INFINITY, f64::min);
        let heights =
            crossed.iter().filter(|other| other.height < seen).map(|other| other.height + other.before);
        point + heights.fold(BEFORE_CURVED * self.usual_size, f64::max).min(0.5 * seen) * normal
    }

    /// Unit normal of a front.
    fn normal(&self, surface: usize, [u, v]: [f64; 2]) -> DVec3 {
        self.normals[surface].unwrap_or_else(|| self.shapes[surface].jet(u, v).normal)
    }

    /// Distance of a point from a surface that it is close to.
    fn distance(&self, surface: usize, point: DVec3) -> f64 {
        let shape = &self.shapes[surface];
        match shape.region() {
            Some(region) => region.nearest(point).distance(point),
            None => shape.project(point).distance,
        }
    }

    /// The front that a ray meets first which starts at `point` in the unit direction `along`; None where it meets
    /// nothing, or the back of a surface of one side, which is black.
    #[inline]
    pub(crate) fn first(&self, point: DVec3, along: DVec3) -> Option<Place> {
        self.met(&Ray::new(point, along))
    }

    /// The front that a ray meets first, as of [`Rays::first`].
    pub(crate) fn met(&self, ray: &Ray) -> Option<Place> {
        let met = self.tree.nearest(ray)?;
        let surface = self.order[met.surface];
        if met.front {
            return Some(self.place(ray, surface, met.hit.t, [met.hit.u, met.hit.v]));
        }
        // The back of a sheet is met where roundings put its front behind it.
        let other = self.other_sides[surface]?;
        let near = SAME_PLACE * (met.hit.t + self.sizes[other]);
        let within = Ray { range: [met.hit.t - near, met.hit.t + near], ..*ray };
        let hit = self.shapes[other].intersect(&within)?;
        Some(self.place(ray, other, hit.t, [hit.u, hit.v]))
    }

    #[inline]
    fn place(&self, ray: &Ray, surface: usize, t: f64, parameters: [f64; 2]) -> Place {
        match self.normals[surface] {
            Some(normal) => Place { surface, parameters, point: ray.at(t), normal },
            None => {
                let jet = self.shapes[surface].jet(parameters[0], parameters[1]);
                Place { surface, parameters, point: jet.position, normal: jet.normal }
            }
        }
    }

    /// Whether nothing stands between `point` and `end`, a point of no surface or where one ends.
    pub(crate) fn is_free(&self, point: DVec3, end: DVec3) -> bool {
        self.tree.is_free(&Ray { range: [0.0, 1.0 - SAME_PLACE], ..Ray::segment(point, end) })
    }

    /// Whether a point on the front of a surface is what a ray towards it meets first.
    pub(crate) fn sees(&self, point: DVec3, surface: usize, end: DVec3) -> bool {
        let room = MEETS * (self.sizes[surface] + point.distance(end));
        let met = self.first(point, (end - point).normalize());
        met.is_some_and(|place| place.surface == surface && place.point.distance(end) <= room)
    }

    /// Whether a place on a surface is the uppermost on its side, and not touched by what stands on it.
    pub(crate) fn is_bare(&self, place: &Place) -> bool {
        let reach = self.touching(place.surface);
        let [below, above] = [-reach, reach].map(|step| place.point + step * place.normal);
        let around = Aabb::around([below, above]).inflate(reach);
        let across = Ray::segment(above, below);
        let covers = |other: &usize| {
            let own = [Some(place.surface), self.other_sides[place.surface]];
            if own.contains(&Some(*other)) {
                return false;
            }
            let Some(hit) = self.shapes[*other].intersect(&across) else { return false };
            let height = (1.0 - 2.0 * hit.t) * reach;
            let normal = self.normal(*other, [hit.u, hit.v]);
            let is_coplanar = height.abs() <= COPLANAR * reach;
            match is_coplanar && normal.dot(place.normal) > 0.0 {
                true => layer_order(self.areas[*other], self.areas[place.surface]).is_gt(),
                false => height >= -COPLANAR * reach,
            }
        };
        !self.boxes.near(&around).iter().any(covers)
    }
}

/// The size that nine tenths of these do not exceed.
fn usual(sizes: &[f64]) -> f64 {
    let mut sorted = sizes.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = (USUAL * sorted.len().saturating_sub(1) as f64) as usize;
    sorted.get(place).copied().unwrap_or(0.0)
}
