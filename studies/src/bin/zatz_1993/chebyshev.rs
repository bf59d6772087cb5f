//! Section 10 wishes for a Chebyshev basis: the squares of figures 4 and 5 by polynomials that are orthonormal
//! for the weight 1/√((1 − s²)(1 − t²)), beside Legendre's.
//!
//! ```text
//! B = Σ_{p+q ≤ N} b_pq p_p(s) p_q(t) ,     b_pq = ∬ w E p_p p_q ds dt
//! ```
//!
//! E is Lambert's closed form, and the integrals are those of Gauss's rule of the weight, with
//! [`POINTS`] × [`POINTS`] points: projections without an error of the transfers. Errors are metric (30), the
//! largest of the same quotients |B − E| / E, and what the mean of B misses of that of E. Last, how far the
//! transfers between the squares are from symmetric.

use std::error::Error;
use std::f64::consts::PI;
use std::io::Write;

use radiosity_core::gauss;
use radiosity_core::jacobi::{Polynomials, Weight};

use crate::curves::{OfOrder, panel, side_by_side};
use crate::squares::{CELLS, Emitter, ORDERS, centre, centres, exact, header, row};

/// Points of the rules along each side: with twice as many no digit that is printed changes.
const POINTS: usize = 300;
/// Order and points of the transfers that are held against their transpose.
const TRANSFER: (usize, usize) = (4, 32);

/// A family of orthonormal polynomials.
struct Family {
    name: &'static str,
    weight: Weight,
    polynomials: Polynomials<ORDERS>,
}

/// A Gauss rule.
struct Rule {
    nodes: Vec<f64>,
    weights: Vec<f64>,
}

/// Errors of one order, in percent.
struct Errors {
    mean: f64,
    largest: f64,
    power: f64,
}

impl Family {
    fn new(name: &'static str, exponent: f64) -> Result<Self, Box<dyn Error>> {
        let weight = Weight::new(exponent, exponent).map_err(|why| why.to_string())?;
        Ok(Self { name, weight, polynomials: Polynomials::new(weight) })
    }

    fn rule(&self, points: usize) -> Result<Rule, Box<dyn Error>> {
        let mut rule = Rule { nodes: vec![0.0; points], weights: vec![0.0; points] };
        gauss::jacobi(self.weight, &mut rule.nodes, &mut rule.weights).map_err(|why| why.to_string())?;
        Ok(rule)
    }

    fn values(&self, x: f64) -> [f64; ORDERS] {
        let mut values = [0.0; ORDERS];
        self.polynomials.values(x, &mut values);
        values
    }

    /// Its coefficients b_pq of the irradiance by an emitter.
    fn projected(&self, emitter: Emitter) -> Result<[[f64; ORDERS]; ORDERS], Box<dyn Error>> {
        let Rule { nodes, weights } = self.rule(POINTS)?;
        let values: Vec<[f64; ORDERS]> = nodes.iter().map(|x| self.values(*x)).collect();
        let places = nodes.iter().flat_map(|s| nodes.iter().map(move |t| [*s, *t]));
        let mut coefficients = [[0.0; ORDERS]; ORDERS];
        for (k, irradiance) in exact(emitter, places).into_iter().enumerate() {
            let [i, j] = [k / POINTS, k % POINTS];
            let weighted = weights[i] * weights[j] * irradiance;
            for (row, along) in coefficients.iter_mut().zip(values[i]) {
                row.iter_mut().zip(values[j]).for_each(|(b, across)| *b += weighted * along * across);
            }
        }
        Ok(coefficients)
    }

    /// Errors of its polynomials of each order.
    fn errors(&self, emitter: Emitter, irradiance: &[f64]) -> Result<Vec<Errors>, Box<dyn Error>> {
        let coefficients = self.projected(emitter)?;
        let values: Vec<[f64; ORDERS]> = (0..CELLS).map(|k| self.values(centre(k))).collect();
        let of_order = |order: usize| {
            let light = |k: usize| {
                let [along, across] = [values[k / CELLS], values[k % CELLS]];
                let row = |p: usize| {
                    along[p] * (0..=order - p).map(|q| coefficients[p][q] * across[q]).sum::<f64>()
                };
                (0..=order).map(row).sum::<f64>()
            };
            let (mut sum, mut largest, mut arrived) = (0.0, 0.0f64, 0.0);
            for (k, exact) in irradiance.iter().enumerate() {
                let found = light(k);
                let missed = (found - exact).abs() / exact;
                (sum, largest, arrived) = (sum + missed, largest.max(missed), arrived + found);
            }
            let power = (arrived / irradiance.iter().sum::<f64>() - 1.0).abs();
            Errors {
                mean: 100.0 * sum / irradiance.len() as f64,
                largest: 100.0 * largest,
                power: 100.0 * power,
            }
        };
        Ok((0..ORDERS).map(of_order).collect())
    }

    /// Largest difference of the transfers between parallel squares at l from those back, over the largest
    /// transfer.
    fn asymmetry(&self) -> Result<f64, Box<dyn Error>> {
        let (order, points) = TRANSFER;
        let [received, sent] = [self.rule(points)?, Family::new("Legendre", 0.0)?.rule(points)?];
        let degrees: Vec<[usize; 2]> =
            (0..=order).flat_map(|p| (0..=order - p).map(move |q| [p, q])).collect();
        let functions = |rule: &Rule| -> Vec<([f64; 2], Vec<f64>)> {
            let pairs = || (0..points).flat_map(|i| (0..points).map(move |j| [i, j]));
            let at = |[i, j]: [usize; 2]| {
                let [along, across] = [i, j].map(|k| self.values(rule.nodes[k]));
                let weight = rule.weights[i] * rule.weights[j];
                let value = |[p, q]: &[usize; 2]| weight * along[*p] * across[*q];
                ([rule.nodes[i], rule.nodes[j]], degrees.iter().map(value).collect())
            };
            pairs().map(at).collect()
        };
        let [received, sent] = [functions(&received), functions(&sent)];
        let count = degrees.len();
        let mut transfers = vec![0.0; count * count];
        for (to, tests) in &received {
            let mut arriving = vec![0.0; count];
            for (from, weighted) in &sent {
                // Sides of 2 in these parameters: the distance is 2 too.
                let squared = (to[0] - from[0]).powi(2) + (to[1] - from[1]).powi(2) + 4.0;
                let kernel = 4.0 / (PI * squared * squared);
                arriving.iter_mut().zip(weighted).for_each(|(sum, value)| *sum += kernel * value);
            }
            for (row, test) in transfers.chunks_exact_mut(count).zip(tests) {
                row.iter_mut().zip(&arriving).for_each(|(sum, value)| *sum += test * value);
            }
        }
        let pairs = (0..count).flat_map(|k| (0..count).map(move |l| [k * count + l, l * count + k]));
        let [apart, size] = pairs.fold([0.0f64; 2], |[apart, size], [k, l]| {
            [apart.max((transfers[k] - transfers[l]).abs()), size.max(transfers[k].abs())]
        });
        Ok(apart / size)
    }
}

/// Prints the errors of both families, and draws them.
pub(crate) fn beside_legendre(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let families = [Family::new("Legendre", 0.0)?, Family::new("Chebyshev", -0.5)?];
    header(out, "basis of section 10, errors in %", "")?;
    let mut panels = Vec::new();
    for (name, emitter) in [
        ("parallel at l", Emitter::parallel(1.0)),
        ("parallel at 0.3 l", Emitter::parallel(0.3)),
        ("parallel at 0.1 l", Emitter::parallel(0.1)),
        ("common edge", Emitter::perpendicular()),
    ] {
        let irradiance = exact(emitter, centres());
        let mut lines = Vec::new();
        for family in &families {
            let errors = family.errors(emitter, &irradiance)?;
            let mut tell = |what: &str, value: &dyn Fn(&Errors) -> f64| {
                row(out, &format!("{name}, {}, {what}", family.name), "", |order| value(&errors[order]))
            };
            for (what, values) in [
                ("mean", tell("mean", &|errors| errors.mean)?),
                ("largest", tell("largest", &|errors| errors.largest)?),
            ] {
                lines.push(OfOrder { label: format!("{}, {what}", family.name), values });
            }
            // Legendre's projection keeps the mean.
            if family.weight != Weight::LEGENDRE {
                tell("power", &|errors| errors.power)?;
            }
        }
        panels.push(panel(name, lines));
    }
    tell_asymmetry(out, &families)?;
    let caption = "relative error of the irradiance over 500 × 500 points, mean (metric 30) and largest";
    side_by_side("docs/chebyshev.svg", "Legendre and Chebyshev polynomials", caption, panels)
}

fn tell_asymmetry(out: &mut impl Write, families: &[Family; 2]) -> Result<(), Box<dyn Error>> {
    let [legendre, chebyshev] = families;
    writeln!(
        out,
        "\nTransfers of order {} from one of two parallel squares at l to the other differ from those back by at most {:.0e} of the \
         largest with Legendre polynomials, by {:.2} with Chebyshev's.",
        TRANSFER.0,
        legendre.asymmetry()?,
        chebyshev.asymmetry()?
    )?;
    Ok(())
}
