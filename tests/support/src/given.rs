//! Solutions that are given, not found: whatever reads them can be held against what was put in.

use radiosity::elements::Elements;
use radiosity::elements::coating::Coating;
use radiosity::solve::solution::{Band, Solution};
use radiosity::solve::system::Coefficients;
use radiosity::{Scene, elements};

use crate::solved::elements_of;

/// A solution of one band on undivided surfaces of this order, with the irradiance `total` everywhere, of
/// which `direct` comes straight from emitters. Materials are those of the scene.
pub fn even(scene: &Scene, order: usize, total: f64, direct: f64) -> Solution {
    let elements = elements_of(scene, order, 1);
    let times = |factor: f64| elements.constant().iter().map(|c| factor * c).collect::<Vec<f64>>();
    let coefficients = Coefficients {
        irradiance: times(total),
        direct: times(direct),
        radiosity: times(total),
        residual: 0.0,
        waiting: None,
    };
    let band = Band::new("grey".into(), &elements, coating(scene, &elements), coefficients);
    Solution::new(elements, vec![band])
}

/// The materials of the scene's first band on its elements.
pub fn coating(scene: &Scene, elements: &Elements) -> Coating {
    let of = |value: &dyn Fn(&elements::Element) -> f64| elements.list().iter().map(value).collect();
    let material = |element: &elements::Element| &scene.surfaces[element.surface].material;
    Coating::constant(of(&|e| material(e).reflectance[0]), of(&|e| material(e).emission[0]))
}
