//! Whether the sides of loops in a plane cross.

use glam::DVec2;

/// Pairs of sides that are compared: at least, and for each side, before loops count as crossing. Chosen; not tuned:
/// boundaries of real meshes take a few for each side.
const LEAST: usize = 1_000_000;
const FOR_EACH: usize = 1000;

/// A side, and the part of it within a strip.
#[derive(Clone, Copy)]
struct Part {
    side: usize,
    low: f64,
    high: f64,
}

/// Whether two sides of `loops` cross by more than `near`. True too where the answer would take too long.
pub(super) fn cross(loops: &[Vec<DVec2>], near: f64) -> bool {
    let sides: Vec<[DVec2; 2]> = loops
        .iter()
        .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]))
        .collect();
    let mut budget = LEAST.max(FOR_EACH * sides.len());
    for mut strip in strips(&sides) {
        strip.sort_by(|a, b| a.low.total_cmp(&b.low));
        for (index, part) in strip.iter().enumerate() {
            for other in strip[index + 1..].iter().take_while(|other| other.low <= part.high) {
                budget -= 1;
                if budget == 0 || do_cross(sides[part.side], sides[other.side], near) {
                    return true;
                }
            }
        }
    }
    false
}

/// The sides in strips of equal height, as many as the root of their number.
fn strips(sides: &[[DVec2; 2]]) -> Vec<Vec<Part>> {
    let heights = || sides.iter().flat_map(|side| side.map(|x| x.y));
    let low = heights().fold(f64::INFINITY, f64::min);
    let high = heights().fold(f64::NEG_INFINITY, f64::max);
    let count = (sides.len() as f64).sqrt() as usize + 1;
    let height = (high - low) / count as f64;
    let strip = |y: f64| (((y - low) / height) as usize).min(count - 1);
    let mut strips = vec![Vec::new(); count];
    for (index, [a, b]) in sides.iter().enumerate() {
        let (first, last) = (strip(a.y.min(b.y)), strip(a.y.max(b.y)));
        for (k, parts) in strips.iter_mut().enumerate().take(last + 1).skip(first) {
            let at = |y: f64| {
                let part = ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
                if part.is_nan() { a.x } else { a.x + part * (b.x - a.x) }
            };
            let [y, z] = [k, k + 1].map(|k| low + k as f64 * height);
            let (x, w) = if first == last { (a.x, b.x) } else { (at(y), at(z)) };
            parts.push(Part { side: index, low: x.min(w), high: x.max(w) });
        }
    }
    strips
}

/// Whether the ends of each lie on both sides of the other, farther than `near`.
fn do_cross(one: [DVec2; 2], other: [DVec2; 2], near: f64) -> bool {
    let apart = |[a, b]: [DVec2; 2], ends: [DVec2; 2]| {
        let along = (b - a).normalize_or_zero();
        let [x, y] = ends.map(|end| along.perp_dot(end - a));
        x.min(y) < -near && x.max(y) > near
    };
    apart(one, other) && apart(other, one)
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
        assert!(cross(&[square, hole(3.5)], 1e-6));
    }
}
