//! First hit of a ray among many surfaces.
//!
//! The surfaces lie in a tree of bounding boxes, eight to a node (Dammertz, Hanika, Keller, *Shallow bounding
//! volume hierarchies for fast SIMD ray tracing of incoherent rays*, 2008, with four). Boxes are tested eight
//! at a time, flat surfaces four at a time, in single precision, with room for its roundings: whoever fails
//! is missed for certain. Whoever passes is met, or not, in double precision by the surface's own formulas.
//! So the answer is that of all surfaces asked one by one.
//!
//! A ray may start on a surface. It does not meet that one there, nor the other side of the same sheet: a
//! flat one not at all, a curved one only where it comes back to it. Where it starts on a crease, on several
//! surfaces at once, it meets those others there that it goes through from the front and that reach before
//! its own, so that no light leaks out of a corner.
//!
//! Where two surfaces are met at once, as the sides of a sheet are, a front goes before a back, then the smaller
//! of two flat ones, which was laid on the other, and then the one that comes first in the list.

mod frame;
mod fork;
mod facet;
mod flats;
mod build;
mod twins;

use crate::tolerances::OVERHANG;
use crate::{Aabb, Hit, PlanarRegion, Ray, Rect, Surface};
use build::{Content, DEEPEST, Item, Layout};
use facet::{Facet, Meeting};
use flats::Flats;
use fork::{Entry, Fork, WIDTH, at_start, child, place};
use frame::{Frame, Ray32};
use glam::DVec3;
use std::sync::Arc;
use twins::twins;

/// Most children that wait to be visited in a tree so deep: all but the nearest at each depth.
const fn most_waiting(depth: usize) -> usize {
    (WIDTH - 1) * depth + WIDTH
}

/// Forks from the root to any leaf in most trees: a ray clears a shorter stack for these.
const SHALLOW: usize = 5;

/// Hits of t no farther apart than this part of them are one hit.
const TIE: f64 = 1e-12;

/// Beyond [`TIE`] by far.
const MARGIN: f64 = 1e-10;

/// Distance by which a ray leaves a curved surface before it may meet it again, as a part of the surface's
/// size: more than a root of the ray's polynomial moves by the rounding δ of where it starts, δ / cos θ, for
/// all but one in 10¹² of the rays that leave diffusely.
const LEAVING: f64 = 1e-6;

/// Distance between places that agree but for rounding, as a part of the largest coordinate.
const TOUCH: f64 = 64.0 * f64::EPSILON;

/// Distance along a ray, as a part of another surface's size, at which it is tested whether the ray has
/// passed that surface's border: small beside the tolerance of its plane, large beside that at seams.
const AHEAD: f64 = 1e-7;

/// Least distance, as a part of its size, by which a surface reaches before the one that a ray starts on to
/// count as before it.
const BEFORE: f64 = 1e-9;

/// Cosine between the normals of surfaces that lie face to face.
const OPPOSED: f64 = 1.0 - 1e-12;

/// Within this part of the largest coordinate a hit may be where the ray starts, but for rounding.
const NEAR: f64 = 1e-9;

/// Hits behind the start of a ray and within roundings of it, at most.
const MOST_PASSED: usize = 4;

/// Hit of a ray on one of many surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encounter {
    /// The surface, by its place in the list.
    pub surface: usize,
    /// Where the ray meets it.
    pub hit: Hit,
    /// Whether the ray comes from before the surface.
    pub front: bool,
    /// Unit normal of the surface there, where its side was told by it.
    pub normal: Option<DVec3>,
}

/// Surfaces, found by rays.
#[derive(Clone, Debug)]
pub struct RayTree {
    surfaces: Vec<Arc<dyn Surface>>,
    frame: Frame,
    forks: Vec<Fork>,
    flats: Vec<Flats>,
    /// Forks from the root to any leaf, at most.
    depth: usize,
    /// Of the flat surfaces that are such, four for each of `flats`.
    facets: Vec<Option<Facet>>,
    twins: Vec<u32>,
    /// Diagonals of the surfaces' boxes.
    sizes: Vec<f64>,
    /// Areas of the flat surfaces; 0 of others.
    areas: Vec<f64>,
    /// The largest coordinate (length).
    size: f64,
}

impl RayTree {
    /// The tree of `surfaces`, of which there are less than 2³⁰. Takes some microseconds for each.
    pub fn new(surfaces: Vec<Arc<dyn Surface>>) -> RayTree {
        let boxes: Vec<Aabb> = surfaces.iter().map(|surface| surface.bounds(&Rect::FULL)).collect();
        let origin = Aabb { min: DVec3::ZERO, max: DVec3::ZERO };
        let bounds = boxes.iter().copied().reduce(Aabb::union).unwrap_or(origin);
        let frame = Frame::around(&bounds);
        let item = |(k, (bounds, surface)): (usize, (&Aabb, &Arc<dyn Surface>))| Item {
            bounds: frame.enclose(&bounds.inflate(OVERHANG * bounds.diagonal())),
            surface: k as u32,
            is_flat: surface.region().is_some(),
        };
        let Layout { forks, flats, depth } =
            Layout::new(boxes.iter().zip(&surfaces).enumerate().map(item).collect());
        let facet = |place: Option<&u32>| Facet::of(&*surfaces[*place? as usize]);
        let facets = flats.iter().flat_map(|leaf| (0..flats::WIDTH).map(|k| facet(leaf.get(k)))).collect();
        let flats = flats.iter().map(|leaf| Flats::new(&surfaces, leaf, &frame)).collect();
        let twins = twins(&surfaces, &boxes);
        let sizes = boxes.iter().map(Aabb::diagonal).collect();
        let area = |surface: &Arc<dyn Surface>| surface.region().map_or(0.0, PlanarRegion::area);
        let areas = surfaces.iter().map(area).collect();
        let size = bounds.min.abs().max(bounds.max.abs()).max_element();
        RayTree { surfaces, frame, forks, flats, depth, facets, twins, sizes, areas, size }
    }

    /// The first surface that the ray meets within its range.
    pub fn nearest(&self, ray: &Ray) -> Option<Encounter> {
        Search::new(self, *ray, None).nearest()
    }

    /// Whether the ray meets nothing within its range.
    pub fn is_free(&self, ray: &Ray) -> bool {
        Search { goal: Goal::Any, ..Search::new(self, *ray, None) }.meets_nothing()
    }

    /// The first surface that a ray meets which starts at `origin`, on the surface of place `own`, and goes
    /// along `direction`, of any length but zero.
    pub fn nearest_from(&self, own: usize, origin: DVec3, direction: DVec3) -> Option<Encounter> {
        let (ray, start) = self.leaving(own, origin, direction, f64::INFINITY);
        Search::new(self, ray, Some(start)).nearest()
    }

    /// Distance behind its start, and before it, within which a ray may still meet what it starts on
    /// (length).
    pub fn reach(&self) -> f64 {
        NEAR * self.size
    }

    /// Key of how rays start on the surface of place `own`: as long as it and the surfaces that they may meet
    /// stay the same, so does what [`RayTree::nearest_from`] says, to the bit.
    pub fn start_on(&self, own: usize) -> [u64; 2] {
        [self.size.to_bits(), u64::from(self.twins[own])]
    }

    /// The other side of the sheet that the surface of place `own` is one side of; `own` where it has none.
    pub fn other_side(&self, own: usize) -> usize {
        self.twins[own] as usize
    }

    /// Whether a ray as of [`RayTree::nearest_from`] through other surfaces, with this [`RayTree::reach`],
    /// might meet one of these before `end`, in multiples of `direction`, or as near to it as two that are
    /// met at once.
    pub fn may_come_before(&self, origin: DVec3, direction: DVec3, end: f64, reach: f64) -> bool {
        let room = 2.0 * reach / direction.length();
        let range = [-room, end + room + MARGIN * end.abs()];
        self.nearest(&Ray { origin, direction, range }).is_some()
    }

    /// Whether a ray as of [`RayTree::nearest_from`] meets nothing before `end`, in multiples of `direction`.
    pub fn is_free_from(&self, own: usize, origin: DVec3, direction: DVec3, end: f64) -> bool {
        let (ray, start) = self.leaving(own, origin, direction, end);
        Search { goal: Goal::Any, ..Search::new(self, ray, Some(start)) }.meets_nothing()
    }

    /// A ray that starts on a surface.
    fn leaving(&self, own: usize, origin: DVec3, direction: DVec3, end: f64) -> (Ray, Start) {
        let start = Start { own: [own, self.twins[own] as usize], step: 1.0 / direction.length() };
        let range = [-start.step * NEAR * self.size, end];
        (Ray { origin, direction, range }, start)
    }
}

/// Start of a ray on a surface.
#[derive(Clone, Copy, Debug)]
struct Start {
    /// The surface and its twin.
    own: [usize; 2],
    /// t per unit of length.
    step: f64,
}

/// The nearest hit so far.
#[derive(Clone, Copy, Debug)]
struct Best {
    surface: usize,
    hit: Hit,
    /// Whether the front is met; None where it has not been told yet.
    front: Option<bool>,
}

/// A ray on its way through a tree, cut off beyond the nearest hit so far.
struct Search<'a> {
    tree: &'a RayTree,
    ray: Ray,
    best: Option<Best>,
    start: Option<Start>,
    goal: Goal,
    /// Whether the ray is known to meet something, wherever that is.
    is_blocked: bool,
}

/// Goal of a search: the nearest hit, or any hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Goal {
    Nearest,
    Any,
}

impl<'a> Search<'a> {
    fn new(tree: &'a RayTree, ray: Ray, start: Option<Start>) -> Self {
        Self { tree, ray, best: None, start, goal: Goal::Nearest, is_blocked: false }
    }

    fn nearest(&mut self) -> Option<Encounter> {
        self.walk();
        let best = self.best?;
        let (front, normal) = self.side(&best);
        Some(Encounter { surface: best.surface, hit: best.hit, front, normal })
    }

    fn meets_nothing(&mut self) -> bool {
        self.walk();
        !self.is_blocked && self.best.is_none()
    }

    /// Visits what the ray may meet, with a stack that is no longer than the tree is deep.
    fn walk(&mut self) {
        match self.tree.depth <= SHALLOW {
            true => self.walk_with(&mut [0; most_waiting(SHALLOW)]),
            false => self.walk_with(&mut [0; most_waiting(DEEPEST)]),
        }
    }

    /// Visits what the ray may meet, near boxes first; others wait on the stack.
    fn walk_with(&mut self, stack: &mut [Entry]) {
        let tree = self.tree;
        let Some(ray) = tree.frame.ray(&self.ray) else { return };
        let mut end = ray.end(self.ray.range[1]);
        let mut depth = 0;
        let mut next = (!tree.forks.is_empty()).then(|| at_start(0));
        while let Some(entry) = next {
            next = None;
            if place(entry) <= end {
                match Content::of(child(entry)) {
                    Content::Fork(fork) => next = tree.forks[fork].entered(&ray, end, stack, &mut depth),
                    leaf => {
                        self.visit_leaf(leaf, &ray, end);
                        if self.goal == Goal::Any && (self.is_blocked || self.best.is_some()) {
                            return;
                        }
                        end = ray.end(self.ray.range[1]);
                    }
                }
            }
            if next.is_none() && depth > 0 {
                depth -= 1;
                next = Some(stack[depth]);
            }
        }
    }

    #[inline]
    fn visit_leaf(&mut self, leaf: Content, ray: &Ray32, end: f32) {
        match leaf {
            Content::Fork(_) => {}
            Content::Flats(leaf) => self.visit_flats(leaf, ray, end),
            Content::Curved(surface) => self.visit_curved(surface),
        }
    }

    #[inline]
    fn visit_flats(&mut self, leaf: usize, ray: &Ray32, end: f32) {
        let flats = &self.tree.flats[leaf];
        let mut left = flats.may_be_hit(ray, end);
        while left != 0 {
            let k = left.trailing_zeros() as usize % flats::WIDTH;
            left &= left - 1;
            let surface = flats.surface(k);
            if !self.is_own(surface) {
                self.visit_flat(surface, self.tree.facets[flats::WIDTH * leaf + k].as_ref());
            }
        }
    }

    fn visit_flat(&mut self, surface: usize, facet: Option<&Facet>) {
        let best = match facet.map_or(Meeting::Doubtful, |facet| facet.meet(&self.ray)) {
            Meeting::None => return,
            Meeting::At(hit, front) => Best { surface, hit, front: Some(front) },
            Meeting::Doubtful => {
                let Some(hit) = self.tree.surfaces[surface].intersect(&self.ray) else { return };
                Best { surface, hit, front: None }
            }
        };
        if self.counts(&best) {
            self.offer(best);
        }
    }

    fn visit_curved(&mut self, surface: usize) {
        let own = self.start.filter(|start| start.own.contains(&surface));
        let leaving = |start: Start| LEAVING * self.tree.sizes[surface] * start.step;
        let mut ray = Ray { range: [own.map_or(self.ray.range[0], leaving), self.ray.range[1]], ..self.ray };
        if self.goal == Goal::Any {
            // Beyond the start of the ray all hits count.
            let near = self.start.filter(|_| own.is_none()).map(|start| start.step * NEAR * self.tree.size);
            let far = Ray { range: [near.map_or(ray.range[0], f64::next_up), ray.range[1]], ..ray };
            self.is_blocked = self.tree.surfaces[surface].occludes(&far);
            match near {
                Some(near) if !self.is_blocked => ray.range[1] = near.min(ray.range[1]),
                _ => return,
            }
        }
        for _ in 0..MOST_PASSED {
            let Some(hit) = self.tree.surfaces[surface].intersect(&ray) else { return };
            let best = Best { surface, hit, front: None };
            if own.is_some() || self.counts(&best) {
                return self.offer(best);
            }
            ray.range[0] = hit.t.next_up();
        }
    }

    /// Takes a hit for the nearest, if it is.
    fn offer(&mut self, new: Best) {
        if let Some(old) = &self.best
            && !self.goes_before(&new, old)
        {
            return;
        }
        self.best = Some(new);
        let end = new.hit.t + TIE * new.hit.t.abs();
        self.ray.range[1] = self.ray.range[1].min(end);
    }

    fn goes_before(&self, new: &Best, old: &Best) -> bool {
        let (t, nearest) = (new.hit.t, old.hit.t);
        if (t - nearest).abs() > TIE * nearest.abs() {
            return t < nearest;
        }
        match (self.is_front(new), self.is_front(old)) {
            (a, b) if a == b => {
                let [new, old] = [new, old].map(|best| (self.tree.areas[best.surface], best.surface));
                new < old
            }
            (is_front, _) => is_front,
        }
    }

    fn is_front(&self, best: &Best) -> bool {
        self.side(best).0
    }

    /// Whether the ray comes from before a hit, and the normal where that tells it.
    fn side(&self, best: &Best) -> (bool, Option<DVec3>) {
        match best.front {
            Some(front) => (front, None),
            None => {
                let normal = self.normal(best);
                (normal.dot(self.ray.direction) < 0.0, Some(normal))
            }
        }
    }

    fn is_own(&self, surface: usize) -> bool {
        self.start.is_some_and(|start| start.own.contains(&surface))
    }

    /// Whether the ray meets a surface where it hits it: not behind its start, and, where it starts on a
    /// crease, not one that it leaves.
    fn counts(&self, best: &Best) -> bool {
        let (Some(start), t) = (self.start, best.hit.t) else { return true };
        if t.abs() > start.step * NEAR * self.tree.size {
            return true;
        }
        let normal = self.normal(best);
        let height = t * normal.dot(self.ray.direction);
        if height.abs() > TOUCH * self.tree.size {
            return t >= 0.0;
        }
        self.is_front(best) && self.is_before_start(best.surface, normal, start)
    }

    /// Whether a surface at the start of the ray reaches before the one that the ray starts on, or covers it
    /// face to face.
    fn is_before_start(&self, surface: usize, normal: DVec3, start: Start) -> bool {
        let (own, other) = (&self.tree.surfaces[start.own[0]], &self.tree.surfaces[surface]);
        let up = own.region().map_or_else(|| foot_normal(own, self.ray.origin), |region| region.normal());
        if normal.dot(up) < -OPPOSED {
            let ahead = |region: &PlanarRegion| self.ray.at(AHEAD * region.extent() * start.step);
            return other.region().is_none_or(|region| region.contains(ahead(region)));
        }
        let hull = other.region().map_or_else(|| other.hull(&Rect::FULL), |region| region.outer().to_vec());
        let before = BEFORE * self.tree.sizes[surface];
        hull.iter().any(|x| (x - self.ray.origin).dot(up) > before)
    }

    fn normal(&self, best: &Best) -> DVec3 {
        self.tree.surfaces[best.surface].jet(best.hit.u, best.hit.v).normal
    }
}

/// The normal of a surface at a point on it.
fn foot_normal(surface: &dyn Surface, point: DVec3) -> DVec3 {
    let foot = surface.project(point);
    surface.jet(foot.u, foot.v).normal
}
