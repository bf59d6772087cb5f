//! Blockers as a whole: surfaces, or the convex bodies that they are faces of.

use radiosity_geom::{Aabb, DVec3, separated};

use super::Visibility;
use crate::visibility::blocker_edges::Rim;
use crate::visibility::bounding_ball::Ball;
use crate::visibility::shadow_volume::Pyramid;

impl Visibility {
    /// Those of `blockers`, one face of each body, that may still stand between the hulls of `a` and `b`, bodies as a whole.
    pub fn narrow_bodies(&self, blockers: &[usize], a: &[DVec3], b: &[DVec3]) -> Vec<usize> {
        self.reaching_between(blockers, |index| (self.ball_of(index), self.hull(index)), a, b)
    }

    /// Bounding box of a surface, or of the convex body that it is a face of.
    pub fn bounds_of(&self, surface: usize) -> Aabb {
        self.bodies.of(surface).map_or(self.boxes[surface], |body| body.bounds)
    }

    /// Points whose convex hull contains a surface, or the convex body that it is a face of.
    pub fn hull(&self, surface: usize) -> &[DVec3] {
        self.bodies.of(surface).map_or(&self.obstacles[surface].hull, |body| &body.hull)
    }

    /// Whether a surface, or the convex body that it is a face of, is certainly apart from the convex hull of a point and a ball.
    pub fn is_apart(&self, surface: usize, x: DVec3, center: DVec3, radius: f64) -> bool {
        self.ball_of(surface).misses_cone(x, center, radius)
    }

    /// Whether `blocker`, or the convex body that it is a face of, may reach, however little, between the hulls of `a` and `b`.
    pub fn reaches(&self, blocker: usize, a: &[DVec3], b: &[DVec3]) -> bool {
        !self.ball_of(blocker).misses_between(&Ball::around(a), &Ball::around(b))
            && !separated(a, b, self.hull(blocker), 0.0)
    }

    /// A ball around a surface, or around the convex body that it is a face of.
    fn ball_of(&self, surface: usize) -> &Ball {
        self.bodies.of(surface).map_or(&self.obstacles[surface].ball, |body| &body.ball)
    }

    /// Whether two surfaces are faces of one convex body: neither then hides anything from a point of the other's front.
    pub fn are_of_one_body(&self, a: usize, b: usize) -> bool {
        self.bodies.place(a).is_some_and(|body| self.bodies.place(b) == Some(body))
    }

    /// The faces of the convex body that a surface is a face of, ascending; itself alone where there is none.
    pub fn faces<'a>(&'a self, surface: &'a usize) -> &'a [usize] {
        self.bodies.of(*surface).map_or(std::slice::from_ref(surface), |body| &body.surfaces)
    }

    /// Adds to `pyramids` what a planar surface hides from `x`, or the convex body that it is a face of: a body as a whole, else,
    /// and from inside it, each convex piece that is `standing`.
    pub fn add_pyramids(
        &self,
        surface: usize,
        x: DVec3,
        standing: impl Fn(&[DVec3]) -> bool,
        pyramids: &mut impl Extend<Pyramid>,
    ) {
        if let Some(whole) = self.bodies.of(surface).and_then(|body| body.pyramid(x)) {
            return pyramids.extend(Some(whole));
        }
        let pieces = self.faces(&surface).iter().filter_map(|face| self.pieces(*face)).flatten();
        pyramids.extend(pieces.filter(|piece| standing(piece)).filter_map(|piece| Pyramid::over(piece, x)));
    }

    /// Those of `surfaces` that are no faces of bodies, and one face of each body.
    pub fn one_of_each_body(&self, surfaces: &[usize]) -> Vec<usize> {
        let is_first = |(place, surface): &(usize, &usize)| {
            !surfaces[..*place].iter().any(|other| self.are_of_one_body(*other, **surface))
        };
        surfaces.iter().enumerate().filter(is_first).map(|(_, surface)| *surface).collect()
    }

    /// What planar `surfaces`, one of each body, hide from `x` of things within `ball`, bodies as a whole.
    pub fn pyramids(&self, surfaces: &[usize], x: DVec3, ball: &Ball) -> Vec<Pyramid> {
        let mut pyramids = Vec::with_capacity(surfaces.len());
        let stands = |piece: &[DVec3]| !ball.is_beside(piece, x);
        surfaces.iter().for_each(|surface| self.add_pyramids(*surface, x, stands, &mut pyramids));
        pyramids
    }

    /// The edges of a planar surface; where it is a face of a body, those of the whole body.
    pub fn rims(&self, surface: usize) -> Vec<Rim> {
        match self.bodies.of(surface) {
            Some(body) => body.rims().collect(),
            None => self.pieces(surface).into_iter().flatten().flat_map(|piece| Rim::all_of(piece)).collect(),
        }
    }
}
