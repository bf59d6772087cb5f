//! Area lights: a curved surface of even exitance that hides nothing of itself, seen by its outline alone.
//!
//! ```text
//! E(x) = 1/π ∫_Ω n·ω dω = 1/(2π) Σ_k θ_k n·(a_k × b_k) / |a_k × b_k| ,     θ_k = ∠(a_k, b_k)
//! ```
//!
//! for exitance 1, over the sides a_k b_k of the outline as seen from x (Lambert's formula); what lies inside
//! the outline does not matter. The outline consists of the silhouette g = n·(X − x) = 0 and of the borders
//! of the part that faces x, g < 0. The quads of a silhouette mesh show both; secant steps find where the
//! silhouette crosses the edges of quads. An arc between two crossings is replaced by two chords that meet at
//!
//! ```text
//! M + ⁴⁄₃ f ,     f from the chord's middle M to the arc's middle; |f| = |a − b| ∠(n_a, n_b)/8 on a
//! silhouette
//! ```
//!
//! The two chords enclose the same area as a parabola with that middle, so the error falls like h⁴, h the
//! mesh width.
//!
//! Surfaces behind the tangent planes of all points of the light, such as the lids of a can, hide nothing of
//! its front.

use std::f64::consts::TAU;

use radiosity_geom::{Aabb, DVec2, DVec3, LOOSE, Surface, extreme_points, sides};
use radiosity_kernel::irradiance::lambert;
use radiosity_visibility::Visibility;
use radiosity_visibility::silhouette_mesh::{Knot, SilhouetteMesh};

use crate::lines::projection::ProjectionPlane;

/// Secant steps towards a silhouette on the edge of a quad. Each multiplies the digits, and two leave less
/// than the h⁴ of the outline.
const STEPS: usize = 2;

/// Height of two chords over the height of a parabola of the same area: (⅔ b h) / (½ b h) = 4/3.
const CHORDS: f64 = 4.0 / 3.0;

/// Clearance: nothing but lids may stand within this multiple of half the second longest side of the bounding
/// box. It covers what lies between the surface and its projection plane, at most √2 − 1 = 0.414 radii from a
/// ball; rounded up.
const ROOM: f64 = 0.42;

/// Least cosine between the normal of the projection plane and the directions to the outline: at 0.2, 78°
/// off, lengths are stretched fivefold. With a smaller value scan lines miss parts of it; with a larger one
/// more lights go by cells.
const STEEPEST: f64 = 0.2;

/// Part of the area of a flat surface by which its convex outline may differ. Chosen: chords differ by 1e-5.
const ALIKE: f64 = 1e-4;

/// Angle h (rad) by which normals and edges turn over the quads of a rough outline: twice that of silhouette meshes.
/// Two chords for a parabola for an arc of the angle h leave h⁴/180 of a round outline: 1.4e-4, a fortieth of the error
/// that pictures allow direct light.
const ROUGH: f64 = 0.4;

/// A side of an outline: two points.
pub(crate) type Side = [DVec3; 2];

/// A quad of the silhouette mesh.
#[derive(Debug)]
struct LightQuad {
    knots: [Knot; 4],
    /// Of the edges that lie on the surface's border, the end that the two chords of the whole edge share.
    apexes: [Option<DVec3>; 4],
}

/// A curved surface of even exitance.
#[derive(Debug)]
pub(crate) struct AreaLight<'a> {
    shape: &'a dyn Surface,
    quads: Vec<LightQuad>,
    /// Indices, ascending, of the surfaces that close it (lids): they hide nothing of it.
    lids: Vec<usize>,
    /// Centre of the bounding ball.
    pub center: DVec3,
    /// Radius of the bounding ball (scene length).
    pub radius: f64,
}

impl<'a> AreaLight<'a> {
    /// The surface as an area light; None if it is a polygon, may hide itself, or anything but lids stands
    /// close to it.
    pub(crate) fn new(visibility: &'a Visibility, surface: usize) -> Option<Self> {
        Self::outlined(visibility, surface, quads)
    }

    /// As [`AreaLight::new`], with an outline that errs by about 1e-4 of the light, and of half as many sides.
    pub(crate) fn rough(visibility: &'a Visibility, surface: usize) -> Option<Self> {
        Self::outlined(visibility, surface, |_| quads(&visibility.mesh_turning(surface, ROUGH)))
    }

    /// The surface as an area light of the quads that `quads` makes, by the surface's mesh or another.
    fn outlined(
        visibility: &'a Visibility,
        surface: usize,
        quads: impl FnOnce(&SilhouetteMesh) -> Vec<LightQuad>,
    ) -> Option<Self> {
        if visibility.pieces(surface).is_some() || visibility.hides_itself(surface) {
            return None;
        }
        let mesh = visibility.silhouette_mesh(surface);
        let quads = quads(mesh);
        let bounds = visibility.bounds_of(surface);
        let (center, radius) = (bounds.center(), 0.5 * bounds.diagonal());
        let is_lid = |other: &usize| {
            let height = |y: DVec3, x: &Knot| (y - x.position).dot(x.normal);
            let is_behind = |y: DVec3| knots(&quads).all(|x| height(y, x) <= LOOSE * radius);
            match visibility.pieces(*other) {
                Some(pieces) => pieces.iter().flatten().all(|y| is_behind(*y)),
                None => visibility
                    .silhouette_mesh(*other)
                    .quads()
                    .all(|q| q.knots.iter().all(|y| is_behind(y.position))),
            }
        };
        let mut sides = (bounds.max - bounds.min).to_array();
        sides.sort_by(f64::total_cmp);
        let room = bounds.inflate(0.5 * ROOM * sides[1]);
        let near = visibility.near(&room).into_iter().filter(|other| *other != surface);
        let (lids, others): (Vec<usize>, Vec<usize>) = near.partition(is_lid);
        // The box of a shade holds the lamp within, which it nowhere comes near.
        let reaches = |other: &usize| match visibility.pieces(*other) {
            Some(pieces) => pieces.iter().any(|piece| Aabb::around(piece.iter().copied()).overlaps(&room)),
            None => visibility.silhouette_mesh(*other).reaches_into(&room),
        };
        (!others.iter().any(reaches)).then_some(Self { shape: mesh.shape(), quads, lids, center, radius })
    }

    /// Upper bound of the irradiance from exitance 1 at a point outside the bounding ball.
    pub(crate) fn most_from(&self, eye: DVec3) -> f64 {
        self.radius * self.radius / self.center.distance_squared(eye)
    }

    /// Whether all `surfaces` are lids of this light, which hide nothing of it from anywhere.
    pub(crate) fn is_closed_by(&self, surfaces: &[usize]) -> bool {
        surfaces.iter().all(|surface| self.lids.binary_search(surface).is_ok())
    }

    /// The sides of the outline seen from `eye`, in no order, all with the part that faces the eye on the
    /// same hand. Empty where no part of the surface faces the eye.
    pub(crate) fn outline(&self, eye: DVec3) -> Vec<Side> {
        let mut sides = Vec::with_capacity(4 * self.quads.len());
        for LightQuad { knots: quad, apexes } in &self.quads {
            let heights = quad.map(|knot| knot.normal.dot(knot.position - eye));
            let faces = heights.map(|g| g < 0.0);
            if faces == [false; 4] {
                continue;
            }
            let edges = || (0..4).map(|k| (k, (k + 1) % 4));
            for (k, next) in edges() {
                let Some(apex) = apexes[k] else { continue };
                self.border(eye, [quad[k], quad[next]], apex, [faces[k], faces[next]], &mut sides);
            }
            if faces == [true; 4] {
                continue;
            }
            let crossed = edges().filter(|(k, next)| faces[*k] != faces[*next]);
            let crossings: Vec<(Knot, bool)> =
                crossed.map(|(k, next)| (self.crossing(eye, quad[k], quad[next]), faces[k])).collect();
            for pair in crossings.chunks_exact(2) {
                // The silhouette starts where the border of the quad leaves the part that faces the eye.
                let [(a, leaves), (b, _)] = [pair[0], pair[1]];
                let [a, b] = if leaves { [a, b] } else { [b, a] };
                let sagitta = (b.position - a.position).dot(b.normal - a.normal) / 8.0;
                let outward = CHORDS * sagitta * (a.normal + b.normal).normalize_or_zero();
                push_arc(a.position, a.position.midpoint(b.position) + outward, b.position, &mut sides);
            }
        }
        sides
    }

    /// Adds the part of an edge on the surface's border that faces the eye; `middle` is the apex of the whole edge.
    fn border(&self, eye: DVec3, [a, b]: [Knot; 2], middle: DVec3, faces: [bool; 2], sides: &mut Vec<Side>) {
        let [start, end] = match faces {
            [false, false] => return,
            [true, true] => return push_arc(a.position, middle, b.position, sides),
            [true, false] => [a, self.crossing(eye, a, b)],
            [false, true] => [self.crossing(eye, a, b), b],
        };
        push_arc(start.position, apex(self.shape(), [start, end]), end.position, sides);
    }

    /// The point where the silhouette crosses the edge from `a` to `b`, at which g has different signs.
    fn crossing(&self, eye: DVec3, mut a: Knot, mut b: Knot) -> Knot {
        let height = |knot: &Knot| knot.normal.dot(knot.position - eye);
        let (mut low, mut high) = (height(&a), height(&b));
        let mut found = a;
        for _ in 0..STEPS {
            let place = low / (low - high);
            let [u, v] = [0, 1].map(|k| a.parameters[k] + place * (b.parameters[k] - a.parameters[k]));
            let jet = self.shape().jet(u, v);
            found = Knot { parameters: [u, v], position: jet.position, normal: jet.normal };
            let here = height(&found);
            if (here < 0.0) == (low < 0.0) {
                (a, low) = (found, here);
            } else {
                (b, high) = (found, here);
            }
            if low == high {
                break;
            }
        }
        found
    }

    fn shape(&self) -> &dyn Surface {
        self.shape
    }

    /// The projection plane: a rectangle that touches the surface from the eye's side, with the outline
    /// `sides` in its coordinates. It is perpendicular to the mean normal of the part that faces `eye`, or
    /// else to the view; one side runs along the outline's farthest point. None where the eye is too near.
    pub(crate) fn plane(&self, eye: DVec3, sides: &[Side]) -> Option<(ProjectionPlane, Vec<[[f64; 2]; 2]>)> {
        let front = knots(&self.quads).filter(|x| x.normal.dot(x.position - eye) < 0.0);
        let facing = -front.map(|x| x.normal).sum::<DVec3>().normalize_or_zero();
        let towards = (self.center - eye).normalize_or_zero();
        let mut inwards = [facing, towards].into_iter();
        let (inward, nearest) = inwards.find_map(|n| self.depth(eye, n, sides).map(|depth| (n, depth)))?;
        let to_foot = towards * (nearest / towards.dot(inward));
        let foot = eye + to_foot;
        let seen = |y: DVec3| (y - eye) * (nearest / (y - eye).dot(inward)) - to_foot;
        let aside = sides.iter().map(|side| seen(side[0]));
        let longest =
            aside.fold(DVec3::ZERO, |a, b| if b.length_squared() > a.length_squared() { b } else { a });
        let along = longest.normalize_or_zero();
        let across = inward.cross(along);
        let projected: Vec<[[f64; 2]; 2]> =
            sides.iter().map(|side| side.map(|y| [seen(y).dot(along), seen(y).dot(across)])).collect();
        let range = |k: usize| {
            let values = projected.iter().flatten().map(|point| point[k]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let [[left, right], [low, high]] = [range(0), range(1)];
        let corner = |s: f64, t: f64| foot + s * along + t * across;
        let rectangle = [corner(left, low), corner(right, low), corner(right, high), corner(left, high)];
        let place = |[s, t]: [f64; 2]| [(s - left) / (right - left), (t - low) / (high - low)];
        let projected = projected.into_iter().map(|side| side.map(place)).collect();
        Some((ProjectionPlane::new(eye, &rectangle, &rectangle)?, projected))
    }

    /// Distance from the eye to the plane perpendicular to `inward` that touches the surface; None unless the
    /// whole outline lies well in front of the eye.
    fn depth(&self, eye: DVec3, inward: DVec3, sides: &[Side]) -> Option<f64> {
        let depth = |y: DVec3| (y - eye).dot(inward);
        let nearest = knots(&self.quads).map(|knot| depth(knot.position)).fold(f64::INFINITY, f64::min);
        let is_ahead = |y: &DVec3| depth(*y) > STEEPEST * y.distance(eye);
        (nearest > 0.0 && sides.iter().flatten().all(is_ahead)).then_some(nearest)
    }
}

impl LightQuad {
    fn new(shape: &dyn Surface, knots: [Knot; 4]) -> Self {
        let apex = |k: usize| {
            let edge = [knots[k], knots[(k + 1) % 4]];
            is_border(&edge[0], &edge[1]).then(|| apex(shape, edge))
        };
        Self { knots, apexes: std::array::from_fn(apex) }
    }
}

/// The quads of a mesh.
fn quads(mesh: &SilhouetteMesh) -> Vec<LightQuad> {
    mesh.quads().map(|quad| LightQuad::new(mesh.shape(), quad.knots)).collect()
}

fn knots(quads: &[LightQuad]) -> impl Iterator<Item = &Knot> {
    quads.iter().flat_map(|quad| &quad.knots)
}

/// Irradiance at `eye` with the unit normal `normal` from an outline of exitance 1 that lies above the
/// horizon.
pub(crate) fn irradiance(eye: DVec3, normal: DVec3, sides: &[Side]) -> f64 {
    let towards = |y: DVec3| (y - eye).normalize_or_zero();
    // Most sides start where the last one ends.
    let (mut at, mut last, mut sum) = (eye, DVec3::ZERO, 0.0);
    for [start, end] in sides {
        let first = if *start == at { last } else { towards(*start) };
        (at, last) = (*end, towards(*end));
        sum += lambert::side(normal, first, last);
    }
    sum.abs() / TAU
}

/// The corners, in order, of the convex polygon that replaces a flat surface with curved edges of this `area`
/// by its chords, and its normal; None of other surfaces.
pub(crate) fn flat_outline(
    visibility: &Visibility,
    surface: usize,
    area: f64,
) -> Option<(Vec<DVec3>, DVec3)> {
    if visibility.pieces(surface).is_some() || visibility.hides_itself(surface) {
        return None;
    }
    let mesh = visibility.silhouette_mesh(surface);
    let Knot { position, normal, .. } = mesh.quads().next()?.knots[0];
    let most = LOOSE * visibility.bounds_of(surface).diagonal();
    let is_level = |knot: &Knot| (knot.position - position).dot(normal).abs() <= most;
    let mut corners = Vec::new();
    for quad in mesh.quads() {
        if !quad.knots.iter().all(is_level) {
            return None;
        }
        let edges = (0..4).map(|k| [quad.knots[k], quad.knots[(k + 1) % 4]]);
        for [a, b] in edges.filter(|[a, b]| is_border(a, b)) {
            corners.extend([a.position, apex(mesh.shape(), [a, b]), b.position]);
        }
    }
    let corners = extreme_points(&corners, normal);
    let twice: DVec3 = sides(&corners).map(|[a, b]| (a - position).cross(b - position)).sum();
    ((0.5 * twice.length() - area).abs() <= ALIKE * area).then_some((corners, normal))
}

/// The end that two chords of an arc on the border share.
fn apex(shape: &dyn Surface, [start, end]: [Knot; 2]) -> DVec3 {
    let [low, high] = [start, end].map(|knot| DVec2::from_array(knot.parameters));
    let middle = shape.jet(0.5 * (low.x + high.x), 0.5 * (low.y + high.y)).position;
    let chord = start.position.midpoint(end.position);
    chord + CHORDS * (middle - chord)
}

/// Whether an edge of a quad lies on the border of the surface's parameters.
fn is_border(a: &Knot, b: &Knot) -> bool {
    (0..2).any(|k| a.parameters[k] == b.parameters[k] && a.parameters[k].abs() == 1.0)
}

fn push_arc(start: DVec3, apex: DVec3, end: DVec3, sides: &mut Vec<Side>) {
    sides.push([start, apex]);
    sides.push([apex, end]);
}
