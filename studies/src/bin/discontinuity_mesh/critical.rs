//! Critical lines: where the light of a lamp that a convex occluder hides changes its form.
//!
//! ```text
//! EV: the shadow of an occluder's edge by a lamp's corner
//! VE: the shadow of an occluder's corner by a lamp's edge
//! ```
//!
//! Both lie in planes that have all of the occluder on one side. Lines that two occluders make together, and
//! curves by three edges, are left out.
//!
//! References: P. Heckbert, *Discontinuity meshing for radiosity*, Eurographics Workshop on Rendering (1992);
//! D. Lischinski, F. Tampieri, D. Greenberg, *Discontinuity meshing for accurate radiosity*, IEEE CG&A 12(6)
//! (1992).

use radiosity_geom::{DVec3, Plane, sides};

/// Heights over a receiver, in parts of that of a source, beyond which no shadow is thrown: it would be far
/// outside any room.
const NEAREST: f64 = 1e-3;

/// Part of the size of an occluder by which its corners may lie off a plane that touches it.
const TOUCHING: f64 = 1e-9;

/// A convex body, or a polygon.
pub(crate) struct Body {
    pub(crate) corners: Vec<DVec3>,
    pub(crate) edges: Vec<[DVec3; 2]>,
}

impl Body {
    /// The body with these faces; corners and edges that faces share count once.
    pub(crate) fn of_faces(faces: &[Vec<DVec3>]) -> Self {
        let mut own = Self { corners: Vec::new(), edges: Vec::new() };
        for face in faces {
            for [a, b] in sides(face) {
                if !own.corners.contains(&a) {
                    own.corners.push(a);
                }
                if !own.edges.contains(&[a, b]) && !own.edges.contains(&[b, a]) {
                    own.edges.push([a, b]);
                }
            }
        }
        own
    }

    /// Whether it lies on one side of the plane through three points.
    fn is_on_one_side(&self, [a, b, c]: [DVec3; 3]) -> bool {
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { return false };
        let heights = self.corners.iter().map(|x| (*x - a).dot(normal));
        let [low, high] = heights.fold([0.0f64; 2], |[low, high], h| [low.min(h), high.max(h)]);
        let size = self.corners.iter().map(|x| x.distance(self.corners[0])).fold(0.0, f64::max);
        low > -TOUCHING * size || high < TOUCHING * size
    }
}

/// The critical lines of one lamp and one occluder on a plane, whose normal points to where light comes from.
pub(crate) fn lines(lamp: &Body, occluder: &Body, plane: Plane) -> Vec<[DVec3; 2]> {
    let mut lines = Vec::new();
    for corner in &lamp.corners {
        for [a, b] in &occluder.edges {
            let top = (1.0 - NEAREST) * plane.height(*corner);
            if occluder.is_on_one_side([*corner, *a, *b])
                && let Some(edge) = between([*a, *b], plane, [0.0, top])
            {
                lines.push(edge.map(|x| shadow(*corner, x, plane)));
            }
        }
    }
    for [a, b] in &lamp.edges {
        for corner in &occluder.corners {
            let foot = plane.height(*corner) / (1.0 - NEAREST);
            if foot >= 0.0
                && occluder.is_on_one_side([*corner, *a, *b])
                && let Some(edge) = between([*a, *b], plane, [foot, f64::INFINITY])
            {
                lines.push(edge.map(|x| shadow(x, *corner, plane)));
            }
        }
    }
    lines
}

/// The part of an edge between two heights over a plane.
fn between([a, b]: [DVec3; 2], plane: Plane, [low, high]: [f64; 2]) -> Option<[DVec3; 2]> {
    let [from, to] = [a, b].map(|x| plane.height(x));
    let (mut start, mut end) = (0.0f64, 1.0f64);
    // Heights are linear along the edge: h = from + t (to − from).
    for (bound, sign) in [(low, 1.0), (high, -1.0)] {
        if bound.is_infinite() {
            continue;
        }
        let [over, after] = [from, to].map(|height| sign * (height - bound));
        match (over >= 0.0, after >= 0.0) {
            (true, true) => {}
            (false, false) => return None,
            (false, true) => start = start.max(over / (over - after)),
            (true, false) => end = end.min(over / (over - after)),
        }
    }
    (start < end).then(|| [a.lerp(b, start), a.lerp(b, end)])
}

/// Where the ray from a source through a point meets the plane.
fn shadow(source: DVec3, through: DVec3, plane: Plane) -> DVec3 {
    let [above, below] = [source, through].map(|x| plane.height(x));
    source + (through - source) * (above / (above - below))
}
