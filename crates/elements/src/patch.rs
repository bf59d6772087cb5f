//! A patch: a piece of an element charted by the unit square, for quadrature.
//!
//! (s, t) ∈ [0, 1]² ↦ x(s, t), with corners c₀ = x(0, 0), c₁ = x(1, 0), c₂ = x(1, 1), c₃ = x(0, 1). A flat
//! patch is the bilinear image of its four corners; a triangle repeats its last corner (c₂ = c₃), and only
//! the edge t = 1 collapses. A curved patch is an affine image of the unit square in the parameters of its
//! surface. Rules that need a corner of contact at s = t = 0 or an edge at t = 0 re-orient the patch; the
//! chart may then be left-handed, so areas are always positive.

use std::sync::Arc;

use radiosity_geom::{DVec2, DVec3, Plane, ROUNDING, Rect, Surface, touching};

/// A piece of an element charted by the unit square.
#[derive(Clone, Debug)]
pub enum Patch {
    /// A planar convex quadrilateral or, with the last corner repeated, a triangle.
    Flat {
        /// Corners at (0,0), (1,0), (1,1), (0,1).
        corners: [DVec3; 4],
        /// Unit normal of the front.
        normal: DVec3,
    },
    /// A parallelogram in the parameters of a curved surface.
    Curved {
        /// The surface whose parameters are charted.
        surface: Arc<dyn Surface>,
        /// Parameters at (0, 0).
        origin: DVec2,
        /// Change of the parameters along s.
        along: DVec2,
        /// Change of the parameters along t.
        across: DVec2,
    },
}

/// A point of a patch with what the kernel needs.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Position of the point.
    pub position: DVec3,
    /// Unit normal of the front.
    pub normal: DVec3,
    /// Area element |x_s × x_t| (scene length²).
    pub area: f64,
    /// Parameters of the surface; zero on flat patches, which need none.
    pub parameters: DVec2,
}

/// A direction of the chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The direction of s.
    Along,
    /// The direction of t.
    Across,
}

/// Equal to the last bit, of the same surface.
impl PartialEq for Patch {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Flat { corners, normal }, Self::Flat { corners: others, normal: other }) => {
                corners == others && normal == other
            }
            (
                Self::Curved { surface, origin, along, across },
                Self::Curved { surface: other, origin: from, along: forth, across: sideways },
            ) => Arc::ptr_eq(surface, other) && [origin, along, across] == [from, forth, sideways],
            _ => false,
        }
    }
}

impl Patch {
    /// The whole parameter rectangle `rect` of a curved surface.
    pub fn curved(surface: Arc<dyn Surface>, rect: &Rect) -> Self {
        Self::Curved {
            surface,
            origin: DVec2::new(rect.u[0], rect.v[0]),
            along: DVec2::new(rect.u[1] - rect.u[0], 0.0),
            across: DVec2::new(0.0, rect.v[1] - rect.v[0]),
        }
    }

    /// Cuts a planar convex polygon (at least 3 vertices, in order) into patches.
    ///
    /// Every edge of the polygon is a whole edge of exactly one patch.
    pub fn of_polygon(polygon: &[DVec3], normal: DVec3) -> Vec<Self> {
        let mut patches = Vec::new();
        let mut rest = 1;
        while rest + 1 < polygon.len() {
            let last = (rest + 2).min(polygon.len() - 1);
            let corners = [polygon[0], polygon[rest], polygon[rest + 1], polygon[last]];
            patches.push(Self::Flat { corners, normal });
            rest = last;
        }
        patches
    }

    /// The point charted by (s, t).
    pub fn node(&self, s: f64, t: f64) -> Node {
        match self {
            Self::Flat { corners: [a, b, c, d], normal } => {
                let along = (b - a) * (1.0 - t) + (c - d) * t;
                let across = (d - a) * (1.0 - s) + (c - b) * s;
                Node {
                    // From one corner: slivers lose the fewest digits of their width.
                    position: a + (b - a) * s + across * t,
                    normal: *normal,
                    area: along.cross(across).length(),
                    parameters: DVec2::ZERO,
                }
            }
            Self::Curved { surface, origin, along, across } => {
                let parameters = *origin + *along * s + *across * t;
                let jet = surface.jet(parameters.x, parameters.y);
                Node {
                    position: jet.position,
                    normal: jet.normal,
                    area: jet.area * along.perp_dot(*across).abs(),
                    parameters,
                }
            }
        }
    }

    /// n × n nodes at the centres of as many equal cells.
    pub fn cell_nodes(&self, n: usize) -> Vec<Node> {
        let place = |k: usize| (k as f64 + 0.5) / n as f64;
        (0..n * n).map(|k| self.node(place(k / n), place(k % n))).collect()
    }

    /// Corners at (0,0), (1,0), (1,1), (0,1); a triangle repeats the last.
    pub fn corners(&self) -> [DVec3; 4] {
        match self {
            Self::Flat { corners, .. } => *corners,
            Self::Curved { surface, origin, along, across } => {
                [*origin, *origin + *along, *origin + *along + *across, *origin + *across]
                    .map(|p| surface.jet(p.x, p.y).position)
            }
        }
    }

    /// The corners as the vertices of a polygon: three for a triangle, four otherwise.
    pub fn polygon(&self) -> Vec<DVec3> {
        let corners = self.corners();
        corners[..if self.is_triangle() { 3 } else { 4 }].to_vec()
    }

    /// Points whose convex hull contains the patch.
    pub fn hull(&self) -> Vec<DVec3> {
        match self {
            Self::Flat { .. } => self.polygon(),
            Self::Curved { surface, .. } => surface.hull(&self.parameters()),
        }
    }

    /// Whether the patch is a flat triangle.
    pub fn is_triangle(&self) -> bool {
        matches!(self, Self::Flat { corners, .. } if corners[2] == corners[3])
    }

    /// Whether the patch lies in a plane.
    pub fn is_flat(&self) -> bool {
        matches!(self, Self::Flat { .. })
    }

    /// Whether the chart is affine to 1e-14 of its size (some roundings): constant area element, polynomial
    /// degree kept.
    pub fn is_parallelogram(&self) -> bool {
        let Self::Flat { corners: [a, b, c, d], .. } = self else { return false };
        let scale = (*c - *a).abs().max_element() + (*d - *b).abs().max_element();
        ((*b - *a) - (*c - *d)).abs().max_element() <= 1e-14 * scale
    }

    /// Whether the patch is flat with four right angles, to rounding.
    pub fn is_rectangle(&self) -> bool {
        let Self::Flat { corners: [a, b, _, d], .. } = self else { return false };
        let (along, across) = (b - a, d - a);
        self.is_parallelogram() && along.dot(across).abs() <= ROUNDING * along.length() * across.length()
    }

    /// Largest lengths along s and along t (scene length).
    pub fn extents(&self) -> [f64; 2] {
        let [a, b, c, d] = self.corners();
        [a.distance(b).max(d.distance(c)), a.distance(d).max(b.distance(c))]
    }

    /// Smallest lengths along s and along t, of sides of a curved patch (scene length); a flat one has its
    /// extents.
    pub fn narrowest(&self) -> [f64; 2] {
        if self.is_flat() {
            return self.extents();
        }
        let [a, b, c, d] = self.corners();
        [a.distance(b).min(d.distance(c)), a.distance(d).min(b.distance(c))]
    }

    /// The direction of the larger extent, and that extent.
    pub fn longest(&self) -> (Direction, f64) {
        let [along, across] = self.extents();
        if along >= across { (Direction::Along, along) } else { (Direction::Across, across) }
    }

    /// About the patch's distance from the plane of its corners: of its middle from theirs, and their twist;
    /// 0 if flat.
    pub fn sagitta(&self) -> f64 {
        if self.is_flat() { 0.0 } else { self.sagitta_of(&self.corners(), &self.node(0.5, 0.5)) }
    }

    /// As [`Patch::sagitta`], where the corners and the middle of the patch are known.
    pub fn sagitta_of(&self, [a, b, c, d]: &[DVec3; 4], middle: &Node) -> f64 {
        if self.is_flat() {
            return 0.0;
        }
        let twist = 0.25 * (a - b + c - d).dot(middle.normal).abs();
        middle.position.distance(0.25 * (a + b + c + d)) + 2.0 * twist
    }

    /// The two halves of a cut at the middle of one direction.
    pub fn halves(&self, direction: Direction) -> [Self; 2] {
        self.cut(direction, 0.5)
    }

    /// The pairs of the halves of the longer of two patches, across its extent, with the other one.
    pub fn halve_longer(p: &Self, q: &Self) -> [[Self; 2]; 2] {
        let ((direction_p, extent_p), (direction_q, extent_q)) = (p.longest(), q.longest());
        if extent_p >= extent_q {
            p.halves(direction_p).map(|half| [half, q.clone()])
        } else {
            q.halves(direction_q).map(|half| [p.clone(), half])
        }
    }

    /// The two parts of a cut at the parameter `at` of one direction.
    pub fn cut(&self, direction: Direction, at: f64) -> [Self; 2] {
        match self {
            Self::Flat { corners: [a, b, c, d], normal } => {
                let flat = |corners| Self::Flat { corners, normal: *normal };
                if direction == Direction::Along {
                    let (low, high) = (a.lerp(*b, at), d.lerp(*c, at));
                    [flat([*a, low, high, *d]), flat([low, *b, *c, high])]
                } else {
                    let (left, right) = (a.lerp(*d, at), b.lerp(*c, at));
                    [flat([*a, *b, right, left]), flat([left, right, *c, *d])]
                }
            }
            Self::Curved { surface, origin, along, across } => {
                [[0.0, at], [at, 1.0 - at]].map(|[from, share]| {
                    let (step, along, across) = match direction {
                        Direction::Along => (*along * from, *along * share, *across),
                        Direction::Across => (*across * from, *along, *across * share),
                    };
                    Self::Curved { surface: Arc::clone(surface), origin: *origin + step, along, across }
                })
            }
        }
    }

    /// This patch, charted so that corner `first` is at (0, 0) and its neighbour `second` at (1, 0). Indices
    /// are those of [`Patch::polygon`].
    pub fn oriented(&self, first: usize, second: usize) -> Self {
        let count = if self.is_triangle() { 3 } else { 4 };
        let forward = (first + 1) % count == second;
        match self {
            Self::Flat { corners, normal } if count == 3 => {
                let third = corners[3 - first - second];
                Self::Flat { corners: [corners[first], corners[second], third, third], normal: *normal }
            }
            Self::Flat { corners, normal } => {
                let step = if forward { 1 } else { 3 };
                let corners = [0, 1, 2, 3].map(|k| corners[(first + k * step) % 4]);
                Self::Flat { corners, normal: *normal }
            }
            Self::Curved { surface, origin, along, across } => {
                let at = |k: usize| match k {
                    0 => *origin,
                    1 => *origin + *along,
                    2 => *origin + *along + *across,
                    _ => *origin + *across,
                };
                let third = (first + if forward { 3 } else { 1 }) % 4;
                Self::Curved {
                    surface: surface.clone(),
                    origin: at(first),
                    along: at(second) - at(first),
                    across: at(third) - at(first),
                }
            }
        }
    }

    /// The part of a curved patch over the parameters `rect`; a flat one as it is.
    pub(crate) fn with_parameters(&self, rect: &Rect) -> Self {
        match self {
            Self::Flat { .. } => self.clone(),
            Self::Curved { surface, .. } => Self::curved(Arc::clone(surface), rect),
        }
    }

    /// The least rectangle of parameters around a curved patch; all parameters for a flat one.
    pub fn parameters(&self) -> Rect {
        let Self::Curved { origin, along, across, .. } = self else { return Rect::FULL };
        let (low, high) = (origin.min(*origin + *along + *across), origin.max(*origin + *along + *across));
        Rect { u: [low.x, high.x], v: [low.y, high.y] }
    }
}

/// The common plane of patches that all lie in one and face the same way.
pub fn plane_of(patches: &[Patch]) -> Option<Plane> {
    let places =
        |patch: &Patch| if patch.is_flat() { vec![patch.node(0.0, 0.0)] } else { patch.cell_nodes(3) };
    let mut all = patches.iter().flat_map(places);
    let first = all.next()?;
    let is_level = |x: Node| {
        let d = x.position - first.position;
        x.normal.distance(first.normal) <= ROUNDING && d.dot(first.normal).abs() <= touching(d.length(), 0.0)
    };
    all.all(is_level).then_some(Plane { point: first.position, normal: first.normal })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pentagon() -> Vec<DVec3> {
        (0..5)
            .map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 5.0).sin_cos();
                DVec3::new(cos, sin, 0.0)
            })
            .collect()
    }

    fn area(patch: &Patch) -> f64 {
        let rule = super::super::rule::UnitRule::of(2);
        let mut sum = 0.0;
        for (s, ws) in rule.iter() {
            for (t, wt) in rule.iter() {
                sum += ws * wt * patch.node(s, t).area;
            }
        }
        sum
    }

    #[test]
    fn polygon_is_covered_once() {
        let patches = Patch::of_polygon(&pentagon(), DVec3::Z);
        let exact = 2.5 * (std::f64::consts::TAU / 5.0).sin();
        let sum: f64 = patches.iter().map(area).sum();
        assert_eq!(patches.len(), 2);
        assert!((sum - exact).abs() < 1e-15 * 8.0, "{sum} {exact}");
    }

    #[test]
    fn halves_and_orientations_keep_the_area() {
        for patch in Patch::of_polygon(&pentagon(), DVec3::Z) {
            let whole = area(&patch);
            for direction in [Direction::Along, Direction::Across] {
                let [a, b] = patch.halves(direction);
                assert!((area(&a) + area(&b) - whole).abs() < 1e-14);
            }
            let polygon = patch.polygon();
            for first in 0..polygon.len() {
                for second in [(first + 1) % polygon.len(), (first + polygon.len() - 1) % polygon.len()] {
                    let turned = patch.oriented(first, second);
                    assert!((area(&turned) - whole).abs() < 1e-14);
                    assert!(turned.node(0.0, 0.0).position.distance(polygon[first]) < 1e-15);
                    assert!(turned.node(1.0, 0.0).position.distance(polygon[second]) < 1e-15);
                }
            }
        }
    }
}
