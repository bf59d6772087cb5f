//! Frames: the coordinates of an element in which its polynomials are written.
//!
//! A convex polygon fills at least half of the rectangle around it along its diameter: the diameter is the
//! base, and the distances from it are the heights, of two inscribed triangles. In such a frame a sliver of
//! any aspect is as good as a shape of aspect 1, since the space of polynomials of total degree ≤ N is the
//! same in all affine coordinates.

use radiosity_geom::{DVec2, DVec3, extreme_points};

use super::patch::Node;

/// Coordinates (a, b) of an element, [−1, 1]² over it.
#[derive(Clone, Debug, PartialEq)]
pub enum Frame {
    /// Affine in the plane: a = (x − origin)·first, b = (x − origin)·second.
    Plane {
        /// Centre of the bounding parallelogram.
        origin: DVec3,
        /// Gradient of a.
        first: DVec3,
        /// Gradient of b.
        second: DVec3,
    },
    /// A rectangle of surface parameters.
    Parameters {
        /// Centre of the rectangle.
        center: DVec2,
        /// Half its sides.
        half: DVec2,
    },
}

impl Frame {
    /// The parallelogram around coplanar `points` with sides along `sides`, two directions in their plane
    /// that are not parallel.
    ///
    /// A parallelogram with its own sides fills its frame: its basis is as well conditioned as the square's.
    pub fn bounding(points: &[DVec3], sides: [DVec3; 2]) -> Self {
        let duals = duals(sides);
        let bounds = duals.map(|dual| {
            points
                .iter()
                .map(|p| (p - points[0]).dot(dual))
                .fold((0.0f64, 0.0f64), |(low, high), x| (low.min(x), high.max(x)))
        });
        let [a, b] = bounds.map(|(low, high)| 0.5 * (low + high));
        let [first, second] = [0, 1].map(|k| duals[k] * (2.0 / (bounds[k].1 - bounds[k].0)));
        Self::Plane { origin: points[0] + sides[0] * a + sides[1] * b, first, second }
    }

    /// The rectangle around coplanar `points` along the longest distance between two of them; `normal` is
    /// perpendicular to their plane. The earliest of equal distances is taken.
    pub(crate) fn along_diameter(points: &[DVec3], normal: DVec3) -> Self {
        let extreme = extreme_points(points, normal);
        let ends: Vec<DVec3> = points.iter().filter(|x| extreme.contains(x)).copied().collect();
        let pairs = ends.iter().enumerate().flat_map(|(k, p)| ends[..k].iter().map(move |q| p - q));
        let first = |best: DVec3, next: DVec3| {
            if next.length_squared() > (1.0 + 1e-12) * best.length_squared() { next } else { best }
        };
        let along = pairs.fold(DVec3::ZERO, first).normalize();
        Self::bounding(points, [along, normal.cross(along)])
    }

    /// (a, b) of a node.
    pub fn coordinates(&self, node: &Node) -> [f64; 2] {
        match self {
            Self::Plane { .. } => self.locate(node.position, DVec2::ZERO),
            Self::Parameters { .. } => self.locate(DVec3::ZERO, node.parameters),
        }
    }

    /// (a, b) of a point: by its position on a plane, by its parameters on a curved surface.
    pub fn locate(&self, position: DVec3, parameters: DVec2) -> [f64; 2] {
        match self {
            Self::Plane { origin, first, second } => {
                let d = position - origin;
                [d.dot(*first), d.dot(*second)]
            }
            Self::Parameters { center, half } => ((parameters - center) / half).to_array(),
        }
    }
}

/// The dual vectors of two directions in a plane: the gradients of the coordinates along them, and vice
/// versa.
pub fn duals([a, b]: [DVec3; 2]) -> [DVec3; 2] {
    let normal = a.cross(b);
    [b.cross(normal), normal.cross(a)].map(|dual| dual / normal.length_squared())
}
