//! A point of a surface, where its light is the limit from the open side.
//!
//! A point may lie at an edge of its surface, or where other surfaces touch it. It is therefore moved slightly
//! away from these, or inwards.

use radiosity_elements::Elements;
use radiosity_geom::{DVec3, Surface, holds, overhang};
use radiosity_light::receiver_point::ReceiverPoint;

use crate::solution::SurfacePlace;

/// Part of the scene's diagonal up to which a point lies on a surface: some sixteen roundings of single
/// precision.
pub(super) const ON_SURFACE: f64 = 1e-6;
/// Part of the surface's own diagonal within which a point lies on it, if that is less.
pub(super) const OF_ITS_OWN: f64 = 1e-4;

/// Distance by which points are moved: this part of the scene's diagonal, at most the part [`AT_MOST`] of the
/// way to the middle of the piece. A tenth of [`ON_SURFACE`], so that a moved point is still found on its
/// surface.
pub(super) const INWARDS: f64 = 1e-7;
/// Largest part of the way to the middle of its piece by which a point is moved: small pieces keep their
/// light.
const AT_MOST: f64 = 1e-3;

/// A point of a surface, prepared as a receiver.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// The point for which light is computed: the foot of the given point, moved as the module says.
    pub place: SurfacePlace,
    /// Parameters of the foot before it was moved, in [−1, 1]².
    pub foot: [f64; 2],
    /// Index of the element that holds the foot.
    pub element: usize,
    /// Unit normal of the surface at the moved point.
    pub normal: DVec3,
}

/// If the unit directions away from touching surfaces sum up to less than this length, they cancel and the
/// point is moved inwards instead: between two walls face to face, to 6°, there is no way aside.
const ASIDE: f64 = 0.1;

impl SurfacePoint {
    /// The surface point at these parameters of a surface in a scene of this diagonal. None inside a hole
    /// that fills a cell.
    pub fn at(elements: &Elements, surface: usize, parameters: [f64; 2], diagonal: f64) -> Option<Self> {
        Self::within(elements, surface, parameters, INWARDS * diagonal, DVec3::ZERO)
    }

    /// The receiver point here with the unit normal `n`: the surface itself is not seen from it but in its
    /// [lune](crate::gather::lune).
    pub fn receiver_point(&self, n: DVec3) -> ReceiverPoint {
        let ground = (n != self.normal).then_some(self.normal);
        ReceiverPoint { position: self.place.position, normal: n, ground, surface: Some(self.place.surface) }
    }

    /// The surface point at the parameters `at`, moved by the length `step` along `away`, or inwards if
    /// `away` nearly vanishes.
    pub(super) fn within(
        elements: &Elements,
        surface: usize,
        at: [f64; 2],
        step: f64,
        away: DVec3,
    ) -> Option<Self> {
        let (shape, extent) = (elements.shape(surface), elements.extent(surface));
        let step = step.min(INWARDS / ON_SURFACE * OF_ITS_OWN * extent);
        let start = shape.jet(at[0], at[1]).position;
        let aside = start + step * away.normalize_or_zero();
        let is_free = shape.region().is_some_and(|region| region.contains(aside));
        let parameters = match middle_of_piece(shape, start) {
            Some(_) if away.length() > ASIDE && is_free => {
                let foot = shape.project(aside);
                [foot.u, foot.v]
            }
            Some(middle) => {
                let share = (step / middle.distance(start)).min(AT_MOST);
                let foot = shape.project(start.lerp(middle, share));
                [foot.u, foot.v]
            }
            None => at.map(|x| x * (1.0 - (step / extent).min(AT_MOST))),
        };
        let jet = shape.jet(parameters[0], parameters[1]);
        let element = elements.at(surface, parameters)?;
        let place = SurfacePlace { surface, parameters, position: jet.position };
        Some(Self { place, foot: at, element, normal: jet.normal })
    }
}

/// Middle of the convex piece of a planar surface that contains `x` or is nearest to it.
fn middle_of_piece(shape: &dyn Surface, x: DVec3) -> Option<DVec3> {
    let region = shape.region()?;
    let pieces = region.convex_pieces();
    let outside = |piece: &[DVec3]| overhang(piece, region.normal(), x);
    let nearest = || pieces.iter().min_by(|a, b| outside(a).total_cmp(&outside(b)));
    let piece = pieces.iter().find(|piece| holds(piece, region.normal(), x)).or_else(nearest)?;
    Some(piece.iter().sum::<DVec3>() / piece.len() as f64)
}
