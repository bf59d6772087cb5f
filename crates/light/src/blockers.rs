//! Blockers of the light at a receiver point, made of the occluders around it.

use std::ops::Range;

use radiosity_geom::{Aabb, DVec3, Rect, separated};
use radiosity_visibility::Visibility;
use radiosity_visibility::shadow_volume::{Coverage, ShadowVolume};
use radiosity_visibility::tolerances::{END, OWN_END};
use smallvec::{SmallVec, smallvec};

use crate::area_light::AreaLight;
use crate::cells::cell::{Cell, MeasuredQuad};
use crate::lines::hidden_spans::{HiddenSpans, OwnPiece};
use crate::lines::projection::ProjectionPlane;
use crate::occluders::Occluders;
use crate::receiver_point::ReceiverPoint;

/// The occluders around a receiver point, as blockers seen from it.
pub(crate) struct Shadows<'a> {
    receiver: &'a ReceiverPoint,
    visibility: &'a Visibility,
    occluders: &'a Occluders,
    blockers: Vec<Blocker>,
    /// The blockers of each obstacle, made when first needed.
    of_obstacle: SmallVec<[Option<Range<usize>>; 8]>,
    /// Stack of blocker indices: the blockers of a cell lie above those of the cell that it is a quarter of.
    stack: SmallVec<[usize; 32]>,
}

#[expect(clippy::large_enum_variant, reason = "most are flat, and made for one point: boxes would cost more")]
enum Blocker {
    /// A convex planar polygon.
    Flat(ShadowVolume),
    /// A curved surface, by index.
    Curved(usize),
}

/// The blockers that may hide a part of a cell: a range of the stack of [`Shadows`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockerRange {
    start: usize,
    end: usize,
}

/// Extent of something that may be hidden: points whose convex hull contains it, and a ball around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent<'a> {
    pub hull: &'a [DVec3],
    pub center: DVec3,
    pub radius: f64,
}

/// A piece of a curved surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurvedPiece {
    /// Index of the surface.
    pub surface: usize,
    /// The parameters of it that the piece covers.
    pub parameters: Rect,
}

impl<'a> Extent<'a> {
    fn of(cell: &'a Cell) -> Self {
        Self { hull: &cell.hull, center: cell.center, radius: cell.radius }
    }
}

impl BlockerRange {
    /// Whether no blocker stands before the cell.
    pub(crate) fn is_empty(&self) -> bool {
        self.start == self.end
    }
}

impl<'a> Shadows<'a> {
    /// Blockers for a receiver point of the site that the occluders were listed for.
    pub(crate) fn new(
        receiver: &'a ReceiverPoint,
        visibility: &'a Visibility,
        occluders: &'a Occluders,
    ) -> Self {
        let of_obstacle = smallvec![None; occluders.obstacles.len()];
        Self { receiver, visibility, occluders, blockers: Vec::new(), of_obstacle, stack: SmallVec::new() }
    }

    /// Whether all obstacles are planar.
    pub(crate) fn all_flat(&self) -> bool {
        self.occluders.obstacles.iter().all(|surface| self.visibility.pieces(*surface).is_some())
    }

    /// Starts a new stack with the blockers, of obstacles with the indices `places`, that may hide a part of
    /// `bounds`.
    pub(crate) fn ask(&mut self, places: &[usize], bounds: &Aabb) -> BlockerRange {
        self.stack.clear();
        for place in places {
            // A shadow volume costs more than the test whether it is needed.
            if self.of_obstacle[*place].is_none() {
                let (surface, radius) = (self.occluders.obstacles[*place], 0.5 * bounds.diagonal());
                if self.visibility.is_apart(surface, self.receiver.position, bounds.center(), radius) {
                    continue;
                }
            }
            let blockers = self.blockers_of(*place);
            self.stack.extend(blockers);
        }
        BlockerRange { start: 0, end: self.stack.len() }
    }

    /// The blockers of the obstacle with the index `place`.
    fn blockers_of(&mut self, place: usize) -> Range<usize> {
        if let Some(range) = &self.of_obstacle[place] {
            return range.clone();
        }
        let start = self.blockers.len();
        let surface = self.occluders.obstacles[place];
        match self.visibility.pieces(surface) {
            Some(_) => self.blockers.extend(self.volumes_over(surface).into_iter().map(Blocker::Flat)),
            None => self.blockers.push(Blocker::Curved(surface)),
        }
        let range = start..self.blockers.len();
        self.of_obstacle[place] = Some(range.clone());
        range
    }

    /// The shadow volumes of a planar surface, or of its convex body, without pieces below the horizon.
    fn volumes_over(&self, surface: usize) -> SmallVec<[ShadowVolume; 1]> {
        let rises = |piece: &[DVec3]| !self.receiver.is_above(piece);
        let mut volumes = SmallVec::new();
        self.visibility.add_volumes(surface, self.receiver.position, rises, &mut volumes);
        volumes
    }

    /// The blockers between the point and an area light: shadow volumes of planar obstacles, and indices of
    /// curved ones; `places` are indices into the obstacles. None where a planar obstacle hides the whole
    /// outline of the light.
    pub(crate) fn before_lamp(
        &self,
        lamp: &AreaLight,
        plane: &ProjectionPlane,
        places: &[usize],
    ) -> Option<(Vec<ShadowVolume>, Vec<usize>)> {
        let corners: Vec<DVec3> = plane.outline.iter().map(|[s, t]| plane.at(*s, *t)).collect();
        let (mut flat, mut curved) = (Vec::new(), Vec::new());
        for place in places {
            let surface = self.occluders.obstacles[*place];
            let stands = !self.visibility.is_apart(surface, self.receiver.position, lamp.center, lamp.radius)
                && plane.reaches(&self.visibility.bounds_of(surface))
                && !lamp.is_closed_by(self.visibility.faces(&surface));
            if !stands {
                continue;
            }
            if self.visibility.pieces(surface).is_none() {
                curved.push(surface);
                continue;
            }
            for volume in self.volumes_over(surface) {
                match volume.coverage_of(&corners) {
                    Coverage::Clear => {}
                    Coverage::Hidden => return None,
                    Coverage::Mixed => flat.push(volume),
                }
            }
        }
        Some((flat, curved))
    }

    /// Whether one of the obstacles with the indices `places` hides the centre of an area light.
    pub(crate) fn hide_lamp(&self, lamp: &AreaLight, places: &[usize]) -> bool {
        let x = self.receiver.position;
        places.iter().map(|place| &self.occluders.obstacles[*place]).any(|surface| {
            let faces = self.visibility.faces(surface);
            let blocks = |face: &usize| {
                let margin = if self.stands_on(*face) { OWN_END } else { END };
                self.visibility.blocks(*face, x, lamp.center, margin)
            };
            !self.visibility.is_apart(*surface, x, lamp.center, 0.0)
                && !lamp.is_closed_by(faces)
                && faces.iter().any(blocks)
        })
    }

    /// Adds a curved blocker to the hidden spans `spans`; `own`: the piece of that blocker which the plane stands
    /// for, if it does.
    pub(crate) fn add_curved(&self, spans: &mut HiddenSpans<'a>, other: usize, own: Option<OwnPiece>) {
        let ReceiverPoint { normal, ground, surface, .. } = *self.receiver;
        let ground = self.stands_on(other).then_some(ground.unwrap_or(normal));
        let is_turned = surface != Some(other);
        spans.add_curved(self.visibility.silhouette_mesh(other), ground, is_turned, own);
    }

    /// Pushes the blockers in `above` that may hide a part of `cell` onto the stack; None where one hides all
    /// of it.
    pub(crate) fn narrow(&mut self, above: BlockerRange, cell: &Cell) -> Option<BlockerRange> {
        self.kept(above, |shadows, blocker| match blocker {
            Blocker::Flat(volume) => match &cell.quad {
                Some(MeasuredQuad { quad, radius }) => volume.coverage_of_quad(quad, *radius),
                None => volume.coverage(&cell.hull, cell.center, cell.radius),
            },
            Blocker::Curved(surface) if cell.is_flat() => {
                shadows.coverage_of_ball(*surface, &Extent::of(cell))
            }
            Blocker::Curved(surface) => shadows.curved_coverage(*surface, &Extent::of(cell)),
        })
    }

    /// As [`Shadows::narrow`], for anything.
    pub(crate) fn narrow_to(&mut self, above: BlockerRange, extent: &Extent) -> Option<BlockerRange> {
        self.kept(above, |shadows, blocker| match blocker {
            Blocker::Flat(volume) => volume.coverage(extent.hull, extent.center, extent.radius),
            Blocker::Curved(surface) => shadows.curved_coverage(*surface, extent),
        })
    }

    /// Pushes the blockers in `above` that do not leave everything clear onto the stack; None where one hides
    /// everything.
    fn kept(
        &mut self,
        above: BlockerRange,
        coverage: impl Fn(&Self, &Blocker) -> Coverage,
    ) -> Option<BlockerRange> {
        self.stack.truncate(above.end);
        for place in above.start..above.end {
            let blocker = self.stack[place];
            match coverage(self, &self.blockers[blocker]) {
                Coverage::Clear => {}
                Coverage::Hidden => return None,
                Coverage::Mixed => self.stack.push(blocker),
            }
        }
        Some(BlockerRange { start: above.end, end: self.stack.len() })
    }

    /// Whether all these blockers are planar.
    pub(crate) fn are_flat(&self, before: BlockerRange) -> bool {
        self.of(before).all(|blocker| matches!(blocker, Blocker::Flat(_)))
    }

    /// The shadow volumes of the planar blockers.
    pub(crate) fn volumes(&self, before: BlockerRange) -> impl Iterator<Item = &ShadowVolume> + Clone {
        self.of(before).filter_map(|blocker| match blocker {
            Blocker::Flat(volume) => Some(volume),
            Blocker::Curved(_) => None,
        })
    }

    /// The hidden spans on a convex planar polygon; None where the point lies in its plane.
    ///
    /// The polygon may stand for `piece`, whose convex hull is spanned by `hull`.
    pub(crate) fn hidden_spans(
        &self,
        before: BlockerRange,
        polygon: &[DVec3],
        hull: &[DVec3],
        piece: Option<CurvedPiece>,
    ) -> Option<HiddenSpans<'_>> {
        let mut spans = HiddenSpans::new(ProjectionPlane::new(self.receiver.position, polygon, hull)?);
        for blocker in self.of(before) {
            match blocker {
                Blocker::Flat(volume) => spans.add_flat(volume),
                Blocker::Curved(other) => {
                    let own = piece.and_then(|piece| self.own_piece(&piece, *other));
                    self.add_curved(&mut spans, *other, own);
                }
            }
        }
        Some(spans)
    }

    /// The piece as one of the obstacle `other`, if it is.
    fn own_piece(&self, piece: &CurvedPiece, other: usize) -> Option<OwnPiece> {
        let CurvedPiece { surface, parameters } = *piece;
        (self.visibility.sheet(surface) == other)
            .then_some(OwnPiece { parameters, is_turned: surface != other })
    }

    /// Whether the point `y` of `surface` is hidden.
    pub(crate) fn hide(&self, before: BlockerRange, y: DVec3, surface: usize) -> bool {
        let sender = self.visibility.sheet(surface);
        self.of(before).any(|blocker| match blocker {
            Blocker::Flat(volume) => volume.hides(y),
            Blocker::Curved(other) => {
                let margin = if *other == sender || self.stands_on(*other) { OWN_END } else { END };
                self.visibility.blocks(*other, self.receiver.position, y, margin)
            }
        })
    }

    /// Whether the receiver lies on an obstacle, on either side.
    fn stands_on(&self, obstacle: usize) -> bool {
        self.receiver.surface.is_some_and(|surface| self.visibility.sheet(surface) == obstacle)
    }

    fn of(&self, before: BlockerRange) -> impl Iterator<Item = &Blocker> + Clone {
        self.stack[before.start..before.end].iter().map(|blocker| &self.blockers[*blocker])
    }

    /// A curved surface hides nothing if a plane separates it from both the extent and the point.
    fn curved_coverage(&self, surface: usize, extent: &Extent) -> Coverage {
        let apart = || {
            let eye = [self.receiver.position];
            separated(&eye, extent.hull, self.visibility.hull(surface), 0.0)
        };
        match self.coverage_of_ball(surface, extent) {
            Coverage::Mixed if apart() => Coverage::Clear,
            coverage => coverage,
        }
    }

    /// A surface hides nothing if it is outside the box around the extent and the point, or too far from the
    /// segment between them.
    fn coverage_of_ball(&self, surface: usize, extent: &Extent) -> Coverage {
        let eye = self.receiver.position;
        let shaft = Aabb::around(extent.hull.iter().copied().chain([eye]));
        let bounds = self.visibility.bounds_of(surface);
        let far = || {
            let reach = 0.5 * bounds.diagonal() + extent.radius;
            distance_squared(bounds.center(), eye, extent.center) > reach * reach
        };
        if !shaft.overlaps(&bounds) || far() { Coverage::Clear } else { Coverage::Mixed }
    }
}

/// Squared distance of a point from a segment.
fn distance_squared(x: DVec3, start: DVec3, end: DVec3) -> f64 {
    let along = end - start;
    let t = ((x - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    x.distance_squared(start + along * t)
}
