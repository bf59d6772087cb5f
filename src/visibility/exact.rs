//! Direct light of a uniform planar emitter at a point, exact with planar blockers.
//!
//! Lambert's closed form: a polygon of exitance 1 with corners v_k in front of the horizon of x gives
//!
//! ```text
//! E(x) = 1/(2π) | Σ_k θ_k n·(a_k × a_{k+1}) / |a_k × a_{k+1}| | ,   a_k = v_k − x ,   θ_k = ∠(a_k, a_{k+1})
//! ```
//!
//! What a convex polygon hides of another from x is the part inside the pyramid from x over its edges, beyond its
//! plane. The rest is convex pieces again: plane after plane of the pyramid, keep what lies outside and go on with
//! what lies inside. Blockers are subtracted one after the other, so overlapping shadows count once.

use core::f64::consts::TAU;

use radiosity_geom::{DVec3, clip_polygon};

/// Points within this part of their distance from a bounding plane count as touching it.
const TOUCHING: f64 = 1e-9;

/// Points within this part of the polygon's reach from a plane lie on it.
const ON_PLANE: f64 = 1e-12;

/// Irradiance at `x` with unit normal `n` from a polygon of exitance 1, wholly visible; what lies behind the
/// horizon is left out.
pub fn irradiance(x: DVec3, n: DVec3, polygon: &[DVec3]) -> f64 {
    match polygon.iter().all(|corner| (corner - x).dot(n) >= 0.0) {
        true => around(x, n, polygon),
        false => around(x, n, &clip_polygon(polygon, x, n)),
    }
}

/// Lambert's sum along the sides of a polygon above the horizon.
fn around(x: DVec3, n: DVec3, above: &[DVec3]) -> f64 {
    let term = |(v, w): (&DVec3, &DVec3)| {
        let (a, b) = (v - x, w - x);
        let cross = a.cross(b);
        let sine = cross.length();
        // A side seen end on subtends no angle.
        if sine > 0.0 { sine.atan2(a.dot(b)) * n.dot(cross) / sine } else { 0.0 }
    };
    let sum: f64 = above.iter().zip(above.iter().cycle().skip(1)).map(term).sum();
    sum.abs() / TAU
}

/// What is left of the convex `polygon` outside all `pyramids`, as convex polygons.
pub fn outside_all<'a>(polygon: &[DVec3], pyramids: impl Iterator<Item = &'a Pyramid>) -> Vec<Vec<DVec3>> {
    let mut parts = vec![polygon.to_vec()];
    for pyramid in pyramids {
        parts = parts.into_iter().flat_map(|part| pyramid.outside(part)).collect();
        if parts.is_empty() {
            break;
        }
    }
    parts
}

/// The part of the convex `polygon` inside any of `pyramids`, as convex polygons that do not overlap; and whether that is
/// all of it.
pub fn inside_any(polygon: &[DVec3], pyramids: &[Pyramid]) -> (Vec<Vec<DVec3>>, bool) {
    let (mut hidden, mut rest) = (Vec::new(), vec![polygon.to_vec()]);
    for pyramid in pyramids {
        let mut kept = Vec::new();
        for part in rest {
            let (outside, inside) = pyramid.divided(part);
            kept.extend(outside);
            hidden.extend(inside);
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
    /// A point of each bounding plane and its inward unit normal.
    planes: Vec<(DVec3, DVec3)>,
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
        let side = |k: usize| {
            let inward = (polygon[k] - x).cross(polygon[(k + 1) % polygon.len()] - x).normalize_or_zero();
            (x, if inward.dot(middle - x) < 0.0 { -inward } else { inward })
        };
        let beyond = (middle, normal * height.signum());
        let planes = (0..polygon.len()).map(side).chain([beyond]).filter(|plane| plane.1 != DVec3::ZERO);
        Some(Self { planes: planes.collect() })
    }

    /// Whether it hides the convex hull of `points`; what merely touches a bounding plane lies outside it.
    pub fn cover(&self, points: &[DVec3]) -> Cover {
        let mut cover = Cover::Hidden;
        for (point, inward) in &self.planes {
            let (mut low, mut high, mut reach) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
            for x in points {
                let offset = x - point;
                let height = offset.dot(*inward);
                (low, high, reach) = (low.min(height), high.max(height), reach.max(offset.length_squared()));
            }
            let tolerance = TOUCHING * reach.sqrt();
            if high <= tolerance {
                return Cover::Clear;
            }
            if low < -tolerance {
                cover = Cover::Mixed;
            }
        }
        cover
    }

    /// Whether it hides the point `y`.
    pub fn hides(&self, y: DVec3) -> bool {
        self.planes.iter().all(|(point, inward)| (y - point).dot(*inward) > 0.0)
    }

    /// The s between which it hides the points `start` + s `along` of a line.
    pub fn shadow_on(&self, start: DVec3, along: DVec3) -> Option<[f64; 2]> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (point, inward) in &self.planes {
            let (height, slope) = ((start - point).dot(*inward), along.dot(*inward));
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

    /// The parts of a convex polygon outside the pyramid.
    fn outside(&self, polygon: Vec<DVec3>) -> Vec<Vec<DVec3>> {
        self.divided(polygon).0
    }

    /// The parts of a convex polygon outside the pyramid, and the one inside it.
    fn divided(&self, polygon: Vec<DVec3>) -> (Vec<Vec<DVec3>>, Option<Vec<DVec3>>) {
        match self.cover(&polygon) {
            Cover::Clear => return (vec![polygon], None),
            Cover::Hidden => return (Vec::new(), Some(polygon)),
            Cover::Mixed => {}
        }
        let mut kept = Vec::new();
        let mut inside = polygon;
        for plane in &self.planes {
            let [outer, inner] = split(inside, *plane);
            kept.extend((outer.len() > 2).then_some(outer));
            inside = inner;
            if inside.len() < 3 {
                return (kept, None);
            }
        }
        (kept, Some(inside))
    }
}

/// The parts of a convex polygon outside and inside a plane, given by a point and its inward unit normal; as
/// [`radiosity_geom::clip_polygon`] on either side, but with the heights computed once. An empty part has no corners.
fn split(polygon: Vec<DVec3>, (point, inward): (DVec3, DVec3)) -> [Vec<DVec3>; 2] {
    let heights = polygon.iter().map(|x| (*x - point).dot(inward));
    let (low, high) = heights.fold((f64::MAX, f64::MIN), |(low, high), h| (low.min(h), high.max(h)));
    let reach = polygon.iter().map(|x| x.distance_squared(point)).fold(0.0, f64::max).sqrt();
    let tolerance = ON_PLANE * reach;
    if low >= -tolerance {
        return [Vec::new(), polygon];
    }
    if high <= tolerance {
        return [polygon, Vec::new()];
    }
    let mut parts = [0, 1].map(|_| Vec::with_capacity(polygon.len() + 1));
    let height = |x: DVec3| {
        let h = (x - point).dot(inward);
        if h.abs() <= tolerance { 0.0 } else { h }
    };
    let mut previous = (polygon[polygon.len() - 1], height(polygon[polygon.len() - 1]));
    for x in polygon {
        let h = height(x);
        if previous.1 * h < 0.0 {
            let crossing = previous.0.lerp(x, previous.1 / (previous.1 - h));
            parts.iter_mut().for_each(|part| part.push(crossing));
        }
        if h <= 0.0 {
            parts[0].push(x);
        }
        if h >= 0.0 {
            parts[1].push(x);
        }
        previous = (x, h);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square(center: DVec3, half: f64) -> Vec<DVec3> {
        [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]]
            .map(|[x, y]| center + half * DVec3::new(x, y, 0.0))
            .to_vec()
    }

    fn seen(x: DVec3, lamp: &[DVec3], blockers: &[Vec<DVec3>]) -> f64 {
        let pyramids: Vec<Pyramid> = blockers.iter().filter_map(|b| Pyramid::over(b, x)).collect();
        outside_all(lamp, pyramids.iter()).iter().map(|part| irradiance(x, DVec3::Z, part)).sum()
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
