//! Shadow volumes: the pyramid with its tip at a point, cut off at a convex blocker, that the blocker hides.
//!
//! Its planes are those through the point and the sides of the outline, and those of the blocker's front
//! faces. In terms of a = y − x each is an inequality a·inward > depth. What lies wholly outside one plane is
//! clear; what lies inside all planes is hidden. A quadrilateral with corners m ± a ± b + (±)(±) c extends
//! along n, and likewise against it, up to
//!
//! ```text
//! n·m + max(|n·a + n·b| + n·c, |n·a − n·b| − n·c)
//! ```

use core::iter;

use radiosity_geom::{COINCIDENT, DVec3, ROUNDING, clip_by_heights};
use smallvec::SmallVec;

use crate::bounding_ball::Ball;

/// Planes that are stored without allocation: enough for most shadow volumes, also of a block.
const PLANES: usize = 10;

/// Corners of a convex polygon relative to a point.
pub type Corners = SmallVec<[DVec3; 8]>;

/// One height per corner.
type Heights = SmallVec<[f64; 8]>;

/// The half-space a·inward > depth, a relative to a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfSpace {
    /// Unit normal.
    pub inward: DVec3,
    /// Distance of its plane from the point (scene length).
    pub depth: f64,
}

impl HalfSpace {
    fn height(&self, a: DVec3) -> f64 {
        a.dot(self.inward) - self.depth
    }

    /// Heights of the corners of a polygon no farther from the point than `reach`; zero within rounding.
    fn heights(&self, polygon: &[DVec3], reach: f64) -> Heights {
        let height = |a: &DVec3| {
            let h = self.height(*a);
            if h.abs() <= ROUNDING * reach { 0.0 } else { h }
        };
        polygon.iter().map(height).collect()
    }

    /// Cuts off the part of a convex polygon outside the plane; empties a polygon that only touches it.
    fn cut(&self, polygon: &mut Corners, reach: f64) {
        let heights = self.heights(polygon, reach);
        if !heights.iter().any(|h| *h > 0.0) {
            polygon.clear();
        } else if heights.iter().any(|h| *h < 0.0) {
            *polygon = kept(polygon, &heights);
        }
    }
}

/// Cuts a convex polygon at the horizon of unit normal `n`; empties a polygon that only touches it.
pub fn cut_at_horizon(n: DVec3, polygon: &mut Corners) {
    let reach = reach(polygon);
    HalfSpace { inward: n, depth: 0.0 }.cut(polygon, reach);
}

/// Largest distance of a corner from the point.
pub fn reach(polygon: &[DVec3]) -> f64 {
    let longer =
        |longest: f64, a: &DVec3| if a.length_squared() > longest { a.length_squared() } else { longest };
    polygon.iter().fold(0.0, longer).sqrt()
}

/// The part of a convex polygon of height ≥ 0, given the heights of its corners, some of them positive.
fn kept(polygon: &[DVec3], heights: &[f64]) -> Corners {
    let mut kept = Corners::new();
    clip_by_heights(polygon, heights, |a| kept.push(a));
    kept
}

/// Position of a set of points relative to a shadow volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coverage {
    /// No point of its convex hull is hidden.
    Clear,
    /// All of it is hidden.
    Hidden,
    /// A part may be hidden.
    Mixed,
}

/// A quadrilateral with corners m ± a ± b + (±)(±) c, of which two may coincide.
#[derive(Clone, Copy, Debug)]
pub struct Quad {
    /// Mean m of the corners.
    middle: DVec3,
    /// a, b and c.
    axes: [DVec3; 3],
}

impl Quad {
    /// The quadrilateral with these corners, in order.
    pub fn new([p, q, r, s]: [DVec3; 4]) -> Self {
        let axes = [q + r - p - s, r + s - p - q, p + r - q - s].map(|axis| 0.25 * axis);
        Self { middle: 0.25 * (p + q + r + s), axes }
    }

    /// Extents of the quadrilateral from its mean corner against and along the unit vector `n`.
    fn reach(&self, n: DVec3) -> [f64; 2] {
        let [a, b, c] = self.axes.map(|axis| axis.dot(n));
        let (sum, difference) = ((a + b).abs(), (a - b).abs());
        let larger = |x: f64, y: f64| if x > y { x } else { y };
        [larger(sum - c, difference + c), larger(sum + c, difference - c)]
    }

    /// Largest distance of a corner from their mean.
    pub fn radius(&self) -> f64 {
        let [a, b, c] = self.axes;
        let corners = [a + b + c, b - a - c, c - a - b, a - b - c];
        corners.iter().map(|x| x.length_squared()).fold(0.0, f64::max).sqrt()
    }
}

/// A shadow volume: the intersection of half-spaces that is hidden from a point.
#[derive(Clone, Debug)]
pub struct ShadowVolume {
    eye: DVec3,
    planes: SmallVec<[HalfSpace; PLANES]>,
}

impl ShadowVolume {
    /// The shadow volume of the convex `polygon` from `x`; None where x lies in its plane and nothing is
    /// hidden.
    pub fn over(polygon: &[DVec3], x: DVec3) -> Option<Self> {
        let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
        let normal: DVec3 =
            polygon.windows(2).map(|side| (side[0] - polygon[0]).cross(side[1] - polygon[0])).sum();
        let normal = normal.normalize_or_zero();
        let height = (middle - x).dot(normal);
        if height.abs() <= COINCIDENT * middle.distance(x) {
            return None;
        }
        let sides = (0..polygon.len()).map(|k| [polygon[k], polygon[(k + 1) % polygon.len()]]);
        let front = HalfSpace { inward: normal * height.signum(), depth: height.abs() };
        Some(Self::bounded(x, middle, sides, iter::once(front)))
    }

    /// The region inside the planes through `x` and each of `sides`, on the side of `middle`, and in the
    /// half-spaces `beyond`, relative to x.
    pub(crate) fn bounded(
        x: DVec3,
        middle: DVec3,
        sides: impl Iterator<Item = [DVec3; 2]>,
        beyond: impl Iterator<Item = HalfSpace>,
    ) -> Self {
        let side = |[a, b]: [DVec3; 2]| {
            let inward = (a - x).cross(b - x).normalize_or_zero();
            HalfSpace { inward: if inward.dot(middle - x) < 0.0 { -inward } else { inward }, depth: 0.0 }
        };
        let sides = sides.map(side).filter(|plane| plane.inward != DVec3::ZERO);
        let mut planes: SmallVec<[HalfSpace; PLANES]> = sides.collect();
        planes.extend(beyond);
        Self { eye: x, planes }
    }

    /// Whether a ball lies wholly outside one of the planes.
    pub fn misses(&self, ball: &Ball) -> bool {
        let middle = ball.center() - self.eye;
        self.planes.iter().any(|plane| plane.height(middle) <= -ball.radius())
    }

    /// Position, relative to the volume, of the convex hull of `points`, which the ball of `radius` about
    /// `center` contains. What only touches a plane lies outside it.
    pub fn coverage(&self, points: &[DVec3], center: DVec3, radius: f64) -> Coverage {
        let middle = center - self.eye;
        // Planes that cross the ball; the one most likely to have all points outside comes first.
        let mut open: SmallVec<[&HalfSpace; PLANES]> = SmallVec::new();
        let mut lowest = f64::INFINITY;
        for plane in &self.planes {
            let height = plane.height(middle);
            if height <= -radius {
                return Coverage::Clear;
            }
            if height < radius {
                open.push(plane);
            }
            if height < lowest.min(radius) {
                lowest = height;
                let last = open.len() - 1;
                open.swap(0, last);
            }
        }
        if open.is_empty() {
            return Coverage::Hidden;
        }
        let seen: Corners = points.iter().map(|y| y - self.eye).collect();
        coverage_by(open.into_iter(), &seen, reach(&seen))
    }

    /// As [`ShadowVolume::coverage`], for a quadrilateral within `radius` of its mean corner.
    pub fn coverage_of_quad(&self, quad: &Quad, radius: f64) -> Coverage {
        let middle = quad.middle - self.eye;
        let tolerance = COINCIDENT * (middle.abs().element_sum() + radius);
        let mut coverage = Coverage::Hidden;
        for plane in &self.planes {
            let height = plane.height(middle);
            if height >= radius {
                continue;
            }
            if height <= -radius {
                return Coverage::Clear;
            }
            let [below, above] = quad.reach(plane.inward);
            if height + above <= tolerance {
                return Coverage::Clear;
            }
            if height - below < -tolerance {
                coverage = Coverage::Mixed;
            }
        }
        coverage
    }

    /// As [`ShadowVolume::coverage`], without a known ball.
    pub fn coverage_of(&self, points: &[DVec3]) -> Coverage {
        let seen: Corners = points.iter().map(|y| y - self.eye).collect();
        self.coverage_seen(&seen)
    }

    /// As [`ShadowVolume::coverage`], for points relative to the tip.
    pub fn coverage_seen(&self, points: &[DVec3]) -> Coverage {
        self.coverage_within(points, reach(points))
    }

    /// As [`ShadowVolume::coverage`], for points relative to the tip and no farther from it than `reach`.
    pub fn coverage_within(&self, points: &[DVec3], reach: f64) -> Coverage {
        coverage_by(self.planes.iter(), points, reach)
    }

    /// Whether the point `y` is hidden.
    pub fn hides(&self, y: DVec3) -> bool {
        self.planes.iter().all(|plane| plane.height(y - self.eye) > 0.0)
    }

    /// The interval of s in which the points `start` + s `along` of a line are hidden.
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

    /// The tip.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// The hidden part of a convex polygon, relative to the tip.
    pub fn hidden_part(&self, polygon: &[DVec3]) -> Corners {
        let (mut hidden, reach) = (Corners::from_slice(polygon), reach(polygon));
        self.planes.iter().for_each(|plane| plane.cut(&mut hidden, reach));
        hidden
    }

    /// Returns the hidden part of a convex polygon, relative to the tip, and adds the rest to `parts`.
    pub fn divide(&self, polygon: &[DVec3], parts: &mut Vec<Corners>) -> Corners {
        let mut inside = Corners::from_slice(polygon);
        let reach = reach(polygon);
        for plane in &self.planes {
            let mut heights = plane.heights(&inside, reach);
            if heights.iter().any(|h| *h < 0.0) {
                heights.iter_mut().for_each(|h| *h = -*h);
                let part = kept(&inside, &heights);
                if part.len() > 2 {
                    parts.push(part);
                }
                plane.cut(&mut inside, reach);
            }
        }
        inside
    }
}

/// Position of the hull of `points`, no farther from the tip than `reach`, relative to the intersection of
/// planes.
fn coverage_by<'a>(planes: impl Iterator<Item = &'a HalfSpace>, points: &[DVec3], reach: f64) -> Coverage {
    let tolerance = COINCIDENT * reach;
    let mut coverage = Coverage::Hidden;
    for plane in planes {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for a in points {
            let height = plane.height(*a);
            low = if height < low { height } else { low };
            high = if height > high { height } else { high };
        }
        if high <= tolerance {
            return Coverage::Clear;
        }
        if low < -tolerance {
            coverage = Coverage::Mixed;
        }
    }
    coverage
}
