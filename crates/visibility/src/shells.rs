//! Shells: whole balls, which hide what lies within them from all that lies without.
//!
//! Two points on one side of a ball of the centre c and the radius R see each other past nothing that lies on the
//! other side but the ball itself; two points on either side of it do not see each other. A surface lies within
//! where its hull does, |y − c| < (1 − δ) R, or where it is the inside of the ball; it lies without where its box
//! does, |y − c| > (1 + δ) R, where its plane touches the ball, or where it is the outside. Of all other surfaces
//! nothing is said.

use radiosity_geom::{Aabb, Bvh, COINCIDENT, DVec3};
use smallvec::SmallVec;

use crate::obstacle::{Bend, Obstacle};

/// The distance δ from a ball, over its radius, within which no side is said. Chosen: a thousandfold of what ends of
/// rays keep from surfaces.
const NEAR: f64 = 1e-6;

/// The whole balls with something within.
#[derive(Debug, Default)]
pub(super) struct Shells {
    shells: Vec<Shell>,
    /// For each surface the shells that it lies within; empty without shells.
    around: Vec<SmallVec<[usize; 1]>>,
}

/// A whole ball, with its two sides if both are surfaces.
#[derive(Debug)]
struct Shell {
    center: DVec3,
    radius: f64,
    sides: [usize; 2],
}

/// A place of which shells are asked.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// Points whose convex hull contains it.
    pub points: &'a [DVec3],
    /// The surface that it lies on, if any.
    pub surface: Option<usize>,
}

impl Shells {
    /// The shells among `obstacles`, whose boxes are `boxes`; `other_side` has the other side of each.
    pub(super) fn of(
        obstacles: &[Obstacle],
        boxes: &[Aabb],
        tree: &Bvh,
        other_side: impl Fn(usize) -> usize,
    ) -> Self {
        let mut own = Self::default();
        for (index, obstacle) in obstacles.iter().enumerate() {
            let Some((center, radius)) = obstacle.shape.ball().filter(|_| index <= other_side(index)) else {
                continue;
            };
            let shell = Shell { center, radius, sides: [index, other_side(index)] };
            let inner = shell.sides.into_iter().filter(|side| obstacles[*side].bend == Bend::Inward);
            let mut within: Vec<usize> = inner.collect();
            let own_sides = within.len();
            tree.overlapping(&boxes[index], |other| {
                if !shell.sides.contains(&other) && shell.holds(&obstacles[other]) {
                    within.push(other);
                }
            });
            if within.len() > own_sides {
                own.around.resize(obstacles.len(), SmallVec::new());
                within.iter().for_each(|other| own.around[*other].push(own.shells.len()));
                own.shells.push(shell);
            }
        }
        own
    }

    /// Whether a shell stands between any two points of two places, of surfaces with these boxes.
    pub(super) fn part(&self, a: &Place, b: &Place, obstacles: &[Obstacle]) -> bool {
        let divides = |inner: &Place, outer: &Place| {
            self.around(inner).iter().any(|shell| self.shells[*shell].is_before(outer, obstacles))
        };
        !self.shells.is_empty() && (divides(a, b) || divides(b, a))
    }

    /// Whether a shell hides a surface from two places.
    pub(super) fn hide(&self, surface: usize, from: [&Place; 2], obstacles: &[Obstacle]) -> bool {
        let around = self.around.get(surface).into_iter().flatten();
        around
            .map(|shell| &self.shells[*shell])
            .any(|shell| from.iter().all(|a| shell.is_before(a, obstacles)))
    }

    /// The shells that a place lies within.
    fn around(&self, place: &Place) -> SmallVec<[usize; 1]> {
        match place.surface {
            Some(surface) => self.around[surface].clone(),
            None => {
                (0..self.shells.len()).filter(|shell| self.shells[*shell].contains(place.points)).collect()
            }
        }
    }
}

impl Shell {
    /// Whether all these points lie within.
    fn contains(&self, points: &[DVec3]) -> bool {
        points.iter().all(|y| y.distance(self.center) < (1.0 - NEAR) * self.radius)
    }

    /// Whether a surface lies within.
    fn holds(&self, other: &Obstacle) -> bool {
        match other.shape.ball() {
            Some((center, radius)) => center.distance(self.center) + radius < (1.0 - NEAR) * self.radius,
            None => self.contains(&other.hull),
        }
    }

    /// Whether a place lies without.
    fn is_before(&self, place: &Place, obstacles: &[Obstacle]) -> bool {
        let least = match place.surface.map(|surface| &obstacles[surface]) {
            Some(own) if self.sides.contains(&place.surface.unwrap_or(usize::MAX)) => {
                return own.bend == Bend::Outward;
            }
            Some(own) if own.pieces.is_some() => 1.0 - COINCIDENT,
            _ => 1.0 + NEAR,
        };
        let bounds = Aabb::around(place.points.iter().copied());
        bounds.distance_squared(self.center) >= (least * self.radius).powi(2)
    }
}
