//! Points spread over all elements: those of a low-discrepancy sequence (Roberts's R2), shifted from patch to patch.

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::Node;
use crate::light::receiver_point::ReceiverPoint;
use crate::solution::Place;

/// Points in all, and the fewest per patch ([`FEWEST`]). Chosen; not tuned.
const POINTS: usize = 256;
const FEWEST: usize = 1;

/// Steps of the sequence: 1/p and 1/p² with p³ = p + 1 (Roberts 2018).
const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_3];

/// A point of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub place: Place,
    /// Unit normal of the surface.
    pub normal: DVec3,
    /// Area that it stands for (m²).
    pub area: f64,
    /// Its number among the points of all elements.
    pub index: usize,
}

impl Point {
    pub(super) fn vantage(&self) -> ReceiverPoint {
        ReceiverPoint::on(self.place.surface, self.place.position, self.normal)
    }
}

/// The points of each element.
pub(super) fn points(list: &[Element]) -> Vec<Vec<Point>> {
    let patches: usize = list.iter().map(|element| element.patches.len()).sum();
    let each = POINTS.div_ceil(patches).max(FEWEST);
    let mut index = 0;
    let of = |element: &Element| {
        let mut points = Vec::with_capacity(each * element.patches.len());
        for patch in &element.patches {
            for _ in 0..each {
                let [s, t] = STEPS.map(|step| (0.5 + step * index as f64).fract());
                let Node { position, normal, parameters, area, .. } = patch.node(s, t);
                let place = Place { surface: element.surface, parameters: parameters.to_array(), position };
                points.push(Point { place, normal, area: area / each as f64, index });
                index += 1;
            }
        }
        points
    };
    list.iter().map(of).collect()
}
