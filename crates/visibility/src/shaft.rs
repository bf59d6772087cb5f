//! Shafts between flat surfaces, the convex hulls of both, and whether anything can stand in them.
//!
//! A shaft lies within the larger radius r of both ends of the segment between their centres. A box of the hierarchy
//! that the segment misses once it is grown by r is left out, with all that it holds (separating axes: S. Gottschalk,
//! M. C. Lin, D. Manocha, SIGGRAPH 1996, 171-180). A surface hides nothing that lies behind either end, that has both
//! ends on one side of its plane, or that a plane separates from both ([`radiosity_geom::separated`]).
//!
//! Of surfaces beside each other it is looked up once for all what reaches into the shafts between them and others
//! beside each other, and of these what stands before each: shafts between hulls of several hold those between each
//! (shaft culling: E. Haines, J. Wallace, *Photorealistic Rendering in Computer Graphics*, 1994, 122-138). Where much
//! reaches into these, as in furnished rooms, that takes longer than it spares, and nothing is looked up for groups.

use radiosity_geom::{Aabb, COINCIDENT, DVec3, Plane, separated, separates, separating};
use smallvec::SmallVec;

use super::Visibility;
use crate::bounding_ball::Ball;
use crate::obstacle::Obstacle;

/// Most surfaces that may stand between two groups whose members are looked at, and most of those that boxes leave.
/// Chosen: looking takes as long as some segments between all members.
const FEW: usize = 64;
const FEW_BY_BOXES: usize = 512;

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

/// Flat surfaces beside each other, at the ends of many shafts.
#[derive(Clone, Debug)]
pub struct Neighbours {
    /// Their planes.
    planes: Vec<Plane>,
    /// Their corners, each once.
    corners: Vec<DVec3>,
    ball: Ball,
    /// Length that counts as none to each of them.
    room: f64,
}

impl Neighbours {
    /// These surfaces.
    pub fn of(ends: &[FlatEnd<'_>]) -> Self {
        let mut corners: Vec<DVec3> = ends.iter().flat_map(|end| end.hull).copied().collect();
        corners.sort_by_key(|corner| corner.to_array().map(f64::to_bits));
        corners.dedup();
        Self {
            planes: ends.iter().map(|end| end.plane).collect(),
            ball: Ball::around(&corners),
            corners,
            room: ends.iter().map(FlatEnd::room).fold(f64::INFINITY, f64::min),
        }
    }

    /// Whether no point lies before any of them.
    fn have_behind(&self, points: &[DVec3]) -> bool {
        self.planes.iter().all(|plane| points.iter().all(|x| plane.height(*x) <= self.room))
    }
}

/// Surfaces that may stand between those of two groups.
#[derive(Clone, Debug)]
pub struct BetweenGroups(Vec<Standing>);

/// A surface that may stand between those of two groups.
#[derive(Clone, Copy, Debug)]
struct Standing {
    surface: usize,
    /// Its plane, if it is flat.
    plane: Option<Plane>,
    /// Sides of that on which either group lies.
    sides: [Sides; 2],
    /// The group that it is nearer to.
    nearer: usize,
}

/// Some of the surfaces between two groups, by their places among these: such as may stand between one member of a
/// group and all of the other.
#[derive(Clone, Debug)]
pub struct Places(SmallVec<[u64; 2]>);

impl Places {
    /// Surfaces that are in both.
    fn shared<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = usize> + 'a {
        let words = self.0.iter().zip(&other.0).map(|(one, other)| one & other).enumerate();
        words.flat_map(|(word, bits)| {
            (0..64).filter(move |bit| bits >> bit & 1 == 1).map(move |bit| 64 * word + bit)
        })
    }

    /// Whether none is in both.
    pub fn are_apart(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(one, other)| one & other == 0)
    }
}

/// Normals of planes that have separated each surface from others, the last two, tried first for others beside these.
#[derive(Clone, Debug)]
pub struct Normals(Vec<[DVec3; 2]>);

impl Normals {
    /// Whether one of them separates a surface from two hulls.
    fn separate(&self, surface: usize, hulls: [&[DVec3]; 3], room: f64) -> bool {
        self.0[surface].iter().any(|normal| separates(*normal, hulls, room))
    }

    fn keep(&mut self, surface: usize, normal: DVec3) {
        self.0[surface] = [normal, self.0[surface][0]];
    }
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
    /// No normals yet.
    pub fn no_normals(&self) -> Normals {
        Normals(vec![[DVec3::ZERO; 2]; self.obstacles.len()])
    }

    /// The surfaces that may stand between those of two groups, as far as these normals for surfaces near either tell;
    /// None where these are many.
    pub fn between_groups(&self, [a, b]: [&Neighbours; 2], normals: &[Normals; 2]) -> Option<BetweenGroups> {
        let room = a.room.min(b.room);
        let may_hide = |surface: usize| {
            let Obstacle { hull, ball, .. } = &self.obstacles[surface];
            if ball.misses_between(&a.ball, &b.ball) {
                return None;
            }
            let [to_a, to_b] = [a, b].map(|group| group.ball.center().distance_squared(ball.center()));
            let nearer = usize::from(to_b < to_a);
            if normals[nearer].separate(surface, [&a.corners, &b.corners, hull], room) {
                return None;
            }
            let plane = self.plane_of(surface);
            let sides = [a, b].map(|group| Sides::of(&group.corners, plane, group.room));
            if sides[0].are_shared(sides[1]) || a.have_behind(hull) || b.have_behind(hull) {
                return None;
            }
            Some(Standing { surface, plane, sides, nearer })
        };
        let mut found = Vec::new();
        for (count, surface) in self.standing_in(Capsule::around(&a.ball, &b.ball)).enumerate() {
            found.extend(may_hide(surface));
            if count >= FEW_BY_BOXES || found.len() > FEW {
                return None;
            }
        }
        Some(BetweenGroups(found))
    }

    /// Places, among the surfaces between two `groups`, of those that may stand between one member of the group
    /// `own`, 0 or 1, and all of the other. Surfaces that are nearer to the other group are not looked at: any may.
    pub fn between(
        &self,
        end: FlatEnd<'_>,
        own: usize,
        groups: [&Neighbours; 2],
        between: &BetweenGroups,
        normals: &mut Normals,
    ) -> Places {
        let other = groups[1 - own];
        let room = end.room().min(other.room);
        let mut may_hide = |standing: &Standing| {
            let Standing { surface, plane, sides, nearer } = *standing;
            let Obstacle { hull, ball, .. } = &self.obstacles[surface];
            if nearer != own {
                return true;
            }
            if normals.separate(surface, [end.hull, &other.corners, hull], room)
                || Sides::of(end.hull, plane, end.room()).are_shared(sides[1 - own])
                || end.has_behind(hull)
                || ball.misses_between(&end.ball, &other.ball)
                || self.is_own(surface, end)
            {
                return false;
            }
            let found = separating(end.hull, &other.corners, hull, room);
            found.into_iter().for_each(|normal| normals.keep(surface, normal));
            found.is_none()
        };
        let mut places = SmallVec::from_elem(0, between.0.len().div_ceil(64));
        for (place, standing) in between.0.iter().enumerate() {
            places[place / 64] |= u64::from(may_hide(standing)) << (place % 64);
        }
        Places(places)
    }

    /// Whether nothing can stand between two flat surfaces, of what may stand between one and neighbours of the other
    /// both ways.
    pub fn is_clear(&self, ends: [FlatEnd<'_>; 2], between: &BetweenGroups, places: [&Places; 2]) -> bool {
        let may_hide = |place: usize| {
            let Standing { surface, plane, .. } = between.0[place];
            self.may_hide(surface, plane, ends)
        };
        !places[0].shared(places[1]).any(may_hide)
    }

    /// Whether nothing can stand between two flat surfaces, of all surfaces.
    pub fn is_clear_of_all(&self, ends: [FlatEnd<'_>; 2]) -> bool {
        let [a, b] = ends.map(|end| end.ball);
        let mut standing = self.standing_in(Capsule::around(&a, &b));
        !standing.any(|surface| self.may_hide(surface, self.plane_of(surface), ends))
    }

    /// Whether a surface in this plane, if it is flat, may stand between two others.
    fn may_hide(&self, surface: usize, plane: Option<Plane>, [a, b]: [FlatEnd<'_>; 2]) -> bool {
        let room = a.room().min(b.room());
        let Obstacle { hull, ball, .. } = &self.obstacles[surface];
        let sides = |end: FlatEnd<'_>| Sides::of(end.hull, plane, end.room());
        !ball.misses_between(&a.ball, &b.ball)
            && !sides(a).are_shared(sides(b))
            && ![a, b].iter().any(|end| end.has_behind(hull) || self.is_own(surface, *end))
            && !separated(a.hull, b.hull, hull, room)
    }

    /// The surfaces that can stand between others and whose boxes reach into a capsule.
    fn standing_in(&self, capsule: Capsule) -> impl Iterator<Item = usize> {
        self.standing_tree.search(move |bounds| !capsule.misses(bounds)).map(|place| self.standing[place])
    }

    /// Whether a surface is an end of a shaft, or of one body with it.
    fn is_own(&self, surface: usize, end: FlatEnd<'_>) -> bool {
        surface == end.surface || self.are_of_one_body(surface, end.surface)
    }

    /// The plane of a surface, if it is flat.
    fn plane_of(&self, surface: usize) -> Option<Plane> {
        let obstacle = &self.obstacles[surface];
        let region = obstacle.shape.region()?;
        Some(Plane { point: obstacle.hull[0], normal: region.normal() })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_scene::Source;

    use super::*;
    use crate::Shadows;

    /// Whether a plane separates each surface by itself from both ends, or it lies behind one.
    fn is_clear_of_all(visibility: &Visibility, [a, b]: [FlatEnd<'_>; 2]) -> bool {
        let room = a.room().min(b.room());
        let keeps_out = |surface: usize| {
            let hull = &visibility.obstacles[surface].hull;
            [a.surface, b.surface].contains(&surface)
                || [a, b].iter().any(|end| end.has_behind(hull))
                || separated(a.hull, b.hull, hull, room)
        };
        visibility.standing().all(keeps_out)
    }

    /// The visibility between triangles.
    fn of_triangles(triangles: &[[DVec3; 3]]) -> Visibility {
        let text = |[a, b, c]: &[DVec3; 3]| {
            format!("[[surfaces]]\ntriangle = {{ vertices = [{a:?}, {b:?}, {c:?}] }}\n").replace("DVec3", "")
        };
        let text: String = triangles.iter().map(text).collect::<String>().replace('(', "[").replace(')', "]");
        let scene = radiosity_language::read(&Source::new("triangles", &text)).expect("triangles");
        Visibility::new(&scene, Shadows::Auto, 1e-3)
    }

    /// One of some triangles as an end of a shaft.
    fn end_of(triangles: &[[DVec3; 3]], surface: usize) -> FlatEnd<'_> {
        let hull = &triangles[surface];
        let normal = (hull[1] - hull[0]).cross(hull[2] - hull[0]).normalize();
        FlatEnd { surface, plane: Plane { point: hull[0], normal }, hull, ball: Ball::around(hull) }
    }

    /// Triangles in a scene, and pairs of them between which nothing can stand.
    fn clear_pairs(triangles: &[[DVec3; 3]]) -> (Visibility, Vec<[usize; 2]>) {
        let visibility = of_triangles(triangles);
        let end = |surface: usize| end_of(triangles, surface);
        let pairs = (0..triangles.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
        let groups: Vec<Vec<usize>> =
            (0..triangles.len()).collect::<Vec<_>>().chunks(3).map(<[_]>::to_vec).collect();
        let group = |members: &Vec<usize>| {
            Neighbours::of(&members.iter().map(|surface| end(*surface)).collect::<Vec<_>>())
        };
        let neighbours: Vec<Neighbours> = groups.iter().map(group).collect();
        let mut normals = [visibility.no_normals(), visibility.no_normals()];
        let is_clear = |[i, j]: &[usize; 2]| {
            let ends = [end(*i), end(*j)];
            let mut is_clear_by = |groups: [&Neighbours; 2]| {
                let between = visibility.between_groups(groups, &normals).expect("they are few");
                let places =
                    [0, 1].map(|own| visibility.between(ends[own], own, groups, &between, &mut normals[own]));
                visibility.is_clear(ends, &between, places.each_ref())
            };
            let is_clear = is_clear_by([&neighbours[i / 3], &neighbours[j / 3]]);
            let one_by_one = [i, j].map(|own| group(&vec![*own]));
            assert_eq!(is_clear, is_clear_by(one_by_one.each_ref()));
            assert_eq!(is_clear, is_clear_of_all(&visibility, ends));
            assert_eq!(is_clear, visibility.is_clear_of_all(ends));
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

    /// Between two triangles that face each other many small ones stand, or few.
    #[test]
    fn groups_with_much_between_are_not_looked_at() {
        let corner = DVec3::new;
        let ends = [
            [corner(0.0, 0.0, 0.0), corner(1.0, 0.0, 0.0), corner(0.0, 1.0, 0.0)],
            [corner(0.0, 0.0, 1.0), corner(0.0, 1.0, 1.0), corner(1.0, 0.0, 1.0)],
        ];
        let small = |k: usize| {
            let foot = corner(0.2, 0.2, 0.3 + 0.005 * k as f64);
            [foot, foot + corner(0.1, 0.0, 0.0), foot + corner(0.0, 0.1, 0.0)]
        };
        for count in [FEW, FEW + 1] {
            let all: Vec<[DVec3; 3]> = ends.into_iter().chain((0..count).map(small)).collect();
            let visibility = of_triangles(&all);
            let [one, other] = [0, 1].map(|surface| end_of(&all, surface));
            let groups = [one, other].map(|end| Neighbours::of(&[end]));
            let normals = [visibility.no_normals(), visibility.no_normals()];
            let between = visibility.between_groups(groups.each_ref(), &normals);
            assert_eq!(between.map(|between| between.0.len()), (count == FEW).then_some(FEW));
            assert!(!visibility.is_clear_of_all([one, other]));
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
