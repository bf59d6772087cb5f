//! From which of two elements a pair is integrated: by their shapes and places, never by their order in the scene.
//!
//! A rule that takes one integral within the other errs differently as its sides are exchanged. So the element that comes first
//! here is the outer one, whichever is the receiver, and F_ij is the same however the scene lists its surfaces. In this order
//! come
//!
//! 1. planar elements with curved sides, such as disks: what polygons show them is cut to size beforehand ([`super::curved`]);
//! 2. polygons;
//! 3. the others, since the horizon of a plane depends on the other point only and is cut out of the other patch;
//!
//! and among their like the larger one, then that of the lower coordinates.

use std::cmp::Ordering;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::Node;

use super::planes::plane_of;

/// Where on each patch places are compared: away from its middle, so that a patch and its mirror image differ.
const PLACE: (f64, f64) = (0.375, 0.4375);

/// What orders an element among others.
#[derive(Debug)]
pub(super) struct Rank {
    class: Class,
    area: f64,
    /// A point of each patch, and its normal.
    places: Vec<[DVec3; 2]>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    Rounded,
    Polygon,
    Curved,
}

impl Rank {
    /// Of one element.
    pub(super) fn of(element: &Element) -> Self {
        let class = match (element.plane, plane_of(&element.patches)) {
            (Some(_), _) => Class::Polygon,
            (None, Some(_)) => Class::Rounded,
            (None, None) => Class::Curved,
        };
        let place = |node: Node| [node.position, node.normal];
        let places = element.patches.iter().map(|patch| place(patch.node(PLACE.0, PLACE.1))).collect();
        Self { class, area: element.area, places }
    }

    /// Which of two elements comes first; equal only where they coincide.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        let coordinates =
            |rank: &Self| rank.places.iter().flatten().flat_map(|x| x.to_array()).collect::<Vec<f64>>();
        let by_places = || {
            let (own, theirs) = (coordinates(self), coordinates(other));
            let differing = own.iter().zip(&theirs).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
            differing.unwrap_or(own.len().cmp(&theirs.len()))
        };
        self.class.cmp(&other.class).then(other.area.total_cmp(&self.area)).then_with(by_places)
    }
}
