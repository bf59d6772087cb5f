//! A value at one place, from values at others around it: a polynomial, fitted with weights.
//!
//! ```text
//! min Σ_i w_i (p(d_i) − f_i)² ,     f ≈ p(0) ,     w_i = (1 − (r_i/R)²)² ,
//! ```
//!
//! with d_i the offset in the tangent plane of the place and r_i the distance in the picture; p has the degree 2 where
//! there are enough values, else 1. Where the places lie on one side p(0) is extrapolated: a = |Σ w d| / √(Σw Σ w d²), 0
//! where they lie around it, tells how far.

use smallvec::SmallVec;

/// Coefficients of a polynomial of degree 2 and of degree 1.
const QUADRATIC: usize = 6;
const LINEAR: usize = 3;

/// Values that a degree takes at the least: some more than it has coefficients.
const SPARE: usize = 1;

/// Least square of a pivot over its diagonal entry: places nearly on a curve know less. Chosen.
const FLAT: f64 = 1e-3;

/// Values around a place.
#[derive(Clone, Debug)]
pub(super) struct Fit<'a> {
    values: SmallVec<[Value<'a>; 25]>,
}

#[derive(Clone, Copy, Debug)]
struct Value<'a> {
    at: [f64; 2],
    weight: f64,
    bands: &'a [f64],
}

/// What is found.
#[derive(Clone, Debug)]
pub(super) struct Found {
    /// The value per band.
    pub value: Vec<f64>,
    /// Root mean square of what the fit leaves, over the size of the values.
    pub residual: f64,
    /// a, at most 1.
    pub aside: f64,
    /// What a fit of degree 1 differs by, over the size of the values; 0 if this one has that degree.
    pub bend: f64,
}

impl<'a> Fit<'a> {
    /// Nothing yet.
    pub(super) fn new() -> Self {
        Self { values: SmallVec::new() }
    }

    /// Takes the value of all bands at the offset `at`, with a weight above 0.
    pub(super) fn take(&mut self, at: [f64; 2], weight: f64, bands: &'a [f64]) {
        self.values.push(Value { at, weight, bands });
    }

    /// The mean of all values, by their weights; None of none.
    pub(super) fn mean(&self) -> Option<Vec<f64>> {
        let first = self.values.first()?;
        let all: f64 = self.values.iter().map(|value| value.weight).sum();
        let mean =
            |band: usize| self.values.iter().map(|value| value.weight * value.bands[band]).sum::<f64>() / all;
        Some((0..first.bands.len()).map(mean).collect())
    }

    /// The fit; None of too few values, or of values on a line.
    pub(super) fn found(&self) -> Option<Found> {
        match self.values.len() {
            count if count >= QUADRATIC + SPARE => {
                let linear = self.of_degree::<LINEAR>()?;
                Some(self.of_degree::<QUADRATIC>().map_or(linear.clone(), |found| found.beside(&linear)))
            }
            count if count >= LINEAR + SPARE => self.of_degree::<LINEAR>(),
            _ => None,
        }
    }

    fn aside(&self) -> f64 {
        let sum = |term: &dyn Fn(&Value) -> f64| {
            self.values.iter().map(|value| value.weight * term(value)).sum::<f64>()
        };
        let [x, y] = [0, 1].map(|k| sum(&|value| value.at[k]));
        let squares = sum(&|value| value.at[0].powi(2) + value.at[1].powi(2));
        x.hypot(y) / (sum(&|_| 1.0) * squares).sqrt()
    }

    fn of_degree<const N: usize>(&self) -> Option<Found> {
        let size = self.values.iter().flat_map(|value| value.at).fold(0.0, |most: f64, x| most.max(x.abs()));
        let row = |value: &Value| {
            let [x, y] = value.at.map(|x| x / size);
            let terms = [1.0, x, y, x * x, x * y, y * y];
            std::array::from_fn::<f64, N, _>(|k| terms[k])
        };
        let mut matrix = [[0.0; N]; N];
        for value in &self.values {
            let row = row(value);
            for (i, j) in (0..N).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                matrix[i][j] += value.weight * row[i] * row[j];
            }
        }
        let factor = factor(matrix)?;
        let bands = self.values[0].bands.len();
        let (mut value, mut left, mut square) = (vec![0.0; bands], 0.0, 0.0);
        for (band, found) in value.iter_mut().enumerate() {
            let mut side = [0.0; N];
            for value in &self.values {
                let row = row(value);
                side.iter_mut().zip(row).for_each(|(side, x)| *side += value.weight * x * value.bands[band]);
            }
            let coefficients = solve(&factor, side);
            *found = coefficients[0];
            for value in &self.values {
                let fitted: f64 = row(value).iter().zip(coefficients).map(|(x, c)| x * c).sum();
                left += value.weight * (fitted - value.bands[band]).powi(2);
                square += value.weight * value.bands[band].powi(2);
            }
        }
        Some(Found {
            value,
            residual: (left / square.max(f64::MIN_POSITIVE)).sqrt(),
            aside: self.aside(),
            bend: 0.0,
        })
    }
}

impl Found {
    /// This fit, where one of degree 1 finds `linear`.
    fn beside(self, linear: &Self) -> Self {
        let apart: f64 = self.value.iter().zip(&linear.value).map(|(a, b)| (a - b).abs()).sum();
        let size: f64 = self.value.iter().map(|value| value.abs()).sum();
        Self { bend: apart / size.max(f64::MIN_POSITIVE), ..self }
    }
}

/// The Cholesky factor of a symmetric matrix, of which the lower triangle is given; None if it is nearly singular.
fn factor<const N: usize>(mut matrix: [[f64; N]; N]) -> Option<[[f64; N]; N]> {
    for i in 0..N {
        let diagonal = matrix[i][i];
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - sum;
            matrix[i][j] = match i == j {
                true if rest <= FLAT * diagonal => return None,
                true => rest.sqrt(),
                false => rest / matrix[j][j],
            };
        }
    }
    Some(matrix)
}

/// x with L Lᵀ x = b.
fn solve<const N: usize>(factor: &[[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for i in 0..N {
        let sum: f64 = (0..i).map(|k| factor[i][k] * b[k]).sum();
        b[i] = (b[i] - sum) / factor[i][i];
    }
    for i in (0..N).rev() {
        let sum: f64 = (i + 1..N).map(|k| factor[k][i] * b[k]).sum();
        b[i] = (b[i] - sum) / factor[i][i];
    }
    b
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

    fn fit(count: usize, f: impl Fn([f64; 2]) -> f64) -> Option<Found> {
        let values: Vec<[f64; 1]> = PLACES[..count].iter().map(|at| [f(*at)]).collect();
        let mut fit = Fit::new();
        for (at, value) in PLACES.iter().zip(&values) {
            fit.take(*at, 0.5 + at[0] * at[0], value);
        }
        fit.found()
    }

    #[test]
    fn polynomials_are_found_and_others_leave_a_residual() {
        let quadratic = fit(9, |[x, y]| 2.0 + 3.0 * x - y + 0.3 * x * x - x * y).expect("nine places");
        assert!((quadratic.value[0] - 2.0).abs() < 1e-12 && quadratic.residual < 1e-12);
        let linear = fit(4, |[x, y]| 2.0 + 3.0 * x - y).expect("four places");
        assert!((linear.value[0] - 2.0).abs() < 1e-12 && linear.residual < 1e-12);
        assert!(linear.aside < 0.3, "{}", linear.aside);
        assert!(fit(9, |[x, _]| if x > 0.5 { 1.0 } else { 0.0 }).expect("nine").residual > 0.1);
    }

    #[test]
    fn places_on_a_line_or_too_few_are_refused() {
        let mut fit = Fit::new();
        assert!(fit.mean().is_none());
        for k in 0..9 {
            assert!(fit.found().is_none());
            fit.take([f64::from(k), 2.0 * f64::from(k)], 1.0, &[1.0]);
        }
        assert!(fit.found().is_none());
        assert_eq!(fit.mean(), Some(vec![1.0]));
    }
}
