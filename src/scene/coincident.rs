//! Whether two surfaces lie in one another: light between them, and the nearest hit of a ray, would be undefined.
//!
//! Planar regions coincide if they share a plane and some area. Other surfaces coincide if they agree at sample points
//! that every symmetry of the parameter square maps onto one another, which finds copies, turned over or not.

use radiosity_geom::{DVec3, PlanarRegion, Surface, clip_polygon, polygon_area};

/// Distance, relative to the larger extent, below which points and planes are the same.
const SAME: f64 = 1e-9;

/// Share of the smaller area two regions must have in common; touching edges have none but rounding.
const SHARED: f64 = 1e-9;

/// Whether `a` and `b` lie in one another.
pub(super) fn coincide(a: &dyn Surface, b: &dyn Surface) -> bool {
    match (a.region(), b.region()) {
        (Some(a), Some(b)) => same_plane(a, b) && common_area(a, b) > SHARED * a.area().min(b.area()),
        (None, None) => same_samples(a, b),
        _ => false,
    }
}

fn same_plane(a: &PlanarRegion, b: &PlanarRegion) -> bool {
    let tolerance = SAME * a.extent().max(b.extent());
    let lies_in = |a: &PlanarRegion, b: &PlanarRegion| {
        b.outer().iter().all(|point| (*point - a.origin()).dot(a.normal()).abs() <= tolerance)
    };
    lies_in(a, b) && lies_in(b, a)
}

fn common_area(a: &PlanarRegion, b: &PlanarRegion) -> f64 {
    let (ours, theirs) = (a.convex_pieces(), b.convex_pieces());
    let pairs = ours.iter().flat_map(|our| theirs.iter().map(move |their| (our, their)));
    pairs.map(|(our, their)| polygon_area(&clip_to(our, their, b.normal()))).sum()
}

/// The part of convex `polygon` inside convex `clip`, which runs counter-clockwise about `normal`.
fn clip_to(polygon: &[DVec3], clip: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let edges = clip.iter().zip(clip.iter().cycle().skip(1));
    edges.fold(polygon.to_vec(), |rest, (from, to)| clip_polygon(&rest, *from, normal.cross(*to - *from)))
}

fn same_samples(a: &dyn Surface, b: &dyn Surface) -> bool {
    let (ours, theirs) = (samples(a), samples(b));
    let extent = ours.iter().map(|point| point.distance(ours[0])).fold(0.0, f64::max);
    let found = |point: &DVec3| theirs.iter().any(|other| other.distance(*point) <= SAME * extent);
    ours.iter().all(found)
}

/// Points at u, v = ±1 and at u, v = ±½.
fn samples(surface: &dyn Surface) -> [DVec3; 8] {
    std::array::from_fn(|k| {
        let size = if k < 4 { 1.0 } else { 0.5 };
        let sign = |bit: usize| if k & bit == 0 { -size } else { size };
        surface.jet(sign(1), sign(2)).position
    })
}
