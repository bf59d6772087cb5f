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
//! borders, where their points are denser; on two levels alike. Edges near a cell lie beside it. Narrow half-shadows are looked for
//! where n ≤ 2 only: the next levels of finer rules found them in all rooms tried. An edge counts only where planes through it and a
//! point of the cell part the inner element, and where it reaches between the two.

use radiosity_geom::{DVec3, separated};

use crate::elements::patch::Patch;
use crate::kernel::pair::segment_distance;
use crate::visibility::Visibility;
use crate::visibility::rim::Rim;

/// Distance of an edge from a cell of size 1, times n², below which its shadow may be overlooked.
const NEAR: f64 = 4.0;
/// Breadth of a half-shadow in a cell of size 1, times n, below which it may be overlooked.
const NARROW: f64 = 1.0;
/// Points a direction of rules that may pass over half-shadows.
const COARSE: f64 = 2.0;
/// Overlap below this part of the size of a cell counts as touching.
const TOUCHING: f64 = 1e-9;

/// The edges of the blockers of a pair.
#[derive(Debug)]
pub(super) struct Edges {
    rims: Vec<Rim>,
    /// Points whose convex hull holds the inner element.
    inner: Vec<DVec3>,
}

impl Edges {
    /// Those of `blockers` before the inner element within the hull of `inner`.
    pub(super) fn new(blockers: &[usize], visibility: &Visibility, inner: Vec<DVec3>) -> Self {
        Self { rims: visibility.rims(blockers), inner }
    }

    /// Points whose convex hull holds the inner element.
    pub(super) fn inner(&self) -> &[DVec3] {
        &self.inner
    }

    /// Whether a rule of so many `points` a direction may pass over shadows within a cell.
    pub(super) fn may_be_passed_over(&self, cell: &Patch, points: usize) -> bool {
        let (corners, hull) = (cell.polygon(), cell.hull());
        let [along, across] = cell.extents();
        let extent = along.max(across);
        let points = points as f64;
        let is_fine = |rim: &Rim| {
            segment_distance(&corners, rim.ends) * points * points < NEAR * extent
                || points <= COARSE && self.half_shadow(rim, &corners) * points < NARROW
        };
        let reaches_between = |rim: &Rim| !separated(&hull, &self.inner, &rim.ends, TOUCHING * extent);
        self.rims.iter().any(|rim| rim.may_part(&hull, &self.inner) && is_fine(rim) && reaches_between(rim))
    }

    /// About the breadth of the half-shadow of an edge in a cell, in parts of the breadth of the cell.
    fn half_shadow(&self, rim: &Rim, cell: &[DVec3]) -> f64 {
        let [a, b] = rim.ends;
        let middle = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len() as f64;
        // Normals of the planes through the edge and either middle, as long as that is far from the edge.
        let normal = |points: &[DVec3]| (middle(points) - a).cross((b - a).normalize_or_zero());
        let breadth = |points: &[DVec3], normal: DVec3| {
            let heights = || points.iter().map(|x| (x - a).dot(normal));
            heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
        };
        breadth(&self.inner, normal(cell)) / breadth(cell, normal(&self.inner)).max(f64::MIN_POSITIVE)
    }
}
