//! The constants of one occlusion correction.

use radiosity_elements::Element;
use radiosity_geom::DVec3;
use radiosity_kernel::contact::clip::Facet;
use radiosity_kernel::moments::Side;
use radiosity_visibility::Visibility;
use radiosity_visibility::bounding_ball::Ball;

use crate::occlusion::outlines::edges::Edges;
use crate::tolerances::LOOSEST_OF_OUTLINES;

/// The accuracy asked of an occlusion correction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limit {
    /// Largest error of an entry.
    pub error: f64,
    /// About the largest entry of the unobstructed block.
    pub entry: f64,
}

/// The constants of one correction.
pub(super) struct Correction<'a> {
    pub(super) pair: [&'a Element; 2],
    pub(super) visibility: &'a Visibility,
    pub(super) edges: Edges,
    pub(super) side: Side,
    pub(super) outer: &'a Element,
    pub(super) inner: &'a Element,
    /// The parts of the inner element that face the outer one.
    pub(super) polygons: Vec<Vec<DVec3>>,
    /// A ball around each part, and one around all.
    pub(super) balls: Vec<Ball>,
    pub(super) ball: Ball,
    pub(super) normal: DVec3,
    /// About the largest φ_k φ_l, per unit of the raw functions.
    pub(super) unit: f64,
    /// The constant raw function of the inner element, and the entry of G per unit of ∫∫κ.
    pub(super) constant: f64,
    pub(super) constants: f64,
    pub(super) points: usize,
    /// Relative accuracy of the inner integrals: 0.3 of the block's, most of which is left to the outer ones.
    pub(super) accuracy: f64,
    pub(super) limit: Limit,
}

impl<'a> Correction<'a> {
    pub(super) fn new(
        pair: [&'a Element; 2],
        side: Side,
        inner: &[Facet],
        blockers: &[usize],
        visibility: &'a Visibility,
        limit: Limit,
    ) -> Self {
        let [outer, other] = match side {
            Side::Receiver => pair,
            Side::Emitter => [pair[1], pair[0]],
        };
        let corners: Vec<DVec3> = inner.iter().flat_map(|facet| facet.corners.iter().copied()).collect();
        let normal = other.plane.map_or(DVec3::ZERO, |plane| plane.normal);
        let unit = pair.iter().map(|element| element.basis.transform()[0]).product();
        let accuracy = (0.3 * limit.error / limit.entry).clamp(1e-14, LOOSEST_OF_OUTLINES);
        Self {
            pair,
            visibility,
            edges: Edges::new(blockers, visibility, &corners, normal),
            side,
            outer,
            inner: other,
            balls: inner.iter().map(|facet| Ball::around(&facet.corners)).collect(),
            ball: Ball::around(&corners),
            polygons: inner.iter().map(|facet| facet.corners.clone()).collect(),
            normal,
            unit,
            constant: other.basis.constant(),
            constants: unit * outer.basis.constant() * other.basis.constant(),
            points: points(outer.basis.total_degree(), accuracy),
            accuracy,
            limit,
        }
    }
}

/// Points per direction of the outer rule, for functions of this degree times the inner integral, which is
/// smooth except for kinks: one point more per three digits, an estimate. Halving takes up what it misses.
fn points(degree: usize, accuracy: f64) -> usize {
    (0.5 * degree as f64 + 1.5 - accuracy.log10() / 3.0) as usize
}
