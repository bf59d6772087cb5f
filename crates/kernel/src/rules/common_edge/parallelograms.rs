//! Two parallelograms with a common edge: the kernel's moments over the angular variables.
//!
//! In the coordinates of [`crate::rules::common_edge`] a point lies at t p from the edge e on the receiver,
//! at v q on the emitter, and κ is homogeneous of degree −2. With (t, v, z) = x (τ, ν, ζ)
//!
//! ```text
//! x² κ = (n_p·q)(n_q·p) τ ν / π|ν q − τ p ± ζ e|⁴ ,    (τ, ν, ζ) = (1, a, b), (a, 1, b), (a, b, 1)
//! κ_rc = ∫₀¹∫₀¹ x²κ p_r(2a − 1) p_c(2b − 1) da db
//! ```
//!
//! Where one side is much deeper, the edge short or the angle small, the kernel has a peak in the square of
//! (a, b). The square is halved as long as that saves points; each part has its own numbers of points
//! ([`crate::rules::orders::subdivided_cube`]).

use core::f64::consts::FRAC_1_PI;

use radiosity_elements::columns::add_scaled;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

use crate::moments::legendre_values::polynomials;
use crate::rules::orders::subdivided_cube::{Multilinear, Part, RuledPart};
use crate::tolerances::{MOST_HALVINGS_OF_SQUARE, ROUNDING_OF_DIRECTIONS};

#[derive(Clone, Copy, Debug)]
pub(crate) struct ParallelogramPair {
    edge: DVec3,
    depths: [DVec3; 2],
    /// (n_p·q)(n_q·p)/π times both area elements.
    strength: f64,
    /// Whether both depths are perpendicular to the edge: both signs of ζ then give the same values.
    upright: bool,
}

/// κ_rc of one subdomain, r-major, combined over the two signs of ζ.
#[derive(Clone, Debug)]
pub(crate) struct Angular {
    /// κ⁺_rc + κ⁻_rc, r-major.
    pub even: Vec<f64>,
    /// κ⁺_rc − κ⁻_rc, r-major.
    pub odd: Vec<f64>,
    /// Number of columns c.
    pub width: usize,
}

/// Subdomain, of three: r = fixed + a · along[0] + b · along[1], for either sign of ζ.
struct Subdomain {
    fixed: [DVec3; 2],
    along: [[DVec3; 2]; 2],
    /// Highest r and highest c.
    degrees: [usize; 2],
    /// Degree of the polynomials, for the number of points.
    degree: usize,
    eps: f64,
    /// Index of the subdomain, from 0.
    which: usize,
    /// Number of signs of ζ to sum: 1 or 2.
    signs: usize,
}

impl ParallelogramPair {
    /// For two parallelograms oriented with the common edge at t = 0, each in front of the other.
    pub(crate) fn new(p: &Patch, q: &Patch) -> Self {
        let (origin, far) = (p.node(0.0, 0.0), q.node(0.0, 1.0));
        let edge = p.node(1.0, 0.0).position - origin.position;
        let depths = [p.node(0.0, 1.0).position - origin.position, far.position - q.node(0.0, 0.0).position];
        let strength = origin.normal.dot(depths[1]) * far.normal.dot(depths[0]);
        let upright =
            depths.iter().all(|d| edge.dot(*d).abs() <= ROUNDING_OF_DIRECTIONS * edge.length() * d.length());
        Self { edge, depths, strength: FRAC_1_PI * strength * origin.area * far.area, upright }
    }

    /// κ_rc of the three subdomains for polynomials of the given degrees [receiver, emitter], and the number
    /// of kernel values. None where the kernel is too nearly singular.
    pub(crate) fn moments(&self, degrees: [usize; 2], eps: f64) -> Option<([Angular; 3], u64)> {
        let mut samples = 0;
        let along_edge = degrees[0] + degrees[1] + 1;
        let regions = [[degrees[1], along_edge], [degrees[0], along_edge], degrees];
        let mut all = regions.map(Angular::new);
        for (which, angular) in all.iter_mut().enumerate() {
            let subdomain = self.subdomain(which, regions[which], degrees[0].max(degrees[1]), eps);
            for sign in 0..subdomain.signs {
                samples += subdomain.add(sign, self.strength, angular)?;
            }
        }
        Some((all, samples))
    }

    fn subdomain(&self, which: usize, degrees: [usize; 2], degree: usize, eps: f64) -> Subdomain {
        let [p, q] = [-self.depths[0], self.depths[1]];
        let signs = [self.edge, -self.edge];
        let (fixed, along) = match which {
            0 => ([p; 2], signs.map(|e| [q, e])),
            1 => ([q; 2], signs.map(|e| [p, e])),
            _ => (signs, [[p, q]; 2]),
        };
        Subdomain { fixed, along, degrees, degree, eps, which, signs: if self.upright { 1 } else { 2 } }
    }
}

impl Angular {
    fn new(degrees: [usize; 2]) -> Self {
        let width = degrees[1] + 1;
        let zeros = vec![0.0; (degrees[0] + 1) * width];
        Self { even: zeros.clone(), odd: zeros, width }
    }
}

impl Subdomain {
    /// Adds the moments for one sign of ζ; returns the number of kernel values.
    fn add(&self, sign: usize, strength: f64, out: &mut Angular) -> Option<u64> {
        let difference = |[a, b]: [f64; 2]| self.difference(sign, a, b);
        let (degree, eps) = (self.degree, self.eps);
        let square = Multilinear { difference: &difference, degree, eps, deepest: MOST_HALVINGS_OF_SQUARE };
        let mut samples = 0;
        for RuledPart { part, points } in square.parts()? {
            check_interrupt();
            self.integrate(sign, strength, &part, points, out);
            samples += (points[0] * points[1]) as u64;
        }
        Some(samples)
    }

    /// y − x at x = 1.
    fn difference(&self, sign: usize, a: f64, b: f64) -> DVec3 {
        self.fixed[sign] + self.along[sign][0] * a + self.along[sign][1] * b
    }

    fn integrate(&self, sign: usize, strength: f64, part: &Part<2>, points: [usize; 2], out: &mut Angular) {
        let rules = points.map(UnitRule::of);
        let (mut row_a, mut row_b) = (vec![0.0; self.degrees[0] + 1], vec![0.0; out.width]);
        let mut tables = Vec::with_capacity(points[1] * out.width);
        for b in &rules[1].nodes {
            polynomials(2.0 * part.at(1, *b) - 1.0, &mut row_b);
            tables.extend_from_slice(&row_b);
        }
        for (a, wa) in rules[0].iter() {
            let a = part.at(0, a);
            row_b.fill(0.0);
            for ((b, wb), table) in rules[1].iter().zip(tables.chunks_exact(out.width)) {
                add_scaled(&mut row_b, wb * self.value(sign, a, part.at(1, b)), table);
            }
            polynomials(2.0 * a - 1.0, &mut row_a);
            let weight = strength * wa * part.size[0] * part.size[1];
            // If one sign serves for both, it counts twice in the sum and cancels in the difference.
            let (even, odd) = if self.signs == 1 { (2.0, 0.0) } else { (1.0, [1.0, -1.0][sign]) };
            for (r, value) in row_a.iter().enumerate() {
                let place = r * out.width..(r + 1) * out.width;
                add_scaled(&mut out.even[place.clone()], even * weight * value, &row_b);
                add_scaled(&mut out.odd[place], odd * weight * value, &row_b);
            }
        }
    }

    /// τν/r⁴.
    fn value(&self, sign: usize, a: f64, b: f64) -> f64 {
        let heights = [a, a, a * b][self.which];
        let r2 = self.difference(sign, a, b).length_squared();
        heights / (r2 * r2)
    }
}
