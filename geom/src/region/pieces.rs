//! Cutting a polygon with holes into convex pieces of three or four vertices.
//!
//! The constrained Delaunay triangulation of the rings has the best-shaped triangles; triangles in the holes
//! are dropped. Rings may touch: vertices within tolerance become one, and an edge that passes through a
//! vertex of another ring is cut there, so that edges meet in common vertices only. Then pairs of neighbours
//! that form a convex quadrilateral are merged, those with the largest least sine of a corner first.

use super::places::{Places, around};
use super::ring::{signed_area, to_segment};
use super::rings::Rings;
use crate::ShapeError;
use crate::tolerances::{COINCIDENT, ROUNDING_OF_AREAS};
use glam::{DVec2, DVec3};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation, mitigate_underflow};
use std::collections::BTreeMap;

/// Corners of a smaller sine (1.1°) are not made when triangles are merged: two triangles integrate better
/// than a needle. An arbitrary choice: with a larger value more pieces are left; with a smaller one rules
/// meet charts that nearly collapse.
const LEAST_SINE: f64 = 0.02;

/// The convex pieces of a region, which are found by place.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    list: Vec<Vec<DVec3>>,
    /// Their places in the coordinates of the plane.
    places: Places,
}

impl PartialEq for Pieces {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list
    }
}

impl Pieces {
    /// Pieces of a plane with the coordinates `to_plane`.
    pub(super) fn new(list: Vec<Vec<DVec3>>, to_plane: impl Fn(DVec3) -> DVec2) -> Self {
        let places = Places::new(list.iter().map(|piece| around(piece.iter().map(|x| to_plane(*x)))));
        Self { list, places }
    }

    pub(super) fn list(&self) -> &[Vec<DVec3>] {
        &self.list
    }

    /// The pieces that reach into the box around points of the plane, and of few all, in order.
    pub(super) fn near<'a, P: IntoIterator<Item = DVec2>>(
        &'a self,
        points: P,
    ) -> impl Iterator<Item = &'a [DVec3]> + use<'a, P> {
        self.places.near(&around(points)).into_iter().map(|piece| &self.list[piece][..])
    }
}

/// A triangulation: indices into `points`, counter-clockwise.
struct Mesh {
    points: Vec<DVec2>,
    triangles: Vec<[usize; 3]>,
}

/// An inner edge from `a` to `b` with the triangle on its left (third vertex `c`) and on its right (`d`).
#[derive(Clone, Copy)]
struct InnerEdge {
    a: usize,
    b: usize,
    c: usize,
    d: usize,
    left: usize,
    right: usize,
}

/// The convex pieces of the region that the rings `flat` bound, whose vertices in space are those of `rings`.
pub(super) fn of(
    flat: &Rings,
    rings: &[Vec<DVec3>],
    names: &[String],
) -> Result<Vec<Vec<DVec3>>, ShapeError> {
    let outline = flat.outline().points();
    if rings.len() == 1 && outline.len() <= 4 && least_sine(outline) > 0.0 {
        return Ok(vec![rings[0].clone()]);
    }
    let Some(mesh) = triangulate(flat) else {
        // Rings that pass every test one by one can still leave nothing between them.
        return Err(ShapeError::HoleOutside { field: names.last().expect("the outline has a name").clone() });
    };
    let vertices: Vec<DVec3> = rings.iter().flatten().copied().collect();
    let in_space = |piece: Vec<usize>| piece.into_iter().map(|k| vertices[k]).collect();
    Ok(mesh.merge().into_iter().map(in_space).collect())
}

/// The constrained Delaunay triangulation of the region; `None` where it does not cover the region.
fn triangulate(rings: &Rings) -> Option<Mesh> {
    let points: Vec<DVec2> = rings.points().flatten().copied().collect();
    let extent = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    let tolerance = COINCIDENT * extent;
    let corners = corners(&points, tolerance);
    let vertices = vertices(&points, &corners, tolerance);
    let places = Places::new(vertices.iter().map(|k| around([points[*k]])));
    let stops = |edge| cut(edge, &points, &vertices, &places, tolerance);
    let constraints = edges(rings, &corners).flat_map(stops).collect();
    let at: Vec<DVec2> = vertices.iter().map(|k| (points[*k] - points[0]) / extent).collect();
    let triangles = delaunay(&at, constraints)?;
    let expected = rings.area();
    let mut mesh = Mesh { points, triangles: Vec::new() };
    for triangle in triangles.into_iter().map(|t| t.map(|k| vertices[k])) {
        // Triangles that rounding opens between touching edges have no area.
        if mesh.area(&triangle) > 1e-12 * expected && rings.enclose(mesh.middle(&triangle)) {
            mesh.triangles.push(triangle);
        }
    }
    let covered: f64 = mesh.triangles.iter().map(|t| mesh.area(t)).sum();
    (expected > 0.0 && (covered - expected).abs() <= ROUNDING_OF_AREAS * expected).then_some(mesh)
}

/// The triangles between points, counter-clockwise, with the edges `constraints` among their sides; the same
/// however these are listed.
fn delaunay(points: &[DVec2], mut constraints: Vec<[usize; 2]>) -> Option<Vec<[usize; 3]>> {
    let mut plane = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
    let handles: Vec<_> = points
        .iter()
        .map(|at| plane.insert(mitigate_underflow(Point2::new(at.x, at.y))).ok())
        .collect::<Option<_>>()?;
    constraints.sort_unstable();
    for [from, to] in constraints {
        plane.try_add_constraint(handles[from], handles[to]);
    }
    Some(plane.inner_faces().map(|face| face.vertices().map(|vertex| vertex.index())).collect())
}

/// The corners, each once, in an order that does not depend on how the rings are listed.
fn vertices(points: &[DVec2], corners: &[usize], tolerance: f64) -> Vec<usize> {
    let mut vertices: Vec<usize> = (0..points.len()).filter(|k| corners[*k] == *k).collect();
    vertices.sort_by_key(|k| ((points[*k] - points[0]) / tolerance).to_array().map(|x| x.round() as i64));
    vertices
}

/// For each point the first point that coincides with it, or itself.
fn corners(points: &[DVec2], tolerance: f64) -> Vec<usize> {
    let places = Places::new(points.iter().map(|point| around([*point])));
    let first = |k: usize| {
        let near = places.near(&around([points[k]]).inflate(tolerance)).into_iter();
        near.take_while(|j| *j < k).find(|j| points[*j].distance(points[k]) <= tolerance).unwrap_or(k)
    };
    (0..points.len()).map(first).collect()
}

/// The edges of all rings between corners.
fn edges<'a>(rings: &'a Rings, corners: &'a [usize]) -> impl Iterator<Item = [usize; 2]> + 'a {
    let ring = |start: &mut usize, n: usize| Some((std::mem::replace(start, *start + n), n));
    let starts = rings.points().map(<[DVec2]>::len).scan(0, ring);
    let of_ring = |(start, n): (usize, usize)| (0..n).map(move |k| [start + k, start + (k + 1) % n]);
    starts.flat_map(of_ring).map(|edge| edge.map(|k| corners[k]))
}

/// The parts of an edge between the vertices that it passes through, in order, as indices of vertices, which
/// are found at `places`.
fn cut(
    [from, to]: [usize; 2],
    points: &[DVec2],
    vertices: &[usize],
    places: &Places,
    tolerance: f64,
) -> Vec<[usize; 2]> {
    let (p, q) = (points[from], points[to]);
    let on = |k: usize| k == from || k == to || to_segment(points[k], [p, q]) <= tolerance;
    let mut stops = places.near(&around([p, q]).inflate(tolerance));
    stops.retain(|at| on(vertices[*at]));
    stops.sort_by(|a, b| points[vertices[*a]].distance(p).total_cmp(&points[vertices[*b]].distance(p)));
    stops.windows(2).map(|part| [part[0], part[1]]).collect()
}

impl Mesh {
    fn area(&self, t: &[usize; 3]) -> f64 {
        signed_area(&t.map(|k| self.points[k]))
    }

    /// The centroid of a triangle.
    fn middle(&self, t: &[usize; 3]) -> DVec2 {
        t.iter().map(|k| self.points[*k]).sum::<DVec2>() / 3.0
    }

    /// The edges between two triangles, each once, in a fixed order.
    fn inner_edges(&self) -> Vec<InnerEdge> {
        let mut seen = BTreeMap::new();
        let mut inner = Vec::new();
        for (index, t) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                if let Some((right, d)) = seen.remove(&(b, a)) {
                    inner.push(InnerEdge { a, b, c, d, left: index, right });
                } else {
                    seen.insert((a, b), (index, c));
                }
            }
        }
        inner
    }

    /// The two triangles of an inner edge as one quadrilateral, counter-clockwise.
    fn quadrilateral(&self, e: &InnerEdge) -> [DVec2; 4] {
        [e.a, e.d, e.b, e.c].map(|k| self.points[k])
    }

    /// Merges pairs of triangles, best quadrilateral first; returns all pieces.
    fn merge(&self) -> Vec<Vec<usize>> {
        let inner = self.inner_edges();
        let mut order: Vec<(f64, InnerEdge)> =
            inner.into_iter().map(|e| (least_sine(&self.quadrilateral(&e)), e)).collect();
        order.sort_by(|x, y| y.0.total_cmp(&x.0));
        let mut merged = vec![false; self.triangles.len()];
        let mut pieces = Vec::new();
        for (sine, e) in order {
            if sine >= LEAST_SINE && !merged[e.left] && !merged[e.right] {
                (merged[e.left], merged[e.right]) = (true, true);
                pieces.push(vec![e.a, e.d, e.b, e.c]);
            }
        }
        let single = self.triangles.iter().zip(merged).filter(|(_, used)| !used).map(|(t, _)| t.to_vec());
        pieces.extend(single);
        pieces
    }
}

/// The least sine of the polygon's turning angles; not positive where it is not strictly convex.
fn least_sine(polygon: &[DVec2]) -> f64 {
    let n = polygon.len();
    let turn = |k: usize| {
        let (p, q, r) = (polygon[k], polygon[(k + 1) % n], polygon[(k + 2) % n]);
        (q - p).perp_dot(r - q) / ((q - p).length() * (r - q).length())
    };
    (0..n).map(turn).fold(f64::INFINITY, f64::min)
}
