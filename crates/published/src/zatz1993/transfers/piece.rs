//! A piece of an element: a parallelogram, a triangle, or all of a curved element.

use radiosity_elements::Element;
use radiosity_elements::frame::Frame;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, polygon_area};

/// Part of an element's area below which a piece is nothing.
const NO_PIECE: f64 = 1e-14;

/// A piece of an element, charted by the square.
#[derive(Clone, Debug)]
pub(crate) struct Piece<'a> {
    /// The element.
    pub element: &'a Element,
    /// The chart.
    pub patch: Patch,
    /// Whether it is the whole element.
    pub is_whole: bool,
}

impl<'a> Piece<'a> {
    /// The disjoint pieces that cover `element`.
    pub(crate) fn all(element: &'a Element) -> Vec<Self> {
        let pieces: Vec<Patch> = element.patches.iter().flat_map(pieces_of).collect();
        let is_whole = pieces.len() == 1;
        pieces.into_iter().map(|patch| Self { element, patch, is_whole }).collect()
    }

    /// The pieces over convex polygons of the element's plane, triangles and parallelograms; those without
    /// area are left out.
    pub(super) fn parts(&self, polygons: &[Vec<DVec3>]) -> Vec<Self> {
        let Patch::Flat { normal, .. } = self.patch else { return vec![self.clone()] };
        let part = |polygon: &Vec<DVec3>| {
            let [a, b, c] = [polygon[0], polygon[1], polygon[2]];
            let patch = Patch::Flat { corners: [a, b, c, *polygon.last().unwrap_or(&c)], normal };
            Self { element: self.element, patch, is_whole: false }
        };
        let has_area = |polygon: &&Vec<DVec3>| polygon_area(polygon) > NO_PIECE * self.element.area;
        polygons.iter().filter(has_area).map(part).collect()
    }

    /// Start, middle and end of the sides, in order.
    pub(super) fn sides(&self) -> Vec<[DVec3; 3]> {
        let count = if self.patch.is_triangle() { 3 } else { 4 };
        let of = |k: usize| {
            let turned = self.patch.oriented(k, (k + 1) % count);
            [0.0, 0.5, 1.0].map(|s| turned.node(s, 0.0).position)
        };
        (0..count).map(of).collect()
    }

    /// The piece charted so that side number `side` lies at t = 0.
    pub(super) fn on_side(&self, side: usize) -> Self {
        let count = if self.patch.is_triangle() { 3 } else { 4 };
        Self { patch: self.patch.oriented(side, (side + 1) % count), ..self.clone() }
    }

    /// Affine coordinates that fill the piece, or those of the element's parameters.
    pub(super) fn frame(&self) -> Frame {
        let [a, b, _, d] = self.patch.corners();
        match self.patch {
            Patch::Flat { .. } => Frame::bounding(&self.patch.polygon(), [b - a, d - a]),
            Patch::Curved { .. } => self.element.basis.frame().clone(),
        }
    }
}

/// A patch, or two triangles if it is flat with four corners and no parallelogram.
fn pieces_of(patch: &Patch) -> Vec<Patch> {
    let Patch::Flat { corners: [a, b, c, d], normal } = patch else { return vec![patch.clone()] };
    if patch.is_triangle() || patch.is_parallelogram() {
        return vec![patch.clone()];
    }
    let triangle = |a: DVec3, b: DVec3, c: DVec3| Patch::Flat { corners: [a, b, c, c], normal: *normal };
    if a.distance_squared(*c) <= b.distance_squared(*d) {
        vec![triangle(*a, *b, *c), triangle(*a, *c, *d)]
    } else {
        vec![triangle(*a, *b, *d), triangle(*b, *c, *d)]
    }
}
