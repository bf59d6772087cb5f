//! Hidden spans: the parts of the scan lines of a projection plane that blockers hide.
//!
//! A planar blocker hides an interval of a line. Each quad of a curved blocker's silhouette mesh meets the
//! plane through the eye and the line in a segment, which hides an interval. These intervals are joined, and
//! only the ends of the union are corrected from the mesh to the true surface ([`crate::lines::silhouette`]).
//! The accuracy of the result is that of the correction; the mesh only has to find the outline.

use std::borrow::Cow;

use radiosity_geom::{Aabb, COINCIDENT, DVec3, Rect};
use radiosity_visibility::shadow_volume::ShadowVolume;
use radiosity_visibility::silhouette_mesh::{Ground, Quad, Region, SilhouetteMesh};
use smallvec::{SmallVec, smallvec};

use crate::lines::projection::ProjectionPlane;
use crate::lines::silhouette::{Crossing, outline};

/// Two ends nearer than this part of the polygon's side are both corrected; the farther counts. An arbitrary
/// choice: with a smaller value a quad behind the one that ends may pass unseen, with a larger one more ends
/// are corrected.
const CLOSE: f64 = 0.02;

/// Ends so far outside a line, over its length, are corrected too: the surface may exceed its mesh, by a
/// fortieth of a quad. With a larger value more ends are corrected that no line meets.
const OUTSIDE: f64 = 0.1;

/// Factor by which normals may turn farther inside a quad than between its corners: a margin, since few
/// normals are known. With a larger value more quads are quartered near the eye.
const STEEPER: f64 = 1.5;

/// Largest correction that is accepted, over the projected size of the quad. The outline lies within a quad
/// of the mesh, and Newton steps that leave it went astray.
const BELIEVED: f64 = 1.0;

/// Between two ends in one mesh without an outline a gap up to this part of a quad's projected breadth is a
/// crack between quads of different sizes. With a larger value narrow gaps between two parts of one surface
/// would close, with a smaller one cracks let light through.
const CRACK: f64 = 0.25;

/// The blockers before a projection plane.
#[derive(Debug)]
pub(crate) struct HiddenSpans<'a> {
    plane: ProjectionPlane,
    quads: Vec<Facet<'a>>,
    /// Range of t that each quad covers.
    heights: Vec<[f64; 2]>,
    volumes: Vec<&'a ShadowVolume>,
    /// Sides, in no order, of the outline of the part that shines; None if the whole polygon does.
    lit: Option<Vec<[[f64; 2]; 2]>>,
}

/// A quad in projection.
#[derive(Debug)]
struct Facet<'a> {
    mesh: &'a SilhouetteMesh,
    quad: Cow<'a, Quad>,
    /// (S, T, λ) of its corners.
    seen: [DVec3; 4],
}

/// A hidden interval of a line.
#[derive(Clone, Copy, Debug)]
struct Hidden {
    low: End,
    high: End,
}

/// An end of a hidden interval, with the edges of quads that it lies on.
#[derive(Clone, Copy, Debug)]
struct End {
    s: f64,
    causes: [Option<Cause>; 2],
}

/// An edge of a quad at which a hidden interval ends.
#[derive(Clone, Copy, Debug)]
struct Cause {
    /// Index of the quad.
    facet: usize,
    crossing: Crossing,
}

/// Where a line crosses an edge of a quad.
#[derive(Clone, Copy)]
struct CrossedEdge {
    /// (S, T, λ).
    point: DVec3,
    crossing: Crossing,
}

/// A mesh at an end of a hidden interval.
#[derive(Clone, Copy)]
struct Within<'a> {
    mesh: &'a SilhouetteMesh,
    /// Projected breadth of its quad there.
    breadth: f64,
}

/// A piece of the surface of a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnPiece {
    /// The parameters that it covers.
    pub parameters: Rect,
    /// Whether its front is the back of the mesh.
    pub is_turned: bool,
}

impl OwnPiece {
    /// Whether a quad of the mesh counts before the piece, whose front the eye sees.
    ///
    /// Its own quads and those beside them do not: their chords lie before a surface that bends towards the eye.
    /// Either the quad is well before the plane, or the eye sees its other side, so that a fold lies between.
    fn may_be_hidden_by(&self, quad: &Quad, seen: &[DVec3; 4], plane: &ProjectionPlane) -> bool {
        // The front of the mesh is the other side of a piece that is turned.
        let is_beyond_fold = || quad.shows(plane.eye, self.is_turned);
        let far = 1.0 - plane.width();
        seen.iter().all(|p| p.z <= far) || (!quad.overlaps(&self.parameters) && is_beyond_fold())
    }
}

/// An end of a hidden interval, corrected to the surface.
#[derive(Clone, Copy)]
struct CorrectedEnd<'a> {
    s: f64,
    /// The mesh that contains the end, where no outline was found.
    within: Option<Within<'a>>,
}

/// The region before the polygon of a projection plane, for a surface that the eye may lie on.
struct Ahead<'a> {
    plane: &'a ProjectionPlane,
    ground: Option<Ground>,
}

impl Region for Ahead<'_> {
    fn eye(&self) -> DVec3 {
        self.plane.eye
    }

    fn reaches(&self, bounds: &Aabb) -> bool {
        self.plane.reaches(bounds)
    }

    fn ground(&self) -> Option<Ground> {
        self.ground
    }
}

impl<'a> HiddenSpans<'a> {
    /// No blockers before `plane` yet.
    pub(crate) fn new(plane: ProjectionPlane) -> Self {
        Self { plane, quads: Vec::new(), heights: Vec::new(), volumes: Vec::new(), lit: None }
    }

    /// No blockers yet; only the inside of an outline, given by its sides in (s, t), shines.
    pub(crate) fn before_lamp(plane: ProjectionPlane, sides: Vec<[[f64; 2]; 2]>) -> Self {
        Self { lit: Some(sides), ..Self::new(plane) }
    }

    /// Adds a planar blocker.
    pub(crate) fn add_flat(&mut self, volume: &'a ShadowVolume) {
        self.volumes.push(volume);
    }

    /// Adds a curved blocker; `ground` is the unit normal under the eye if the eye lies on it, `is_turned` if
    /// it lies on the other side than that of the mesh. `own`: the piece of the blocker itself that the plane
    /// stands for, which only some quads may hide ([`OwnPiece::may_be_hidden_by`]).
    pub(crate) fn add_curved(
        &mut self,
        mesh: &'a SilhouetteMesh,
        ground: Option<DVec3>,
        is_turned: bool,
        own: Option<OwnPiece>,
    ) {
        let side = if is_turned { -1.0 } else { 1.0 };
        let ground =
            ground.map(|normal| Ground { normal: side * normal, least: self.plane.rise(normal) / STEEPER });
        let ahead = Ahead { plane: &self.plane, ground };
        let (quads, heights) = (&mut self.quads, &mut self.heights);
        mesh.visit(&ahead, &mut |quad| {
            let seen = quad.knots.map(|knot| self.plane.see(knot.position));
            if own.is_none_or(|own| own.may_be_hidden_by(&quad, &seen, &self.plane)) {
                heights.push(height(&seen));
                quads.push(Facet { mesh, quad, seen });
            }
        });
    }

    /// Whether there is no blocker.
    pub(crate) fn is_empty(&self) -> bool {
        self.quads.is_empty() && self.volumes.is_empty()
    }

    /// These spans with s and t exchanged: lines run in the other direction.
    pub(crate) fn transposed(&self) -> Self {
        let quads: Vec<_> = self.quads.iter().map(Facet::transposed).collect();
        let heights = quads.iter().map(|facet| height(&facet.seen)).collect();
        let turned =
            |sides: &Vec<[[f64; 2]; 2]>| sides.iter().map(|side| side.map(|[s, t]| [t, s])).collect();
        let lit = self.lit.as_ref().map(turned);
        Self { plane: self.plane.transposed(), quads, heights, volumes: self.volumes.clone(), lit }
    }

    /// The projection plane.
    pub(crate) fn plane(&self) -> &ProjectionPlane {
        &self.plane
    }

    /// The parts of line `t` between `low` and `high` that shine, ascending.
    pub(crate) fn lit(&self, t: f64, [low, high]: [f64; 2]) -> SmallVec<[[f64; 2]; 2]> {
        let Some(sides) = &self.lit else { return smallvec![[low, high]] };
        let crossed = sides.iter().filter(|[a, b]| (a[1] > t) != (b[1] > t));
        let mut places: SmallVec<[f64; 4]> =
            crossed.map(|[a, b]| a[0] + (b[0] - a[0]) * (t - a[1]) / (b[1] - a[1])).collect();
        places.sort_unstable_by(f64::total_cmp);
        let parts = places.chunks_exact(2).map(|ends| [ends[0].max(low), ends[1].min(high)]);
        parts.filter(|[start, end]| start < end).collect()
    }

    /// Writes the visible parts of line `t` between `low` and `high` to `out`, ascending.
    pub(crate) fn visible(&self, t: f64, [low, high]: [f64; 2], out: &mut Vec<[f64; 2]>) {
        out.clear();
        let outside = OUTSIDE * (high - low);
        let mut last = CorrectedEnd { s: low, within: None };
        for hidden in self.hidden(t, [low - outside, high + outside]) {
            let from = self.corrected(t, hidden.low, -1.0);
            if from.s > last.s + COINCIDENT && !last.is_crack(&from) {
                out.push([last.s, from.s.min(high)]);
            }
            let end = self.corrected(t, hidden.high, 1.0);
            if end.s > last.s {
                last = end;
            }
            if last.s >= high {
                return;
            }
        }
        out.push([last.s, high]);
    }

    /// The hidden intervals of line `t` by the meshes, ascending and disjoint.
    fn hidden(&self, t: f64, [low, high]: [f64; 2]) -> Vec<Hidden> {
        let mut parts = Vec::new();
        for (index, [bottom, top]) in self.heights.iter().enumerate() {
            if *bottom <= t && t <= *top {
                self.quads[index].hide(index, t, &mut parts);
            }
        }
        let (start, along) = (self.plane.at(0.0, t), self.plane.along);
        let flat = self.volumes.iter().filter_map(|volume| volume.shadow_on(start, along));
        parts.extend(flat.map(|ends| Hidden::between(ends.map(|s| End { s, causes: [None; 2] }))));
        parts.retain(|part| part.high.s > low && part.low.s < high);
        parts.sort_unstable_by(|a, b| a.low.s.total_cmp(&b.low.s));
        let mut apart: Vec<Hidden> = Vec::new();
        for part in parts {
            match apart.last_mut() {
                Some(last) if part.low.s <= last.high.s + COINCIDENT => last.join(&part),
                _ => apart.push(part),
            }
        }
        apart
    }

    /// An end of a hidden interval, corrected to the surface; `side` is +1 for the high end, −1 for the low
    /// one.
    fn corrected(&self, t: f64, end: End, side: f64) -> CorrectedEnd<'_> {
        let size = |seen: &[DVec3; 4]| seen.iter().map(|p| (p.x / p.z - end.s).abs()).fold(0.0, f64::max);
        let found = end.causes.iter().flatten().filter_map(|cause| {
            let Facet { mesh, quad, seen } = &self.quads[cause.facet];
            let s = outline(&self.plane, t, mesh.shape(), quad, cause.crossing, side)?;
            let is_believed = seen.iter().all(|p| p.z > 0.0) && (s - end.s).abs() <= BELIEVED * size(seen);
            is_believed.then_some(s)
        });
        let farther = |a: f64, b: f64| if side > 0.0 { a.max(b) } else { a.min(b) };
        if let Some(s) = found.reduce(farther) {
            return CorrectedEnd { s, within: None };
        }
        let is_inner = |cause: &Cause| !self.quads[cause.facet].quad.is_border(cause.crossing.edge);
        let within = end.causes[0].filter(is_inner).map(|cause| {
            let Facet { mesh, seen, .. } = &self.quads[cause.facet];
            Within { mesh, breadth: size(seen) }
        });
        CorrectedEnd { s: end.s, within }
    }
}

impl CorrectedEnd<'_> {
    /// Whether the gap between two ends is a crack between quads of different sizes.
    fn is_crack(&self, next: &Self) -> bool {
        match (self.within, next.within) {
            (Some(own), Some(other)) => {
                std::ptr::eq(own.mesh, other.mesh)
                    && next.s - self.s <= CRACK * own.breadth.max(other.breadth)
            }
            _ => false,
        }
    }
}

impl Facet<'_> {
    fn transposed(&self) -> Self {
        Self { mesh: self.mesh, quad: self.quad.clone(), seen: self.seen.map(|p| DVec3::new(p.y, p.x, p.z)) }
    }

    /// The intervals of line `t` that the quad hides: between pairs of edges that the line crosses.
    fn hide(&self, index: usize, t: f64, out: &mut Vec<Hidden>) {
        let height = self.seen.map(|p| p.y - t * p.z);
        let above = height.map(|h| h > 0.0);
        if above == [above[0]; 4] {
            return;
        }
        let mut last: Option<CrossedEdge> = None;
        for edge in 0..4 {
            let next = (edge + 1) % 4;
            if above[edge] == above[next] {
                continue;
            }
            let place = height[edge] / (height[edge] - height[next]);
            let point = self.seen[edge].lerp(self.seen[next], place);
            let crossed = CrossedEdge { point, crossing: Crossing { edge, place } };
            match last.take() {
                None => last = Some(crossed),
                Some(start) => out.extend(between(start, crossed, index)),
            }
        }
    }
}

/// Range of t that a quad covers.
fn height(seen: &[DVec3; 4]) -> [f64; 2] {
    if seen.iter().any(|p| p.z <= COINCIDENT) {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    let t = seen.map(|p| p.y / p.z);
    [t.into_iter().fold(f64::INFINITY, f64::min), t.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// The interval of its line that a segment before the plane hides.
fn between(a: CrossedEdge, b: CrossedEdge, facet: usize) -> Option<Hidden> {
    let (near, far) = (COINCIDENT, 1.0 - COINCIDENT);
    let (low, high) = (a.point.z.min(b.point.z), a.point.z.max(b.point.z));
    if high <= near || low >= far {
        return None;
    }
    let end = |CrossedEdge { point, crossing }: CrossedEdge, other: DVec3| {
        let depth = point.z.clamp(near, far);
        if depth == point.z {
            return End { s: point.x / depth, causes: [Some(Cause { facet, crossing }), None] };
        }
        let x = point.x + (other.x - point.x) * (depth - point.z) / (other.z - point.z);
        End { s: x / depth, causes: [None; 2] }
    };
    Some(Hidden::between([end(a, b.point), end(b, a.point)]))
}

impl Hidden {
    fn between([a, b]: [End; 2]) -> Self {
        if a.s <= b.s { Self { low: a, high: b } } else { Self { low: b, high: a } }
    }

    /// Joins an interval that begins at or after the beginning of this one.
    fn join(&mut self, other: &Self) {
        if other.low.s <= self.low.s + CLOSE {
            self.low.causes[1] = self.low.causes[1].or(other.low.causes[0]);
        }
        let (far, near) = match other.high.s > self.high.s + COINCIDENT {
            true => (other.high, self.high),
            false => (self.high, other.high),
        };
        self.high = far;
        if near.s >= far.s - CLOSE {
            self.high.causes[1] = far.causes[1].or(near.causes[0]);
        }
    }
}
