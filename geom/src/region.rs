//! Polygons with holes in a plane.
//!
//! The plane passes through the first vertex of the outline; its normal is Newell's, ½ Σ xᵢ × xᵢ₊₁ made a
//! unit vector, so that the outline runs counter-clockwise about it. Holes are stored clockwise: the region
//! lies to the left of every edge.

mod places;
mod ring;
mod rings;
mod pieces;

use crate::tolerances::{LOOSE, NO_AREA, PLANARITY, ROUNDING, ROUNDINGS_OF_PLANE};
use crate::{Hit, Motion, ShapeError, area_vector, coordinate_rounding, intersection};
use glam::{DVec2, DVec3};
use pieces::Pieces;
use rings::Rings;

/// A polygon with holes in a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanarRegion {
    outer: Vec<DVec3>,
    holes: Vec<Vec<DVec3>>,
    /// Outline and holes in plane coordinates.
    flat: Rings,
    axes: [DVec3; 2],
    normal: DVec3,
    area: f64,
    extent: f64,
    pieces: Pieces,
}

impl PlanarRegion {
    /// The region inside `outer` and outside all `holes`. The right-hand rule of `outer` gives the normal;
    /// holes may run in either direction and may touch each other and the outline, but not cross them.
    ///
    /// # Errors
    ///
    /// Too few, repeated or non-finite vertices; no area; vertices farther off the plane than 2e-5 of the
    /// extent and than the rounding of their coordinates; a ring that crosses itself; a hole that leaves the
    /// outline or overlaps another. The fields are named `vertices` and `holes[k]`.
    pub fn new(outer: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> Result<PlanarRegion, ShapeError> {
        let names: Vec<String> = (0..=holes.len()).map(ring_name).collect();
        let mut rings = vec![outer];
        rings.extend(holes);
        for (ring, name) in rings.iter().zip(&names) {
            check_vertices(ring, name)?;
        }
        let (normal, extent) = plane_of(&rings[0])?;
        for (ring, name) in rings.iter().zip(&names) {
            check_planar(ring, rings[0][0], normal, extent, name)?;
        }
        let axes = axes_of(&rings[0], normal);
        let mut flat: Vec<Vec<DVec2>> =
            rings.iter().map(|ring| ring.iter().map(|x| in_plane(*x, rings[0][0], axes)).collect()).collect();
        for k in 1..flat.len() {
            if ring::signed_area(&flat[k]) > 0.0 {
                flat[k].reverse();
                rings[k].reverse();
            }
        }
        let flat = Rings::new(flat);
        flat.check(&names, extent)?;
        let origin = rings[0][0];
        let pieces = Pieces::new(pieces::of(&flat, &rings, &names)?, |x| in_plane(x, origin, axes));
        let area = flat.area();
        let holes = rings.split_off(1);
        let outer = rings.remove(0);
        Ok(PlanarRegion { outer, holes, flat, axes, normal, area, extent, pieces })
    }

    /// The vertices of the outline, counter-clockwise about the normal.
    pub fn outer(&self) -> &[DVec3] {
        &self.outer
    }

    /// The vertices of each hole, clockwise about the normal.
    pub fn holes(&self) -> &[Vec<DVec3>] {
        &self.holes
    }

    /// Unit normal, by the right-hand rule of the outline.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// A point of the plane: the first vertex of the outline.
    pub fn origin(&self) -> DVec3 {
        self.outer[0]
    }

    /// Two unit vectors in the plane, the first along the first edge, with axis 0 × axis 1 = normal.
    pub fn axes(&self) -> [DVec3; 2] {
        self.axes
    }

    /// Area of the outline without the holes, in squared units of length.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The largest distance of a vertex from the origin: the region's size, for tolerances.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Height of `point` over the plane, positive before the front (units of length).
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin()).dot(self.normal)
    }

    /// All corners: those of the outline, then those of each hole.
    pub fn corners(&self) -> Vec<DVec3> {
        self.outer.iter().chain(self.holes.iter().flatten()).copied().collect()
    }

    /// The nearest point of the region.
    pub fn nearest(&self, point: DVec3) -> DVec3 {
        let foot = point - self.height(point) * self.normal;
        if self.contains(foot) {
            return foot;
        }
        let rings = std::iter::once(&self.outer).chain(&self.holes);
        let edges = rings.flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        let nearest = edges.map(|(a, b)| {
            let along = (point - *a).dot(*b - *a) / a.distance_squared(*b);
            a.lerp(*b, along.clamp(0.0, 1.0))
        });
        let nearer = |a: &DVec3, b: &DVec3| a.distance_squared(point).total_cmp(&b.distance_squared(point));
        nearest.min_by(nearer).expect("a region has edges")
    }

    /// Coordinates of the foot of `point` on the plane, along [`PlanarRegion::axes`] from
    /// [`PlanarRegion::origin`].
    pub fn to_plane(&self, point: DVec3) -> DVec2 {
        in_plane(point, self.origin(), self.axes)
    }

    /// Whether `point` lies in the region: in its plane within 1e-6 of the extent, and inside or within 1e-9
    /// of the boundary.
    pub fn contains(&self, point: DVec3) -> bool {
        self.height(point).abs() <= LOOSE * self.extent && self.covers(self.to_plane(point))
    }

    /// Whether the plane coordinates `at` lie in the region or within 1e-9 of its boundary.
    pub(crate) fn covers(&self, at: DVec2) -> bool {
        self.flat.covers(at, Hit::SEAM * self.extent)
    }

    /// The outline in plane coordinates.
    pub(crate) fn flat_outline(&self) -> &[DVec2] {
        self.flat.outline().points()
    }

    /// The region cut into few, well-shaped convex polygons of three or four of the given vertices each,
    /// counter-clockwise about the normal. Together they cover the region exactly. A convex outline of three
    /// or four vertices is one piece.
    pub fn convex_pieces(&self) -> &[Vec<DVec3>] {
        self.pieces.list()
    }

    /// The parts of its convex pieces over those of another region, seen along that region's normal.
    pub fn common_parts<'a>(&'a self, other: &'a PlanarRegion) -> impl Iterator<Item = Vec<DVec3>> + 'a {
        let tilt = self.normal.dot(other.normal);
        let foot = move |x: &DVec3| self.to_plane(*x - self.height(*x) / tilt * other.normal);
        let ours = self.pieces.near(other.outer.iter().map(foot));
        let pairs = ours.flat_map(move |our| {
            let theirs = other.pieces.near(our.iter().map(|x| other.to_plane(*x)));
            theirs.map(move |their| (our, their))
        });
        pairs.map(|(our, their)| intersection(our, their, other.normal())).filter(|part| part.len() > 2)
    }

    /// The region as seen from its other side, with the opposite normal.
    #[must_use]
    pub fn flipped(&self) -> PlanarRegion {
        let reversed =
            |rings: &[Vec<DVec3>]| rings.iter().map(|r| r.iter().rev().copied().collect()).collect();
        // The first vertex stays first, so that the plane keeps its origin.
        let mut outer: Vec<DVec3> = self.outer.iter().rev().copied().collect();
        outer.rotate_right(1);
        let axes = [self.axes[0], -self.axes[1]];
        let mirrored = |ring: &[DVec2]| ring.iter().rev().map(|p| DVec2::new(p.x, -p.y)).collect();
        let mut flat: Vec<Vec<DVec2>> = self.flat.points().map(mirrored).collect();
        flat[0].rotate_right(1);
        let flat = Rings::new(flat);
        let origin = outer[0];
        PlanarRegion {
            outer,
            holes: reversed(&self.holes),
            flat,
            axes,
            normal: -self.normal,
            pieces: Pieces::new(reversed(self.pieces.list()), |x| in_plane(x, origin, axes)),
            ..*self
        }
    }

    /// The region after a motion.
    pub(crate) fn moved(&self, motion: &Motion) -> PlanarRegion {
        let ring = |ring: &[DVec3]| -> Vec<DVec3> { ring.iter().map(|x| motion.point(*x)).collect() };
        let rings = |rings: &[Vec<DVec3>]| rings.iter().map(|r| ring(r)).collect();
        let scale = motion.scale();
        let outer = ring(&self.outer);
        let (origin, axes) = (outer[0], self.axes.map(|axis| motion.direction(axis)));
        PlanarRegion {
            outer,
            holes: rings(&self.holes),
            flat: self.flat.map(|ring| ring.iter().map(|p| scale * *p).collect()),
            axes,
            normal: motion.direction(self.normal),
            area: scale * scale * self.area,
            extent: scale * self.extent,
            pieces: Pieces::new(rings(self.pieces.list()), |x| in_plane(x, origin, axes)),
        }
    }
}

/// `vertices` for the outline, `holes[k]` for the holes.
fn ring_name(k: usize) -> String {
    if k == 0 { "vertices".into() } else { format!("holes[{}]", k - 1) }
}

/// Each vertex finite and apart from the next, at least three.
fn check_vertices(ring: &[DVec3], name: &str) -> Result<(), ShapeError> {
    let field = || name.to_owned();
    if ring.iter().any(|x| !x.is_finite()) {
        return Err(ShapeError::NotFinite { field: field() });
    }
    if ring.len() < 3 {
        return Err(ShapeError::TooFewVertices { field: field(), count: ring.len() });
    }
    let extent = ring.iter().map(|x| x.distance(ring[0])).fold(0.0, f64::max);
    let repeats = |k: &usize| ring[*k].distance(ring[(k + 1) % ring.len()]) <= ROUNDING * extent;
    match (0..ring.len()).find(repeats) {
        Some(index) => Err(ShapeError::RepeatedVertex { field: field(), index }),
        None => Ok(()),
    }
}

/// Newell's unit normal of the outline, and its extent.
fn plane_of(outer: &[DVec3]) -> Result<(DVec3, f64), ShapeError> {
    let twice = 2.0 * area_vector(outer);
    let extent = outer.iter().map(|x| x.distance(outer[0])).fold(0.0, f64::max);
    if twice.length() <= NO_AREA * extent * extent {
        // A symmetric bow tie has no net area; its crossing is the better message.
        return Err(ring::bow_tie(outer).unwrap_or(ShapeError::NoArea { field: ring_name(0) }));
    }
    Ok((twice.normalize(), extent))
}

/// Every vertex of `ring` within tolerance of the plane.
fn check_planar(
    ring: &[DVec3],
    origin: DVec3,
    normal: DVec3,
    extent: f64,
    name: &str,
) -> Result<(), ShapeError> {
    let heights = ring.iter().map(|x| (*x - origin).dot(normal).abs());
    let (index, deviation) = heights.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).expect("three vertices");
    if deviation <= (PLANARITY * extent).max(ROUNDINGS_OF_PLANE * coordinate_rounding(ring, Some(normal))) {
        return Ok(());
    }
    Err(ShapeError::NotPlanar { field: name.to_owned(), index, deviation })
}

/// Unit axes of the plane, the first along the first edge.
fn axes_of(outer: &[DVec3], normal: DVec3) -> [DVec3; 2] {
    let edge = outer[1] - outer[0];
    let first = (edge - edge.dot(normal) * normal).normalize();
    [first, normal.cross(first)]
}

/// Plane coordinates of a point.
fn in_plane(point: DVec3, origin: DVec3, axes: [DVec3; 2]) -> DVec2 {
    let d = point - origin;
    DVec2::new(d.dot(axes[0]), d.dot(axes[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn flat(points: &[(f64, f64)]) -> Vec<DVec3> {
        points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
    }

    fn square(center: (f64, f64), half: f64) -> Vec<DVec3> {
        let (x, y) = center;
        flat(&[(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)])
    }

    fn area_vector(polygon: &[DVec3]) -> DVec3 {
        let next = polygon.iter().cycle().skip(1);
        0.5 * polygon.iter().zip(next).map(|(x, y)| x.cross(*y)).sum::<DVec3>()
    }

    /// Pieces are convex, counter-clockwise, made of given vertices, and their areas add up to the region's.
    fn assert_covers(region: &PlanarRegion) {
        let given: Vec<DVec3> =
            region.outer().iter().chain(region.holes().iter().flatten()).copied().collect();
        let mut sum = 0.0;
        for piece in region.convex_pieces() {
            assert!((3..=4).contains(&piece.len()) && piece.iter().all(|x| given.contains(x)));
            for k in 0..piece.len() {
                let (p, q, r) = (piece[k], piece[(k + 1) % piece.len()], piece[(k + 2) % piece.len()]);
                assert!((q - p).cross(r - q).dot(region.normal()) > 0.0, "{piece:?} is not convex");
            }
            sum += area_vector(piece).dot(region.normal());
            let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
            assert!(region.contains(middle));
        }
        assert!((sum - region.area()).abs() <= 1e-12 * region.area(), "{sum} instead of {}", region.area());
    }

    #[test]
    fn a_square_with_a_square_hole_is_four_trapezia() {
        let region = PlanarRegion::new(square((0.0, 0.0), 2.0), vec![square((0.0, 0.0), 1.0)]).unwrap();
        assert_eq!(region.area(), 12.0);
        assert_covers(&region);
        assert_eq!(region.convex_pieces().len(), 4);
        assert!(!region.contains(DVec3::ZERO) && region.contains(DVec3::new(1.5, 0.3, 0.0)));
        assert!(region.contains(DVec3::X) && !region.contains(DVec3::new(1.5, 0.3, 0.1)));
    }

    #[test]
    fn a_convex_quad_or_triangle_is_one_piece() {
        let quad = flat(&[(0.0, 0.0), (4.0, 0.1), (3.0, 2.0), (0.5, 1.0)]);
        for ring in [quad.clone(), quad[..3].to_vec()] {
            let region = PlanarRegion::new(ring.clone(), vec![]).unwrap();
            assert_eq!(region.convex_pieces(), vec![ring]);
        }
    }

    #[test]
    fn holes_may_touch_the_outline_and_each_other() {
        let outer = || square((0.0, 0.0), 2.0);
        for holes in [
            vec![square((1.5, 0.0), 0.5)],
            vec![square((1.5, 1.5), 0.5)],
            vec![square((-0.5, 0.0), 0.5), square((0.5, 0.0), 0.5)],
            vec![square((-0.5, -0.5), 0.5), square((0.5, 0.5), 0.5)],
            vec![flat(&[(-2.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0)])],
        ] {
            assert_covers(&PlanarRegion::new(outer(), holes).unwrap());
        }
    }

    #[test]
    fn vertices_within_straight_edges_are_allowed() {
        let square =
            flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (2.0, 2.0), (0.0, 2.0), (0.0, 1.0)]);
        assert_covers(&PlanarRegion::new(square, vec![]).unwrap());
        let triangle = flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)]);
        assert_covers(&PlanarRegion::new(triangle, vec![]).unwrap());
    }

    #[test]
    fn the_floor_of_the_cornell_box_without_its_blocks() {
        let outer = flat(&[(552.8, 0.0), (549.6, 559.2), (0.0, 559.2), (0.0, 0.0)]);
        let short = flat(&[(130.0, 65.0), (82.0, 225.0), (240.0, 272.0), (290.0, 114.0)]);
        let tall = flat(&[(423.0, 247.0), (265.0, 296.0), (314.0, 456.0), (472.0, 406.0)]);
        let area = area_vector(&outer).length() - area_vector(&short).length() - area_vector(&tall).length();
        let region = PlanarRegion::new(outer, vec![short, tall]).unwrap();
        assert!((region.area() - area).abs() < 1e-9 * area);
        assert_covers(&region);
        // Twelve vertices and two holes make 14 triangles; all in pairs they would be seven pieces.
        assert!((7..=11).contains(&region.convex_pieces().len()), "{}", region.convex_pieces().len());
    }

    #[test]
    fn flipping_twice_gives_the_region_back() {
        let region = PlanarRegion::new(square((0.0, 0.0), 2.0), vec![square((0.5, 0.0), 1.0)]).unwrap();
        assert_eq!(region.flipped().flipped(), region);
        assert_eq!(region.flipped().normal(), -region.normal());
        assert_eq!(region.flipped().area(), region.area());
        assert_covers(&region.flipped());
    }

    #[test]
    fn wrong_polygons_name_the_ring() {
        let outer = || square((0.0, 0.0), 2.0);
        let bow_tie = || flat(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
        let skew_bow_tie = || flat(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 2.0)]);
        let spike = || flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)]);
        let message = |outer, holes| PlanarRegion::new(outer, holes).unwrap_err();
        assert!(matches!(message(bow_tie(), vec![]), ShapeError::SelfCrossing { .. }));
        assert!(matches!(message(skew_bow_tie(), vec![]), ShapeError::SelfCrossing { .. }));
        assert!(matches!(message(spike(), vec![]), ShapeError::SelfCrossing { .. }));
        assert!(matches!(
            message(outer()[..2].to_vec(), vec![]),
            ShapeError::TooFewVertices { count: 2, .. }
        ));
        assert!(matches!(message(vec![DVec3::ZERO; 3], vec![]), ShapeError::RepeatedVertex { index: 0, .. }));
        let line = flat(&[(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)]);
        assert!(matches!(message(line, vec![]), ShapeError::NoArea { .. } | ShapeError::SelfCrossing { .. }));
        let mut bent = outer();
        bent[2].z = 0.1;
        assert!(matches!(message(bent, vec![]), ShapeError::NotPlanar { .. }));
        let mut broken = outer();
        broken[1].x = f64::NAN;
        assert_eq!(message(broken, vec![]).field(), "vertices");
        let outside = message(outer(), vec![square((2.0, 0.0), 0.5)]);
        assert_eq!(outside, ShapeError::HoleOutside { field: "holes[0]".into() });
        assert_eq!(message(outer(), vec![square((9.0, 0.0), 0.5)]).field(), "holes[0]");
        let pair = vec![square((0.0, 0.0), 1.0), square((0.5, 0.5), 1.0)];
        assert!(matches!(message(outer(), pair), ShapeError::HolesOverlap { .. }));
        let nested = vec![square((0.0, 0.0), 1.0), square((0.0, 0.0), 0.5)];
        assert!(matches!(message(outer(), nested), ShapeError::HolesOverlap { .. }));
        let twice = vec![square((0.0, 0.0), 1.0), square((0.0, 0.0), 1.0)];
        assert!(matches!(message(outer(), twice), ShapeError::HolesOverlap { .. }));
        assert!(PlanarRegion::new(outer(), vec![outer()]).is_err());
    }

    #[test]
    fn edges_on_one_line_do_not_cross_however_the_outline_begins() {
        let comb = [
            (1.0, 0.0),
            (1.930_166_430_024_638_4, 2.790_499_290_348_640_3),
            (1.0, 4.0),
            (1.0, 3.0),
            (1.0, 1.704_612_591_356_569_3),
            (1.302_027_981_270_701_9, 2.000_000_000_281_280_8),
            (1.0, 1.0),
        ];
        for start in 0..comb.len() {
            let mut comb = comb;
            comb.rotate_left(start);
            PlanarRegion::new(flat(&comb), Vec::new()).unwrap();
        }
    }

    /// A square of `side`² cells of breadth 2 with a hole in each: the diamond |x| + |y| ≤ its radius about
    /// the middle.
    fn sieve(side: usize, radii: &[f64]) -> Result<PlanarRegion, ShapeError> {
        let middle = |k: usize| [k % side, k / side].map(|place| 2.0 * place as f64 + 1.0);
        let hole = |(k, r): (usize, &f64)| {
            let [x, y] = middle(k);
            flat(&[(x - r, y), (x, y - r), (x + r, y), (x, y + r)])
        };
        let breadth = 2.0 * side as f64;
        let outer = flat(&[(0.0, 0.0), (breadth, 0.0), (breadth, breadth), (0.0, breadth)]);
        PlanarRegion::new(outer, radii.iter().enumerate().map(hole).collect())
    }

    #[test]
    fn overlapping_holes_among_many_are_named() {
        let mut radii = vec![0.9; 100];
        radii[57] = 1.6;
        let expected = ShapeError::HolesOverlap { field: "holes[57]".into(), other: "holes[47]".into() };
        assert_eq!(sieve(10, &radii).unwrap_err(), expected);
        radii[57] = 0.9;
        radii[90] = 1.05;
        assert_eq!(sieve(10, &radii).unwrap_err().field(), "holes[90]");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        /// Each point of a plate with many holes lies in the hole about the middle of its cell, or in the
        /// plate; a long outline is walked along by place, too.
        #[test]
        fn a_sieve_covers_what_its_holes_leave(
            radii in prop::collection::vec(0.1..0.95, 144), places in prop::collection::vec(prop::array::uniform2(-0.5..24.5), 200),
        ) {
            let region = sieve(12, &radii).unwrap();
            assert_covers(&region);
            let exact = 24.0 * 24.0 - radii.iter().map(|r| 2.0 * r * r).sum::<f64>();
            prop_assert!((region.area() - exact).abs() < 1e-12 * exact);
            for [x, y] in places {
                let [column, row] = [x, y].map(|at: f64| (at / 2.0).floor());
                let inside = (0.0..24.0).contains(&x) && (0.0..24.0).contains(&y);
                let r = if inside { radii[(12.0 * row + column) as usize] } else { 0.0 };
                let from_middle = (x - 2.0 * column - 1.0).abs() + (y - 2.0 * row - 1.0).abs();
                prop_assert_eq!(region.contains(DVec3::new(x, y, 0.0)), inside && from_middle >= r);
            }
        }

        /// A comb of many teeth, ten times as high as broad: inside by height, on the border at its sides.
        #[test]
        fn long_outlines_cover_what_lies_below_them(
            heights in prop::collection::vec(0.5..1.5, 9..60), places in prop::collection::vec(prop::array::uniform2(0.0..1.0), 50),
        ) {
            let n = heights.len();
            let step = |(k, h): (usize, &f64)| [k, k + 1].map(|side| (0.1 * side as f64, *h));
            let top = heights.iter().enumerate().flat_map(step).rev();
            let outline: Vec<(f64, f64)> = [(0.0, 0.0), (0.1 * n as f64, 0.0)].into_iter().chain(top).collect();
            let region = PlanarRegion::new(flat(&outline), vec![]).unwrap();
            assert_covers(&region);
            prop_assert!((region.area() - 0.1 * heights.iter().sum::<f64>()).abs() < 1e-12 * n as f64);
            for [x, y] in places {
                let height = heights[(n as f64 * x) as usize];
                let (x, y) = (0.1 * n as f64 * x, 2.0 * y);
                prop_assert_eq!(region.contains(DVec3::new(x, y, 0.0)), y <= height);
                prop_assert!(region.contains(DVec3::new(x, height, 0.0)));
            }
        }

        /// Square and diamond holes in the cells of a grid, which touch along edges and in points.
        #[test]
        fn pieces_cover_regions_between_touching_holes(
            cells in prop::collection::vec(0..6, 25), turn in 0.0..6.3_f64, scale in -6.0..6.0_f64,
        ) {
            let (axis, scale) = (DVec2::from_angle(turn), 10.0_f64.powf(scale));
            let ring = |points: &[(f64, f64)]| -> Vec<DVec3> {
                points.iter().map(|&(x, y)| scale * axis.rotate(DVec2::new(x, y)).extend(0.3)).collect()
            };
            let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
            let diamond = [(0.5, 0.0), (1.0, 0.5), (0.5, 1.0), (0.0, 0.5)];
            let holes = cells.iter().enumerate().filter(|(_, kind)| **kind < 2).map(|(k, kind)| {
                let at = |(x, y)| (x + (k % 5) as f64, y + (k / 5) as f64);
                ring(&if *kind == 0 { square } else { diamond }.map(at))
            });
            let region = PlanarRegion::new(ring(&square.map(|(x, y)| (5.0 * x, 5.0 * y))), holes.collect()).unwrap();
            assert_covers(&region);
        }

        /// Star-shaped outlines with a star-shaped hole, anywhere in space.
        #[test]
        fn pieces_cover_random_regions(
            radii in prop::collection::vec(0.6..1.0, 5..24),
            inner in prop::collection::vec(0.1..0.3, 3..9),
            tilt in prop::array::uniform3(-1.0..1.0),
        ) {
            let turn = glam::DQuat::from_scaled_axis(DVec3::from_array(tilt));
            let ring = |radii: &[f64]| -> Vec<DVec3> {
                let at = |(k, r): (usize, &f64)| {
                    let angle = std::f64::consts::TAU * k as f64 / radii.len() as f64;
                    turn * (*r * DVec3::new(angle.cos(), angle.sin(), 0.0)) + DVec3::new(3.0, -2.0, 1.0)
                };
                radii.iter().enumerate().map(at).collect()
            };
            let region = PlanarRegion::new(ring(&radii), vec![ring(&inner)]).unwrap();
            prop_assert!(region.normal().dot(turn * DVec3::Z) > 1.0 - 1e-12);
            assert_covers(&region);
        }
    }
}
