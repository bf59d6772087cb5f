//! The points of a surface at which the light of its texels is computed.

use radiosity_elements::Elements;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Jet, Rect, Surface, distance_to_segment, overhang, sides};
use radiosity_solve::gather::surface_point::SurfacePoint;

use crate::pictures::frame_light::eye::SeenPlace;

/// Distance that computed points keep from borders, over the surface's extent: three times as far as a
/// [`SurfacePoint`] moves a point.
const INWARDS: f64 = 3e-5;

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
}

impl<'a> Places<'a> {
    /// The places of so many texels of a surface in a scene of this diagonal.
    pub(super) fn of(elements: &'a Elements, surface: usize, size: [usize; 2], diagonal: f64) -> Self {
        let open = elements.shape(surface).region().map(|_| OpenPart::of(elements, surface, size));
        Self { elements, surface, size, diagonal, open }
    }

    /// The place at which the light of a texel is computed; None where no place in the open is near to it.
    pub(super) fn at(&self, texel: [usize; 2]) -> Option<SeenPlace> {
        let Self { elements, surface, size, .. } = *self;
        let shape = elements.shape(surface);
        let own = parameters(size, texel);
        let at = match &self.open {
            Some(open) => {
                let foot = shape.project(open.nearest(shape.jet(own[0], own[1]).position)?);
                [foot.u, foot.v]
            }
            None => own,
        };
        let SurfacePoint { place, element, normal, .. } =
            SurfacePoint::at(elements, surface, at, self.diagonal)?;
        let is_open = elements.list()[element].contact.is_none();
        is_open.then_some(SeenPlace { element, place, normal })
    }

    /// The places of all texels, in rows of constant v.
    pub(super) fn all(&self) -> Vec<Option<SeenPlace>> {
        let [columns, rows] = self.size;
        (0..rows).flat_map(|j| (0..columns).map(move |i| [i, j])).map(|texel| self.at(texel)).collect()
    }
}

/// The open part of a flat surface: no body stands on it and no sheet covers it.
struct OpenPart {
    /// Convex and disjoint polygons, counter-clockwise about the normal.
    pieces: Vec<Vec<DVec3>>,
    normal: DVec3,
    /// Distance that points keep from the border (scene length).
    inwards: f64,
    /// Greatest distance of a point outside from its nearest open point (scene length).
    reach: f64,
}

impl OpenPart {
    fn of(elements: &Elements, surface: usize, size: [usize; 2]) -> Self {
        let shape = elements.shape(surface);
        let own = &elements.list()[elements.of_surface(surface)];
        let open = own.iter().filter(|element| element.contact.is_none());
        let pieces = open.flat_map(|element| element.patches.iter().map(Patch::polygon)).collect();
        let extent = shape.bounds(&Rect::FULL).diagonal();
        Self {
            pieces,
            normal: shape.jet(0.0, 0.0).normal,
            inwards: INWARDS * extent,
            reach: REACH * texel_diagonal(shape, size),
        }
    }

    /// The nearest open point, kept a little inside; None beyond reach.
    fn nearest(&self, x: DVec3) -> Option<DVec3> {
        let outside = |piece: &[DVec3]| overhang(piece, self.normal, x);
        let inside = self.pieces.iter().find(|piece| outside(piece) <= 0.0);
        let (piece, point) = match inside {
            Some(piece) if outside(piece) < -self.inwards => return Some(x),
            Some(piece) => (piece, x),
            None => self.on_border(x)?,
        };
        let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
        let share = (self.inwards / point.distance(middle)).min(0.5);
        Some(point.lerp(middle, share))
    }

    /// The piece nearest to a point outside all, and its nearest point.
    fn on_border(&self, x: DVec3) -> Option<(&Vec<DVec3>, DVec3)> {
        let edges = self.pieces.iter().flat_map(|piece| sides(piece).map(move |side| (piece, side)));
        let far = edges.map(|(piece, [a, b])| (distance_to_segment(x, [a, b]), piece, [a, b]));
        let (distance, piece, [a, b]) = far.min_by(|one, other| one.0.total_cmp(&other.0))?;
        let along = (x - a).dot(b - a) / a.distance_squared(b);
        (distance <= self.reach).then(|| (piece, a.lerp(b, along.clamp(0.0, 1.0))))
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
