//! Direct light of a uniform planar emitter at a point, exact with planar blockers.
//!
//! Lambert's closed form: a polygon of exitance 1 with corners v_k in front of the horizon of x gives
//!
//! ```text
//! E(x) = 1/(2π) | Σ_k θ_k n·(a_k × a_{k+1}) / |a_k × a_{k+1}| | ,   a_k = v_k − x ,   θ_k = ∠(a_k, a_{k+1})
//! ```
//!
//! What a convex polygon hides of another from x is the part inside the pyramid from x over its edges, beyond its
//! plane. With C₁, C₂, … what the blockers hide, and F the form of a polygon outside all of them,
//!
//! ```text
//! F(P; C₁, C₂, …) = F(P; C₂, …) − F(P ∩ C₁; C₂, …) ,
//! ```
//!
//! so that a single blocker costs two polygons. Where many overlap, P \ C₁ is cut into convex pieces instead, plane after
//! plane of the pyramid. Either way overlapping shadows count once.

use core::f64::consts::TAU;
use core::iter;

use radiosity_geom::DVec3;
use smallvec::SmallVec;

/// Points within this part of their distance from a bounding plane count as touching it.
const TOUCHING: f64 = 1e-9;

/// Points within this part of their distance from a plane that cuts a polygon count as lying on it.
const ON_PLANE: f64 = 1e-12;

/// Overlapping blockers up to which what they hide in common is subtracted and added.
const FEW: usize = 4;

/// Corners of a convex polygon as seen from a point, which is the origin.
type Corners = SmallVec<[DVec3; 8]>;

/// A number for each of them.
type Heights = SmallVec<[f64; 8]>;

/// The half-space a·inward > depth of what is seen from a point.
#[derive(Clone, Copy, Debug)]
struct Plane {
    /// Unit normal.
    inward: DVec3,
    depth: f64,
}

impl Plane {
    fn height(&self, a: DVec3) -> f64 {
        a.dot(self.inward) - self.depth
    }

    /// Heights of the corners of a polygon; zero where rounding decides.
    fn heights(&self, polygon: &[DVec3]) -> Heights {
        let reach = polygon.iter().map(|a| a.length_squared()).fold(0.0, f64::max).sqrt();
        let height = |a: &DVec3| {
            let h = self.height(*a);
            if h.abs() <= ON_PLANE * reach { 0.0 } else { h }
        };
        polygon.iter().map(height).collect()
    }

    /// Leaves the part inside of a convex polygon; nothing where it merely touches the plane.
    fn cut(&self, polygon: &mut Corners) {
        let heights = self.heights(polygon);
        if !heights.iter().any(|h| *h > 0.0) {
            polygon.clear();
        } else if heights.iter().any(|h| *h < 0.0) {
            *polygon = kept(polygon, heights.iter().copied());
        }
    }
}

/// The part of a convex polygon where its corners' heights, some of them positive, are not below zero.
fn kept(polygon: &[DVec3], heights: impl Iterator<Item = f64> + Clone) -> Corners {
    let mut kept = Corners::new();
    let before = polygon.iter().zip(heights.clone()).cycle().skip(polygon.len() - 1);
    for ((a, h), (previous, height)) in polygon.iter().zip(heights).zip(before) {
        if height * h < 0.0 {
            kept.push(previous.lerp(*a, height / (height - h)));
        }
        if h >= 0.0 {
            kept.push(*a);
        }
    }
    kept
}

/// Irradiance at `x` with unit normal `n` from a convex planar polygon of exitance 1, wholly visible; what lies behind the
/// horizon is left out.
pub fn irradiance(x: DVec3, n: DVec3, polygon: &[DVec3]) -> f64 {
    visible_irradiance(x, n, polygon, [].iter())
}

/// The same from the part of the polygon that no pyramid, all of them from x, hides.
pub fn visible_irradiance<'a>(
    x: DVec3,
    n: DVec3,
    polygon: &[DVec3],
    pyramids: impl Iterator<Item = &'a Pyramid>,
) -> f64 {
    let mut corners: Corners = polygon.iter().map(|corner| corner - x).collect();
    if corners.iter().all(|a| a.dot(n) >= 0.0) {
        return outside(n, &corners, pyramids);
    }
    Plane { inward: n, depth: 0.0 }.cut(&mut corners);
    outside(n, &corners, pyramids)
}

/// From the part of a polygon above the horizon outside pyramids.
fn outside<'a>(n: DVec3, polygon: &[DVec3], pyramids: impl Iterator<Item = &'a Pyramid>) -> f64 {
    let mut mixed: SmallVec<[&Pyramid; 8]> = SmallVec::new();
    for pyramid in pyramids {
        match pyramid.cover_seen(polygon) {
            Cover::Clear => {}
            Cover::Hidden => return 0.0,
            Cover::Mixed => mixed.push(pyramid),
        }
    }
    let Some((first, rest)) = mixed.split_first() else { return lambert(n, polygon) };
    let rest = || rest.iter().copied();
    if mixed.len() > FEW {
        return first.divided(polygon).0.iter().map(|part| outside(n, part, rest())).sum();
    }
    let mut hidden = Corners::from_slice(polygon);
    first.planes.iter().for_each(|plane| plane.cut(&mut hidden));
    (outside(n, polygon, rest()) - outside(n, &hidden, rest())).max(0.0)
}

/// Lambert's sum along the sides of a polygon above the horizon.
fn lambert(n: DVec3, polygon: &[DVec3]) -> f64 {
    let Some(mut a) = polygon.last().copied() else { return 0.0 };
    let mut sum = 0.0;
    for &b in polygon {
        let cross = a.cross(b);
        let sine = cross.length();
        // A side seen end on subtends no angle.
        if sine > 0.0 {
            sum += sine.atan2(a.dot(b)) * n.dot(cross) / sine;
        }
        a = b;
    }
    sum.abs() / TAU
}

/// The part of the convex `polygon` inside any of `pyramids`, all of them from one point, as convex polygons that do not
/// overlap; and whether that is all of it.
pub fn inside_any(polygon: &[DVec3], pyramids: &[Pyramid]) -> (Vec<Vec<DVec3>>, bool) {
    let Some(&Pyramid { eye, .. }) = pyramids.first() else { return (Vec::new(), false) };
    let back = |part: &[DVec3]| -> Vec<DVec3> { part.iter().map(|a| a + eye).collect() };
    let whole: Corners = polygon.iter().map(|corner| corner - eye).collect();
    let (mut hidden, mut rest) = (Vec::new(), vec![whole]);
    for pyramid in pyramids {
        let mut kept = Vec::new();
        for part in rest {
            match pyramid.cover_seen(&part) {
                Cover::Clear => kept.push(part),
                Cover::Hidden => hidden.push(back(&part)),
                Cover::Mixed => {
                    let (outer, inner) = pyramid.divided(&part);
                    kept.extend(outer);
                    hidden.extend((inner.len() > 2).then(|| back(&inner)));
                }
            }
        }
        rest = kept;
        if rest.is_empty() {
            return (hidden, true);
        }
    }
    (hidden, false)
}

/// How a set of points stands to what a blocker hides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// Nothing of its convex hull is hidden.
    Clear,
    /// All of it is hidden.
    Hidden,
    /// Some of it may be.
    Mixed,
}

/// The region that a convex polygon hides from a point: inside all of these half-spaces.
#[derive(Clone, Debug)]
pub struct Pyramid {
    eye: DVec3,
    planes: SmallVec<[Plane; 5]>,
}

impl Pyramid {
    /// What the convex `polygon` hides from `x`; None where x lies in its plane and nothing is hidden.
    pub fn over(polygon: &[DVec3], x: DVec3) -> Option<Self> {
        let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
        let normal: DVec3 =
            polygon.windows(2).map(|side| (side[0] - polygon[0]).cross(side[1] - polygon[0])).sum();
        let normal = normal.normalize_or_zero();
        let height = (middle - x).dot(normal);
        if height.abs() <= 1e-9 * middle.distance(x) {
            return None;
        }
        let sides = (0..polygon.len()).map(|k| [polygon[k], polygon[(k + 1) % polygon.len()]]);
        Some(Self::bounded(x, middle, sides, iter::once((normal * height.signum(), height.abs()))))
    }

    /// What lies within the planes through `x` and each of `sides`, on the side of `middle`, and beyond each of the planes
    /// of `beyond`, given by unit normals away from x and distances from it.
    pub(super) fn bounded(
        x: DVec3,
        middle: DVec3,
        sides: impl Iterator<Item = [DVec3; 2]>,
        beyond: impl Iterator<Item = (DVec3, f64)>,
    ) -> Self {
        let side = |[a, b]: [DVec3; 2]| {
            let inward = (a - x).cross(b - x).normalize_or_zero();
            Plane { inward: if inward.dot(middle - x) < 0.0 { -inward } else { inward }, depth: 0.0 }
        };
        let sides = sides.map(side).filter(|plane| plane.inward != DVec3::ZERO);
        let beyond = beyond.map(|(inward, depth)| Plane { inward, depth });
        Self { eye: x, planes: sides.chain(beyond).collect() }
    }

    /// Whether it hides the convex hull of `points`, which the ball of `radius` around `center` holds; what merely touches a
    /// bounding plane lies outside it.
    pub fn cover(&self, points: &[DVec3], center: DVec3, radius: f64) -> Cover {
        let middle = center - self.eye;
        // Planes that cross the ball.
        let mut open: SmallVec<[&Plane; 9]> = SmallVec::new();
        for plane in &self.planes {
            let height = plane.height(middle);
            if height <= -radius {
                return Cover::Clear;
            }
            if height < radius {
                open.push(plane);
            }
        }
        if open.is_empty() {
            return Cover::Hidden;
        }
        let seen: Corners = points.iter().map(|y| y - self.eye).collect();
        cover_by(open.into_iter(), &seen)
    }

    /// How the convex hull of `points` stands to what it hides.
    pub fn cover_of(&self, points: &[DVec3]) -> Cover {
        let seen: Corners = points.iter().map(|y| y - self.eye).collect();
        self.cover_seen(&seen)
    }

    /// The same of points as seen from the eye.
    fn cover_seen(&self, points: &[DVec3]) -> Cover {
        cover_by(self.planes.iter(), points)
    }

    /// Whether it hides the point `y`.
    pub fn hides(&self, y: DVec3) -> bool {
        self.planes.iter().all(|plane| plane.height(y - self.eye) > 0.0)
    }

    /// The s between which it hides the points `start` + s `along` of a line.
    pub fn shadow_on(&self, start: DVec3, along: DVec3) -> Option<[f64; 2]> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for plane in &self.planes {
            let (height, slope) = (plane.height(start - self.eye), along.dot(plane.inward));
            if slope > 0.0 {
                low = low.max(-height / slope);
            } else if slope < 0.0 {
                high = high.min(-height / slope);
            } else if height <= 0.0 {
                return None;
            }
        }
        (low < high).then_some([low, high])
    }

    /// What it leaves of a convex polygon, as convex polygons, and what it hides.
    fn divided(&self, polygon: &[DVec3]) -> (SmallVec<[Corners; 5]>, Corners) {
        let mut parts: SmallVec<[Corners; 5]> = SmallVec::new();
        let mut inside = Corners::from_slice(polygon);
        for plane in &self.planes {
            let heights = plane.heights(&inside);
            if heights.iter().any(|h| *h < 0.0) {
                parts.push(kept(&inside, heights.iter().map(|h| -h)));
                plane.cut(&mut inside);
            }
        }
        parts.retain(|part| part.len() > 2);
        (parts, inside)
    }
}

/// How the convex hull of points stands to the half-spaces of some planes together.
fn cover_by<'a>(planes: impl Iterator<Item = &'a Plane>, points: &[DVec3]) -> Cover {
    let reach = points.iter().map(|a| a.length_squared()).fold(0.0, f64::max);
    let tolerance = TOUCHING * reach.sqrt();
    let mut cover = Cover::Hidden;
    for plane in planes {
        let (low, high) = range(points.iter().map(|a| plane.height(*a)));
        if high <= tolerance {
            return Cover::Clear;
        }
        if low < -tolerance {
            cover = Cover::Mixed;
        }
    }
    cover
}

/// The least and the greatest.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use radiosity_geom::clip_polygon;

    fn square(center: DVec3, half: f64) -> Vec<DVec3> {
        [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]]
            .map(|[x, y]| center + half * DVec3::new(x, y, 0.0))
            .to_vec()
    }

    fn seen(x: DVec3, lamp: &[DVec3], blockers: &[Vec<DVec3>]) -> f64 {
        let pyramids: Vec<Pyramid> = blockers.iter().filter_map(|b| Pyramid::over(b, x)).collect();
        visible_irradiance(x, DVec3::Z, lamp, pyramids.iter())
    }

    /// Below the corner of a rectangle a × b at distance c, with A = a/c, B = b/c:
    /// F = 1/(2π) [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))].
    #[test]
    fn rectangle_above_its_corner() {
        for (a, b) in [(1.0f64, 1.0f64), (0.3, 2.0), (20.0, 5.0)] {
            let lamp = [[0., 0.], [a, 0.], [a, b], [0., b]].map(|[x, y]| DVec3::new(x, y, 1.0));
            let half = |a: f64, b: f64| a / a.hypot(1.0) * (b / a.hypot(1.0)).atan();
            let exact = (half(a, b) + half(b, a)) / TAU;
            assert!((irradiance(DVec3::ZERO, DVec3::Z, &lamp) - exact).abs() < 1e-15);
        }
    }

    #[test]
    fn behind_the_horizon_is_dark() {
        let wall = [[1., -1., -1.], [1., 1., -1.], [1., 1., 1.], [1., -1., 1.]].map(DVec3::from_array);
        let upper = [[1., -1., 0.], [1., 1., 0.], [1., 1., 1.], [1., -1., 1.]].map(DVec3::from_array);
        let above = irradiance(DVec3::ZERO, DVec3::Z, &upper);
        assert!(above > 0.05);
        assert!((irradiance(DVec3::ZERO, DVec3::Z, &wall) - above).abs() < 1e-15);
        assert_eq!(irradiance(DVec3::ZERO, DVec3::Z, &square(-DVec3::Z, 1.0)), 0.0);
    }

    #[test]
    fn overlapping_blockers_count_once() {
        let lamp = square(DVec3::new(0., 0., 2.), 0.5);
        let plate = square(DVec3::new(1., 0., 1.), 1.0);
        let free = seen(DVec3::ZERO, &lamp, &[]);
        let half = seen(DVec3::ZERO, &lamp, std::slice::from_ref(&plate));
        assert!((half - 0.5 * free).abs() < 1e-15, "the plate hides the half with x > 0");
        let twice = seen(DVec3::ZERO, &lamp, &[plate.clone(), plate.clone()]);
        assert!((twice - half).abs() < 1e-15);
        let both = seen(DVec3::ZERO, &lamp, &[plate.clone(), square(DVec3::new(-1., 0., 1.5), 1.0)]);
        assert!(both.abs() < 1e-15);
        let plates: Vec<_> = (0..12)
            .map(|k| square(DVec3::new(1., 0.3 * f64::from(k % 3), 1.0 + 0.01 * f64::from(k)), 1.0))
            .collect();
        let of_many = seen(DVec3::ZERO, &lamp, &plates);
        let at_once = square(DVec3::new(1., 0.3, 1.0), 1.3);
        let of_one = seen(DVec3::ZERO, &lamp, &[at_once]);
        assert!(
            of_many <= half && of_many >= of_one,
            "twelve plates {of_many}, one {half}, a larger one {of_one}"
        );
        let behind = seen(DVec3::ZERO, &lamp, &[square(DVec3::new(0., 0., 3.), 2.0)]);
        assert!((behind - free).abs() < 1e-15);
    }

    proptest! {
        /// Light that a blocker lets pass, and light that would pass only through its outline, make up all of it.
        #[test]
        fn a_blocker_and_its_outline_share_the_light(
            x in (-1.0..1.0, -1.0..1.0), center in (-1.0..1.0, -1.0..1.0, 0.3..1.7), half in 0.1..0.8,
        ) {
            let x = DVec3::new(x.0, x.1, 0.0);
            let lamp = square(DVec3::new(0., 0., 2.), 0.7);
            let plate = square(DVec3::new(center.0, center.1, center.2), half);
            // The shadow of the plate in the plane of the lamp.
            let shadow: Vec<DVec3> = plate.iter().map(|p| x + (*p - x) * (2.0 / center.2)).collect();
            let mut through = lamp.clone();
            for k in 0..4 {
                let inward = DVec3::Z.cross(shadow[(k + 1) % 4] - shadow[k]);
                through = clip_polygon(&through, shadow[k], inward);
            }
            let hidden = if through.len() > 2 { irradiance(x, DVec3::Z, &through) } else { 0.0 };
            let passed = seen(x, &lamp, &[plate]);
            prop_assert!((hidden + passed - irradiance(x, DVec3::Z, &lamp)).abs() < 1e-14);
        }
    }
}
