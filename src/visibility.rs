//! Visibility: who may stand between two patches, and whether a segment is free.
//!
//! A pair of patches first loses every surface that certainly misses the convex hull of the two
//! (the *shaft*); what is left are its candidate blockers, usually few or none. With none the pair is
//! fully visible and no ray is cast. Where one flat convex blocker catches all segments between the
//! corners of the two hulls it catches every segment, and the pair is fully hidden. Otherwise a
//! segment is tested against the candidates alone.

pub mod exact;

use std::sync::Arc;

use radiosity_geom::{Aabb, Bvh, DVec3, Hit, Ray, Rect, Surface, separated};

use crate::scene::Scene;

/// A segment may touch surfaces within this part of its length at both ends.
const END: f64 = 1e-9;

/// The surfaces of a scene as obstacles.
#[derive(Debug)]
pub struct Visibility {
    obstacles: Vec<Obstacle>,
    /// Of all surfaces.
    tree: Bvh,
    /// The surfaces that can stand between two others, ascending.
    standing: Vec<usize>,
    /// Of those.
    standing_tree: Bvh,
    shadows: Shadows,
}

/// Whether surfaces hide each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shadows {
    /// Everything sees everything it faces.
    Off,
    /// Rays against the candidates of each pair. A blocker that reaches into the shaft of a pair by less
    /// than this part of the breadth of the narrower of the two is passed over: it hides about that part
    /// of the light between them at the most.
    Rays(f64),
}

#[derive(Debug)]
struct Obstacle {
    shape: Arc<dyn Surface>,
    hull: Vec<DVec3>,
    /// Convex pieces of a planar obstacle. One that is a single piece can hide a pair by itself.
    pieces: Option<Vec<Vec<DVec3>>>,
}

impl Visibility {
    /// The obstacles of `scene`.
    pub fn new(scene: &Scene, shadows: Shadows) -> Self {
        let obstacles: Vec<Obstacle> = scene.surfaces.iter().map(|s| Obstacle::new(&s.shape)).collect();
        let boxes: Vec<Aabb> = scene.surfaces.iter().map(|s| s.shape.bounds(&Rect::FULL)).collect();
        let standing = standing(&obstacles, &boxes);
        let standing_boxes: Vec<Aabb> = standing.iter().map(|index| boxes[*index]).collect();
        let standing_tree = Bvh::build(&standing_boxes);
        Self { obstacles, tree: Bvh::build(&boxes), standing, standing_tree, shadows }
    }

    /// Surfaces other than the two named that may stand between the hulls of points `a` and `b`, ascending.
    pub fn candidates(&self, a: &[DVec3], b: &[DVec3], surfaces: [usize; 2]) -> Vec<usize> {
        let mut found = Vec::new();
        if self.shadows == Shadows::Off || self.standing.is_empty() {
            return found;
        }
        let bounds = a.iter().chain(b).fold(Aabb::EMPTY, |bounds, point| bounds.grow(*point));
        self.standing_tree.overlapping(&bounds, |place| {
            let index = self.standing[place];
            if !surfaces.contains(&index) {
                found.push(index);
            }
        });
        found.sort_unstable();
        self.narrow(&found, a, b)
    }

    /// Those of `blockers` that may still stand between the hulls of `a` and `b`.
    pub fn narrow(&self, blockers: &[usize], a: &[DVec3], b: &[DVec3]) -> Vec<usize> {
        let Shadows::Rays(tolerance) = self.shadows else { return Vec::new() };
        let size = breadth(a).min(breadth(b));
        let reaches = |index: &usize| !separated(a, b, &self.obstacles[*index].hull, tolerance * size);
        blockers.iter().copied().filter(reaches).collect()
    }

    /// Whether one of `blockers` alone hides the hulls of `a` and `b` from each other wholly.
    pub fn hidden(&self, blockers: &[usize], a: &[DVec3], b: &[DVec3]) -> bool {
        blockers.iter().any(|index| {
            let obstacle = &self.obstacles[*index];
            obstacle.is_convex()
                && a.iter().all(|x| b.iter().all(|y| obstacle.shape.occludes(&segment(*x, *y))))
        })
    }

    /// Whether the open segment from `x` to `y` misses all of `blockers`.
    pub fn free(&self, blockers: &[usize], x: DVec3, y: DVec3) -> bool {
        let ray = segment(x, y);
        !blockers.iter().any(|index| self.obstacles[*index].shape.occludes(&ray))
    }

    /// Whether `blocker` may reach, however little, between the hulls of `a` and `b`.
    pub fn reaches(&self, blocker: usize, a: &[DVec3], b: &[DVec3]) -> bool {
        !separated(a, b, &self.obstacles[blocker].hull, 0.0)
    }

    /// Centre and radius of the only one of `blockers` where that is a whole ball.
    pub fn only_ball(&self, blockers: &[usize]) -> Option<(DVec3, f64)> {
        let [only] = blockers else { return None };
        self.obstacles[*only].shape.ball()
    }

    /// Convex polygons that make up a planar surface; None for curved ones.
    pub fn pieces(&self, surface: usize) -> Option<&[Vec<DVec3>]> {
        self.obstacles[surface].pieces.as_deref()
    }

    /// Whether any surface of the scene may stand between any two others.
    pub fn any_shadow(&self) -> bool {
        let n = self.obstacles.len();
        let pair = |i: usize, j: usize| (&self.obstacles[i].hull, &self.obstacles[j].hull);
        (0..n).any(|i| {
            (0..i).any(|j| {
                let (a, b) = pair(i, j);
                !self.candidates(a, b, [i, j]).is_empty()
            })
        })
    }

    /// The first surface that a ray meets.
    ///
    /// Front and back of a two-sided surface are met at once: a back counts as a trifle farther.
    pub fn nearest(&self, ray: &Ray) -> Option<(usize, Hit)> {
        self.tree.nearest(ray, |index, ray| {
            let shape = &self.obstacles[index].shape;
            let hit = shape.intersect(ray)?;
            let back = shape.jet(hit.u, hit.v).normal.dot(ray.direction) > 0.0;
            let t = if back { hit.t * (1.0 + 1e-12) } else { hit.t };
            ray.reaches(t).then_some(Hit { t, ..hit })
        })
    }
}

impl Obstacle {
    fn new(shape: &Arc<dyn Surface>) -> Self {
        let hull = shape.region().map_or_else(|| shape.hull(&Rect::FULL), |region| region.outer().to_vec());
        let pieces = shape.region().map(|region| region.convex_pieces());
        Self { shape: Arc::clone(shape), hull, pieces }
    }

    fn is_convex(&self) -> bool {
        self.pieces.as_ref().is_some_and(|pieces| pieces.len() == 1)
    }
}

/// The surfaces that can stand between two others, ascending.
///
/// A planar surface that has the whole scene on one side of its plane stands between no two points of it: the walls of a
/// convex room drop out here once and for all.
fn standing(obstacles: &[Obstacle], boxes: &[Aabb]) -> Vec<usize> {
    let scene = boxes.iter().fold(Aabb::EMPTY, |bounds, other| bounds.union(*other));
    let tolerance = END * scene.diagonal();
    let walls_in = |obstacle: &Obstacle| {
        let (Some(_), [point, ..]) = (&obstacle.pieces, &obstacle.hull[..]) else { return false };
        let normal = obstacle.shape.jet(0.0, 0.0).normal;
        let height = |x: &DVec3| (x - point).dot(normal);
        let points = || obstacles.iter().flat_map(|other| &other.hull).map(height);
        points().all(|h| h >= -tolerance) || points().all(|h| h <= tolerance)
    };
    (0..obstacles.len()).filter(|index| !walls_in(&obstacles[*index])).collect()
}

/// Largest distance of points from the line through the first and the point farthest from it.
fn breadth(points: &[DVec3]) -> f64 {
    let farther = |a: &&DVec3, b: &&DVec3| a.distance(points[0]).total_cmp(&b.distance(points[0]));
    let Some(far) = points.iter().max_by(farther) else { return 0.0 };
    let along = (far - points[0]).normalize_or_zero();
    points.iter().map(|x| (x - points[0]).cross(along).length()).fold(0.0, f64::max)
}

fn segment(x: DVec3, y: DVec3) -> Ray {
    Ray { origin: x, direction: y - x, range: [END, 1.0 - END] }
}
