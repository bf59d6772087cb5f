//! Real roots of polynomials of low degree.
//!
//! Quadratic a x² + b x + c: with q = −½(b + sgn(b)√(b² − 4ac)) the roots are q/a and c/q; neither subtracts
//! nearly equal numbers except in the discriminant, which is formed with a fused product (Kahan, *On the cost
//! of floating-point computation without extra-precise arithmetic*, 2004).
//!
//! Higher degrees on [0, 1]: in the Bernstein form Σ bᵢ Bᵢⁿ(x) the number of sign changes of b is at least
//! the number of roots and differs from it by an even number (Descartes' rule). No change: no root. One:
//! exactly one, found by bisection sped up by Newton steps. More: halve the interval by de Casteljau's scheme
//! (Lane and Riesenfeld, *Bounds on a polynomial*, 1981). Double roots never separate, nor does a root just
//! where an interval is halved; where the interval has shrunk to 2⁻²⁶ Newton steps from its middle give the
//! root.

use crate::bernstein::{evaluate, split};

/// The real roots of a x² + b x + c, in no particular order; a double root twice; infinite or NaN where there
/// are fewer.
pub fn quadratic(a: f64, b: f64, c: f64) -> [f64; 2] {
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

/// Halvings of an interval after which one root represents all in it: a double root is no better known than
/// to the square root of the precision, 2⁻²⁶.
const DEEPEST: usize = 26;

/// Visits the roots in [0, 1] of the polynomial with Bernstein coefficients `b`: each at least once, simple
/// ones to full precision, multiple ones to about 1e-8, where there may be false ones too: the caller has to
/// check.
pub fn bernstein<const N: usize>(b: [f64; N], mut visit: impl FnMut(f64)) {
    let largest = b.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    // The zero polynomial vanishes everywhere and so nowhere in particular.
    if largest > 0.0 {
        isolate(&b, [0.0, 1.0], 0, 4.0 * f64::EPSILON * largest, &mut visit);
    }
}

fn isolate<const N: usize>(
    b: &[f64; N],
    [low, high]: [f64; 2],
    depth: usize,
    noise: f64,
    visit: &mut impl FnMut(f64),
) {
    if b.iter().all(|x| *x > noise) || b.iter().all(|x| *x < -noise) {
        return;
    }
    if b.iter().all(|x| x.abs() <= noise) {
        return visit(0.5 * (low + high));
    }
    let changes = b.windows(2).filter(|w| (w[0] < 0.0) != (w[1] < 0.0)).count();
    if changes == 1 && b[0].abs() > noise && b[N - 1].abs() > noise {
        return visit(low + (high - low) * bracketed(b));
    }
    let middle = 0.5 * (low + high);
    if depth == DEEPEST {
        return visit(low + (high - low) * polished(b));
    }
    let [left, right] = split(b, 0.5);
    isolate(&left, [low, middle], depth + 1, noise, visit);
    isolate(&right, [middle, high], depth + 1, noise, visit);
}

/// The only root in [0, 1] of a polynomial that changes sign there.
fn bracketed<const N: usize>(b: &[f64; N]) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = b[0] / (b[0] - b[N - 1]);
    for _ in 0..60 {
        let (value, slope) = evaluate(b, x);
        if (value < 0.0) == (b[0] < 0.0) {
            low = x
        } else {
            high = x
        }
        let newton = x - value / slope;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= f64::EPSILON {
            return next;
        }
        x = next;
    }
    x
}

/// A few Newton steps from ½, kept within [0, 1]: a simple root in or beside a short interval.
fn polished<const N: usize>(b: &[f64; N]) -> f64 {
    let mut x = 0.5;
    for _ in 0..3 {
        let (value, slope) = evaluate(b, x);
        let next = x - value / slope;
        if next.is_finite() {
            x = next.clamp(0.0, 1.0);
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bernstein::from_powers;
    use proptest::prelude::*;

    #[test]
    fn missing_roots_are_not_finite() {
        assert!(quadratic(1.0, 0.0, 1.0).iter().all(|x| x.is_nan()));
        let linear = quadratic(0.0, 2.0, -1.0);
        assert!(linear.contains(&0.5) && linear.iter().any(|x| !x.is_finite()));
    }

    #[test]
    fn double_roots_are_seen() {
        let mut seen = Vec::new();
        // (x − 0.3)², and its Bernstein coefficients.
        bernstein(from_powers([0.09, -0.6, 1.0]), |x| seen.push(x));
        assert!(!seen.is_empty() && seen.iter().all(|x| (x - 0.3).abs() < 1e-7));
    }

    #[test]
    fn roots_where_the_interval_is_halved_keep_their_digits() {
        // x (x − ½)(x − 1) has roots at both ends and in the middle.
        let mut seen = Vec::new();
        bernstein(from_powers([0.0, 0.5, -1.5, 1.0]), |x| seen.push(x));
        for root in [0.0, 0.5, 1.0] {
            assert!(seen.iter().any(|x| (x - root).abs() < 1e-15), "{root} not in {seen:?}");
        }
        assert!(seen.iter().all(|x| [0.0, 0.5, 1.0].iter().any(|root| (x - root).abs() < 1e-15)), "{seen:?}");
    }

    proptest! {
        #[test]
        fn quartics_find_all_their_roots(roots in prop::collection::vec(0.0..1.0_f64, 4)) {
            let mut power = [1.0, 0.0, 0.0, 0.0, 0.0];
            for r in &roots {
                power = std::array::from_fn(|k| if k == 0 { 0.0 } else { power[k - 1] } - r * power[k]);
            }
            let mut seen = Vec::new();
            bernstein(from_powers(power), |x| seen.push(x));
            for r in &roots {
                let others: f64 = roots.iter().filter(|x| *x != r).map(|x: &f64| (x - r).abs()).product();
                // The powers' coefficients, of sum up to 2⁴, carry a few roundings each; the slope at the
                // root is the product of its distances from the others.
                let tolerance = 64.0 * f64::EPSILON / others;
                prop_assert!(others < 1e-8 || seen.iter().any(|x| (x - r).abs() < tolerance), "{roots:?} {seen:?}");
            }
        }

        #[test]
        fn quadratic_finds_its_roots(x in -10.0..10.0, y in -10.0..10.0, a in prop_oneof![-3.0..-0.1, 0.1..3.0]) {
            let (low, high) = (f64::min(x, y), f64::max(x, y));
            let mut roots = quadratic(a, -a * (x + y), a * x * y);
            prop_assume!(!roots[0].is_nan());
            roots.sort_by(f64::total_cmp);
            // The coefficients carry rounding of their own, which a near-double root feels as its square
            // root.
            let tolerance = 1e-14 * 100.0 / (high - low).max(1e-7);
            prop_assert!((roots[0] - low).abs() < tolerance && (roots[1] - high).abs() < tolerance);
        }
    }
}
