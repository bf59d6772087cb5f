//! Time of a jet, shape by shape, compared with the arithmetic that it cannot avoid.
//!
//! The yardsticks, in the same run: "affine" is one multiply-add per coordinate, "trigonometry" two
//! sine–cosine pairs, "tensor" the 4 × 4 sums of a bicubic position and its two tangents from given basis
//! values.

#![expect(clippy::print_stdout, reason = "the table of fastest rounds is a result")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use radiosity_geom::{Jet, Surface};
use radiosity_test_support::gallery::gallery;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Jets per tile.
const COUNT: usize = 1024;

/// A named way to fill a tile.
type Way<'a> = (&'static str, Box<dyn FnMut() + 'a>);

fn jets(c: &mut Criterion) {
    let at: Vec<[f64; 2]> =
        (0..COUNT).map(|k| [(k % 32) as f64 / 16.0 - 0.97, (k / 32) as f64 / 16.0 - 0.97]).collect();
    let exhibits = gallery();
    let mut ways: Vec<Way> = vec![
        ("yardstick affine", points(&at, affine)),
        ("yardstick trigonometry", points(&at, trigonometry)),
        ("yardstick tensor", points(&at, tensor)),
    ];
    for exhibit in &exhibits {
        let (surface, at) = (&*exhibit.surface, &at);
        let mut out = vec![surface.jet(0.0, 0.0); COUNT];
        ways.push((exhibit.name, Box::new(move || many(surface, black_box(at), &mut out))));
    }
    let mut group = c.benchmark_group("jets");
    group
        .throughput(Throughput::Elements(COUNT as u64))
        .sample_size(10)
        .measurement_time(Duration::from_millis(500));
    group.warm_up_time(Duration::from_millis(200));
    for (name, way) in &mut ways {
        group.bench_function(*name, |b| b.iter(&mut *way));
    }
    fastest(&mut ways);
}

fn points<'a>(at: &'a [[f64; 2]], fill: fn(&[[f64; 2]], &mut [DVec3])) -> Box<dyn FnMut() + 'a> {
    let mut out = vec![DVec3::ZERO; COUNT];
    Box::new(move || {
        fill(black_box(at), &mut out);
        black_box(&out);
    })
}

/// The fastest of 300 rounds of each way, the ways taking turns, against noise.
fn fastest(ways: &mut [Way]) {
    let mut best = vec![f64::INFINITY; ways.len()];
    for _ in 0..300 {
        for ((_, way), best) in ways.iter_mut().zip(&mut best) {
            let start = Instant::now();
            way();
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    for ((name, _), best) in ways.iter().zip(&best) {
        println!("{name}: {:.1} ns", 1e9 * best / COUNT as f64);
    }
}

fn many(surface: &dyn Surface, at: &[[f64; 2]], out: &mut [Jet]) {
    for ([u, v], jet) in at.iter().zip(&mut *out) {
        *jet = surface.jet(*u, *v);
    }
    black_box(out);
}

fn affine(at: &[[f64; 2]], out: &mut [DVec3]) {
    let (a, b, c) = (black_box(DVec3::ONE), black_box(DVec3::X), black_box(DVec3::Y));
    for ([u, v], x) in at.iter().zip(out) {
        *x = a + *u * b + *v * c;
    }
}

fn trigonometry(at: &[[f64; 2]], out: &mut [DVec3]) {
    for ([u, v], x) in at.iter().zip(out) {
        let ((a, b), (c, d)) = (u.sin_cos(), v.sin_cos());
        *x = DVec3::new(b * d, a * d, b * c);
    }
}

fn tensor(at: &[[f64; 2]], out: &mut [DVec3]) {
    let net = black_box([[DVec3::ONE; 4]; 4]);
    for ([u, v], x) in at.iter().zip(out) {
        let (p, q) = ([*u, 1.0 - u, u * u, *v], [*v, 1.0 - v, v * v, *u]);
        let rows = net.map(|row| (sum(&row, &p), sum(&row, &q)));
        let (values, slopes) = (rows.map(|r| r.0), rows.map(|r| r.1));
        *x = sum(&values, &q) + sum(&values, &p).cross(sum(&slopes, &q));
    }
}

fn sum(points: &[DVec3; 4], weights: &[f64; 4]) -> DVec3 {
    points.iter().zip(weights).map(|(p, w)| *w * *p).sum()
}

criterion_group!(benches, jets);
criterion_main!(benches);
