//! Irradiance at points of all surfaces, gathered from fine polynomials, and errors against it.

use radiosity::scene::SceneSurface;
use radiosity::solve::solved::Solved;
use radiosity::solve::{Options, Transport};
use radiosity::{Scene, Work};
use radiosity_geom::DVec3;

/// Points along each side of a surface.
const POINTS: usize = 9;

/// Where errors are measured, and the irradiance there.
pub(crate) struct Judge {
    points: Vec<Point>,
}

/// A point on a surface.
pub(crate) struct Point {
    pub surface: usize,
    pub parameters: [f64; 2],
    pub position: DVec3,
    area: f64,
    exact: f64,
}

impl Judge {
    /// Irradiance gathered from polynomials of order 5.
    pub(crate) fn new(scene: &Scene) -> Self {
        let options =
            Options { order: 5, shadow_eps: 1e-3, transport: Transport::Exact, ..Options::default() };
        let exact = Solved::new(scene.clone(), options, &Work::alone()).expect("the scene can be solved");
        let mut points = Vec::new();
        for (surface, own) in scene.surfaces.iter().enumerate() {
            for k in 0..POINTS * POINTS {
                let place = |k: usize| (2 * k + 1) as f64 / POINTS as f64 - 1.0;
                let parameters = [place(k % POINTS), place(k / POINTS)];
                let elements = exact.outcome.solution.elements();
                if elements.at(surface, parameters).is_none() {
                    continue;
                }
                let jet = own.shape.jet(parameters[0], parameters[1]);
                let exact = exact.irradiance_at(jet.position + 1e-6 * jet.normal, jet.normal)[0];
                let area = jet.du.cross(jet.dv).length();
                points.push(Point { surface, parameters, position: jet.position, area, exact });
            }
        }
        Self { points }
    }

    /// Radiosity of each surface in the mean, in parts of the power that the scene emits.
    pub(crate) fn brightness(&self, scene: &Scene) -> Vec<f64> {
        let surfaces = &scene.surfaces;
        let power: f64 = surfaces.iter().map(|own| own.exitance(0) * own.shape.area()).sum();
        let mean = |(surface, own): (usize, &SceneSurface)| {
            let points = || self.points.iter().filter(|point| point.surface == surface);
            let area: f64 = points().map(|point| point.area).sum();
            let received: f64 = points().map(|point| point.area * point.exact).sum();
            (own.exitance(0) + own.material.reflectance[0] * received / area.max(f64::MIN_POSITIVE)) / power
        };
        surfaces.iter().enumerate().map(mean).collect()
    }

    /// The relative error of irradiance in the root of the mean square, by area; `found` is asked at each point.
    pub(crate) fn error(&self, found: impl Fn(&Point) -> Option<f64>) -> f64 {
        let (mut missed, mut size) = (0.0, 0.0);
        for point in &self.points {
            let Some(found) = found(point) else { continue };
            missed += point.area * (found - point.exact).powi(2);
            size += point.area * point.exact.powi(2);
        }
        f64::sqrt(missed / size)
    }
}
