//! Coincident surfaces: two that lie in one another, so that light between them, and the nearest hit of a
//! ray, would be undefined.
//!
//! Planar regions coincide if they share a plane and some area. For other pairs short rays along the normals
//! of one surface test the other, at 8 × 8 places off every symmetry of the parameter square: the surfaces
//! coincide if such a place, and one to each side of it, lies on the other surface with the same normal. That
//! finds copies and parts of one another, whatever shapes made them, except overlaps narrower than an eighth
//! of both. Surfaces that touch in a point or along a line do not coincide.

use std::sync::Arc;

use radiosity_geom::{
    Aabb, COINCIDENT, DVec3, PARALLEL_PLANES, PlanarRegion, Ray, Rect, Surface, polygon_area, polygon_width,
    touching,
};

use crate::tolerances::{OVERLAP_OF_BREADTH, OVERLAP_OF_EXTENT};

/// Tested values of each parameter, no two symmetric, and none where shapes are likely to touch, such as ends
/// and middles. Overlaps narrower than the steps between them, an eighth of the parameters, may be missed;
/// more places take time as their square. An arbitrary choice otherwise.
const PLACES: [f64; 8] = [-0.913, -0.671, -0.437, -0.172, 0.089, 0.323, 0.582, 0.864];

/// Distance in parameters to the tests beside a place. Surfaces that only touch part from each other like its
/// square: it has to be well above the root of [`COINCIDENT`], 3·10⁻⁵, or they would count as one; and
/// overlaps narrower than it are missed.
const ASIDE: f64 = 0.02;

/// A shape with its bounding box, which rules out nearly all pairs.
#[derive(Debug)]
pub struct Occupied {
    shape: Arc<dyn Surface>,
    bounds: Aabb,
    extent: f64,
}

impl Occupied {
    /// The space of `shape`.
    pub fn new(shape: &Arc<dyn Surface>) -> Self {
        let bounds = match shape.region() {
            Some(region) => Aabb::around(region.outer().iter().copied()),
            None => shape.bounds(&Rect::FULL),
        };
        let extent = bounds.diagonal();
        Occupied { shape: Arc::clone(shape), bounds: bounds.inflate(COINCIDENT * extent), extent }
    }

    /// Bounding box with a margin for rounding.
    pub fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// Whether two coinciding surfaces face away from each other.
    pub fn opposes(&self, other: &Occupied) -> bool {
        match (self.shape.region(), other.shape.region()) {
            (Some(a), Some(b)) => a.normal().dot(b.normal()) < 0.0,
            _ => turns_away(self, other) || turns_away(other, self),
        }
    }

    /// The area that two planar surfaces have in common; 0 if either is curved.
    pub(super) fn common_area(&self, other: &Occupied) -> f64 {
        match (self.shape.region(), other.shape.region()) {
            (Some(a), Some(b)) => common_area(a, b),
            _ => 0.0,
        }
    }

    /// Whether the two surfaces lie in one another.
    pub fn coincides(&self, other: &Occupied) -> bool {
        self.bounds.overlaps(&other.bounds)
            && match (self.shape.region(), other.shape.region()) {
                (Some(a), Some(b)) => same_plane(a, b) && overlap(a, b) > 0.0,
                _ => lies_in(self, other) || lies_in(other, self),
            }
    }
}

fn same_plane(a: &PlanarRegion, b: &PlanarRegion) -> bool {
    let (small, large) = if a.extent() <= b.extent() { (a, b) } else { (b, a) };
    // Heights refer to the large region's plane: the small one's is uncertain far away.
    let tolerance = touching(small.extent(), large.extent());
    small.outer().iter().all(|point| large.height(*point).abs() <= tolerance)
        && large.normal().cross(small.normal()).length() <= PARALLEL_PLANES
}

/// The area that two regions in one plane share, seen along the normal of the second; 0 where edges only touch,
/// which overlap by rounding in many models of single precision.
pub fn overlap(a: &PlanarRegion, b: &PlanarRegion) -> f64 {
    let least = least_overlap([a, b].map(PlanarRegion::extent), [a, b].map(PlanarRegion::area));
    let parts: Vec<Vec<DVec3>> = a.common_parts(b).collect();
    let is_wide = parts.iter().any(|part| polygon_width(part) > least);
    if is_wide { parts.iter().map(|part| polygon_area(part)).sum() } else { 0.0 }
}

/// Width (length) up to which two sheets with these extents (lengths) and areas only touch.
pub fn least_overlap(extents: [f64; 2], areas: [f64; 2]) -> f64 {
    let breadth = (areas[0] / extents[0]).min(areas[1] / extents[1]);
    (OVERLAP_OF_EXTENT * extents[0].min(extents[1])).min(OVERLAP_OF_BREADTH * breadth)
}

/// The area that two regions have in common, seen along the normal of the second.
pub(super) fn common_area(a: &PlanarRegion, b: &PlanarRegion) -> f64 {
    a.common_parts(b).map(|part| polygon_area(&part)).sum()
}

/// Whether a part of `a`, more than a line, lies in `b`.
fn lies_in(a: &Occupied, b: &Occupied) -> bool {
    let size = a.extent.min(b.extent);
    let on = |u: f64, v: f64| {
        let jet = a.shape.jet(u, v);
        let belongs = a.shape.region().is_none_or(|region| region.contains(jet.position));
        belongs && b.bounds.contains(jet.position) && passes_through(&b.shape, jet.position, jet.normal, size)
    };
    // Surfaces that only touch agree along one direction at most.
    let around = |u: f64, v: f64| on(u, v) && on(u + ASIDE, v) && on(u, v + ASIDE);
    PLACES.iter().any(|u| PLACES.iter().any(|v| around(*u, *v)))
}

/// Whether `surface` passes through `point` perpendicular to `normal`.
fn passes_through(surface: &Arc<dyn Surface>, point: DVec3, normal: DVec3, size: f64) -> bool {
    normal_there(surface, point, normal, size)
        .is_some_and(|there| there.cross(normal).length() < PARALLEL_PLANES)
}

/// The normal of `surface` at `point`, found by a segment of 1e-4 of `size` along `normal`; None if it is not
/// on it.
fn normal_there(surface: &Arc<dyn Surface>, point: DVec3, normal: DVec3, size: f64) -> Option<DVec3> {
    let reach = 1e-4 * size * normal;
    let hit = surface.intersect(&Ray::segment(point - reach, point + reach))?;
    let there = surface.jet(hit.u, hit.v);
    (there.position.distance(point) <= COINCIDENT * size).then_some(there.normal)
}

/// Whether the normals are opposite at all places of `a` that lie in `b`, of which there are some.
fn turns_away(a: &Occupied, b: &Occupied) -> bool {
    let size = a.extent.min(b.extent);
    let places = PLACES.iter().flat_map(|u| PLACES.iter().map(move |v| (*u, *v)));
    let mut cosines = places.filter_map(|(u, v)| {
        let jet = a.shape.jet(u, v);
        let belongs = a.shape.region().is_none_or(|region| region.contains(jet.position));
        let there = normal_there(&b.shape, jet.position, jet.normal, size).filter(|_| belongs)?;
        Some(there.dot(jet.normal))
    });
    cosines.next().is_some_and(|first| first < 0.0 && cosines.all(|cosine| cosine < 0.0))
}

#[cfg(test)]
mod tests {
    use radiosity_geom::{
        Flipped,
        shapes::{Bezier, Bilinear, Cone, Cylinder, Disk, FULL_TURN, Parallelogram, Revolution, Sphere},
    };

    use super::*;

    const X: DVec3 = DVec3::X;
    const Y: DVec3 = DVec3::Y;
    const Z: DVec3 = DVec3::Z;

    fn occupied(shape: impl Surface + 'static) -> Occupied {
        Occupied::new(&(Arc::new(shape) as Arc<dyn Surface>))
    }

    #[track_caller]
    fn assert_coincide(expected: bool, a: &Occupied, b: &Occupied) {
        assert_eq!((a.coincides(b), b.coincides(a)), (expected, expected));
    }

    fn ball(center: DVec3, radius: f64, axis: DVec3, z: [f64; 2]) -> Sphere {
        Sphere::new(center, radius, axis, z, FULL_TURN).unwrap()
    }

    #[test]
    fn parts_of_a_sphere_lie_in_it_whatever_their_axis() {
        let whole = occupied(ball(X, 2.0, Z, [-2.0, 2.0]));
        for part in
            [ball(X, 2.0, Y, [-2.0, 2.0]), ball(X, 2.0, X + Y, [1.8, 1.9]), ball(X, 2.0, Z, [-1.0, 2.0])]
        {
            assert_coincide(true, &whole, &occupied(part.clone()));
            assert_coincide(true, &whole, &occupied(Flipped::new(Box::new(part))));
        }
        assert_coincide(false, &whole, &occupied(ball(X, 2.0 + 1e-6, Z, [-2.0, 2.0])));
        // From within, two balls touch in a point.
        assert_coincide(false, &whole, &occupied(ball(2.0 * X, 1.0, X, [-1.0, 1.0])));
        // Two halves share a circle.
        assert_coincide(
            false,
            &occupied(ball(X, 2.0, Z, [0.0, 2.0])),
            &occupied(ball(X, 2.0, Z, [-2.0, 0.0])),
        );
    }

    #[test]
    fn a_copy_turned_over_opposes_and_a_plain_one_does_not() {
        let shapes: [Arc<dyn Surface>; 3] = [
            Arc::new(ball(X, 2.0, Z, [-2.0, 2.0])),
            Arc::new(Disk::new(X, Y, 1.0, 0.2, FULL_TURN).unwrap()),
            Arc::new(Parallelogram::new(X, Y, Z).unwrap()),
        ];
        for shape in &shapes {
            let own = Occupied::new(shape);
            assert!(!own.opposes(&own));
            assert!(own.opposes(&occupied(Flipped::new(Box::new(Arc::clone(shape))))));
        }
    }

    #[test]
    fn parts_of_a_cylinder_and_of_a_disk_lie_in_them() {
        let wall = |base: f64, height: f64, angle| Cylinder::new(base * Z, height * Z, 1.0, angle).unwrap();
        let whole = occupied(wall(0.0, 2.0, FULL_TURN));
        assert_coincide(true, &whole, &occupied(wall(1.7, 2.0, FULL_TURN)));
        assert_coincide(true, &whole, &occupied(wall(0.5, 0.1, [1.0, 1.2])));
        assert_coincide(false, &whole, &occupied(wall(2.0, 2.0, FULL_TURN)));
        // A cone that is a cylinder, a sheet that lies in a plane, and a disk on a table.
        assert_coincide(true, &whole, &occupied(Cone::new(Z, Z, 1.0, 1.0, FULL_TURN).unwrap()));
        let disk = occupied(Disk::new(DVec3::ZERO, Z, 1.0, 0.0, FULL_TURN).unwrap());
        let ring = Revolution::new([0.2 * X, 0.3 * X, 0.4 * X, 0.5 * X], DVec3::ZERO, Z, FULL_TURN);
        assert_coincide(true, &disk, &occupied(ring.unwrap()));
        let table = occupied(Parallelogram::new(-3.0 * (X + Y), 6.0 * X, 6.0 * Y).unwrap());
        assert_coincide(true, &table, &disk);
        // A wheel standing on the table, and one standing in it.
        let wheel = Cylinder::new(Z - X, 2.0 * X, 1.0, FULL_TURN).unwrap();
        assert_coincide(false, &table, &occupied(wheel));
        assert_coincide(false, &table, &whole);
    }

    #[test]
    fn copies_of_bent_patches_coincide_and_neighbours_do_not() {
        let corners = |shift: f64| [DVec3::ZERO, X, X + Y + 0.3 * Z, Y].map(|p| p + shift * X);
        let quad = |vertices| occupied(Bilinear::new(vertices).unwrap());
        let mut turned = corners(0.0);
        turned.reverse();
        assert_coincide(true, &quad(corners(0.0)), &quad(turned));
        assert_coincide(false, &quad(corners(0.0)), &quad(corners(1.0)));
        let net = |shift: f64, height: f64| {
            let point = |i: usize, j: usize| {
                DVec3::new(i as f64 + shift, j as f64, height * (i * j) as f64 * (3.0 - i as f64))
            };
            occupied(Bezier::new(std::array::from_fn(|i| std::array::from_fn(|j| point(i, j)))).unwrap())
        };
        assert_coincide(true, &net(0.0, 0.2), &net(0.0, 0.2));
        assert_coincide(false, &net(0.0, 0.2), &net(3.0, 0.2));
        assert_coincide(false, &net(0.0, 0.2), &net(0.0, 0.201));
    }
}
