//! Cutting a polygon with holes into convex pieces of three or four vertices.
//!
//! Ear clipping gives some triangulation; flipping every edge opposite to two angles of sum above π makes it
//! the constrained Delaunay triangulation, the one of best-shaped triangles (Lawson, *Software for C¹ surface
//! interpolation*, 1977). Then pairs of neighbours that form a convex quadrilateral are merged, those with
//! the largest least sine of a corner first.

use super::rings::{encloses, signed_area};
use crate::ShapeError;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Corners flatter than this sine are not made: two triangles integrate better than one needle-shaped
/// quadrilateral.
const LEAST_SINE: f64 = 0.02;

/// Of touching holes, this multiple of the extent is taken off to triangulate between them.
const SHRINK: f64 = 1e-7;

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

/// The convex pieces of the region bounded by `flat` (outline, then holes), with the vertices `rings` in
/// space.
pub(super) fn of(
    flat: &[Vec<DVec2>],
    rings: &[Vec<DVec3>],
    names: &[String],
) -> Result<Vec<Vec<DVec3>>, ShapeError> {
    if flat.len() == 1 && flat[0].len() <= 4 && least_sine(&flat[0]) > 0.0 {
        return Ok(vec![rings[0].clone()]);
    }
    // Ear clipping may stumble over holes that touch: then by holes shrunk a little.
    let Some(mut mesh) = [0.0, SHRINK].into_iter().find_map(|shrink| triangulate(flat, shrink)) else {
        // Rings that pass every test one by one can still leave nothing between them.
        return Err(ShapeError::HoleOutside { field: names.last().expect("the outline has a name").clone() });
    };
    mesh.make_delaunay();
    let vertices: Vec<DVec3> = rings.iter().flatten().copied().collect();
    let in_space = |piece: Vec<usize>| piece.into_iter().map(|k| vertices[k]).collect();
    Ok(mesh.merge().into_iter().map(in_space).collect())
}

/// Some triangulation of the region, found with the holes shrunk by a multiple of the extent; `None` where it
/// does not cover the region.
fn triangulate(flat: &[Vec<DVec2>], shrink: f64) -> Option<Mesh> {
    let points: Vec<DVec2> = flat.iter().flatten().copied().collect();
    let extent = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    let mut starts = Vec::new();
    let mut apart: Vec<[f64; 2]> = flat[0].iter().map(|p| p.to_array()).collect();
    for hole in &flat[1..] {
        starts.push(apart.len());
        apart.extend(shrunk(hole, shrink * extent).map(|p| p.to_array()));
    }
    let mut indices: Vec<usize> = Vec::new();
    earcut::Earcut::new().earcut(apart, &starts, &mut indices);
    let mut mesh = Mesh { points, triangles: Vec::new() };
    let expected: f64 = flat.iter().map(|ring| signed_area(ring)).sum();
    for t in indices.as_chunks::<3>().0 {
        let area = mesh.area(t);
        // What opens between touching holes as they shrink has no area.
        if area.abs() > 1e-12 * expected {
            mesh.triangles.push(if area < 0.0 { [t[0], t[2], t[1]] } else { *t });
        }
    }
    let covered: f64 = mesh.triangles.iter().map(|t| mesh.area(t)).sum();
    let whole = expected > 0.0 && (covered - expected).abs() <= 1e-9 * expected;
    (whole && mesh.triangles.iter().all(|t| mesh.lies_in(t, flat))).then_some(mesh)
}

/// The vertices of a hole (clockwise) moved by `depth` across both their edges, into the hole.
fn shrunk(hole: &[DVec2], depth: f64) -> impl Iterator<Item = DVec2> + '_ {
    let n = hole.len();
    (0..n).map(move |k| {
        let (before, at, after) = (hole[(k + n - 1) % n], hole[k], hole[(k + 1) % n]);
        let across = [at - before, after - at].map(|edge| -edge.normalize().perp());
        at + depth * (across[0] + across[1]) / (1.0 + across[0].dot(across[1])).max(0.1)
    })
}

impl Mesh {
    fn area(&self, t: &[usize; 3]) -> f64 {
        signed_area(&t.map(|k| self.points[k]))
    }

    /// Whether the middle of the triangle is inside the outline and outside the holes.
    fn lies_in(&self, t: &[usize; 3], flat: &[Vec<DVec2>]) -> bool {
        let middle = t.iter().map(|k| self.points[*k]).sum::<DVec2>() / 3.0;
        encloses(&flat[0], middle) && !flat[1..].iter().any(|hole| encloses(hole, middle))
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

    /// Flips edges until none is opposite to angles of sum above π. Each flip raises the least angles, so
    /// this ends.
    fn make_delaunay(&mut self) {
        while let Some(e) = self.inner_edges().into_iter().find(|e| self.wants_flip(e)) {
            self.triangles[e.left] = [e.c, e.d, e.b];
            self.triangles[e.right] = [e.d, e.c, e.a];
        }
    }

    fn wants_flip(&self, e: &InnerEdge) -> bool {
        let opposite = |k: usize| {
            let (p, q) = (self.points[e.a] - self.points[k], self.points[e.b] - self.points[k]);
            p.angle_to(q).abs()
        };
        let flat = opposite(e.c) + opposite(e.d) <= std::f64::consts::PI + 1e-9;
        !flat && least_sine(&self.quadrilateral(e)) > 1e-9
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
