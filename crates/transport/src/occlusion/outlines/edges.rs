//! Edges of blockers whose shadows a rule over a cell of the outer element may miss.
//!
//! What is hidden from x varies with x on two lengths. One is the distance d of x from the edge that bounds
//! the shadow: a slit makes a strip of light of about that width. The other is the width of the penumbra, in
//! which the edge passes over the inner element,
//!
//! ```text
//! p = w d / d′ ,     w the width of the inner element across the edge, d′ its distance from the edge.
//! ```
//!
//! A Gauss rule of n points over a cell of width h may miss what is narrower than about h/n inside it and
//! h/n² at its border, where its points are denser; so may the next level. Edges near a cell are assumed at
//! its border; of a ball d is the distance from its surface. Narrow penumbras are looked for if n ≤ 2, as
//! seen from the middle of the cell, and from its corners too if high accuracy is asked: in all rooms tried,
//! finer rules found the others. An edge counts only if planes through it and a point of the cell cut the
//! inner element, and if it lies between the two.

use radiosity_elements::patch::Patch;
use radiosity_geom::{COINCIDENT, DVec3, extreme_points, separated};
use radiosity_kernel::contact::gap::{point_to_polygon, segment_distance};
use radiosity_visibility::Visibility;
use radiosity_visibility::blocker_edges::BlockerEdge;
use radiosity_visibility::bounding_ball::Ball;

use crate::tolerances::FINE_SHADOWS;

/// Distance of an edge from a cell of size 1, times n², below which its shadow may be missed: some three
/// times that of a Gauss rule's first point from the border.
const NEAR: f64 = 4.0;
/// Width of a penumbra in a cell of size 1, times n, below which it may be missed: twice the mean distance of
/// points. With a larger value more cells are divided.
const NARROW: f64 = 2.0;
/// Most points per direction of rules that may miss penumbras as seen from the middle of the cell. Found
/// enough in all rooms tried.
const COARSE: f64 = 2.0;

/// The edges of the blockers of a pair.
#[derive(Debug)]
pub(super) struct Edges {
    blockers: Vec<EdgesOfBlocker>,
    /// Points whose convex hull holds the inner element.
    inner: Vec<DVec3>,
    /// Mean of the corners of the inner element's parts.
    middle: DVec3,
}

/// The edges of one blocker.
#[derive(Debug)]
struct EdgesOfBlocker {
    /// Index of the blocker.
    blocker: usize,
    edges: Vec<BlockerEdge>,
    /// Centre and radius of the blocker, if it is a ball.
    ball: Option<(DVec3, f64)>,
}

impl Edges {
    /// The edges of `blockers`, one for each body, before an inner element whose parts have these `corners`;
    /// flat ones lie in one plane with this `normal`.
    pub(super) fn new(
        blockers: &[usize],
        visibility: &Visibility,
        corners: &[DVec3],
        normal: Option<DVec3>,
    ) -> Self {
        let edges = |blocker: &usize| EdgesOfBlocker {
            blocker: *blocker,
            edges: visibility.blocker_edges(*blocker),
            ball: visibility.ball(*blocker),
        };
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let inner = normal.map_or_else(|| corners.to_vec(), |normal| extreme_points(corners, normal));
        Self { blockers: blockers.iter().map(edges).collect(), inner, middle }
    }

    /// Points whose convex hull holds the inner element.
    pub(super) fn inner(&self) -> &[DVec3] {
        &self.inner
    }

    /// Whether a rule of `points` points per direction and this relative `accuracy` may miss shadows of
    /// `blockers` within a cell.
    pub(super) fn may_be_passed_over(
        &self,
        cell: &Patch,
        blockers: &[usize],
        points: f64,
        accuracy: f64,
    ) -> bool {
        let (corners, hull) = (cell.polygon(), cell.hull());
        let [along, across] = cell.extents();
        let extent = along.max(across);
        let is_tight = accuracy < FINE_SHADOWS;
        let is_narrow = |edge: &BlockerEdge| {
            let breadth = || {
                let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
                let rest: &[DVec3] = if is_tight { &corners } else { &[] };
                let seen = seen_breadth(&self.inner, edge, middle, rest);
                seen / seen_breadth(&corners, edge, self.middle, &[]).max(f64::MIN_POSITIVE)
            };
            (is_tight || points <= COARSE) && breadth() * points < NARROW
        };
        let (ball, near) = (Ball::around(&corners), |gap: f64| gap * points * points < NEAR * extent);
        let is_near = |edge: &BlockerEdge| {
            near(ball.gap_to_segment(edge.ends)) && near(segment_distance(&corners, edge.ends))
        };
        let reaches_between =
            |edge: &BlockerEdge| !separated(&hull, &self.inner, &edge.ends, COINCIDENT * extent);
        let is_near_ball = |(center, radius): (DVec3, f64)| {
            (point_to_polygon(center, &corners) - radius) * points * points < NEAR * extent
        };
        let mut between = self.blockers.iter().filter(|own| blockers.contains(&own.blocker));
        between.any(|own| {
            own.ball.is_some_and(is_near_ball)
                || own.edges.iter().any(|edge| {
                    edge.may_part(&hull, &self.inner)
                        && (is_near(edge) || is_narrow(edge))
                        && reaches_between(edge)
                })
        })
    }
}

/// Width of `points` as seen from `middle` across an edge, times the distance of `middle` from the edge's
/// line; the least of this and the same from each of `rest`.
fn seen_breadth(points: &[DVec3], edge: &BlockerEdge, middle: DVec3, rest: &[DVec3]) -> f64 {
    let [a, b] = edge.ends;
    let along = (b - a).normalize_or_zero();
    let breadth = |from: DVec3| {
        let normal = (from - a).cross(along);
        let heights = points.iter().map(|x| (x - a).dot(normal));
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
        high - low
    };
    rest.iter().map(|x| breadth(*x)).fold(breadth(middle), f64::min)
}
