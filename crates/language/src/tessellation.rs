//! A curved surface → flat pieces between points of it.
//!
//! The points are those of a grid of its parameters. Each cell of the grid becomes a polygon of its corners, or
//! two triangles where these lie in no plane, or one where two of them coincide, as at a pole. Pieces err by
//! κ h²/8 from a surface of curvature κ, for cells of width h.

use std::num::NonZeroUsize;

use radiosity_formats::model::Shape;
use radiosity_geom::{COINCIDENT, DVec3, PlanarRegion, Surface};

/// The flat pieces of `surface` over `count` × `count` cells, counter-clockwise seen from its front.
pub(super) fn pieces(surface: &dyn Surface, count: NonZeroUsize) -> Vec<Shape> {
    let count = count.get();
    let place = |k: usize| 2.0 * k as f64 / count as f64 - 1.0;
    let points: Vec<DVec3> = (0..=count)
        .flat_map(|i| (0..=count).map(move |j| [place(i), place(j)]))
        .map(|[u, v]| surface.jet(u, v).position)
        .collect();
    let at = |i: usize, j: usize| points[i * (count + 1) + j];
    let cells = (0..count).flat_map(|i| (0..count).map(move |j| [i, j]));
    cells
        .flat_map(|[i, j]| {
            let front = surface.jet(0.5 * (place(i) + place(i + 1)), 0.5 * (place(j) + place(j + 1))).normal;
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            flat(corners, front)
        })
        .map(|outline| Shape::Polygon { outline, holes: Vec::new() })
        .collect()
}

/// The flat pieces between four corners, some of which may coincide, with this front.
fn flat(corners: [DVec3; 4], front: DVec3) -> Vec<Vec<DVec3>> {
    let [first, second] = [corners[2] - corners[0], corners[3] - corners[1]];
    let size = first.length().max(second.length());
    let mut outline = corners.to_vec();
    outline.dedup_by(|a, b| a.distance(*b) <= COINCIDENT * size);
    if outline.len() > 1 && outline[0].distance(outline[outline.len() - 1]) <= COINCIDENT * size {
        outline.pop();
    }
    if first.cross(second).dot(front) < 0.0 {
        outline.reverse();
    }
    match outline[..] {
        [a, b, c, d] if PlanarRegion::new(outline.clone(), Vec::new()).is_err() => {
            vec![vec![a, b, c], vec![a, c, d]]
        }
        [_, _, _, ..] => vec![outline],
        _ => Vec::new(),
    }
}
