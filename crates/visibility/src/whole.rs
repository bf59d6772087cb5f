//! Visibility tests of whole blockers: of surfaces, or of the convex bodies they belong to.

use radiosity_geom::{Aabb, DVec3, separated};
use smallvec::SmallVec;

use super::{Hull, Visibility};
use crate::blocker_edges::BlockerEdge;
use crate::blocker_shadow::BlockerShadow;
use crate::bounding_ball::Ball;
use crate::frustum::Frustum;
use crate::round_shadow::RoundShadow;
use crate::shadow_cone::ShadowCone;
use crate::shadow_volume::ShadowVolume;

impl Visibility {
    /// The `blockers`, one face per body, that may stand between the hulls of `a` and `b`, bodies as a whole.
    pub fn narrow_bodies(&self, blockers: &[usize], a: &[DVec3], b: &[DVec3]) -> Vec<usize> {
        let whole = |index: usize| Hull { ball: self.ball_of(index), points: self.hull(index) };
        self.reaching_between(blockers, whole, [a, b]).collect()
    }

    /// Bounding box of a surface, or of the convex body it belongs to.
    pub fn bounds_of(&self, surface: usize) -> Aabb {
        self.bodies.of(surface).map_or(self.boxes[surface], |body| body.bounds)
    }

    /// Points whose convex hull contains a surface, or the convex body it belongs to.
    pub fn hull(&self, surface: usize) -> &[DVec3] {
        self.bodies.of(surface).map_or(&self.obstacles[surface].hull, |body| &body.hull)
    }

    /// Whether a surface, or the convex body it belongs to, certainly misses the hull of the point `x` and a
    /// ball.
    pub fn is_apart(&self, surface: usize, x: DVec3, center: DVec3, radius: f64) -> bool {
        self.ball_of(surface).misses_cone(x, center, radius)
    }

    /// Whether `blocker`, or its convex body, may reach between the hulls of `a` and `b`, by however little.
    pub fn reaches(&self, blocker: usize, a: &[DVec3], b: &[DVec3]) -> bool {
        !self.ball_of(blocker).misses_between(&Ball::around(a), &Ball::around(b))
            && !separated(a, b, self.hull(blocker), 0.0)
    }

    /// Ball around a surface, or around the convex body it belongs to.
    fn ball_of(&self, surface: usize) -> &Ball {
        self.bodies.of(surface).map_or(&self.obstacles[surface].ball, |body| &body.ball)
    }

    /// Whether two surfaces belong to one convex body; then neither hides anything from points on the other's
    /// front.
    pub fn are_of_one_body(&self, a: usize, b: usize) -> bool {
        self.bodies.place(a).is_some_and(|body| self.bodies.place(b) == Some(body))
    }

    /// The faces of the convex body that a surface belongs to, ascending; the surface alone if there is none.
    pub fn faces<'a>(&'a self, surface: &'a usize) -> &'a [usize] {
        self.bodies.of(*surface).map_or(std::slice::from_ref(surface), |body| &body.surfaces)
    }

    /// Adds the shadow volumes from `x` of a planar surface to `volumes`: that of its convex body, if it has
    /// one and x lies outside, else one for each convex piece for which `standing` holds.
    pub fn add_volumes(
        &self,
        surface: usize,
        x: DVec3,
        standing: impl Fn(&[DVec3]) -> bool,
        volumes: &mut impl Extend<ShadowVolume>,
    ) {
        if let Some(whole) = self.bodies.of(surface).and_then(|body| body.volume(x)) {
            return volumes.extend(Some(whole));
        }
        let pieces = self.faces(&surface).iter().filter_map(|face| self.pieces(*face)).flatten();
        for piece in pieces.filter(|piece| standing(piece)) {
            volumes.extend(ShadowVolume::over(piece, x));
        }
    }

    /// The `surfaces` with only the first face of each body and the first side of each sheet, and without those
    /// within a ball or a can among them, whose shadows that of the ball covers.
    pub fn one_of_each_body(&self, surfaces: &[usize]) -> Vec<usize> {
        let is_first = |(place, surface): &(usize, &usize)| {
            !surfaces[..*place].iter().any(|other| {
                self.are_of_one_body(*other, **surface) || self.sheet(*other) == self.sheet(**surface)
            })
        };
        let is_covered = |(place, surface): &(usize, &usize)| {
            let covers = |(at, other): (usize, &usize)| {
                at != *place
                    && self.covers(*other, **surface)
                    && !(self.covers(**surface, *other) && at > *place)
            };
            surfaces.iter().enumerate().any(covers)
        };
        let all = surfaces.iter().enumerate().filter(is_first);
        all.filter(|own| !is_covered(own)).map(|(_, surface)| *surface).collect()
    }

    /// Whether a surface, with all of its convex body, lies within a ball or between the ends of a can or a cone.
    /// The wall of a can lies on a solid that goes on beyond these.
    fn covers(&self, round: usize, surface: usize) -> bool {
        let lids = self.frustum(round).map(Frustum::lids);
        let is_between_ends = |face: &usize| {
            lids.is_some_and(|lids| lids.into_iter().all(|lid| self.obstacles[*face].lies_behind(lid)))
        };
        let is_ball = self.ball(round).is_some();
        let mut faces = self.faces(&surface).iter();
        faces.all(|face| (is_ball || is_between_ends(face)) && self.encloses(round, *face))
    }

    /// Shadows from `x` of planar `surfaces` and balls, one per body, that may hide a part of `ball`; those of
    /// balls with so many `corners` on a full turn.
    pub fn shadows(&self, surfaces: &[usize], x: DVec3, ball: &Ball, corners: usize) -> Vec<BlockerShadow> {
        let mut shadows = Vec::with_capacity(surfaces.len());
        let stands = |piece: &[DVec3]| !ball.is_beside(piece, x);
        let mut volumes: SmallVec<[ShadowVolume; 8]> = SmallVec::new();
        for surface in surfaces {
            if let Some((center, radius)) = self.ball(*surface) {
                shadows.extend(ShadowCone::over(center, radius, x, corners).map(BlockerShadow::Cone));
                continue;
            }
            self.add_volumes(*surface, x, stands, &mut volumes);
            shadows.extend(volumes.drain(..).map(BlockerShadow::Pyramid));
        }
        shadows
    }

    /// The shadow of a round surface from `x`; None where it hides nothing.
    pub fn round_shadow(&self, surface: usize, x: DVec3) -> Option<RoundShadow<'_>> {
        match self.ball(surface) {
            Some((center, radius)) => ShadowCone::over(center, radius, x, 0).map(RoundShadow::of_ball),
            None => RoundShadow::of_frustum(self.frustum(surface)?, x),
        }
    }

    /// The edges of a planar surface, or of the convex body it belongs to; of round ones those that stand for
    /// their outlines.
    pub fn blocker_edges(&self, surface: usize) -> Vec<BlockerEdge> {
        if let Some((center, radius)) = self.ball(surface) {
            return BlockerEdge::about_ball(center, radius).collect();
        }
        if let Some(frustum) = self.frustum(surface) {
            return frustum.edges();
        }
        match self.bodies.of(surface) {
            Some(body) => body.blocker_edges().collect(),
            None => self
                .pieces(surface)
                .into_iter()
                .flatten()
                .flat_map(|piece| BlockerEdge::all_of(piece))
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::*;
    use crate::Shadows;

    /// A leaning can hides as much as its lid; of tiles, balls and cans beyond its ends it hides nothing.
    #[test]
    fn walls_cover_their_lids_and_nothing_beyond_their_ends() {
        let shapes = [
            "cylinder = { base = [0, 0, 0], axis = [0.3, 0, 0.4], radius = 0.3 }",
            "disk = { center = [0.3, 0, 0.4], normal = [0.3, 0, 0.4], radius = 0.3 }",
            "disk = { center = [0, 0, 0], normal = [-0.3, 0, -0.4], radius = 0.3 }",
            "parallelogram = { origin = [0.05, -0.1, 0.2], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0] }",
            "parallelogram = { origin = [0.3, 0, 0.42], edge1 = [0.02, 0, 0], edge2 = [0, 0.02, 0] }",
            "sphere = { center = [0.6, 0, 0.8], radius = 0.2 }",
            "cylinder = { base = [0.33, 0, 0.44], axis = [0.3, 0, 0.4], radius = 0.2 }",
            "disk = { center = [0.33, 0, 0.44], normal = [-0.3, 0, -0.4], radius = 0.2 }",
        ];
        let list = shapes.map(|shape| format!("[[surfaces]]\n{shape}\n")).concat();
        let scene = radiosity_language::read(&Source::new("cans.toml", &list)).expect("a scene");
        let visibility = Visibility::new(&scene, Shadows::Auto, 1e-3);
        let all: Vec<usize> = (0..shapes.len()).collect();
        assert_eq!(visibility.one_of_each_body(&all), [0, 4, 5, 6]);
        let reversed: Vec<usize> = all.into_iter().rev().collect();
        assert_eq!(visibility.one_of_each_body(&reversed), [6, 5, 4, 0]);
    }
}
