//! Surfaces as rays meet them.
//!
//! A ray that leaves a point starts the distance δ before it, along the normal that it leaves by: 10⁻⁷ of the
//! largest extent. So a point in a stack of faces belongs to the uppermost on its side, and gaps narrower than
//! δ are closed. A ray towards a point on a lamp ends δ before that. Of coplanar faces of one direction the
//! smaller lies on the larger.

use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, Ray, RayTree, Rect, Surface};
use radiosity_scene::Scene;

/// δ over the largest extent of the scene. Chosen: a thousand times what curved surfaces err by, a tenth of the
/// narrowest gap whose light anybody asks for.
const START: f64 = 1e-7;

/// Distance from the start, in δ, within which other faces are found that cover it or touch it.
const WITHIN: f64 = 2.0;

/// Part of δ within which faces lie in one plane.
const COPLANAR: f64 = 1e-2;

/// Relative distance along a ray within which the other side of a sheet is looked for.
const SAME_PLACE: f64 = 1e-9;

/// The surfaces of a scene, for rays.
#[derive(Debug)]
pub(crate) struct Rays {
    /// Surfaces in ascending order of areas: of those that are met at once the first counts.
    tree: RayTree,
    /// Index in the scene by place in the tree.
    order: Vec<usize>,
    shapes: Vec<Arc<dyn Surface>>,
    /// Normals of those that are flat.
    normals: Vec<Option<DVec3>>,
    areas: Vec<f64>,
    other_sides: Vec<Option<usize>>,
    boxes: Bvh,
    /// δ (scene length).
    start: f64,
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

/// First thing that a ray meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Met {
    /// The front of a surface.
    Front(Place),
    /// The back of a surface of one side, which is black.
    Back,
    /// Nothing.
    Nothing,
}

impl Rays {
    pub(crate) fn of(scene: &Scene) -> Self {
        let shapes: Vec<Arc<dyn Surface>> =
            scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect();
        let areas: Vec<f64> = shapes.iter().map(|shape| shape.area()).collect();
        let mut order: Vec<usize> = (0..shapes.len()).collect();
        order.sort_by(|a, b| areas[*a].total_cmp(&areas[*b]).then(a.cmp(b)));
        let tree = RayTree::new(order.iter().map(|k| Arc::clone(&shapes[*k])).collect());
        let boxes: Vec<Aabb> = shapes.iter().map(|shape| shape.bounds(&Rect::FULL)).collect();
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        Self {
            tree,
            order,
            normals: shapes.iter().map(|shape| shape.region().map(|region| region.normal())).collect(),
            shapes,
            areas,
            other_sides: scene.surfaces.iter().map(|surface| surface.other_side).collect(),
            boxes: Bvh::build(&boxes),
            start: START * (bounds.max - bounds.min).max_element(),
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

    /// Distance δ before a point at which its rays start (scene length).
    pub(crate) fn start(&self) -> f64 {
        self.start
    }

    /// First thing that a ray meets which leaves `point` by the unit vector `normal` in the unit direction `along`.
    #[inline]
    pub(crate) fn first(&self, point: DVec3, normal: DVec3, along: DVec3) -> Met {
        self.met(&Ray::new(point + self.start * normal, along))
    }

    /// First thing that a ray meets.
    pub(crate) fn met(&self, ray: &Ray) -> Met {
        let Some(met) = self.tree.nearest(ray) else { return Met::Nothing };
        let surface = self.order[met.surface];
        if met.front {
            return Met::Front(self.place(ray, surface, met.hit.t, [met.hit.u, met.hit.v]));
        }
        // The back of a sheet is met where roundings put its front behind it.
        let Some(other) = self.other_sides[surface] else { return Met::Back };
        let near = SAME_PLACE * met.hit.t + COPLANAR * self.start;
        let within = Ray { range: [met.hit.t - near, met.hit.t + near], ..*ray };
        match self.shapes[other].intersect(&within) {
            Some(hit) => Met::Front(self.place(ray, other, hit.t, [hit.u, hit.v])),
            None => Met::Back,
        }
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

    /// Whether nothing stands between `point`, left by its normal, and `end`.
    #[inline]
    pub(crate) fn is_free(&self, point: DVec3, normal: DVec3, end: DVec3) -> bool {
        self.tree.is_free(&Ray::segment(point + self.start * normal, end))
    }

    /// Whether a place on a surface is the uppermost on its side, and not touched by what stands on it.
    pub(crate) fn is_bare(&self, place: &Place) -> bool {
        let reach = WITHIN * self.start;
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
            let normal = self.normals[*other].unwrap_or_else(|| self.shapes[*other].jet(hit.u, hit.v).normal);
            let is_coplanar = height.abs() <= COPLANAR * self.start;
            match is_coplanar && normal.dot(place.normal) > 0.0 {
                true => self.areas[*other] < self.areas[place.surface],
                false => height >= -COPLANAR * self.start,
            }
        };
        !self.boxes.near(&around).iter().any(covers)
    }
}
