//! Time of a conversion between Jacobi and Legendre coefficients.
//!
//! Every line copies the coefficients and converts them in place. The textbook's steps lower one exponent by
//! one in the classical polynomials, in plain floats: twice as many, with two divisions a term, and they
//! cancel.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use radiosity_core::convert;

/// ‖P_n^(a,b)‖ = √(2^{a+b+1}/(2n + a + b + 1) · Π_{j=1…b} (n + j)/(n + a + j)).
fn norm(a: u8, b: u8, n: usize) -> f64 {
    let (a, b, n) = (f64::from(a), f64::from(b), n as f64);
    let start = 2.0f64.powf(a + b + 1.0) / (2.0 * n + a + b + 1.0);
    (1..=b as usize).fold(start, |square, j| square * (n + j as f64) / (n + a + j as f64)).sqrt()
}

/// P_k^(α,β) in P_j^(α−1,β), `sign` 1, or P_j^(α,β−1), `sign` −1; `sum` is α + β, `other` the exponent that
/// stays.
fn lower(c: &mut [f64], sum: usize, other: usize, sign: f64) {
    let mut carried = 0.0;
    for (k, c) in c.iter_mut().enumerate().rev() {
        let share = (*c + carried) / (k + sum) as f64;
        carried = sign * (k + other) as f64 * share;
        *c = (2 * k + sum) as f64 * share;
    }
}

fn textbook(a: u8, b: u8, c: &mut [f64]) {
    c.iter_mut().enumerate().for_each(|(n, c)| *c /= norm(a, b, n));
    for beta in (1..=usize::from(b)).rev() {
        lower(c, usize::from(a) + beta, a.into(), -1.0);
    }
    for alpha in (1..=usize::from(a)).rev() {
        lower(c, alpha, 0, 1.0);
    }
    c.iter_mut().enumerate().for_each(|(n, c)| *c *= norm(0, 0, n));
}

fn conversion_in_time(criterion: &mut Criterion) {
    for (a, b, n) in [(0, 2, 8), (2, 2, 30), (3, 7, 60), (10, 10, 60), (20, 20, 100)] {
        let mut group = criterion.benchmark_group(format!("Jacobi ({a}, {b}) and Legendre"));
        group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
        let c: Vec<f64> = (0..=n).map(|k| ((k + 1) as f64 * 0.754_877_666).fract() * 2.0 - 1.0).collect();
        let mut place = c.clone();
        let mut line = |name: &str, turn: fn(u8, u8, &mut [f64])| {
            group.bench_function(BenchmarkId::new(name, n), |bench| {
                bench.iter(|| {
                    place.copy_from_slice(&c);
                    turn(black_box(a), black_box(b), black_box(&mut place));
                });
            });
        };
        line("to Legendre", convert::to_legendre);
        line("from Legendre", convert::from_legendre);
        line("to Legendre, textbook", textbook);
    }
}

criterion_group!(benches, conversion_in_time);
criterion_main!(benches);
