//! Points spread evenly over the area of an element, or of some patches.
//!
//! On flat elements points are distributed by area exactly. On curved ones they are distributed by the
//! parameters, and each carries the area element there over its mean as a weight.

use radiosity_geom::DVec3;

use crate::Element;
use crate::measure::WeightedNode;
use crate::patch::{Node, Patch};
use crate::rule::UnitRule;

/// Points of the Gauss rule, along either parameter, that finds the area of a curved patch. The area is a
/// weight that divides out in the mean; 8 points find it to 1e-6 on a half sphere.
const AREA_POINTS: usize = 8;

/// Map from two numbers in [0, 1] to points of patches, spread evenly over their area.
#[derive(Debug)]
pub struct AreaPreservingMap {
    pieces: Vec<Piece>,
}

/// A part of an element from which points are drawn directly.
#[derive(Debug)]
struct Piece {
    /// Shares of the area before this piece, and with it.
    shares: [f64; 2],
    chart: Chart,
}

#[derive(Debug)]
enum Chart {
    Parallelogram { corner: DVec3, sides: [DVec3; 2], normal: DVec3 },
    Triangle { corner: DVec3, sides: [DVec3; 2], normal: DVec3 },
    Curved { patch: Patch, area: f64 },
}

impl AreaPreservingMap {
    /// Map onto an element.
    pub fn over(element: &Element) -> Self {
        Self::of(&element.patches)
    }

    /// Map onto disjoint patches.
    pub fn of(patches: &[Patch]) -> Self {
        let charts: Vec<Chart> = patches.iter().flat_map(charts).collect();
        let area: f64 = charts.iter().map(Chart::area).sum();
        let mut before = 0.0;
        let pieces = charts.into_iter().map(|chart| {
            let shares = [before, before + chart.area() / area];
            before = shares[1];
            Piece { shares, chart }
        });
        Self { pieces: pieces.collect() }
    }

    /// The point that two numbers in [0, 1] choose, with the weight 1 / (A p), p the density of points per
    /// area there; 1 on flat elements.
    pub fn point(&self, [s, t]: [f64; 2]) -> WeightedNode {
        let last = self.pieces.len() - 1;
        let place = self.pieces.partition_point(|piece| piece.shares[1] <= s).min(last);
        let Piece { shares: [low, high], chart } = &self.pieces[place];
        chart.point(((s - low) / (high - low)).clamp(0.0, 1.0), t)
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

    fn point(&self, s: f64, t: f64) -> WeightedNode {
        let flat = |corner: &DVec3, [a, b]: &[DVec3; 2], normal: &DVec3, s: f64, t: f64| WeightedNode {
            node: Node {
                position: corner + a * s + b * t,
                normal: *normal,
                area: 0.0,
                parameters: Default::default(),
            },
            weight: 1.0,
        };
        match self {
            Self::Parallelogram { corner, sides, normal } => flat(corner, sides, normal, s, t),
            Self::Triangle { corner, sides, normal } => {
                // √s is distributed as the distance from a corner is.
                let root = s.sqrt();
                flat(corner, sides, normal, root * (1.0 - t), root * t)
            }
            Self::Curved { patch, area } => {
                let node = patch.node(s, t);
                WeightedNode { node, weight: node.area / area }
            }
        }
    }
}
