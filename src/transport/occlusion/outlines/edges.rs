//! The edges of blockers, and which of them a rule over a cell of the outer element may overlook.
//!
//! What is hidden from x changes with x on two lengths: the distance d of x from an edge that bounds the shadow, as a strip of
//! light behind a slit does, and the breadth of the half-shadow, within which the edge passes over the inner element,
//!
//! ```text
//! p = w d / d′ ,     w the breadth of the inner element across the edge, d′ its distance from the edge.
//! ```
//!
//! Gauss rules of n points over a cell h wide may pass over what is narrower than about h / n within it, and h / n² at its
//! borders, where their points are denser; on two levels alike. Edges near a cell lie beside it. Narrow half-shadows are looked
//! for where n ≤ 2, about the middle of the cell, and at the corners too where much is asked: elsewhere the next levels of finer
//! rules found them in all rooms tried. An edge counts only where planes through it and a point of the cell part the inner
//! element, and where it reaches between the two.

use radiosity_geom::{COINCIDENT, DVec3, extreme_points, separated};

use crate::elements::patch::Patch;
use crate::transport::contact::flat::segment_distance;
use crate::visibility::Visibility;
use crate::visibility::blocker_edges::Rim;

/// Distance of an edge from a cell of size 1, times n², below which its shadow may be overlooked.
const NEAR: f64 = 4.0;
/// Breadth of a half-shadow in a cell of size 1, times n, below which it may be overlooked.
const NARROW: f64 = 2.0;
/// Most points a direction of rules that may pass over half-shadows as a cell sees them from its middle.
const COARSE: f64 = 2.0;
/// Relative accuracy below which the half-shadows seen from a cell's corners count: of slits that it sees edge on.
const TIGHT: f64 = 1e-4;
/// The edges of the blockers of a pair.
#[derive(Debug)]
pub(super) struct Edges {
    /// Of each blocker its own.
    rims: Vec<(usize, Vec<Rim>)>,
    /// Points whose convex hull holds the inner element.
    inner: Vec<DVec3>,
    /// Mean of the corners of its parts.
    middle: DVec3,
}

impl Edges {
    /// Those of `blockers`, one for each body, before the flat inner element whose parts have these `corners`, in a plane with
    /// that `normal`.
    pub(super) fn new(blockers: &[usize], visibility: &Visibility, corners: &[DVec3], normal: DVec3) -> Self {
        let rims = blockers.iter().map(|blocker| (*blocker, visibility.rims(*blocker))).collect();
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        Self { rims, inner: extreme_points(corners, normal), middle }
    }

    /// Points whose convex hull holds the inner element.
    pub(super) fn inner(&self) -> &[DVec3] {
        &self.inner
    }

    /// Whether a rule of so many points a direction may pass over shadows of `blockers` within a cell, where so much relative
    /// accuracy is asked.
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
        let is_tight = accuracy < TIGHT;
        let is_narrow = |rim: &Rim| {
            let breadth = || {
                let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
                let rest: &[DVec3] = if is_tight { &corners } else { &[] };
                let seen = seen_breadth(&self.inner, rim, middle, rest);
                seen / seen_breadth(&corners, rim, self.middle, &[]).max(f64::MIN_POSITIVE)
            };
            (is_tight || points <= COARSE) && breadth() * points < NARROW
        };
        let is_near = |rim: &Rim| segment_distance(&corners, rim.ends) * points * points < NEAR * extent;
        let reaches_between = |rim: &Rim| !separated(&hull, &self.inner, &rim.ends, COINCIDENT * extent);
        let near = self.rims.iter().filter(|(blocker, _)| blockers.contains(blocker));
        near.flat_map(|(_, rims)| rims).any(|rim| {
            rim.may_part(&hull, &self.inner) && (is_near(rim) || is_narrow(rim)) && reaches_between(rim)
        })
    }
}

/// Breadth of `points` across the planes through an edge and `middle`, times how far that is from the edge's line; the least of
/// that and of those of each of the `rest`.
fn seen_breadth(points: &[DVec3], rim: &Rim, middle: DVec3, rest: &[DVec3]) -> f64 {
    let [a, b] = rim.ends;
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
