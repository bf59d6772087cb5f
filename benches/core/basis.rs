//! Time of one basis value, in tiles and at single points.
//!
//! Every line evaluates the same 1024 points; divide by 1024 × the number of functions for the cost of a
//! value. Tiles are consumed at once (summed), as assembly consumes them: nothing is written to memory.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use radiosity_core::basis::{total, triangle};
use radiosity_core::legendre;

const POINTS: usize = 1024;

/// Orders 0 … 8: nine functions.
const N: usize = 9;

fn points() -> Vec<f64> {
    (0..POINTS).map(|i| (i as f64 * 0.754_877_666).fract() * 2.0 - 1.0).collect()
}

/// Adds up all rows, so that none is optimised away.
fn consume<const W: usize>(rows: &[[f64; W]], sum: &mut [f64; W]) {
    for row in rows {
        for l in 0..W {
            sum[l] += row[l];
        }
    }
}

/// The textbook loop: one point at a time, P_n by its recurrence, times its norm.
fn textbook(x: f64, out: &mut [f64; N]) {
    let (mut before, mut last) = (0.0, 1.0);
    for (n, p) in out.iter_mut().enumerate() {
        let n = n as f64;
        *p = (n + 0.5).sqrt() * last;
        (before, last) = (last, ((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0));
    }
}

fn tiles<const W: usize>(x: &[f64]) -> [f64; W] {
    let (mut sum, mut out) = ([0.0; W], [[0.0; W]; N]);
    for x in x.as_chunks().0 {
        legendre::tile(x, &mut out);
        consume(&out, &mut sum);
    }
    sum
}

fn tiles_with_derivatives<const W: usize>(x: &[f64]) -> [f64; W] {
    let (mut sum, mut out, mut slopes) = ([0.0; W], [[0.0; W]; N], [[0.0; W]; N]);
    for x in x.as_chunks().0 {
        legendre::tile_with_derivatives(x, &mut out, &mut slopes);
        consume(&out, &mut sum);
        consume(&slopes, &mut sum);
    }
    sum
}

fn tiles_anchored<const W: usize>(x: &[f64]) -> [f64; W] {
    let (mut sum, mut out) = ([0.0; W], [[0.0; W]; N]);
    for x in x.as_chunks().0 {
        legendre::tile_anchored(x, &mut out);
        consume(&out, &mut sum);
    }
    sum
}

fn sums<const W: usize>(f: &[f64; N], x: &[f64]) -> [f64; W] {
    let mut sum = [0.0; W];
    for x in x.as_chunks().0 {
        consume(&[legendre::sum_tile(f, x)], &mut sum);
    }
    sum
}

fn singly(x: &[f64], evaluate: impl Fn(f64, &mut [f64; N])) -> [f64; 1] {
    let (mut sum, mut out) = ([0.0], [0.0; N]);
    for &x in x {
        evaluate(x, &mut out);
        consume(out.as_chunks().0, &mut sum);
    }
    sum
}

fn order_8_in_one_variable(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("Legendre to order 8, 1024 points");
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let x = points();
    let f = [0.5; N];
    group.bench_function("tiles of 8", |b| b.iter(|| tiles::<8>(black_box(&x))));
    group.bench_function("tiles of 16", |b| b.iter(|| tiles::<16>(black_box(&x))));
    group.bench_function("tiles of 8 with derivatives", |b| {
        b.iter(|| tiles_with_derivatives::<8>(black_box(&x)))
    });
    group.bench_function("anchored tiles of 16", |b| b.iter(|| tiles_anchored::<16>(black_box(&x))));
    group.bench_function("Clenshaw sums, 16 lanes", |b| b.iter(|| sums::<16>(black_box(&f), black_box(&x))));
    group.bench_function("single points, anchored", |b| {
        b.iter(|| singly(black_box(&x), |x, out| legendre::orthonormal(x, out)));
    });
    group.bench_function("textbook loop", |b| b.iter(|| singly(black_box(&x), textbook)));
}

fn two_variables(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("total degree ≤ 8, 45 functions, 1024 points");
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let x = points();
    let y: Vec<f64> = x.iter().map(|x| -0.5 - 0.4 * x).collect();
    let pairs = || x.as_chunks::<16>().0.iter().zip(y.as_chunks::<16>().0);
    group.bench_function("square, tiles of 16", |b| {
        b.iter(|| {
            let (mut sum, mut out) = ([0.0; 16], [[0.0; 16]; total::count(8)]);
            for (s, t) in pairs() {
                total::tile::<9, 16>(black_box(s), t, &mut out);
                consume(&out, &mut sum);
            }
            sum
        });
    });
    group.bench_function("triangle, tiles of 16", |b| {
        b.iter(|| {
            let (mut sum, mut out) = ([0.0; 16], [[0.0; 16]; total::count(8)]);
            for (s, t) in pairs() {
                triangle::tile(8, black_box(s), t, &mut out);
                consume(&out, &mut sum);
            }
            sum
        });
    });
}

criterion_group!(benches, order_8_in_one_variable, two_variables);
criterion_main!(benches);
