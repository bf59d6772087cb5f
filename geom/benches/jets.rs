//! How fast are jets, shape by shape, compared with the arithmetic they cannot avoid?
//!
//! The yardsticks, in the same run: "affine" is one multiply-add per coordinate, "trigonometry" two
//! sine–cosine pairs, "tensor" the 4 × 4 sums of a bicubic position and its two tangents from given basis
//! values.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use radiosity_geom::{Jet, Surface};
use std::hint::black_box;
use std::time::Duration;

#[path = "../tests/geometry/gallery.rs"]
#[expect(dead_code, reason = "the conformance suite reads the other fields")]
mod gallery;

const COUNT: usize = 1024;

fn jets(c: &mut Criterion) {
    let at: Vec<[f64; 2]> =
        (0..COUNT).map(|k| [(k % 32) as f64 / 16.0 - 0.97, (k / 32) as f64 / 16.0 - 0.97]).collect();
    let mut group = c.benchmark_group("jets");
    group
        .throughput(Throughput::Elements(COUNT as u64))
        .sample_size(10)
        .measurement_time(Duration::from_secs(1));
    group.warm_up_time(Duration::from_millis(300));
    let mut points = vec![DVec3::ZERO; COUNT];
    group.bench_function("yardstick affine", |b| b.iter(|| affine(black_box(&at), &mut points)));
    group.bench_function("yardstick trigonometry", |b| b.iter(|| trigonometry(black_box(&at), &mut points)));
    group.bench_function("yardstick tensor", |b| b.iter(|| tensor(black_box(&at), &mut points)));
    for exhibit in gallery::gallery() {
        let mut out = vec![exhibit.surface.jet(0.0, 0.0); COUNT];
        group.bench_function(exhibit.name, |b| b.iter(|| many(&*exhibit.surface, black_box(&at), &mut out)));
    }
}

fn many(surface: &dyn Surface, at: &[[f64; 2]], out: &mut [Jet]) {
    surface.jets(at, out);
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
