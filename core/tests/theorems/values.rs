//! Values and derivatives: tables, big integers, orthonormality, and the agreement of all ways to evaluate.

use proptest::prelude::*;
use radiosity_core::jacobi::{self, Entry, Polynomials, Table, Weight};
use radiosity_core::legendre;

use crate::tables::{decimals, number, tables};
use radiosity_test_support::oracle::{Fixed, Oracle};

/// p_0 … p_32 and their derivatives, from the public functions for a weight.
fn values(weight: Weight, x: f64) -> [[f64; 33]; 2] {
    let (mut p, mut d) = ([0.0; 33], [0.0; 33]);
    if weight == Weight::LEGENDRE {
        legendre::orthonormal_with_derivatives(x, &mut p, &mut d);
    } else {
        Polynomials::<33>::new(weight).values_with_derivatives(x, &mut p, &mut d);
    }
    [p, d]
}

/// The size that errors at degree n are measured by: √(v_n² + v_{n−1}²).
fn envelope(v: &[f64], n: usize) -> f64 {
    v[n].hypot(if n > 0 { v[n - 1] } else { 0.0 })
}

#[test]
fn values_and_derivatives_keep_the_digits_of_the_tables() {
    for table in tables("values.json") {
        let weight = Weight::new(number(&table, "alpha"), number(&table, "beta")).expect("a weight");
        let degrees =
            table["degrees"].as_array().expect("degrees").iter().map(|n| n.as_u64().expect("whole") as usize);
        let degrees: Vec<usize> = degrees.collect();
        for point in table["points"].as_array().expect("points") {
            let x: f64 = point["x"].as_str().expect("a decimal").parse().expect("a float");
            let ours = values(weight, x);
            for (key, ours) in ["v", "d"].into_iter().zip(&ours) {
                for (&n, exact) in degrees.iter().zip(decimals(point, key)).filter(|(n, _)| **n <= 32) {
                    let error =
                        (Fixed::decimal(&exact) - Fixed::float(ours[n])).to_f64().abs() / f64::EPSILON;
                    let limit = if key == "v" { 10.0 } else { 20.0 };
                    assert!(
                        error <= limit * envelope(ours, n),
                        "{weight:?}: {key} of degree {n} at {x}: {error}"
                    );
                    if x.abs() == 1.0 && key == "v" {
                        assert!(error <= 1.5 * ours[n].abs(), "{weight:?}: degree {n} at {x}: {error}");
                    }
                }
            }
        }
    }
}

#[test]
fn derivatives_at_the_ends_follow_the_differential_equation() {
    // p_n′(±1) = ± n (n + α + β + 1)/(2 (α + 1)) p_n(±1), β for the left end.
    for (alpha, beta) in [(0.0, 0.0), (0.0, 2.0), (-0.5, 1.25), (-0.9, -0.9)] {
        let weight = Weight::new(alpha, beta).expect("a weight");
        for (x, exponent) in [(1.0, alpha), (-1.0, beta)] {
            let [p, d] = values(weight, x);
            for n in 1..33 {
                let degree = n as f64;
                let exact = x * degree * (degree + alpha + beta + 1.0) / (2.0 * (exponent + 1.0)) * p[n];
                assert!((d[n] / exact - 1.0).abs() < 1e-14, "({alpha}, {beta}), degree {n} at {x}");
            }
        }
    }
}

#[test]
fn legendre_values_grow_as_the_root_of_the_degree_at_the_ends() {
    let mut p = vec![0.0; 2000];
    legendre::orthonormal(-1.0, &mut p);
    for (n, p) in p.iter().enumerate() {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        assert_eq!(*p, sign * (n as f64 + 0.5).sqrt());
    }
}

#[test]
fn norms_of_large_degree_and_exponent_do_not_overflow() {
    // ‖P_n^(0,2)‖² = 8/(2n + 3), ‖P_n^(α,α)‖ far beyond where Γ(n + α) leaves the floats.
    let norms = Polynomials::<400>::new(Weight::integer(0, 2)).norms();
    for (n, norm) in norms.iter().enumerate() {
        assert!((norm * norm * (2 * n + 3) as f64 / 8.0 - 1.0).abs() < 1e-14, "{n}");
    }
    let table = Polynomials::<200>::new(Weight::integer(100, 60));
    assert!(table.norms().iter().chain(table.right()).chain(table.left()).all(|v| v.is_normal()));
}

#[test]
fn tiles_hold_the_values_of_single_points() {
    let x = [-1.0, -0.9, -0.3, 0.0, 0.1, 0.5, 0.99, 1.0];
    let (mut tile, mut slopes, mut anchored) = ([[0.0; 8]; 12], [[0.0; 8]; 12], [[0.0; 8]; 12]);
    legendre::tile(&x, &mut tile);
    legendre::tile_anchored(&x, &mut anchored);
    let mut again = [[0.0; 8]; 12];
    legendre::tile_with_derivatives(&x, &mut again, &mut slopes);
    assert_eq!(tile, again);
    for (l, &x) in x.iter().enumerate() {
        let [p, d] = values(Weight::LEGENDRE, x);
        for n in 0..12 {
            assert!((tile[n][l] - p[n]).abs() < 2e-14, "degree {n} at {x}");
            assert!((anchored[n][l] - p[n]).abs() < 2e-15, "degree {n} at {x}");
            assert!((slopes[n][l] - d[n]).abs() < 1e-12, "derivative {n} at {x}");
        }
    }
}

fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -0.95..4.0f64, 1 => Just(0.0), 1 => Just(2.0), 1 => 4.0..30.0f64]
}

/// Points everywhere, and as near to the ends as floats can be.
fn point() -> impl Strategy<Value = f64> {
    let near = (0i32..53, prop::bool::ANY).prop_map(|(k, left)| {
        let x = 1.0 - 0.5f64.powi(k + 1);
        if left { -x } else { x }
    });
    prop_oneof![2 => -1.0..=1.0f64, 1 => near]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn values_of_any_weight_keep_their_digits(alpha in exponent(), beta in exponent(), x in point()) {
        let weight = Weight::new(alpha, beta).expect("a weight");
        let [p, _] = values(weight, x);
        for n in [1, 2, 7, 19, 32] {
            let oracle = Oracle::new(alpha, beta, n);
            // p_n² = π_n²/(μ₀ · (norm/μ₀)); compared squared, since the oracle takes no roots.
            let exact = oracle.value(&Fixed::float(x)).to_f64() / (oracle.squared_norm().to_f64() * weight.integral()).sqrt();
            let error = (p[n] - exact).abs() / f64::EPSILON;
            prop_assert!(error <= 30.0 * envelope(&p, n), "degree {n}: {} and {exact}", p[n]);
        }
    }

    #[test]
    fn derivatives_are_limits_of_difference_quotients(alpha in exponent(), beta in exponent(), x in point()) {
        let weight = Weight::new(alpha, beta).expect("a weight");
        let [_, d] = values(weight, x);
        // (p(x + h) − p(x − h))/2h with h = 2⁻⁸⁰ in 320 bits: truncation h² p‴/6 is far below rounding.
        let h = Fixed::float(0.5f64.powi(80));
        for n in [1, 2, 7, 19, 32] {
            let oracle = Oracle::new(alpha, beta, n);
            let rise = oracle.value(&(Fixed::float(x) + h.clone())) - oracle.value(&(Fixed::float(x) - h.clone()));
            let scale = (oracle.squared_norm().to_f64() * weight.integral()).sqrt();
            let exact = (&rise / &h).to_f64() / (2.0 * scale);
            let error = (d[n] - exact).abs() / f64::EPSILON;
            prop_assert!(error <= 60.0 * envelope(&d, n), "degree {n}: {} and {exact}", d[n]);
        }
    }

    #[test]
    fn the_ways_to_evaluate_agree(alpha in exponent(), beta in exponent(), x in -0.99..0.99f64) {
        let weight = Weight::new(alpha, beta).expect("a weight");
        let table = Polynomials::<20>::new(weight);
        let (mut anchored, mut alone, mut plain) = ([0.0; 20], [0.0; 20], [0.0; 20]);
        table.values(x, &mut anchored);
        jacobi::orthonormal(weight, x, &mut alone);
        table.recurrence().values(x, &mut plain);
        prop_assert_eq!(anchored, alone);
        let mut entries = [Entry::EMPTY; 23];
        let kept = Table::new(weight, &mut entries);
        let (mut slopes, mut kept_slopes, mut kept_values) = ([0.0; 20], [0.0; 20], [0.0; 20]);
        kept.values(x, &mut alone);
        prop_assert_eq!(anchored, alone);
        table.values_with_derivatives(x, &mut alone, &mut slopes);
        kept.values_with_derivatives(x, &mut kept_values, &mut kept_slopes);
        prop_assert_eq!((alone, slopes), (kept_values, kept_slopes));
        let norms = table.norms();
        prop_assert!((0..20).all(|n| (kept.norm(n) / norms[n] - 1.0).abs() < 1e-14));
        let size = anchored.iter().fold(0.0f64, |size, p| size.max(p.abs()));
        for n in 0..20 {
            prop_assert!((plain[n] - anchored[n]).abs() <= 1e-11 * size);
        }
    }

    #[test]
    fn sums_are_sums(f in prop::array::uniform13(-1.0..1.0f64), x in -1.0..=1.0f64) {
        let mut p = [0.0; 13];
        legendre::orthonormal(x, &mut p);
        let plain: f64 = f.iter().zip(&p).map(|(f, p)| f * p).sum();
        prop_assert!((legendre::sum(&f, x) - plain).abs() < 1e-13);
        prop_assert!((legendre::sum_tile(&f, &[x; 8])[3] - plain).abs() < 1e-13);
        prop_assert!((legendre::Table::<13>::RECURRENCE.sum(&f, x) - plain).abs() < 1e-13);
    }
}
