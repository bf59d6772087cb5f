//! A function of the radius of a disk as a Legendre series, on a machine without an operating system.
//!
//! The compiler makes the rule and the polynomials. `.ci/run` compiles the program for bare targets, a test
//! at its end runs it.
#![cfg_attr(not(test), no_std)]

use radiosity_core::convert;
use radiosity_core::gauss::Rule;
use radiosity_core::jacobi::{Polynomials, Weight};

/// With the radius (1 + x)/2 an area element of the disk is proportional to (1 + x) dx.
const AREA: Weight = Weight::integer(0, 1);
const RULE: Rule<8> = Rule::jacobi(AREA);
const BASIS: Polynomials<8> = Polynomials::new(AREA);

/// The Legendre coefficients of the polynomial of degree 7 that equals `f` in the eight nodes.
pub fn fit(f: fn(f64) -> f64) -> [f64; 8] {
    let (mut coefficients, mut p) = ([0.0; 8], [0.0; 8]);
    for (&x, w) in RULE.nodes.iter().zip(RULE.weights) {
        BASIS.values(x, &mut p);
        let value = w * f(x);
        coefficients.iter_mut().zip(p).for_each(|(c, p)| *c += value * p);
    }
    convert::to_legendre(0, 1, &mut coefficients);
    coefficients
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_core::legendre;

    proptest! {
        #[test]
        fn polynomials_of_degree_7_are_fitted_exactly(x in -1.0..=1.0f64) {
            let f = |x: f64| 1.0 - x * (2.0 - x * x * (0.5 + x * x * (1.5 - x * x)));
            prop_assert!((legendre::sum(&super::fit(f), x) - f(x)).abs() < 1e-13);
        }
    }
}
