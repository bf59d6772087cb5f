//! The two sides of an occlusion correction: the outer element as patches, the inner one as facets.
//!
//! The outer one is curved, or farther from the blockers relative to its size. A flat outer element is cut
//! along the sides of blockers that stand on it. Of two flat elements only the parts in front of each other
//! count.

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Plane, clip_polygon, touching};
use radiosity_kernel::contact::clip::Facet;
use radiosity_kernel::contact::gap::{point_to_polygon, polygon_distance, segment_distance};
use radiosity_kernel::contact::sectors::sectors;
use radiosity_kernel::moments::Side;
use radiosity_visibility::Visibility;
use radiosity_visibility::frustum::Frustum;

use crate::occlusion::beside_frusta::outer_sides;
use crate::occlusion::outlines::kinks::{Line, kinks};
use crate::tolerances::FINE_SHADOWS;

/// Height of a blocker's side over the plane of the outer element, relative to the side's length, up to which
/// it counts as standing there: its shadow almost jumps. With a larger value elements are cut where halving
/// would do; with a smaller one cells are halved along the side.
const STANDING: f64 = 1e-2;

/// The two sides of a pair of which at least one is flat or a disk, or both lie on the inside of one sphere.
pub(super) struct Sides {
    /// The outer element of the pair.
    pub(super) side: Side,
    /// The outer element.
    pub(super) outer: Vec<Patch>,
    /// The inner one where it is flat; none of a disk or on a sphere.
    pub(super) inner: Vec<Facet>,
}

impl Sides {
    /// The sides of a pair; a flat outer element is cut along kinks where high relative `accuracy` is asked.
    pub(super) fn of(
        pair: [&Element; 2],
        blockers: &[usize],
        visibility: &Visibility,
        accuracy: f64,
    ) -> Self {
        match pair.map(|element| element.plane.is_none()) {
            [true, true] => match outer_sides(pair, blockers, visibility) {
                [false, true] => Self { side: Side::Emitter, outer: sectors(pair[1]), inner: Vec::new() },
                _ => Self { side: Side::Receiver, outer: sectors(pair[0]), inner: Vec::new() },
            },
            [true, _] => Self { side: Side::Receiver, outer: sectors(pair[0]), inner: facets(pair[1]) },
            [_, true] => Self { side: Side::Emitter, outer: sectors(pair[1]), inner: facets(pair[0]) },
            _ => Self::of_flat(pair, blockers, visibility, accuracy),
        }
    }

    fn of_flat(pair: [&Element; 2], blockers: &[usize], visibility: &Visibility, accuracy: f64) -> Self {
        let [receivers, emitters] = facing(pair);
        let polygons =
            [&receivers, &emitters].map(|side| side.iter().map(|f| &f.corners[..]).collect::<Vec<_>>());
        let side = match outer_sides(pair, blockers, visibility) {
            [true, false] => Side::Receiver,
            [false, true] => Side::Emitter,
            _ => outer_side(&polygons, blockers, visibility),
        };
        let (outer, inner) = match side {
            Side::Receiver => (receivers, emitters),
            Side::Emitter => (emitters, receivers),
        };
        let mut parts: Vec<Facet> =
            outer.iter().flat_map(|facet| cut_along(facet, blockers, visibility)).collect();
        if accuracy < FINE_SHADOWS {
            let mut bodies = visibility.one_of_each_body(blockers);
            bodies.retain(|body| visibility.pieces(*body).is_some());
            for Line { point, across } in kinks(&outer, &inner, &bodies, visibility) {
                parts = parts.iter().flat_map(|part| halves(part, point, across)).collect();
            }
        }
        let outer =
            parts.into_iter().flat_map(|part| Patch::of_polygon(&part.corners, part.normal)).collect();
        Self { side, outer, inner }
    }
}

/// The patches of a flat element as facets.
fn facets(element: &Element) -> Vec<Facet> {
    let normal = element.plane.map_or(DVec3::ZERO, |plane| plane.normal);
    element.patches.iter().map(|patch| Facet { corners: patch.polygon(), normal }).collect()
}

/// The parts of either element's patches in front of the other's plane.
fn facing(pair: [&Element; 2]) -> [Vec<Facet>; 2] {
    let distance = pair[0].bounds().union(pair[1].bounds()).diagonal();
    let tolerance = touching(pair[0].extent.min(pair[1].extent), distance);
    [[pair[0], pair[1]], [pair[1], pair[0]]].map(|[own, other]| {
        let Some(Plane { point, normal }) = other.plane else { return Vec::new() };
        let plane = Facet { corners: vec![point], normal };
        facets(own).iter().filter_map(|facet| facet.in_front_of(&plane, tolerance)).collect()
    })
}

/// The side that is better as the outer one.
fn outer_side(polygons: &[Vec<&[DVec3]>; 2], blockers: &[usize], visibility: &Visibility) -> Side {
    let pieces = || blockers.iter().filter_map(|blocker| visibility.pieces(*blocker)).flatten();
    let frusta =
        || blockers.iter().filter_map(|blocker| visibility.frustum(*blocker)).flat_map(Frustum::faces);
    let balls = || blockers.iter().filter_map(|blocker| visibility.ball(*blocker));
    let [receiver, emitter] = polygons.each_ref().map(|side| {
        let to_pieces =
            side.iter().flat_map(|polygon| pieces().map(move |piece| polygon_distance(polygon, piece)));
        let to_balls = side.iter().flat_map(|polygon| {
            balls().map(move |(center, radius)| point_to_polygon(center, polygon) - radius)
        });
        let to_frusta =
            side.iter().flat_map(|polygon| frusta().map(move |face| polygon_distance(polygon, &face)));
        let gap = to_pieces.chain(to_frusta).chain(to_balls).fold(f64::INFINITY, f64::min);
        let corners = || side.iter().flat_map(|polygon| polygon.iter());
        let size = corners().flat_map(|a| corners().map(move |b| a.distance(*b))).fold(0.0, f64::max);
        gap / size
    });
    let fewer = polygons[1].len() < polygons[0].len();
    if emitter > receiver || (emitter == receiver && fewer) { Side::Emitter } else { Side::Receiver }
}

/// A facet cut along the sides of blockers that (almost) stand on it, and along those that pass through its
/// plane; only the parts that a side touches are cut.
fn cut_along(facet: &Facet, blockers: &[usize], visibility: &Visibility) -> Vec<Facet> {
    let mut parts = vec![facet.clone()];
    for piece in blockers.iter().filter_map(|blocker| visibility.pieces(*blocker)).flatten() {
        let above = clip_polygon(piece, facet.corners[0], facet.normal);
        let height = |x: DVec3| (x - facet.corners[0]).dot(facet.normal).abs();
        for (a, b) in above.iter().copied().zip(above.iter().copied().cycle().skip(1)) {
            if height(a).max(height(b)) <= STANDING * a.distance(b) {
                let across = facet.normal.cross(b - a);
                let (beside, met): (Vec<Facet>, Vec<Facet>) = parts
                    .into_iter()
                    .partition(|part| segment_distance(&part.corners, [a, b]) > STANDING * a.distance(b));
                parts = met.iter().flat_map(|part| halves(part, a, across)).chain(beside).collect();
            }
        }
    }
    parts
}

/// The parts of a facet on either side of the line through `point` normal to `across`.
fn halves(part: &Facet, point: DVec3, across: DVec3) -> impl Iterator<Item = Facet> {
    let sides = [across, -across].map(|inward| clip_polygon(&part.corners, point, inward));
    let normal = part.normal;
    sides.into_iter().filter(|side| side.len() > 2).map(move |corners| Facet { corners, normal })
}
