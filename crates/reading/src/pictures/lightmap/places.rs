//! The points of a surface at which the light of its texels is computed.

use radiosity_elements::Elements;
use radiosity_geom::{Jet, Rect, Surface};

use crate::pictures::eye::SeenPlace;
use crate::pictures::light_field::extent::Extent;
use crate::pictures::light_field::open_part::{OpenPart, open_place};

/// Greatest distance from the open part to the centre of a texel that takes the light of its nearest point,
/// over the diagonal of a texel: interpolation inside asks for texels up to 1 away.
const REACH: f64 = 1.001;

/// The parameters of texel (i, j) of so many.
pub(super) fn parameters(size: [usize; 2], texel: [usize; 2]) -> [f64; 2] {
    let place = |k: usize, count: usize| -1.0 + 2.0 * k as f64 / (count - 1) as f64;
    [place(texel[0], size[0]), place(texel[1], size[1])]
}

/// The texels of a surface.
pub(super) struct Places<'a> {
    elements: &'a Elements,
    surface: usize,
    size: [usize; 2],
    /// Diagonal of the scene (scene length).
    diagonal: f64,
    /// The open part of a flat surface; None of a curved one.
    open: Option<OpenPart>,
    /// Longest diagonal of a texel of a flat surface (scene length).
    texel: f64,
}

impl<'a> Places<'a> {
    /// The places of so many texels of a surface in a scene of this diagonal.
    pub(super) fn of(elements: &'a Elements, surface: usize, size: [usize; 2], diagonal: f64) -> Self {
        let shape = elements.shape(surface);
        let open = shape.region().map(|_| OpenPart::of(elements, surface));
        Self { elements, surface, size, diagonal, open, texel: texel_diagonal(shape, size) }
    }

    /// The place at which the light of a texel is computed; None where no place in the open is near to it.
    pub(super) fn at(&self, texel: [usize; 2]) -> Option<SeenPlace> {
        let own = parameters(self.size, texel);
        open_place(self.elements, self.surface, self.open.as_ref(), own, REACH * self.texel, self.diagonal)
    }

    /// Diagonal of the scene (scene length).
    pub(super) fn diagonal(&self) -> f64 {
        self.diagonal
    }

    /// Longest distance of texels beside each other, along the parameters (scene length).
    pub(super) fn apart(&self) -> f64 {
        let lengths = Extent::of(self.elements.shape(self.surface)).lengths;
        (0..2).map(|axis| lengths[axis] / (self.size[axis] - 1) as f64).fold(0.0, f64::max)
    }

    /// The places of all texels, in rows of constant v.
    pub(super) fn all(&self) -> Vec<Option<SeenPlace>> {
        let [columns, rows] = self.size;
        (0..rows).flat_map(|j| (0..columns).map(move |i| [i, j])).map(|texel| self.at(texel)).collect()
    }
}

/// The longest diagonal of a texel of a flat surface (scene length).
fn texel_diagonal(shape: &dyn Surface, [columns, rows]: [usize; 2]) -> f64 {
    let corners = Rect::FULL.corners().map(|[u, v]| shape.jet(u, v));
    let diagonal = |jet: Jet| {
        let (du, dv) = (2.0 * jet.du / (columns - 1) as f64, 2.0 * jet.dv / (rows - 1) as f64);
        (du + dv).length().max((du - dv).length())
    };
    corners.into_iter().map(diagonal).fold(0.0, f64::max)
}
