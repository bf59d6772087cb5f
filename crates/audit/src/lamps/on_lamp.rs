//! Points on the surfaces of lamps.

use std::sync::Arc;

use radiosity_geom::{DVec3, Ray, Rect, Surface};

use crate::skin::Skin;
use crate::spread::SpreadPoint;

/// A point on the surface of a lamp, for a point that sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnLamp {
    pub(super) point: DVec3,
    /// Its parameters, where anybody asks.
    pub(super) parameters: [f64; 2],
    /// Unit vector from the point that sees it.
    pub(super) along: DVec3,
    /// Density of such points per solid angle.
    pub(super) density: f64,
}

impl OnLamp {
    /// A point drawn by area, for the point `from`; None where it faces away.
    pub(super) fn of<'a>(
        on: SpreadPoint,
        from: DVec3,
        shape: impl Fn() -> &'a Arc<dyn Surface>,
        skin: &Skin,
    ) -> Option<Self> {
        let step = on.point - from;
        let squared = step.length_squared();
        let along = step / squared.sqrt();
        let leaving = -on.normal.dot(along);
        if leaving.is_nan() || leaving <= 0.0 {
            return None;
        }
        let parameters = match on.parameters {
            Some(parameters) => parameters,
            // As a ray finds them.
            None if skin.is_patterned() => {
                let shape = shape();
                let step = shape.bounds(&Rect::FULL).diagonal() * on.normal;
                let across = Ray::segment(on.point + step, on.point - step);
                let hit = shape.intersect(&across)?;
                [hit.u, hit.v]
            }
            None => [0.0; 2],
        };
        let density = on.density * squared / leaving;
        Some(Self { point: on.point, parameters, along, density })
    }
}
