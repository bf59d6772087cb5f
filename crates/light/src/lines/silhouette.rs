//! The crossing of a curved surface's outline with a scan line.
//!
//! The outline of a surface X(u, v) from x consists of its borders and of its silhouette g = n · (X − x) = 0.
//! A silhouette mesh gives a first approximation of the crossing, on an edge of a quad. From there Newton
//! steps solve
//!
//! ```text
//! border      h(w)    = m · (X(w) − x) = 0                 m the normal of the plane through x and the line
//! silhouette  h(u, v) = 0 ,   g(u, v) = 0
//! ```
//!
//! with the slopes of g taken from the corners of the quad. A point off the silhouette by ε is seen off the
//! outline by κ ε²/2 only (κ: curvature), and the outline crosses the line where its tangent along m × n
//! does. So one step from a mesh of width h leaves an error of order h⁴.
//!
//! Along the view d the surface leaves its tangent plane by −|d|²/2 · (dg/dd)/|X − x| along n. That side of
//! the silhouette is hidden, which tells the beginning of a hidden interval from its end where a quad shows
//! both.

use radiosity_geom::{DVec2, DVec3, Jet, Surface};
use radiosity_visibility::silhouette_mesh::Quad;

use crate::lines::projection::ProjectionPlane;

/// Newton steps towards a border, each of which squares the error: two leave the eighth power of the mesh
/// width, less than the silhouette has.
const BORDER_STEPS: usize = 2;

/// Most Newton steps towards a silhouette; one is enough from a good mesh. A crossing that needs more is left
/// where the mesh has it.
const STEPS: usize = 5;

/// Sine of the angle between view and surface below which a point is on the silhouette: seen, it is off the
/// outline by half its square, 5·10⁻⁵ of a radius of curvature.
const GRAZING: f64 = 1e-2;

/// Sine of the angle to the plane of the line below which a point is on the line. The tangent of the outline
/// carries it the rest of the way, and the error is of second order.
const ON_LINE: f64 = 1e-3;

/// The crossing of a scan line with the edge of a quad.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    /// The edge, from this corner to the next.
    pub edge: usize,
    /// Place on the edge, 0 to 1.
    pub place: f64,
}

/// s of the crossing of the true outline with line `t`, near that of the mesh; None where it is not found.
///
/// If both a border and a silhouette are crossed, the crossing farther towards `side` (±1) counts.
pub(crate) fn outline(
    plane: &ProjectionPlane,
    t: f64,
    shape: &dyn Surface,
    quad: &Quad,
    crossing: Crossing,
    side: f64,
) -> Option<f64> {
    let line = Line { plane, normal: plane.slice(t) };
    let (start, end) = (&quad.knots[crossing.edge], &quad.knots[(crossing.edge + 1) % 4]);
    let [a, b] = [start, end].map(|knot| DVec2::from_array(knot.parameters));
    let is_border = quad.is_border(crossing.edge);
    let heights = quad.knots.map(|knot| knot.normal.dot(knot.position - plane.eye));
    let turns = heights.iter().any(|g| *g < 0.0) && heights.iter().any(|g| *g > 0.0);
    let border = if is_border { line.border(shape, a, b, crossing.place) } else { None };
    let silhouette = match turns || !is_border {
        true => line.silhouette(shape, quad, heights, a.lerp(b, crossing.place), side),
        false => None,
    };
    match (border, silhouette) {
        (Some(a), Some(b)) => Some(if side > 0.0 { a.max(b) } else { a.min(b) }),
        (a, b) => a.or(b),
    }
}

struct Line<'a> {
    plane: &'a ProjectionPlane,
    /// Normal of the plane through the eye and the line.
    normal: DVec3,
}

impl Line<'_> {
    fn border(&self, shape: &dyn Surface, a: DVec2, b: DVec2, mut place: f64) -> Option<f64> {
        let mut seen = DVec3::ZERO;
        for _ in 0..BORDER_STEPS {
            let at = a.lerp(b, place);
            let jet = shape.jet(at.x, at.y);
            let (offset, slope) = (jet.position - self.plane.eye, jet.du * (b - a).x + jet.dv * (b - a).y);
            let step = -self.normal.dot(offset) / self.normal.dot(slope);
            seen = self.plane.see_direction(offset + step * slope);
            place = (place + step).clamp(0.0, 1.0);
        }
        at_line(seen)
    }

    fn silhouette(
        &self,
        shape: &dyn Surface,
        quad: &Quad,
        g: [f64; 4],
        mut at: DVec2,
        side: f64,
    ) -> Option<f64> {
        let low = DVec2::from_array(quad.knots[0].parameters);
        let width = DVec2::from_array(quad.knots[2].parameters) - low;
        let slope = DVec2::new(g[1] - g[0] + g[2] - g[3], g[3] - g[0] + g[2] - g[1]) / (2.0 * width);
        for _ in 0..STEPS {
            let jet = shape.jet(at.x, at.y);
            let offset = jet.position - self.plane.eye;
            let (height, off) = (self.normal.dot(offset), jet.normal.dot(offset));
            let near = GRAZING * offset.length();
            if off.abs() <= near && height.abs() <= ON_LINE * offset.length() * self.normal.length() {
                return if self.ends(&jet, offset, slope, side) {
                    self.tangent(offset, jet.normal)
                } else {
                    None
                };
            }
            let across = DVec2::new(self.normal.dot(jet.du), self.normal.dot(jet.dv));
            let step = DVec2::new(across.y * off - slope.y * height, slope.x * height - across.x * off)
                / across.perp_dot(slope);
            at = (at + step).clamp(low - width, low + 2.0 * width).clamp(DVec2::NEG_ONE, DVec2::ONE);
            if !at.is_finite() {
                return None;
            }
        }
        None
    }

    /// Whether the surface is on the hidden side of its silhouette at `offset` from the eye: before an end
    /// for side 1.
    fn ends(&self, jet: &Jet, offset: DVec3, slope: DVec2, side: f64) -> bool {
        let view = offset.reject_from(jet.normal);
        let [uu, uv, vv] = [jet.du.dot(jet.du), jet.du.dot(jet.dv), jet.dv.dot(jet.dv)];
        let [u, v] = [jet.du.dot(view), jet.dv.dot(view)];
        let along = DVec2::new(vv * u - uv * v, uu * v - uv * u);
        slope.dot(along) * jet.normal.dot(self.plane.along) * side >= 0.0
    }

    /// s where the tangent plane through the eye at `offset` meets the line; `normal` may be slightly off.
    fn tangent(&self, offset: DVec3, normal: DVec3) -> Option<f64> {
        let along = self.normal.cross(normal.reject_from(offset));
        at_line(self.plane.see_direction(if along.dot(offset) < 0.0 { -along } else { along }))
    }
}

fn at_line(seen: DVec3) -> Option<f64> {
    let s = seen.x / seen.z;
    (seen.z > 0.0 && s.is_finite()).then_some(s)
}
