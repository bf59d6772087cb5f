//! Parts of two flat patches that face each other while one is translated.
//!
//! The height of a corner c of one patch over the plane of the other is h(p) = h(0) + p n·d. A patch is in
//! front of the plane, behind it or cut by it, until the first corner that is not yet in the plane reaches
//! it. Parts that face each other are a polygon that stays as it is only where the patch is in front, or
//! where it is cut and moves along the plane.

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, ROUNDING, clip_polygon};

use super::span::Span;

/// Parts that two patches show each other.
#[derive(Debug)]
pub(crate) enum Faces {
    /// Nothing, for p in the span.
    Nothing(Span),
    /// These parts, for p in the span.
    Parts([Vec<Patch>; 2], Span),
    /// Parts that change with p.
    Changing,
}

/// One patch against the plane of the other.
enum Side {
    Front(Span),
    Behind(Span),
    /// Whether the plane cuts it in a line that stays.
    Cut {
        stays: bool,
    },
}

/// A patch as a polygon, displaced by `shift`.
struct Polygon {
    corners: Vec<DVec3>,
    normal: DVec3,
}

impl Faces {
    /// Of the receiver's patch `p` and the emitter's `q`, which is displaced by `shift` and moves along
    /// `direction`; heights below `tolerance` (scene length) are zero. Only flat patches have a normal of
    /// their own: None for others.
    pub(crate) fn of([p, q]: [&Patch; 2], shift: DVec3, direction: DVec3, tolerance: f64) -> Option<Self> {
        let (receiver, emitter) = (Polygon::of(p, DVec3::ZERO)?, Polygon::of(q, shift)?);
        let sides =
            [receiver.side(&emitter, -direction, tolerance), emitter.side(&receiver, direction, tolerance)];
        Some(match sides {
            [Side::Behind(a), Side::Behind(b)] => Self::Nothing(a.hull(&b)),
            [Side::Behind(span), _] | [_, Side::Behind(span)] => Self::Nothing(span),
            [Side::Cut { stays: false }, _] | [_, Side::Cut { stays: false }] => Self::Changing,
            [of_p, of_q] => {
                let span = of_p.span().common(&of_q.span());
                let parts = [
                    of_p.part(p, &receiver, &emitter, DVec3::ZERO),
                    of_q.part(q, &emitter, &receiver, shift),
                ];
                Self::Parts(parts, span)
            }
        })
    }
}

impl Polygon {
    fn of(patch: &Patch, shift: DVec3) -> Option<Self> {
        let Patch::Flat { normal, .. } = patch else { return None };
        let corners = patch.polygon().iter().map(|c| c + shift).collect();
        Some(Self { corners, normal: *normal })
    }

    /// This polygon, which moves along `direction`, against the plane of `other`.
    fn side(&self, other: &Self, direction: DVec3, tolerance: f64) -> Side {
        let heights = self.corners.iter().map(|c| (c - other.corners[0]).dot(other.normal));
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
        let slope = other.normal.dot(direction);
        let slope = if slope.abs() <= ROUNDING * direction.length() { 0.0 } else { slope };
        if low >= -tolerance {
            Side::Front(Span::above(low.max(0.0), slope))
        } else if high <= tolerance {
            Side::Behind(Span::above(-high.min(0.0), -slope))
        } else {
            Side::Cut { stays: slope == 0.0 }
        }
    }
}

impl Side {
    fn span(&self) -> Span {
        match self {
            Self::Front(span) | Self::Behind(span) => *span,
            Self::Cut { .. } => Span::ALL,
        }
    }

    /// The part of `patch`, whose displaced polygon is `own`, in front of the plane of `other`.
    fn part(&self, patch: &Patch, own: &Polygon, other: &Polygon, shift: DVec3) -> Vec<Patch> {
        let Self::Cut { .. } = self else { return vec![patch.clone()] };
        let clipped = clip_polygon(&own.corners, other.corners[0], other.normal);
        let back: Vec<DVec3> = clipped.iter().map(|c| c - shift).collect();
        Patch::of_polygon(&back, own.normal)
    }
}
