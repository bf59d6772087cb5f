//! Whether an element certainly lies outside a ball: only then does the ball hide what lies in the cone of its
//! tangents.
//!
//! A polygon's distance from the centre is known. What lies on the boundary of a convex solid lies outside a
//! ball within that solid, and a sphere outside a ball beyond it. Of other curved elements the boxes around
//! their parts decide, which are halved as far as a box reaches into the ball.

use std::collections::VecDeque;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{Aabb, COINCIDENT, ConvexSolid, DVec3};
use radiosity_kernel::contact::gap::point_to_polygon;

/// Parts of a curved element that are looked at: what is not certain by then, as where it touches the ball,
/// counts as inside.
const MOST_PARTS: usize = 4096;

/// Whether no point of an element lies in the ball by more than rounding; false where that is not certain.
pub(crate) fn lies_outside(element: &Element, center: DVec3, radius: f64) -> bool {
    let least = radius * (1.0 - COINCIDENT);
    if element.plane.is_some() {
        return element.patches.iter().all(|patch| point_to_polygon(center, &patch.polygon()) >= least);
    }
    if lies_outside_by_solid(element, center, least) {
        return true;
    }
    let mut open: VecDeque<Patch> = element.patches.iter().cloned().collect();
    for _ in 0..MOST_PARTS {
        let Some(part) = open.pop_front() else { return true };
        if distance_to_box(center, &Aabb::around(part.hull())) >= least {
            continue;
        }
        if part.node(0.5, 0.5).position.distance(center) < least {
            return false;
        }
        open.extend(part.halves(part.longest().0));
    }
    false
}

/// Whether the ball lies in the convex solid on whose boundary an element lies, or outside that solid, a ball.
fn lies_outside_by_solid(element: &Element, center: DVec3, radius: f64) -> bool {
    let Some(Patch::Curved { surface, .. }) = element.patches.first() else { return false };
    match surface.solid() {
        // Its excess is no length.
        None | Some(ConvexSolid::Patch(_)) => false,
        Some(solid) => {
            let excess = solid.excess(center);
            let is_beyond = matches!(solid, ConvexSolid::Ball { .. }) && excess >= radius;
            excess <= -radius || is_beyond
        }
    }
}

fn distance_to_box(point: DVec3, bounds: &Aabb) -> f64 {
    point.distance(point.clamp(bounds.min, bounds.max))
}
