//! Parallelograms of the vectors, as elements.

use radiosity::Scene;
use radiosity::elements::cells::Layers;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::geom::shapes::Parallelogram;
use radiosity::geom::{DQuat, DVec3};
use radiosity_test_support::compare::{farthest, largest};
use radiosity_test_support::data::point;
use radiosity_test_support::scenes::grey;
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
        let [centre, along, across] = ["o", "eu", "ev"].map(|key| point(&value[key]));
        Self { centre, along, across }
    }

    pub(super) fn moved(&self, by: DVec3) -> Self {
        Self { centre: self.centre + by, ..*self }
    }

    /// Turned about an axis through `centre` by an angle (radians).
    pub(super) fn turned(&self, axis: DVec3, centre: DVec3, angle: f64) -> Self {
        let turn = |x: DVec3| DQuat::from_axis_angle(axis.normalize(), angle) * x;
        Self {
            centre: centre + turn(self.centre - centre),
            along: turn(self.along),
            across: turn(self.across),
        }
    }

    /// Area over that of the parameters, which is 4.
    pub(super) fn stretch(&self) -> f64 {
        self.along.cross(self.across).length()
    }
}

/// A scene of the quads, grey all of them.
pub(super) fn scene(quads: &[Quad]) -> Scene {
    let (mut builder, grey) = grey();
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

/// Largest difference over the largest entry of `exact`.
pub(super) fn relative(found: &[f64], exact: &[f64]) -> f64 {
    farthest(found, exact) / largest(exact)
}
