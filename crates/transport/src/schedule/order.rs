//! The outer element of a pair: decided by shape and place, never by the order of the scene.
//!
//! A rule that takes one integral inside the other has another error when the two are exchanged. With this
//! order A_i F_ij does not depend on how the scene lists its surfaces:
//!
//! 1. planar elements with curved sides, such as disks: rules are refined over the outer element, and
//!    polygons can be cut at its plane beforehand;
//! 2. polygons;
//! 3. all others: the points of a planar outer element share one horizon, which is cut out of the inner
//!    patch.
//!
//! Of two in one class the larger comes first; of equal areas the one with the lower coordinates.

use std::cmp::Ordering;

use radiosity_elements::Element;
use radiosity_elements::patch::Node;
use radiosity_geom::DVec3;

/// Parameters of the compared point on each patch: arbitrary, but off symmetry lines, so that mirror images
/// differ.
const PLACE: (f64, f64) = (0.375, 0.4375);

/// Class, area and points of an element, by which elements are ordered.
#[derive(Debug)]
pub(crate) struct Precedence {
    class: Class,
    area: f64,
    /// A point of each patch, and its normal there.
    places: Vec<[DVec3; 2]>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Class {
    Rounded,
    Polygon,
    Curved,
}

impl Precedence {
    pub(crate) fn of(element: &Element) -> Self {
        let class = match (element.plane, element.level) {
            (Some(_), _) => Class::Polygon,
            (None, Some(_)) => Class::Rounded,
            (None, None) => Class::Curved,
        };
        let place = |node: Node| [node.position, node.normal];
        let places = element.patches.iter().map(|patch| place(patch.node(PLACE.0, PLACE.1))).collect();
        Self { class, area: element.area, places }
    }

    /// The order of two elements; equal only where they coincide.
    pub(crate) fn order(&self, other: &Self) -> Ordering {
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
    use radiosity_elements::{Discretization, Elements};

    use super::*;

    /// Names of surfaces in the order of their elements.
    fn sorted(surfaces: &[(&str, &str)]) -> Vec<String> {
        let text = surfaces.iter().map(|(name, shape)| format!("[[surfaces]]\nname = {name:?}\n{shape}\n"));
        let scene =
            radiosity_language::read(&radiosity_scene::Source::new("scene", &text.collect::<String>()))
                .expect("it is valid");
        let elements = Elements::new(&scene, &Discretization::uniform(0, 1)).expect("all have area");
        let mut ordered: Vec<(Precedence, String)> = elements
            .list()
            .iter()
            .map(|element| (Precedence::of(element), scene.surfaces[element.surface].name.clone()))
            .collect();
        ordered.sort_by(|a, b| a.0.order(&b.0));
        ordered.into_iter().map(|(_, name)| name).collect()
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
