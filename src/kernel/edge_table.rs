//! The polynomial part of the common-edge rule on two parallelograms, tabulated once.
//!
//! In the coordinates of [`super::edge`] the kernel of two parallelograms is K(a, b)/x², free of y. Expand both
//! sides in their own polynomials T_m(s, t) = p_i(2s − 1) p_α(2t − 1). For each of the three regions and the
//! first sign of u − s, with (t, v, z) = x (τ, ν, ζ),
//!
//! ```text
//! D_q[m, n] = ∫₀¹∫₀¹ T_m(s, t) T_n(u, v) (1 − z) dy dx ,   M_mn = Σ_q w_q (K_q⁺ ± K_q⁻) D_q[m, n]
//! ```
//!
//! depends on the degrees and the angular rule only. Reflecting the edge, s → 1 − s and u → 1 − u, exchanges
//! the two signs of u − s and multiplies D by (−1)^{i+j}, which is the ± above: the table holds one sign. So a
//! pair costs 6n² kernel values and one product with the table, whatever the degree. The table itself is
//! factorised: over y first (shared by all points of one ζ), then over x.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex};

use radiosity_core::{basis::total, legendre};

use crate::elements::patch::Patch;
use crate::elements::rule::UnitRule;

use super::integrand::kernel;

/// The table for one pair of degrees and one angular rule.
#[derive(Debug)]
pub(super) struct EdgeTable {
    points: Vec<AngularPoint>,
    /// Number of polynomials on either side.
    counts: [usize; 2],
    /// D, a row of `counts[0] · counts[1]` per angular point, receiver's index first.
    values: Vec<f64>,
    /// (−1)^{i+j} of each entry of a row.
    parity: Vec<f64>,
}

/// One point of the angular rule in one of the three regions.
#[derive(Clone, Copy, Debug)]
struct AngularPoint {
    tau: f64,
    nu: f64,
    zeta: f64,
    weight: f64,
}

impl EdgeTable {
    /// The table for `degrees` [receiver, emitter] and `angular` points a direction; computed on first use.
    pub(super) fn of(degrees: [usize; 2], angular: usize) -> Arc<Self> {
        type Tables = Mutex<HashMap<([usize; 2], usize), Arc<EdgeTable>>>;
        static TABLES: LazyLock<Tables> = LazyLock::new(Tables::default);
        let find = || TABLES.lock().expect("no holder panics").get(&(degrees, angular)).cloned();
        // Computed outside the lock: two threads may do the same work, with the same result.
        find().unwrap_or_else(|| {
            let table = Arc::new(Self::compute(degrees, angular));
            TABLES.lock().expect("no holder panics").entry((degrees, angular)).or_insert(table).clone()
        })
    }

    /// Moments M in the patches' own polynomials, receiver's index first; both patches are parallelograms with
    /// the common edge at t = 0.
    pub(super) fn moments(&self, p: &Patch, q: &Patch) -> Vec<f64> {
        let length = self.counts[0] * self.counts[1];
        let (mut even, mut odd) = (vec![0.0; length], vec![0.0; length]);
        let areas = p.node(0.5, 0.5).area * q.node(0.5, 0.5).area;
        for (point, row) in self.points.iter().zip(self.values.chunks_exact(length)) {
            let near = p.node(0.0, point.tau);
            let sides = [1.0, -1.0].map(|sign| kernel(&near, &q.node(sign * point.zeta, point.nu)));
            let weight = areas * point.weight;
            add_scaled(&mut even, weight * (sides[0] + sides[1]), row);
            // Edges at right angles to both depths see no difference between the two signs.
            if (sides[0] - sides[1]).abs() > 1e-15 * (sides[0] + sides[1]) {
                add_scaled(&mut odd, weight * (sides[0] - sides[1]), row);
            }
        }
        even.iter_mut().zip(&odd).zip(&self.parity).for_each(|((e, o), sign)| {
            if *sign < 0.0 {
                *e = *o;
            }
        });
        even
    }

    /// Kernel values that one pair takes.
    pub(super) fn samples(&self) -> u64 {
        2 * self.points.len() as u64
    }

    fn compute(degrees: [usize; 2], angular: usize) -> Self {
        let points = angular_points(angular);
        let counts = degrees.map(total::count);
        let exact = (degrees[0] + degrees[1] + 3) / 2;
        let rule = UnitRule::of(exact);
        let length = counts[0] * counts[1];
        let mut values = vec![0.0; points.len() * length];
        let mut along = Along::new(degrees, rule);
        for (point, row) in points.iter().zip(values.chunks_exact_mut(length)) {
            let tables = along.at(point.zeta);
            for ((x, wx), table) in rule.iter().zip(tables) {
                let receiver = powers(degrees[0], x * point.tau);
                let emitter = powers(degrees[1], x * point.nu);
                accumulate(row, degrees, wx, &receiver, &emitter, table);
            }
        }
        Self { points, counts, values, parity: parity(degrees) }
    }
}

/// Σ_y w_y (1 − z) p_i(2s − 1) p_j(2u − 1) for z = xζ at every node x, kept for each ζ met.
struct Along<'a> {
    degrees: [usize; 2],
    rule: &'a UnitRule,
    known: Vec<(f64, Vec<Vec<f64>>)>,
}

impl<'a> Along<'a> {
    fn new(degrees: [usize; 2], rule: &'a UnitRule) -> Self {
        Self { degrees, rule, known: Vec::new() }
    }

    /// One table per node x, row-major in (i, j).
    fn at(&mut self, zeta: f64) -> &[Vec<f64>] {
        let place = self.known.iter().position(|(known, _)| *known == zeta).unwrap_or_else(|| {
            let tables = self.rule.nodes.iter().map(|x| self.table(x * zeta)).collect();
            self.known.push((zeta, tables));
            self.known.len() - 1
        });
        &self.known[place].1
    }

    fn table(&self, z: f64) -> Vec<f64> {
        let columns = self.degrees[1] + 1;
        let mut table = vec![0.0; (self.degrees[0] + 1) * columns];
        for (y, wy) in self.rule.iter() {
            let base = (1.0 - z) * y;
            let (s, u) = (powers(self.degrees[0], base), powers(self.degrees[1], base + z));
            for (row, s) in table.chunks_exact_mut(columns).zip(&s) {
                add_scaled(row, wy * (1.0 - z) * s, &u);
            }
        }
        table
    }
}

fn angular_points(angular: usize) -> Vec<AngularPoint> {
    let rule = UnitRule::of(angular);
    let mut points = Vec::with_capacity(3 * angular * angular);
    for (b, wb) in rule.iter() {
        for (a, wa) in rule.iter() {
            for (tau, nu, zeta) in [(1.0, a, b), (a, 1.0, b), (a, b, 1.0)] {
                points.push(AngularPoint { tau, nu, zeta, weight: wa * wb });
            }
        }
    }
    points
}

/// p_n(2x − 1), n = 0..=degree, for x ∈ [0, 1].
fn powers(degree: usize, x: f64) -> Vec<f64> {
    let mut values = vec![0.0; degree + 1];
    legendre::orthonormal(2.0 * x - 1.0, &mut values);
    values
}

/// Adds w p_α(t) p_β(v) Y[i, j] to row entries [(i, α), (j, β)].
fn accumulate(
    row: &mut [f64],
    degrees: [usize; 2],
    weight: f64,
    receiver: &[f64],
    emitter: &[f64],
    table: &[f64],
) {
    let columns = degrees[1] + 1;
    let mut places = row.iter_mut();
    for (i, alpha) in pairs(degrees[0]) {
        let left = weight * receiver[alpha];
        let line = &table[i * columns..(i + 1) * columns];
        for ((j, beta), place) in pairs(degrees[1]).zip(&mut places) {
            *place += left * line[j] * emitter[beta];
        }
    }
}

fn parity(degrees: [usize; 2]) -> Vec<f64> {
    let sign = |(i, j): (usize, usize)| if (i + j).is_multiple_of(2) { 1.0 } else { -1.0 };
    pairs(degrees[0]).flat_map(|(i, _)| pairs(degrees[1]).map(move |(j, _)| sign((i, j)))).collect()
}

/// Degrees (along, across) of the polynomials of total degree ≤ `degree`, in their order.
fn pairs(degree: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=degree).flat_map(|d| (0..=d).map(move |j| (d - j, j)))
}

fn add_scaled(out: &mut [f64], factor: f64, row: &[f64]) {
    out.iter_mut().zip(row).for_each(|(o, r)| *o += factor * r);
}
