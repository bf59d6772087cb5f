//! Rays that leave an element: from points spread evenly over its area, in cosine-distributed directions.
//!
//! The density of points and directions together is cos θ / (π A), that of κ V dA_y over the whole hemisphere. The
//! numbers are a Kronecker sequence in four dimensions, shifted by a hash of a number of the element, so that a ray depends
//! on its element and its own number only: not on threads, nor on how many rays are sent in all.
//!
//! On flat elements points are distributed by area exactly. On curved ones they are distributed by the parameters, and
//! each ray carries the area element there over its mean as a weight.

use std::f64::consts::TAU;

use radiosity_geom::DVec3;

use crate::elements::Element;
use crate::elements::patch::{Node, Patch};
use crate::elements::rule::UnitRule;
use crate::transport::moments::kronecker;

/// Points of the Gauss rule, along either parameter, that finds the area of a curved patch. The area is a weight
/// that divides out in the mean; 8 points find it to 1e-6 on a half sphere.
const AREA_POINTS: usize = 8;

/// What sends the rays of one element.
#[derive(Debug)]
pub(super) struct Sender {
    pieces: Vec<Piece>,
    shift: [f64; 4],
}

/// A ray as it leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure {
    /// Where it starts.
    pub node: Node,
    /// Its unit direction.
    pub direction: DVec3,
    /// 1 / (A p), p the density of points per area here: 1 on flat elements.
    pub weight: f64,
}

/// A part of an element from which points are drawn directly.
#[derive(Debug)]
struct Piece {
    /// Shares of the element's area before this piece, and with it.
    shares: [f64; 2],
    chart: Chart,
}

#[derive(Debug)]
enum Chart {
    Parallelogram { corner: DVec3, sides: [DVec3; 2], normal: DVec3 },
    Triangle { corner: DVec3, sides: [DVec3; 2], normal: DVec3 },
    Curved { patch: Patch, area: f64 },
}

impl Sender {
    /// The sender of an element; its rays are those of this number.
    pub(super) fn new(element: &Element, number: u64) -> Self {
        let charts: Vec<Chart> = element.patches.iter().flat_map(charts).collect();
        let area: f64 = charts.iter().map(Chart::area).sum();
        let mut before = 0.0;
        let pieces = charts.into_iter().map(|chart| {
            let shares = [before, before + chart.area() / area];
            before = shares[1];
            Piece { shares, chart }
        });
        Self { pieces: pieces.collect(), shift: shift(number) }
    }

    /// The ray of that `index`.
    pub(super) fn departure(&self, index: u64) -> Departure {
        let mut z = kronecker::point(index);
        z.iter_mut().zip(self.shift).for_each(|(z, shift)| *z = (*z + shift).fract());
        let [s, t, polar, turn] = z;
        let last = self.pieces.len() - 1;
        let place = self.pieces.partition_point(|piece| piece.shares[1] <= s).min(last);
        let Piece { shares: [low, high], chart } = &self.pieces[place];
        let (node, weight) = chart.point(((s - low) / (high - low)).clamp(0.0, 1.0), t);
        Departure { node, direction: lambert(node.normal, polar, turn), weight }
    }
}

/// The pieces of a patch: two triangles for a quadrilateral that is no parallelogram.
fn charts(patch: &Patch) -> Vec<Chart> {
    let Patch::Flat { corners: [a, b, c, d], normal } = patch else {
        return vec![Chart::Curved { patch: patch.clone(), area: curved_area(patch) }];
    };
    let triangle =
        |b: &DVec3, c: &DVec3| Chart::Triangle { corner: *a, sides: [b - a, c - a], normal: *normal };
    if patch.is_triangle() {
        vec![triangle(b, c)]
    } else if patch.is_parallelogram() {
        vec![Chart::Parallelogram { corner: *a, sides: [b - a, d - a], normal: *normal }]
    } else {
        vec![triangle(b, c), triangle(c, d)]
    }
}

fn curved_area(patch: &Patch) -> f64 {
    let rule = UnitRule::of(AREA_POINTS);
    let points = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
    points.map(|((s, ws), (t, wt))| ws * wt * patch.node(s, t).area).sum()
}

impl Chart {
    fn area(&self) -> f64 {
        match self {
            Self::Parallelogram { sides: [a, b], .. } => a.cross(*b).length(),
            Self::Triangle { sides: [a, b], .. } => 0.5 * a.cross(*b).length(),
            Self::Curved { area, .. } => *area,
        }
    }

    /// The point that two numbers in [0, 1] choose, and its weight.
    fn point(&self, s: f64, t: f64) -> (Node, f64) {
        let flat = |corner: &DVec3, [a, b]: &[DVec3; 2], normal: &DVec3, s: f64, t: f64| Node {
            position: corner + a * s + b * t,
            normal: *normal,
            area: 0.0,
            parameters: Default::default(),
        };
        match self {
            Self::Parallelogram { corner, sides, normal } => (flat(corner, sides, normal, s, t), 1.0),
            Self::Triangle { corner, sides, normal } => {
                // √s is distributed as the distance from a corner is.
                let root = s.sqrt();
                (flat(corner, sides, normal, root * (1.0 - t), root * t), 1.0)
            }
            Self::Curved { patch, area } => {
                let node = patch.node(s, t);
                (node, node.area / area)
            }
        }
    }
}

/// A cosine-distributed direction about a unit normal.
fn lambert(normal: DVec3, polar: f64, turn: f64) -> DVec3 {
    let (along, across) = normal.any_orthonormal_pair();
    let (sin, cos) = (TAU * turn).sin_cos();
    let out = polar.sqrt();
    (along * cos + across * sin) * out + normal * (1.0 - polar).max(0.0).sqrt()
}

/// Numbers in [0, 1) by which the sequence of that number is shifted.
fn shift(number: u64) -> [f64; 4] {
    std::array::from_fn(|k| (hash(4 * number + k as u64) >> 11) as f64 / (1u64 << 53) as f64)
}

/// SplitMix64: G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014.
fn hash(value: u64) -> u64 {
    let z = value.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
