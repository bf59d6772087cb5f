//! Parallelograms of the vectors, as elements.

use radiosity::elements::cells::Layers;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::{Material, Scene, SceneBuilder};
use serde_json::Value;

/// x(s, t) = centre + s along + t across, s and t in [−1, 1].
#[derive(Clone, Copy, Debug)]
pub(super) struct Quad {
    pub(super) centre: DVec3,
    pub(super) along: DVec3,
    pub(super) across: DVec3,
}

impl Quad {
    pub(super) fn read(value: &Value) -> Self {
        let [centre, along, across] = ["o", "eu", "ev"].map(|key| vector(&value[key]));
        Self { centre, along, across }
    }

    pub(super) fn moved(&self, by: DVec3) -> Self {
        Self { centre: self.centre + by, ..*self }
    }

    /// Area over that of the parameters, which is 4.
    pub(super) fn stretch(&self) -> f64 {
        self.along.cross(self.across).length()
    }
}

/// A scene of the quads, grey all of them.
pub(super) fn scene(quads: &[Quad]) -> Scene {
    let mut builder = SceneBuilder::new("quads", ["grey"]);
    let material = Material::new(vec![0.5], vec![1.0]).expect("reflectance is below one");
    let grey = builder.material("grey", material);
    for (k, Quad { centre, along, across }) in quads.iter().enumerate() {
        let shape = Parallelogram::new(*centre - *along - *across, 2.0 * *along, 2.0 * *across);
        builder.surface(format!("quad {k}"), shape.expect("edges are not parallel"), &grey);
    }
    builder.build().expect("the scene is valid")
}

/// The quads as one element each; order 2 in each parameter is that of the vectors.
pub(super) fn elements(quads: &[Quad], space: Space, order: usize) -> Elements {
    let how = Discretization { order, space, subdivide: Subdivide::Uniform(1), layers: Layers::NONE };
    Elements::new(&scene(quads), &how).expect("quads have area")
}

pub(super) fn vector(value: &Value) -> DVec3 {
    let number = |k: usize| value[k].as_f64().expect("a vector has three numbers");
    DVec3::new(number(0), number(1), number(2))
}

pub(super) fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list of numbers");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

pub(super) fn read(name: &str) -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    let text = std::fs::read_to_string(path).expect("the data are there");
    serde_json::from_str(&text).expect("the data are JSON")
}

/// Largest difference over the largest entry of `exact`.
pub(super) fn relative(found: &[f64], exact: &[f64]) -> f64 {
    assert_eq!(found.len(), exact.len());
    let largest = exact.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    found.iter().zip(exact).fold(0.0f64, |most, (x, y)| most.max((x - y).abs())) / largest
}
