//! Derivative, mass and two-scale matrices of the Legendre basis.

use proptest::prelude::*;
use radiosity_core::gauss::Rule;
use radiosity_core::jacobi::Weight;
use radiosity_core::legendre::{self, Half};

const N: usize = 12;

fn basis(x: f64) -> [f64; N] {
    let mut p = [0.0; N];
    legendre::orthonormal(x, &mut p);
    p
}

#[test]
fn halves_together_keep_lengths() {
    let [left, right] = [Half::Left, Half::Right].map(legendre::two_scale::<N>);
    for n in 0..N {
        for m in 0..N {
            let product = |h: &[[f64; N]; N]| (0..N).map(|k| h[n][k] * h[m][k]).sum::<f64>();
            let exact = if n == m { 2.0 } else { 0.0 };
            assert!((product(&left) + product(&right) - exact).abs() < 1e-14);
            let sign = if (n + m) % 2 == 0 { 1.0 } else { -1.0 };
            assert_eq!(left[n][m], sign * right[n][m]);
        }
    }
}

#[test]
fn the_mass_matrix_without_a_weight_is_the_identity_and_with_one_a_moment() {
    let one = legendre::mass::<N>(Weight::LEGENDRE);
    // ∫ p_m p_n (1 + x): the identity plus multiplication by x, whose entries are n/√(4n² − 1).
    let linear = legendre::mass::<N>(Weight::integer(0, 1));
    for m in 0..N {
        for n in 0..N {
            let delta = if m == n { 1.0 } else { 0.0 };
            let k = m.max(n) as f64;
            let by_x = if m.abs_diff(n) == 1 { k / (4.0 * k * k - 1.0).sqrt() } else { 0.0 };
            assert!((one[m][n] - delta).abs() < 1e-14);
            assert!((linear[m][n] - delta - by_x).abs() < 1e-14);
        }
    }
}

#[test]
fn derivatives_integrate_to_the_difference_of_the_ends() {
    // ∫ p_n′ p_k dx, by a rule exact for it, is D[n][k].
    let matrix = legendre::derivative::<N>();
    let rule = Rule::<N>::legendre();
    for n in 0..N {
        for k in 0..N {
            let entry = rule.sum(|x| {
                let (mut p, mut d) = ([0.0; N], [0.0; N]);
                legendre::orthonormal_with_derivatives(x, &mut p, &mut d);
                d[n] * p[k]
            });
            assert!((entry - matrix[n][k]).abs() < 1e-12, "D[{n}][{k}]");
        }
    }
}

proptest! {
    #[test]
    fn children_continue_the_parent(t in -1.0..=1.0f64) {
        for (half, centre) in [(Half::Left, -1.0), (Half::Right, 1.0)] {
            let matrix = legendre::two_scale::<N>(half);
            let (parent, child) = (basis(0.5 * (t + centre)), basis(t));
            for n in 0..N {
                let sum: f64 = (0..N).map(|m| matrix[n][m] * child[m]).sum();
                prop_assert!((sum - parent[n]).abs() < 1e-14 * (n + 1) as f64 * 2.0);
            }
        }
    }

    #[test]
    fn derivative_coefficients_evaluate_to_the_derivative(f in prop::array::uniform12(-1.0..1.0f64), x in -1.0..=1.0f64) {
        let matrix = legendre::derivative::<N>();
        let mut slopes = [0.0; N];
        for (n, f) in f.iter().enumerate() {
            for k in 0..N {
                slopes[k] += f * matrix[n][k];
            }
        }
        let (mut p, mut d) = ([0.0; N], [0.0; N]);
        legendre::orthonormal_with_derivatives(x, &mut p, &mut d);
        let exact: f64 = f.iter().zip(&d).map(|(f, d)| f * d).sum();
        prop_assert!((legendre::sum(&slopes, x) - exact).abs() < 1e-11);
    }
}
