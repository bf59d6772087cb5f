//! The lune of a tilted sensor: what it sees of the surface that it stands on.
//!
//! Of the hemisphere about the sensor's normal the surface fills the part below its own horizon, a lune, at any small
//! height over it.

use std::f64::consts::PI;

use radiosity_elements::Elements;
use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;

use crate::solution::{Band, Solution, SurfacePlace};

/// Directions along each side of the lune of an emitter that is not diffuse: a jump of radiance within it errs by
/// about half of one.
const DIRECTIONS: usize = 64;

/// The lune below the horizon of a surface, as a tilted sensor on it sees it.
#[derive(Clone, Copy, Debug)]
pub struct Lune {
    /// Where the sensor stands on the surface.
    pub place: SurfacePlace,
    /// Index of the element there.
    pub element: usize,
    /// Unit normal of the surface.
    ground: DVec3,
    /// Unit normal of the sensor.
    normal: DVec3,
}

impl Lune {
    /// The lune of a receiver; None where it is not tilted against the front of a surface that it stands on.
    pub fn of(receiver: &ReceiverPoint, elements: &Elements) -> Option<Self> {
        let ReceiverPoint { position, normal, .. } = *receiver;
        let (surface, ground) = (receiver.surface?, receiver.ground?);
        let foot = elements.shape(surface).project(position);
        let parameters = [foot.u, foot.v];
        let element = elements.at(surface, parameters)?;
        Some(Self { place: SurfacePlace { surface, parameters, position }, element, ground, normal })
    }

    /// Irradiance of the sensor through the lune (W m⁻² per band), where `radiosity` (W m⁻² per band) leaves the
    /// surface. With θ between the normals, and a what it emits in a direction over its mean,
    ///
    /// ```text
    /// E = B (1 − cos θ)/2 + E₀ ( 1/π ∫₀^θ ∫₀^π a(φ, ψ) sin² ψ sin φ dψ dφ − (1 − cos θ)/2 ) ,
    /// ```
    ///
    /// φ from the sensor's horizon, ψ from the line where it meets the surface's.
    pub fn light(&self, solution: &Solution, radiosity: &[f64]) -> Vec<f64> {
        let SurfacePlace { surface, parameters, .. } = self.place;
        let part = 0.5 * (1.0 - self.ground.dot(self.normal));
        let radiances = solution.emitters().radiances;
        let emitted = match radiances.is_directed(surface) {
            true => self.mean(|into| radiances.relative(surface, into)),
            false => part,
        };
        let bands = solution.bands().iter().zip(radiosity);
        let of = |(band, radiosity): (&Band, &f64)| {
            part * radiosity + (emitted - part) * band.coating.exitance_at(self.element, parameters)
        };
        bands.map(of).collect()
    }

    /// Irradiance of the sensor through the lune (W m⁻² per band), by the polynomials of the surface.
    pub(crate) fn polynomial_light(&self, solution: &Solution) -> Vec<f64> {
        let of = |band| solution.radiosity(band, self.element, &self.place);
        let radiosity: Vec<f64> = (0..solution.bands().len()).map(of).collect();
        self.light(solution, &radiosity)
    }

    /// 1/π ∫ a cos dω over the lune; a depends on the direction towards the sensor.
    fn mean(&self, a: impl Fn(DVec3) -> f64) -> f64 {
        let Self { ground, normal, .. } = *self;
        let along = normal.cross(ground).normalize_or(normal.any_orthonormal_vector());
        // Where the surface rises over the sensor's horizon.
        let level = normal.cross(along);
        let tilt = ground.angle_between(normal);
        let place = |k: usize| (k as f64 + 0.5) / DIRECTIONS as f64;
        let each = (0..DIRECTIONS * DIRECTIONS).map(|k| {
            let (sin, cos) = (PI * place(k / DIRECTIONS)).sin_cos();
            let (rise, level_part) = (tilt * place(k % DIRECTIONS)).sin_cos();
            let direction = cos * along + sin * (rise * normal + level_part * level);
            a(-direction) * sin * sin * rise
        });
        each.sum::<f64>() * tilt / (DIRECTIONS * DIRECTIONS) as f64
    }
}
