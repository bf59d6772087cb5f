//! Whether the sides of loops in a plane cross or touch other than at common corners.

use glam::DVec2;
use radiosity_geom::sides;

/// Pairs of sides that are compared at least before loops count as crossing: a million take some
/// milliseconds.
const LEAST: usize = 1_000_000;
/// Pairs that are compared for each side before loops count as crossing: boundaries of real meshes take a
/// few, and the time of others would grow with the square of their sides.
const FOR_EACH: usize = 100;

/// A side, and the part of it within a strip.
#[derive(Clone, Copy)]
struct Part {
    side: usize,
    low: f64,
    high: f64,
}

/// Whether two sides of `loops` without a common corner come as near to each other as `near`. True too where
/// the answer would take too long.
pub(super) fn cross(loops: &[Vec<DVec2>], near: f64) -> bool {
    let sides: Vec<[DVec2; 2]> = loops.iter().flat_map(|ring| sides(ring)).collect();
    let mut budget = LEAST.max(FOR_EACH * sides.len());
    for mut strip in strips(&sides, near) {
        strip.sort_by(|a, b| a.low.total_cmp(&b.low));
        for (index, part) in strip.iter().enumerate() {
            for other in strip[index + 1..].iter().take_while(|other| other.low <= part.high) {
                budget -= 1;
                if budget == 0 || meet(sides[part.side], sides[other.side], near) {
                    return true;
                }
            }
        }
    }
    false
}

/// The sides in strips of equal height, as many as the root of their number.
fn strips(sides: &[[DVec2; 2]], near: f64) -> Vec<Vec<Part>> {
    let heights = || sides.iter().flat_map(|side| side.map(|x| x.y));
    let low = heights().fold(f64::INFINITY, f64::min);
    let high = heights().fold(f64::NEG_INFINITY, f64::max);
    let count = (sides.len() as f64).sqrt() as usize + 1;
    let height = (high - low) / count as f64;
    let strip = |y: f64| (((y - low) / height) as usize).min(count - 1);
    let mut strips = vec![Vec::new(); count];
    for (index, [a, b]) in sides.iter().enumerate() {
        let (first, last) = (strip(a.y.min(b.y) - near), strip(a.y.max(b.y) + near));
        for (k, parts) in strips.iter_mut().enumerate().take(last + 1).skip(first) {
            let at = |y: f64| {
                let part = ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                if part.is_nan() { a.x } else { a.x + part * (b.x - a.x) }
            };
            let [y, z] = [(k, -near), (k + 1, near)].map(|(k, more)| low + k as f64 * height + more);
            let (x, w) = if first == last { (a.x, b.x) } else { (at(y), at(z)) };
            parts.push(Part { side: index, low: x.min(w) - near, high: x.max(w) + near });
        }
    }
    strips
}

/// Whether two sides without a common corner cross, or an end of one is as near to the other as `near`.
fn meet(one: [DVec2; 2], other: [DVec2; 2], near: f64) -> bool {
    if one.iter().any(|end| other.contains(end)) {
        return false;
    }
    let touches = |side: [DVec2; 2], ends: [DVec2; 2]| ends.iter().any(|end| distance(side, *end) <= near);
    let parts = |[a, b]: [DVec2; 2], ends: [DVec2; 2]| {
        let [x, y] = ends.map(|end| (b - a).perp_dot(end - a));
        (x < 0.0) != (y < 0.0)
    };
    touches(one, other) || touches(other, one) || (parts(one, other) && parts(other, one))
}

/// Distance of a point from a side.
fn distance([a, b]: [DVec2; 2], point: DVec2) -> f64 {
    let along = (point - a).dot(b - a) / a.distance_squared(b);
    a.lerp(b, along.clamp(0.0, 1.0)).distance(point)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().map(|x| DVec2::from_array(*x)).collect()
    }

    #[test]
    fn a_bow_crosses_itself_and_a_square_does_not() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(!cross(&[ring(&square)], 1e-6));
        assert!(cross(&[ring(&bow)], 1e-6));
    }

    #[test]
    fn a_hole_that_leaves_its_outline_crosses() {
        let square = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let hole = |x: f64| ring(&[[x, 1.0], [x, 2.0], [x + 1.0, 2.0], [x + 1.0, 1.0]]);
        assert!(!cross(&[square.clone(), hole(1.0)], 1e-6));
        assert!(cross(&[square.clone(), hole(3.5)], 1e-6));
        assert!(cross(&[square, hole(3.0)], 1e-6), "its side lies on the outline");
    }
}
