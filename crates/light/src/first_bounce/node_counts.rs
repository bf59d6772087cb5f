//! Numbers of nodes of the rules for direct light and its first bounce, before any light is computed.

use radiosity_elements::patch::Patch;

use super::{DIRECT_HALVINGS, direct_points, halvings_of, reflected_halvings, reflected_points};
use crate::emitters::Emitters;

/// Numbers of nodes of rules on elements, where light peaks nowhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NodeCounts {
    /// Those for the part of d that elements send.
    pub direct: usize,
    /// Those for the part of d that luminaires and the sun send.
    pub of_points: usize,
    /// Those for g.
    pub reflected: usize,
}

impl NodeCounts {
    /// The numbers of nodes on the elements of these emitters.
    pub fn of(sources: &Emitters<'_>) -> Self {
        let for_points = halvings_of(sources.points);
        sources.elements.iter().fold(Self::default(), |sums, element| {
            let on = |halvings: usize, points: usize| (points << halvings).pow(2);
            let direct =
                |halvings: usize| element.patches.len() * on(halvings, direct_points(element, halvings));
            let reflected = |patch: &Patch| {
                let halvings = reflected_halvings(element, patch);
                on(halvings, reflected_points(element, halvings))
            };
            Self {
                direct: sums.direct + direct(DIRECT_HALVINGS),
                of_points: sums.of_points + direct(for_points),
                reflected: sums.reflected + element.patches.iter().map(reflected).sum::<usize>(),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use radiosity_elements::coating::Coating;
    use radiosity_elements::patch::Node;
    use radiosity_elements::{Discretization, Elements};
    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::Parallelogram;
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_visibility::Visibility;
    use radiosity_work::ranks::Ranks;

    use super::super::{CoatedBounce, GivenLight, NumberedNode, Peaks, coefficients};
    use super::*;
    use crate::emitters::Radiances;
    use crate::point_lights::PointLights;

    /// Rules ask for light at as many nodes as are counted, at each order.
    #[test]
    fn rules_ask_at_as_many_nodes_as_are_counted() {
        let mut builder = SceneBuilder::new("plates", ["grey"]);
        let paint = builder.material("paint", Material::new(vec![0.5], vec![1.0]).expect("a paint"));
        let plate = |z: f64, [a, b]: [DVec3; 2]| Parallelogram::new(DVec3::Z * z, a, b).expect("a plate");
        builder.surface("low", Arc::new(plate(0.0, [DVec3::X, DVec3::Y])), &paint);
        builder.surface("high", Arc::new(plate(1.0, [DVec3::Y, DVec3::X])), &paint);
        let scene = builder.build().expect("a scene");
        let visibility = Visibility::open(&scene);
        for order in 0..5 {
            let elements = Elements::new(&scene, &Discretization::uniform(order, 2)).expect("elements");
            let list = elements.list();
            let coating = Coating::reflecting(&scene, list, 0);
            let (radiances, points) = (Radiances::of(&scene), PointLights::of(&scene));
            let sources =
                Emitters { elements: list, coatings: vec![&coating], radiances: &radiances, points: &points };
            let counts = NodeCounts::of(&sources);
            let asked = AtomicUsize::new(0);
            let lit = |_: usize, _: &NumberedNode<'_>| {
                asked.fetch_add(1, Ordering::Relaxed);
                vec![1.0]
            };
            coefficients(&sources, &Peaks::NONE, &lit, Ranks::alone());
            assert_eq!(counts.direct, asked.into_inner(), "order {order}");
            assert_eq!(counts.of_points, counts.direct);
            // Without reflectance there are no tables, and light is asked for at nodes for d and g.
            let dark = Material::new(vec![0.0], vec![1.0]).expect("a paint");
            let scene = scene.with_material("paint", dark).expect("it is there");
            let coating = Coating::reflecting(&scene, list, 0);
            let sources =
                Emitters { elements: list, coatings: vec![&coating], radiances: &radiances, points: &points };
            let asked = AtomicUsize::new(0);
            let lit = |_: usize, _: &Node| {
                asked.fetch_add(1, Ordering::Relaxed);
                vec![1.0]
            };
            let light = GivenLight { lit: &lit, apart: &[] };
            CoatedBounce::of(&sources, &visibility, light, 1e-2, Ranks::alone());
            assert_eq!(asked.into_inner(), counts.direct + counts.reflected, "order {order}");
        }
    }
}
