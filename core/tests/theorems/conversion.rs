//! Jacobi to Legendre and back, against big integers, tables and closed forms.
//!
//! d = A c. Errors are measured entry by entry in ε of what the condition allows: of |A| |c| there, of |A⁻¹|
//! |d| back.

use proptest::prelude::*;
use radiosity_core::convert;
use radiosity_core::jacobi::{self, Weight};
use radiosity_core::legendre;

use crate::tables::{decimals, integer, tables};
use radiosity_test_support::connection::{Connection, norm};
use radiosity_test_support::oracle::Fixed;

const N: usize = 31;

/// The exponents that are looked at closely.
const PAIRS: [(u8, u8); 10] =
    [(0, 1), (1, 0), (1, 1), (2, 2), (3, 7), (7, 3), (5, 5), (10, 10), (0, 10), (20, 20)];

/// Degrees to 100.
const MANY: usize = 101;

fn to_legendre(a: u8, b: u8, c: &[f64]) -> Vec<f64> {
    let mut d = c.to_vec();
    convert::to_legendre(a, b, &mut d);
    d
}

fn from_legendre(a: u8, b: u8, d: &[f64]) -> Vec<f64> {
    let mut c = d.to_vec();
    convert::from_legendre(a, b, &mut c);
    c
}

fn unit(n: usize, length: usize) -> Vec<f64> {
    (0..length).map(|k| f64::from(u8::from(k == n))).collect()
}

fn exactly(v: &[f64]) -> Vec<Fixed> {
    v.iter().map(|&v| Fixed::float(v)).collect()
}

/// `length` numbers in (−1, 1) by Knuth's linear congruential generator.
fn random(seed: u64, length: usize) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / f64::from(1u32 << 26) / f64::from(1u32 << 26) - 1.0
    };
    (0..length).map(|_| next()).collect()
}

/// Largest remainder of the big integers where the exact number is 0.
const NOTHING: f64 = 1e-60;

/// The largest error of `ours` in ε of `size`, entry by entry; where the size is 0, there must be no error.
fn worst(ours: &[f64], exact: &[Fixed], size: &[Fixed]) -> f64 {
    let errors = ours.iter().zip(exact).zip(size).map(|((&v, exact), size)| match size.to_f64() {
        size if size > NOTHING => (Fixed::float(v) - exact.clone()).to_f64().abs() / size / f64::EPSILON,
        _ if v == 0.0 => 0.0,
        _ => f64::INFINITY,
    });
    errors.fold(0.0, f64::max)
}

/// The error of A c in ε of |A| |c|.
fn error_there(a: u8, b: u8, c: &[f64]) -> f64 {
    let (connection, exact) = (Connection::new(a, b), exactly(c));
    worst(&to_legendre(a, b, c), &connection.apply(&exact), &connection.size(&exact))
}

/// The error of A⁻¹ d in ε of |A⁻¹| |d|, for a = b or one of them 0.
fn error_back(a: u8, b: u8, d: &[f64]) -> f64 {
    let (connection, exact) = (Connection::new(a, b), exactly(d));
    let size = connection.inverse_size(&exact).expect("definite signs");
    worst(&from_legendre(a, b, d), &connection.apply_inverse(&exact), &size)
}

/// p_n^(a,b)(1) = C(n + a, n)/‖P_n^(a,b)‖.
fn end(a: usize, b: usize, n: usize) -> Fixed {
    let classical = (1..=a).fold(Fixed::new(1), |v, j| v.times((n + j) as i64, j as i64));
    &classical / &norm(a, b, n)
}

/// p_n^(m,m)(0) for even n, from P_{k+2}(0)/P_k(0) = −(k + m + 1)(k + m + 2)/((k + 2)(k + 2m + 2)).
fn middle(m: usize, n: usize) -> Fixed {
    let classical = (0..n).step_by(2).fold(Fixed::new(1), |v, k| {
        v.times(-(((k + m + 1) * (k + m + 2)) as i64), ((k + 2) * (k + 2 * m + 2)) as i64)
    });
    &classical / &norm(m, m, n)
}

/// The relative error of Σ_k v_k p_k(x) in ε, from the functions that are not 0; all terms have one sign.
fn error_of_sum(v: &[f64], p: impl Fn(usize) -> Fixed, exact: &Fixed) -> f64 {
    let terms = v.iter().enumerate().filter(|(_, v)| **v != 0.0);
    let sum = terms.fold(Fixed::new(0), |sum, (k, &v)| sum + &Fixed::float(v) * &p(k));
    (sum - exact.clone()).to_f64().abs() / exact.to_f64().abs() / f64::EPSILON
}

#[test]
fn signs_are_those_of_rows_and_columns() {
    for (a, b) in PAIRS {
        let connection = Connection::new(a, b);
        for n in (0..40).step_by(3) {
            let column = exactly(&unit(n, n + 1));
            for (k, entry) in connection.apply(&column).iter().enumerate() {
                let sign = connection.sign(n) * connection.sign(k);
                assert!(sign as f64 * entry.to_f64() > -NOTHING, "({a}, {b}), {k}, {n}: {}", entry.to_f64());
            }
            for (k, entry) in connection.apply_inverse(&column).iter().enumerate() {
                let Some(sign) = connection.inverse_sign(n) else { continue };
                let sign = sign * connection.inverse_sign(k).expect("as in the column");
                assert!(sign as f64 * entry.to_f64() > -NOTHING, "({a}, {b}), {k}, {n}: {}", entry.to_f64());
            }
        }
    }
}

#[test]
fn legendre_coefficients_are_right_to_twelve_eps() {
    for (a, b) in PAIRS {
        for length in [1, 2, 3, 16, 31, 61, MANY] {
            for c in [unit(length - 1, length), random(1, length), random(2, length)] {
                let error = error_there(a, b, &c);
                assert!(error <= 12.0, "({a}, {b}), {length} coefficients: {error} ε");
            }
        }
    }
}

#[test]
fn legendre_coefficients_are_right_for_all_exponents_to_twenty() {
    for a in 0..=20 {
        for b in 0..=20 {
            let error = error_there(a, b, &random(u64::from(a) << 8 | u64::from(b), MANY));
            assert!(error <= 12.0, "({a}, {b}): {error} ε");
        }
    }
}

#[test]
fn jacobi_coefficients_are_right_to_twelve_eps() {
    let ends = (1..=20).flat_map(|m| [(m, m), (0, m), (m, 0)]);
    for (a, b) in ends {
        for d in [random(4, MANY), unit(MANY - 1, MANY)] {
            let error = error_back(a, b, &d);
            assert!(error <= 12.0, "({a}, {b}): {error} ε");
        }
    }
}

#[test]
fn jacobi_coefficients_are_right_to_twelve_eps_of_the_largest_where_signs_are_mixed() {
    for (a, b) in [(1, 2), (2, 1), (3, 7), (7, 3), (20, 9), (9, 20)] {
        let connection = Connection::new(a, b);
        let columns: Vec<Vec<Fixed>> =
            (0..61).map(|n| connection.apply_inverse(&exactly(&unit(n, 61)))).collect();
        let largest = |d: &[Fixed]| {
            let row = |k: usize| (0..61).fold(Fixed::new(0), |sum, n| sum + (&columns[n][k] * &d[n]).abs());
            (0..61).map(|k| row(k).to_f64()).fold(0.0, f64::max)
        };
        for d in [random(5, 61), random(6, 61), unit(60, 61), unit(33, 61)] {
            let exact = connection.apply_inverse(&exactly(&d));
            let limit = 12.0 * f64::EPSILON * largest(&exactly(&d));
            for (ours, exact) in from_legendre(a, b, &d).iter().zip(exact) {
                let error = (Fixed::float(*ours) - exact).abs().to_f64();
                assert!(error <= limit, "({a}, {b}): {error} for {limit}");
            }
        }
    }
}

#[test]
fn large_degrees_and_exponents_stay_in_range() {
    // Columns of A with positive entries up to 1e294, by p_n^(a,b)(1) = Σ_k A_kn p_k(1).
    for (a, b, n) in
        [(2, 2, 3000), (60, 60, 3000), (255, 0, 1700), (255, 127, 2000), (255, 255, 100), (255, 255, 2500)]
    {
        let column = to_legendre(a, b, &unit(n, n + 1));
        let error = error_of_sum(&column, |k| end(0, 0, k), &end(a.into(), b.into(), n));
        assert!(error <= 12.0, "({a}, {b}), {n}: {error} ε");
    }
    // Columns of A⁻¹ for (0, b), by p_n(1) = Σ_k (A⁻¹)_kn p_k^(0,b)(1).
    for (b, n) in [(2, 3000), (127, 3000), (255, 1700)] {
        let column = from_legendre(0, b, &unit(n, n + 1));
        let error = error_of_sum(&column, |k| end(0, b.into(), k), &end(0, 0, n));
        assert!(error <= 12.0, "(0, {b}), {n}: {error} ε");
    }
    // Columns of A⁻¹ for (m, m), by p_n(0) = Σ_k (A⁻¹)_kn p_k^(m,m)(0).
    for (m, n) in [(2, 3000), (127, 3000), (255, 2500)] {
        let column = from_legendre(m, m, &unit(n, n + 1));
        let error = error_of_sum(&column, |k| middle(m.into(), k), &middle(0, n));
        assert!(error <= 12.0, "({m}, {m}), {n}: {error} ε");
    }
}

#[test]
fn the_highest_degree_loses_nothing_however_high() {
    // A_nn = Π_{j=1…a+b} (2n + j)/(n + j) · ‖P_n‖/‖P_n^(a,b)‖, by the leading coefficients.
    for (a, b) in [(0, 1), (1, 1), (0, 2), (2, 2), (3, 2)] {
        for n in (0..4000).step_by(97) {
            let leading = (1..=a + b).fold(norm(0, 0, n), |v, j| v.times((2 * n + j) as i64, (n + j) as i64));
            let exact = &leading / &norm(a, b, n);
            let mut c = unit(n, n + 1);
            convert::to_legendre(a as u8, b as u8, &mut c);
            let error = exact.ulps(c[n]);
            assert!(error <= 3.0, "({a}, {b}), {n}: {error} ulp");
        }
    }
}

#[test]
fn mirrored_weights_turn_signs() {
    // p_n^(a,b)(−x) = (−1)ⁿ p_n^(b,a)(x), bit for bit.
    let turned = |v: Vec<f64>| -> Vec<f64> {
        v.iter().enumerate().map(|(n, v)| if n % 2 == 1 { -v } else { *v }).collect()
    };
    let c = random(8, MANY);
    for (a, b) in PAIRS {
        assert_eq!(to_legendre(b, a, &turned(c.clone())), turned(to_legendre(a, b, &c)), "({a}, {b})");
        assert_eq!(from_legendre(b, a, &turned(c.clone())), turned(from_legendre(a, b, &c)), "({a}, {b})");
    }
}

#[test]
fn legendre_coefficients_stay_as_they_are_for_the_weight_1() {
    let c = random(7, MANY);
    assert_eq!(to_legendre(0, 0, &c), c);
    assert_eq!(from_legendre(0, 0, &c), c);
}

#[test]
fn even_and_odd_stay_apart() {
    for m in (0..=20).chain([60, 255]) {
        for turn in [to_legendre, from_legendre] {
            for odd in 0..2 {
                let half: Vec<f64> = random(3, MANY)
                    .iter()
                    .enumerate()
                    .map(|(n, &c)| if n % 2 == odd { c } else { 0.0 })
                    .collect();
                let turned = turn(m, m, &half);
                assert!(turned.iter().skip(1 - odd).step_by(2).all(|d| d.to_bits() == 0), "({m}, {m})");
                assert!(turned.iter().skip(odd).step_by(2).all(|&d| d != 0.0), "({m}, {m})");
            }
        }
    }
}

#[test]
fn unit_vectors_convert_to_two_in_1e15() {
    for table in tables("jacobi_to_legendre.json") {
        let (a, b) = (integer(&table, "alpha") as u8, integer(&table, "beta") as u8);
        for row in table["rows"].as_array().expect("rows") {
            let n = integer(row, "n");
            let exact: Vec<f64> = decimals(row, "c").iter().map(|c| c.parse().expect("a float")).collect();
            let size = exact.iter().fold(0.0f64, |size, c| size.max(c.abs()));
            let mut unit = [0.0; N];
            unit[n] = 1.0;
            convert::to_legendre(a, b, &mut unit);
            for k in 0..=n {
                assert!(
                    (unit[k] - exact[k]).abs() <= 2e-15 * size,
                    "({a}, {b}), {n}: {} {}",
                    unit[k],
                    exact[k]
                );
            }
        }
    }
}

/// 2ⁿ P_n^(a,b) = Σ_m C(n + a, m) C(n + b, n − m) (x − 1)^{n−m} (x + 1)^m as coefficients of powers of x,
/// exactly.
fn powers(a: u32, b: u32, n: u32) -> Vec<i128> {
    let binomial = |n: u32, k: u32| (0..k).fold(1i128, |v, j| v * i128::from(n - j) / i128::from(j + 1));
    let mut sum = vec![0i128; n as usize + 1];
    for m in 0..=n {
        let mut product = vec![binomial(n + a, m) * binomial(n + b, n - m)];
        for factor in 0..n {
            let root = if factor < n - m { -1 } else { 1 };
            product.push(0);
            for k in (0..product.len()).rev() {
                let shifted = if k > 0 { product[k - 1] } else { 0 };
                product[k] = root * product[k] + shifted;
            }
        }
        sum.iter_mut().zip(&product).for_each(|(sum, term)| *sum += term);
    }
    sum
}

/// ∫ xᵐ p_k dx = √(k + ½) · 2 m! / ((m − k)!! (m + k + 1)!!) for m − k even, else 0.
fn power_in_legendre(m: usize, k: usize) -> f64 {
    if k > m || (m - k) % 2 == 1 {
        return 0.0;
    }
    let above: f64 = (1..=m).map(|j| j as f64).product();
    let even: f64 = (2..=m - k).step_by(2).map(|j| j as f64).product();
    let odd: f64 = (1..=m + k + 1).step_by(2).map(|j| j as f64).product();
    (k as f64 + 0.5).sqrt() * 2.0 * above / even / odd
}

#[test]
fn powers_of_x_lose_nine_digits_where_the_steps_lose_none() {
    let table = tables("jacobi_to_legendre.json").into_iter().find(|table| integer(table, "beta") == 2);
    let table = table.expect("the table of (0, 2)");
    let row = table["rows"].as_array().expect("rows").last().expect("a row").clone();
    let exact: Vec<f64> = decimals(&row, "c").iter().map(|c| c.parse().expect("a float")).collect();
    // p_30^(0,2) in powers of x, every coefficient rounded once, and from there to Legendre.
    let norm = (8.0f64 / 63.0).sqrt() * 2.0f64.powi(30);
    let by_powers: Vec<f64> = powers(0, 2, 30).iter().map(|&c| c as f64 / norm).collect();
    let route = |k: usize| (0..=30).map(|m| by_powers[m] * power_in_legendre(m, k)).sum::<f64>();
    let worst = |ours: &dyn Fn(usize) -> f64| (0..=30).fold(0.0f64, |w, k| w.max((ours(k) - exact[k]).abs()));
    let size = exact.iter().fold(0.0f64, |size, c| size.max(c.abs()));
    let by_steps = |n: usize| {
        let mut unit = [0.0; N];
        unit[n] = 1.0;
        convert::to_legendre(0, 2, &mut unit);
        unit
    };
    assert!(worst(&route) > 1e-9 * size, "{}", worst(&route));
    assert!(worst(&|k| by_steps(30)[k]) < 2e-15 * size);
    // The formulas of the route themselves are right: degree 2 needs no digits.
    let low: Vec<f64> = powers(0, 2, 2).iter().map(|&c| c as f64 / (4.0 * (8.0f64 / 7.0).sqrt())).collect();
    for k in 0..3 {
        let ours: f64 = (0..3).map(|m| low[m] * power_in_legendre(m, k)).sum();
        assert!((ours - by_steps(2)[k]).abs() < 1e-14);
    }
}

/// Up to 101 coefficients of many sizes.
fn coefficients() -> impl Strategy<Value = Vec<f64>> {
    let coefficient = (-1.0..1.0f64, -40..40i32).prop_map(|(c, e)| c * 2.0f64.powi(e));
    prop::collection::vec(coefficient, 0..=MANY)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_coefficients_convert_to_twelve_eps(c in coefficients(), a in 0u8..=20, b in 0u8..=20) {
        let error = error_there(a, b, &c);
        prop_assert!(error <= 12.0, "({a}, {b}): {error} ε");
    }

    #[test]
    fn any_coefficients_convert_back_to_twelve_eps(d in coefficients(), m in 0u8..=20, kind in 0..3) {
        let (a, b) = [(m, m), (m, 0), (0, m)][kind as usize];
        let error = error_back(a, b, &d);
        prop_assert!(error <= 12.0, "({a}, {b}): {error} ε");
    }

    #[test]
    fn there_and_back_keeps_what_the_condition_allows(
        c in coefficients(), m in 0u8..=20, kind in 0..3
    ) {
        let (a, b) = [(m, m), (m, 0), (0, m)][kind as usize];
        let (connection, exact) = (Connection::new(a, b), exactly(&c));
        let size = connection.inverse_size(&connection.size(&exact)).expect("definite signs");
        let error = worst(&from_legendre(a, b, &to_legendre(a, b, &c)), &exact, &size);
        prop_assert!(error <= 24.0, "({a}, {b}): {error} ε");
    }

    #[test]
    fn conversion_leaves_the_function_alone(
        c in prop::array::uniform16(-1.0..1.0f64), a in 0u8..=20, b in 0u8..=20, x in -1.0..=1.0f64
    ) {
        let (mut p, mut q) = ([0.0; 16], [0.0; 16]);
        jacobi::orthonormal(Weight::integer(a, b), x, &mut p);
        legendre::orthonormal(x, &mut q);
        let d = to_legendre(a, b, &c);
        let sum = |c: &[f64], p: &[f64; 16]| c.iter().zip(p).map(|(c, p)| c * p).sum::<f64>();
        let size = |c: &[f64], p: &[f64; 16]| c.iter().zip(p).map(|(c, p)| (c * p).abs()).sum::<f64>();
        let allowed = 1e-13 * (size(&c, &p) + size(&d, &q));
        prop_assert!((sum(&c, &p) - sum(&d, &q)).abs() <= allowed, "({a}, {b}) at {x}");
    }
}
