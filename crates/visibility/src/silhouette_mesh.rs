//! Silhouette meshes: quads over a curved surface, so fine that normals and edges turn little over each. They
//! only find the outline; light never uses them.
//!
//! ```text
//! quad of size h, curvature κ:   distance from the surface ≤ κ h²/8 ,   error of the corrected outline ∝ h⁴
//! ```
//!
//! The quads form a tree of boxes that contain the true surface, so what a region misses is certain. A quad
//! nearer to the eye than its size, reduced where it bends little, is quartered repeatedly: on a surface that
//! the eye lies on or just before, the chords of a quad would rise above the eye.

use std::borrow::Cow;
use std::sync::Arc;

use radiosity_geom::{Aabb, DVec3, Rect, Surface};

/// Largest angle (rad), about, by which normals and edges turn over a quad: 11°, at which a quad lies up to a
/// fortieth of its size off the surface. With a smaller value there are more quads, with a larger one
/// outlines are corrected by more.
const TURN: f64 = 0.2;

/// Most quads along a parameter, as many as turn by two full turns: a bound of memory for creases.
const MOST: usize = 64;

/// Sample points along a parameter that measure the turning, each way. What turns between two of them and
/// back is missed.
const LOOKS: usize = 16;

/// Most quarterings of a quad near the eye on the eye's own surface, which is then 1/32 as long; parts that remain
/// are ignored.
const DEPTH: usize = 5;

/// Most quarterings of a quad near an eye that does not lie on its surface: as chords leave the surface by about
/// TURN²/8 · 4⁻⁹ = 2·10⁻⁸ of its radius, they stay behind an eye a ten-millionth of its size before it. With a
/// smaller value a sheet would hide all from an eye on its back, or on another sheet that lies close before it.
const DEPTH_BEFORE: usize = 9;

/// A quad nearer to the eye than this times its bent size is quartered. An arbitrary choice: with a smaller
/// value the chords of near quads hide what the surface does not; with a larger one more quads are made anew
/// for each eye.
const NEAR: f64 = 0.7;

/// Pairs of corners of a quad.
const PAIRS: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

/// The silhouette mesh of a surface.
#[derive(Debug)]
pub struct SilhouetteMesh {
    shape: Arc<dyn Surface>,
    nodes: Vec<Node>,
}

/// A corner of a quad.
#[derive(Clone, Copy, Debug)]
pub struct Knot {
    /// Parameters of the surface.
    pub parameters: [f64; 2],
    /// The point.
    pub position: DVec3,
    /// Unit normal of the surface.
    pub normal: DVec3,
}

/// The part of a surface over a rectangle of its parameters, replaced by the quad of its corners.
#[derive(Clone, Copy, Debug)]
pub struct Quad {
    /// Corners, counter-clockwise in the parameters.
    pub knots: [Knot; 4],
    rect: Rect,
    bounds: Aabb,
}

#[derive(Debug)]
struct Node {
    bounds: Aabb,
    kind: NodeKind,
}

#[derive(Debug)]
enum NodeKind {
    /// Indices of the two halves.
    Halves([usize; 2]),
    Leaf(Box<Quad>),
}

/// The region in which quads are looked for.
pub trait Region {
    /// The point that sees.
    fn eye(&self) -> DVec3;
    /// Whether a box may reach into the region.
    fn reaches(&self, bounds: &Aabb) -> bool;
    /// The surface at the eye, if the eye lies on it.
    fn ground(&self) -> Option<Ground>;
}

/// The surface at an eye that lies on it.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// Its unit normal there, on the side of the mesh.
    pub normal: DVec3,
    /// Sine of the angle to the normal below which the normals of a quad around the eye keep that quad out of
    /// a region.
    pub least: f64,
}

impl SilhouetteMesh {
    /// The mesh of a surface.
    pub(crate) fn new(shape: &Arc<dyn Surface>) -> Self {
        Self::turning(shape, TURN)
    }

    /// The mesh of a surface over each of whose quads normals and edges turn by about the angle `turn` (rad).
    pub(crate) fn turning(shape: &Arc<dyn Surface>, turn: f64) -> Self {
        let mut mesh = Self { shape: Arc::clone(shape), nodes: Vec::new() };
        let counts = [false, true].map(|transposed| quads_along(shape.as_ref(), transposed, turn));
        mesh.grow([0, counts[0]], [0, counts[1]], counts);
        mesh
    }

    /// Adds the node of a range of quads and its children; returns its index.
    fn grow(&mut self, u: [usize; 2], v: [usize; 2], counts: [usize; 2]) -> usize {
        let index = self.nodes.len();
        let place = |k: usize, count: usize| 2.0 * k as f64 / count as f64 - 1.0;
        let (wide, high) = (u[1] - u[0], v[1] - v[0]);
        if wide.max(high) == 1 {
            let rect = Rect { u: u.map(|k| place(k, counts[0])), v: v.map(|k| place(k, counts[1])) };
            let quad = self.quad(rect);
            self.nodes.push(Node { bounds: quad.bounds, kind: NodeKind::Leaf(Box::new(quad)) });
            return index;
        }
        self.nodes.push(Node { bounds: Aabb::EMPTY, kind: NodeKind::Halves([0, 0]) });
        let middle = |range: [usize; 2]| usize::midpoint(range[0], range[1]);
        let halves = match wide >= high {
            true => [[u[0], middle(u)], [middle(u), u[1]]].map(|u| self.grow(u, v, counts)),
            false => [[v[0], middle(v)], [middle(v), v[1]]].map(|v| self.grow(u, v, counts)),
        };
        let bounds = self.nodes[halves[0]].bounds.union(self.nodes[halves[1]].bounds);
        self.nodes[index] = Node { bounds, kind: NodeKind::Halves(halves) };
        index
    }

    fn quad(&self, rect: Rect) -> Quad {
        Quad { knots: rect.corners().map(|at| self.knot(at)), rect, bounds: self.shape.bounds(&rect) }
    }

    fn knot(&self, [u, v]: [f64; 2]) -> Knot {
        let jet = self.shape.jet(u, v);
        Knot { parameters: [u, v], position: jet.position, normal: jet.normal }
    }

    /// The quarters of a quad, in boxes with a margin of size · turn/4, twice the sagitta of an arc.
    fn quarters(&self, quad: &Quad) -> [Quad; 4] {
        let center = self.knot(quad.rect.center());
        let middles: [Knot; 4] = std::array::from_fn(|k| {
            let [a, b] = [quad.knots[k], quad.knots[(k + 1) % 4]].map(|knot| knot.parameters);
            self.knot([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])
        });
        let [low_left, low_right, high_left, high_right] = quad.rect.quarters();
        let quarter = |k: usize, rect: Rect| {
            let mut knots = [center; 4];
            (knots[k], knots[(k + 1) % 4], knots[(k + 3) % 4]) =
                (quad.knots[k], middles[k], middles[(k + 3) % 4]);
            let mut quarter = Quad { knots, rect, bounds: Aabb::around(knots.map(|knot| knot.position)) };
            quarter.bounds = quarter.bounds.inflate(0.25 * quarter.size() * quarter.turn());
            quarter
        };
        [quarter(0, low_left), quarter(1, low_right), quarter(2, high_right), quarter(3, high_left)]
    }

    /// The surface.
    pub fn shape(&self) -> &dyn Surface {
        self.shape.as_ref()
    }

    /// All quads.
    pub fn quads(&self) -> impl Iterator<Item = &Quad> {
        self.nodes.iter().filter_map(|node| match &node.kind {
            NodeKind::Leaf(quad) => Some(&**quad),
            NodeKind::Halves(_) => None,
        })
    }

    /// Whether the surface may reach into a box.
    pub fn reaches_into(&self, bounds: &Aabb) -> bool {
        self.quads().any(|quad| quad.bounds.overlaps(bounds))
    }

    /// Calls `take` for every quad that may reach into `region`, quartered near the eye.
    pub fn visit<'a>(&'a self, region: &impl Region, take: &mut impl FnMut(Cow<'a, Quad>)) {
        let depth = if region.ground().is_some() { DEPTH } else { DEPTH_BEFORE };
        let mut stack = vec![0];
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            if !region.reaches(&node.bounds) {
                continue;
            }
            match &node.kind {
                NodeKind::Halves(halves) => stack.extend(halves),
                NodeKind::Leaf(quad) => self.visit_quad(Cow::Borrowed(&**quad), region, depth, take),
            }
        }
    }

    fn visit_quad<'a>(
        &'a self,
        quad: Cow<'a, Quad>,
        region: &impl Region,
        rest: usize,
        take: &mut impl FnMut(Cow<'a, Quad>),
    ) {
        let gap = quad.bounds.distance_squared(region.eye());
        if gap > (NEAR * quad.bent_size()).powi(2) {
            return take(quad);
        }
        let is_under = |ground: Ground| rest == 0 || (gap == 0.0 && quad.leans_less(&ground));
        if region.ground().is_some_and(is_under) {
            return;
        }
        if rest == 0 {
            return take(quad);
        }
        for quarter in self.quarters(&quad) {
            if region.reaches(&quarter.bounds) {
                self.visit_quad(Cow::Owned(quarter), region, rest - 1, take);
            }
        }
    }
}

impl Quad {
    /// Whether it stands for a part of the surface over `parameters`.
    pub fn overlaps(&self, parameters: &Rect) -> bool {
        self.rect.overlaps(parameters)
    }

    /// Whether an eye sees the front of the surface, or its back, at a corner of it.
    pub fn shows(&self, eye: DVec3, is_front: bool) -> bool {
        let side = if is_front { 1.0 } else { -1.0 };
        self.knots.iter().any(|knot| side * knot.normal.dot(eye - knot.position) > 0.0)
    }

    /// Whether an edge, from this corner to the next, lies on the border of the surface's parameters.
    pub fn is_border(&self, edge: usize) -> bool {
        let [a, b] = [edge, (edge + 1) % 4].map(|corner| self.knots[corner].parameters);
        (0..2).any(|k| a[k] == b[k] && a[k].abs() == 1.0)
    }

    /// Length of a diagonal.
    fn size(&self) -> f64 {
        self.knots[0].position.distance(self.knots[2].position)
    }

    /// Size of a quad of the same sagitta that turns by [`TURN`] over its diagonal, at most the true size: on
    /// the side of a column only the breadth counts.
    fn bent_size(&self) -> f64 {
        let sagitta = |(i, j): (usize, usize)| {
            let (a, b) = (&self.knots[i], &self.knots[j]);
            (b.position - a.position).dot(b.normal - a.normal).abs()
        };
        (PAIRS.into_iter().map(sagitta).fold(0.0, f64::max) / TURN).min(self.size())
    }

    /// Whether all normals lean from `normal` by a smaller sine than `least`.
    fn leans_less(&self, ground: &Ground) -> bool {
        let Ground { normal, least } = *ground;
        let lean = |knot: &Knot| knot.normal.cross(normal).length();
        self.knots.iter().all(|knot| knot.normal.dot(normal) > 0.0 && lean(knot) < least)
    }

    /// Largest sine of the angle between two of its normals.
    fn turn(&self) -> f64 {
        let normal = |k: usize| self.knots[k].normal;
        let sine = |(i, j): (usize, usize)| normal(i).cross(normal(j)).length_squared();
        PAIRS.into_iter().map(sine).fold(0.0, f64::max).sqrt()
    }
}

/// Number of quads that turn by `turn` (rad) that a surface needs along u, or along v if `transposed`.
fn quads_along(shape: &dyn Surface, transposed: bool, turn: f64) -> usize {
    let at = |k: usize| 2.0 * (k as f64 + 0.5) / LOOKS as f64 - 1.0;
    let mut sharpest = 0.0f64;
    for other in 0..LOOKS {
        let mut last: Option<[DVec3; 2]> = None;
        for place in 0..LOOKS {
            let jet =
                if transposed { shape.jet(at(other), at(place)) } else { shape.jet(at(place), at(other)) };
            let tangent = if transposed { jet.dv } else { jet.du };
            let here = [jet.normal, tangent.normalize_or_zero()];
            if let Some(last) = last {
                let angle = |k: usize| here[k].cross(last[k]).length().atan2(here[k].dot(last[k]));
                sharpest = sharpest.max(angle(0)).max(angle(1));
            }
            last = Some(here);
        }
    }
    ((sharpest * LOOKS as f64 / turn - 1e-9).ceil() as usize).clamp(1, MOST)
}
