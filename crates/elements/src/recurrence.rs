//! Orthonormal polynomials in two variables, evaluated by a recurrence.
//!
//! The functions come in levels (by total degree, or by the larger of two degrees) such that the product of a
//! function of level m and one of level n lies in the levels up to m + n. With f_c = φ_q φ_p a choice of
//! products from levels m and d − m, where coordinates replace the functions of level 1,
//!
//! ```text
//! φ_k = Σ_c W_ck f_c − Σ_{l < level d} H_lk φ_l ,    level(k) = d .
//! ```
//!
//! The projections of the f_c orthogonal to the levels below d span level d; in an orthonormal basis of it
//! f = A φ + …, with more rows than columns. Any left inverse of A gives a recurrence; W is the least one,
//! (AᵀA)⁻¹Aᵀ, which amplifies the rounding of the f_c least. The number of digits at high degree depends on
//! the choice of products. Measured loss of orthonormality at N = 20:
//!
//! | products | triangle | square with holes | L, arms 1/10 wide |
//! | --- | --- | --- | --- |
//! | d + 1 of x φ_p, fixed | 5e-5 | 6e-6 | 9e-5 |
//! | d + 1 of x φ_p, the farthest | 6e-12 | 3e-11 | 4e-8 |
//! | all x φ_p (m = 1) | 1e-13 | 9e-14 | 3e-8 |
//! | m = 1, 2, 3 | 3e-14 | 2e-14 | 2e-14 |
//!
//! Products of Legendre polynomials times a triangular matrix lose all digits there. The sum over l could end
//! at level d − 2m, below which H is rounding only; keeping that rounding keeps a digit.
//!
//! References: Y. Nakatsukasa and L. N. Trefethen, "Vandermonde with Arnoldi", SIAM Review 63 (2021), for one
//! variable; C. F. Dunkl and Y. Xu, *Orthogonal Polynomials of Several Variables* (2014), §3.2, for left
//! inverses.

use std::ops::Range;

use nalgebra::DMatrix;
use radiosity_core::norm;

use super::columns::{add_scaled, take_out};

/// A product of which those chosen before it leave no more adds no dimension. Functions and products are of
/// order 1.
const DEPENDENT: f64 = 1e-14;

/// The levels of a space of polynomials.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Levels {
    /// Functions of each level; level 0 is the constant alone.
    pub functions: Vec<Range<usize>>,
    /// Degrees in a and b of the monomials that stand for level 1.
    pub first: Vec<[i32; 2]>,
}

/// The factor of a product.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Multiplier {
    /// a^i b^j.
    Monomial([i32; 2]),
    /// φ_q.
    Function(usize),
}

/// A product of two functions, the lower one given as such or as a monomial.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Product {
    multiplier: Multiplier,
    /// Index of the other function.
    source: usize,
}

/// A point with its weight in an inner product.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WeightedPoint {
    /// (a, b).
    pub coordinates: [f64; 2],
    /// Positive.
    pub weight: f64,
}

/// Step of the recurrence from the functions before a level to those of the level.
#[derive(Clone, Debug, PartialEq)]
struct Step {
    functions: Range<usize>,
    products: Vec<Product>,
    /// For each product, then for each function before the level: W_c or −H_l, one entry per new function.
    columns: Vec<f64>,
}

/// Orthonormal polynomials φ_0, φ_1, … ; φ_0 is constant.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Recurrence {
    constant: f64,
    steps: Vec<Step>,
}

impl Recurrence {
    /// The functions that are orthonormal on `points`, by products of levels m and d − m for 1 ≤ m ≤ `depth`.
    /// None where the points cannot distinguish the polynomials.
    pub(crate) fn new(points: &[WeightedPoint], levels: &Levels, depth: usize) -> Option<Self> {
        let roots: Vec<f64> = points.iter().map(|point| point.weight.sqrt()).collect();
        let constant = 1.0 / norm(&roots);
        let first = roots.iter().map(|root| root * constant).collect();
        let mut builder = Builder { points, roots, columns: vec![first] };
        let steps =
            (1..levels.functions.len()).map(|d| builder.step(levels, d, depth)).collect::<Option<_>>()?;
        constant.is_finite().then_some(Self { constant, steps })
    }

    /// φ_k(a, b) into `out`, as many as there are functions.
    pub(crate) fn values(&self, coordinates: [f64; 2], out: &mut [f64]) {
        out[0] = self.constant;
        for step in &self.steps {
            let (before, rest) = out.split_at_mut(step.functions.start);
            let level = &mut rest[..step.functions.len()];
            level.fill(0.0);
            let products = step.products.iter().map(|Product { multiplier, source }| {
                before[*source]
                    * match multiplier {
                        Multiplier::Monomial(degrees) => monomial(coordinates, *degrees),
                        Multiplier::Function(index) => before[*index],
                    }
            });
            let terms = products.chain(before.iter().copied());
            for (term, column) in terms.zip(step.columns.chunks_exact(level.len())) {
                add_scaled(level, term, column);
            }
        }
    }
}

fn monomial([a, b]: [f64; 2], [i, j]: [i32; 2]) -> f64 {
    match [i, j] {
        [1, 0] => a,
        [0, 1] => b,
        _ => a.powi(i) * b.powi(j),
    }
}

/// A recurrence under construction.
struct Builder<'a> {
    points: &'a [WeightedPoint],
    /// √w_a.
    roots: Vec<f64>,
    /// √w_a φ_k(x_a), a column per function, as the recurrence evaluates it.
    columns: Vec<Vec<f64>>,
}

impl Builder<'_> {
    fn step(&mut self, levels: &Levels, degree: usize, depth: usize) -> Option<Step> {
        let products = products(levels, degree, depth);
        let values: Vec<Vec<f64>> = products.iter().map(|product| self.product(product)).collect();
        let (rests, overlaps) = self.projected_out(&values);
        let functions = levels.functions[degree].clone();
        let mut rows = least_weights(&rests, functions.len())?;
        for row in &mut rows {
            let below = (0..self.columns.len()).map(|l| {
                -row.iter().zip(&overlaps).map(|(weight, overlap)| weight * overlap[l]).sum::<f64>()
            });
            *row = row.iter().copied().chain(below).collect();
        }
        self.correct(&values, &mut rows);
        let level: Vec<Vec<f64>> = rows.iter().map(|row| self.evaluated(&values, row)).collect();
        self.columns.extend(level);
        let columns = (0..rows[0].len()).flat_map(|term| rows.iter().map(move |row| row[term])).collect();
        Some(Step { functions, products, columns })
    }

    fn product(&self, product: &Product) -> Vec<f64> {
        let values = self.columns[product.source].iter();
        match product.multiplier {
            Multiplier::Monomial(degrees) => {
                let points = values.zip(self.points);
                points.map(|(value, point)| value * monomial(point.coordinates, degrees)).collect()
            }
            Multiplier::Function(index) => {
                let factors = self.columns[index].iter().zip(&self.roots);
                values.zip(factors).map(|(value, (factor, root))| value * factor / root).collect()
            }
        }
    }

    /// The components of `values` orthogonal to all functions so far, and their inner products with those.
    fn projected_out(&self, values: &[Vec<f64>]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let project = |value: &Vec<f64>| {
            let mut rest = value.clone();
            let overlaps = self.columns.iter().map(|column| take_out(&mut rest, column)).collect();
            (rest, overlaps)
        };
        values.iter().map(project).unzip()
    }

    /// The function that `row` makes of `products` and the functions so far, at the points.
    fn evaluated(&self, products: &[Vec<f64>], row: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.points.len()];
        for (factor, column) in row.iter().zip(products.iter().chain(&self.columns)) {
            add_scaled(&mut out, *factor, column);
        }
        out
    }

    /// Orthonormalises the functions once more, as they are evaluated.
    fn correct(&self, products: &[Vec<f64>], rows: &mut [Vec<f64>]) {
        let mut done: Vec<Vec<f64>> = Vec::new();
        for k in 0..rows.len() {
            let mut column = self.evaluated(products, &rows[k]);
            let (earlier, row) = rows.split_at_mut(k);
            let row = &mut row[0];
            for (other, entry) in self.columns.iter().zip(&mut row[products.len()..]) {
                *entry -= take_out(&mut column, other);
            }
            for (other, theirs) in done.iter().zip(earlier) {
                let overlap = take_out(&mut column, other);
                add_scaled(row, -overlap, theirs);
            }
            let scale = 1.0 / norm(&column);
            column.iter_mut().for_each(|x| *x *= scale);
            row.iter_mut().for_each(|x| *x *= scale);
            done.push(column);
        }
    }
}

/// The products that reach level `degree`.
fn products(levels: &Levels, degree: usize, depth: usize) -> Vec<Product> {
    let coordinates = levels.first.iter().map(|degrees| Multiplier::Monomial(*degrees)).collect();
    let multipliers = |level: usize| -> Vec<Multiplier> {
        levels.functions[level].clone().map(Multiplier::Function).collect()
    };
    let mut products = pairs(coordinates, &levels.functions[degree - 1]);
    for level in 2..=depth.min(degree / 2) {
        products.extend(pairs(multipliers(level), &levels.functions[degree - level]));
    }
    products
}

fn pairs(multipliers: Vec<Multiplier>, sources: &Range<usize>) -> Vec<Product> {
    let with_each =
        |multiplier: Multiplier| sources.clone().map(move |source| Product { multiplier, source });
    multipliers.into_iter().flat_map(with_each).collect()
}

/// W: for each of `count` functions the weights of the products, of which `rests` is what the levels below
/// leave. None if these span fewer dimensions.
fn least_weights(rests: &[Vec<f64>], count: usize) -> Option<Vec<Vec<f64>>> {
    let columns = DMatrix::from_vec(rests.first()?.len(), rests.len(), rests.concat());
    // Pivots are sought in the triangle: it has far fewer rows than there are points.
    let chosen = columns.qr().unpack_r().col_piv_qr();
    let triangle = chosen.r();
    if triangle.nrows() < count || (0..count).any(|k| triangle[(k, k)] <= DEPENDENT) {
        return None;
    }
    // A, in the orthonormal basis of the columns that were chosen. With A = Q R its least left inverse is R⁻¹
    // Qᵀ.
    let mut matrix = triangle.rows(0, count).transpose();
    chosen.p().inv_permute_rows(&mut matrix);
    let qr = matrix.qr();
    let weights = qr.r().solve_upper_triangular(&qr.q().transpose())?;
    let rows = weights.row_iter().map(|row| row.iter().copied().collect());
    weights.iter().all(|weight| weight.is_finite()).then(|| rows.collect())
}

#[cfg(test)]
mod tests {
    use radiosity_core::dot;

    use super::*;

    /// Three orthonormal columns of five entries times a 3 × n matrix C, given by its columns.
    fn spanned(c: &[[f64; 3]]) -> Vec<Vec<f64>> {
        let unit = [[0.6, 0.0, 0.8, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.6, -0.8]];
        let entry = |c: &[f64; 3], k: usize| (0..3).map(|l| c[l] * unit[l][k]).sum();
        c.iter().map(|c| (0..5).map(|k| entry(c, k)).collect()).collect()
    }

    /// W makes orthonormal functions of the columns, and is least: it vanishes on what makes nothing of them.
    #[test]
    fn least_weights_make_orthonormal_functions() {
        let c = [[1.0, 0.0, 0.0], [1.0, 1e-3, 0.0], [2.0, 1e-3, 0.0], [0.3, 2e-4, 1e-4], [0.0, 0.0, 0.0]];
        let vanishing = [[1.0, 1.0, -1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0]];
        let weights = least_weights(&spanned(&c), 3).expect("three dimensions");
        let coefficients: Vec<Vec<f64>> = weights
            .iter()
            .map(|row| (0..3).map(|l| row.iter().zip(&c).map(|(w, c)| w * c[l]).sum()).collect())
            .collect();
        for (k, own) in coefficients.iter().enumerate() {
            for (l, other) in coefficients.iter().enumerate() {
                let defect = dot(own, other) - f64::from(u8::from(k == l));
                // Rounding times the condition number of C, about 3e4.
                assert!(defect.abs() < 2e-11, "{k} {l}: {defect:e}");
            }
        }
        for row in &weights {
            assert_eq!(row.len(), c.len());
            vanishing.iter().for_each(|null| assert!(dot(row, null).abs() < 1e-14 * norm(row), "{row:?}"));
        }
        let one = least_weights(&[vec![-0.5]], 1).expect("one dimension");
        assert!((one[0][0].abs() - 2.0).abs() < 1e-15);
    }

    #[test]
    fn too_few_dimensions_are_refused() {
        let plane = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.5, 0.25, 0.0], [0.0, 1.0, 0.0]];
        assert!(least_weights(&spanned(&plane), 2).is_some());
        assert!(least_weights(&spanned(&plane), 3).is_none(), "a third to rounding only");
        assert!(least_weights(&spanned(&[[0.0; 3]; 4]), 1).is_none(), "nothing");
        assert!(least_weights(&spanned(&plane[..1]), 2).is_none(), "one column");
        assert!(least_weights(&[vec![1.0], vec![2.0]], 2).is_none(), "one point");
        assert!(least_weights(&spanned(&[[f64::NAN; 3], [1.0; 3]]), 1).is_none(), "not a number");
        assert!(least_weights(&[], 1).is_none());
    }
}
