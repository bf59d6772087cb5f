//! A value at one place, from values at others around it: a polynomial, fitted with weights.
//!
//! ```text
//! min Σ_i w_i (p(d_i) − f_i)² ,     f ≈ p(0) ,     w_i = (1 − (r_i/R)²)² ,
//! ```
//!
//! with d_i the offset in the tangent plane of the place and r_i the distance in the lattice; p has the degree 2
//! where there are enough values, else 1. The fit is linear in the values, p(0) = Σ_i c_i f_i, and Λ = Σ_i |c_i|
//! is the factor by which it amplifies errors: 1 to 1.3 where values lie around the place, more where they lie
//! on one side and p(0) is extrapolated. Values may carry errors, which the fit averages.

use radiosity_core::dot;
use smallvec::SmallVec;

/// Coefficients of a polynomial of degree 2 and of degree 1.
const QUADRATIC: usize = 6;
const LINEAR: usize = 3;

/// Values that a degree takes at the least: some more than it has coefficients.
const SPARE: usize = 1;

/// Least square of a pivot over its diagonal entry: places nearly on a curve know less. Measured in an office of 160 ×
/// 120 pixels: with 1e-3 nodes in two rows, and one in a third with a weight of a thousandth, passed for three rows;
/// beside a lamp's housing light was 29 % too dark, and pictures erred by 1.33 % (L2) where they do by 1.23.
const FLAT: f64 = 1e-2;

/// Most factor by which a fit amplifies errors of its values, where it is trusted. Chosen: 1 inside, about 1.3 at a
/// border that has values.
const AMPLIFIED: f64 = 1.6;

/// Most difference from a fit of one degree less, over the most residual of a fit, where it is trusted. Chosen: the
/// error that remains is smaller by about as much; fits of few values leave little even where light peaks between them.
const BENT: f64 = 3.0;

/// Reach R of a value in a fit, in steps of the lattice that the values stand on. Chosen.
const REACH: f64 = 2.0;

/// The weight of a value that is `apart` from the place of a fit, along both directions of a lattice (its steps).
pub(crate) fn weight(apart: [f64; 2]) -> f64 {
    let square = apart[0].powi(2) + apart[1].powi(2);
    (1.0 - square / (REACH * REACH)).max(0.0).powi(2)
}

/// Values around a place.
#[derive(Clone, Debug)]
pub(crate) struct Fit<'a> {
    values: SmallVec<[FitValue<'a>; 25]>,
}

#[derive(Clone, Copy, Debug)]
struct FitValue<'a> {
    at: [f64; 2],
    weight: f64,
    bands: &'a [f64],
    error: f64,
}

/// The result of a fit.
#[derive(Clone, Debug)]
pub(crate) struct FitResult {
    /// The value per band.
    pub value: Vec<f64>,
    /// Root mean square of what the fit leaves, the sum over the bands.
    pub residual: f64,
    /// Root mean square of the values' own errors.
    pub noise: f64,
    /// Factor Λ by which the fit amplifies errors of its values, 1 at the least.
    pub amplified: f64,
    /// Difference from polynomials of one degree less, the sum over the bands: at the place from the
    /// fit of degree 1, or the root mean square of what that of degree 0 leaves.
    pub bend: f64,
    /// Root mean square of what the fit of degree 1 leaves where the degree is 2, the sum over the bands; else 0.
    pub curve: f64,
}

impl FitResult {
    /// Light that the fit leaves, or that polynomials of one degree less differ by, beside the values' own errors, the
    /// sum over the bands; infinite where it amplifies errors.
    pub(crate) fn left(&self) -> f64 {
        if self.amplified > AMPLIFIED {
            return f64::INFINITY;
        }
        self.beside_noise(self.residual).max(self.beside_noise(self.bend) / BENT)
    }

    /// As [`FitResult::left`], of values on a few lines, which polynomials of degree 2 meet whatever light does
    /// between: what those of degree 1 leave counts too, over `most`.
    pub(crate) fn left_on_few_lines(&self, most: f64) -> f64 {
        self.left().max(self.beside_noise(self.curve) / most)
    }

    /// Part of a root mean square beside the values' own errors.
    fn beside_noise(&self, of: f64) -> f64 {
        (of * of - self.noise * self.noise).max(0.0).sqrt()
    }
}

impl<'a> Fit<'a> {
    /// A fit without values.
    pub(crate) fn new() -> Self {
        Self { values: SmallVec::new() }
    }

    /// Takes the value of all bands at the offset `at`, with a weight above 0. Their sum has the standard
    /// deviation `error`.
    pub(crate) fn take(&mut self, at: [f64; 2], weight: f64, bands: &'a [f64], error: f64) {
        self.values.push(FitValue { at, weight, bands, error });
    }

    /// `found` within the range that the values have, band by band.
    pub(crate) fn within(&self, mut found: Vec<f64>) -> Vec<f64> {
        for (band, value) in found.iter_mut().enumerate() {
            let all = || self.values.iter().map(|value| value.bands[band]);
            *value = value.min(all().fold(f64::MIN, f64::max)).max(all().fold(f64::MAX, f64::min));
        }
        found
    }

    /// The fit; None of too few values, or of values on a line.
    pub(crate) fn found(&self) -> Option<FitResult> {
        let wanted = match self.values.len() {
            count if count >= QUADRATIC + SPARE => QUADRATIC,
            count if count >= LINEAR + SPARE => LINEAR,
            _ => return None,
        };
        let rows = self.rows();
        let factor = PartialCholesky::of(self.matrix(&rows), wanted);
        let terms = if factor.terms == QUADRATIC { QUADRATIC } else { LINEAR };
        if factor.terms < terms {
            return None;
        }
        let unit = factor.forward([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let mut value = Vec::with_capacity(self.values[0].bands.len());
        let (mut residual, mut bend, mut curve) = (0.0, 0.0, 0.0);
        let (all, noise) = self.weights();
        for band in 0..self.values[0].bands.len() {
            let (side, squares) = self.side(&rows, band);
            let found = factor.forward(side);
            let of_degree = |terms: usize| dot(&unit[..terms], &found[..terms]);
            let left =
                |terms: usize| ((squares - dot(&found[..terms], &found[..terms])).max(0.0) / all).sqrt();
            value.push(of_degree(terms));
            bend += match terms {
                QUADRATIC => (of_degree(terms) - of_degree(LINEAR)).abs(),
                _ => left(1),
            };
            residual += left(terms);
            curve += if terms == QUADRATIC { left(LINEAR) } else { 0.0 };
        }
        let amplified = self.amplified(&rows, &factor.backward(&unit, terms)[..terms]);
        Some(FitResult { value, residual, noise, amplified, bend, curve })
    }

    /// Σ w, and the root mean square of the errors.
    fn weights(&self) -> (f64, f64) {
        let all: f64 = self.values.iter().map(|value| value.weight).sum();
        let squares: f64 = self.values.iter().map(|value| value.weight * value.error.powi(2)).sum();
        (all, (squares / all).sqrt())
    }

    /// Λ = Σ_i |w_i row_i · M⁻¹ e₀|, of the given M⁻¹ e₀.
    fn amplified(&self, rows: &[[f64; QUADRATIC]], inverse: &[f64]) -> f64 {
        let each = self.values.iter().zip(rows);
        each.map(|(value, row)| (value.weight * dot(&row[..inverse.len()], inverse)).abs()).sum()
    }

    /// The terms of the polynomial at each place, which are at most 1.
    fn rows(&self) -> SmallVec<[[f64; QUADRATIC]; 25]> {
        let size = self.values.iter().flat_map(|value| value.at).fold(0.0, |most: f64, x| most.max(x.abs()));
        let row = |value: &FitValue| {
            let [x, y] = value.at.map(|x| x / size);
            [1.0, x, y, x * x, x * y, y * y]
        };
        self.values.iter().map(row).collect()
    }

    /// The normal equations' matrix, its lower triangle.
    fn matrix(&self, rows: &[[f64; QUADRATIC]]) -> [[f64; QUADRATIC]; QUADRATIC] {
        let mut matrix = [[0.0; QUADRATIC]; QUADRATIC];
        for (value, row) in self.values.iter().zip(rows) {
            for (i, entries) in matrix.iter_mut().enumerate() {
                let weighted = value.weight * row[i];
                entries[..=i].iter_mut().zip(row).for_each(|(entry, x)| *entry += weighted * x);
            }
        }
        matrix
    }

    /// The normal equations' right-hand side in a band, and Σ w f².
    fn side(&self, rows: &[[f64; QUADRATIC]], band: usize) -> ([f64; QUADRATIC], f64) {
        let (mut side, mut all) = ([0.0; QUADRATIC], 0.0);
        for (value, row) in self.values.iter().zip(rows) {
            let weighted = value.weight * value.bands[band];
            side.iter_mut().zip(row).for_each(|(side, x)| *side += weighted * x);
            all += weighted * value.bands[band];
        }
        (side, all)
    }
}

/// A Cholesky factor L of the normal equations' matrix M = L Lᵀ. Its leading rows are the factor of fewer
/// terms.
///
/// With L y = b and L z = e₀ the fit is p(0) = z · y, and Σ w (p − f)² = Σ w f² − y · y.
struct PartialCholesky {
    rows: [[f64; QUADRATIC]; QUADRATIC],
    /// Rows that are known: M is nearly singular from there on, or no more were wanted.
    terms: usize,
}

impl PartialCholesky {
    /// Factors a symmetric matrix, of which the lower triangle is given, for so many terms.
    fn of(mut matrix: [[f64; QUADRATIC]; QUADRATIC], wanted: usize) -> Self {
        for i in 0..wanted {
            let diagonal = matrix[i][i];
            for j in 0..i {
                matrix[i][j] = (matrix[i][j] - dot(&matrix[i][..j], &matrix[j][..j])) / matrix[j][j];
            }
            let rest = diagonal - dot(&matrix[i][..i], &matrix[i][..i]);
            if rest <= FLAT * diagonal {
                return Self { rows: matrix, terms: i };
            }
            matrix[i][i] = rest.sqrt();
        }
        Self { rows: matrix, terms: wanted }
    }

    /// y with L y = b, in the known rows.
    fn forward(&self, mut b: [f64; QUADRATIC]) -> [f64; QUADRATIC] {
        for i in 0..self.terms {
            b[i] = (b[i] - dot(&self.rows[i][..i], &b[..i])) / self.rows[i][i];
        }
        b
    }

    /// x with Lᵀ x = y, of so many leading rows.
    fn backward(&self, y: &[f64; QUADRATIC], terms: usize) -> [f64; QUADRATIC] {
        let mut x = *y;
        for i in (0..terms).rev() {
            let known: f64 = (i + 1..terms).map(|k| self.rows[k][i] * x[k]).sum();
            x[i] = (x[i] - known) / self.rows[i][i];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: [[f64; 2]; 9] = [
        [-1.0, -0.5],
        [1.0, -0.7],
        [0.9, 1.0],
        [-1.2, 0.8],
        [0.3, 0.1],
        [-0.2, 1.4],
        [0.1, -1.3],
        [1.6, 0.2],
        [-1.5, 0.1],
    ];

    fn fit(count: usize, f: impl Fn([f64; 2]) -> f64) -> Option<FitResult> {
        let values: Vec<[f64; 1]> = PLACES[..count].iter().map(|at| [f(*at)]).collect();
        let mut fit = Fit::new();
        for (at, value) in PLACES.iter().zip(&values) {
            fit.take(*at, 0.5 + at[0] * at[0], value, 0.1);
        }
        fit.found()
    }

    #[test]
    fn polynomials_are_found_and_others_leave_a_residual() {
        let quadratic = fit(9, |[x, y]| 2.0 + 3.0 * x - y + 0.3 * x * x - x * y).expect("nine places");
        // Squares are subtracted: half of the digits remain.
        assert!((quadratic.value[0] - 2.0).abs() < 1e-12 && quadratic.residual < 1e-6);
        assert!(quadratic.bend > 0.1 && (quadratic.noise - 0.1).abs() < 1e-12);
        let linear = fit(4, |[x, y]| 2.0 + 3.0 * x - y).expect("four places");
        assert!((linear.value[0] - 2.0).abs() < 1e-12 && linear.residual < 1e-6);
        assert!(linear.bend > 1.0 && linear.amplified < 1.5, "{linear:?}");
        assert!(fit(9, |[x, _]| if x > 0.5 { 1.0 } else { 0.0 }).expect("nine").residual > 0.1);
    }

    /// A fit at the origin to values of rows at the heights `rows`, each with four nodes, and of the single nodes
    /// `beside`, in cells of the side 1.
    fn fit_of_rows(rows: &[(f64, f64)], beside: &[([f64; 2], f64)]) -> FitResult {
        let of_row = |(y, value): &(f64, f64)| [-1.4, -0.4, 0.6, 1.6].map(|x| ([x, *y], *value));
        let nodes: Vec<([f64; 2], [f64; 1])> = rows
            .iter()
            .flat_map(of_row)
            .chain(beside.iter().copied())
            .map(|(at, value)| (at, [value]))
            .collect();
        let mut fit = Fit::new();
        nodes
            .iter()
            .filter(|(at, _)| weight(*at) > 0.0)
            .for_each(|(at, value)| fit.take(*at, weight(*at), value, 0.5));
        fit.found().expect("two rows and more")
    }

    /// Light of a panel under a desk: it falls within the last tenth below the top, where the last row stands.
    #[test]
    fn three_rows_say_little_between() {
        let panel = fit_of_rows(&[(-1.7, 108.0), (-0.7, 136.0), (0.3, 85.0)], &[]);
        assert!(panel.residual < 0.5 && panel.left() < 4.0, "{panel:?}");
        assert!(panel.left_on_few_lines(1.5) > 6.0, "{panel:?}");
        let even = fit_of_rows(&[(-1.7, 108.0), (-0.7, 109.0), (0.3, 109.0)], &[]);
        assert!(even.left_on_few_lines(1.5) < 0.5, "{even:?}");
    }

    /// Light beside a lamp's housing: two rows, and a node of a third that is nearly out of reach.
    #[test]
    fn two_rows_and_a_faint_node_are_two_rows() {
        let found = fit_of_rows(&[(-0.13, 96.0), (0.87, 226.0)], &[([0.6, 1.87], 230.0)]);
        assert!(found.curve == 0.0 && found.left() > 10.0, "{found:?}");
    }

    #[test]
    fn places_on_a_line_or_too_few_are_refused() {
        let mut fit = Fit::new();
        for k in 0..9 {
            assert!(fit.found().is_none());
            fit.take([f64::from(k), 2.0 * f64::from(k)], 1.0, &[1.0], 0.0);
        }
        assert!(fit.found().is_none());
        assert_eq!(fit.within(vec![1.2]), vec![1.0]);
    }
}
