//! The inner integral of a near flat pair, in polar coordinates about the foot of the outer point.
//!
//! The outer point x has the height h > 0 over the plane of the polygon Q, and the foot x′ in it. With
//! w = y − x′,
//!
//! ```text
//! I_l(x) = ∫_Q κ(x, y) L_l(y) dA = h/π ∫_Q (g + n_x·w) L_l(x′ + w) / (|w|² + h²)² dA ,    g = n_x·(x′ − x) .
//! ```
//!
//! Q is the signed sum of the triangles between x′ and its edges. On an edge at the signed distance p from
//! x′, with s counted along it from the foot of x′, v(s) the vector from x′ to its point, R² = p² + s² and
//! w = t v(s),
//!
//! ```text
//! I_l = h/π Σ_edges ∫ p ds/R⁴ ∫₀¹ t (g + t n_x·v) L_l(x′ + t v) / (t² + η²)² dt ,    η = h/R .
//! ```
//!
//! The integral along a ray is exact for every η ([`crate::rules::near::radial`]): h → 0 costs nothing. The
//! rest is analytic in s except at s = ±𝚒D, D = √(p² + h²) being the distance of x from the edge's line.
//! s = D sinh μ makes it converge exponentially, and the cost of the nearest edge grows like ln(1/D).

use num_complex::Complex64;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::MOST_POINTS;
use radiosity_elements::space::Space;
use radiosity_geom::{DVec2, DVec3};

use crate::rules::near::radial::Radial;
use crate::rules::near::samples::Samples;
use crate::rules::near::stretch::Stretch;

/// Points of an edge up to which no cut at the foot is tried: both halves together take hardly fewer.
const FEW: usize = 6;
/// p|/D below which an edge carries nothing: rounding.
const NO_WEIGHT: f64 = 1e-16;

#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub start: DVec3,
    /// Unit vector along it.
    pub along: DVec3,
    pub length: f64,
}

/// The edges of a flat patch, in order.
pub(super) fn edges(patch: &Patch) -> Vec<Edge> {
    edges_of(&patch.polygon())
}

fn edges_of(polygon: &[DVec3]) -> Vec<Edge> {
    (0..polygon.len())
        .map(|k| {
            let side = polygon[(k + 1) % polygon.len()] - polygon[k];
            let length = side.length();
            Edge { start: polygon[k], along: side / length, length }
        })
        .filter(|edge| edge.length > 0.0)
        .collect()
}

/// An edge of a flat emitter.
#[derive(Clone, Copy, Debug)]
struct BorderEdge {
    edge: Edge,
    /// Unit vector in the plane of the emitter, normal to the edge, out of the emitter.
    outward: DVec3,
}

/// The edges of a convex polygon in a plane with this normal.
fn border(polygon: &[DVec3], normal: DVec3) -> Vec<BorderEdge> {
    let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
    let outward = |edge: &Edge| {
        let side = edge.along.cross(normal);
        if side.dot(edge.start - middle) < 0.0 { -side } else { side }
    };
    edges_of(polygon).into_iter().map(|edge| BorderEdge { edge, outward: outward(&edge) }).collect()
}

/// The polar rule over one flat emitter.
#[derive(Debug)]
pub(in crate::rules) struct Polar<'a> {
    edges: Vec<BorderEdge>,
    /// A point of its plane.
    origin: DVec3,
    normal: DVec3,
    basis: &'a AreaBasis,
    /// Largest extent of the emitter relative to the element's frame.
    fraction: f64,
    radial: Radial,
    samples: Samples,
    column: Vec<f64>,
}

impl<'a> Polar<'a> {
    /// For the flat patch `emitter`, a part of an element with `basis`.
    pub(in crate::rules) fn new(emitter: &Patch, basis: &'a AreaBasis, eps: f64) -> Self {
        let normal = emitter.node(0.5, 0.5).normal;
        let polygon = emitter.polygon();
        Self {
            fraction: fraction(emitter, basis),
            edges: border(&polygon, normal),
            origin: polygon[0],
            normal,
            basis,
            radial: Radial::new(basis.total_degree(), eps),
            samples: Samples::default(),
            column: vec![0.0; basis.len()],
        }
    }

    /// As [`Polar::column`], of a convex part of the emitter.
    pub(in crate::rules) fn column_of(&mut self, part: &[DVec3], x: &Node, eps: f64) -> (&[f64], u64) {
        self.edges = border(part, self.normal);
        self.column(x, eps)
    }

    /// I_l(x) for all l, to about `eps` relative to the largest irradiance, and the number of samples.
    pub(super) fn column(&mut self, x: &Node, eps: f64) -> (&[f64], u64) {
        self.samples.clear();
        let height = self.height(x);
        if height > 0.0 {
            for k in 0..self.edges.len() {
                let ray = Rays::new(x, height, self.normal, &self.edges[k]);
                for (piece, n) in ray.pieces(self.fraction, self.basis.total_degree() + 1, eps) {
                    self.edge(&ray, &piece, n);
                }
            }
        }
        let count = self.samples.len() as u64;
        match self.basis.is_product() && self.basis.space() == Space::Total {
            true => self.samples.sum(self.basis.order(), &mut self.column),
            false => self.samples.sum_of(|place, out| self.basis.raw(place, out), &mut self.column),
        }
        (&self.column, count)
    }

    /// Height of a point over the plane of the emitter.
    pub(in crate::rules) fn height(&self, x: &Node) -> f64 {
        (x.position - self.origin).dot(self.normal)
    }

    /// Whether the emitter's polynomials, extended to the foot of a point, grow so little that rounding stays
    /// below ε.
    pub(in crate::rules) fn reaches(&self, x: DVec3, eps: f64) -> bool {
        let foot = x - self.normal * (x - self.origin).dot(self.normal);
        let place = self.basis.frame().locate(foot, DVec2::ZERO);
        let a = place[0].abs().max(place[1].abs()).max(1.0);
        let growth = (a + (a * a - 1.0).sqrt()).powi(self.basis.total_degree() as i32);
        // 1e-15 is the rounding error of values; no accuracy beyond 1e-12 is asked.
        growth * 1e-15 < eps.max(1e-12)
    }

    /// The number of samples that [`Polar::column`] takes.
    pub(super) fn count(&self, x: &Node, eps: f64) -> usize {
        let height = self.height(x);
        let points = |edge: &BorderEdge| {
            let ray = Rays::new(x, height, self.normal, edge);
            ray.pieces(self.fraction, self.basis.total_degree() + 1, eps).map(|(_, n)| n).sum::<usize>()
        };
        self.edges.iter().map(points).sum::<usize>() * self.radial.len()
    }

    /// Where the line `start` + s `step` meets the plane inside the polygon, h = 0 and I_l has a term of
    /// order h² ln h; None if that stays below `eps` for all s ∈ [0, 1].
    pub(super) fn crossing(&self, start: DVec3, step: DVec3, eps: f64) -> Option<Complex64> {
        let (height, slope) = ((start - self.origin).dot(self.normal), step.dot(self.normal));
        let size = self.edges.iter().map(|border| border.edge.length).fold(0.0, f64::max);
        let most = height.abs().max((height + slope).abs()) / size;
        // A parallel line does not meet the plane; a term below a tenth of the error allowed counts as none.
        if slope.abs() < 1e-14 * step.length() || most * most < 0.1 * eps {
            return None;
        }
        let place = -height / slope;
        let foot = start + step * place;
        let inside = self.edges.iter().all(|border| (foot - border.edge.start).dot(border.outward) <= 0.0);
        inside.then_some(Complex64::from(place))
    }

    fn edge(&mut self, ray: &Rays, piece: &Piece, n: usize) {
        let place = |point: DVec3| DVec2::from_array(self.basis.frame().locate(point, DVec2::ZERO));
        let origin = place(ray.foot);
        for (s, w) in piece.stretch.offsets(n) {
            let (s, w) = (piece.length * s, piece.length * w);
            let vector = ray.outward * ray.distance + ray.along * s;
            let radius2 = ray.distance * ray.distance + s * s;
            let step = place(ray.foot + vector) - origin;
            let turned = ray.normal.dot(vector);
            let factor = core::f64::consts::FRAC_1_PI * ray.height * ray.distance * w / (radius2 * radius2);
            for (t, [alpha, beta]) in self.radial.at(ray.height / radius2.sqrt()) {
                self.samples.push(origin + step * t, factor * (ray.facing * alpha + turned * beta));
            }
        }
    }
}

/// Approximate part of its element's frame that a flat patch covers in its longest direction.
pub(super) fn fraction(patch: &Patch, basis: &AreaBasis) -> f64 {
    let places: Vec<[f64; 2]> =
        patch.polygon().iter().map(|x| basis.frame().locate(*x, DVec2::ZERO)).collect();
    let width = |axis: usize| {
        let values = places.iter().map(|place| place[axis]);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        0.5 * (high - low)
    };
    width(0).max(width(1))
}

/// The rays from the foot of an outer point to one edge.
struct Rays {
    foot: DVec3,
    normal: DVec3,
    height: f64,
    /// g = n_x·(x′ − x).
    facing: f64,
    along: DVec3,
    outward: DVec3,
    /// p, the distance of the edge from the foot.
    distance: f64,
    /// s at the ends of the edge.
    ends: [f64; 2],
}

#[derive(Clone, Copy)]
struct Piece {
    stretch: Stretch,
    length: f64,
}

impl Rays {
    fn new(x: &Node, height: f64, normal: DVec3, border: &BorderEdge) -> Self {
        let BorderEdge { edge, outward } = *border;
        let to_start = edge.start - x.position;
        let start = to_start.dot(edge.along);
        Self {
            foot: x.position - normal * height,
            normal: x.normal,
            height,
            facing: -height * x.normal.dot(normal),
            along: edge.along,
            outward,
            distance: to_start.dot(outward),
            ends: [start, start + edge.length],
        }
    }

    /// The edge in pieces: cut at the foot of x where that saves points, and where a rule would be too large.
    fn pieces(&self, fraction: f64, degree: usize, eps: f64) -> impl Iterator<Item = (Piece, usize)> {
        let radius = (self.distance * self.distance + self.height * self.height).sqrt();
        let weight = (self.distance / radius).abs();
        let eps = (eps / weight.max(NO_WEIGHT)).min(0.5);
        let piece = |low: f64, high: f64| {
            let length = high - low;
            let (center, scale) = (-low / length, radius / length);
            let stretch = Stretch::around(center, scale);
            let n = stretch.points(stretch.ellipse(Complex64::new(center, scale)), fraction, degree, eps);
            (Piece { stretch, length }, n)
        };
        let [low, high] = self.ends;
        let whole = piece(low, high);
        let mut pieces = [None; 4];
        if weight <= NO_WEIGHT {
            return pieces.into_iter().flatten();
        }
        let mut places = [low, high, high, high, high];
        if low < 0.0 && high > 0.0 && whole.1 > FEW {
            let halves = [piece(low, 0.0), piece(0.0, high)];
            if halves[0].1 + halves[1].1 < whole.1 {
                places = [low, 0.0, high, high, high];
            }
        }
        if whole.1 > MOST_POINTS {
            let middle =
                |a: f64, b: f64| radius * (0.5 * ((a / radius).asinh() + (b / radius).asinh())).sinh();
            let inner = places[1].min(high);
            let foot = if inner < high { inner } else { middle(low, high) };
            places = [low, middle(low, foot), foot, middle(foot, high), high];
        }
        for (k, slot) in pieces.iter_mut().enumerate() {
            if places[k] < places[k + 1] {
                *slot = Some(piece(places[k], places[k + 1]));
            }
        }
        pieces.into_iter().flatten()
    }
}
