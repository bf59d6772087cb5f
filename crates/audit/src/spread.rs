//! Points on surfaces, spread by area.
//!
//! Flat surfaces, and what a rectangle of their parameters cuts out of them, are cut into triangles, on which
//! points are even. The parameters of curved ones are cut into
//! 16 × 16 cells, taken by their areas; within a cell points are even in the parameters, so that their density
//! p per area is known, nearly 1/A, and a point counts by 1/(A p).

use std::sync::Arc;

use radiosity_geom::{DVec3, PlanarRegion, Rect, Surface};

/// Cells along each parameter of a curved surface. Chosen: area elements then hardly vary within one.
const CELLS: usize = 16;

/// Points on a surface, or on a rectangle of its parameters.
#[derive(Clone, Debug)]
pub(crate) struct Spread {
    shape: Arc<dyn Surface>,
    form: Form,
    /// Area of what is spread over (scene length²), of a rectangle of a curved surface to 10⁻⁴ or so.
    area: f64,
}

#[derive(Clone, Debug)]
enum Form {
    /// Triangles, each with the sum of areas up to its end.
    Triangles { list: Vec<[DVec3; 3]>, sums: Vec<f64>, normal: DVec3 },
    /// Sums of areas of the cells, row by row.
    Cells { rect: Rect, sums: Vec<f64> },
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpreadPoint {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
    /// Its parameters; None on flat surfaces, of which few ask.
    pub(crate) parameters: Option<[f64; 2]>,
    /// Its density p per area (1 / scene length²).
    pub(crate) density: f64,
}

/// The place of a number in a sequence of sums, and the part of it that is left, in [0, 1).
fn chosen(sums: &[f64], draw: f64) -> (usize, f64) {
    let wanted = draw * sums[sums.len() - 1];
    let place = sums.partition_point(|sum| *sum <= wanted).min(sums.len() - 1);
    let before = if place == 0 { 0.0 } else { sums[place - 1] };
    (place, ((wanted - before) / (sums[place] - before)).clamp(0.0, 1.0 - f64::EPSILON))
}

impl Spread {
    /// Points on a rectangle of the parameters of `shape`.
    pub(crate) fn over(shape: &Arc<dyn Surface>, rect: Rect) -> Self {
        let form = match shape.region() {
            None => Form::Cells { rect, sums: areas_of_cells(shape.as_ref(), &rect) },
            Some(region) => {
                let list: Vec<[DVec3; 3]> = match rect == Rect::FULL {
                    true => triangles(region).collect(),
                    false => {
                        let pieces = region.convex_pieces().iter();
                        pieces.flat_map(|piece| fan(within(piece.clone(), shape.as_ref(), &rect))).collect()
                    }
                };
                let mut sum = 0.0;
                let area = |[a, b, c]: &[DVec3; 3]| 0.5 * (*b - *a).cross(*c - *a).length();
                let sums = list
                    .iter()
                    .map(|corners| {
                        sum += area(corners);
                        sum
                    })
                    .collect();
                Form::Triangles { list, sums, normal: region.normal() }
            }
        };
        let area = match &form {
            Form::Cells { sums, .. } if rect != Rect::FULL => sums[sums.len() - 1],
            _ => shape.area(),
        };
        Self { shape: Arc::clone(shape), form, area }
    }

    /// The point of two draws; None where nothing of a flat surface lies in the rectangle.
    pub(crate) fn point(&self, [s, t]: [f64; 2]) -> Option<SpreadPoint> {
        match &self.form {
            Form::Triangles { list, sums, normal } => {
                let all = *sums.last().filter(|all| **all > 0.0)?;
                let (place, s) = chosen(sums, s);
                let [a, b, c] = list[place];
                let root = s.sqrt();
                let point = (1.0 - root) * a + root * (1.0 - t) * b + root * t * c;
                Some(SpreadPoint { point, normal: *normal, parameters: None, density: all.recip() })
            }
            Form::Cells { rect, sums } => {
                let (place, s) = chosen(sums, s);
                let cell = cell(rect, place);
                let parameters = cell.at(2.0 * s - 1.0, 2.0 * t - 1.0);
                let jet = self.shape.jet(parameters[0], parameters[1]);
                let density = density(sums, place, &cell, jet.area);
                Some(SpreadPoint {
                    point: jet.position,
                    normal: jet.normal,
                    parameters: Some(parameters),
                    density,
                })
            }
        }
    }

    /// The density at which points of these parameters are drawn; of flat surfaces that of all points.
    pub(crate) fn density(&self, parameters: [f64; 2]) -> f64 {
        match &self.form {
            Form::Triangles { sums, .. } => sums[sums.len() - 1].recip(),
            Form::Cells { rect, sums } => {
                let [u, v] = parameters;
                let along = |value: f64, [low, high]: [f64; 2]| {
                    (((value - low) / (high - low) * CELLS as f64) as usize).min(CELLS - 1)
                };
                let place = along(v, rect.v) * CELLS + along(u, rect.u);
                density(sums, place, &cell(rect, place), self.shape.jet(u, v).area)
            }
        }
    }

    /// Weight of a point in means over the surface.
    pub(crate) fn weight(&self, point: &SpreadPoint) -> f64 {
        match &self.form {
            Form::Triangles { .. } => 1.0,
            Form::Cells { .. } => 1.0 / (self.area * point.density),
        }
    }
}

/// Triangles that make up a region.
pub(crate) fn triangles(region: &PlanarRegion) -> impl Iterator<Item = [DVec3; 3]> + '_ {
    region.convex_pieces().iter().flat_map(|piece| fan(piece.clone()))
}

/// Triangles that make up a convex polygon.
fn fan(corners: Vec<DVec3>) -> impl Iterator<Item = [DVec3; 3]> {
    (2..corners.len()).map(move |k| [corners[0], corners[k - 1], corners[k]])
}

/// The part of a convex piece of a flat surface that a rectangle of its parameters holds: a convex quadrilateral,
/// as lines of constant parameters are straight (I. Sutherland, G. Hodgman, *Reentrant polygon clipping*, 1974).
fn within(piece: Vec<DVec3>, shape: &dyn Surface, rect: &Rect) -> Vec<DVec3> {
    let ends = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| rect.at(u, v));
    let corners = ends.map(|[u, v]| shape.jet(u, v).position);
    // Along it the corners run counter-clockwise, whichever side is the front.
    let above = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    (0..4).fold(piece, |own, k| {
        let inward = above.cross(corners[(k + 1) % 4] - corners[k]);
        let depth = |point: DVec3| inward.dot(point - corners[k]);
        let mut left = Vec::with_capacity(own.len() + 1);
        for (i, to) in own.iter().enumerate() {
            let from = own[(i + own.len() - 1) % own.len()];
            let [before, after] = [from, *to].map(depth);
            if (before < 0.0) != (after < 0.0) {
                left.push(from.lerp(*to, before / (before - after)));
            }
            if after >= 0.0 {
                left.push(*to);
            }
        }
        left
    })
}

/// A cell by its place.
fn cell(rect: &Rect, place: usize) -> Rect {
    let side = |k: usize| [0, 1].map(|end| 2.0 * (k + end) as f64 / CELLS as f64 - 1.0);
    let ([u0, u1], [v0, v1]) = (side(place % CELLS), side(place / CELLS));
    let ([a, c], [b, d]) = (rect.at(u0, v0), rect.at(u1, v1));
    Rect { u: [a, b], v: [c, d] }
}

/// Density of points in a cell whose area element there is `element`.
fn density(sums: &[f64], place: usize, cell: &Rect, element: f64) -> f64 {
    let before = if place == 0 { 0.0 } else { sums[place - 1] };
    let share = (sums[place] - before) / sums[sums.len() - 1];
    let [du, dv] = cell.half_extent();
    share / (4.0 * du * dv * element)
}

/// Sums of the cells' areas by midpoints of 2 × 2 parts: what they err by changes which points are drawn, not
/// what they mean, as densities are of the same sums.
fn areas_of_cells(shape: &dyn Surface, rect: &Rect) -> Vec<f64> {
    let mut sum = 0.0;
    let area = |place: usize| {
        let own = cell(rect, place);
        let parts = own.quarters().map(|part| part.center()).map(|[u, v]| shape.jet(u, v).area);
        let [du, dv] = own.half_extent();
        du * dv * parts.iter().sum::<f64>()
    };
    let mut add = |place: usize| {
        sum += area(place);
        sum
    };
    (0..CELLS * CELLS).map(&mut add).collect()
}
