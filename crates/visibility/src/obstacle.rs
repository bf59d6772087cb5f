//! A surface as an obstacle, and how it bends relative to its tangent planes.

use std::sync::{Arc, OnceLock};

use radiosity_geom::{COINCIDENT, ConvexSolid, DVec3, Jet, Meridian, Plane, ROUNDING, Rect, Surface};

use crate::bounding_ball::Ball;
use crate::silhouette_mesh::SilhouetteMesh;
use crate::within::lies_within;

/// Sample points along each parameter of a curved surface, by which it is seen how it bends. All pairs of
/// them are compared, so that the time grows with their fourth power; a bend between two of them may be
/// missed.
const LOOKS: usize = 5;

/// A surface whose normals all have at least this cosine (0.8°) to each other counts as flat: it rises over
/// its own tangent planes by 0.7 % of its size at the most. With a smaller value shadows that bent surfaces
/// throw on themselves are lost; with a larger one more surfaces need a mesh.
const ALIKE: f64 = 0.9999;

/// Part of a surface's size by which a point may lie beyond its sampled tangent planes so that its solid is
/// asked: more than what touches, as that is weighted by the area element. With a larger value more solids
/// are made for nothing.
const ROUGHLY: f64 = 1e-3;

/// A surface with its data for visibility tests.
#[derive(Debug)]
pub(super) struct Obstacle {
    pub(super) shape: Arc<dyn Surface>,
    pub(super) hull: Vec<DVec3>,
    /// Ball around the hull.
    pub(super) ball: Ball,
    /// Convex pieces of a planar obstacle; a single piece can hide a whole pair.
    pub(super) pieces: Option<Vec<Vec<DVec3>>>,
    /// The convex solid on whose boundary it lies, if it is known; made when first needed.
    solid: OnceLock<Option<ConvexSolid>>,
    /// The surfaces within that solid, ascending; found when first needed.
    pub(super) enclosed: OnceLock<Vec<usize>>,
    /// Thickness along the thinnest of its normals, over its size: 0 of what is flat.
    pub(super) slimness: f64,
    /// Position relative to its own tangent planes.
    pub(super) bend: Bend,
    /// Tangent planes at sampled points of a curved obstacle.
    pub(super) looks: Vec<Plane>,
    /// Silhouette mesh, made when first needed.
    pub(super) mesh: OnceLock<SilhouetteMesh>,
}

impl Obstacle {
    pub(super) fn new(shape: &Arc<dyn Surface>) -> Self {
        let hull = shape.region().map_or_else(|| shape.hull(&Rect::FULL), |region| region.outer().to_vec());
        let pieces = shape.region().map(|region| region.convex_pieces().to_vec());
        let jets = if pieces.is_some() { Vec::new() } else { looks(shape.as_ref()) };
        let bend = Bend::of(&jets);
        let looks: Vec<Plane> =
            jets.iter().map(|jet| Plane { point: jet.position, normal: jet.normal }).collect();
        let (shape, ball) = (Arc::clone(shape), Ball::around(&hull));
        let thicknesses = looks.iter().map(|look| thickness(&hull, look));
        let thinnest = thicknesses.reduce(f64::min).unwrap_or(0.0);
        let slimness = (thinnest / (2.0 * ball.radius())).min(1.0);
        let (solid, enclosed, mesh) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self { shape, ball, hull, pieces, solid, enclosed, slimness, bend, looks, mesh }
    }

    /// Whether it lies on the boundary of a convex solid within which the other one lies. It lies within its
    /// own where it does not bend both ways.
    pub(super) fn encloses(&self, other: &Self) -> bool {
        self.may_enclose(other) && self.solid().is_some_and(|solid| self.is_around(other, solid))
    }

    /// Whether it lies on the boundary of a convex solid within which all of a scene lies; only then its
    /// tangent planes are asked, if it has no solid of closed form, as that takes a thousand times as long.
    pub(super) fn encloses_all(&self, scene: &[Self]) -> bool {
        if !scene.iter().all(|other| self.may_enclose(other)) {
            return false;
        }
        let of_planes = || self.shape.tangent_planes().map(|planes| ConvexSolid::Patch(Box::new(planes)));
        let solid = self.shape.solid().or_else(of_planes);
        let encloses =
            solid.as_ref().is_some_and(|solid| scene.iter().all(|other| self.is_around(other, solid)));
        if encloses {
            self.solid.get_or_init(|| solid);
            self.enclosed.get_or_init(|| (0..scene.len()).collect());
        }
        encloses
    }

    fn is_around(&self, other: &Self, solid: &ConvexSolid) -> bool {
        match std::ptr::eq(self, other) {
            true => self.bend != Bend::Mixed,
            false => lies_within(&*other.shape, solid, self.touching()),
        }
    }

    /// Whether sampled points of another one suggest that it encloses it.
    pub(super) fn may_enclose(&self, other: &Self) -> bool {
        let of_curved = other.looks.iter().map(|look| look.point);
        let of_planar = other.pieces.iter().flat_map(|_| other.hull.iter().copied());
        self.may_contain(of_curved.chain(of_planar))
    }

    /// Whether it lies on the boundary of a convex solid that the points belong to.
    pub(super) fn contains(&self, points: &[DVec3]) -> bool {
        self.may_contain(points.iter().copied())
            && self.solid().is_some_and(|solid| points.iter().all(|x| solid.excess(*x) <= self.touching()))
    }

    /// Whether points lie on one side of the tangent planes at the sampled points, at least nearly.
    fn may_contain(&self, mut points: impl Iterator<Item = DVec3> + Clone) -> bool {
        let room = ROUGHLY * self.ball.radius();
        let heights = |point: DVec3| self.looks.iter().map(move |look| look.height(point));
        self.pieces.is_none()
            && (points.clone().all(|x| heights(x).all(|height| height >= -room))
                || points.all(|x| heights(x).all(|height| height <= room)))
    }

    fn solid(&self) -> Option<&ConvexSolid> {
        self.solid.get_or_init(|| self.shape.solid()).as_ref()
    }

    /// Whether some corner of another surface, its middle or a point by which its bends are told lies inside the
    /// solid.
    pub(super) fn is_entered_by(&self, other: &Self) -> bool {
        let corners: &[DVec3] = if other.pieces.is_some() { &other.hull } else { &[] };
        let points = corners.iter().copied().chain(other.looks.iter().map(|look| look.point));
        let mut points = points.chain([other.shape.jet(0.0, 0.0).position]);
        self.solid().is_some_and(|solid| points.any(|x| solid.excess(x) < -self.touching()))
    }

    /// Distance by which a point may lie outside its solid (length).
    fn touching(&self) -> f64 {
        COINCIDENT * self.ball.radius()
    }

    /// The plane in which it lies, facing one way.
    pub(super) fn plane(&self) -> Option<Plane> {
        let Jet { position: point, normal, .. } = self.shape.jet(0.0, 0.0);
        let plane = Plane { point, normal };
        let is_level = |look: &Plane| {
            look.normal.distance(normal) <= ROUNDING
                && plane.height(look.point).abs() <= ROUNDING * self.ball.radius()
        };
        self.looks.iter().all(is_level).then_some(plane)
    }

    /// Whether no point of it lies before a plane.
    pub(super) fn lies_behind(&self, plane: Plane) -> bool {
        let highest = match self.shape.meridian() {
            Some(Meridian { origin, axis, ends, .. }) => {
                let along = plane.normal.dot(axis);
                let across = plane.normal.cross(axis).length();
                plane.height(origin)
                    + ends.iter().map(|end| end.y * along + end.x * across).fold(f64::MIN, f64::max)
            }
            None => self.hull.iter().map(|corner| plane.height(*corner)).fold(f64::MIN, f64::max),
        };
        highest <= self.touching()
    }

    /// Whether it is one flat convex piece.
    pub(super) fn is_convex(&self) -> bool {
        self.pieces.as_ref().is_some_and(|pieces| pieces.len() == 1)
    }

    /// Whether its sampled normals differ noticeably.
    pub(super) fn is_bent(&self) -> bool {
        self.looks.iter().any(|look| look.normal.dot(self.looks[0].normal) < ALIKE)
    }
}

/// Largest difference of heights over a plane.
fn thickness(points: &[DVec3], plane: &Plane) -> f64 {
    let heights = || points.iter().map(|x| plane.height(*x));
    heights().fold(f64::MIN, f64::max) - heights().fold(f64::MAX, f64::min)
}

/// Jets at a grid of points of a surface.
fn looks(shape: &dyn Surface) -> Vec<Jet> {
    let at = |k: usize| 2.0 * k as f64 / (LOOKS - 1) as f64 - 1.0;
    (0..LOOKS * LOOKS).map(|k| shape.jet(at(k / LOOKS), at(k % LOOKS))).collect()
}

/// Position of a surface relative to the tangent planes of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// Behind all of them, or nearly flat: it hides nothing of itself.
    Outward,
    /// In front of all of them, like the inside of a ball: all its points see each other.
    Inward,
    /// Partly behind and partly in front of them.
    Mixed,
}

impl Bend {
    /// Classifies by sampled `jets`; a planar surface has none.
    fn of(jets: &[Jet]) -> Self {
        let size = jets.iter().map(|y| y.position.distance(jets[0].position)).fold(0.0, f64::max);
        let all = |holds: &dyn Fn(&Jet, &Jet) -> bool| jets.iter().all(|x| jets.iter().all(|y| holds(x, y)));
        let height = |x: &Jet, y: &Jet| (y.position - x.position).dot(x.normal);
        if all(&|x, y| height(x, y) <= COINCIDENT * size) || all(&|x, y| y.normal.dot(x.normal) >= ALIKE) {
            return Bend::Outward;
        }
        if all(&|x, y| height(x, y) >= -COINCIDENT * size) { Bend::Inward } else { Bend::Mixed }
    }
}
