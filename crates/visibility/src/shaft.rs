//! Shafts between flat surfaces, the convex hulls of both, and whether anything can stand in them.
//!
//! A shaft lies within the larger radius r of both ends of the segment between their centres. A box of the hierarchy
//! that the segment misses once it is grown by r is left out, with all that it holds (separating axes: S. Gottschalk,
//! M. C. Lin, D. Manocha, SIGGRAPH 1996, 171-180). A surface hides nothing that lies behind either end, that has both
//! ends on one side of its plane, or that a plane separates from both ([`radiosity_geom::separated`]).
//!
//! Of shafts from one surface to many beside each other it is looked up once for all what reaches into them.

use radiosity_geom::{Aabb, COINCIDENT, DVec3, Plane, separated};

use super::Visibility;
use crate::bounding_ball::Ball;

/// Most surfaces that are kept as what may stand before many others. Chosen: to look them up for each takes no longer.
const MOST_KEPT: usize = 200;

/// A flat surface at an end of a shaft.
#[derive(Clone, Copy, Debug)]
pub struct FlatEnd<'a> {
    /// Its number.
    pub surface: usize,
    /// Its plane.
    pub plane: Plane,
    /// Points whose convex hull contains it.
    pub hull: &'a [DVec3],
    /// The ball around these.
    pub ball: Ball,
}

impl FlatEnd<'_> {
    /// Length that counts as none.
    fn room(&self) -> f64 {
        COINCIDENT * self.ball.radius()
    }

    /// Whether no point lies before it.
    fn has_behind(&self, points: &[DVec3]) -> bool {
        points.iter().all(|x| self.plane.height(*x) <= self.room())
    }
}

/// Surfaces beside each other, at the ends of many shafts.
#[derive(Clone, Debug)]
pub struct Neighbours {
    /// The corners of the box around them.
    corners: [DVec3; 8],
    ball: Ball,
}

impl Neighbours {
    /// All that lies within a box.
    pub fn within(bounds: &Aabb) -> Self {
        Self { corners: bounds.corners(), ball: Ball::over(bounds) }
    }
}

/// Surfaces that may stand between one and its others; none where they are too many to be kept.
#[derive(Clone, Debug)]
pub struct Between(Option<Vec<Standing>>);

/// A surface that may stand between others.
#[derive(Clone, Copy, Debug)]
struct Standing {
    surface: usize,
    /// Its plane, if it is flat.
    plane: Option<Plane>,
    sides: Sides,
}

/// Sides of a plane on which all of some points lie.
#[derive(Clone, Copy, Debug)]
struct Sides {
    is_before: bool,
    is_behind: bool,
}

impl Sides {
    /// On which sides of a plane points lie; on none for no plane.
    fn of(points: &[DVec3], plane: Option<Plane>, room: f64) -> Self {
        let Some(plane) = plane else { return Self { is_before: false, is_behind: false } };
        let mut sides = Self { is_before: true, is_behind: true };
        for point in points {
            let height = plane.height(*point);
            sides.is_before &= height >= -room;
            sides.is_behind &= height <= room;
        }
        sides
    }

    /// Whether others lie on one side too.
    fn are_shared(self, other: Self) -> bool {
        self.is_before && other.is_before || self.is_behind && other.is_behind
    }
}

/// All that lies within a radius of a segment.
struct Capsule {
    middle: DVec3,
    /// Half of the way from one end to the other.
    half: DVec3,
    radius: f64,
}

impl Capsule {
    fn around(a: &Ball, b: &Ball) -> Self {
        let (middle, half) = (0.5 * (a.center() + b.center()), 0.5 * (b.center() - a.center()));
        Self { middle, half, radius: a.radius().max(b.radius()) }
    }

    /// Whether it certainly misses a box.
    #[inline]
    fn misses(&self, bounds: &Aabb) -> bool {
        let off = self.middle - 0.5 * (bounds.min + bounds.max);
        let size = 0.5 * (bounds.max - bounds.min) + self.radius;
        let along = self.half.abs();
        if (off.abs() - along).cmpgt(size).any() {
            return true;
        }
        let across = off.cross(self.half).abs();
        let reach = DVec3::new(
            size.y * along.z + size.z * along.y,
            size.x * along.z + size.z * along.x,
            size.x * along.y + size.y * along.x,
        );
        across.cmpgt(reach).any()
    }
}

impl Visibility {
    /// The surfaces that may stand between one and what lies among its `neighbours`.
    pub fn between(&self, end: FlatEnd<'_>, neighbours: &Neighbours) -> Between {
        let mut kept = Vec::new();
        for surface in self.standing_in(Capsule::around(&end.ball, &neighbours.ball)) {
            let standing = self.standing_beside(surface, &end);
            let others = Sides::of(&neighbours.corners, standing.plane, end.room());
            if end.has_behind(&self.obstacles[surface].hull) || standing.sides.are_shared(others) {
                continue;
            }
            if kept.len() == MOST_KEPT {
                return Between(None);
            }
            kept.push(standing);
        }
        Between(Some(kept))
    }

    /// Whether nothing can stand between two flat surfaces, of what may stand between the first one and neighbours of
    /// the other.
    pub fn is_clear(&self, ends: [FlatEnd<'_>; 2], between: &Between) -> bool {
        let [a, b] = &ends;
        match between {
            Between(Some(kept)) => kept.iter().all(|standing| !self.may_hide(standing, ends)),
            Between(None) => self
                .standing_in(Capsule::around(&a.ball, &b.ball))
                .all(|surface| !self.may_hide(&self.standing_beside(surface, a), ends)),
        }
    }

    /// The surfaces that can stand between others and whose boxes reach into a capsule.
    fn standing_in(&self, capsule: Capsule) -> impl Iterator<Item = usize> {
        self.standing_tree.search(move |bounds| !capsule.misses(bounds)).map(|place| self.standing[place])
    }

    /// A surface, with the sides of its plane on which an end lies.
    fn standing_beside(&self, surface: usize, end: &FlatEnd<'_>) -> Standing {
        let obstacle = &self.obstacles[surface];
        let region = obstacle.shape.region();
        let plane = region.map(|region| Plane { point: obstacle.hull[0], normal: region.normal() });
        Standing { surface, plane, sides: Sides::of(end.hull, plane, end.room()) }
    }

    /// Whether a surface may reach into the shaft between two ends, beside the first of which it stands.
    fn may_hide(&self, standing: &Standing, [a, b]: [FlatEnd<'_>; 2]) -> bool {
        if standing.sides.are_shared(Sides::of(b.hull, standing.plane, b.room())) {
            return false;
        }
        let is_own =
            |surface: usize| surface == standing.surface || self.are_of_one_body(standing.surface, surface);
        let obstacle = &self.obstacles[standing.surface];
        !is_own(a.surface)
            && !is_own(b.surface)
            && !a.has_behind(&obstacle.hull)
            && !b.has_behind(&obstacle.hull)
            && !obstacle.ball.misses_between(&a.ball, &b.ball)
            && !separated(a.hull, b.hull, &obstacle.hull, a.room().min(b.room()))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_scene::Source;

    use super::*;
    use crate::Shadows;

    /// Triangles in a scene, and each as an end of a shaft.
    fn clear_pairs(triangles: &[[DVec3; 3]]) -> (Visibility, Vec<[usize; 2]>) {
        let text = |[a, b, c]: &[DVec3; 3]| {
            format!("[[surfaces]]\ntriangle = {{ vertices = [{a:?}, {b:?}, {c:?}] }}\n").replace("DVec3", "")
        };
        let text: String = triangles.iter().map(text).collect::<String>().replace('(', "[").replace(')', "]");
        let scene = radiosity_language::read(&Source::new("triangles", &text)).expect("triangles");
        let visibility = Visibility::new(&scene, Shadows::Auto, 1e-3);
        let end = |surface: usize| {
            let hull = &triangles[surface];
            let normal = (hull[1] - hull[0]).cross(hull[2] - hull[0]).normalize();
            FlatEnd { surface, plane: Plane { point: hull[0], normal }, hull, ball: Ball::around(hull) }
        };
        let pairs = (0..triangles.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
        let all = Neighbours::within(&Aabb::around(triangles.iter().flatten().copied()));
        let is_clear = |[i, j]: &[usize; 2]| {
            let ends = [end(*i), end(*j)];
            let is_clear = visibility.is_clear(ends, &visibility.between(ends[0], &all));
            assert_eq!(is_clear, visibility.is_clear(ends, &Between(None)));
            is_clear
        };
        let clear = pairs.filter(is_clear).collect();
        (visibility, clear)
    }

    /// Triangles of this size at these places, and one across the middle of the way between the first two.
    fn triangles(points: &[[f64; 9]], size: f64) -> Vec<[DVec3; 3]> {
        let triangle = |p: &[f64; 9]| {
            let foot = DVec3::new(p[0], p[1], p[2]);
            [foot, foot + size * DVec3::new(p[3], p[4], p[5]), foot + size * DVec3::new(p[6], p[7], p[8])]
        };
        points
            .iter()
            .map(triangle)
            .filter(|[a, b, c]| (b - a).cross(c - a).length() > 0.01 * size * size)
            .collect()
    }

    proptest! {
        /// Between what is clear, no segment that leaves both at their fronts is stopped.
        #[test]
        fn segments_between_what_is_clear_are_free(
            points in prop::collection::vec(prop::array::uniform9(-1.0..1.0_f64), 4..20), size in 0.1..1.0_f64,
            weights in prop::collection::vec(prop::array::uniform4(0.01..0.99_f64), 20),
        ) {
            let triangles = triangles(&points, size);
            let (visibility, clear) = clear_pairs(&triangles);
            let place = |[a, b, c]: [DVec3; 3], [s, t]: [f64; 2]| a + s * (b - a) + s * t * (c - b);
            let before = |[a, b, c]: [DVec3; 3], x: DVec3| (b - a).cross(c - a).dot(x - a) > 1e-6;
            for pair in clear {
                let [one, two] = pair.map(|surface| triangles[surface]);
                for [s, t, u, v] in &weights {
                    let (x, y) = (place(one, [*s, *t]), place(two, [*u, *v]));
                    let is_seen = before(one, y) && before(two, x);
                    prop_assert!(!is_seen || visibility.is_free(Some(pair[0]), x, y), "{:?}", pair);
                }
            }
        }
    }

    /// Two plates that face each other, a bar beside them, and the bar between them.
    #[test]
    fn what_stands_beside_leaves_pairs_clear() {
        let corner = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let plates = [
            [corner(0.0, 0.0, 0.0), corner(1.0, 0.0, 0.0), corner(0.0, 1.0, 0.0)],
            [corner(0.0, 0.0, 1.0), corner(0.0, 1.0, 1.0), corner(1.0, 0.0, 1.0)],
        ];
        let bar = |x: f64| [corner(x, -1.0, 0.5), corner(x, 2.0, 0.5), corner(x + 1e-3, 2.0, 0.6)];
        let is_clear = |x: f64| clear_pairs(&[plates[0], plates[1], bar(x)]).1.contains(&[1, 0]);
        assert!(is_clear(-0.01) && !is_clear(0.01) && !is_clear(0.9) && is_clear(1.01));
    }
}
