//! A flat element of a constant, with the points of its rule and of its segments.

use std::f64::consts::PI;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{shift, shifted};
use radiosity_geom::{DVec3, Plane, touching};
use radiosity_kernel::rules::contour;
use radiosity_visibility::FlatEnd;
use radiosity_visibility::bounding_ball::Ball;

/// Distance of two facets over the sum of their radii from which points tell their exchange.
const FAR: f64 = 4.0;

/// Places along either side of a quadrilateral: those of Gauss.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// Places of three points in a triangle, of degree 2.
const THIRDS: [[f64; 2]; 3] = [[1.0 / 6.0, 1.0 / 6.0], [2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0]];

/// A flat element of a constant.
#[derive(Debug)]
pub(super) struct Facet {
    plane: Plane,
    /// Its corners, and the ball around them.
    hull: Vec<DVec3>,
    ball: Ball,
    surface: usize,
    /// Number of its element.
    number: u64,
    /// Its area (length²).
    pub area: f64,
    center: DVec3,
    /// Distance of the farthest corner from the centre.
    radius: f64,
    /// Height below which a point lies in its plane.
    flush: f64,
    nodes: Vec<FacetNode>,
    map: AreaPreservingMap,
    /// Shift of the points of its segments, where they start here, and where they end.
    shift: [f64; 4],
    /// The first of these points, where segments start here, and where they end.
    first: [Vec<DVec3>; 2],
}

/// A point of a rule, with its weight (length²).
#[derive(Clone, Copy, Debug)]
struct FacetNode {
    position: DVec3,
    weight: f64,
}

/// End of segments on a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Start = 0,
    Stop = 1,
}

/// Two facets that see each other if nothing stands between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// Whether points tell their exchange.
    pub is_far: bool,
}

impl Facet {
    /// The facet of an element with this number, with so many ends of segments at hand; None for what is bent, or lies
    /// on another one.
    pub(super) fn of(element: &Element, number: u64, count: u64) -> Option<Self> {
        let plane = element.plane.filter(|_| element.contact.is_none())?;
        let hull = element.hull.clone();
        let center = hull.iter().sum::<DVec3>() / hull.len() as f64;
        let radius = hull.iter().map(|corner| corner.distance(center)).fold(0.0, f64::max);
        let (map, shift) = (AreaPreservingMap::over(element), shift(number));
        let nodes = element.patches.iter().flat_map(nodes).collect();
        let place = |end: End| (0..count).map(|index| point(&map, &shift, end, index)).collect();
        let first = [place(End::Start), place(End::Stop)];
        Some(Self {
            plane,
            ball: Ball::around(&hull),
            hull,
            surface: element.surface,
            number,
            area: element.area,
            center,
            radius,
            flush: touching(element.extent, 0.0),
            nodes,
            map,
            shift,
            first,
        })
    }

    /// Whether either lies in front of the other, at least in part.
    pub(super) fn sight_of(&self, other: &Self) -> Option<Sight> {
        let are_whole = [self.has_whole_before(other)?, other.has_whole_before(self)?];
        let far = FAR * (self.radius + other.radius);
        let is_apart = self.center.distance_squared(other.center) > far * far;
        Some(Sight { is_far: is_apart && are_whole == [true; 2] })
    }

    /// Whether all of another facet lies before this one; None where nothing of it does.
    fn has_whole_before(&self, other: &Self) -> Option<bool> {
        // Of most the ball around it tells, without its corners.
        let height = self.plane.height(other.center);
        if height >= other.radius + self.flush {
            return Some(true);
        }
        if height <= -other.radius {
            return None;
        }
        let [low, high] = self.heights_of(other);
        (high > self.flush).then_some(low >= 0.0)
    }

    /// Number of its element.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// Its centre.
    pub(super) fn center(&self) -> DVec3 {
        self.center
    }

    /// The facet as an end of a shaft.
    pub(super) fn end(&self) -> FlatEnd<'_> {
        let Self { surface, plane, hull, ball, .. } = self;
        FlatEnd { surface: *surface, plane: *plane, hull, ball: *ball }
    }

    /// Least and largest height of the corners of another facet over the plane of this one.
    fn heights_of(&self, other: &Self) -> [f64; 2] {
        let heights = other.hull.iter().map(|corner| self.plane.height(*corner));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| [low.min(own), high.max(own)])
    }

    /// The exchange with a facet that nothing hides (length²), and the number of its terms.
    pub(super) fn by_points(&self, other: &Self) -> (f64, u64) {
        let mut sum = 0.0;
        for own in &self.nodes {
            for to in &other.nodes {
                sum += own.weight * to.weight * self.kernel([own.position, to.position], other);
            }
        }
        (sum, (self.nodes.len() * other.nodes.len()) as u64)
    }

    /// κ from a point of this facet to one of another (length⁻²).
    pub(super) fn kernel(&self, [from, to]: [DVec3; 2], other: &Self) -> f64 {
        let along = to - from;
        let square = along.length_squared();
        let cosines = self.plane.normal.dot(along).max(0.0) * (-other.plane.normal.dot(along)).max(0.0);
        cosines / (PI * square * square)
    }

    /// The end of a segment of this index.
    pub(super) fn point(&self, end: End, index: u64) -> DVec3 {
        match self.first[end as usize].get(index as usize) {
            Some(point) => *point,
            None => point(&self.map, &self.shift, end, index),
        }
    }
}

/// The end of a segment of this index.
fn point(map: &AreaPreservingMap, shift: &[f64; 4], end: End, index: u64) -> DVec3 {
    let [a, b, c, d] = shifted(kronecker::point(index), shift);
    let place = if end == End::Start { [a, b] } else { [c, d] };
    map.point(place).node.position
}

/// The points of a flat patch.
fn nodes(patch: &Patch) -> Vec<FacetNode> {
    let [a, b, _, d] = patch.corners();
    if patch.is_triangle() {
        let weight = (b - a).cross(d - a).length() / 6.0;
        return THIRDS.map(|[s, t]| FacetNode { position: a + (b - a) * s + (d - a) * t, weight }).to_vec();
    }
    let places = GAUSS.into_iter().flat_map(|s| GAUSS.map(|t| [s, t]));
    let node = |[s, t]: [f64; 2]| {
        let node = patch.node(s, t);
        FacetNode { position: node.position, weight: 0.25 * node.area }
    };
    places.map(node).collect()
}

/// The exchange of two elements that nothing hides (length²), and the number of its terms.
pub(super) fn by_contour([first, other]: [&Element; 2]) -> (f64, u64) {
    let pairs = first.patches.iter().flat_map(|p| other.patches.iter().map(move |q| contour::patches(p, q)));
    pairs.fold((0.0, 0), |(sum, terms), (value, count)| (sum + value, terms + count))
}

#[cfg(test)]
mod tests {
    use radiosity_elements::{Discretization, Elements};

    use super::super::BY_POINTS;
    use super::*;

    /// Two triangles of random corners, and the distance of their centres over the sum of their radii.
    fn scene(seed: u64) -> String {
        let number = |k: u64| shift::<1>(7 * seed + k)[0] - 0.5;
        let triangle = |first: u64, z: f64, turn: bool| {
            let corner =
                |k: u64| [number(first + 3 * k), number(first + 3 * k + 1), z + number(first + 3 * k + 2)];
            let [a, b, c] = [0, 1, 2].map(corner);
            let corners = if turn { [a, c, b] } else { [a, b, c] };
            format!("[[surfaces]]\ntriangle = {{ vertices = {corners:?} }}\n")
        };
        triangle(0, 0.0, false) + &triangle(100, 4.0 + 8.0 * (seed % 10) as f64 / 10.0, true)
    }

    /// Where points are taken, they err by no more than is told of them, against the contour integral.
    #[test]
    fn points_tell_far_exchanges() {
        let (mut far, mut worst) = (0, 0.0_f64);
        for seed in 0..4000 {
            let text = scene(seed);
            let scene = radiosity_language::read(&radiosity_scene::Source::new("two", &text)).expect("two");
            let how = Discretization::uniform(0, 1);
            let elements = Elements::new(&scene, &how).expect("they have area");
            let [first, other] = elements.list() else { panic!("two elements") };
            let [one, two] = [first, other].map(|own| Facet::of(own, seed, 1).expect("they are flat"));
            if one.sight_of(&two).is_some_and(|sight| sight.is_far) {
                let (found, exact) = (one.by_points(&two).0, by_contour([first, other]).0);
                worst = worst.max((found / exact - 1.0).abs());
                far += 1;
            }
        }
        assert!(far > 500, "{far}");
        assert!(worst < BY_POINTS && worst > 0.1 * BY_POINTS, "{worst}");
    }
}
