//! Sensors at which the error of gathered light is estimated.

use radiosity_geom::DVec3;

use crate::gather::spot::Spot;
use crate::light::receiver_point::ReceiverPoint;
use crate::solution::Solution;
use crate::visibility::Visibility;

use super::points::{Point, points};

/// Most sensors of those asked for at which errors are estimated, evenly chosen. Chosen.
const MOST: usize = 512;

/// A receiver, and how much its light counts.
#[derive(Debug)]
pub(super) struct Sensor {
    pub point: ReceiverPoint,
    /// Weight of its squared error, per band.
    pub weights: Vec<f64>,
}

impl Sensor {
    /// Sensors spread over all surfaces that reflect: weights ρ² times the area that each stands for.
    pub(super) fn of_surfaces(solution: &Solution) -> Vec<Self> {
        let points = points(solution.elements().list());
        let weights = |element: usize, area: f64| -> Vec<f64> {
            solution.bands().iter().map(|band| band.coating.reflectance[element].powi(2) * area).collect()
        };
        let sensor = |element: usize, point: &Point| Self {
            point: point.vantage(),
            weights: weights(element, point.area),
        };
        let all = points.iter().enumerate();
        let all = all.flat_map(|(element, own)| own.iter().map(move |point| sensor(element, point)));
        all.filter(|sensor| sensor.weights.iter().any(|weight| *weight > 0.0)).collect()
    }

    /// Sensors at these positions with these normals, or at some of them; all count the same.
    pub(super) fn at(points: &[[DVec3; 2]], solution: &Solution, visibility: &Visibility) -> Vec<Self> {
        let step = points.len().div_ceil(MOST).max(1);
        let sensor = |[position, normal]: &[DVec3; 2]| {
            let spot = Spot::find(solution.elements(), visibility, *position, *normal);
            let free = || ReceiverPoint::free(*position, *normal);
            let point = spot.map_or_else(free, |spot| spot.vantage(*normal));
            Self { point, weights: vec![1.0; solution.bands().len()] }
        };
        points.iter().step_by(step).map(sensor).collect()
    }
}
