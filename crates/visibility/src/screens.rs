//! Screens: planar surfaces joined along common sides, which hide together what none of them hides alone.
//!
//! Let K be the convex hull of two ends A and B, and S a union of joined surfaces that meets neither end
//! inside and whose border stays out of the inside of K. Where a segment from a point of A to a point of B
//! moves within A and B, the parity of its meetings with S does not change: it would have to pass the border,
//! or an end would have to pass S (V. Guillemin, A. Pollack, *Differential Topology*, 1974, §2.4).
//!
//! ```text
//! one segment meets S an odd number of times   ⇒   every segment meets S: A and B are hidden from each other
//! ```
//!
//! S is grown from one surface across the sides that reach into K. The two sides of a fin are one screen each
//! unless its tip reaches into K; then the parity is even, and nothing is told. Segments leave a flat end in
//! front of its plane, so the sides of the surface that it lies on are never passed.

use std::iter;

use radiosity_geom::{Aabb, COINCIDENT, DVec3, Plane, distance_to_segment, separated, sides};
use smallvec::SmallVec;

use crate::convex_bodies::Face;

/// Most surfaces of a screen. What hides widely is mostly near an end, where the shaft is narrow; with a
/// larger value more time goes into screens that turn out to be open.
const MOST: usize = 64;

/// Distance from the border of a surface, over the border's longest side, within which it is not told whether
/// a segment meets the surface: far above rounding.
const UNCERTAIN: f64 = 1e-7;

/// Distance from a sheet to the inside of an end, over the size of the shaft, from which it is certain that they
/// do not touch: far above the rounding with which it is told that a border stays out of the shaft. With a
/// smaller value a sheet that stands on a flat end, its lower border in the border of the shaft, would hide what
/// it stands on.
const CLEAR: f64 = 1e-7;

/// Extent of a flat end along a direction, over its size, up to which it counts as flat across it: far above
/// the rounding of its corners. With a smaller value rounding makes an end look thick along its normal, and what
/// stands on it look as if it stood beside it.
const FLAT: f64 = 1e-3;

/// One end of a set of segments.
#[derive(Clone, Copy, Debug)]
pub struct End<'a> {
    hull: &'a [DVec3],
    own: Option<Own>,
}

/// The planar surface that an end is a part of.
#[derive(Clone, Copy, Debug)]
struct Own {
    surface: usize,
    plane: Plane,
}

impl<'a> End<'a> {
    /// A part of the planar `surface`, with these corners; segments leave it in front of its `plane`.
    pub fn on(surface: usize, plane: Plane, hull: &'a [DVec3]) -> Self {
        Self { hull, own: Some(Own { surface, plane }) }
    }

    /// All that lies in the hull of these points, on whatever surfaces.
    pub fn within(hull: &'a [DVec3]) -> Self {
        Self { hull, own: None }
    }

    /// Points whose convex hull holds it.
    pub(super) fn hull(&self) -> &'a [DVec3] {
        self.hull
    }

    /// The planar surface whose part it is, if it is a part of one.
    pub(super) fn surface(&self) -> Option<usize> {
        self.own.map(|own| own.surface)
    }

    /// Whether segments to `point` leave it in front of its plane, by more than `margin`.
    pub(super) fn faces(&self, point: DVec3, margin: f64) -> bool {
        self.own.is_none_or(|own| own.plane.height(point) > margin)
    }
}

/// The planar surfaces of a scene without holes, with those that join them.
#[derive(Debug)]
pub(super) struct Screens {
    /// By index of the surface.
    sheets: Vec<Option<Sheet>>,
}

/// A surface of a screen.
#[derive(Debug)]
struct Sheet {
    outline: Vec<DVec3>,
    /// Unit normal.
    normal: DVec3,
    /// The surface beyond each side, if exactly one joins there.
    beyond: SmallVec<[Option<usize>; 4]>,
    /// Length that is uncertain along its border.
    uncertain: f64,
}

/// The hull of two ends.
struct Shaft<'a> {
    ends: [End<'a>; 2],
    bounds: Aabb,
    /// Length by which what touches may reach into the shaft.
    tolerance: f64,
}

impl Screens {
    /// The screens of `faces`, of which `twins` lie beyond the sides, in a scene of `surfaces` surfaces.
    pub(super) fn new(faces: &[Face], twins: &[Vec<Option<usize>>], surfaces: usize) -> Self {
        let mut sheets: Vec<Option<Sheet>> = iter::repeat_with(|| None).take(surfaces).collect();
        for (face, twins) in faces.iter().zip(twins) {
            let longest = sides(face.outline).map(|[a, b]| a.distance(b)).fold(0.0, f64::max);
            sheets[face.surface] = Some(Sheet {
                outline: face.outline.to_vec(),
                normal: face.normal,
                beyond: twins.iter().map(|twin| twin.map(|twin| faces[twin].surface)).collect(),
                uncertain: UNCERTAIN * longest,
            });
        }
        Self { sheets }
    }

    /// Whether the screen that grows from the surface `first` certainly meets all segments between the two
    /// ends, of which `segment` is one. `thin` is the narrower end's breadth.
    pub(super) fn close(&self, ends: [End; 2], first: usize, segment: [DVec3; 2], thin: f64) -> bool {
        let shaft = Shaft::new(ends, COINCIDENT * thin);
        let mut screen: SmallVec<[usize; MOST]> = SmallVec::new();
        screen.push(first);
        let (mut next, mut is_odd) = (0, false);
        while let Some(surface) = screen.get(next) {
            let Some(sheet) = self.sheets[*surface].as_ref().filter(|sheet| shaft.spares_ends(sheet)) else {
                return false;
            };
            let Some(meets) = sheet.meets(segment) else { return false };
            is_odd ^= meets;
            for (side, beyond) in sides(&sheet.outline).zip(&sheet.beyond) {
                let is_known = beyond.is_some_and(|other| screen.contains(&other) || shaft.leaves(other));
                if is_known || shaft.misses(&side) {
                    continue;
                }
                let Some(other) = beyond.filter(|_| screen.len() < MOST) else { return false };
                screen.push(other);
            }
            next += 1;
        }
        is_odd
    }
}

impl<'a> Shaft<'a> {
    fn new(ends: [End<'a>; 2], tolerance: f64) -> Self {
        let points = ends.iter().flat_map(|end| end.hull.iter().copied());
        Self { ends, bounds: Aabb::around(points), tolerance }
    }

    /// Distance from an end at which a sheet certainly does not touch it (length).
    fn clear(&self) -> f64 {
        self.tolerance + CLEAR * self.bounds.diagonal()
    }

    /// Whether one of the ends is a part of a surface.
    fn leaves(&self, surface: usize) -> bool {
        self.ends.iter().any(|end| end.surface() == Some(surface))
    }

    /// Whether a side stays out of the inside of the shaft.
    fn misses(&self, side: &[DVec3; 2]) -> bool {
        let [a, b] = self.ends.map(|end| end.hull);
        !self.bounds.overlaps(&Aabb::around(*side)) || separated(a, b, side, self.tolerance)
    }

    /// Whether a sheet meets neither end, or only the border of one that is flat.
    fn spares_ends(&self, sheet: &Sheet) -> bool {
        self.ends.iter().all(|end| match end.own {
            Some(own) => sheet.spares(end.hull, own.plane.normal, [self.tolerance, self.clear()]),
            None => separated(end.hull, end.hull, &sheet.outline, -self.clear()),
        })
    }
}

impl Sheet {
    /// Whether the sheet does not meet the inside of the flat `hull` with this `normal`: it stays beside its
    /// border to a tolerance, or `clear` of its plane (lengths).
    fn spares(&self, hull: &[DVec3], normal: DVec3, [tolerance, clear]: [f64; 2]) -> bool {
        let size = Aabb::around(hull.iter().copied()).diagonal();
        let lies_beyond = |d: DVec3| {
            let d = d.normalize_or_zero();
            let height = |x: &DVec3| x.dot(d);
            let own = hull.iter().map(height).fold(f64::INFINITY, f64::min);
            let far = hull.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            let top = self.outline.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            // Where the hull is flat across d it has no inside beyond its lowest points.
            if far - own > FLAT * size { top <= own + tolerance } else { top < own - clear }
        };
        let both = |d: DVec3| lies_beyond(d) || lies_beyond(-d);
        let across = || sides(hull).map(|[a, b]| (b - a).cross(normal));
        let crosses = || {
            let pairs = sides(hull).flat_map(|own| sides(&self.outline).map(move |other| [own, other]));
            pairs.map(|[[a, b], [c, d]]| (b - a).cross(d - c))
        };
        both(normal) || across().any(both) || both(self.normal) || crosses().any(both)
    }

    /// Whether the segment between two points meets the sheet; None where that is not certain.
    fn meets(&self, [x, y]: [DVec3; 2]) -> Option<bool> {
        let [above, below] = [x, y].map(|point| (point - self.outline[0]).dot(self.normal));
        if above.abs().min(below.abs()) <= self.uncertain {
            return None;
        }
        if above * below > 0.0 {
            return Some(false);
        }
        let at = x.lerp(y, above / (above - below));
        let is_certain = sides(&self.outline).all(|side| distance_to_segment(at, side) > self.uncertain);
        is_certain.then(|| self.surrounds(at))
    }

    /// Whether a point of its plane lies within its outline: a ray in the plane leaves it an odd number of
    /// times.
    fn surrounds(&self, point: DVec3) -> bool {
        let axis = self.normal.abs().max_position();
        let flat =
            |x: DVec3| [x[(axis + 1) % 3] - point[(axis + 1) % 3], x[(axis + 2) % 3] - point[(axis + 2) % 3]];
        let leaves = |[a, b]: &[DVec3; 2]| {
            let ([ax, ay], [bx, by]) = (flat(*a), flat(*b));
            (ay > 0.0) != (by > 0.0) && ax + (bx - ax) * ay / (ay - by) > 0.0
        };
        sides(&self.outline).filter(leaves).count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::shapes::Triangle;
    use radiosity_geom::{Ray, Surface};

    use super::*;
    use crate::convex_bodies::twins;

    /// Cells of a sheet along either direction.
    const CELLS: usize = 4;
    /// Corners of its grid along either direction.
    const CORNERS: usize = CELLS + 1;

    /// The triangles of a folded sheet over |x|, |y| < 1, whose corners have these `heights`.
    fn folded(heights: &[f64]) -> Vec<[DVec3; 3]> {
        let at = |k: usize| 2.0 * k as f64 / CELLS as f64 - 1.0;
        let corner = |i: usize, j: usize| DVec3::new(at(i), at(j), heights[CORNERS * i + j]);
        let cells = (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j)));
        cells
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect()
    }

    /// The screens of triangles.
    fn screens(triangles: &[[DVec3; 3]]) -> Screens {
        let face = |(surface, outline): (usize, &'_ [DVec3; 3])| {
            let [a, b, c] = *outline;
            (surface, (b - a).cross(c - a).normalize())
        };
        let normals: Vec<(usize, DVec3)> = triangles.iter().enumerate().map(face).collect();
        let faces: Vec<Face> = normals
            .iter()
            .zip(triangles)
            .map(|((surface, normal), outline)| Face { surface: *surface, outline, normal: *normal })
            .collect();
        Screens::new(&faces, &twins(&faces), triangles.len() + 2)
    }

    fn plane([a, b, c]: [DVec3; 3], towards: DVec3) -> Plane {
        let normal = (b - a).cross(c - a).normalize();
        Plane { point: a, normal: normal * normal.dot(towards - a).signum() }
    }

    fn middle(points: &[DVec3]) -> DVec3 {
        points.iter().sum::<DVec3>() / points.len() as f64
    }

    /// Whether some screen of the triangles closes the shaft of two triangles that face each other.
    fn is_closed(triangles: &[[DVec3; 3]], a: [DVec3; 3], b: [DVec3; 3]) -> bool {
        let n = triangles.len();
        let ends = [End::on(n, plane(a, middle(&b)), &a), End::on(n + 1, plane(b, middle(&a)), &b)];
        // Beside the middles, which may see each other through a corner or a side.
        let (screens, segment) = (screens(triangles), [point(a, [0.31, 0.37]), point(b, [0.29, 0.41])]);
        (0..n).any(|first| screens.close(ends, first, segment, 0.1))
    }

    /// A point of a triangle.
    fn point([a, b, c]: [DVec3; 3], [u, v]: [f64; 2]) -> DVec3 {
        let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
        a + (b - a) * u + (c - a) * v
    }

    fn is_met(triangles: &[Triangle], x: DVec3, y: DVec3) -> bool {
        let ray = Ray { origin: x, direction: y - x, range: [0.0, 1.0] };
        triangles.iter().any(|triangle| triangle.occludes(&ray))
    }

    fn end(height: f64) -> impl Strategy<Value = [DVec3; 3]> {
        let at = prop::array::uniform2(-0.6..0.6f64);
        let corners = prop::array::uniform3(prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array));
        (at, 0.05..0.9f64, corners).prop_filter_map("has area", move |([x, y], size, corners)| {
            let corners = corners.map(|c| DVec3::new(x, y, height) + size * c * DVec3::new(1.0, 1.0, 0.3));
            let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
            (area > 0.1 * size * size).then_some(corners)
        })
    }

    fn heights() -> impl Strategy<Value = Vec<f64>> {
        (0.0..0.6f64, prop::collection::vec(-1.0..1.0f64, CORNERS * CORNERS))
            .prop_map(|(bend, heights)| heights.iter().map(|h| bend * h).collect())
    }

    const LOW: [DVec3; 3] =
        [DVec3::new(-0.3, -0.2, -1.0), DVec3::new(0.3, -0.2, -1.0), DVec3::new(0.0, 0.3, -1.0)];
    const HIGH: [DVec3; 3] =
        [DVec3::new(-0.3, -0.2, 1.0), DVec3::new(0.3, -0.2, 1.0), DVec3::new(0.0, 0.3, 1.2)];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        /// No segment passes a screen that is told to close, be a triangle missing or bumps as high as ends.
        #[test]
        fn what_a_screen_closes_no_segment_passes(
            heights in heights(), a in end(-0.9), b in end(0.9), missing in 0..4 * CELLS * CELLS,
            places in prop::collection::vec(prop::array::uniform4(0.0..1.0f64), 500),
        ) {
            let mut triangles = folded(&heights);
            if missing < triangles.len() {
                triangles.remove(missing);
            }
            prop_assume!(is_closed(&triangles, a, b));
            let shapes: Vec<Triangle> =
                triangles.iter().filter_map(|triangle| Triangle::new(*triangle).ok()).collect();
            let (front, back) = (plane(a, middle(&b)), plane(b, middle(&a)));
            for [p, q, r, s] in places {
                let (x, y) = (point(a, [p, q]), point(b, [r, s]));
                if front.height(y) > 0.0 && back.height(x) > 0.0 {
                    prop_assert!(is_met(&shapes, x, y), "{x} and {y} see each other");
                }
            }
        }

        /// A folded sheet that is wide enough closes; not with a slit, however narrow, across the shaft.
        #[test]
        fn a_slit_is_found(heights in heights(), slit in -7.0..-1.0f64, height in -0.4..0.4f64) {
            let whole = folded(&heights);
            prop_assert!(is_closed(&whole, LOW, HIGH));
            // The middle line of the grid lies within the shaft.
            let flat: Vec<[DVec3; 3]> = folded(&[height; CORNERS * CORNERS]);
            let shift = |triangle: &[DVec3; 3]| {
                let moved = if middle(triangle).x > 0.0 { 10f64.powf(slit) } else { 0.0 };
                triangle.map(|corner| corner + moved * DVec3::X)
            };
            prop_assert!(is_closed(&flat, LOW, HIGH));
            prop_assert!(!is_closed(&flat.iter().map(shift).collect::<Vec<_>>(), LOW, HIGH));
        }
    }

    /// A fin of two sides and a tip, as high as `top`, across the shaft.
    fn fin(top: f64) -> Vec<[DVec3; 3]> {
        let profile = [[-0.1, -9.0], [-0.1, top], [0.1, top], [0.1, -9.0]];
        let quads = profile.windows(2).map(|side| {
            let corner = |[z, x]: [f64; 2], y: f64| DVec3::new(x, y, z);
            [corner(side[0], -2.0), corner(side[1], -2.0), corner(side[1], 2.0), corner(side[0], 2.0)]
        });
        quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect()
    }

    #[test]
    fn a_fin_hides_unless_its_tip_reaches_into_the_shaft() {
        assert!(is_closed(&fin(0.3 + 1e-6), LOW, HIGH));
        assert!(!is_closed(&fin(0.3 - 1e-6), LOW, HIGH));
        assert!(!is_closed(&fin(-0.4), LOW, HIGH));
    }

    #[test]
    fn what_stands_on_an_end_does_not_hide_it() {
        // A sheet through the lower end: to its left all is hidden, to its right all is seen.
        let through = [[-0.1, -1.0], [-0.1, -0.5], [9.0, -0.5]];
        let quads = through.windows(2).map(|side| {
            let corner = |[x, z]: [f64; 2], y: f64| DVec3::new(x, y, z);
            [corner(side[0], -2.0), corner(side[1], -2.0), corner(side[1], 2.0), corner(side[0], 2.0)]
        });
        let sheet: Vec<[DVec3; 3]> = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        assert!(!is_closed(&sheet, LOW, HIGH));
        let beside: Vec<[DVec3; 3]> =
            sheet.iter().map(|triangle| triangle.map(|corner| corner - 0.3 * DVec3::X)).collect();
        assert!(is_closed(&beside, LOW, HIGH));
    }
}
