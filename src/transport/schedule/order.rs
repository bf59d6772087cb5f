//! From which of two elements a pair is integrated: by their shapes and places, never by their order in the scene.
//!
//! A rule that takes one integral within the other errs differently as its sides are exchanged. So the element that comes first
//! here is the outer one, whichever is the receiver, and A_i F_ij is the same however the scene lists its surfaces:
//!
//! 1. planar elements with curved sides, such as disks, because rules are refined over the outer element and polygons can be cut
//!    at its plane beforehand;
//! 2. polygons;
//! 3. the others, since the horizon of a plane depends on the other point only and is cut out of the other patch.
//!
//! Of two alike the larger one comes first, else that of the lower coordinates.

use std::cmp::Ordering;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::Node;

use crate::transport::contact::planes::plane_of;

/// Where on each patch places are compared: away from its middle, so that a patch and its mirror image differ.
const PLACE: (f64, f64) = (0.375, 0.4375);

/// What orders an element among others.
#[derive(Debug)]
pub(in crate::transport) struct Rank {
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
    pub(in crate::transport) fn of(element: &Element) -> Self {
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
    pub(in crate::transport) fn order(&self, other: &Self) -> Ordering {
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

#[cfg(test)]
mod tests {
    use super::*;

    use crate::elements::{Discretization, Elements};
    use crate::scene::Scene;

    /// Names of surfaces as their elements come in order.
    fn sorted(surfaces: &[(&str, &str)]) -> Vec<String> {
        let text = surfaces.iter().map(|(name, shape)| format!("[[surfaces]]\nname = {name:?}\n{shape}\n"));
        let scene = Scene::from_toml(&text.collect::<String>(), "scene").expect("it is valid");
        let elements = Elements::new(&scene, &Discretization::uniform(0, 1)).expect("all have area");
        let mut ranks: Vec<(Rank, String)> = elements
            .list()
            .iter()
            .map(|element| (Rank::of(element), scene.surfaces[element.surface].name.clone()))
            .collect();
        ranks.sort_by(|a, b| a.0.order(&b.0));
        ranks.into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn elements_come_in_one_order_however_they_are_listed() {
        let square =
            |x: f64| format!("quad = {{ vertices = [[{x}, 0, 0], [{x}, 1, 0], [{x}, 1, 1], [{x}, 0, 1]] }}");
        let [left, right] = [square(0.0), square(3.0)];
        let mut surfaces = vec![
            ("ball", "sphere = { center = [0, 0, 9], radius = 1 }"),
            ("right", &right[..]),
            ("large", "quad = { vertices = [[0, 0, 5], [2, 0, 5], [2, 2, 5], [0, 2, 5]] }"),
            ("disk", "disk = { center = [5, 0, 0], normal = [0, 0, 1], radius = 0.5 }"),
            ("left", &left[..]),
        ];
        let first = sorted(&surfaces);
        assert_eq!(first, ["disk", "large", "left", "right", "ball"]);
        surfaces.reverse();
        assert_eq!(sorted(&surfaces), first);
    }
}
