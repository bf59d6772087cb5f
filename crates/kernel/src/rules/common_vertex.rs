//! Two patches with one common corner: regularising coordinates on four subdomains, or two for triangles.
//!
//! With the corner as origin, points of two parallelograms are s p₁ + t p₂ and u q₁ + v q₂, of two triangles
//! s (p₁ + t (p₂ − p₁)) and u (q₁ + v (q₂ − q₁)), all coordinates in [0, 1]. In each of the subdomains
//!
//! ```text
//! parallelograms: (s, t, u, v) = x · (1, a, b, c)  and the other three places of the 1 ,   dV = x³ dx da db dc
//! triangles:      (s, u) = x · (1, a) or x · (a, 1) ,  t = b, v = c ,                      dV = x dx da db dc
//! ```
//!
//! x²κ does not depend on x, and its only singularity is that of 1/r⁴, outside the cube of (a, b, c). The sum
//! over x is therefore exact, and the zeros of r² give the numbers of points along a, b and c
//! (`crate::rules::orders::subdivided_cube`). The cube is halved as long as that saves points, so that angles
//! and proportions of the patches do not matter.
//!
//! Reference: Sauter and Schwab, *Boundary Element Methods*, chapter 5.

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::{Line, UnitRule};

use crate::moments::integrand::Sees;
use crate::moments::{Moments, PatchMoments};
use crate::rules::far;
use crate::rules::orders::subdivided_cube::{Multilinear, Part, RuledPart};
use crate::tolerances::{MOST_HALVINGS_OF_CUBE, SHARE_OF_TRIANGLES};

/// Numbers of points [x, angular] for degrees `[receiver, emitter]`, where visibility is sampled or a chart
/// is not affine. ϱ ≤ 4.2 was found on perpendicular and tilted squares with one common corner, N = 4 and 8,
/// ε = 1e-2 to 1e-8; more points in x as at a common edge ([`crate::rules::common_edge::counts`]).
pub fn counts(p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64) -> [usize; 2] {
    let affine = p.is_parallelogram() && q.is_parallelogram();
    let extra = if affine { 0 } else { 1 + (-eps.log10() / 1.5).ceil() as usize };
    let ratio = 1.0 / aspect(p, q);
    let sigma = ratio + (1.0 + ratio * ratio).sqrt();
    let rho = (sigma + (sigma * sigma - 1.0).sqrt()).min(4.2);
    [far::exact(degrees) + extra, far::points(degrees[0].max(degrees[1]), eps, rho)]
}

/// Ratio of the largest to the smallest extent of the two patches.
pub fn aspect(p: &Patch, q: &Patch) -> f64 {
    let extents = [p.extents(), q.extents()].concat();
    extents.iter().copied().fold(0.0, f64::max) / extents.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Adds two patches oriented with their common corner at (0, 0), with `points` = [x, angular]; any charts.
pub fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 2], sees: Option<Sees>) {
    let mut pair = moments.patches(p, q);
    for place in 0..4 {
        add(&mut pair, Subdomain::Box(place), &Part::WHOLE, points[0], [points[1]; 3], sees);
    }
    moments.add(pair);
}

/// Adds two flat patches that see each other wholly, oriented with their common corner at (0, 0).
///
/// Returns false, and adds nothing, where the cubes take too many parts because the patches (nearly) meet
/// elsewhere too.
pub fn integrate_flat(moments: &mut Moments, p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64) -> bool {
    let plans: Option<Vec<Plan>> = if p.is_parallelogram() && q.is_parallelogram() {
        (0..4).map(|place| Plan::new(p, q, Subdomain::Box(place), degrees, eps)).collect()
    } else {
        let (fan_p, fan_q) = (fan(p), fan(q));
        let pairs = fan_p.iter().flat_map(|p| fan_q.iter().map(move |q| (p, q)));
        let plan = |(p, q)| {
            [true, false].map(|receiver| {
                Plan::new(p, q, Subdomain::Fan { receiver }, degrees, SHARE_OF_TRIANGLES * eps)
            })
        };
        pairs.flat_map(plan).collect()
    };
    let Some(plans) = plans else { return false };
    for plan in plans {
        let mut pair = moments.patches(&plan.patches[0], &plan.patches[1]);
        for RuledPart { part, points } in plan.parts {
            add(&mut pair, plan.subdomain, &part, far::exact(degrees), points, None);
        }
        moments.add(pair);
    }
    true
}

/// The subdomain: which coordinates are proportional to x.
#[derive(Clone, Copy, Debug)]
enum Subdomain {
    /// All four; the one with this index is x itself.
    Box(usize),
    /// s and u; that of the receiver or of the emitter is x itself.
    Fan {
        /// Whether s = x, not u.
        receiver: bool,
    },
}

impl Subdomain {
    /// (s, t, u, v) at x = 1.
    fn place(self, [a, b, c]: [f64; 3]) -> [f64; 4] {
        match self {
            Self::Box(0) => [1.0, a, b, c],
            Self::Box(1) => [a, 1.0, b, c],
            Self::Box(2) => [a, b, 1.0, c],
            Self::Box(_) => [a, b, c, 1.0],
            Self::Fan { receiver: true } => [1.0, b, a, c],
            Self::Fan { receiver: false } => [a, b, 1.0, c],
        }
    }

    /// Exponent of x in dV.
    fn power(self) -> i32 {
        match self {
            Self::Box(_) => 3,
            Self::Fan { .. } => 1,
        }
    }
}

/// For two patches in one subdomain: the parts of the cube with their points.
struct Plan {
    patches: [Patch; 2],
    subdomain: Subdomain,
    parts: Vec<RuledPart<3>>,
}

impl Plan {
    fn new(p: &Patch, q: &Patch, subdomain: Subdomain, degrees: [usize; 2], eps: f64) -> Option<Self> {
        // y − x.
        let difference = |place: [f64; 3]| {
            let [s, t, u, v] = subdomain.place(place);
            q.node(u, v).position - p.node(s, t).position
        };
        let degree = degrees[0].max(degrees[1]);
        let parts =
            Multilinear { difference: &difference, degree, eps, deepest: MOST_HALVINGS_OF_CUBE }.parts()?;
        Some(Self { patches: [p.clone(), q.clone()], subdomain, parts })
    }
}

/// Adds one part of a subdomain. For each x its points are a tensor grid.
fn add(
    pair: &mut PatchMoments,
    subdomain: Subdomain,
    part: &Part<3>,
    radial: usize,
    points: [usize; 3],
    sees: Option<Sees>,
) {
    let rules = points.map(UnitRule::of);
    let size: f64 = part.size.iter().product();
    for (x, wx) in UnitRule::of(radial).iter() {
        let running = |k: usize, scale: f64| -> Vec<f64> {
            rules[k].nodes.iter().map(|node| scale * part.at(k, *node)).collect()
        };
        let (fixed, weight) = ([x], wx * x.powi(subdomain.power()) * size);
        let at_x = Line { nodes: &fixed, weights: &[1.0] };
        match subdomain {
            Subdomain::Box(place) => {
                let nodes = [0, 1, 2].map(|k| running(k, x));
                let line = |k: usize| Line { nodes: &nodes[k], weights: &rules[k].weights };
                let lines = std::array::from_fn(|side| match side.cmp(&place) {
                    std::cmp::Ordering::Equal => at_x,
                    std::cmp::Ordering::Less => line(side),
                    std::cmp::Ordering::Greater => line(side - 1),
                });
                pair.product(lines, weight, sees);
            }
            Subdomain::Fan { receiver } => {
                let nodes = [running(0, x), running(1, 1.0), running(2, 1.0)];
                let [a, b, c] = [0, 1, 2].map(|k| Line { nodes: &nodes[k], weights: &rules[k].weights });
                pair.product(if receiver { [at_x, b, a, c] } else { [a, b, at_x, c] }, weight, sees);
            }
        }
    }
}

/// A flat patch with the corner at (0, 0) as triangles with that corner at s = 0.
fn fan(patch: &Patch) -> Vec<Patch> {
    let Patch::Flat { normal, .. } = patch else { return vec![patch.clone()] };
    let polygon = patch.polygon();
    let triangle = |k: usize| Patch::Flat {
        corners: [polygon[0], polygon[k], polygon[k + 1], polygon[0]],
        normal: *normal,
    };
    (1..polygon.len() - 1).map(triangle).collect()
}
