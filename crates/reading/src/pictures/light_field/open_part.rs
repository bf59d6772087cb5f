//! The part of a flat surface that is lit, and its points nearest to others.

use crate::pictures::eye::SeenPlace;
use radiosity_elements::Elements;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Rect, distance_to_segment, overhang, sides};

/// Distance that computed points keep from borders, over the surface's extent: three times as far as a
/// surface point moves a point.
const INWARDS: f64 = 3e-5;

/// The open part of a flat surface: no body stands on it and no sheet covers it.
#[derive(Debug)]
pub(crate) struct OpenPart {
    /// Convex and disjoint polygons, counter-clockwise about the normal.
    pieces: Vec<Vec<DVec3>>,
    normal: DVec3,
    /// Distance that points keep from the border (scene length).
    inwards: f64,
}

impl OpenPart {
    /// The open part of a flat surface.
    pub(crate) fn of(elements: &Elements, surface: usize) -> Self {
        let shape = elements.shape(surface);
        let own = &elements.list()[elements.of_surface(surface)];
        let open = own.iter().filter(|element| element.contact.is_none());
        let pieces = open.flat_map(|element| element.patches.iter().map(Patch::polygon)).collect();
        let extent = shape.bounds(&Rect::FULL).diagonal();
        Self { pieces, normal: shape.jet(0.0, 0.0).normal, inwards: INWARDS * extent }
    }

    /// The open point nearest to x, kept a little inside; None where it is further than `reach` (scene length).
    fn nearest(&self, x: DVec3, reach: f64) -> Option<DVec3> {
        let outside = |piece: &[DVec3]| overhang(piece, self.normal, x);
        let inside = self.pieces.iter().find(|piece| outside(piece) <= 0.0);
        let (piece, point) = match inside {
            Some(piece) if outside(piece) < -self.inwards => return Some(x),
            Some(piece) => (piece, x),
            None => self.on_border(x, reach)?,
        };
        let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
        let share = (self.inwards / point.distance(middle)).min(0.5);
        Some(point.lerp(middle, share))
    }

    /// The piece nearest to a point outside all, and its nearest point.
    fn on_border(&self, x: DVec3, reach: f64) -> Option<(&Vec<DVec3>, DVec3)> {
        let edges = self.pieces.iter().flat_map(|piece| sides(piece).map(move |side| (piece, side)));
        let far = edges.map(|(piece, [a, b])| (distance_to_segment(x, [a, b]), piece, [a, b]));
        let (distance, piece, [a, b]) = far.min_by(|one, other| one.0.total_cmp(&other.0))?;
        let along = (x - a).dot(b - a) / a.distance_squared(b);
        (distance <= reach).then(|| (piece, a.lerp(b, along.clamp(0.0, 1.0))))
    }
}

/// The place of a surface that is nearest to these parameters, in the part `open` of a flat one; None where it is
/// further than `reach` (scene length), in a hole or under a body. The scene has this diagonal.
pub(crate) fn open_place(
    elements: &Elements,
    surface: usize,
    open: Option<&OpenPart>,
    parameters: [f64; 2],
    reach: f64,
    diagonal: f64,
) -> Option<SeenPlace> {
    let shape = elements.shape(surface);
    let at = match open {
        Some(open) => {
            let [u, v] = parameters;
            let foot = shape.project(open.nearest(shape.jet(u, v).position, reach)?);
            [foot.u, foot.v]
        }
        None => parameters,
    };
    SeenPlace::at(elements, surface, at, diagonal)
}
