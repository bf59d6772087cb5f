//! Curved surfaces in the same place.

use glam::DVec3;
use radiosity_fit::outline;
use radiosity_geom::{Aabb, Bvh, COINCIDENT, PARALLEL_PLANES};

use crate::model::{Mantle, Model, Shape};
use crate::repair::copies::Copies;
use crate::repair::record::Repairs;

/// Keeps one of curved surfaces in the same place.
pub(super) fn mend(model: &mut Model, asked: Option<f64>, repairs: &mut Repairs) {
    let curved: Vec<(usize, Aabb)> = model
        .surfaces
        .iter()
        .enumerate()
        .filter_map(|(index, surface)| Some((index, bounds(&surface.shape)?)))
        .collect();
    let boxes: Vec<Aabb> = curved.iter().map(|(_, bounds)| *bounds).collect();
    let tree = Bvh::build(&boxes);
    let mut copies = Copies::of(model);
    for (own, (first, bounds)) in curved.iter().enumerate() {
        if !copies.is_there(*first) {
            continue;
        }
        for other in tree.near(bounds).into_iter().filter(|other| *other > own) {
            let second = curved[other].0;
            let [a, b] = [*first, second].map(|index| &model.surfaces[index].shape);
            if let Some(is_alike) =
                same(a, b, asked).filter(|_| copies.is_there(*first) && copies.is_there(second))
            {
                copies.settle(model, *first, second, is_alike);
            }
        }
    }
    copies.make(model, repairs);
}

/// The box around a shape that is no polygon.
fn bounds(shape: &Shape) -> Option<Aabb> {
    let around = |points: &[DVec3], reach: f64| Some(Aabb::around(points.iter().copied()).inflate(reach));
    match shape {
        Shape::Polygon { .. } => None,
        Shape::Quad(corners) => around(corners, 0.0),
        Shape::Disk { center, radius, .. } | Shape::Sphere { center, radius, .. } => {
            around(&[*center], *radius)
        }
        Shape::Cylinder { .. } | Shape::Cone { .. } => {
            let Mantle { base, axis, radii, .. } = shape.mantle()?;
            around(&[base, base + axis], radii[0].max(radii[1]))
        }
        Shape::Torus { center, major, minor, .. } => around(&[*center], major + minor),
    }
}

/// Whether two shapes are in the same place, and if so, whether their fronts are the same.
fn same(a: &Shape, b: &Shape, asked: Option<f64>) -> Option<bool> {
    let size = bounds(a)?.diagonal();
    let near = |points: &[DVec3]| outline::tolerance(points, asked).max(COINCIDENT * size);
    if let (Shape::Quad(p), Shape::Quad(q)) = (a, b) {
        return same_quad(p, q, near(p));
    }
    if let (Some(p), Some(q)) = (a.mantle(), b.mantle()) {
        return same_mantle(&p, &q, near(&[p.base, p.base + p.axis]));
    }
    let is_alike = match (a, b) {
        (Shape::Disk { normal: m, .. }, Shape::Disk { normal: n, .. }) => m.dot(*n) > 0.0,
        (Shape::Sphere { inward: own, .. }, Shape::Sphere { inward: other, .. })
        | (Shape::Torus { inward: own, .. }, Shape::Torus { inward: other, .. }) => own == other,
        _ => return None,
    };
    // The middle, the axis if there is one, and the radii.
    let ((p, r), (q, s)) = (a.numbers(), b.numbers());
    let near = near(&p[..1]);
    let is_same = p[0].distance(q[0]) <= near
        && r.iter().zip(&s).all(|(r, s)| (r - s).abs() <= near)
        && p[1..].iter().zip(&q[1..]).all(|(m, n)| are_parallel(*m, *n));
    is_same.then_some(is_alike)
}

fn are_parallel(a: DVec3, b: DVec3) -> bool {
    a.cross(b).length() <= PARALLEL_PLANES * a.length() * b.length()
}

fn same_quad(p: &[DVec3; 4], q: &[DVec3; 4], near: f64) -> Option<bool> {
    let agree = |pick: &dyn Fn(usize) -> usize| (0..4).all(|k| p[k].distance(q[pick(k) % 4]) <= near);
    if (0..4).any(|turn| agree(&|k| k + turn)) {
        return Some(true);
    }
    (0..4).any(|turn| agree(&|k| turn + 4 - k)).then_some(false)
}

fn same_mantle(p: &Mantle, q: &Mantle, near: f64) -> Option<bool> {
    let ends = |mantle: &Mantle| [mantle.base, mantle.base + mantle.axis];
    let agrees = |k: usize, l: usize| {
        ends(p)[k].distance(ends(q)[l]) <= near && (p.radii[k] - q.radii[l]).abs() <= near
    };
    let is_same = agrees(0, 0) && agrees(1, 1) || agrees(0, 1) && agrees(1, 0);
    is_same.then_some(p.inward == q.inward)
}
