//! Sensors at which the error of gathered light is estimated, and points spread over all elements: those of a
//! low-discrepancy sequence (Roberts's R2), shifted from patch to patch.
//!
//! Each patch has as many points; where there are more patches than points, the patches at equal steps of
//! area have one. Every discretisation has points of its own: what was refined for the sake of some would
//! look too good from the same.

use radiosity_audit::{Spot, evenly};
use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::standpoint::Standpoint;
use crate::gather::surface_point::SurfacePoint;
use crate::solution::{Band, Solution, SurfacePlace};

use crate::goal::{Aim, Goal};

/// Most sensors of those asked for at which errors are estimated, one of each of as many equal stretches of
/// their list: they tell a mean square to some five percent where errors are alike.
const MOST: usize = 512;

/// Points in all, at least: they tell a mean square to some three percent where errors are spread evenly.
/// With fewer an error in one place may be missed; each takes a gathering.
const POINTS: usize = 1024;

/// Numbers of the sequence that are left out for each unknown of a discretisation: a prime.
const STRIDE: usize = 1009;

/// Steps of the sequence: 1/p and 1/p² with p³ = p + 1 (Roberts 2018).
const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_3];

/// A receiver, and how much its light counts.
#[derive(Debug)]
pub(super) struct Sensor {
    pub point: ReceiverPoint,
    /// Weight of its squared error, per band.
    pub weights: Vec<f64>,
}

impl Sensor {
    /// Sensors spread over all surfaces that reflect: weights ρ² times the area that each stands for.
    fn of_surfaces(solution: &Solution) -> Vec<Self> {
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
    fn at(goal: &Goal, solution: &Solution, visibility: &Visibility) -> Vec<Self> {
        let weight = |point: Option<&SurfacePoint>, band: &Band| match (goal.of, point) {
            (Aim::Seen, Some(point)) => band.coating.squared(point.element),
            _ => 1.0,
        };
        let sensor = |[position, normal]: [DVec3; 2]| {
            let standpoint = Standpoint::find(solution.elements(), visibility, position, normal);
            let weights = solution.bands().iter().map(|band| weight(standpoint.on(), band)).collect();
            Self { point: standpoint.receiver_point(normal), weights }
        };
        evenly(goal.points.iter().copied(), goal.points.len(), MOST, 0).map(sensor).collect()
    }

    /// The sensors of a goal.
    pub(super) fn of(goal: &Goal, solution: &Solution, visibility: &Visibility) -> Vec<Self> {
        match goal.of {
            Aim::Points | Aim::Seen => Self::at(goal, solution, visibility),
            Aim::Gathered | Aim::Solution => Self::of_surfaces(solution),
        }
    }

    /// The place for a referee.
    pub(super) fn spot(&self) -> Spot {
        Spot::Point { position: self.point.position, normal: self.point.normal }
    }
}

/// A point of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub place: SurfacePlace,
    /// Unit normal of the surface.
    pub normal: DVec3,
    /// Area that it stands for (m²).
    pub area: f64,
}

impl Point {
    pub(super) fn receiver_point(&self) -> ReceiverPoint {
        ReceiverPoint::on(self.place.surface, self.place.position, self.normal)
    }
}

/// The points of each element.
pub(super) fn points(list: &[Element]) -> Vec<Vec<Point>> {
    let coefficients: usize = list.iter().map(|element| element.basis.len()).sum();
    let first = STRIDE * coefficients;
    let patches: usize = list.iter().map(|element| element.patches.len()).sum();
    if patches > POINTS { by_area(list, first) } else { by_patch(list, first, POINTS.div_ceil(patches)) }
}

/// Points of each element, `each` on each of its patches, from number `first` of the sequence on.
fn by_patch(list: &[Element], first: usize, each: usize) -> Vec<Vec<Point>> {
    let mut indices = first..;
    let of = |element: &Element| {
        let patches = element.patches.iter().flat_map(|patch| std::iter::repeat_n(patch, each));
        let point = |(patch, index)| {
            let (point, area) = point(element, patch, index);
            Point { area: area / each as f64, ..point }
        };
        patches.zip(&mut indices).map(point).collect()
    };
    list.iter().map(of).collect()
}

/// A point wherever another 1/[`POINTS`] of the area is full; it stands for as much.
fn by_area(list: &[Element], first: usize) -> Vec<Vec<Point>> {
    let step = list.iter().map(|element| element.area).sum::<f64>() / POINTS as f64;
    let (mut reached, mut index) = (0.5 * step, first);
    let of = |element: &Element| {
        let mut points = Vec::new();
        for patch in &element.patches {
            let whole = area(element, patch);
            reached += whole;
            while reached >= step {
                reached -= step;
                let (point, area) = point(element, patch, index);
                points.push(Point { area: step * area / whole, ..point });
                index += 1;
            }
        }
        points
    };
    list.iter().map(of).collect()
}

/// Point `index` of the sequence on a patch of an element, and the area element there.
fn point(element: &Element, patch: &Patch, index: usize) -> (Point, f64) {
    let [s, t] = STEPS.map(|step| (0.5 + step * index as f64).fract());
    let Node { position, normal, parameters, area, .. } = patch.node(s, t);
    let place = SurfacePlace { surface: element.surface, parameters: parameters.to_array(), position };
    (Point { place, normal, area }, area)
}

/// Area of a patch: that of its middle where it is flat, and curved elements have one.
fn area(element: &Element, patch: &Patch) -> f64 {
    if patch.is_flat() { patch.node(0.5, 0.5).area } else { element.area }
}
