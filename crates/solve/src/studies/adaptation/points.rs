//! Points spread over all elements: those of a low-discrepancy sequence (Roberts's R2), shifted from patch to
//! patch.
//!
//! Each patch has as many; where there are more patches than points, the patches at equal steps of area have
//! one. Every discretisation has points of its own: what was refined for the sake of some would look too good
//! from the same.

use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;

use crate::solution::SurfacePlace;

/// Points in all, at least: they tell a mean square to some three percent where errors are spread evenly.
/// With fewer an error in one place may be missed; each takes a gathering.
const POINTS: usize = 1024;

/// Numbers of the sequence that are left out for each unknown of a discretisation: a prime.
const STRIDE: usize = 1009;

/// Steps of the sequence: 1/p and 1/p² with p³ = p + 1 (Roberts 2018).
const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_3];

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
