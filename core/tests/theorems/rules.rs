//! Gauss rules: tables, big integers, and the properties that define them.

use nalgebra::DMatrix;
use proptest::prelude::*;
use radiosity_core::gauss::{self, RuleError};
use radiosity_core::jacobi::{self, Weight, WeightError};

use crate::tables::{decimals, floats, integer, number, tables};
use radiosity_test_support::oracle::{Fixed, Oracle, integral};

fn legendre(n: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
    gauss::legendre(&mut x, &mut w).expect("equal slices");
    (x, w)
}

fn jacobi_rule(alpha: f64, beta: f64, n: usize) -> (Vec<f64>, Vec<f64>) {
    let weight = Weight::new(alpha, beta).expect("a weight");
    let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
    gauss::jacobi(weight, &mut x, &mut w).expect("equal slices");
    (x, w)
}

/// The largest error in ulp of floats against exact decimals; an exact 0 must be met exactly.
fn worst(exact: &[String], ours: &[f64]) -> f64 {
    assert_eq!(exact.len(), ours.len());
    let errors = exact.iter().zip(ours).map(|(exact, &v)| match Fixed::decimal(exact) {
        zero if zero == Fixed::new(0) => {
            if v == 0.0 {
                0.0
            } else {
                f64::INFINITY
            }
        }
        exact => exact.ulps(v),
    });
    errors.fold(0.0, f64::max)
}

/// The largest errors in ulp of nodes and weights against big integers.
fn against_oracle(alpha: f64, beta: f64, mu_0: &Fixed, (x, w): &(Vec<f64>, Vec<f64>)) -> (f64, f64) {
    let oracle = Oracle::new(alpha, beta, x.len());
    let mut errors = (0.0f64, 0.0f64);
    for (&x, &w) in x.iter().zip(w) {
        let (root, share) = oracle.root(x);
        if x != 0.0 {
            errors.0 = errors.0.max(root.ulps(x));
        }
        errors.1 = errors.1.max((mu_0 * &share).ulps(w));
    }
    errors
}

#[test]
fn legendre_rules_round_the_tables_correctly() {
    for table in tables("gauss_legendre.json") {
        let n = integer(&table, "n");
        let (x, w) = legendre(n);
        assert!(worst(&decimals(&table, "x"), &x[n / 2..]) <= 0.51, "nodes of n = {n}");
        assert!(worst(&decimals(&table, "w"), &w[n / 2..]) <= 0.51, "weights of n = {n}");
    }
}

#[test]
fn legendre_rules_are_correctly_rounded_where_no_table_is() {
    for n in (1..=64).chain([99, 100, 127, 128]) {
        let (nodes, weights) = against_oracle(0.0, 0.0, &Fixed::new(2), &legendre(n));
        assert!(nodes <= 0.501 && weights <= 0.501, "n = {n}: {nodes} and {weights} ulp");
    }
}

#[test]
fn jacobi_rules_round_the_tables_correctly() {
    for table in tables("gauss_jacobi.json") {
        let (alpha, beta, n) = (number(&table, "alpha"), number(&table, "beta"), integer(&table, "n"));
        let (x, w) = jacobi_rule(alpha, beta, n);
        assert!(worst(&decimals(&table, "x"), &x) <= 0.51, "nodes of ({alpha}, {beta}), n = {n}");
        assert!(worst(&decimals(&table, "w"), &w) <= 0.51, "weights of ({alpha}, {beta}), n = {n}");
    }
}

/// 2^(a+b+1) a! b!/(a + b + 1)!
fn integer_integral(a: i64, b: i64) -> Fixed {
    let ratio = (1..=a).fold(Fixed::new(2), |v, j| &(&v * &Fixed::new(2 * j)) / &Fixed::new(b + j));
    &(1..=b).fold(ratio, |v, _| &v * &Fixed::new(2)) / &Fixed::new(a + b + 1)
}

#[test]
fn jacobi_rules_of_integer_exponents_are_correctly_rounded_where_no_table_is() {
    for (a, b) in [(0, 1), (1, 0), (1, 1), (3, 7), (30, 0), (29, 30), (12, 12)] {
        for n in [1, 2, 4, 6, 11, 24, 100] {
            let rule = jacobi_rule(a as f64, b as f64, n);
            let (nodes, weights) = against_oracle(a as f64, b as f64, &integer_integral(a, b), &rule);
            assert!(nodes <= 0.51 && weights <= 0.51, "({a}, {b}), n = {n}: {nodes} and {weights} ulp");
        }
    }
}

#[test]
fn the_integral_of_a_weight_obeys_reflection() {
    // B(p, 1 − p) = π/sin(πp): the weight of α = p − 1, β = −p.
    for p in [0.0625, 0.125, 0.25, 0.375, 0.5, 0.75, 0.875] {
        let integral = Weight::new(p - 1.0, -p).expect("a weight").integral();
        let exact = std::f64::consts::PI / (std::f64::consts::PI * p).sin();
        assert!((integral / exact - 1.0).abs() < 4.0 * f64::EPSILON, "{p}: {integral} and {exact}");
    }
    for table in tables("gauss_jacobi.json") {
        let weight = Weight::new(number(&table, "alpha"), number(&table, "beta")).expect("a weight");
        let exact = Fixed::decimal(table["mu0"].as_str().expect("a decimal"));
        assert!(exact.ulps(weight.integral()) <= 0.501, "{weight:?}");
        // The oracle of other tests, from a series, knows the same number.
        assert_eq!(exact.to_f64(), integral(weight.alpha(), weight.beta()).to_f64());
    }
}

#[test]
fn constant_rules_are_the_run_time_rules_bit_for_bit() {
    fn legendre_agrees<const N: usize>() {
        let (x, w) = legendre(N);
        assert_eq!(gauss::Legendre::<N>::NODES[..], x);
        assert_eq!(gauss::Legendre::<N>::WEIGHTS[..], w);
    }
    fn jacobi_agrees<const A: u8, const B: u8, const N: usize>() {
        let (x, w) = jacobi_rule(A.into(), B.into(), N);
        assert_eq!(gauss::Jacobi::<A, B, N>::NODES[..], x);
        assert_eq!(gauss::Jacobi::<A, B, N>::WEIGHTS[..], w);
    }
    const HALVES: Weight = match Weight::new(-0.3, 0.7) {
        Ok(weight) => weight,
        Err(_) => panic!(),
    };
    const RULE: gauss::Rule<9> = gauss::Rule::jacobi(HALVES);
    legendre_agrees::<1>();
    legendre_agrees::<2>();
    legendre_agrees::<7>();
    legendre_agrees::<20>();
    legendre_agrees::<64>();
    jacobi_agrees::<0, 2, 20>();
    jacobi_agrees::<2, 2, 11>();
    jacobi_agrees::<1, 0, 5>();
    assert_eq!(RULE, gauss::Rule::jacobi(HALVES));
    assert_eq!((RULE.nodes.to_vec(), RULE.weights.to_vec()), jacobi_rule(-0.3, 0.7, 9));
}

#[test]
fn asymptotic_rules_agree_with_correctly_rounded_ones() {
    let ulps = |a: f64, b: f64| (a - b).abs() / (b.abs().next_up() - b.abs());
    for n in (101..140).chain([256, 513, 777, 1000, 2001]) {
        let (exact_x, exact_w) = legendre(n);
        let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
        gauss::legendre_asymptotic(&mut x, &mut w).expect("n > 100");
        for i in 0..n {
            assert!(x[i] == exact_x[i] || ulps(x[i], exact_x[i]) <= 3.0, "node {i} of {n}");
            assert!(ulps(w[i], exact_w[i]) <= 4.0, "weight {i} of {n}");
        }
    }
}

#[test]
fn rules_are_the_eigenvalues_of_the_jacobi_matrix() {
    // The matrix of the weight (1 + x)², from the entries of the orthonormal recurrence.
    let n = 12;
    let (x, w) = jacobi_rule(0.0, 2.0, n);
    let moment = |f: &dyn Fn(f64, &[f64]) -> f64| -> f64 {
        let mut p = vec![0.0; n];
        x.iter()
            .zip(&w)
            .map(|(&x, &w)| {
                jacobi::orthonormal(Weight::integer(0, 2), x, &mut p);
                w * f(x, &p)
            })
            .sum()
    };
    let matrix = DMatrix::from_fn(n, n, |i, j| moment(&|x, p| x * p[i] * p[j]));
    let eigen = matrix.symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    for (i, k) in order.into_iter().enumerate() {
        assert!((eigen.eigenvalues[k] - x[i]).abs() < 1e-13);
        assert!((8.0 / 3.0 * eigen.eigenvectors[(0, k)].powi(2) - w[i]).abs() < 1e-13);
    }
}

#[test]
fn parts_of_very_large_rules_agree_with_the_asymptotic_ones() {
    let n = 1_000_001;
    let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
    gauss::legendre_asymptotic(&mut x, &mut w).expect("it is large");
    for first in [0, 1, 123_456, 400_000, 499_993] {
        let (mut nodes, mut weights) = ([0.0; 8], [0.0; 8]);
        gauss::legendre_part(n, first, &mut nodes, &mut weights).expect("there are so many");
        for k in 0..8 {
            let place = n / 2 + first + k;
            // 3 and 4 ulp of the asymptotic ones, half a one of the others.
            assert!((nodes[k] - x[place]).abs() <= 3.5 * f64::EPSILON * x[place], "node {first} + {k}");
            assert!((weights[k] - w[place]).abs() <= 4.5 * f64::EPSILON * w[place], "weight {first} + {k}");
        }
    }
}

#[test]
fn parts_of_a_rule_are_the_rule_to_the_last_bit() {
    for n in [1, 2, 7, 16, 17, 40, 101] {
        let (x, w) = legendre(n);
        for first in 0..n.div_ceil(2) {
            for count in 1..=n.div_ceil(2) - first {
                let (mut nodes, mut weights) = (vec![f64::NAN; count], vec![f64::NAN; count]);
                gauss::legendre_part(n, first, &mut nodes, &mut weights).expect("there are so many");
                let place = n / 2 + first..n / 2 + first + count;
                assert_eq!((&nodes[..], &weights[..]), (&x[place.clone()], &w[place]), "{n} {first} {count}");
            }
        }
        let (mut nodes, mut weights) = ([0.0; 60], [0.0; 60]);
        assert_eq!(gauss::legendre_part(n, 0, &mut nodes, &mut weights), Err(RuleError::Beyond));
    }
}

#[test]
fn bad_arguments_are_refused_and_nothing_is_written() {
    for (alpha, beta) in [(-1.0, 0.0), (-1.5, 0.0), (f64::NAN, 0.0), (f64::INFINITY, 0.0), (257.0, 0.0)] {
        assert_eq!(Weight::new(alpha, beta), Err(WeightError::Alpha));
        assert_eq!(Weight::new(beta, alpha), Err(WeightError::Beta));
    }
    let (mut x, mut w, mut s) = ([7.0; 3], [7.0; 2], [7.0; 3]);
    assert_eq!(gauss::legendre(&mut x, &mut w), Err(RuleError::Lengths));
    assert_eq!(gauss::jacobi(Weight::LEGENDRE, &mut x, &mut w), Err(RuleError::Lengths));
    assert_eq!(gauss::legendre_asymptotic(&mut x, &mut w), Err(RuleError::Lengths));
    assert_eq!(gauss::legendre_asymptotic(&mut x, &mut s), Err(RuleError::TooSmall));
    assert_eq!((x, w, s), ([7.0; 3], [7.0; 2], [7.0; 3]));
    assert_eq!(gauss::legendre(&mut [], &mut []), Err(RuleError::Empty));
    assert_eq!(gauss::jacobi(Weight::LEGENDRE, &mut [], &mut []), Err(RuleError::Empty));
}

#[test]
fn exponents_near_minus_one_give_a_rule_or_an_error_but_no_wrong_number() {
    for k in 2..=16 {
        let alpha = -1.0 + 0.1f64.powi(k);
        for (beta, n) in
            [(0.3, 1), (0.3, 2), (0.3, 5), (2.0, 20), (alpha, 1), (alpha, 5), (alpha, 20), (0.0, 101)]
        {
            let weight = Weight::new(alpha, beta).expect("a weight");
            let (mut x, mut w) = (vec![7.0; n], vec![7.0; n]);
            match gauss::jacobi(weight, &mut x, &mut w) {
                Ok(()) => {
                    let (nodes, weights) = against_oracle(alpha, beta, &integral(alpha, beta), &(x, w));
                    assert!(
                        nodes <= 0.55 && weights <= 2.0,
                        "({alpha}, {beta}), n = {n}: {nodes}, {weights} ulp"
                    );
                }
                Err(error) => {
                    assert_eq!(error, RuleError::NearEnd);
                    assert!(k > 4, "({alpha}, {beta}), n = {n} is refused");
                    assert!(x.iter().chain(&w).all(|v| *v == 7.0));
                }
            }
        }
    }
}

#[test]
fn weights_too_small_for_floats_are_zero_and_the_others_sum_up() {
    for (alpha, beta) in [(256.0, 0.0), (0.5, 256.0), (256.0, 256.0)] {
        let (x, w) = jacobi_rule(alpha, beta, 1000);
        let total = Weight::new(alpha, beta).expect("a weight").integral();
        assert!(w.iter().all(|w| *w >= 0.0) && w.contains(&0.0));
        assert!((w.iter().sum::<f64>() / total - 1.0).abs() < 1e-14);
        assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

#[test]
fn exponents_next_to_an_integer_have_the_integral_of_the_integer() {
    for (alpha, beta, exact) in [(0.0, 0.0, 2.0), (1.0, 0.0, 2.0), (2.0, 2.0, 16.0 / 15.0)] {
        for tiny in [f64::from_bits(1), 1e-300, 1e-20] {
            for (alpha, beta) in [(alpha + tiny, beta), (alpha, beta - tiny)] {
                assert_eq!(Weight::new(alpha, beta).expect("a weight").integral(), exact);
            }
        }
    }
}

#[test]
fn rules_integrate_monomials_up_to_twice_their_size_and_no_further() {
    for n in 1..=12usize {
        let (x, w) = jacobi_rule(0.0, 2.0, n);
        let sum = |k: usize| x.iter().zip(&w).map(|(x, w)| w * x.powi(k as i32)).sum::<f64>();
        // ∫ xᵏ (1 + 2x + x²) dx.
        let even = |k: usize| if k.is_multiple_of(2) { 2.0 / (k + 1) as f64 } else { 0.0 };
        let exact = |k: usize| even(k) + 2.0 * even(k + 1) + even(k + 2);
        for k in 0..2 * n {
            assert!((sum(k) - exact(k)).abs() < 1e-15, "n = {n}, x^{k}");
        }
        // The error at degree 2n is ‖π_n‖², by definition of the rule.
        assert!(exact(2 * n) - sum(2 * n) > 0.5f64.powi(2 * n as i32 + 2), "n = {n}");
    }
}

fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -0.99..6.0f64, 1 => Just(0.0), 1 => Just(-0.5), 1 => 6.0..60.0f64]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn nodes_and_weights_of_any_exponents_are_correctly_rounded(
        alpha in exponent(), beta in exponent(), n in 1usize..40
    ) {
        let rule = jacobi_rule(alpha, beta, n);
        let (nodes, weights) = against_oracle(alpha, beta, &integral(alpha, beta), &rule);
        prop_assert!(nodes <= 0.55, "nodes {nodes} ulp");
        prop_assert!(weights <= 0.55, "weights {weights} ulp");
    }

    #[test]
    fn rules_are_exact_to_2n_minus_1_and_not_to_2n(alpha in exponent(), beta in exponent(), n in 1usize..40) {
        let weight = Weight::new(alpha, beta).expect("a weight");
        let (x, w) = jacobi_rule(alpha, beta, n);
        let mut p = vec![0.0; n + 1];
        let mut gram = vec![0.0; (n + 1) * (n + 1)];
        for (&x, &w) in x.iter().zip(&w) {
            jacobi::orthonormal(weight, x, &mut p);
            for i in 0..=n {
                for j in 0..=n {
                    gram[i * (n + 1) + j] += w * p[i] * p[j];
                }
            }
        }
        for i in 0..=n {
            for j in 0..=n {
                // Degree i + j ≤ 2n − 1 is integrated: δ_ij. p_n² is not: π_n vanishes at every node.
                let exact = if i == j && i < n { 1.0 } else { 0.0 };
                prop_assert!((gram[i * (n + 1) + j] - exact).abs() < 1e-12, "<p_{i}, p_{j}> = {}", gram[i * (n + 1) + j]);
            }
        }
    }

    #[test]
    fn weights_are_positive_and_sum_to_the_integral(alpha in exponent(), beta in exponent(), n in 1usize..80) {
        let (x, w) = jacobi_rule(alpha, beta, n);
        let total = Weight::new(alpha, beta).expect("a weight").integral();
        prop_assert!(w.iter().all(|w| *w > 0.0));
        prop_assert!((w.iter().sum::<f64>() / total - 1.0).abs() < 1e-14);
        prop_assert!(x.iter().all(|x| x.abs() < 1.0));
        prop_assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn exchanged_exponents_mirror_the_rule(alpha in exponent(), beta in exponent(), n in 1usize..40) {
        let (x, w) = jacobi_rule(alpha, beta, n);
        let (mirrored, weights) = jacobi_rule(beta, alpha, n);
        for i in 0..n {
            prop_assert_eq!(x[i], -mirrored[n - 1 - i]);
            prop_assert_eq!(w[i], weights[n - 1 - i]);
        }
    }

    #[test]
    fn nodes_of_neighbouring_sizes_interlace(alpha in exponent(), beta in exponent(), n in 1usize..60) {
        let (few, _) = jacobi_rule(alpha, beta, n);
        let (more, _) = jacobi_rule(alpha, beta, n + 1);
        for i in 0..n {
            prop_assert!(more[i] < few[i] && few[i] < more[i + 1]);
        }
    }
}

#[test]
fn a_thousand_points_stay_within_an_ulp() {
    // Every 37th node; big integers are slow.
    let n = 1000;
    for (alpha, beta) in [(0.0, 0.0), (0.0, 2.0)] {
        let (x, w) = jacobi_rule(alpha, beta, n);
        let mu_0 = integer_integral(alpha as i64, beta as i64);
        let oracle = Oracle::new(alpha, beta, n);
        for i in (0..n).step_by(37) {
            let (root, share) = oracle.root(x[i]);
            assert!(
                root.ulps(x[i]) <= 1.0 && (&mu_0 * &share).ulps(w[i]) <= 1.0,
                "({alpha}, {beta}), node {i}"
            );
        }
    }
    assert_eq!(legendre(n), jacobi_rule(0.0, 0.0, n));
}

#[test]
fn the_middle_of_an_odd_uneven_rule_is_not_zero() {
    // Only α = β pins the middle node: P_3^(0,2) has its second root near 0.306.
    let of_three = |table: &serde_json::Value| number(table, "beta") == 2.0 && integer(table, "n") == 3;
    let table = tables("gauss_jacobi.json").into_iter().find(of_three).expect("a rule of three points");
    assert_eq!(jacobi_rule(0.0, 2.0, 3).0[1], floats(&table, "x")[1]);
}
