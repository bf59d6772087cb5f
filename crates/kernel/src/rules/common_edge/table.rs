//! The polynomial factors of the common-edge rule for two parallelograms: one table for each pair of degrees.
//!
//! In the coordinates of [`crate::rules::common_edge`] the kernel of two parallelograms is K(a, b)/x² and
//! does not depend on y. A pair therefore enters through its angular moments κ_rc alone
//! ([`crate::rules::common_edge::parallelograms`]). Both sides are expanded in their own polynomials
//! T_m(s, t) = p_i(2s − 1) p_α(2t − 1). In the first subdomain, t = x, v = xa, z = xb,
//!
//! ```text
//! M_mn = ∫₀¹ dx p_α(2x − 1) Σ_r B_βr(x) Σ_c C_ijc(x) κ_rc ,
//! p_β(2xa − 1) = Σ_r B_βr(x) p_r(2a − 1) ,
//! Y_ij(z) = ∫₀¹ (1 − z) p_i(2s − 1) p_j(2u − 1) dy ,   Y_ij(xb) = Σ_c C_ijc(x) p_c(2b − 1) ,
//! ```
//!
//! with n = (j, β). The second subdomain exchanges the roles of t and v; in the third, z = x, the sum over c
//! belongs to v = xb. All sums are finite: r ≤ β, c ≤ i + j + 1. Reversing the edge, s → 1 − s and u → 1 − u,
//! exchanges the signs of u − s and multiplies by (−1)^{i+j}: even i + j takes κ⁺ + κ⁻, odd i + j takes
//! κ⁺ − κ⁻. B, C and Y depend on the degrees only.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex};

use radiosity_core::{basis::total, dot};
use radiosity_elements::basis::HIGHEST_ORDER;
use radiosity_elements::rule::UnitRule;
use radiosity_work::interruption::check_interrupt;

use crate::moments::legendre_values::polynomials;
use crate::rules::common_edge::parallelograms::Angular;
use crate::rules::far;

/// B, C and Y at the nodes x for one pair of degrees.
#[derive(Debug)]
pub(crate) struct EdgeTable {
    degrees: [usize; 2],
    nodes: Vec<Radial>,
}

/// The tables at one x.
#[derive(Debug)]
struct Radial {
    weight: f64,
    /// p_n(2x − 1), n up to the larger degree.
    values: Vec<f64>,
    /// B_nr, a square matrix, n and r up to the larger degree.
    dilation: Vec<f64>,
    /// C_ijc: for each (i, j) a row of N_i + N_j + 2 places, of which i + j + 2 are used.
    along: Vec<f64>,
    /// Y_ij(x).
    along_at_x: Vec<f64>,
}

impl EdgeTable {
    /// The table for `degrees` [receiver, emitter]; computed on first use.
    pub(crate) fn of(degrees: [usize; 2]) -> Arc<Self> {
        type Tables = Mutex<HashMap<[usize; 2], Arc<EdgeTable>>>;
        static TABLES: LazyLock<Tables> = LazyLock::new(Tables::default);
        let find = || TABLES.lock().expect("no holder panics").get(&degrees).cloned();
        // Computed outside the lock: two threads may compute the same table, with the same values.
        find().unwrap_or_else(|| {
            let table = Arc::new(Self::compute(degrees));
            TABLES.lock().expect("no holder panics").entry(degrees).or_insert(table).clone()
        })
    }

    /// Number of points in x times that in y.
    pub(crate) fn points(&self) -> usize {
        self.nodes.len() * self.nodes.len()
    }

    /// Moments M in the patches' own polynomials of total degree, receiver's index first, from the angular
    /// moments.
    pub(crate) fn moments(&self, angular: &[Angular; 3]) -> Vec<f64> {
        let counts = self.degrees.map(total::count);
        let mut moments = vec![0.0; counts[0] * counts[1]];
        let widths = self.degrees.map(|degree| degree + 1);
        let mut table = vec![0.0; widths[0] * widths[1] * widths[0].max(widths[1])];
        for radial in &self.nodes {
            check_interrupt();
            self.spread(radial, &angular[0], 1, &mut table);
            self.collect(&mut moments, |(i, alpha), (j, beta)| {
                radial.weight * radial.values[alpha] * table[(i * widths[1] + j) * widths[1] + beta]
            });
            self.spread(radial, &angular[1], 0, &mut table);
            self.collect(&mut moments, |(i, alpha), (j, beta)| {
                radial.weight * radial.values[beta] * table[(i * widths[1] + j) * widths[0] + alpha]
            });
            let across = [&angular[2].even, &angular[2].odd].map(|kappa| self.sandwich(radial, kappa));
            self.collect(&mut moments, |(i, alpha), (j, beta)| {
                radial.weight
                    * radial.along_at_x[i * widths[1] + j]
                    * across[(i + j) % 2][alpha * widths[1] + beta]
            });
        }
        moments
    }

    /// `out`[i, j, n] = Σ_r B_nr Σ_c C_ijc κ_rc for n up to the degree of `side`.
    fn spread(&self, radial: &Radial, angular: &Angular, side: usize, out: &mut [f64]) {
        let (columns, width, places) = (self.degrees[1] + 1, self.degrees[side] + 1, self.places());
        let stride = radial.values.len();
        let mut row = [0.0; 2 * HIGHEST_ORDER + 1];
        for i in 0..=self.degrees[0] {
            for j in 0..columns {
                let kappa = if (i + j) % 2 == 0 { &angular.even } else { &angular.odd };
                let along = &radial.along[(i * columns + j) * places..][..i + j + 2];
                // The total degree limits i + n on the receiver, j + n on the emitter.
                let most = self.degrees[side] - [i, j][side];
                for (r, value) in row[..=most].iter_mut().enumerate() {
                    *value = dot(along, &kappa[r * angular.width..][..along.len()]);
                }
                let line = &mut out[(i * columns + j) * width..][..=most];
                for (n, value) in line.iter_mut().enumerate() {
                    *value = dot(&radial.dilation[n * stride..=n * stride + n], &row[..=n]);
                }
            }
        }
    }

    /// E_αβ = Σ_rc B_αr κ_rc B_βc.
    fn sandwich(&self, radial: &Radial, kappa: &[f64]) -> Vec<f64> {
        let widths = self.degrees.map(|degree| degree + 1);
        let stride = radial.values.len();
        let mut half = vec![0.0; widths[0] * widths[1]];
        for (line, kappa) in half.chunks_exact_mut(widths[1]).zip(kappa.chunks_exact(widths[1])) {
            for (beta, value) in line.iter_mut().enumerate() {
                *value = dot(&radial.dilation[beta * stride..=beta * stride + beta], &kappa[..=beta]);
            }
        }
        let mut whole = vec![0.0; widths[0] * widths[1]];
        for (alpha, line) in whole.chunks_exact_mut(widths[1]).enumerate() {
            let factors = &radial.dilation[alpha * stride..=alpha * stride + alpha];
            for (factor, row) in factors.iter().zip(half.chunks_exact(widths[1])) {
                line.iter_mut().zip(row).for_each(|(e, h)| *e += factor * h);
            }
        }
        whole
    }

    fn collect(&self, moments: &mut [f64], value: impl Fn((usize, usize), (usize, usize)) -> f64) {
        let mut places = moments.iter_mut();
        for receiver in pairs(self.degrees[0]) {
            for (emitter, place) in pairs(self.degrees[1]).zip(&mut places) {
                *place += value(receiver, emitter);
            }
        }
    }

    /// Length of a row of C.
    fn places(&self) -> usize {
        self.degrees[0] + self.degrees[1] + 2
    }

    fn compute(degrees: [usize; 2]) -> Self {
        let rule = UnitRule::of(far::exact(degrees));
        let nodes = rule.iter().map(|(x, weight)| Radial::new(x, weight, degrees, rule)).collect();
        Self { degrees, nodes }
    }
}

impl Radial {
    fn new(x: f64, weight: f64, degrees: [usize; 2], rule: &UnitRule) -> Self {
        let size = degrees[0].max(degrees[1]) + 1;
        let dilated = |a: f64| values(x * a, size);
        let along = |b: f64| along_edge(x * b, degrees, rule);
        Self {
            weight,
            values: values(x, size),
            dilation: expanded(dilated, size, size),
            along: expanded(along, degrees[0] + degrees[1] + 2, (degrees[0] + 1) * (degrees[1] + 1)),
            along_at_x: along_edge(x, degrees, rule),
        }
    }
}

/// Coefficients of `count` functions of a ∈ [0, 1] in p_c(2a − 1), c < `places`; one row for each function.
fn expanded(functions: impl Fn(f64) -> Vec<f64>, places: usize, count: usize) -> Vec<f64> {
    let mut rows = vec![0.0; count * places];
    for (a, weight) in UnitRule::of(places).iter() {
        let polynomials = values(a, places);
        for (row, value) in rows.chunks_exact_mut(places).zip(functions(a)) {
            // Factor 2: the length of [−1, 1] over that of [0, 1].
            row.iter_mut().zip(&polynomials).for_each(|(c, p)| *c += 2.0 * weight * value * p);
        }
    }
    rows
}

/// Y_ij(z), row-major.
fn along_edge(z: f64, degrees: [usize; 2], rule: &UnitRule) -> Vec<f64> {
    let columns = degrees[1] + 1;
    let mut table = vec![0.0; (degrees[0] + 1) * columns];
    for (y, wy) in rule.iter() {
        let base = (1.0 - z) * y;
        let (s, u) = (values(base, degrees[0] + 1), values(base + z, columns));
        for (row, s) in table.chunks_exact_mut(columns).zip(&s) {
            row.iter_mut().zip(&u).for_each(|(out, u)| *out += wy * (1.0 - z) * s * u);
        }
    }
    table
}

/// p_n(2x − 1), n < `count`.
fn values(x: f64, count: usize) -> Vec<f64> {
    let mut values = vec![0.0; count];
    polynomials(2.0 * x - 1.0, &mut values);
    values
}

/// Degrees (along, across) of the polynomials of total degree ≤ `degree`, in the order of the basis.
fn pairs(degree: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=degree).flat_map(|d| (0..=d).map(move |j| (d - j, j)))
}
