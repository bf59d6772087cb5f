//! What bicubic patches share: values of 4 × 4 control nets, normals at collapsed edges, and rays cast at
//! them tile by tile.

use super::fold::{places, turns_back};
use crate::bernstein::{Coefficient, combine, restrict, weights};
use crate::slabs::Slabs;
use crate::zeros::zeros;
use crate::{Aabb, Hit, Jet, Ray, Rect, ShapeError};
use glam::{DVec2, DVec3};

/// A value with its derivatives by s, by t, and by both, s, t ∈ [0, 1].
#[derive(Clone, Copy)]
pub(super) struct Sample<T> {
    pub(super) value: T,
    pub(super) by_s: T,
    pub(super) by_t: T,
    pub(super) by_st: T,
}

/// The tensor-product cubic with coefficients `net[i][j]`, i along s.
pub(super) fn sample<T: Coefficient>(net: &[[T; 4]; 4], s: f64, t: f64) -> Sample<T> {
    let (ws, wt) = (weights(s), weights(t));
    let rows = net.each_ref().map(|row| combine(row, &wt, t));
    let (value, by_s) = combine(&rows.map(|row| row.0), &ws, s);
    let (by_t, by_st) = combine(&rows.map(|row| row.1), &ws, s);
    Sample { value, by_s, by_t, by_st }
}

/// The jet of a patch over u, v ∈ [−1, 1] from `at(u, v)`, its value and derivatives over [0, 1]².
pub(super) fn jet(u: f64, v: f64, at: impl Fn(f64, f64) -> Sample<DVec3>) -> Jet {
    let here = at(u, v);
    let cross = here.by_s.cross(here.by_t);
    let degenerate = cross.length() <= 1e-12 * (here.by_s.length_squared() + here.by_t.length_squared());
    let normal = if degenerate { limit_normal(u, v, &here, at) } else { cross.normalize() };
    Jet {
        position: here.value,
        du: 0.5 * here.by_s,
        dv: 0.5 * here.by_t,
        normal,
        area: 0.25 * cross.length(),
    }
}

/// The normal where the tangents span no plane. On an edge collapsed to a point one tangent vanishes like the
/// distance from the edge times the mixed derivative; elsewhere the normal a little farther inside has to do.
fn limit_normal(u: f64, v: f64, here: &Sample<DVec3>, at: impl Fn(f64, f64) -> Sample<DVec3>) -> DVec3 {
    let collapsed_in_t = here.by_t.length_squared() < here.by_s.length_squared();
    let limit = if collapsed_in_t {
        -u.signum() * here.by_s.cross(here.by_st)
    } else {
        -v.signum() * here.by_st.cross(here.by_t)
    };
    let size = here.by_s.length_squared() + here.by_t.length_squared() + here.by_st.length_squared();
    if limit.length() > 1e-9 * size {
        return limit.normalize();
    }
    let inside = at((1.0 - 1e-4) * u, (1.0 - 1e-4) * v);
    inside.by_s.cross(inside.by_t).normalize_or(DVec3::Z)
}

/// The control net of the part of the patch over `rect`.
pub(super) fn part<T: Coefficient>(net: &[[T; 4]; 4], rect: &Rect) -> [[T; 4]; 4] {
    let [s, t] = [rect.u, rect.v].map(|range| range.map(|w| 0.5 * (1.0 + w)));
    let rows = net.each_ref().map(|row| restrict(row, t[0], t[1]));
    let columns: [[T; 4]; 4] = std::array::from_fn(|j| restrict(&rows.map(|row| row[j]), s[0], s[1]));
    std::array::from_fn(|i| columns.map(|column| column[i]))
}

/// One of the 4 × 4 equal parts a patch is cut into, in its parameters, to look for rays only where they
/// pass.
#[derive(Clone, Debug)]
pub(super) struct Tile<T> {
    net: [[T; 4]; 4],
    bounds: Aabb,
    /// Lowest u and v.
    corner: [f64; 2],
}

/// Tiles along each parameter.
const TILES: usize = 4;

/// The tiles of a patch; `point` makes a control point of a coefficient.
pub(super) fn tiles<T: Coefficient>(net: &[[T; 4]; 4], point: impl Fn(T) -> DVec3) -> Vec<Tile<T>> {
    let width = 2.0 / TILES as f64;
    let tile = |k: usize| {
        let corner = [(k / TILES) as f64 * width - 1.0, (k % TILES) as f64 * width - 1.0];
        let [u, v] = corner.map(|w| [w, w + width]);
        let net = part(net, &Rect { u, v });
        let bounds = Aabb::around(net.as_flattened().iter().map(|x| point(*x)));
        // Room for seams and rounding.
        Tile { net, bounds: bounds.inflate(1e-8 * bounds.diagonal()), corner }
    };
    (0..TILES * TILES).map(tile).collect()
}

/// The nearest hit, or with `any` the first one found. `point` makes a point of a coefficient; `seen` a
/// multiple of its place across the ray's direction, given two unit vectors across it.
pub(super) fn cast<T: Coefficient>(
    tiles: &[Tile<T>],
    ray: &Ray,
    any: bool,
    point: impl Fn(T) -> DVec3,
    seen: impl Fn(T, [DVec3; 2]) -> DVec2,
) -> Option<Hit> {
    let (slabs, width) = (Slabs::new(ray), 2.0 / TILES as f64);
    let across: [DVec3; 2] = ray.direction.normalize().any_orthonormal_pair().into();
    let mut best: Option<Hit> = None;
    for tile in tiles {
        let end = best.map_or(ray.range[1], |hit| hit.t);
        if slabs.entry(&tile.bounds, ray.range[0], end).is_none() {
            continue;
        }
        let net = tile.net.map(|row| row.map(|x| seen(x, across)));
        zeros(&net, Hit::SEAM / width, |s, t| {
            let position = point(sample(&tile.net, s, t).value);
            let along = (position - ray.origin).dot(ray.direction) / ray.direction.length_squared();
            let hit = Hit::accept(ray, along, tile.corner[0] + s * width, tile.corner[1] + t * width);
            best = hit.map_or(best, |hit| Hit::nearer(best, hit));
            any && hit.is_some()
        });
        if any && best.is_some() {
            break;
        }
    }
    best
}

/// Refuses a patch whose normals all vanish, and a flat one that turns back on itself.
pub(super) fn check_area(field: &str, at: impl Fn(f64, f64) -> Sample<DVec3>) -> Result<(), ShapeError> {
    let samples = places().flat_map(|s| places().map(move |t| (s, t)));
    let samples: Vec<_> = samples.map(|(s, t)| at(s, t)).collect();
    let normals: Vec<DVec3> = samples.iter().map(|here| here.by_s.cross(here.by_t)).collect();
    let spans = |(here, normal): (&Sample<DVec3>, &DVec3)| {
        normal.length() > 1e-9 * (here.by_s.length_squared() + here.by_t.length_squared())
    };
    if !samples.iter().zip(&normals).any(spans) {
        return Err(ShapeError::NoArea { field: field.into() });
    }
    if turns_back(&normals) { Err(ShapeError::TurnsBack { field: field.into() }) } else { Ok(()) }
}
