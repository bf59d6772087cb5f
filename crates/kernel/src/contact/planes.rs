//! Relative position of the planes of two elements.

use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::{DVec3, Plane, ROUNDING, touching};

/// The common plane of patches that all lie in one and face the same way.
pub fn plane_of(patches: &[Patch]) -> Option<Plane> {
    let places =
        |patch: &Patch| if patch.is_flat() { vec![patch.node(0.0, 0.0)] } else { patch.cell_nodes(3) };
    let mut all = patches.iter().flat_map(places);
    let first = all.next()?;
    let is_level = |x: Node| {
        let d = x.position - first.position;
        x.normal.distance(first.normal) <= ROUNDING && d.dot(first.normal).abs() <= touching(d.length(), 0.0)
    };
    all.all(is_level).then_some(Plane { point: first.position, normal: first.normal })
}

/// Exchange of light between two elements, as far as their planes tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Planes {
    /// The elements may exchange light.
    Exchanging,
    /// One element lies behind the plane of the other: they exchange none.
    Behind,
    /// Both elements lie in one plane: they exchange none.
    Coplanar,
}

/// Heights of a corner over a plane, over the extent of its element, beyond which all corners lie on one
/// side: 1 and what rounding may add.
const FAR: f64 = 1.001;

/// Elements of one planar surface count as coplanar, however their planes were rounded.
pub fn of(receiver: &Element, emitter: &Element) -> Planes {
    if receiver.surface == emitter.surface && receiver.plane.is_some() {
        return Planes::Coplanar;
    }
    let extent = receiver.extent.min(emitter.extent);
    for (plane, other) in [(&receiver.plane, emitter), (&emitter.plane, receiver)] {
        let Some(plane) = plane else { continue };
        let [low, high] = heights(plane, other, extent);
        if high <= 0.0 {
            return if low >= 0.0 { Planes::Coplanar } else { Planes::Behind };
        }
    }
    Planes::Exchanging
}

/// Least and largest height of an element over a plane (scene length), or bounds of the same sign. Heights
/// within rounding are 0, for elements of which the smaller is `extent` wide.
fn heights(plane: &Plane, element: &Element, extent: f64) -> [f64; 2] {
    let first = plane.height(element.hull[0]);
    if first.abs() > FAR * (element.extent + touching(extent, element.hull[0].distance(plane.point))) {
        return [first; 2];
    }
    let height = |x: &DVec3| {
        let height = plane.height(*x);
        if height.abs() <= touching(extent, x.distance(plane.point)) { 0.0 } else { height }
    };
    let range = |[low, high]: [f64; 2], h: f64| [low.min(h), high.max(h)];
    element.hull.iter().map(height).fold([f64::INFINITY, f64::NEG_INFINITY], range)
}
