//! Bases of the square and the triangle: orthonormality, order, gradients, tiles, and the collapsed rule.

use proptest::prelude::*;
use radiosity_core::basis::triangle::{Collapsed, WeightedPoint};
use radiosity_core::basis::{tensor, total, triangle};
use radiosity_core::gauss::Rule;
use radiosity_core::jacobi::{self, Weight};

use crate::tables::{decimals, integer, tables};
use radiosity_test_support::oracle::Fixed;

fn square<const N: usize>() -> Vec<WeightedPoint> {
    let rule = Rule::<N>::legendre();
    let pairs = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    let point = |(i, j): (usize, usize)| WeightedPoint {
        s: rule.nodes[i],
        t: rule.nodes[j],
        weight: rule.weights[i] * rule.weights[j],
    };
    pairs.map(point).collect()
}

fn assert_orthonormal(points: &[WeightedPoint], count: usize, values: impl Fn(f64, f64, &mut [f64])) {
    let mut gram = vec![0.0; count * count];
    let mut v = vec![0.0; count];
    for point in points {
        values(point.s, point.t, &mut v);
        for k in 0..count {
            for l in 0..count {
                gram[k * count + l] += point.weight * v[k] * v[l];
            }
        }
    }
    for k in 0..count {
        for l in 0..count {
            let exact = if k == l { 1.0 } else { 0.0 };
            assert!((gram[k * count + l] - exact).abs() < 1e-13, "<{k}, {l}> = {}", gram[k * count + l]);
        }
    }
}

#[test]
fn bases_are_orthonormal_on_their_domain() {
    assert_orthonormal(&square::<11>(), total::count(10), |s, t, v| total::values(10, s, t, v));
    let points: Vec<WeightedPoint> = Collapsed::<11>::new().points().collect();
    assert_orthonormal(&points, total::count(10), |s, t, v| triangle::values(10, s, t, v));
}

#[test]
fn square_products_agree_with_the_tables() {
    for table in tables("tensor2d.json") {
        let pair = |key: &str| {
            let exponents = table[key].as_array().expect("two exponents");
            Weight::new(exponents[0].as_f64().expect("a number"), exponents[1].as_f64().expect("a number"))
        };
        let order = integer(&table, "N");
        let coordinate = |key: &str| table[key].as_str().expect("a decimal").parse::<f64>().expect("a float");
        let (s, t) = (coordinate("s"), coordinate("t"));
        let (mut p, mut q) = (vec![0.0; order + 1], vec![0.0; order + 1]);
        jacobi::orthonormal(pair("s_ab").expect("a weight"), s, &mut p);
        jacobi::orthonormal(pair("t_ab").expect("a weight"), t, &mut q);
        let exact = decimals(&table, "v");
        assert_eq!(exact.len(), total::count(order));
        for (k, exact) in exact.iter().enumerate() {
            let (i, j) = total::degrees(k);
            let error = (Fixed::decimal(exact) - Fixed::float(p[i] * q[j])).to_f64();
            assert!(error.abs() < 2e-15, "({i}, {j}) at ({s}, {t}): {error}");
        }
    }
}

#[test]
fn positions_count_up_by_total_degree_and_invert() {
    let mut k = 0;
    for degree in 0..40 {
        for j in 0..=degree {
            assert_eq!(total::index(degree - j, j), k);
            assert_eq!(total::degrees(k), (degree - j, j));
            k += 1;
        }
        assert_eq!(total::count(degree), k);
    }
    for k in 0..tensor::count(6) {
        let (i, j) = tensor::degrees(6, k);
        assert_eq!(tensor::index(6, i, j), k);
    }
}

/// i! j!/(i + j + 2)! · 4 = ∬ ((1 + s)/2)ⁱ ((1 + t)/2)ʲ ds dt over the triangle.
fn moment(i: usize, j: usize) -> f64 {
    let binomial = (1..=j).fold(1.0, |v, k| v * k as f64 / (i + k) as f64);
    4.0 * binomial / ((i + j + 1) * (i + j + 2)) as f64
}

#[test]
fn the_collapsed_rule_is_exact_to_2n_minus_1_and_not_to_2n() {
    let rule = Collapsed::<5>::new();
    let error = |i: usize, j: usize| {
        let sum = |WeightedPoint { s, t, weight }| {
            weight * (0.5 * (1.0 + s)).powi(i as i32) * (0.5 * (1.0 + t)).powi(j as i32)
        };
        (rule.points().map(sum).sum::<f64>() - moment(i, j)).abs()
    };
    for degree in 0..10 {
        assert!((0..=degree).all(|j| error(degree - j, j) < 1e-15), "degree {degree}");
    }
    assert!((0..=10).any(|j| error(10 - j, j) > 1e-9));
    assert!(
        rule.points()
            .all(|WeightedPoint { s, t, weight }| s > -1.0 && t > -1.0 && s + t < 0.0 && weight > 0.0)
    );
}

#[test]
fn tiles_hold_the_values_of_single_points() {
    let s = [-0.9, -0.5, 0.0, 0.3, -0.2, 0.7, -0.99, 0.1];
    let t = [0.8, -0.5, -0.1, -0.4, 0.1, -0.8, 0.98, -0.2];
    let (mut of_total, mut of_triangle) = ([[0.0; 8]; 28], [[0.0; 8]; 28]);
    total::tile::<7, 8>(&s, &t, &mut of_total);
    triangle::tile(6, &s, &t, &mut of_triangle);
    let (mut v, mut w) = ([0.0; 28], [0.0; 28]);
    for l in 0..8 {
        total::values(6, s[l], t[l], &mut v);
        triangle::values(6, s[l], t[l], &mut w);
        assert!((0..28).all(|k| (of_total[k][l] - v[k]).abs() < 1e-13));
        assert!((0..28).all(|k| of_triangle[k][l] == w[k]));
    }
}

#[test]
fn the_triangle_basis_is_finite_at_the_collapsed_vertex() {
    let (mut v, mut by_s, mut by_t) = ([0.0; 66], [0.0; 66], [0.0; 66]);
    triangle::gradients(10, -1.0, 1.0, &mut v, &mut by_s, &mut by_t);
    assert!(v.iter().chain(&by_s).chain(&by_t).all(|v| v.is_finite()));
    // Only i = 0 survives there: √(½ (j + 1)) P_j^(1,0)(1) = √(½ (j + 1)) (j + 1).
    for (k, v) in v.iter().enumerate() {
        let (i, j) = total::degrees(k);
        let exact = if i == 0 { (0.5 * (j + 1) as f64).sqrt() * (j + 1) as f64 } else { 0.0 };
        assert!((v - exact).abs() < 1e-12, "({i}, {j})");
    }
}

#[test]
#[should_panic(expected = "one entry per function")]
fn a_slice_of_the_wrong_length_is_refused() {
    total::values(3, 0.0, 0.0, &mut [0.0; 9]);
}

/// Writes values and both derivatives at (s, t).
type Gradients = fn(usize, f64, f64, &mut [f64], &mut [f64], &mut [f64]);

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn gradients_are_slopes(s in -0.9..0.9f64, t in -0.9..0.9f64) {
        let order = 6;
        let bases: [(usize, Gradients); 2] = [
            (total::count(order), total::gradients),
            (total::count(order), triangle::gradients),
        ];
        for (count, gradients) in bases {
            let at = |s: f64, t: f64| {
                let (mut v, mut by_s, mut by_t) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
                gradients(order, s, t, &mut v, &mut by_s, &mut by_t);
                (v, by_s, by_t)
            };
            let h = 1e-5;
            let (_, by_s, by_t) = at(s, t);
            let ((right, ..), (left, ..)) = (at(s + h, t), at(s - h, t));
            let ((above, ..), (below, ..)) = (at(s, t + h), at(s, t - h));
            for k in 0..count {
                prop_assert!(((right[k] - left[k]) / (2.0 * h) - by_s[k]).abs() < 1e-4);
                prop_assert!(((above[k] - below[k]) / (2.0 * h) - by_t[k]).abs() < 1e-4);
            }
        }
    }
}
