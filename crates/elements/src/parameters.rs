//! The parameters of points of surfaces, which the patches of flat ones do not carry.

use radiosity_geom::{COINCIDENT, DVec3, Surface};

use super::frame::duals;
use super::patch::Node;

/// The parameters (u, v) of a point of a flat surface: by the affine map that most of them are, or else by
/// search; from −1 to 1.
pub fn parameters(shape: &dyn Surface, position: DVec3) -> [f64; 2] {
    let middle = shape.jet(0.0, 0.0);
    let offset = position - middle.position;
    let [u, v] = duals([middle.du, middle.dv]).map(|dual| offset.dot(dual));
    let size = middle.du.length() + middle.dv.length();
    if shape.jet(u, v).position.distance(position) <= COINCIDENT * size {
        return [u, v].map(|x| x.clamp(-1.0, 1.0));
    }
    let foot = shape.project(position);
    [foot.u, foot.v]
}

/// The parameters (u, v) of a node of a surface.
pub fn of_node(shape: &dyn Surface, node: &Node, is_flat: bool) -> [f64; 2] {
    if is_flat { parameters(shape, node.position) } else { node.parameters.to_array() }
}
