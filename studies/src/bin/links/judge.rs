//! Irradiance at points of all surfaces, gathered from fine polynomials, and errors against it.

use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::SceneSurface;
use radiosity::solve::{Options, Transport, solve};
use radiosity::{Scene, Work};
use radiosity_geom::DVec3;

/// Points along each side of a surface.
const POINTS: usize = 9;
/// Accuracy of gathered light.
const GATHERED: f64 = 2e-4;

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
    /// Irradiance gathered from polynomials of this order, with the shadows between elements to `shadow_eps`.
    pub(crate) fn new(scene: &Scene, order: usize, shadow_eps: f64) -> Self {
        let options = Options { order, shadow_eps, transport: Transport::Exact, ..Options::default() };
        let outcome = solve(scene, &options, &Work::alone()).expect("the scene can be solved");
        let visibility = options.visibility(scene);
        let reader = Reader::new(&outcome.solution, &visibility, ReadMode::Gather, GATHERED);
        let mut points = Vec::new();
        for (surface, own) in scene.surfaces.iter().enumerate() {
            for k in 0..POINTS * POINTS {
                let place = |k: usize| (2 * k + 1) as f64 / POINTS as f64 - 1.0;
                let parameters = [place(k % POINTS), place(k / POINTS)];
                let jet = own.shape.jet(parameters[0], parameters[1]);
                let is_in_a_hole = own.shape.region().is_some_and(|region| !region.contains(jet.position));
                if is_in_a_hole {
                    continue;
                }
                let receiver = ReceiverPoint::on(surface, jet.position, jet.normal);
                let exact = reader.gathered(&receiver).expect("light is gathered").irradiance[0];
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
