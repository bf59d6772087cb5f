//! Where light is read: on surfaces, in the air, and where a thing of the room is hard to read.

use glam::DVec3;

use crate::draft::Draft;
use radiosity::Scene;
use radiosity::audit::{Referee, Spot};
use radiosity_test_support::random::Random;

/// Sensors on surfaces, and in the air.
const ON_SURFACES: usize = 8;
const IN_AIR: usize = 5;

/// Distance from solids (metres), and from the walls.
const APART: f64 = 0.05;

/// Points of the scene's text, with unit normals.
pub(crate) fn all(scene: &Scene, draft: &Draft) -> Vec<[DVec3; 2]> {
    let place = |spot: Spot| match spot {
        Spot::Point { position, normal } => Some([position + scene.middle, normal]),
        _ => None,
    };
    let sample = Referee::of_light(scene).sample(ON_SURFACES, 1);
    let mut sensors: Vec<[DVec3; 2]> = sample.into_iter().filter_map(|own| place(own.spot)).collect();
    let bounds = scene.surfaces.iter().map(|own| own.shape.bounds(&radiosity::geom::Rect::FULL));
    let [low, high] = bounds.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], own| {
        [low.min(own.min), high.max(own.max)]
    });
    // Windows may lie before the wall x = 0.
    let [low, high] = [(low + scene.middle).max(DVec3::ZERO) + APART, high + scene.middle - APART];
    let mut random = Random(sensors.len() as u64 + scene.surfaces.len() as u64);
    let is_air = |x: DVec3| {
        draft.solids.iter().all(|[a, b]| (*a - APART).cmpgt(x).any() || (*b + APART).cmplt(x).any())
    };
    let mut left = IN_AIR;
    while left > 0 {
        let x = low + (high - low) * random.vector(0.0, 1.0);
        if is_air(x) {
            let normals = [DVec3::Z, random.direction()];
            sensors.push([x, random.pick(&normals)]);
            left -= 1;
        }
    }
    sensors.extend(&draft.wanted);
    sensors
}
