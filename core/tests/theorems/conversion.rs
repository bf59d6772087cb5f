//! Jacobi to Legendre and back.

use proptest::prelude::*;
use radiosity_core::convert;
use radiosity_core::jacobi::{self, Weight};
use radiosity_core::legendre;

use crate::tables::{decimals, integer, tables};

const N: usize = 31;

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
            // Steps in two exponents lose a digit by n = 30.
            let limit = if a > 0 && b > 0 { 2e-14 } else { 2e-15 };
            for k in 0..=n {
                assert!(
                    (unit[k] - exact[k]).abs() <= limit * size,
                    "({a}, {b}), {n}: {} {}",
                    unit[k],
                    exact[k]
                );
            }
        }
    }
}

/// 2ⁿ P_n^(a,b) = Σ_m C(n + a, m) C(n + b, n − m) (x − 1)^{n−m} (x + 1)^m as coefficients of powers of x, exactly.
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

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn conversion_leaves_the_function_alone(
        c in prop::array::uniform16(-1.0..1.0f64), a in 0u8..4, b in 0u8..4, x in -1.0..=1.0f64
    ) {
        let (mut p, mut q) = ([0.0; 16], [0.0; 16]);
        jacobi::orthonormal(Weight::integer(a, b), x, &mut p);
        legendre::orthonormal(x, &mut q);
        let dot = |c: &[f64; 16], p: &[f64; 16]| c.iter().zip(p).map(|(c, p)| c * p).sum::<f64>();
        let mut by_steps = c;
        convert::to_legendre(a, b, &mut by_steps);
        let size = 1.0 + p.iter().map(|p| p.abs()).sum::<f64>();
        prop_assert!((dot(&c, &p) - dot(&by_steps, &q)).abs() < 1e-12 * size);
    }

    #[test]
    fn there_and_back_is_the_identity(c in prop::collection::vec(-1.0..1.0f64, 0..31), a in 0u8..4, b in 0u8..4) {
        let mut there = c.clone();
        convert::to_legendre(a, b, &mut there);
        convert::from_legendre(a, b, &mut there);
        for (back, c) in there.iter().zip(&c) {
            prop_assert!((back - c).abs() < 1e-10, "{back} and {c}");
        }
    }
}
