//! Parts of two flat patches that face each other while one moves.
//!
//! The height of a corner of one patch over the plane of the other is a quadratic polynomial of the variable
//! t, over 1 + t² where it turns ([`super::point_pair`]). A patch is in front of the plane, behind it or cut
//! by it, until the first corner that is not yet in the plane reaches it. Parts that face each other are a
//! polygon that stays as it is only where the patch is in front, or where it is cut and moves along the
//! plane.

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Motion, ROUNDING, clip_polygon};

use super::motion::RelativeMotion;
use super::point_pair::PointPair;
use super::span::Span;

/// Parts that two patches show each other.
#[derive(Debug)]
pub(crate) enum Faces {
    /// Nothing, for t in the span.
    Nothing(Span),
    /// These parts, for t in the span.
    Parts([Vec<Patch>; 2], Span),
    /// Parts that change with t.
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

/// A patch as a polygon, where it is.
struct Polygon {
    corners: Vec<DVec3>,
    normal: DVec3,
}

/// How the second patch moves from where it is, with what is rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving {
    /// Where it is.
    pub place: Motion,
    pub motion: RelativeMotion,
    /// Heights below this are zero (scene length).
    pub tolerance: f64,
}

impl Faces {
    /// Of the receiver's patch `p` and the emitter's `q`, which moves. Only flat patches have a normal of
    /// their own: None for others.
    pub(crate) fn of([p, q]: [&Patch; 2], moving: &Moving) -> Option<Self> {
        let rest = Motion::IDENTITY;
        let (receiver, emitter) = (Polygon::of(p, &rest)?, Polygon::of(q, &moving.place)?);
        let pair = |x: DVec3, y: DVec3| PointPair {
            receiver: x,
            offset: y - x,
            receiver_normal: receiver.normal,
            emitter_normal: emitter.normal,
        };
        let [x0, y0] = [receiver.corners[0], emitter.corners[0]];
        let leaving = |x: &DVec3| pair(*x, y0).heights(&moving.motion).leaving.map(|h| -h);
        let arriving = |y: &DVec3| pair(x0, *y).heights(&moving.motion).arriving;
        let sides = [
            moving.side(receiver.corners.iter().map(leaving)),
            moving.side(emitter.corners.iter().map(arriving)),
        ];
        Some(match sides {
            [Side::Behind(a), Side::Behind(b)] => Self::Nothing(a.hull(&b)),
            [Side::Behind(span), _] | [_, Side::Behind(span)] => Self::Nothing(span),
            [Side::Cut { stays: false }, _] | [_, Side::Cut { stays: false }] => Self::Changing,
            [of_p, of_q] => {
                let span = of_p.span().common(&of_q.span());
                let parts = [
                    of_p.part(p, &receiver, &emitter, &rest),
                    of_q.part(q, &emitter, &receiver, &moving.place),
                ];
                Self::Parts(parts, span)
            }
        })
    }
}

impl Moving {
    /// A patch whose corners have these heights against the plane.
    fn side(&self, heights: impl Iterator<Item = [f64; 3]>) -> Side {
        let heights: Vec<[f64; 3]> = heights.map(|h| self.rounded(h)).collect();
        let [low, high] =
            [f64::min, f64::max].map(|of| heights.iter().map(|h| h[0]).reduce(of).unwrap_or(0.0));
        let above = |sign: f64| {
            let spans = heights.iter().map(|[h, rest @ ..]| {
                let [h1, h2] = rest.map(|h| sign * h);
                Span::above([(sign * h).max(0.0), h1, h2])
            });
            spans.fold(Span::ALL, |all, span| all.common(&span))
        };
        if low >= -self.tolerance {
            Side::Front(above(1.0))
        } else if high <= self.tolerance {
            Side::Behind(above(-1.0))
        } else {
            Side::Cut { stays: heights.iter().all(|h| self.stays(h)) }
        }
    }

    /// Heights without what is rounding in their changes.
    fn rounded(&self, [h0, h1, h2]: [f64; 3]) -> [f64; 3] {
        let none_below = |h: f64, limit: f64| if h.abs() <= limit { 0.0 } else { h };
        match self.motion {
            RelativeMotion::Translation(direction) => [h0, none_below(h1, ROUNDING * direction.length()), h2],
            RelativeMotion::Rotation { .. } => [
                none_below(h0, self.tolerance),
                none_below(h1, self.tolerance),
                none_below(h2, self.tolerance),
            ],
        }
    }

    /// Whether a corner of these heights stays as high as it is.
    fn stays(&self, [h0, h1, h2]: &[f64; 3]) -> bool {
        match self.motion {
            RelativeMotion::Translation(_) => *h1 == 0.0,
            RelativeMotion::Rotation { .. } => *h1 == 0.0 && (h2 - h0).abs() <= self.tolerance,
        }
    }
}

impl Polygon {
    fn of(patch: &Patch, place: &Motion) -> Option<Self> {
        let Patch::Flat { normal, .. } = patch else { return None };
        let corners = patch.polygon().iter().map(|c| place.point(*c)).collect();
        Some(Self { corners, normal: place.direction(*normal) })
    }
}

impl Side {
    fn span(&self) -> Span {
        match self {
            Self::Front(span) | Self::Behind(span) => *span,
            Self::Cut { .. } => Span::ALL,
        }
    }

    /// The part of `patch`, which is `own` at `place`, in front of the plane of `other`.
    fn part(&self, patch: &Patch, own: &Polygon, other: &Polygon, place: &Motion) -> Vec<Patch> {
        let (Self::Cut { .. }, Patch::Flat { normal, .. }) = (self, patch) else {
            return vec![patch.clone()];
        };
        let clipped = clip_polygon(&own.corners, other.corners[0], other.normal);
        let back: Vec<DVec3> = clipped.iter().map(|c| place.point_back(*c)).collect();
        Patch::of_polygon(&back, *normal)
    }
}
