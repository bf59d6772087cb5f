//! Whether joined surfaces hide two ends from each other. A few rays choose the screens that are tried, and
//! leave out ends that see each other; they never decide that something is hidden.

use std::iter;

use radiosity_geom::{COINCIDENT, DVec3, Ray};

use super::{Visibility, breadth};
use crate::screens::End;
use crate::tolerances::OWN_END;

/// Surfaces along a ray that screens are grown from, at either end: those next to an end hide most. With a
/// larger value a few more pairs are told hidden at once, and all that are not take longer.
const TRIED: usize = 2;

/// Rays besides the one between the middles, from near the corners of either end.
const MORE_RAYS: usize = 3;

/// Where these start between the middle and a corner: near the corner, but not on the border.
const OUTWARDS: f64 = 0.9;

/// Part by which the weights of corners differ, and the golden section, whose multiples spread them.
const UNEVEN: f64 = 0.1;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Visibility {
    /// Whether a screen certainly meets all segments between two ends. Where it is false something may hide
    /// them all the same.
    pub fn are_screened(&self, ends: [End; 2]) -> bool {
        let Some(segment) = self.first_hidden(ends) else { return false };
        let [a, b] = ends;
        let thin = breadth(a.hull()).min(breadth(b.hull()));
        let [x, y] = segment;
        let from_a = self.met_between(a.surface(), x, y).take(TRIED);
        let from_b = self.met_between(b.surface(), y, x).take(TRIED);
        let is_own = |surface: usize| ends.iter().any(|end| end.surface() == Some(surface));
        from_a.chain(from_b).any(|first| !is_own(first) && self.screens.close(ends, first, segment, thin))
    }

    /// The first of a few segments between two ends, in front of both; None where one of them is free.
    fn first_hidden(&self, ends: [End; 2]) -> Option<[DVec3; 2]> {
        if !self.casts() || self.standing.is_empty() {
            return None;
        }
        let [a, b] = ends;
        let mut first = None;
        for k in 0..=MORE_RAYS {
            let [x, y] = [place(a.hull(), k), place(b.hull(), 2 * k)];
            let margin = COINCIDENT * x.distance(y);
            if !(a.faces(y, margin) && b.faces(x, margin)) {
                continue;
            }
            if self.is_free(a.surface(), x, y) {
                return None;
            }
            first = first.or(Some([x, y]));
        }
        first
    }

    /// The surfaces that the segment from `x`, on `surface` if on any, to `y` meets, one after another.
    fn met_between(&self, surface: Option<usize>, x: DVec3, y: DVec3) -> impl Iterator<Item = usize> {
        let mut last = None;
        iter::from_fn(move || {
            let range = [last.map_or(0.0, |t| t + COINCIDENT), 1.0 - OWN_END];
            let ray = Ray { origin: x, direction: y - x, range };
            let met = match (last, surface) {
                (None, Some(surface)) => self.nearest_from(surface, x, y - x),
                _ => self.nearest(&ray),
            };
            let met = met.filter(|met| met.hit.t <= ray.range[1])?;
            last = Some(met.hit.t);
            Some(met.surface)
        })
    }
}

/// A place near the middle of a hull, or near one of its corners. Corners weigh differently, as symmetric
/// things would be met right on the sides that join their faces, where it is not certain what is met.
fn place(hull: &[DVec3], k: usize) -> DVec3 {
    let weight = |corner: usize| 1.0 + UNEVEN * (GOLDEN * corner as f64).fract();
    let weights: f64 = (0..hull.len()).map(weight).sum();
    let middle = hull.iter().enumerate().map(|(corner, x)| x * weight(corner)).sum::<DVec3>() / weights;
    if k == 0 { middle } else { middle.lerp(hull[k % hull.len()], OUTWARDS) }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_geom::{Aabb, Plane};
    use radiosity_scene::Source;

    use super::*;
    use crate::Shadows;

    /// A fin between two others, of triangles.
    #[derive(Clone, Copy, Debug)]
    struct Fin {
        height: f64,
        /// By which its top stands beside its foot.
        lean: f64,
        /// Strips along its length.
        strips: usize,
    }

    fn corners(points: &[[f64; 3]]) -> String {
        format!("vertices = {points:?}")
    }

    /// Fins on a plate, closed at the foot, and boxes anywhere between them.
    fn scene(fins: &[Fin], boxes: &[[f64; 6]]) -> Visibility {
        let mut shapes = vec![format!(
            "quad = {{ {} }}",
            corners(&[[-1.0, -1.0, 0.0], [9.0, -1.0, 0.0], [9.0, 2.0, 0.0], [-1.0, 2.0, 0.0]])
        )];
        for (place, fin) in fins.iter().enumerate() {
            let foot = place as f64;
            let [left, right] = [foot + fin.lean, foot + 0.2 + fin.lean];
            let profile = [[foot, 0.0], [left, fin.height], [right, fin.height], [foot + 0.2, 0.0]];
            for (side, strip) in (0..3).flat_map(|side| (0..fin.strips).map(move |strip| (side, strip))) {
                let [from, to] = [strip, strip + 1].map(|strip| strip as f64 / fin.strips as f64);
                let at = |[x, z]: [f64; 2], y: f64| [x, y, z];
                let [low, high] = [profile[side], profile[side + 1]];
                let [a, b, c, d] = [at(low, from), at(high, from), at(high, to), at(low, to)];
                shapes.extend(
                    [[a, b, c], [a, c, d]].map(|outline| format!("triangle = {{ {} }}", corners(&outline))),
                );
            }
        }
        for [x, y, z, u, v, w] in boxes {
            shapes.push(format!("box = {{ origin = [{x}, {y}, {z}], size = [{u}, {v}, {w}] }}"));
        }
        let text: String = shapes.iter().map(|shape| format!("[[surfaces]]\n{shape}\n")).collect();
        let scene = radiosity_language::read(&Source::new("fins", &text)).expect("a scene");
        Visibility::new(&scene, Shadows::Auto, 1e-3)
    }

    fn end(visibility: &Visibility, surface: usize) -> End<'_> {
        End::on(surface, plane(visibility, surface), &visibility.obstacles[surface].hull)
    }

    fn plane(visibility: &Visibility, surface: usize) -> Plane {
        let region = visibility.obstacles[surface].shape.region().expect("all are planar");
        Plane { point: region.outer()[0], normal: region.normal() }
    }

    /// A point of a surface, none on its border.
    fn point(visibility: &Visibility, surface: usize, weights: &[f64; 4]) -> DVec3 {
        let hull = &visibility.obstacles[surface].hull;
        let sum: f64 = weights[..hull.len()].iter().sum();
        hull.iter().zip(weights).map(|(x, weight)| x * (weight / sum)).sum()
    }

    /// Whether anything but `surfaces` stands between two points.
    fn is_met(visibility: &Visibility, surfaces: &[usize], x: DVec3, y: DVec3) -> bool {
        let mut others = (0..visibility.obstacles.len()).filter(|index| !surfaces.contains(index));
        others.any(|index| visibility.blocks(index, x, y, 1e-12))
    }

    fn fin() -> impl Strategy<Value = Fin> {
        let height = prop_oneof![Just(1.0), 0.1..1.5f64];
        (height, prop_oneof![Just(0.0), -0.5..0.5f64], 1..4usize).prop_map(|(height, lean, strips)| Fin {
            height,
            lean,
            strips,
        })
    }

    fn weights() -> impl Strategy<Value = [f64; 4]> {
        prop::array::uniform4(0.01..1.0f64)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        /// Of surfaces and groups of them that are told hidden no point sees another, by rays at all others.
        #[test]
        fn what_is_told_hidden_is_hidden(
            fins in prop::collection::vec(fin(), 2..6),
            boxes in prop::collection::vec(
                (prop::array::uniform3(-0.5..3.0f64), prop::array::uniform3(0.1..1.0f64))
                    .prop_map(|([x, y, z], [u, v, w])| [x, 0.3 * y, z, u, v, w]),
                0..4,
            ),
            places in prop::collection::vec((weights(), weights()), 30),
            group in 1..5usize,
        ) {
            let visibility = scene(&fins, &boxes);
            let n = visibility.obstacles.len();
            for a in 0..n {
                let own = end(&visibility, a);
                for b in (0..n).filter(|b| *b != a) {
                    let members: Vec<usize> = (b..n.min(b + group)).filter(|member| *member != a).collect();
                    let points = members.iter().flat_map(|member| visibility.obstacles[*member].hull.iter().copied());
                    let corners = Aabb::around(points).corners();
                    let is_group = members.len() > 1;
                    let other = if is_group { End::within(&corners) } else { end(&visibility, b) };
                    if !visibility.are_screened([own, other]) {
                        continue;
                    }
                    for ((p, q), member) in places.iter().zip(members.iter().cycle()) {
                        let (x, y) = (point(&visibility, a, p), point(&visibility, *member, q));
                        let faces = plane(&visibility, a).height(y) > 0.0
                            && (is_group || plane(&visibility, b).height(x) > 0.0);
                        let own: &[usize] = if is_group { &[a] } else { &[a, b] };
                        let own: Vec<usize> = own.iter().chain(&members).copied().collect();
                        prop_assert!(
                            !faces || is_met(&visibility, &own, x, y),
                            "{a} at {x} sees {member} at {y}, one of {members:?}"
                        );
                    }
                }
            }
        }
    }

    /// Of six fins those that are not neighbours are hidden from each other, one by one and all at once.
    #[test]
    fn a_fin_hides_all_beyond_it() {
        let fin = Fin { height: 1.0, lean: 0.0, strips: 3 };
        let visibility = scene(&[fin; 6], &[]);
        let of_fin = |fin: usize| 1 + 18 * fin..19 + 18 * fin;
        let (right, left) =
            (of_fin(1).end - 6..of_fin(1).end, |fin: usize| of_fin(fin).start..of_fin(fin).start + 6);
        for a in right {
            let own = end(&visibility, a);
            for b in left(3).chain(left(5)) {
                assert!(visibility.are_screened([own, end(&visibility, b)]), "{a} and {b}");
            }
            let beyond =
                (left(3).start..of_fin(5).end).flat_map(|b| visibility.obstacles[b].hull.iter().copied());
            assert!(visibility.are_screened([own, End::within(&Aabb::around(beyond).corners())]), "{a}");
            assert!(left(2).all(|b| !visibility.are_screened([own, end(&visibility, b)])), "{a}");
        }
    }

    /// Fins of which the middle one is lower by a millionth hide nothing wholly.
    #[test]
    fn over_a_lower_fin_something_is_seen() {
        let fin = |height: f64| Fin { height, lean: 0.0, strips: 1 };
        let visibility = |middle: f64| scene(&[fin(1.0), fin(middle), fin(1.0)], &[]);
        // The upper halves of the sides that look at each other.
        let [a, b] = [6, 13];
        let [level, lower] = [visibility(1.0), visibility(1.0 - 1e-6)];
        assert!(level.are_screened([end(&level, a), end(&level, b)]));
        assert!(!lower.are_screened([end(&lower, a), end(&lower, b)]));
    }
}
