//! The trait of all surfaces.
//!
//! A surface is a map X: [−1, 1]² → ℝ³ with tangents X_u, X_v. Its area element is |X_u × X_v| du dv and its
//! front the side that X_u × X_v points to. A shape has to give its jet, its bounds and its nearest ray hit;
//! everything else follows from these three, and a shape replaces what it knows in closed form.

use crate::tolerances::ROUNDING;
use crate::{Aabb, ConvexSolid, Hit, Meridian, PlanarRegion, Ray, Rect, ShapeError, TangentPlanes};
use glam::DVec3;
use radiosity_core::gauss::{Legendre, Rule};
use std::fmt::Debug;

/// Position, tangents, normal and area element of a surface at one parameter pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// The point X(u, v).
    pub position: DVec3,
    /// X_u, the derivative of the position by u ∈ [−1, 1].
    pub du: DVec3,
    /// X_v, the derivative of the position by v ∈ [−1, 1].
    pub dv: DVec3,
    /// Unit normal of the front; where the tangents do not span a plane, its limit.
    pub normal: DVec3,
    /// |X_u × X_v|, area per unit of du dv.
    pub area: f64,
}

impl Jet {
    /// The jet with front x_u × x_v; the tangents must span a plane.
    pub(crate) fn regular(position: DVec3, du: DVec3, dv: DVec3) -> Jet {
        let cross = du.cross(dv);
        let area = cross.length();
        Jet { position, du, dv, normal: cross / area, area }
    }
}

/// The nearest point of a surface to a given point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// First parameter of the nearest point, in [−1, 1].
    pub u: f64,
    /// Second parameter of the nearest point, in [−1, 1].
    pub v: f64,
    /// Distance between the nearest point and the given point (length).
    pub distance: f64,
}

/// A parametric surface over u, v ∈ [−1, 1]².
///
/// For a polygon ([`Surface::region`] is `Some`) the parameters are affine in the plane and [−1, 1]² is a
/// rectangle or parallelogram around the outline; only the region inside the outline and outside the holes
/// belongs to the surface. All other surfaces are the whole image of [−1, 1]².
pub trait Surface: Debug + Send + Sync {
    /// Position, tangents, normal and area element at u, v ∈ [−1, 1].
    fn jet(&self, u: f64, v: f64) -> Jet;

    /// A box that contains the image of `rect`, close enough around it to cull with.
    fn bounds(&self, rect: &Rect) -> Aabb;

    /// The hit of lowest t within the ray's range. Both sides are hit alike. Parameters up to 1 +
    /// [`Hit::SEAM`] count and are clamped; holes let the ray pass.
    fn intersect(&self, ray: &Ray) -> Option<Hit>;

    /// A few points whose convex hull contains the image of `rect`: the corners where that is exact, else
    /// those of the box.
    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        self.bounds(rect).corners().to_vec()
    }

    /// Centre and radius of the ball whose whole boundary the surface is, if it is one.
    fn ball(&self) -> Option<(DVec3, f64)> {
        None
    }

    /// The segment that sweeps the surface as it turns all the way round an axis, if one does; v runs along it.
    fn meridian(&self) -> Option<Meridian> {
        None
    }

    /// The convex solid on whose boundary the surface lies, where it is known.
    fn solid(&self) -> Option<ConvexSolid> {
        None
    }

    /// The tangent planes, where they are known all at once and make no [solid](Surface::solid) of closed
    /// form.
    fn tangent_planes(&self) -> Option<TangentPlanes> {
        None
    }

    /// Outline and holes, where the surface is a polygon in a plane.
    fn region(&self) -> Option<&PlanarRegion> {
        None
    }

    /// The corners of a surface that is given by them: the outline's, then each hole's. None of any other.
    fn corners(&self) -> Vec<DVec3> {
        Vec::new()
    }

    /// The surface with each of its [corners](Surface::corners) where `place` puts it; None if it has none.
    ///
    /// # Errors
    /// Errors of the surface's constructor: corners that coincide, or lie in no plane.
    fn with_corners(&self, _place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        None
    }

    /// Whether the ray meets the surface at all.
    fn occludes(&self, ray: &Ray) -> bool {
        self.intersect(ray).is_some()
    }

    /// Surface area, in squared units of length, to about 14 digits.
    fn area(&self) -> f64 {
        match self.region() {
            Some(region) => region.area(),
            None => refine_area(self, &Rect::FULL, gauss_area(self, &Rect::FULL), 0),
        }
    }

    /// The nearest point of the parameter domain's image: exact for points close to the surface, a local
    /// minimum of the distance for those far from a strongly curved one.
    fn project(&self, point: DVec3) -> Foot {
        nearest_foot(self, point)
    }

    /// Parameters of a `point` on the surface; `None` where it is farther off than 1e-9 of the surface's
    /// extent.
    fn invert(&self, point: DVec3) -> Option<[f64; 2]> {
        let foot = self.project(point);
        (foot.distance <= 1e-9 * self.bounds(&Rect::FULL).diagonal()).then_some([foot.u, foot.v])
    }
}

/// ∬ |X_u × X_v| over `rect` by the ten-point Gauss rule in each direction.
fn gauss_area<S: Surface + ?Sized>(surface: &S, rect: &Rect) -> f64 {
    let Rule { nodes, weights } = Legendre::<10>::RULE;
    let row = |s: f64| -> f64 {
        let value = |t: f64| {
            let [u, v] = rect.at(s, t);
            surface.jet(u, v).area
        };
        nodes.iter().zip(weights).map(|(t, w)| w * value(*t)).sum()
    };
    let [du, dv] = rect.half_extent();
    du * dv * nodes.iter().zip(weights).map(|(s, w)| w * row(*s)).sum::<f64>()
}

/// Splits `rect` until quartering changes its area, `whole` by one rule, by less than 2e-14, which
/// is some hundred roundings, or 8 times: the quarters are 1/256 as long then, and at a crease no number is
/// enough.
fn refine_area<S: Surface + ?Sized>(surface: &S, rect: &Rect, whole: f64, depth: usize) -> f64 {
    let quarters = rect.quarters();
    let parts = quarters.map(|quarter| gauss_area(surface, &quarter));
    let sum: f64 = parts.iter().sum();
    if (sum - whole).abs() <= 2e-14 * sum || depth == 8 {
        return sum;
    }
    quarters.iter().zip(parts).map(|(quarter, part)| refine_area(surface, quarter, part, depth + 1)).sum()
}

/// Starts of a search for the nearest point. A descent ends in the valley that it starts in; six nearest
/// seeds reach both sides of a seam and the surroundings of a pole. An arbitrary choice: fewer may end in the
/// wrong valley, more take time in proportion.
const DESCENTS: usize = 6;

/// Parameters to start descents from, nearest first: the nearest of the centres of 10 × 10 cells, which keep
/// off poles and seams.
fn seeds<S: Surface + ?Sized>(surface: &S, point: DVec3) -> Vec<(f64, [f64; 2])> {
    let middle = |k: usize| (k as f64 + 0.5) / 5.0 - 1.0;
    let grid = (0..100).map(|k| [middle(k % 10), middle(k / 10)]);
    let distance = |[u, v]: [f64; 2]| surface.jet(u, v).position.distance_squared(point);
    let mut seeds: Vec<(f64, [f64; 2])> = grid.map(|at| (distance(at), at)).collect();
    let nearer = |a: &(f64, [f64; 2]), b: &(f64, [f64; 2])| {
        let [(d, [u, v]), (e, [s, t])] = [*a, *b];
        d.total_cmp(&e).then(v.total_cmp(&t)).then(u.total_cmp(&s))
    };
    seeds.select_nth_unstable_by(DESCENTS, nearer);
    seeds.truncate(DESCENTS);
    seeds.sort_unstable_by(nearer);
    seeds
}

/// The best of a few descents: several, since near a pole the nearest seed may lie on the wrong side of the
/// seam.
pub(crate) fn nearest_foot<S: Surface + ?Sized>(surface: &S, point: DVec3) -> Foot {
    let near = ROUNDING * surface.bounds(&Rect::FULL).diagonal();
    let mut best = Foot { u: 0.0, v: 0.0, distance: f64::INFINITY };
    for (_, start) in seeds(surface, point) {
        let foot = descend(surface, point, start);
        if foot.distance < best.distance {
            best = foot;
        }
        if best.distance <= near {
            break;
        }
    }
    best
}

/// The foot of a point on the surface, by one descent from the middle of the parameters; None if that does
/// not find it.
pub(crate) fn foot_from_middle<S: Surface + ?Sized>(surface: &S, point: DVec3) -> Option<Foot> {
    let foot = descend(surface, point, [0.0; 2]);
    (foot.distance <= ROUNDING * surface.bounds(&Rect::FULL).diagonal()).then_some(foot)
}

/// Minimises |X(u, v) − point| from `start` by damped Gauss–Newton steps kept within the domain.
fn descend<S: Surface + ?Sized>(surface: &S, point: DVec3, start: [f64; 2]) -> Foot {
    let mut at = start;
    let mut jet = surface.jet(at[0], at[1]);
    let mut distance = jet.position.distance(point);
    let mut damping = 1e-6;
    for _ in 0..60 {
        let next = step(&jet, point, at, damping);
        let moved = (next[0] - at[0]).abs().max((next[1] - at[1]).abs());
        let next_jet = surface.jet(next[0], next[1]);
        let next_distance = next_jet.position.distance(point);
        if next_distance <= distance {
            (at, jet, distance) = (next, next_jet, next_distance);
            damping *= 0.01;
        } else {
            damping = (100.0 * damping).max(1e-12);
        }
        if moved < 1e-15 || damping > 1e12 {
            break;
        }
    }
    Foot { u: at[0], v: at[1], distance }
}

/// One Gauss–Newton step: the least-squares solution of X_u δu + X_v δv = point − X, first free, then along
/// whichever side of the domain it would leave.
fn step(jet: &Jet, point: DVec3, at: [f64; 2], damping: f64) -> [f64; 2] {
    let gap = point - jet.position;
    let (a, b, c) = (jet.du.length_squared(), jet.du.dot(jet.dv), jet.dv.length_squared());
    let ridge = damping * (a + c) + f64::MIN_POSITIVE;
    let (ar, cr) = (a + ridge, c + ridge);
    let (p, q) = (jet.du.dot(gap), jet.dv.dot(gap));
    let det = ar * cr - b * b;
    let free = [at[0] + (cr * p - b * q) / det, at[1] + (ar * q - b * p) / det];
    let u = free[0].clamp(-1.0, 1.0);
    let v = free[1].clamp(-1.0, 1.0);
    match (u == free[0], v == free[1]) {
        (true, false) => [(at[0] + (p - b * (v - at[1])) / ar).clamp(-1.0, 1.0), v],
        (false, true) => [u, (at[1] + (q - b * (u - at[0])) / cr).clamp(-1.0, 1.0)],
        _ => [u, v],
    }
}
