//! Control nets of bicubic patches: values of nets of 4 × 4 points, their parts, and normals at collapsed
//! edges.

use super::fold::{places, turns_back};
use crate::bernstein::{Coefficient, combine, restrict, weights};
use crate::{Jet, Rect, ShapeError};
use glam::DVec3;

/// A value with its derivatives by s, by t, and by both, s, t ∈ [0, 1].
#[derive(Clone, Copy)]
pub(super) struct Sample<T> {
    pub(super) value: T,
    pub(super) by_s: T,
    pub(super) by_t: T,
    pub(super) by_st: T,
}

/// The tensor-product cubic with coefficients `net[i][j]`, i along s.
#[inline]
pub(super) fn sample<T: Coefficient>(net: &[[T; 4]; 4], s: f64, t: f64) -> Sample<T> {
    let (ws, wt) = (weights(s), weights(t));
    let (mut values, mut slopes) = ([net[0][0]; 4], [net[0][0]; 4]);
    for (row, (value, slope)) in net.iter().zip(values.iter_mut().zip(&mut slopes)) {
        (*value, *slope) = combine(row, &wt, t);
    }
    let (value, by_s) = combine(&values, &ws, s);
    let (by_t, by_st) = combine(&slopes, &ws, s);
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
/// distance from the edge times the mixed derivative; elsewhere it is the normal at 1 − 1e-4 of the
/// parameters.
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
