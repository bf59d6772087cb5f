//! Real roots of polynomials of low degree.
//!
//! Quadratic a x² + b x + c: with q = −½(b + sgn(b)√(b² − 4ac)) the roots are q/a and c/q; neither subtracts nearly equal
//! numbers except in the discriminant, which is formed with a fused product (Kahan, *On the cost of floating-point
//! computation without extra-precise arithmetic*, 2004).

/// The real roots of a x² + b x + c, in no particular order; a double root twice; infinite or NaN where there are fewer.
pub(crate) fn quadratic(a: f64, b: f64, c: f64) -> [f64; 2] {
    let discriminant = difference_of_products(b, b, 4.0 * a, c);
    if discriminant < 0.0 {
        return [f64::NAN; 2];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / a, c / q]
}

/// a b − c d, accurate to 1.5 ulp.
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let cd = c * d;
    let error = (-c).mul_add(d, cd);
    a.mul_add(b, -cd) + error
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn missing_roots_are_not_finite() {
        assert!(quadratic(1.0, 0.0, 1.0).iter().all(|x| x.is_nan()));
        let linear = quadratic(0.0, 2.0, -1.0);
        assert!(linear.contains(&0.5) && linear.iter().any(|x| !x.is_finite()));
    }

    proptest! {
        #[test]
        fn quadratic_finds_its_roots(x in -10.0..10.0, y in -10.0..10.0, a in prop_oneof![-3.0..-0.1, 0.1..3.0]) {
            let (low, high) = (f64::min(x, y), f64::max(x, y));
            let mut roots = quadratic(a, -a * (x + y), a * x * y);
            prop_assume!(!roots[0].is_nan());
            roots.sort_by(f64::total_cmp);
            // The coefficients carry rounding of their own, which a near-double root feels as its square root.
            let tolerance = 1e-14 * 100.0 / (high - low).max(1e-7);
            prop_assert!((roots[0] - low).abs() < tolerance && (roots[1] - high).abs() < tolerance);
        }
    }
}
