//! Visibility: which surfaces may stand between two patches, and whether a segment is free.
//!
//! A surface that certainly misses the convex hull of two patches (the *shaft*) hides nothing; the remaining
//! surfaces are the candidate blockers of the pair, usually few or none. Without candidates the pair is fully
//! visible and no ray is cast. Where one flat convex blocker meets all segments between the corners of the
//! two hulls it meets every segment, and the pair is fully hidden. Otherwise segments are tested against the
//! candidates alone.
//!
//! In order: [`tolerances`], [`blocker_edges`], [`bounding_ball`], [`shadow_volume`], [`round_outline`],
//! `shadow_cone`, [`frustum`], [`round_shadow`] and [`blocker_shadow`] (what blockers hide from a point),
//! `cloud`, `convex_bodies`, `screens` (joined surfaces), [`silhouette_mesh`], [`Shadows`] (ways to find
//! them), `within` (what lies in a convex solid), `obstacle` (of what obstacles are made), `shells` (balls with
//! something within), `rays`, [`Surroundings`] and `whole` (what rays meet first, about a point, what hides as a
//! whole), `screened` (what joined surfaces hide), `shaft` (whether anything can stand between flat surfaces),
//! [`Visibility`], the noun of the crate; then what a scene says of itself: [`footprints`] (where bodies stand),
//! [`covered_parts`] (flat surfaces on others) and [`inspection`] (contents, contacts, what looks wrong).
//!
//! Imports `core`, `geom`, `work`, `fit` and `scene`.

pub mod tolerances;
mod golden_spiral;
pub mod blocker_edges;
pub mod bounding_ball;
pub mod shadow_volume;
pub mod round_outline;
mod shadow_cone;
pub mod frustum;
pub mod round_shadow;
pub mod blocker_shadow;
mod cloud;
mod convex_bodies;
mod screens;
pub mod silhouette_mesh;
mod shadows;
mod within;
mod obstacle;
mod shells;
mod rays;
mod surroundings;
mod whole;
mod screened;
mod shaft;
pub mod footprints;
pub mod covered_parts;
pub mod inspection;

use std::cmp::Ordering;
use std::sync::Arc;

use radiosity_geom::{
    Aabb, Bvh, COINCIDENT, DVec3, Jet, Meridian, Plane, Ray, RayTree, Rect, Surface, separated, touching,
};
use radiosity_scene::Scene;
use radiosity_work::interruption::check_interrupt;

use bounding_ball::Ball;
use cloud::Cloud;
use convex_bodies::{Bodies, Face, twins};
use frustum::Frustum;
use obstacle::{Bend, Obstacle};
pub use screens::End;
use screens::Screens;
pub use shadows::Shadows;
pub use shaft::{BetweenGroups, FlatEnd, Neighbours, Normals, Places};
pub use shells::Place;
use shells::Shells;
use silhouette_mesh::SilhouetteMesh;
pub use surroundings::Surroundings;
use tolerances::{END, OWN_END};

/// The surfaces of a scene as obstacles.
#[derive(Debug)]
pub struct Visibility {
    obstacles: Vec<Obstacle>,
    /// Bounding boxes of the surfaces.
    boxes: Vec<Aabb>,
    /// Hierarchy of all surfaces.
    tree: Bvh,
    /// Hierarchy of all surfaces, for first hits of rays.
    rays: RayTree,
    /// The surfaces that can stand between two others, ascending.
    standing: Vec<usize>,
    /// Hierarchy of the standing surfaces.
    standing_tree: Bvh,
    bodies: Bodies,
    /// The solids that curved surfaces close, where they lie between two coaxial circles.
    frusta: Vec<Option<Frustum>>,
    screens: Screens,
    /// Whole balls with something within; none without shadows.
    shells: Shells,
    /// Rank of each surface by the coordinates of its hull.
    places: Vec<usize>,
    shadows: Shadows,
    /// Accuracy of the shadows: a blocker that reaches into the shaft by less than this part of the narrower patch's
    /// breadth, times its own thickness over its size, is ignored, as it hides at most about that part of the light
    /// between them.
    eps: f64,
}

/// Bounds of a blocker.
#[derive(Clone, Copy)]
struct Hull<'a> {
    ball: &'a Ball,
    /// Points whose convex hull contains it.
    points: &'a [DVec3],
}

impl Visibility {
    /// The surfaces of `scene`, none of which hides anything.
    pub fn open(scene: &Scene) -> Self {
        Self::new(scene, Shadows::Off, 0.0)
    }

    /// The obstacles of `scene`, whose shadows are found so, to the accuracy `eps`.
    pub fn new(scene: &Scene, shadows: Shadows, eps: f64) -> Self {
        let obstacle = |shape: &Arc<dyn Surface>| {
            check_interrupt();
            Obstacle::new(shape)
        };
        let obstacles: Vec<Obstacle> = scene.surfaces.iter().map(|s| obstacle(&s.shape)).collect();
        let boxes: Vec<Aabb> = scene.surfaces.iter().map(|s| s.shape.bounds(&Rect::FULL)).collect();
        let cloud = cloud_of(&obstacles);
        let tree = Bvh::build(&boxes);
        let rays = RayTree::new(scene.surfaces.iter().map(|s| Arc::clone(&s.shape)).collect());
        let (bodies, screens) = bodies(&obstacles, &cloud);
        let places = places(&obstacles);
        let frusta = frusta(&obstacles, &boxes, &tree);
        let unseen = Self {
            obstacles,
            boxes,
            tree,
            rays,
            standing: Vec::new(),
            standing_tree: Bvh::build(&[]),
            bodies,
            frusta,
            screens,
            shells: Shells::default(),
            places,
            shadows: Shadows::Off,
            eps: 0.0,
        };
        unseen.found_by(shadows, eps)
    }

    /// These obstacles, whose shadows are found so, to the accuracy `eps`.
    #[must_use]
    pub fn found_by(self, shadows: Shadows, eps: f64) -> Self {
        let eps = if shadows == Shadows::Off { 0.0 } else { eps };
        let Self { obstacles, boxes, tree, rays, .. } = &self;
        let standing = standing(obstacles, &cloud_of(obstacles), boxes, eps);
        let standing_boxes: Vec<Aabb> = standing.iter().map(|index| boxes[*index]).collect();
        let standing_tree = Bvh::build(&standing_boxes);
        let shells = match shadows {
            Shadows::Off => Shells::default(),
            _ => Shells::of(obstacles, boxes, tree, |own| rays.other_side(own)),
        };
        Self { standing, standing_tree, shells, shadows, eps, ..self }
    }

    /// Candidate blockers between the hulls of the points `a` and `b`, ascending: without the two `surfaces`,
    /// and without faces of a convex body that one of them belongs to.
    pub fn candidates(&self, a: &[DVec3], b: &[DVec3], surfaces: [usize; 2]) -> Vec<usize> {
        self.some_candidates(a, b, surfaces, usize::MAX)
    }

    /// [`Visibility::candidates`], so many of them at the most.
    pub fn some_candidates(&self, a: &[DVec3], b: &[DVec3], surfaces: [usize; 2], most: usize) -> Vec<usize> {
        let found = self.standing_between(a, b, surfaces);
        // What a surface encloses is looked for once it reaches between the two.
        let holds_both = |index: &usize| surfaces.iter().all(|surface| self.encloses(*index, *surface));
        // What sees the outside of a convex solid sees it past nothing that lies within; where it passes
        // through, rays find the corners that stick out.
        let is_within = |index: &usize| {
            let [first, second] = surfaces;
            [[first, second], [second, first]].into_iter().any(|[own, other]| {
                let Obstacle { bend, .. } = &self.obstacles[own];
                *bend == Bend::Outward
                    && self.encloses(own, *index)
                    && !self.obstacles[own].is_entered_by(&self.obstacles[other])
            })
        };
        let may_hide = |index: &usize| !holds_both(index) && !is_within(index);
        let reaching = self.reaching_between(&found, |index| self.own_hull(index), [a, b]);
        reaching.filter(may_hide).take(most).collect()
    }

    /// Whether a surface certainly hides nothing of two others from each other: it lies in a convex solid
    /// that one of them is the outside of, or behind the plane that one lies in, or they are one outside,
    /// which sees nothing of itself.
    pub fn hides_nothing(&self, blocker: usize, surfaces: [usize; 2]) -> bool {
        surfaces.iter().any(|surface| {
            let own = &self.obstacles[*surface];
            let is_outside = own.bend == Bend::Outward && own.is_bent();
            let is_behind = |plane: Plane| self.obstacles[blocker].lies_behind(plane);
            is_outside && (surfaces[0] == surfaces[1] || self.encloses(*surface, blocker))
                || own.plane().is_some_and(is_behind)
        })
    }

    /// As [`Visibility::candidates`] between a part of `surface`, in the hull `a`, and points that lie on no
    /// surface.
    pub fn candidates_before_points(&self, a: &[DVec3], points: &[DVec3], surface: usize) -> Vec<usize> {
        let mut found = self.narrow(&self.standing_between(a, points, [surface; 2]), a, points);
        found.retain(|index| !(self.encloses(*index, surface) && self.contains(*index, points)));
        found
    }

    /// The surfaces that reach into the box around two hulls and can stand between others, ascending: without
    /// the two `surfaces` and their bodies.
    fn standing_between(&self, a: &[DVec3], b: &[DVec3], surfaces: [usize; 2]) -> Vec<usize> {
        check_interrupt();
        let mut found = Vec::new();
        if self.shadows == Shadows::Off || self.standing.is_empty() {
            return found;
        }
        let bounds = a.iter().chain(b).fold(Aabb::EMPTY, |bounds, point| bounds.grow(*point));
        self.standing_tree.overlapping(&bounds, |place| {
            let index = self.standing[place];
            if !surfaces.iter().any(|surface| *surface == index || self.are_of_one_body(index, *surface)) {
                found.push(index);
            }
        });
        found.sort_unstable();
        found
    }

    /// Whether a surface lies on the boundary of a convex solid within which another one lies: it hides
    /// nothing between places within.
    pub fn encloses(&self, surface: usize, other: usize) -> bool {
        let own = &self.obstacles[surface];
        let all =
            || (0..self.obstacles.len()).filter(|index| own.encloses(&self.obstacles[*index])).collect();
        // All are looked for once it may hold one that is asked for: most hold none of these.
        own.pieces.is_none()
            && (own.enclosed.get().is_some() || own.may_enclose(&self.obstacles[other]))
            && own.enclosed.get_or_init(all).binary_search(&other).is_ok()
    }

    /// Whether a surface lies on the boundary of a convex solid that points belong to.
    pub fn contains(&self, surface: usize, points: &[DVec3]) -> bool {
        self.obstacles[surface].contains(points)
    }

    /// Whether a whole ball hides two places from each other.
    pub fn are_parted(&self, a: &Place, b: &Place) -> bool {
        self.shells.part(a, b, &self.obstacles)
    }

    /// Whether a whole ball hides a surface from both of two places.
    pub fn is_shut_away(&self, surface: usize, from: [&Place; 2]) -> bool {
        self.shells.hide(surface, from, &self.obstacles)
    }

    /// `surfaces` sorted by their coordinates, so that the order does not depend on the scene's list.
    pub fn by_place(&self, surfaces: &[usize]) -> Vec<usize> {
        let mut sorted = surfaces.to_vec();
        sorted.sort_by_key(|surface| self.places[*surface]);
        sorted
    }

    /// Which of the two surfaces may themselves hide a part of the first, in the hull `a`, from a part of the
    /// second, in `b`: surfaces that bend both ways, and the inside of a bowl if the other patch reaches out
    /// of the bowl.
    pub fn hiding_themselves(&self, surfaces: [usize; 2], [a, b]: [&[DVec3]; 2]) -> Vec<usize> {
        if self.shadows == Shadows::Off {
            return Vec::new();
        }
        let [first, second] = surfaces;
        let may_hide = |surface: usize, other: usize, others: &[DVec3]| {
            let Obstacle { bend, looks, ball, .. } = &self.obstacles[surface];
            let is_outside =
                |y: &DVec3| looks.iter().any(|look| look.height(*y) < -COINCIDENT * ball.radius());
            match bend {
                Bend::Outward => false,
                Bend::Inward => {
                    first != second && others.iter().any(is_outside) && !self.encloses(surface, other)
                }
                Bend::Mixed => true,
            }
        };
        let mut found: Vec<usize> = Vec::new();
        found.extend(may_hide(first, second, b).then_some(first));
        found.extend((second != first && may_hide(second, first, a)).then_some(second));
        found.sort_unstable();
        found
    }

    /// The `blockers` that may stand between the hulls of `a` and `b`.
    pub fn narrow(&self, blockers: &[usize], a: &[DVec3], b: &[DVec3]) -> Vec<usize> {
        self.reaching_between(blockers, |index| self.own_hull(index), [a, b]).collect()
    }

    /// The bounds of a surface alone.
    fn own_hull(&self, surface: usize) -> Hull<'_> {
        let Obstacle { ball, hull, .. } = &self.obstacles[surface];
        Hull { ball, points: hull }
    }

    /// The `blockers` whose `part` reaches between two hulls, one after the other; none without
    /// shadows.
    fn reaching_between<'a>(
        &'a self,
        blockers: &'a [usize],
        part: impl Fn(usize) -> Hull<'a> + 'a,
        [a, b]: [&'a [DVec3]; 2],
    ) -> impl Iterator<Item = usize> + 'a {
        let blockers = if self.shadows == Shadows::Off { &[] } else { blockers };
        let size = breadth(a).min(breadth(b));
        let (around_a, around_b) = (Ball::around(a), Ball::around(b));
        let reaches = move |index: &usize| {
            let Hull { ball, points } = part(*index);
            // What is flat and lies flush before a surface reaches into the shaft by little, but hides much.
            let slimness = if self.frusta[*index].is_some() { 0.0 } else { self.obstacles[*index].slimness };
            let tolerance = (self.eps * slimness).max(COINCIDENT);
            !ball.misses_between(&around_a, &around_b) && !separated(a, b, points, tolerance * size)
        };
        blockers.iter().copied().filter(reaches)
    }

    /// Whether a single one of `blockers` hides the hulls of `a` and `b` wholly from each other.
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
        !blockers.iter().any(|index| {
            let Obstacle { ball, shape, .. } = &self.obstacles[*index];
            !ball.misses(x, y) && shape.occludes(&ray)
        })
    }

    /// As [`Visibility::free`], where the ends lie on the two surfaces `own`, which may be blockers too.
    pub fn free_between(&self, own: [usize; 2], blockers: &[usize], x: DVec3, y: DVec3) -> bool {
        !blockers.iter().any(|index| {
            let margin = if own.contains(index) { OWN_END } else { END };
            self.blocks(*index, x, y, margin)
        })
    }

    /// The surfaces that reach into the box `bounds` and may stand between points of two surfaces, ascending;
    /// with `open` also those that may stand before a point anywhere. A convex body's first face represents
    /// it, and of the two sides of a curved sheet the first. Empty without shadows.
    pub fn reaching_into(&self, bounds: &Aabb, open: bool) -> Vec<usize> {
        self.reaching(open, |other| other.overlaps(bounds))
    }

    /// As [`Visibility::reaching_into`], but those that may stand between a point `x` and what lies in the box
    /// `bounds`, and some others.
    pub fn reaching_before(&self, x: DVec3, bounds: &Aabb, open: bool) -> Vec<usize> {
        let around = bounds.grow(x);
        let ball = Ball::over(bounds);
        self.reaching(open, |other| {
            other.overlaps(&around) && !Ball::over(other).misses_cone(x, ball.center(), ball.radius())
        })
    }

    /// The surfaces whose boxes `may_hold` something, and some others, as of [`Visibility::reaching_into`].
    /// What a box fails has to be failed by every box inside it.
    fn reaching(&self, open: bool, may_hold: impl Fn(&Aabb) -> bool) -> Vec<usize> {
        let mut found = Vec::new();
        match (self.shadows, open) {
            (Shadows::Off, _) => {}
            (_, true) => found.extend(self.tree.search(may_hold)),
            (_, false) => found.extend(self.standing_tree.search(may_hold).map(|place| self.standing[place])),
        }
        found.iter_mut().for_each(|surface| *surface = self.sheet(self.faces(surface)[0]));
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The surfaces whose boxes overlap `bounds`, ascending.
    pub fn near(&self, bounds: &Aabb) -> Vec<usize> {
        self.tree.near(bounds)
    }

    /// Bounding box of all surfaces.
    pub fn bounds(&self) -> Aabb {
        self.boxes.iter().fold(Aabb::EMPTY, |bounds, other| bounds.union(*other))
    }

    /// The obstacle that stands for a surface: of the two sides of a curved sheet the first, as both hide the
    /// same; otherwise the surface itself.
    pub fn sheet(&self, surface: usize) -> usize {
        let is_curved = self.obstacles[surface].pieces.is_none();
        if is_curved { surface.min(self.rays.other_side(surface)) } else { surface }
    }

    /// Whether one place of a surface may hide another one from some point. False if the surface lies behind
    /// all its tangent planes, like the outside of a ball, or if its normals are nearly parallel.
    pub fn hides_itself(&self, surface: usize) -> bool {
        self.obstacles[surface].bend != Bend::Outward
    }

    /// Whether the points of a surface all see each other: it lies in front of all its tangent planes.
    pub fn is_hollow(&self, surface: usize) -> bool {
        self.obstacles[surface].bend == Bend::Inward
    }

    /// Whether `surface` meets the segment from `x` to `y`, without the part `margin` of its length at either
    /// end.
    pub fn blocks(&self, surface: usize, x: DVec3, y: DVec3, margin: f64) -> bool {
        let Obstacle { ball, shape, .. } = &self.obstacles[surface];
        let ray = Ray { origin: x, direction: y - x, range: [margin, 1.0 - margin] };
        !ball.misses(x, y) && shape.occludes(&ray)
    }

    /// Centre and radius of a surface, if it is a whole ball.
    pub fn ball(&self, surface: usize) -> Option<(DVec3, f64)> {
        self.obstacles[surface].shape.ball()
    }

    /// The segment that sweeps a surface as it turns all the way round an axis, if one does.
    pub fn meridian(&self, surface: usize) -> Option<Meridian> {
        self.obstacles[surface].shape.meridian()
    }

    /// Centre and radius of the single blocker, if it is a whole ball.
    pub fn only_ball(&self, blockers: &[usize]) -> Option<(DVec3, f64)> {
        if let [only] = blockers { self.ball(*only) } else { None }
    }

    /// The solid that a surface closes, if it lies between two coaxial circles.
    pub fn frustum(&self, surface: usize) -> Option<&Frustum> {
        self.frusta[surface].as_ref()
    }

    /// Whether shadows of `blockers` are computed from outlines: all are planar, whole balls or close solids
    /// between two coaxial circles, and the mode allows it.
    pub fn has_outlines(&self, blockers: &[usize]) -> bool {
        let has_outline = |index: &usize| {
            let Obstacle { pieces, shape, .. } = &self.obstacles[*index];
            pieces.is_some() || shape.ball().is_some() || self.frusta[*index].is_some()
        };
        matches!(self.shadows, Shadows::Auto | Shadows::Exact) && blockers.iter().all(has_outline)
    }

    /// Whether surfaces hide each other at all.
    pub fn casts(&self) -> bool {
        self.shadows != Shadows::Off
    }

    /// Whether all of these surfaces are planar.
    pub fn are_planar(&self, surfaces: &[usize]) -> bool {
        surfaces.iter().all(|index| self.obstacles[*index].pieces.is_some())
    }

    /// Centre and radius of the ball whose whole inside the surface is, if it is one.
    pub fn whole_dome(&self, surface: usize) -> Option<(DVec3, f64)> {
        if self.is_hollow(surface) { self.obstacles[surface].shape.ball() } else { None }
    }

    /// Convex polygons that make up a planar surface; None for curved ones.
    pub fn pieces(&self, surface: usize) -> Option<&[Vec<DVec3>]> {
        self.obstacles[surface].pieces.as_deref()
    }

    /// Silhouette mesh of a surface, made when first needed.
    pub fn silhouette_mesh(&self, surface: usize) -> &SilhouetteMesh {
        let Obstacle { shape, mesh, .. } = &self.obstacles[surface];
        mesh.get_or_init(|| SilhouetteMesh::new(shape))
    }

    /// Another mesh of a surface, over each of whose quads it turns by about the angle `turn` (rad).
    pub fn mesh_turning(&self, surface: usize, turn: f64) -> SilhouetteMesh {
        SilhouetteMesh::turning(&self.obstacles[surface].shape, turn)
    }

    /// Whether any surface may stand between any two others.
    pub fn any_shadow(&self) -> bool {
        let n = self.obstacles.len();
        let pair = |i: usize, j: usize| (&self.obstacles[i].hull, &self.obstacles[j].hull);
        let is_shaded = |i: usize, j: usize| {
            let (a, b) = pair(i, j);
            !self.some_candidates(a, b, [i, j], 1).is_empty()
        };
        self.shadows != Shadows::Off
            && self.has_obstacles()
            && (0..n).any(|i| (0..i).any(|j| is_shaded(i, j)))
    }

    /// Whether some surface is bent and not hollow: its points may see something only partly above their
    /// horizon.
    pub fn any_horizon(&self) -> bool {
        self.obstacles.iter().any(|obstacle| obstacle.bend != Bend::Inward && obstacle.is_bent())
    }

    /// Whether a surface can stand between two others.
    pub fn stands(&self, surface: usize) -> bool {
        self.standing.binary_search(&surface).is_ok()
    }

    /// The surfaces that can stand between two others, ascending.
    pub fn standing(&self) -> impl Iterator<Item = usize> {
        self.standing.iter().copied()
    }

    /// Whether the planes of the surfaces allow any of them to stand between two others.
    pub fn has_obstacles(&self) -> bool {
        !self.standing.is_empty()
    }
}

/// The surfaces that can stand between two others, ascending.
///
/// A planar surface with the whole scene on one side of its plane, such as a wall of a convex room, cannot. Nor can a
/// curved wall on a convex solid within which the whole scene lies, such as that of a can, nor a slightly bent wall
/// behind which nothing lies, with a depth over its diagonal below `eps`, the accuracy of the shadows.
fn standing(obstacles: &[Obstacle], cloud: &Cloud, boxes: &[Aabb], eps: f64) -> Vec<usize> {
    let walls_in = |index: &usize| {
        let Obstacle { shape, hull, .. } = &obstacles[*index];
        let Jet { position, normal, .. } = shape.jet(0.0, 0.0);
        let size = boxes[*index].diagonal();
        let tangent = Plane { point: position, normal };
        let reversed = Plane { normal: -normal, ..tangent };
        let range = |(low, high): (f64, f64), h: f64| (low.min(h), high.max(h));
        let heights = hull.iter().map(|x| tangent.height(*x));
        let (low, high) = heights.fold((f64::MAX, f64::MIN), range);
        let depth = high - low;
        let is_planar = depth <= touching(size, 0.0);
        (is_planar || depth <= eps * size)
            && (cloud.lies_below(-low, &reversed, size) || cloud.lies_below(high, &tangent, size))
            && (is_planar || has_nothing_beside(*index, depth * normal, obstacles))
    };
    (0..obstacles.len())
        .filter(|index| !walls_in(index) && !obstacles[*index].encloses_all(obstacles))
        .collect()
}

/// Part of a slightly bent wall, about its middle, beside which nothing lies: other walls meet it at its border.
const AMID: f64 = 0.99;

/// Whether no other surface comes as near as `depth`, along the normal, to what is amid a slightly bent surface: a flat
/// cone on a floor is no wall.
fn has_nothing_beside(own: usize, depth: DVec3, obstacles: &[Obstacle]) -> bool {
    let Obstacle { hull, ball, .. } = &obstacles[own];
    let amid = |x: &DVec3| ball.center() + AMID * (*x - ball.center());
    let slab: Vec<DVec3> = hull.iter().map(amid).flat_map(|x| [x - depth, x + depth]).collect();
    let is_apart =
        |(index, other): (usize, &Obstacle)| index == own || separated(&slab, &slab, &other.hull, 0.0);
    obstacles.iter().enumerate().all(is_apart)
}

/// The points whose convex hull holds all obstacles.
fn cloud_of(obstacles: &[Obstacle]) -> Cloud {
    Cloud::new(obstacles.iter().flat_map(|obstacle| obstacle.hull.iter().copied()).collect())
}

/// The solids that curved surfaces close, where they lie between two coaxial circles.
fn frusta(obstacles: &[Obstacle], boxes: &[Aabb], tree: &Bvh) -> Vec<Option<Frustum>> {
    let meridians: Vec<Option<Meridian>> =
        obstacles.iter().map(|obstacle| obstacle.shape.meridian()).collect();
    let frustum = |own: usize| {
        let reach = boxes[own].inflate(COINCIDENT * boxes[own].diagonal());
        let near = tree.near(&reach).into_iter().filter(|other| *other != own);
        Frustum::of(meridians[own].as_ref()?, near.filter_map(|other| Some((other, meridians[other]?))))
    };
    (0..obstacles.len()).map(frustum).collect()
}

/// The convex bodies that surfaces close, and the surfaces as parts of screens.
fn bodies(obstacles: &[Obstacle], cloud: &Cloud) -> (Bodies, Screens) {
    let faces = obstacles.iter().enumerate().filter_map(|(surface, Obstacle { shape, hull, .. })| {
        let region = shape.region().filter(|region| region.holes().is_empty())?;
        Some(Face { surface, outline: &hull[..], normal: region.normal() })
    });
    let faces: Vec<Face> = faces.collect();
    let twins = twins(&faces);
    let bodies = Bodies::new(&faces, &twins, obstacles.len(), cloud);
    (bodies, Screens::new(&faces, &twins, obstacles.len()))
}

/// Largest distance of the points from the line through the first point and the one farthest from it.
fn breadth(points: &[DVec3]) -> f64 {
    let farther = |a: &&DVec3, b: &&DVec3| a.distance(points[0]).total_cmp(&b.distance(points[0]));
    let Some(far) = points.iter().max_by(farther) else { return 0.0 };
    let along = (far - points[0]).normalize_or_zero();
    points.iter().map(|x| (x - points[0]).cross(along).length()).fold(0.0, f64::max)
}

fn segment(x: DVec3, y: DVec3) -> Ray {
    Ray { origin: x, direction: y - x, range: [END, 1.0 - END] }
}

/// Rank of each obstacle by the coordinates of its hull.
fn places(obstacles: &[Obstacle]) -> Vec<usize> {
    let coordinates = |index: usize| obstacles[index].hull.iter().flat_map(|point| point.to_array());
    let mut sorted: Vec<usize> = (0..obstacles.len()).collect();
    sorted.sort_by(|a, b| {
        let mut orders = coordinates(*a).zip(coordinates(*b)).map(|(x, y)| x.total_cmp(&y));
        orders.find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    });
    let mut places = vec![0; obstacles.len()];
    sorted.into_iter().enumerate().for_each(|(place, index)| places[index] = place);
    places
}
