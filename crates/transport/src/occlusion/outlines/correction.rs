//! The constants of one occlusion correction.

use radiosity_elements::Element;
use radiosity_geom::{DVec3, Meridian, separated};
use radiosity_kernel::contact::clip::Facet;
use radiosity_kernel::irradiance::within_disk::SeenDisk;
use radiosity_kernel::moments::Side;
use radiosity_kernel::rules::zone::Zone;
use radiosity_visibility::Visibility;
use radiosity_visibility::bounding_ball::Ball;

use crate::occlusion::beside_frusta::{disk_meridian, have_frusta};
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

/// The inner element as points of the outer one see it.
pub(super) enum InnerShape<'a> {
    Flat(Facets),
    /// A disk, or a ring.
    Round(Rims),
    /// On the inside of the sphere that the outer element lies on too.
    OfSphere(Zone<'a>),
}

/// A flat inner element.
pub(super) struct Facets {
    /// The parts that face the outer element.
    pub(super) polygons: Vec<Vec<DVec3>>,
    /// A ball around each part.
    pub(super) balls: Vec<Ball>,
    /// Unit normal.
    pub(super) normal: DVec3,
}

/// A disk or a ring that carries a constant.
pub(super) struct Rims {
    pub(super) center: DVec3,
    /// Two unit vectors in its plane, at a right angle.
    axes: [DVec3; 2],
    /// Radius of its hole, 0 of a disk, and of its rim.
    radii: [f64; 2],
}

impl Rims {
    fn of(Meridian { origin, axis, ends, normal: _ }: Meridian) -> Self {
        let (first, second) = axis.any_orthonormal_pair();
        let [a, b] = ends.map(|end| end.x);
        Self { center: origin + ends[0].y * axis, axes: [first, second], radii: [a.min(b), a.max(b)] }
    }

    /// The disk within its rim, and that which its hole takes away, as a point sees them.
    pub(super) fn seen_from(&self, x: DVec3) -> (SeenDisk, Option<SeenDisk>) {
        let disk =
            |radius: f64| SeenDisk { center: self.center - x, axes: self.axes.map(|axis| radius * axis) };
        let [hole, rim] = self.radii;
        (disk(rim), (hole > 0.0).then(|| disk(hole)))
    }
}

/// The constants of one correction.
pub(super) struct Correction<'a> {
    pub(super) pair: [&'a Element; 2],
    pub(super) visibility: &'a Visibility,
    pub(super) edges: Edges,
    pub(super) side: Side,
    pub(super) outer: &'a Element,
    pub(super) inner: &'a Element,
    pub(super) inner_shape: InnerShape<'a>,
    /// A ball around the inner element.
    pub(super) ball: Ball,
    /// About the largest φ_k φ_l, per unit of the raw functions.
    pub(super) unit: f64,
    /// The constant raw function of the inner element, and the entry of G per unit of ∫∫κ.
    pub(super) constant: f64,
    pub(super) constants: f64,
    pub(super) points: usize,
    /// Corners of the polygons that stand for the outlines of balls.
    pub(super) ball_corners: usize,
    /// Relative accuracy of the inner integrals: 0.3 of the block's, most of which is left to the outer ones.
    pub(super) accuracy: f64,
    pub(super) limit: Limit,
    /// Whether kinks are curved, as those past cans, cones and disks, and past balls between flat elements: no cut
    /// follows them.
    pub(super) is_round: bool,
    /// Whether a blocker may pass through a curved outer element: what is hidden jumps where it does.
    pub(super) is_cut: bool,
    /// Whether one of the blockers is a can, a cone or a disk: then the shadow of each counts by itself, in closed
    /// form: the schedule has made sure that no line meets two of them and that the inner element carries a constant.
    /// Balls alone have kites, which are as fast.
    pub(super) has_frusta: bool,
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
        let unit = pair.iter().map(|element| element.basis.transform()[0]).product();
        let accuracy = (0.3 * limit.error / limit.entry).clamp(1e-14, LOOSEST_OF_OUTLINES);
        let (corners, inner_shape) = match other.plane {
            Some(plane) => {
                let polygons: Vec<Vec<DVec3>> = inner.iter().map(|facet| facet.corners.clone()).collect();
                let balls = polygons.iter().map(|polygon| Ball::around(polygon)).collect();
                (polygons.concat(), InnerShape::Flat(Facets { polygons, balls, normal: plane.normal }))
            }
            None => (other.hull.clone(), round_shape(other, visibility, accuracy)),
        };
        let has_frusta = have_frusta(blockers, visibility);
        let more_corners = if matches!(inner_shape, InnerShape::OfSphere(_)) { ON_SPHERES } else { 1 };
        Self {
            pair,
            visibility,
            ball: Ball::around(&corners),
            edges: Edges::new(blockers, visibility, &corners, other.level.map(|level| level.normal)),
            side,
            outer,
            inner: other,
            inner_shape,
            unit,
            constant: other.basis.constant(),
            constants: unit * outer.basis.constant() * other.basis.constant(),
            points: points(outer.basis.total_degree(), accuracy),
            ball_corners: ball_corners(accuracy) * more_corners,
            accuracy,
            limit,
            has_frusta,
            is_round: has_frusta
                || pair.iter().all(|element| element.plane.is_some()) && !visibility.are_planar(blockers),
            is_cut: is_cut(outer, blockers, visibility),
        }
    }
}

/// An inner element that is not flat.
fn round_shape<'a>(element: &'a Element, visibility: &Visibility, accuracy: f64) -> InnerShape<'a> {
    let zone = || Zone::of(element, accuracy).expect("both elements lie on the inside of a sphere");
    let disk = disk_meridian(element, visibility).map(|meridian| InnerShape::Round(Rims::of(meridian)));
    disk.unwrap_or_else(|| InnerShape::OfSphere(zone()))
}

/// Whether a blocker may pass through a curved element.
fn is_cut(element: &Element, blockers: &[usize], visibility: &Visibility) -> bool {
    let hull = &element.hull;
    element.plane.is_none() && blockers.iter().any(|own| !separated(hull, hull, visibility.hull(*own), 0.0))
}

/// Fewest corners that stand for a ball's outline: six kites, each of a sixth of a turn.
const FEWEST_CORNERS: usize = 12;
/// Most of them: they miss 7e-10 of a shadow.
const MOST_CORNERS: usize = 128;

/// More of them within a sphere, whose area per direction varies more over a wide shadow than light does: a
/// sixteenth of the error.
const ON_SPHERES: usize = 2;

/// Corners that stand for a ball's outline: n miss 0.2/n⁴ of a shadow; half as many again as that asks for.
fn ball_corners(accuracy: f64) -> usize {
    let corners = 1.5 * (0.2 / accuracy).sqrt().sqrt();
    (corners.ceil() as usize).clamp(FEWEST_CORNERS, MOST_CORNERS)
}

/// Points per direction of the outer rule, for functions of this degree times the inner integral, which is
/// smooth except for kinks: one point more per three digits, an estimate. Halving takes up what it misses.
fn points(degree: usize, accuracy: f64) -> usize {
    (0.5 * degree as f64 + 1.5 - accuracy.log10() / 3.0) as usize
}
