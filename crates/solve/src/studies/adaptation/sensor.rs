//! Sensors at which the error of gathered light is estimated.

use radiosity_elements::sampling::kronecker;
use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::surface_point::SurfacePoint;
use crate::solution::{Band, Solution};

use super::points::{Point, points};
use crate::goal::{Aim, Goal};

/// Most sensors of those asked for at which errors are estimated, one of each of as many equal stretches of
/// their list: they tell a mean square to some five percent where errors are alike.
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
            solution.bands().iter().map(|band| band.coating.squared(element) * area).collect()
        };
        let sensor = |element: usize, point: &Point| Self {
            point: point.receiver_point(),
            weights: weights(element, point.area),
        };
        let all = points.iter().enumerate();
        let all = all.flat_map(|(element, own)| own.iter().map(move |point| sensor(element, point)));
        all.filter(|sensor| sensor.weights.iter().any(|weight| *weight > 0.0)).collect()
    }

    /// Sensors at the points of a goal, or at some of them. All count the same, but where reflected light is
    /// seen by ρ².
    pub(super) fn at(goal: &Goal, solution: &Solution, visibility: &Visibility) -> Vec<Self> {
        let weight = |point: Option<&SurfacePoint>, band: &Band| match (goal.of, point) {
            (Aim::Seen, Some(point)) => band.coating.squared(point.element),
            _ => 1.0,
        };
        let sensor = |[position, normal]: [DVec3; 2]| {
            let point = SurfacePoint::find(solution.elements(), visibility, position, normal);
            let weights = solution.bands().iter().map(|band| weight(point.as_ref(), band)).collect();
            let free = || ReceiverPoint::free(position, normal);
            Self { point: point.map_or_else(free, |point| point.receiver_point(normal)), weights }
        };
        some(goal.points.len()).map(|index| sensor(goal.points[index])).collect()
    }
}

/// Indices of [`MOST`] of so many points, one of each equal stretch, at places that do not keep step with the
/// rows of a plane.
fn some(count: usize) -> impl Iterator<Item = usize> {
    let chosen = count.min(MOST);
    (0..chosen).map(move |k| {
        let [low, high] = [k, k + 1].map(|k| k * count / chosen);
        let [share, _] = kronecker::point(k as u64);
        low + ((high - low) as f64 * share) as usize
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn few_sensors_are_all_taken_and_many_from_every_column() {
        assert!(some(300).eq(0..300));
        assert_eq!(some(0).count(), 0);
        // A plane of 512 × 64 sensors: their columns are indices modulo 64.
        let taken: Vec<usize> = some(512 * 64).collect();
        assert!(taken.len() == MOST && taken.is_sorted_by(|a, b| a < b));
        assert_eq!(taken.iter().map(|index| index % 64).collect::<BTreeSet<_>>().len(), 64);
    }
}
