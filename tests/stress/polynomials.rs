//! Polynomials and Gauss rules to order 60, against their recurrences in double-double.
//!
//! ```text
//! (k + 1) P_k₊₁ = (2k + 1) x P_k − k P_k₋₁ ,    P′_k₊₁ = P′_k₋₁ + (2k + 1) P_k ,    p_k = √(k + ½) P_k
//! ```
//!
//! for Legendre's; those of Jacobi for the weight (1 − x)^a, as triangles have them, with
//! ‖P_k‖² = 2^(a + 1)/(2k + a + 1),
//!
//! ```text
//! 2 (k + 1)(k + a + 1)(2k + a) P_k₊₁ =
//!   (2k + a + 1) [(2k + a + 2)(2k + a) x + a²] P_k − 2 k (k + a)(2k + a + 2) P_k₋₁ .
//! ```
//!
//! Errors at degree k count in multiples of ε √(p_k² + p_k₋₁²): the zeros of p_k are not the place to ask for
//! relative ones.

use radiosity_core::basis::total;
use radiosity_core::jacobi::{self, Weight};
use radiosity_core::{gauss, legendre};

use crate::double::Double;
use crate::row::Row;
use radiosity_test_support::random::Random;

const HIGHEST: usize = 60;

fn whole(k: usize) -> Double {
    Double::from(k as f64)
}

/// P_k(x) and P′_k(x) for k ≤ `degree`.
fn plain(degree: usize, x: Double) -> [Vec<Double>; 2] {
    let (mut p, mut d) = (vec![Double::ONE, x], vec![Double::ZERO, Double::ONE]);
    for k in 1..degree {
        p.push((whole(2 * k + 1) * x * p[k] - whole(k) * p[k - 1]) / whole(k + 1));
        d.push(d[k - 1] + whole(2 * k + 1) * p[k]);
    }
    [p, d]
}

/// p_k(x) of the weight (1 − x)^a for k ≤ `degree`.
fn one_sided(degree: usize, a: usize, x: Double) -> Vec<Double> {
    let first = (whole(a + 2) * x + whole(a)) * Double::from(0.5);
    let mut p = vec![Double::ONE, first];
    for k in 1..degree {
        let middle = whole((2 * k + a + 2) * (2 * k + a)) * x + whole(a * a);
        let above =
            whole(2 * k + a + 1) * middle * p[k] - whole(2 * k * (k + a) * (2 * k + a + 2)) * p[k - 1];
        p.push(above / whole(2 * (k + 1) * (k + a + 1) * (2 * k + a)));
    }
    let norm = |k: usize| (Double::from(2f64.powi(a as i32 + 1)) / whole(2 * k + a + 1)).sqrt();
    p.into_iter().enumerate().map(|(k, p)| p / norm(k)).collect()
}

/// Points everywhere, and as close to the ends as floats come.
fn points(count: usize) -> Vec<f64> {
    let mut random = Random(1);
    let inside = (0..count).map(|_| random.between(-1.0, 1.0));
    let near = (1..=52).flat_map(|k| [1.0 - 0.5f64.powi(k), 0.5f64.powi(k) - 1.0]);
    inside.chain(near).chain([-1.0, 0.0, 1.0]).collect()
}

/// Adds the errors of `ours` in multiples of ε and the envelope of `exact`.
fn compare(row: &Row, ours: &[f64], exact: &[Double], x: f64) {
    for (k, (value, exact_value)) in ours.iter().zip(exact).enumerate() {
        let before = if k > 0 { exact[k - 1].to_f64() } else { 0.0 };
        let size = exact_value.to_f64().hypot(before) * f64::EPSILON;
        let error = (Double::from(*value) - *exact_value).abs().to_f64() / size;
        row.add(error, || format!("degree {k} at {x:e}"));
    }
}

fn values(count: usize) {
    let range = format!("degree ≤ {HIGHEST}, to the ends");
    let row = Row::new("Legendre polynomials", range.clone(), HIGHEST as f64, "ε");
    let slopes = Row::new("derivatives of Legendre polynomials", range, 2.0 * HIGHEST as f64, "ε");
    for x in points(count) {
        let (mut p, mut d) = ([0.0; HIGHEST + 1], [0.0; HIGHEST + 1]);
        legendre::orthonormal_with_derivatives(x, &mut p, &mut d);
        let scale = |(k, v): (usize, Double)| v * (whole(k) + Double::from(0.5)).sqrt();
        let [exact, exact_slopes] =
            plain(HIGHEST, Double::from(x)).map(|v| v.into_iter().enumerate().map(scale).collect::<Vec<_>>());
        compare(&row, &p, &exact, x);
        compare(&slopes, &d[1..], &exact_slopes[1..], x);
    }
}

fn triangles(count: usize) {
    let row = Row::new(
        "Jacobi polynomials, weight (1 − x)^a",
        format!("degree ≤ {HIGHEST}, a ≤ 121"),
        2.0 * HIGHEST as f64,
        "ε",
    );
    for (a, x) in [1, 3, 11, 41, 121].into_iter().flat_map(|a| points(count).into_iter().map(move |x| (a, x)))
    {
        let mut p = [0.0; HIGHEST + 1];
        jacobi::orthonormal(Weight::integer(a, 0), x, &mut p);
        compare(&row, &p, &one_sided(HIGHEST, usize::from(a), Double::from(x)), x);
    }
}

fn rules(counts: impl Iterator<Item = usize>) {
    let row = Row::new("Gauss–Legendre nodes and weights", "n ≤ 120", 1.0, "ε");
    for n in counts {
        let (mut nodes, mut weights) = (vec![0.0; n], vec![0.0; n]);
        gauss::legendre(&mut nodes, &mut weights).expect("slices are equal and not empty");
        for (x, w) in nodes.into_iter().zip(weights) {
            let mut exact = Double::from(x);
            for _ in 0..2 {
                let [p, d] = plain(n, exact);
                exact = exact - p[n] / d[n];
            }
            let slope = plain(n, exact)[1][n];
            let weight = Double::from(2.0) / ((Double::ONE - exact * exact) * slope * slope);
            let relative = |ours: f64, exact: Double| {
                let error = (Double::from(ours) - exact).abs().to_f64();
                if error > 0.0 { error / exact.abs().to_f64() / f64::EPSILON } else { 0.0 }
            };
            // The middle of an odd rule is 0 exactly, of which Newton's method leaves 1e-30 or so.
            let node = if x == 0.0 { exact.to_f64().abs() } else { relative(x, exact) };
            row.add(node.max(relative(w, weight)), || format!("n = {n}, node {x}"));
        }
    }
}

/// Products of two polynomials, as elements carry them.
fn products(count: usize) {
    let row =
        Row::new("basis functions of total degree", format!("order ≤ {HIGHEST}"), 2.0 * HIGHEST as f64, "ε");
    let mut out = vec![0.0; total::count(HIGHEST)];
    let places = points(count);
    for (s, t) in places.iter().zip(places.iter().rev()) {
        total::values(HIGHEST, *s, *t, &mut out);
        let [p, q] = [*s, *t].map(|x| plain(HIGHEST, Double::from(x))[0].clone());
        let [p, q] = [p, q].map(|v| {
            let scaled = |(k, v)| v * (whole(k) + Double::from(0.5)).sqrt();
            v.into_iter().enumerate().map(scaled).collect::<Vec<Double>>()
        });
        let size = |v: &[Double], k: usize| v[k].to_f64().hypot(if k > 0 { v[k - 1].to_f64() } else { 0.0 });
        for (k, ours) in out.iter().enumerate() {
            let (i, j) = total::degrees(k);
            let error = (Double::from(*ours) - p[i] * q[j]).abs().to_f64() / (size(&p, i) * size(&q, j));
            row.add(error / f64::EPSILON, || format!("degrees {i}, {j} at {s:e}, {t:e}"));
        }
    }
}

#[test]
fn polynomials_keep_their_digits() {
    values(20);
    triangles(5);
    rules([1, 2, 5, 20, 61].into_iter());
    products(2);
}

#[test]
#[ignore = "many cases"]
fn polynomials_keep_their_digits_everywhere() {
    values(2000);
    triangles(500);
    rules(1..=120);
    products(200);
}
