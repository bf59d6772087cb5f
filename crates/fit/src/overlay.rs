//! Areas in a plane that rings enclose, and the parts of them outside others.
//!
//! Points nearer to each other than a tolerance are made one, and sides are led through points that lie on
//! them; then the crossings are found in integers by the crate `i_overlay`. Points that were given come back
//! as they were given, to the bit, also those that lie beside the plane.

mod nodes;

use std::collections::{HashMap, HashSet};

use glam::{DVec2, DVec3};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{ContourDirection, IntOverlayOptions, Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use radiosity_geom::{COINCIDENT, distance_to_segment, sides};

use crate::outline::{perimeter, tolerance};
use crate::plane::Plane;
use nodes::{Near, Nodes, bits, through_nodes};
use radiosity_geom::area_vector;

/// Steps of the integers over the extent: some four thousand to the tolerance of 1e-9, so that crossings stay
/// where they are, and far from their limit, 2⁶², so that no product overflows.
const STEPS: f64 = (1u64 << 42) as f64;

/// Distance within which points are made one, over the largest length that is refused as 0, so that none is
/// refused afterwards: crossings are rounded to steps, and a side that is led through a point moves. Smaller
/// leaves no room for that; larger closes slits that were meant.
const SPARE: f64 = 4.0;

/// A polygon with holes: the outline runs counter-clockwise about the plane's normal.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Corners of the outline.
    pub outline: Vec<DVec3>,
    /// Corners of each hole.
    pub holes: Vec<Vec<DVec3>>,
}

impl Part {
    pub(super) fn rings(&self) -> impl Iterator<Item = &[DVec3]> {
        std::iter::once(self.outline.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }
}

/// Areas that the rings enclose by the even–odd rule: a line from a point in them to far away crosses an odd
/// number of sides. `asked` is a length within which points are one, where it is larger than their rounding.
pub fn enclosed(plane: &Plane, rings: &[&[DVec3]], asked: Option<f64>) -> Vec<Part> {
    let given: Vec<DVec3> = rings.iter().flat_map(|ring| ring.iter().copied()).collect();
    let parts = Drawing::new(plane, &given, rings, &[], asked).parts(OverlayRule::Subject, FillRule::EvenOdd);
    settled(plane, &given, parts, asked)
}

/// Areas of `parts` outside `others`; outlines of both run counter-clockwise, holes clockwise. `asked` is a
/// length within which points are one, where it is larger than their rounding.
pub fn without(plane: &Plane, parts: &[Part], others: &[Part], asked: Option<f64>) -> Vec<Part> {
    let [own, cut] = [parts, others].map(|parts| parts.iter().flat_map(Part::rings).collect::<Vec<_>>());
    let given: Vec<DVec3> = own.iter().flat_map(|ring| ring.iter().copied()).collect();
    let parts =
        Drawing::new(plane, &given, &own, &cut, asked).parts(OverlayRule::Difference, FillRule::NonZero);
    settled(plane, &given, parts, asked)
}

/// The parts with new points made one with each other, and sides led through them: where three sides cross in
/// one point, rounding leaves three.
fn settled(plane: &Plane, given: &[DVec3], parts: Vec<Part>, asked: Option<f64>) -> Vec<Part> {
    let known: HashSet<[u64; 3]> = given.iter().map(|x| bits(*x)).collect();
    let rings: Vec<&[DVec3]> = parts.iter().flat_map(Part::rings).collect();
    if rings.iter().copied().flatten().all(|x| known.contains(&bits(*x))) {
        return parts;
    }
    Drawing::new(plane, given, &rings, &[], asked).parts(OverlayRule::Subject, FillRule::EvenOdd)
}

/// A corner of a ring.
#[derive(Clone, Copy)]
struct RingCorner {
    point: DVec3,
    /// Whether it was given, and no crossing of sides made it.
    is_given: bool,
}

/// Rings in a plane with common nodes.
struct Drawing<'a> {
    plane: &'a Plane,
    nodes: Nodes,
    /// Rings of nodes, those before `subjects` being the rings that are cut.
    rings: Vec<Vec<usize>>,
    subjects: usize,
    /// Sides of the rings that are cut, as pairs of nodes.
    sides: Vec<[usize; 2]>,
    near: Near,
    tolerance: f64,
    low: DVec2,
    step: f64,
}

impl<'a> Drawing<'a> {
    /// The rings that are cut and those that cut them; points that were given are kept rather than others.
    fn new(
        plane: &'a Plane,
        given: &[DVec3],
        subjects: &[&[DVec3]],
        clips: &[&[DVec3]],
        asked: Option<f64>,
    ) -> Self {
        let tolerance = SPARE * tolerance(given, asked);
        let mut nodes = Nodes::new(tolerance);
        for x in given {
            nodes.take(*x, plane.flat(*x));
        }
        nodes.given = nodes.points.len();
        let ring = |ring: &&[DVec3]| ring.iter().map(|x| nodes.take(*x, plane.flat(*x))).collect::<Vec<_>>();
        let rings = subjects.iter().chain(clips).map(ring).collect();
        let rings = through_nodes(rings, &nodes, tolerance);
        let [low, high] = nodes.bounds();
        let step = (high - low).max_element().max(f64::MIN_POSITIVE) / STEPS;
        let subjects = subjects.len();
        let sides: Vec<[usize; 2]> = rings[..subjects].iter().flat_map(|ring| sides(ring)).collect();
        let near = nodes.near(&sides);
        Drawing { plane, nodes, rings, subjects, sides, near, tolerance, low, step }
    }

    fn whole(&self, at: DVec2) -> IntPoint<i64> {
        let steps = (at - self.low) / self.step;
        IntPoint::new(steps.x.round() as i64, steps.y.round() as i64)
    }

    /// The parts that a rule leaves, each ring beginning with the first of the points that were given.
    fn parts(&self, rule: OverlayRule, fill: FillRule) -> Vec<Part> {
        let options = IntOverlayOptions {
            preserve_input_collinear: true,
            output_direction: ContourDirection::CounterClockwise,
            preserve_output_collinear: true,
            min_output_area: 0,
            ogc: true,
        };
        let count = self.rings.iter().map(Vec::len).sum();
        let mut overlay = Overlay::<i64>::new_custom(count, options, Default::default());
        for (k, ring) in self.rings.iter().enumerate() {
            let ring: Vec<IntPoint<i64>> =
                ring.iter().map(|node| self.whole(self.nodes.flat[*node])).collect();
            let kind = if k < self.subjects { ShapeType::Subject } else { ShapeType::Clip };
            overlay.add_contour(&ring, kind);
        }
        let known: HashMap<[i64; 2], usize> =
            (0..self.nodes.flat.len()).map(|node| (place(self.whole(self.nodes.flat[node])), node)).collect();
        let shapes = overlay.overlay(rule, fill);
        let part = |shape: Vec<Vec<IntPoint<i64>>>| {
            let mut rings = shape.into_iter().map(|ring| self.ring(ring, &known));
            let outline = rings.next().flatten()?;
            Some(Part { outline, holes: rings.flatten().collect() })
        };
        let mut parts: Vec<(usize, Part)> =
            shapes.into_iter().filter_map(part).map(|part| (self.first(&part.outline), part)).collect();
        parts.sort_by_key(|(first, _)| *first);
        parts.into_iter().map(|(_, part)| part).collect()
    }

    /// A ring in space; none if nothing but rounding lies inside.
    fn ring(&self, ring: Vec<IntPoint<i64>>, known: &HashMap<[i64; 2], usize>) -> Option<Vec<DVec3>> {
        let corner = |at: IntPoint<i64>| match known.get(&place(at)) {
            Some(node) => RingCorner { point: self.nodes.points[*node], is_given: *node < self.nodes.given },
            None => RingCorner { point: self.crossing(at), is_given: false },
        };
        let mut corners: Vec<RingCorner> = ring.into_iter().map(corner).collect();
        self.straighten(&mut corners);
        let mut points: Vec<DVec3> = corners.into_iter().map(|corner| corner.point).collect();
        if points.len() < 3 || area_vector(&points).length() <= self.tolerance * perimeter(&points) {
            return None;
        }
        let start = (0..points.len()).min_by_key(|k| self.order(points[*k])).unwrap_or(0);
        points.rotate_left(start);
        Some(points)
    }

    /// Takes out corners that were not given, where they have no effect.
    fn straighten(&self, corners: &mut Vec<RingCorner>) {
        let mut at = 0;
        while at < corners.len() && corners.len() > 3 {
            let count = corners.len();
            let RingCorner { point, is_given } = corners[at];
            let ends = [(at + count - 1) % count, (at + 1) % count].map(|next| corners[next].point);
            match !is_given && distance_to_segment(point, ends) <= self.tolerance {
                true => drop(corners.remove(at)),
                false => at += 1,
            }
        }
    }

    /// The point in space of a crossing: on the side nearest to it, so that coordinates that the side's ends
    /// share are kept.
    fn crossing(&self, at: IntPoint<i64>) -> DVec3 {
        let at = self.low + self.step * DVec2::new(at.x as f64, at.y as f64);
        let point = at.extend(0.0);
        let mut found: Vec<(f64, usize)> = Vec::new();
        self.near.at(point, |side| {
            let ends = self.sides[side].map(|node| self.nodes.flat[node].extend(0.0));
            found.push((distance_to_segment(point, ends), side));
        });
        let nearest = found.into_iter().min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let Some((_, side)) = nearest.filter(|(away, _)| *away <= self.tolerance) else {
            return self.plane.raised(at);
        };
        let [from, to] = self.sides[side];
        let [p, q] = [self.nodes.flat[from], self.nodes.flat[to]];
        let along = ((at - p).dot(q - p) / (q - p).length_squared()).clamp(0.0, 1.0);
        let [x, y] = [self.nodes.points[from], self.nodes.points[to]];
        x + along * (y - x)
    }

    /// Index of a point among those that were given; the largest number for others.
    fn order(&self, x: DVec3) -> usize {
        self.nodes.index.get(&bits(x)).copied().unwrap_or(usize::MAX)
    }

    fn first(&self, ring: &[DVec3]) -> usize {
        ring.iter().map(|x| self.order(*x)).min().unwrap_or(usize::MAX)
    }
}

fn place(at: IntPoint<i64>) -> [i64; 2] {
    [at.x, at.y]
}

/// Whether a ring runs somewhere and back along the same way, as the seam does that leads an outline to a
/// hole.
pub fn has_seam(plane: &Plane, ring: &[DVec3], asked: Option<f64>) -> bool {
    let drawing = Drawing::new(plane, ring, &[ring], &[], asked);
    let sides: HashSet<[usize; 2]> = drawing.rings.iter().flat_map(|ring| sides(ring)).collect();
    sides.iter().any(|[from, to]| sides.contains(&[*to, *from]))
}

/// Whether sides of a ring cross in points that are no points of it.
pub fn crosses_itself(plane: &Plane, ring: &[DVec3], parts: &[Part]) -> bool {
    let given: HashSet<[u64; 3]> = ring.iter().map(|x| bits(*x)).collect();
    let is_new = parts.iter().flat_map(Part::rings).flatten().any(|x| !given.contains(&bits(*x)));
    let net = area_vector(ring).dot(plane.normal());
    let sum =
        parts.iter().flat_map(Part::rings).map(|ring| area_vector(ring).dot(plane.normal())).sum::<f64>();
    is_new || sum > (1.0 + COINCIDENT) * net
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
        points.iter().map(|[x, y]| DVec3::new(*x, *y, 0.3)).collect()
    }

    fn square(low: f64, high: f64) -> Vec<DVec3> {
        flat(&[[low, low], [high, low], [high, high], [low, high]])
    }

    fn part(outline: Vec<DVec3>) -> Part {
        Part { outline, holes: Vec::new() }
    }

    fn area(parts: &[Part]) -> f64 {
        parts.iter().flat_map(Part::rings).map(|ring| area_vector(ring).z).sum()
    }

    #[test]
    fn a_square_in_a_square_leaves_a_hole_with_its_own_points() {
        let plane = Plane::of(&square(0.0, 1.0)).unwrap();
        let left = without(&plane, &[part(square(0.0, 1.0))], &[part(square(0.1, 0.7))], None);
        assert_eq!(left.len(), 1);
        assert_eq!(left[0].outline, square(0.0, 1.0));
        assert!(left[0].holes[0].len() == 4 && square(0.1, 0.7).iter().all(|x| left[0].holes[0].contains(x)));
    }

    #[test]
    fn a_strip_across_leaves_two_parts() {
        let strip = flat(&[[0.3, -1.0], [0.6, -1.0], [0.6, 2.0], [0.3, 2.0]]);
        let plane = Plane::of(&square(0.0, 1.0)).unwrap();
        let left = without(&plane, &[part(square(0.0, 1.0))], &[part(strip)], None);
        assert_eq!(left.len(), 2);
        assert!((area(&left) - 0.7).abs() < 1e-12);
        assert!(left.iter().all(|part| part.outline.iter().all(|x| x.z == 0.3)));
    }

    #[test]
    fn what_differs_by_rounding_is_the_same() {
        let plane = Plane::of(&square(0.0, 1.0)).unwrap();
        let shaken: Vec<DVec3> = square(0.0, 1.0)
            .iter()
            .enumerate()
            .map(|(k, x)| *x + DVec3::splat(1e-10 * (k as f64 - 1.7)))
            .collect();
        assert!(without(&plane, &[part(square(0.0, 1.0))], &[part(shaken)], None).is_empty());
    }
}
