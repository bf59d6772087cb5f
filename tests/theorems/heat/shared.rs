//! Scenes, and their heat at an order.

use radiosity::Work;
use radiosity::heat::{Heat, HeatError, HeatOptions, STEFAN_BOLTZMANN, SurfaceHeat};
use radiosity::solve::{Options, Transport};
use radiosity_test_support::scenes::typed;

pub(super) fn at_order(order: usize, text: &str) -> Result<Heat, HeatError> {
    to_accuracy(1e-11, order, text)
}

pub(super) fn to_accuracy(eps: f64, order: usize, text: &str) -> Result<Heat, HeatError> {
    let options = Options {
        order,
        subdivide: Some(1),
        eps,
        shadow_eps: eps,
        transport: Transport::Exact,
        tolerance: 1e-13,
        ..Options::default()
    };
    Heat::of(&typed(text), &HeatOptions { options, conductances: true }, &Work::alone())
}

pub(super) fn lumped(text: &str) -> Heat {
    at_order(0, text).unwrap_or_else(|error| panic!("{error}"))
}

/// Flat surfaces take their closed forms at any `eps`. Curved ones take longer for a smaller one, and what
/// closure tells of them does not depend on it.
pub(super) fn lumped_and_curved(text: &str) -> Heat {
    to_accuracy(1e-3, 0, text).unwrap_or_else(|error| panic!("{error}"))
}

pub(super) fn of<'a>(heat: &'a Heat, name: &str) -> &'a SurfaceHeat {
    heat.surfaces.iter().find(|own| own.name == name).unwrap()
}

pub(super) fn level(kelvin: f64) -> f64 {
    STEFAN_BOLTZMANN * kelvin.powi(4)
}

/// A unit cube with a black floor at 1000 K, a black ceiling at 500 K and adiabatic walls.
pub(super) const CUBE: &str = r#"
    materials.hot = { emissivity = 1, temperature = 1000 }
    materials.cold = { emissivity = 1, temperature = 500 }
    materials.brick = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "floor"
    material = "hot"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = "ceiling"
    material = "cold"
    quad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }
    [[surfaces]]
    name = "wall"
    material = "brick"
    box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["bottom", "top"] }
"#;
