//! The margins of a cell, between the sides and the outermost points of its rule.
//!
//! Where a contact lies near the border of the inner element, W falls from its largest value to 0 within about
//! r² across a line at their distance, r the distance from the contact. Cells at the contact, and cells along
//! that line, have it in a margin before they are small enough: no point of the rule on the cell, or on its
//! halves, sees the fall. Hence W is asked for next to each side, beside three points of the row along it, the
//! outermost ones and one in the middle, and compared there with I W, which interpolates W at the points of the
//! rule:
//!
//! ```text
//! missed = ½ Σ w ‖ L_k δ_l ‖ min(1, 16 |δ₀| / max |W₀|) ,     δ_l = W_l − I W_l ,
//! ```
//!
//! with w the weight of the row in the middle, of the point at its ends. Beside points of the rule I W
//! interpolates in one direction, and missed is that of this direction: halving in the other one would not
//! take it away. What both sides of a corner do not explain, δ at the corner less δ at the places beside it,
//! counts with the weight of the point there, half for each direction.
//!
//! A rule of n points is exact to the degree 2n − 1, interpolation to n − 1: where W is smooth errors of the
//! rule go like the square of δ. Where W falls in the margin δ₀ is about max |W₀|, and missed is half of what
//! the row carries. Places lie inside of the sides: at a contact W has no value.

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::rule::UnitRule;

use crate::rules::horizon::cell::DIRECTIONS;

/// Distance of places from the side, over that of the outermost points: below the least gap at which surfaces
/// count as apart, over which W falls at the common border of two of them.
const INSIDE: f64 = 1e-6;

/// Part of the weight of a row that lies beyond its points.
const BEYOND: f64 = 0.5;

/// Factor of the difference, over the largest value: what is a sixteenth of it off is no rest of a smooth
/// function. With 4, one of 60 cans near borders more erred by over three times what is told at 1e-8.
const FALL: f64 = 16.0;

/// A place next to a side.
pub(super) struct Place {
    /// The direction across the side: 0 for a side at an end of s.
    pub direction: usize,
    /// Its parameters.
    pub at: [f64; 2],
    /// Area of the margin that it stands for (scene length²).
    pub area: f64,
}

/// A place next to a corner.
pub(super) struct Corner {
    /// Its parameters.
    pub at: [f64; 2],
    /// The places next to both sides that are beside it, in the order of all.
    pub beside: [usize; 2],
    /// Area of the margin that it stands for (scene length²).
    pub area: f64,
}

/// The margins of a cell under a tensor rule.
pub(super) struct Margins {
    pub places: Vec<Place>,
    pub corners: Vec<Corner>,
}

/// Places on each side: next to both ends and in the middle.
const ON_SIDE: usize = 3;

/// Of the tensor rule on a cell with these points along and across.
pub(super) fn margins(points: [usize; 2], nodes: &[WeightedNode]) -> Margins {
    let weight = |[i, j]: [usize; 2]| nodes[i * points[1] + j].weight;
    let last = points.map(|n| n - 1);
    let outermost = points.map(|n| UnitRule::of(n).nodes[0]);
    let ends = |direction: usize| [(0, 0.0), (last[direction], 1.0)];
    let at_distance = |end: f64, distance: f64| end + (1.0 - 2.0 * end) * distance;
    let inside = |direction: usize, end: f64| at_distance(end, INSIDE * outermost[direction]);
    let oriented =
        |direction: usize, across, along| if direction == 0 { [across, along] } else { [along, across] };
    let mut places = Vec::new();
    for direction in 0..DIRECTIONS.len() {
        let other = 1 - direction;
        for (row, end) in ends(direction) {
            let point = |k: usize| if direction == 0 { [row, k] } else { [k, row] };
            let whole: f64 = (0..points[other]).map(|k| weight(point(k))).sum();
            let at_ends = ends(other).map(|(k, _)| (k, weight(point(k))));
            places.extend(at_ends.into_iter().chain([(points[other] / 2, whole)]).map(|(k, area)| Place {
                direction,
                at: oriented(direction, inside(direction, end), UnitRule::of(points[other]).nodes[k]),
                area: BEYOND * area,
            }));
        }
    }
    let corners = ends(0).into_iter().enumerate().flat_map(|(i, (row, s))| {
        ends(1).into_iter().enumerate().map(move |(j, (column, t))| Corner {
            at: [inside(0, s), inside(1, t)],
            beside: [ON_SIDE * i + j, ON_SIDE * (2 + j) + i],
            area: BEYOND * weight([row, column]),
        })
    });
    Margins { corners: corners.collect(), places }
}

/// Share of a difference of `off` from the interpolated value that counts, of values up to `largest`.
pub(super) fn share(off: f64, largest: f64) -> f64 {
    if off > 0.0 { (FALL * off / largest).min(1.0) } else { 0.0 }
}

/// The polynomial through values at the points of a tensor rule, `columns` for each of them, at a place.
pub(super) fn interpolated(points: [usize; 2], values: &[f64], columns: usize, at: [f64; 2]) -> Vec<f64> {
    let [along, across] = [0, 1].map(|k| factors(UnitRule::of(points[k]), at[k]));
    let mut sums = vec![0.0; columns];
    let pairs = along.iter().flat_map(|a| across.iter().map(move |b| a * b));
    for (factor, seen) in pairs.zip(values.chunks_exact(columns)) {
        sums.iter_mut().zip(seen).for_each(|(sum, value)| *sum += factor * value);
    }
    sums
}

/// Lagrange's polynomials of a rule's points at a place.
fn factors(rule: &UnitRule, at: f64) -> Vec<f64> {
    let others = |j: usize| rule.nodes.iter().enumerate().filter(move |(k, _)| *k != j).map(|(_, x)| *x);
    let factor = |(j, own): (usize, &f64)| others(j).map(|x| (at - x) / (own - x)).product();
    rule.nodes.iter().enumerate().map(factor).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_interpolated() {
        let points = [4, 3];
        let of = |s: f64, t: f64| [1.0 + s * s * s * t, t * t - s];
        let [along, across] = points.map(UnitRule::of);
        let values: Vec<f64> =
            along.iter().flat_map(|(s, _)| across.iter().flat_map(move |(t, _)| of(s, t))).collect();
        for at in [[0.0, 0.5], [1.0, 1.0], [0.5, 0.0]] {
            let found = interpolated(points, &values, 2, at);
            assert!(found.iter().zip(of(at[0], at[1])).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        }
    }
}
