//! Whether an element lies outside a ball: only then does the ball hide what lies in the cone of its tangents.

use radiosity_elements::Element;
use radiosity_geom::{COINCIDENT, DVec3};
use radiosity_kernel::contact::gap::point_to_polygon;
use radiosity_kernel::contact::sectors::sectors;

/// Points along each direction of a sector of a curved element that are looked at, besides its corners.
const LOOKS: usize = 6;

/// Whether no point of an element lies in the ball by more than rounding: of a flat one for certain, of a
/// curved one by the points of a grid.
pub(crate) fn lies_outside(element: &Element, center: DVec3, radius: f64) -> bool {
    let least = radius * (1.0 - COINCIDENT);
    if element.plane.is_some() {
        return element.patches.iter().all(|patch| point_to_polygon(center, &patch.polygon()) >= least);
    }
    sectors(element).iter().all(|patch| {
        let corners = patch.corners().into_iter();
        let inner = patch.cell_nodes(LOOKS).into_iter().map(|x| x.position);
        corners.chain(inner).all(|x| x.distance(center) >= least)
    })
}
