//! Prints how many digits this crate keeps, next to figures measured for other libraries.
//!
//!     cargo run --release -p radiosity-studies --bin core_accuracy
//!
//! Ours are measured by this program, against big integers. Those of others were measured once, over the same
//! sizes: nodes in ulp, weights relative in ε, which is between half an ulp and one.

use std::io::{self, Write};

use radiosity_core::convert;
use radiosity_core::gauss;
use radiosity_core::jacobi::{Polynomials, Weight};
use radiosity_core::legendre;
use radiosity_test_support::connection::Connection;
use radiosity_test_support::oracle::{Fixed, Oracle, integral};

/// The worst error of nodes and weights in ulp over some rules; at most 40 nodes of each are looked at.
fn rules(
    exponents: &[(f64, f64)],
    sizes: &[usize],
    write: impl Fn(Weight, &mut [f64], &mut [f64]),
) -> (f64, f64) {
    let mut worst = (0.0f64, 0.0f64);
    for &(alpha, beta) in exponents {
        let weight = Weight::new(alpha, beta).expect("exponents above −1");
        let mu_0 = integral(alpha, beta);
        for &n in sizes {
            let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
            write(weight, &mut x, &mut w);
            let oracle = Oracle::new(alpha, beta, n);
            for i in (0..n).step_by(n.div_ceil(40)).filter(|&i| x[i] != 0.0) {
                let (root, share) = oracle.root(x[i]);
                worst.0 = worst.0.max(root.ulps(x[i]));
                worst.1 = worst.1.max((&mu_0 * &share).ulps(w[i]));
            }
        }
    }
    worst
}

/// The worst error of p_n(x), n ≤ 32, in ε of √(p_n² + p_{n−1}²).
fn values(alpha: f64, beta: f64) -> f64 {
    let weight = Weight::new(alpha, beta).expect("exponents above −1");
    let table = Polynomials::<33>::new(weight);
    let mut worst = 0.0f64;
    for i in 0..=60 {
        // Dense towards both ends, the last points one bit from ±1.
        let near = 1.0 - 0.5f64.powi(i - 7);
        let x = if i < 15 {
            -0.98 + 0.14 * f64::from(i)
        } else if i % 2 == 0 {
            near
        } else {
            -near
        };
        let mut p = [0.0; 33];
        table.values(x, &mut p);
        for n in [1, 2, 3, 5, 8, 13, 20, 32] {
            let oracle = Oracle::new(alpha, beta, n);
            let norm = (oracle.squared_norm().to_f64() * weight.integral()).sqrt();
            let exact = oracle.value(&Fixed::float(x)).to_f64() / norm;
            worst = worst.max((p[n] - exact).abs() / p[n].hypot(p[n - 1]) / f64::EPSILON);
        }
    }
    worst
}

/// Worst errors of conversions of coefficients in (−1, 1), in ε.
struct Conversion {
    /// Error of coefficients converted to Legendre, over Σ |A| |c|, entry by entry.
    there: f64,
    /// Error of coefficients converted from Legendre, over Σ |A⁻¹| |d|, entry by entry.
    back: f64,
    /// Error of coefficients converted there and back, in ε of 1.
    returned: f64,
    /// The largest entry of |A⁻¹| |A| |c| for |c_n| = 1.
    condition: f64,
}

fn conversion(a: u8, b: u8, count: usize) -> Conversion {
    let connection = Connection::new(a, b);
    let unit = |n: usize| (0..count).map(|k| Fixed::new(i64::from(k == n))).collect::<Vec<Fixed>>();
    let columns: Vec<Vec<Fixed>> = (0..count).map(|n| connection.apply_inverse(&unit(n))).collect();
    let inverse_size = |d: &[Fixed]| -> Vec<Fixed> {
        let row = |k: usize| (0..count).fold(Fixed::new(0), |sum, n| sum + (&columns[n][k] * &d[n]).abs());
        (0..count).map(row).collect()
    };
    let mut worst = Conversion { there: 0.0, back: 0.0, returned: 0.0, condition: 0.0 };
    for seed in 1..=6 {
        // Multiples of the reciprocal of the plastic number, mod 1.
        let c: Vec<f64> = (0..count)
            .map(|n| ((n + 1) as f64 * 0.754_877_666 * f64::from(seed)).fract() * 2.0 - 1.0)
            .collect();
        let exact: Vec<Fixed> = c.iter().map(|&c| Fixed::float(c)).collect();
        let (mut there, mut back) = (c.clone(), c.clone());
        convert::to_legendre(a, b, &mut there);
        convert::from_legendre(a, b, &mut back);
        worst.there = worst.there.max(error(&there, &connection.apply(&exact), &connection.size(&exact)));
        worst.back = worst.back.max(error(&back, &connection.apply_inverse(&exact), &inverse_size(&exact)));
        convert::from_legendre(a, b, &mut there);
        worst.returned = worst.returned.max(error(&there, &exact, &vec![Fixed::new(1); count]));
    }
    let rows = inverse_size(&connection.size(&vec![Fixed::new(1); count]));
    worst.condition = rows.iter().map(Fixed::to_f64).fold(0.0, f64::max);
    worst
}

/// The largest error in ε of `size`, entry by entry.
fn error(ours: &[f64], exact: &[Fixed], size: &[Fixed]) -> f64 {
    let errors = ours.iter().zip(exact).zip(size).map(|((&v, exact), size)| {
        (Fixed::float(v) - exact.clone()).to_f64().abs() / size.to_f64() / f64::EPSILON
    });
    errors.fold(0.0, f64::max)
}

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    let gl = |_: Weight, x: &mut [f64], w: &mut [f64]| gauss::legendre(x, w).expect("equal slices");
    let fast = |_: Weight, x: &mut [f64], w: &mut [f64]| gauss::legendre_asymptotic(x, w).expect("n > 100");
    let gj =
        |weight: Weight, x: &mut [f64], w: &mut [f64]| gauss::jacobi(weight, x, w).expect("equal slices");
    let plain = [(0.0, 0.0)];
    let whole = [(0.0, 2.0), (2.0, 0.0), (2.0, 2.0), (0.0, 30.0), (30.0, 17.0)];
    let broken = [(0.5, 0.5), (1.5, 0.25), (-0.3, -0.7), (0.3, -0.3), (-0.9, -0.9), (-0.95, 8.5)];
    let few: Vec<usize> = (1..=33).collect();

    writeln!(out, "Gauss rules: worst error of nodes and weights, ulp")?;
    let mut line = |name: &str, (x, w): (f64, f64), others: &str| {
        writeln!(out, "  {name:<38} {x:6.3} {w:6.3}   {others}")
    };
    line(
        "Legendre, n ≤ 33",
        rules(&plain, &few, gl),
        "gauss-quad 22, 0.5 · bilby 1.0, 126 · scipy 7.6, 2880 · GSL 0.94, 239",
    )?;
    line(
        "Legendre, n = 50 … 101",
        rules(&plain, &[50, 64, 99, 100, 101], gl),
        "gauss-quad 36, 1.4 · bilby 26, 629 · scipy 20, 4e4 · GSL 1.9, 1e6",
    )?;
    line(
        "Legendre, n = 256, 513, 1000",
        rules(&plain, &[256, 513, 1000], gl),
        "gauss-quad 572, 2.2 · bilby 215, 2.2 · scipy 99, 8e7 · GSL 4, 2e9",
    )?;
    line("Legendre asymptotic, n = 101 … 1000", rules(&plain, &[101, 256, 513, 1000], fast), "the same")?;
    line(
        "Jacobi, whole exponents, n ≤ 100",
        rules(&whole, &[1, 2, 3, 5, 8, 20, 33, 64, 100], gj),
        "weights: gauss-quad 4e5 to total loss · bilby 240 … 1e4 · scipy 7e5",
    )?;
    line(
        "Jacobi, any exponents, n ≤ 100",
        rules(&broken, &[1, 2, 3, 5, 8, 20, 33, 64, 100], gj),
        "weights: the same; gauss-quad NaN at α + β = −1",
    )?;

    writeln!(out, "\nValues, n ≤ 32, to one bit from ±1: worst error in ε of √(p_n² + p_{{n−1}}²)")?;
    for ((alpha, beta), others) in [
        ((0.0, 0.0), "scipy 182 · three-term recurrence 72"),
        ((0.0, 2.0), "scipy 48 · three-term recurrence 34"),
        ((2.0, 0.0), "scipy 86 · three-term recurrence 21"),
        ((2.0, 2.0), "scipy 39 · three-term recurrence 17"),
        ((-0.9, -0.9), "scipy 3200 · three-term recurrence 16000"),
    ] {
        writeln!(
            out,
            "  {:<38} {:6.2}            {others}",
            format!("({alpha}, {beta})"),
            values(alpha, beta)
        )?;
    }
    let mut ends = [0.0; 33];
    legendre::orthonormal(1.0, &mut ends);
    let exact = ends.iter().enumerate().all(|(n, p)| *p == (n as f64 + 0.5).sqrt());
    writeln!(out, "  Legendre at ±1 correctly rounded: {exact}")?;

    writeln!(
        out,
        "\nConversion, d = A c: worst error in ε of Σ|A||c| there, of Σ|A⁻¹||d| back, of 1 there and back,"
    )?;
    writeln!(out, "and the largest entry of |A⁻¹||A||c|, |c_n| = 1")?;
    for (a, b) in
        [(0, 1), (1, 0), (0, 2), (1, 1), (2, 2), (5, 5), (3, 7), (7, 3), (10, 10), (0, 10), (20, 20)]
    {
        for n in [30, 60, 100] {
            let Conversion { there, back, returned, condition } = conversion(a, b, n + 1);
            writeln!(
                out,
                "  {:<38} {there:6.2} {back:6.2} {returned:9.1e} {condition:9.2e}",
                format!("({a}, {b}), n ≤ {n}")
            )?;
        }
    }
    Ok(())
}
