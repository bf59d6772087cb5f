//! Flat patches with one common corner.
//!
//! With the corner as origin, two parallelograms are s p₁ + t p₂ and u q₁ + v q₂, two triangles s (p₁ + t (p₂ − p₁)) and
//! u (q₁ + v (q₂ − q₁)), all coordinates in [0, 1]. In each of the subdomains
//!
//! ```text
//! parallelograms: (s, t, u, v) = x · (1, a, b, c)  and the other three places of the 1 ,   dV = x³ dx da db dc
//! triangles:      (s, u) = x · (1, a) or x · (a, 1) ,  t = b, v = c ,                      dV = x dx da db dc
//! ```
//!
//! x²κ does not depend on x, nor does it know any singularity but that of 1/r⁴ outside the cube of a, b, c: the sum over x is exact, and the
//! number of points along a, b and c follows from where r² vanishes ([`super::analytic`]). The cube is halved as long as that takes fewer points,
//! so angles and proportions of the patches do not matter.

use radiosity_geom::DVec3;

use crate::elements::patch::Patch;
use crate::elements::rule::{MOST_POINTS, UnitRule};

use super::analytic;
use super::integrand::Sees;
use super::moments::{Moments, PatchMoments};
use super::product::Line;
use super::separated;

/// Places of the other two variables at which the rate of convergence along one is looked at.
const PLACES: [f64; 9] = [0.0, 0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1.0];
/// Most halvings of the cube.
const DEEPEST: u32 = 60;
/// Most parts of it.
const MOST_PARTS: usize = 512;
/// What is asked of triangles, whose area elements are not constant in the subdomains.
const FAN_SHARE: f64 = 0.5;

/// Numbers of points [x, angular] for degrees `[receiver, emitter]`, for patches whose visibility is sampled or whose charts are
/// not affine.
pub(super) fn counts(p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64) -> [usize; 2] {
    let affine = p.is_parallelogram() && q.is_parallelogram();
    let extra = if affine { 0 } else { 1 + (-eps.log10() / 1.5).ceil() as usize };
    let ratio = 1.0 / aspect(p, q);
    let sigma = ratio + (1.0 + ratio * ratio).sqrt();
    let rho = (sigma + (sigma * sigma - 1.0).sqrt()).min(4.2);
    [exact(degrees) + extra, separated::points(degrees[0].max(degrees[1]), eps, rho)]
}

/// Ratio of the largest to the smallest extent of the two patches.
pub(super) fn aspect(p: &Patch, q: &Patch) -> f64 {
    let extents = [p.extents(), q.extents()].concat();
    extents.iter().copied().fold(0.0, f64::max) / extents.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Adds the pair of patches oriented with their common corner at (0, 0), with `points` = [x, angular] of any charts.
pub(super) fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 2], sees: Option<Sees>) {
    let mut pair = moments.patches(p, q);
    for place in 0..4 {
        add(&mut pair, Subdomain::Box(place), &Part::WHOLE, points[0], [points[1]; 3], sees);
    }
    moments.add(pair);
}

/// Adds two flat patches oriented with their common corner at (0, 0) that see each other freely.
///
/// False, and nothing is added, where this takes too many parts: they meet, or as good as meet, elsewhere too.
pub(super) fn integrate_flat(
    moments: &mut Moments,
    p: &Patch,
    q: &Patch,
    degrees: [usize; 2],
    eps: f64,
) -> bool {
    let plans = if p.is_parallelogram() && q.is_parallelogram() {
        plans(p, q, &[0, 1, 2, 3].map(Subdomain::Box), degrees, eps)
    } else {
        let subdomains = [true, false].map(|receiver| Subdomain::Fan { receiver });
        let (fan_p, fan_q) = (fan(p), fan(q));
        let pairs = fan_p.iter().flat_map(|p| fan_q.iter().map(move |q| (p, q)));
        pairs.flat_map(|(p, q)| plans(p, q, &subdomains, degrees, FAN_SHARE * eps)).collect()
    };
    if !plans.iter().all(Plan::resolved) {
        return false;
    }
    for plan in plans {
        let mut pair = moments.patches(&plan.patches[0], &plan.patches[1]);
        for (part, points) in plan.parts {
            add(&mut pair, plan.subdomain, &part, exact(degrees), points, None);
        }
        moments.add(pair);
    }
    true
}

/// Which coordinates run with x.
#[derive(Clone, Copy, Debug)]
enum Subdomain {
    /// All four; the one named stands at x.
    Box(usize),
    /// s and u; that of the receiver or of the emitter stands at x.
    Fan {
        /// Which.
        receiver: bool,
    },
}

/// A part of the cube (a, b, c).
#[derive(Clone, Copy, Debug)]
struct Part {
    low: [f64; 3],
    size: [f64; 3],
}

impl Part {
    const WHOLE: Self = Self { low: [0.0; 3], size: [1.0; 3] };

    fn halves(&self, direction: usize) -> [Self; 2] {
        let mut halves = [*self; 2];
        halves[0].size[direction] *= 0.5;
        halves[1].size[direction] *= 0.5;
        halves[1].low[direction] += halves[1].size[direction];
        halves
    }

    fn at(&self, direction: usize, place: f64) -> f64 {
        self.low[direction] + self.size[direction] * place
    }
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

/// The rule of one pair in one subdomain, with its number of points chosen part by part.
struct Plan {
    patches: [Patch; 2],
    subdomain: Subdomain,
    degree: usize,
    eps: f64,
    parts: Vec<(Part, [usize; 3])>,
}

fn plans(p: &Patch, q: &Patch, subdomains: &[Subdomain], degrees: [usize; 2], eps: f64) -> Vec<Plan> {
    let plan = |subdomain: &Subdomain| {
        let (patches, degree) = ([p.clone(), q.clone()], degrees[0].max(degrees[1]));
        let mut plan = Plan { patches, subdomain: *subdomain, degree, eps, parts: Vec::new() };
        plan.plan(Part::WHOLE, 0);
        plan
    };
    subdomains.iter().map(plan).collect()
}

impl Plan {
    fn resolved(&self) -> bool {
        self.parts.iter().all(|(_, points)| points.iter().all(|n| *n <= MOST_POINTS))
    }

    fn plan(&mut self, part: Part, depth: u32) {
        let points = self.points(&part);
        let cost = |points: [usize; 3]| points.iter().product::<usize>();
        let direction = (0..3).max_by_key(|k| (points[*k], 3 - k)).expect("there are three");
        let halves = part.halves(direction);
        let halved: usize = halves.iter().map(|half| cost(self.points(half))).sum();
        let too_many = points.iter().any(|n| *n > MOST_POINTS);
        let may = depth < DEEPEST && self.parts.len() < MOST_PARTS;
        if may && (too_many || halved < cost(points)) {
            halves.into_iter().for_each(|half| self.plan(half, depth + 1));
        } else {
            self.parts.push((part, points));
        }
    }

    /// Points along a, b and c.
    fn points(&self, part: &Part) -> [usize; 3] {
        [0, 1, 2].map(|direction| {
            let others = [(direction + 1) % 3, (direction + 2) % 3];
            let mut rho = f64::INFINITY;
            for first in PLACES {
                for second in PLACES {
                    let mut place = part.low;
                    place[others[0]] = part.at(others[0], first);
                    place[others[1]] = part.at(others[1], second);
                    let low = self.difference(place);
                    place[direction] = part.at(direction, 1.0);
                    rho = rho.min(analytic::rate(low, self.difference(place) - low));
                }
            }
            analytic::points(self.degree, self.eps, rho)
        })
    }

    /// y − x, linear in each of the three.
    fn difference(&self, place: [f64; 3]) -> DVec3 {
        let [s, t, u, v] = self.subdomain.place(place);
        self.patches[1].node(u, v).position - self.patches[0].node(s, t).position
    }
}

/// For each x a subdomain is a tensor grid.
fn add(
    pair: &mut PatchMoments,
    subdomain: Subdomain,
    part: &Part,
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
        let at_x: Line = (&fixed, &[1.0]);
        match subdomain {
            Subdomain::Box(place) => {
                let nodes = [0, 1, 2].map(|k| running(k, x));
                let lines = std::array::from_fn(|side| match side.cmp(&place) {
                    std::cmp::Ordering::Equal => at_x,
                    std::cmp::Ordering::Less => (&nodes[side][..], &rules[side].weights[..]),
                    std::cmp::Ordering::Greater => (&nodes[side - 1][..], &rules[side - 1].weights[..]),
                });
                pair.product(lines, weight, sees);
            }
            Subdomain::Fan { receiver } => {
                let nodes = [running(0, x), running(1, 1.0), running(2, 1.0)];
                let [a, b, c] = [0, 1, 2].map(|k| (&nodes[k][..], &rules[k].weights[..]));
                pair.product(if receiver { [at_x, b, a, c] } else { [a, b, at_x, c] }, weight, sees);
            }
        }
    }
}

/// Points that are exact for the polynomials along x.
fn exact(degrees: [usize; 2]) -> usize {
    (degrees[0] + degrees[1] + 3) / 2
}

/// A patch oriented with the corner at (0, 0) as triangles that collapse in it: s = 0 is the corner.
fn fan(patch: &Patch) -> Vec<Patch> {
    let Patch::Flat { normal, .. } = patch else { return vec![patch.clone()] };
    let polygon = patch.polygon();
    let triangle = |k: usize| Patch::Flat {
        corners: [polygon[0], polygon[k], polygon[k + 1], polygon[0]],
        normal: *normal,
    };
    (1..polygon.len() - 1).map(triangle).collect()
}
