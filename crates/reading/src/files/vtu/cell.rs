//! The cells of an element.

use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::DVec3;

use super::bending::BentCells;
use super::nodes;

/// VTK's numbers of the types of cells.
const LAGRANGE_TRIANGLE: u8 = 69;
const LAGRANGE_QUADRILATERAL: u8 = 70;

/// A node of a cell.
pub(super) struct Corner {
    pub(super) position: DVec3,
    pub(super) normal: DVec3,
    /// Parameters of the surface; None where it is flat.
    pub(super) parameters: Option<[f64; 2]>,
}

/// A Lagrange cell, counter-clockwise as seen from the front.
pub(super) struct Cell {
    shape: Shape,
    degree: usize,
}

enum Shape {
    /// The corners and the normal.
    Triangle([DVec3; 3], DVec3),
    /// The chart, mirrored where it is left-handed.
    Quadrilateral { patch: Patch, is_mirrored: bool },
}

/// The cells of an element, and how far they are from it (scene length).
pub(super) fn of(element: &Element) -> (Vec<Cell>, f64) {
    let (mut cells, mut deviation) = (Vec::new(), 0.0f64);
    for patch in &element.patches {
        if let Patch::Flat { corners, normal } = patch {
            cells.extend(flat(patch, *corners, *normal, element.basis.total_degree().max(1)));
            continue;
        }
        let bent = BentCells::over(patch, element.basis.order().max(1), element.extent);
        deviation = deviation.max(bent.deviation);
        cells.extend(bent.cells.into_iter().map(|patch| quadrilateral(patch, bent.degree)));
    }
    (cells, deviation)
}

/// The cells of a flat patch: one if its chart is affine, else triangles.
fn flat(patch: &Patch, [a, b, c, d]: [DVec3; 4], normal: DVec3, degree: usize) -> Vec<Cell> {
    if !patch.is_triangle() && patch.is_parallelogram() {
        return vec![quadrilateral(patch.clone(), degree)];
    }
    let triangle = |corners: [DVec3; 3]| Cell { shape: Shape::Triangle(corners, normal), degree };
    let all = [[a, b, c], [a, c, d]].into_iter();
    all.take(if patch.is_triangle() { 1 } else { 2 })
        .map(|corners| triangle(counter_clockwise(corners, normal)))
        .collect()
}

fn counter_clockwise([a, b, c]: [DVec3; 3], normal: DVec3) -> [DVec3; 3] {
    if (b - a).cross(c - a).dot(normal) < 0.0 { [a, c, b] } else { [a, b, c] }
}

fn quadrilateral(patch: Patch, degree: usize) -> Cell {
    let is_mirrored = match &patch {
        Patch::Flat { corners: [a, b, _, d], normal } => (b - a).cross(d - a).dot(*normal) < 0.0,
        Patch::Curved { surface, origin, along, across } => {
            let middle = *origin + 0.5 * (*along + *across);
            let jet = surface.jet(middle.x, middle.y);
            jet.du.cross(jet.dv).dot(jet.normal) * along.perp_dot(*across) < 0.0
        }
    };
    Cell { shape: Shape::Quadrilateral { patch, is_mirrored }, degree }
}

impl Cell {
    /// VTK's number of its type.
    pub(super) fn kind(&self) -> u8 {
        match self.shape {
            Shape::Triangle(..) => LAGRANGE_TRIANGLE,
            Shape::Quadrilateral { .. } => LAGRANGE_QUADRILATERAL,
        }
    }

    /// Its nodes, in VTK's order.
    pub(super) fn nodes(&self) -> Vec<Corner> {
        match &self.shape {
            Shape::Triangle([a, b, c], normal) => {
                let position = |[s, t]: [f64; 2]| a + (b - a) * s + (c - a) * t;
                let corner = |at| Corner { position: position(at), normal: *normal, parameters: None };
                nodes::triangle(self.degree).into_iter().map(corner).collect()
            }
            Shape::Quadrilateral { patch, is_mirrored } => {
                let node = |[s, t]: [f64; 2]| if *is_mirrored { patch.node(t, s) } else { patch.node(s, t) };
                let corner = |at| {
                    let Node { position, normal, parameters, .. } = node(at);
                    let parameters = (!patch.is_flat()).then_some(parameters.to_array());
                    Corner { position, normal, parameters }
                };
                nodes::quadrilateral(self.degree).into_iter().map(corner).collect()
            }
        }
    }
}
