//! The kernel between two parallelograms with a common edge, as moments over the angular variables.
//!
//! In the coordinates of [`super::edge`] the two stand at t p and v q from the edge e, and κ is homogeneous of degree −2:
//! with (t, v, z) = x (τ, ν, ζ)
//!
//! ```text
//! x² κ = (n_p·q)(n_q·p) τ ν / π|ν q − τ p ± ζ e|⁴ ,    (τ, ν, ζ) = (1, a, b), (a, 1, b), (a, b, 1)
//! κ_rc = ∫₀¹∫₀¹ x²κ p_r(2a − 1) p_c(2b − 1) da db
//! ```
//!
//! Where one side is much deeper, the edge short or the angle small, the kernel peaks in one place of the square (a, b).
//! The square is halved towards it as long as that takes fewer points; each part has its own number of points along a and b
//! ([`super::analytic`]).

use core::f64::consts::FRAC_1_PI;

use radiosity_geom::DVec3;

use crate::elements::patch::Patch;
use crate::elements::rule::{MOST_POINTS, UnitRule};

use super::analytic;
use super::chart::polynomials;

/// Places of the other variable at which the rate of convergence along one is looked at.
const PLACES: [f64; 7] = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0];
/// Most halvings of the square.
const DEEPEST: u32 = 48;

/// Two parallelograms with a common edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hinge {
    edge: DVec3,
    depths: [DVec3; 2],
    /// (n_p·q)(n_q·p)/π times both area elements.
    strength: f64,
    /// Whether both depths stand upright on the edge, so that both signs of ζ give the same.
    upright: bool,
}

/// κ_rc of one region, r-major, combined over the two signs of ζ.
#[derive(Clone, Debug)]
pub(super) struct Angular {
    /// κ⁺ + κ⁻.
    pub even: Vec<f64>,
    /// κ⁺ − κ⁻.
    pub odd: Vec<f64>,
    /// Number of c.
    pub width: usize,
}

/// A part of the square (a, b).
#[derive(Clone, Copy, Debug)]
struct Part {
    low: [f64; 2],
    size: [f64; 2],
}

/// One of the three regions: r = fixed + a · along[0] + b · along[1], for the two signs of ζ.
struct Region {
    fixed: [DVec3; 2],
    along: [[DVec3; 2]; 2],
    /// Highest r and c.
    degrees: [usize; 2],
    /// The degree of the integrand's polynomials that counts for the number of points.
    degree: usize,
    eps: f64,
    /// Which, from 0.
    which: usize,
    /// How many of the two signs differ.
    signs: usize,
}

impl Hinge {
    /// Of two parallelograms oriented with the common edge at t = 0, each in front of the other.
    pub(super) fn new(p: &Patch, q: &Patch) -> Self {
        let (origin, far) = (p.node(0.0, 0.0), q.node(0.0, 1.0));
        let edge = p.node(1.0, 0.0).position - origin.position;
        let depths = [p.node(0.0, 1.0).position - origin.position, far.position - q.node(0.0, 0.0).position];
        let strength = origin.normal.dot(depths[1]) * far.normal.dot(depths[0]);
        let upright = depths.iter().all(|d| edge.dot(*d).abs() <= 1e-15 * edge.length() * d.length());
        Self { edge, depths, strength: FRAC_1_PI * strength * origin.area * far.area, upright }
    }

    /// κ_rc of the three regions for polynomials of the given degrees [receiver, emitter]; the number of kernel values too.
    pub(super) fn moments(&self, degrees: [usize; 2], eps: f64) -> ([Angular; 3], u64) {
        let mut samples = 0;
        let along_edge = degrees[0] + degrees[1] + 1;
        let regions = [[degrees[1], along_edge], [degrees[0], along_edge], degrees];
        let angular = [0, 1, 2].map(|which| {
            let region = self.region(which, regions[which], degrees[0].max(degrees[1]), eps);
            let mut angular = Angular::new(regions[which]);
            region.add(self.strength, Part::WHOLE, 0, &mut angular, &mut samples);
            angular
        });
        (angular, samples)
    }

    fn region(&self, which: usize, degrees: [usize; 2], degree: usize, eps: f64) -> Region {
        let [p, q] = [-self.depths[0], self.depths[1]];
        let signs = [self.edge, -self.edge];
        let (fixed, along) = match which {
            0 => ([p; 2], signs.map(|e| [q, e])),
            1 => ([q; 2], signs.map(|e| [p, e])),
            _ => (signs, [[p, q]; 2]),
        };
        Region { fixed, along, degrees, degree, eps, which, signs: if self.upright { 1 } else { 2 } }
    }
}

impl Angular {
    fn new(degrees: [usize; 2]) -> Self {
        let width = degrees[1] + 1;
        let zeros = vec![0.0; (degrees[0] + 1) * width];
        Self { even: zeros.clone(), odd: zeros, width }
    }
}

impl Part {
    const WHOLE: Self = Self { low: [0.0; 2], size: [1.0; 2] };

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

impl Region {
    /// Adds the moments of one part, halved where that takes fewer points.
    fn add(&self, strength: f64, part: Part, depth: u32, out: &mut Angular, samples: &mut u64) {
        let points = self.points(&part);
        let cost = |points: [usize; 2]| points[0] * points[1];
        let direction = usize::from(points[1] > points[0]);
        let halves = part.halves(direction);
        let halved: usize = halves.iter().map(|half| cost(self.points(half))).sum();
        let too_many = points.iter().any(|n| *n > MOST_POINTS);
        if depth < DEEPEST && (too_many || halved < cost(points)) {
            halves.iter().for_each(|half| self.add(strength, *half, depth + 1, out, samples));
        } else {
            self.integrate(strength, &part, points, out);
            *samples += (self.signs * cost(points)) as u64;
        }
    }

    /// Points along a and b.
    fn points(&self, part: &Part) -> [usize; 2] {
        [0, 1].map(|direction| {
            let other = 1 - direction;
            let rate = |sign: usize, place: f64| {
                let base = self.fixed[sign]
                    + self.along[sign][other] * part.at(other, place)
                    + self.along[sign][direction] * part.low[direction];
                analytic::rate(base, self.along[sign][direction] * part.size[direction])
            };
            let rates = (0..self.signs).flat_map(|sign| PLACES.map(|place| rate(sign, place)));
            analytic::points(self.degree, self.eps, rates.fold(f64::INFINITY, f64::min))
        })
    }

    fn integrate(&self, strength: f64, part: &Part, points: [usize; 2], out: &mut Angular) {
        let rules = points.map(UnitRule::of);
        let (mut row_a, mut row_b) = (vec![0.0; self.degrees[0] + 1], vec![0.0; out.width]);
        let tables: Vec<Vec<f64>> = rules[1]
            .nodes
            .iter()
            .map(|b| {
                polynomials(2.0 * part.at(1, *b) - 1.0, &mut row_b);
                row_b.clone()
            })
            .collect();
        let (mut even, mut odd) = (vec![0.0; out.width], vec![0.0; out.width]);
        for (a, wa) in rules[0].iter() {
            let a = part.at(0, a);
            even.fill(0.0);
            odd.fill(0.0);
            for ((b, wb), table) in rules[1].iter().zip(&tables) {
                let [plus, minus] = self.values(a, part.at(1, b));
                add_scaled(&mut even, wb * (plus + minus), table);
                if plus != minus {
                    add_scaled(&mut odd, wb * (plus - minus), table);
                }
            }
            polynomials(2.0 * a - 1.0, &mut row_a);
            let weight = strength * wa * part.size[0] * part.size[1];
            for (r, value) in row_a.iter().enumerate() {
                let place = r * out.width..(r + 1) * out.width;
                add_scaled(&mut out.even[place.clone()], weight * value, &even);
                add_scaled(&mut out.odd[place], weight * value, &odd);
            }
        }
    }

    /// τν/r⁴ for both signs of ζ.
    fn values(&self, a: f64, b: f64) -> [f64; 2] {
        let heights = [a, a, a * b][self.which];
        let value = |sign: usize| {
            let r2 = (self.fixed[sign] + self.along[sign][0] * a + self.along[sign][1] * b).length_squared();
            heights / (r2 * r2)
        };
        let plus = value(0);
        [plus, if self.signs == 1 { plus } else { value(1) }]
    }
}

fn add_scaled(out: &mut [f64], factor: f64, row: &[f64]) {
    out.iter_mut().zip(row).for_each(|(o, r)| *o += factor * r);
}
