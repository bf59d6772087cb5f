//! The tail: what polynomials of an order leave out, from how their coefficients fall.
//!
//! With a_d² the sum of the squares of an element's coefficients of degree d, C = a²_N + a²_{N−1} and
//! q = C/(a²_{N−2} + a²_{N−3}), what follows is one of
//!
//! ```text
//! geometric:   Σ = C q/(1 − q)
//! algebraic:   Σ = ½ C Σ_{n > N} (m/n)^p ≈ ½ C m^p (N + ½)^(1 − p)/(p − 1) ,   m = N − ½ ,   p = −ln q / ln(m/(m − 2))
//! ```
//!
//! Where radiosity is smooth coefficients fall geometrically; at edges, where it behaves like rᵞ, and at shadows they come to fall
//! algebraically. The sums run over all elements.
//!
//! Below order 3 there are no two pairs. Order 2 has q = a₂²/a₀², order 1 q = (a₁²/a₀²)², and the algebraic sum is
//! a²_N (N + ½)/(p − 1), p = −ln q / ln 5. Order 0 does not show its tail.

use crate::solution::{Band, Solution};

/// Largest q: coefficients that do not fall are not continued for ever.
const LARGEST_RATIO: f64 = 0.9;

/// Least p.
const LEAST_POWER: f64 = 1.5;

/// ‖B − B_h‖ / ‖B_h − E₀‖ as the coefficients of B_h suggest, all bands pooled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tail {
    /// If they go on to fall geometrically.
    pub(super) geometric: f64,
    /// If they go on to fall like a power of the degree.
    pub(super) algebraic: f64,
}

impl Tail {
    pub(super) fn of(solution: &Solution) -> Self {
        let mut sums = Sums::default();
        for band in solution.bands() {
            sums.add(solution, band);
        }
        let relative = |sum: f64| if sum > 0.0 { (sum / sums.size).sqrt() } else { 0.0 };
        Self { geometric: relative(sums.geometric), algebraic: relative(sums.algebraic) }
    }
}

/// Squares over all elements.
#[derive(Default)]
struct Sums {
    size: f64,
    geometric: f64,
    algebraic: f64,
}

impl Sums {
    fn add(&mut self, solution: &Solution, band: &Band) {
        let mut rest = &band.coefficients.irradiance[..];
        for (element, reflectance) in solution.elements().list().iter().zip(&band.coating.reflectance) {
            let (own, others) = rest.split_at(element.basis.len());
            rest = others;
            let square = |h: &f64| (reflectance * h).powi(2);
            let levels = element.basis.space().levels(element.basis.order()).functions;
            let squares: Vec<f64> =
                levels.into_iter().map(|level| own[level].iter().map(square).sum()).collect();
            let [geometric, algebraic] = continued(&squares);
            self.size += squares.iter().sum::<f64>();
            self.geometric += geometric;
            self.algebraic += algebraic;
        }
    }
}

/// Both sums beyond a_0², …, a_N².
fn continued(squares: &[f64]) -> [f64; 2] {
    let order = squares.len() - 1;
    let degree = order as f64;
    let pair = |k: usize| squares[k] + squares[k - 1];
    let (carry, ratio) = match order {
        0 => return [0.0; 2],
        1 => (pair(1), (squares[1] / squares[0]).powi(2)),
        2 => (pair(2), squares[2] / squares[0]),
        _ => (pair(order), pair(order) / pair(order - 2)),
    };
    if carry == 0.0 || ratio == 0.0 {
        return [0.0; 2];
    }
    let fall = ratio.min(LARGEST_RATIO);
    let middle = degree - 0.5;
    let stretch = if order < 3 { 5.0 } else { middle / (middle - 2.0) };
    let power = (-ratio.ln() / f64::ln(stretch)).max(LEAST_POWER);
    let [last, from] = if order < 3 { [squares[order], degree + 0.5] } else { [0.5 * carry, middle] };
    let algebraic = last * (from / (degree + 0.5)).powf(power) * (degree + 0.5) / (power - 1.0);
    [carry * fall / (1.0 - fall), algebraic]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn geometric_sums_are_exact_for_geometric_coefficients() {
        for (fall, order) in [(0.1f64, 3), (0.5, 6), (0.02, 8)] {
            let squares: Vec<f64> = (0..=order).map(|d| fall.powi(d)).collect();
            let [geometric, _] = continued(&squares);
            let exact = fall.powi(order + 1) / (1.0 - fall);
            assert!((geometric / exact - 1.0).abs() < 1e-12, "{geometric} {exact}");
        }
    }

    #[test]
    fn algebraic_sums_are_close_for_powers_of_the_degree() {
        for (power, order) in [(2.0f64, 4), (3.0, 6), (4.0, 9), (3.0, 14)] {
            let square = |d: usize| (d.max(1) as f64).powf(-power);
            let squares: Vec<f64> = (0..=order).map(square).collect();
            let [geometric, algebraic] = continued(&squares);
            let exact: f64 = (order + 1..100_000).map(square).sum();
            assert!((algebraic / exact).ln().abs() < 0.5, "{algebraic} {exact}");
            assert!(geometric < exact);
        }
    }

    #[test]
    fn nothing_follows_a_constant() {
        for order in 0..6 {
            let mut squares = vec![0.0; order + 1];
            squares[0] = 1.0;
            assert_eq!(continued(&squares), [0.0; 2]);
        }
    }
}
