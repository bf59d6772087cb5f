//! The visible parts of a line, between the roots of heights.
//!
//! Lines w ↦ (w, z) of a chart, in either direction, are grouped in strips between the places z where a
//! height vanishes at the end w = 0 or w = 1 of the line. On the strip z₀ < z < z₁, and the parts a(z) < w <
//! b(z) of a line on which all heights are positive, with Gauss nodes z_j, w_i and weights α_j, β_i on [0, 1]
//! and the area element A,
//!
//! ```text
//! ∫ f dA ≈ Σ_j (z₁ − z₀) α_j Σ_parts Σ_i (b − a) β_i (A f)(a + (b − a) w_i, z) ,   z = z₀ + (z₁ − z₀) z_j .
//! ```
//!
//! Roots are bracketed between 6 places; where two may lie between places of equal sign, the vertex of the
//! parabola through three values is tried. False position (Illinois) ends where two steps are 1e-9 apart, or
//! after 40. The kernel vanishes linearly at a horizon: there roots to 1e-9 make an error of second order,
//! 1e-18.
//!
//! Reference: M. Dowell, P. Jarratt, *BIT* 11 (1971) 168–174.

use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;

use crate::rules::horizon::view::{HEIGHTS, Heights};
use crate::tolerances::GRID_OF_HEIGHTS;

/// Lines in one direction, by how heights vary along them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lines {
    /// Every height has one root on a line at most.
    Plain(Direction),
    /// A height may have any number of roots.
    Winding(Direction),
}

/// Factors of a node's weight in area: the patch's area element, the weights across and along lines, the
/// widths of the strip and of the visible part.
pub(super) type Factors = [f64; 5];

/// Calls `take` with the nodes and weights of a rule on the visible part of a patch, with these points along
/// and across, its lines running in the direction of `lines`; they are grouped in strips where a height
/// vanishes at their ends. Returns the number of evaluations.
pub(super) fn seen(
    patch: &Patch,
    lines: Lines,
    points: [usize; 2],
    heights: &impl Fn(&Node) -> Heights,
    mut take: impl FnMut(&Node, Factors),
) -> u64 {
    let (Lines::Plain(direction) | Lines::Winding(direction)) = lines;
    let node = |w: f64, z: f64| match direction {
        Direction::Along => patch.node(w, z),
        Direction::Across => patch.node(z, w),
    };
    let at = |w: f64, z: f64| heights(&node(w, z));
    let [along, across] = points.map(UnitRule::of);
    let (line, over) = if direction == Direction::Along { (along, across) } else { (across, along) };
    let mut evaluations = 0;
    let mut breaks = vec![0.0, 1.0];
    for side in [0.0, 1.0] {
        evaluations += roots(|z| at(side, z), &mut breaks);
    }
    breaks.sort_by(f64::total_cmp);
    for (low, high) in stretches(&breaks) {
        for (z, wz) in over.iter() {
            let z = low + (high - low) * z;
            let stretches = match lines {
                Lines::Plain(_) => visible(|w| at(w, z), &mut evaluations).into_iter().collect(),
                Lines::Winding(_) => visible_parts(|w| at(w, z), &mut evaluations),
            };
            for [start, end] in stretches {
                evaluations += line.nodes.len() as u64;
                for (w, ww) in line.iter() {
                    let y = node(start + (end - start) * w, z);
                    take(&y, [y.area, wz, ww, high - low, end - start]);
                }
            }
        }
    }
    evaluations
}

/// The parts of a line on which all heights are positive.
fn visible_parts(f: impl Fn(f64) -> Heights, evaluations: &mut u64) -> Vec<[f64; 2]> {
    let mut breaks = vec![0.0, 1.0];
    *evaluations += roots(&f, &mut breaks);
    breaks.sort_by(f64::total_cmp);
    *evaluations += breaks.len() as u64 - 1;
    let is_seen = |(low, high): &(f64, f64)| f(0.5 * (low + high)).iter().all(|h| *h > 0.0);
    stretches(&breaks).filter(is_seen).map(|(low, high)| [low, high]).collect()
}

/// The part of a line on which all heights are positive, each height being monotone.
fn visible(f: impl Fn(f64) -> Heights, evaluations: &mut u64) -> Option<[f64; 2]> {
    let (first, last) = (f(0.0), f(1.0));
    *evaluations += 2;
    let mut stretch = [0.0f64, 1.0];
    for k in 0..HEIGHTS {
        if first[k].max(last[k]) <= 0.0 {
            return None;
        }
        if first[k].min(last[k]) < 0.0 {
            let at = root(|w| f(w)[k], [0.0, 1.0], [first[k], last[k]], evaluations);
            stretch = if first[k] < 0.0 {
                [stretch[0].max(at), stretch[1]]
            } else {
                [stretch[0], stretch[1].min(at)]
            };
        }
    }
    (stretch[0] < stretch[1]).then_some(stretch)
}

/// Appends the roots of all heights in (0, 1); returns the number of evaluations.
fn roots(f: impl Fn(f64) -> Heights, out: &mut Vec<f64>) -> u64 {
    let place = |k: usize| k as f64 / (GRID_OF_HEIGHTS - 1) as f64;
    let values: [Heights; GRID_OF_HEIGHTS] = std::array::from_fn(|k| f(place(k)));
    let mut evaluations = GRID_OF_HEIGHTS as u64;
    for which in 0..HEIGHTS {
        let mut brackets = Vec::new();
        for k in 1..GRID_OF_HEIGHTS {
            let (low, high) = (values[k - 1][which], values[k][which]);
            if low * high < 0.0 {
                brackets.push(([place(k - 1), place(k)], [low, high]));
            }
        }
        let between =
            |k: &usize| values[k - 1][which] * values[k + 1][which] < 0.0 && values[*k][which] == 0.0;
        out.extend((1..GRID_OF_HEIGHTS - 1).filter(between).map(place));
        // Two roots may lie between neighbours of equal sign: the vertex of the parabola through three values
        // is tried.
        for k in 1..GRID_OF_HEIGHTS - 1 {
            let [a, b, c] = [k - 1, k, k + 1].map(|k| values[k][which]);
            let bend = a - 2.0 * b + c;
            if !(a * b > 0.0 && b * c > 0.0 && b * bend > 0.0 && (a - c).abs() < 2.0 * bend.abs()) {
                continue;
            }
            let w = place(k) + 0.5 * (a - c) / bend / (GRID_OF_HEIGHTS - 1) as f64;
            let value = f(w)[which];
            evaluations += 1;
            if value * b < 0.0 {
                brackets.push(([place(k - 1), w], [a, value]));
                brackets.push(([w, place(k + 1)], [value, c]));
            }
        }
        for (ends, values) in brackets {
            out.push(root(|w| f(w)[which], ends, values, &mut evaluations));
        }
    }
    evaluations
}

/// A bracketed root by false position (Illinois variant), to 1e-9 or 40 steps.
fn root(f: impl Fn(f64) -> f64, mut ends: [f64; 2], mut values: [f64; 2], evaluations: &mut u64) -> f64 {
    let mut last = ends[0];
    for _ in 0..40 {
        let w = (ends[0] * values[1] - ends[1] * values[0]) / (values[1] - values[0]);
        if (w - last).abs() <= 1e-9 {
            return w;
        }
        last = w;
        let value = f(w);
        *evaluations += 1;
        if value * values[1] < 0.0 {
            (ends[0], values[0]) = (ends[1], values[1]);
        } else {
            values[0] *= 0.5;
        }
        (ends[1], values[1]) = (w, value);
    }
    last
}

/// The intervals between sorted breaks; those up to 1e-12 are dropped as rounding.
fn stretches(breaks: &[f64]) -> impl Iterator<Item = (f64, f64)> + '_ {
    breaks.windows(2).map(|w| (w[0], w[1])).filter(|(low, high)| high - low > 1e-12)
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;

    use super::*;

    /// The area of h > 0 in the unit square by a rule of four points per direction.
    fn area(lines: Lines, h: impl Fn(DVec3) -> f64) -> f64 {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let square = Patch::Flat { corners, normal: DVec3::Z };
        let mut sum = 0.0;
        seen(&square, lines, [4; 2], &|x| [h(x.position), 1.0, 1.0], |_, factors| {
            sum += factors.iter().product::<f64>();
        });
        sum
    }

    #[test]
    fn a_corner_is_cut_off_where_the_horizon_leaves_through_a_side() {
        let found = area(Lines::Plain(Direction::Along), |x| x.x + x.y - 0.5);
        assert!((found - 0.875).abs() < 1e-9, "{found}");
    }

    #[test]
    fn lines_that_are_seen_amid_or_at_both_ends_are_seen_there() {
        let amid = area(Lines::Winding(Direction::Along), |x| (x.x - 0.35) * (0.6 - x.x));
        let ends = area(Lines::Winding(Direction::Along), |x| (x.x - 0.35) * (x.x - 0.6));
        assert!((amid - 0.25).abs() < 1e-9 && (ends - 0.75).abs() < 1e-9, "{amid} {ends}");
    }
}
