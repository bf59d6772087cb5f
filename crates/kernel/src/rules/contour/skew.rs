//! Skew edges: the inner integral in closed form, the outer one by Gauss' rule.
//!
//! From a point at the distance w of the inner line, whose ends lie at u₀ and u₁ from its foot,
//!
//! ```text
//! ∫ ln r dt = [ u ln √(u² + w²) + w atan(u/w) ] − u₁ + u₀ .
//! ```
//!
//! As a function of the outer arc length s this is analytic except at c ± iδ for each end of the inner edge,
//! c being the foot of the end on the outer line and δ its distance; and at s* ± ih/sin θ, where the lines
//! pass each other at the distance h, if the foot on the inner line lies on the inner edge. On a panel [l, m]
//! Gauss' rule converges like ϱ⁻²ⁿ,
//!
//! ```text
//! ϱ = σ + √(σ² − 1) ,   σ = (|c + iδ − l| + |c + iδ − m|) / (m − l) ;
//! ```
//!
//! Panels where that is too slow are cut at c if it is inside, else at a quarter of the way from c to the far
//! end. Their number grows like log(1/δ).

use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::rules::contour::segment::Segment;
use crate::tolerances::{DIGITS_OF_CONTOUR, MOST_POINTS_OF_CONTOUR, SMALLEST_SIGMA_OF_CONTOUR};

/// Shortest panels, relative to the edge: singularities at their ends are integrable.
const SHORTEST: f64 = 1e-15;

/// ∫∫ (ln r + 3/2) over two segments that are not parallel, and the number of logarithms.
pub(super) fn integral(a: &Segment, b: &Segment) -> (f64, u64) {
    let (outer, inner) = if a.length <= b.length { (a, b) } else { (b, a) };
    let field = Field::new(outer, inner);
    let singularities = singularities(outer, inner);
    let mut sum = 0.0;
    let mut terms = 0;
    let mut panels = vec![[0.0, outer.length]];
    while let Some([low, high]) = panels.pop() {
        let (sigma, center) = sharpest(&singularities, low, high);
        if sigma < SMALLEST_SIGMA_OF_CONTOUR && high - low > SHORTEST * outer.length {
            let cut = cut(low, high, center);
            panels.extend([[low, cut], [cut, high]]);
            continue;
        }
        let rule = UnitRule::of(points(sigma));
        let panel: f64 = rule.iter().map(|(x, w)| w * field.at(low + x * (high - low))).sum();
        sum += (high - low) * panel;
        terms += 2 * rule.nodes.len() as u64;
    }
    (sum + 0.5 * a.length * b.length, terms)
}

/// ∫ (ln r + 1) dt along the inner edge, from points of the outer one.
struct Field {
    /// Vector product of the outer start, relative to the inner start, with the inner direction; its
    /// derivative in s.
    across: [DVec3; 2],
    /// Foot of the outer start on the inner line; its derivative in s.
    foot: [f64; 2],
    length: f64,
}

impl Field {
    fn new(outer: &Segment, inner: &Segment) -> Self {
        let offset = outer.start - inner.start;
        Self {
            across: [offset.cross(inner.direction), outer.direction.cross(inner.direction)],
            foot: [offset.dot(inner.direction), outer.direction.dot(inner.direction)],
            length: inner.length,
        }
    }

    fn at(&self, s: f64) -> f64 {
        let w2 = (self.across[0] + self.across[1] * s).length_squared();
        let u0 = -(self.foot[0] + self.foot[1] * s);
        let u1 = u0 + self.length;
        let w = w2.sqrt();
        end(u1, w2) - end(u0, w2) + w * (w * self.length).atan2(w2 + u0 * u1)
    }
}

/// u ln √(u² + w²).
fn end(u: f64, w2: f64) -> f64 {
    let r2 = u * u + w2;
    if r2 > 0.0 { 0.5 * u * r2.ln() } else { 0.0 }
}

/// The singularities c ± iδ of the integrand as a function of the outer arc length.
#[derive(Clone, Copy)]
struct Singularity {
    /// c.
    foot: f64,
    /// δ.
    distance: f64,
}

fn singularities(outer: &Segment, inner: &Segment) -> [Singularity; 3] {
    let seen = |point: DVec3| {
        let offset = point - outer.start;
        Singularity { foot: offset.dot(outer.direction), distance: offset.cross(outer.direction).length() }
    };
    let ends = [seen(inner.start), seen(inner.end)];
    let normal = outer.direction.cross(inner.direction);
    let offset = inner.start - outer.start;
    let sine2 = normal.length_squared();
    let foot = offset.cross(outer.direction).dot(normal) / sine2;
    let passing = if (0.0..=inner.length).contains(&foot) {
        Singularity {
            foot: offset.cross(inner.direction).dot(normal) / sine2,
            distance: offset.dot(normal).abs() / sine2,
        }
    } else {
        ends[0]
    };
    [ends[0], ends[1], passing]
}

/// Smallest σ on a panel, and the foot c of its singularity.
fn sharpest(singularities: &[Singularity], low: f64, high: f64) -> (f64, f64) {
    let sigma = |Singularity { foot, distance }: &Singularity| {
        ((foot - low).hypot(*distance) + (foot - high).hypot(*distance)) / (high - low)
    };
    let worst = |least: (f64, f64), singularity: &Singularity| {
        let sigma = sigma(singularity);
        if sigma < least.0 { (sigma, singularity.foot) } else { least }
    };
    singularities.iter().fold((f64::INFINITY, 0.0), worst)
}

fn points(sigma: f64) -> usize {
    let rate = 2.0 * (sigma + (sigma * sigma - 1.0).max(0.0).sqrt()).ln();
    if rate * MOST_POINTS_OF_CONTOUR as f64 > DIGITS_OF_CONTOUR {
        (DIGITS_OF_CONTOUR / rate).ceil().max(1.0) as usize
    } else {
        MOST_POINTS_OF_CONTOUR
    }
}

/// Where to cut a panel that is too long for a singularity with the foot `center`.
fn cut(low: f64, high: f64, center: f64) -> f64 {
    // A foot this near to an end does not cut there: one panel would be a thousandth of the other and the
    // other as hard as the whole.
    let margin = 1e-3 * (high - low);
    if center > low + margin && center < high - margin {
        return center;
    }
    let near_low = center - low < high - center;
    let (near, far) = if near_low { (low, high) } else { (high, low) };
    let cut = center + 0.25 * (far - center);
    if (cut - near) * (far - near) > 0.0 { cut } else { low.midpoint(high) }
}
