//! The exchange of two faces of constant radiosity, hidden by nothing.
//!
//! ```text
//! w = ∬ κ dA dA ,     κ = cos⁺ cos⁺ / (π r²)                                   (length²)
//! ```
//!
//! Between flat faces in closed form ([`polygon_exchange`]), exact also where they touch; between a flat and
//! a curved one by Lambert's formula at the Gauss points of the curved one; else by the Gauss points of both.

use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::{DVec3, clip_polygon};
use radiosity_kernel::irradiance::lambert;
use radiosity_kernel::{kernel, polygon_exchange};

use super::face::Face;

/// Gauss points per direction on the first and the second face: two numbers, so that no point meets itself
/// where a face exchanges light with itself. An arbitrary choice: links are used where faces are small beside
/// their distance, and few points are enough.
const POINTS: [usize; 2] = [4, 5];

/// w of two faces, which may be one and the same.
pub(crate) fn exchange(p: &Face, q: &Face) -> f64 {
    match (p.normal, q.normal) {
        (Some(_), Some(_)) => flat(p, q),
        (Some(normal), None) => mixed(p, normal, q),
        (None, Some(normal)) => mixed(q, normal, p),
        (None, None) => curved(p, q),
    }
}

fn flat(p: &Face, q: &Face) -> f64 {
    let pairs = p.patches.iter().flat_map(|a| q.patches.iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| polygon_exchange(&a.polygon(), &b.polygon())).sum()
}

/// w of a flat face of this normal and a curved one.
fn mixed(flat: &Face, normal: DVec3, curved: &Face) -> f64 {
    let polygons: Vec<Vec<DVec3>> = flat.patches.iter().map(Patch::polygon).collect();
    let seen = |node: &Node| polygons.iter().map(|polygon| irradiance(node, polygon, normal)).sum::<f64>();
    curved.nodes(POINTS[0]).iter().map(|node| node.area * seen(node)).sum()
}

/// Irradiance at a point from a polygon of exitance 1 with this normal.
fn irradiance(at: &Node, polygon: &[DVec3], normal: DVec3) -> f64 {
    if (at.position - polygon[0]).dot(normal) <= 0.0 {
        return 0.0;
    }
    let corners = clip_polygon(polygon, at.position, at.normal);
    let corners: Vec<DVec3> = corners.iter().map(|corner| corner - at.position).collect();
    lambert::polygon(at.normal, &corners)
}

fn curved(p: &Face, q: &Face) -> f64 {
    let others = q.nodes(POINTS[1]);
    let sent = |x: &Node| others.iter().map(|y| y.area * kernel(x, y)).sum::<f64>();
    p.nodes(POINTS[0]).iter().map(|x| x.area * sent(x)).sum()
}
