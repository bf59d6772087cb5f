//! Two triangles with a common edge: the kernel's homogeneity used as for parallelograms, on other
//! subdomains.
//!
//! With the edge e from the origin and the third corners p and q, the points are x = σ e + τ p and y = σ′
//! e + ν q, where σ, τ ≥ 0, σ + τ ≤ 1 and likewise σ′, ν ≥ 0, σ′ + ν ≤ 1. With z = σ′ − σ the kernel depends
//! on (τ, ν, z) alone and is homogeneous of degree −2 ([`crate::rules::common_edge::parallelograms`]). For
//! given (τ, ν, z) the length of the interval of σ is
//!
//! ```text
//! 1 − max(τ, ν + z)  (z ≥ 0) ,     1 − max(τ + |z|, ν)  (z < 0) .
//! ```
//!
//! Scaled by x so that the maximum is x, each sign of z has two subdomains,
//!
//! ```text
//! z ≥ 0 :  (τ, ν, z) = x (1, a(1 − b), ab) ,  dV = x² a dx da db      z < 0 :  the same with τ and ν exchanged.
//!          (τ, ν, z) = x (a, 1 − b, b) ,      dV = x² dx da db
//! ```
//!
//! The sums over x ∈ [0, 1] and over the interval, of length 1 − x, are exact. The difference y − x is linear
//! in a and in b, so that the zeros of r² give the numbers of points ([`crate::rules::orders::analyticity`]).
//! The square of (a, b) is halved as long as that saves points.

use core::f64::consts::FRAC_1_PI;

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

use crate::moments::Moments;
use crate::rules::common_edge::sum::EdgeSum;
use crate::rules::far;
use crate::rules::orders::subdivided_cube::{Multilinear, Part, RuledPart};
use crate::tolerances::{MOST_HALVINGS_OF_SQUARE, SHARE_OF_TRIANGLES};

/// Two triangles, each the half s + t ≤ 1 of a parallelogram with the common edge at t = 0.
struct TrianglePair {
    edge: DVec3,
    corners: [DVec3; 2],
    /// (n_p·q)(n_q·p)/π times both area elements.
    strength: f64,
}

/// Subdomain, of four.
#[derive(Clone, Copy)]
struct Subdomain {
    /// z < 0: receiver and emitter exchange places.
    mirrored: bool,
    /// The first subdomain of its sign, (1, a(1 − b), ab), whose side a = 0 is one point.
    collapsed: bool,
}

impl Subdomain {
    const ALL: [Self; 4] = [
        Self { mirrored: false, collapsed: true },
        Self { mirrored: false, collapsed: false },
        Self { mirrored: true, collapsed: true },
        Self { mirrored: true, collapsed: false },
    ];

    /// (τ, ν, |z|) at x = 1.
    fn place(self, a: f64, b: f64) -> [f64; 3] {
        let [first, second, z] = if self.collapsed { [1.0, a * (1.0 - b), a * b] } else { [a, 1.0 - b, b] };
        if self.mirrored { [second, first, z] } else { [first, second, z] }
    }

    /// dV / x² dx da db.
    fn jacobian(self, a: f64) -> f64 {
        if self.collapsed { a } else { 1.0 }
    }
}

impl TrianglePair {
    fn new(p: &Patch, q: &Patch) -> Self {
        let origin = p.node(0.0, 0.0);
        let far = q.node(0.0, 0.0);
        let edge = p.node(1.0, 0.0).position - origin.position;
        let corners = [p, q].map(|patch| patch.node(0.0, 1.0).position - origin.position);
        let strength = origin.normal.dot(corners[1]) * far.normal.dot(corners[0]);
        Self { edge, corners, strength: FRAC_1_PI * strength * origin.area * far.area }
    }

    /// y − x at x = 1.
    fn difference(&self, subdomain: Subdomain, a: f64, b: f64) -> DVec3 {
        let [tau, nu, z] = subdomain.place(a, b);
        let z = if subdomain.mirrored { -z } else { z };
        self.corners[1] * nu - self.corners[0] * tau + self.edge * z
    }

    /// x²κ.
    fn kernel(&self, subdomain: Subdomain, a: f64, b: f64) -> f64 {
        let [tau, nu, _] = subdomain.place(a, b);
        let r2 = self.difference(subdomain, a, b).length_squared();
        self.strength * tau * nu / (r2 * r2)
    }
}

/// Adds the halves s + t ≤ 1 of two parallelograms with a common edge at t = 0 that see each other wholly.
///
/// Returns false, and adds nothing, where the kernel is too nearly singular.
pub(crate) fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64) -> bool {
    let pair = TrianglePair::new(p, q);
    let parts = |subdomain: Subdomain| {
        let difference = |[a, b]: [f64; 2]| pair.difference(subdomain, a, b);
        let degree = degrees[0].max(degrees[1]);
        Multilinear {
            difference: &difference,
            degree,
            eps: SHARE_OF_TRIANGLES * eps,
            deepest: MOST_HALVINGS_OF_SQUARE,
        }
        .parts()
    };
    let Some(plans) = Subdomain::ALL.into_iter().map(parts).collect::<Option<Vec<_>>>() else { return false };
    let mut sum = EdgeSum::new(moments.patches(p, q));
    let rule = UnitRule::of(far::exact(degrees));
    for (subdomain, parts) in Subdomain::ALL.into_iter().zip(plans) {
        for RuledPart { part, points } in parts {
            add(&mut sum, &pair, subdomain, &part, points, rule);
        }
    }
    moments.add(sum.pair);
    true
}

fn add(
    sum: &mut EdgeSum,
    pair: &TrianglePair,
    subdomain: Subdomain,
    part: &Part<2>,
    points: [usize; 2],
    rule: &UnitRule,
) {
    let rules = points.map(UnitRule::of);
    let size: f64 = part.size.iter().product();
    for (a, wa) in rules[0].iter() {
        check_interrupt();
        for (b, wb) in rules[1].iter() {
            let (a, b) = (part.at(0, a), part.at(1, b));
            let value = wa * wb * size * subdomain.jacobian(a) * pair.kernel(subdomain, a, b);
            sum.pair.samples += 1;
            for (x, wx) in rule.iter() {
                let [tau, nu, z] = subdomain.place(a, b).map(|place| x * place);
                for (y, wy) in rule.iter() {
                    let base = (1.0 - x) * y;
                    let (s, u) = if subdomain.mirrored { (base + z, base) } else { (base, base + z) };
                    sum.add(s, u, value * wx * wy * (1.0 - x));
                }
                sum.close_across_emitter(nu);
                sum.close_across_receiver(tau);
            }
        }
    }
}
