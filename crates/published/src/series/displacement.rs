//! The kernel of a pair of points for any small displacement, as a power series in three variables.
//!
//! ```text
//! |r + p|⁻⁴ = Σ a_k p^k ,   k = (k₁, k₂, k₃) ,  |k| = k₁ + k₂ + k₃ ,   a_0 = r⁻⁴
//! |k| r² a_k = −(2|k| + 2) Σ_i r_i a_{k−e_i} − (|k| + 2) Σ_i a_{k−2e_i}
//! κ(p) = −(n_y·(r + p))(n_x·(r + p))/π · Σ a_k p^k
//! ```
//!
//! It holds the products of displacements along different axes, which a sum of three series along the axes
//! lacks. Range:
//! |p| < r. (N + 1)(N + 2)(N + 3)/6 coefficients to total degree N.

use core::f64::consts::FRAC_1_PI;

use radiosity_geom::DVec3;

use super::point_pair::PointPair;

/// κ as a polynomial of a displacement.
#[derive(Clone, Debug)]
pub struct DisplacementSeries {
    degree: usize,
    /// Degree by degree; within one, k₁ falling, then k₂ falling.
    coefficients: Vec<f64>,
}

impl DisplacementSeries {
    /// The series to total degree `degree`.
    pub fn new(pair: &PointPair, degree: usize) -> Self {
        let distance = inverse_fourth_power(pair.offset, degree);
        let (x, y) = (pair.receiver_normal, pair.emitter_normal);
        let (arriving, leaving) = (x.dot(pair.offset), y.dot(pair.offset));
        let linear = (x * leaving + y * arriving).to_array();
        let (x, y) = (x.to_array(), y.to_array());
        let coefficient = |k: [usize; 3]| {
            let mut sum = arriving * leaving * distance[place(k)];
            for i in 0..3 {
                let Some(less) = lowered(k, i) else { continue };
                sum += linear[i] * distance[place(less)];
                for (j, y) in y.iter().enumerate() {
                    sum += lowered(less, j).map_or(0.0, |less| x[i] * y * distance[place(less)]);
                }
            }
            -FRAC_1_PI * sum
        };
        Self { degree, coefficients: exponents(degree).map(coefficient).collect() }
    }

    /// κ with the emitter displaced by `p`, cut after the total degree of the series.
    pub fn at(&self, p: DVec3) -> f64 {
        let power = |[i, j, k]: [usize; 3]| p.x.powi(i as i32) * p.y.powi(j as i32) * p.z.powi(k as i32);
        exponents(self.degree).zip(&self.coefficients).map(|(k, c)| c * power(k)).sum()
    }
}

/// a_k to total degree `degree`.
fn inverse_fourth_power(r: DVec3, degree: usize) -> Vec<f64> {
    let (r2, r) = (r.length_squared(), r.to_array());
    let mut a: Vec<f64> = Vec::with_capacity(place([0, 0, degree]) + 1);
    for k in exponents(degree) {
        let total = k.iter().sum::<usize>() as f64;
        if total == 0.0 {
            a.push(1.0 / (r2 * r2));
            continue;
        }
        let (mut first, mut second) = (0.0, 0.0);
        for (i, r) in r.iter().enumerate() {
            let Some(less) = lowered(k, i) else { continue };
            first += r * a[place(less)];
            second += lowered(less, i).map_or(0.0, |less| a[place(less)]);
        }
        a.push(-((2.0 * total + 2.0) * first + (total + 2.0) * second) / (total * r2));
    }
    a
}

/// k − e_i, where k_i > 0.
fn lowered(mut k: [usize; 3], i: usize) -> Option<[usize; 3]> {
    k[i] = k[i].checked_sub(1)?;
    Some(k)
}

/// All k with |k| ≤ `degree`, in order.
fn exponents(degree: usize) -> impl Iterator<Item = [usize; 3]> {
    let level = |n: usize| (0..=n).flat_map(move |m| (0..=m).map(move |k| [n - m, m - k, k]));
    (0..=degree).flat_map(level)
}

/// The position of k in that order.
fn place([i, j, k]: [usize; 3]) -> usize {
    let (m, n) = (j + k, i + j + k);
    n * (n + 1) * (n + 2) / 6 + m * (m + 1) / 2 + k
}
