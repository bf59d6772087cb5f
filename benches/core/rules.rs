//! Time of a Gauss rule, compared with other crates.
//!
//! Groups are questions; within a group the lines are comparable. The peers allocate, this crate writes into
//! slices. `bilby` needs a newer compiler than this workspace promises; it is a dependency of the benches
//! only.

use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, criterion_group, criterion_main};
use gauss_quad::{FiniteAboveNegOneF64, GaussJacobi, GaussLegendre};
use radiosity_core::gauss::{self, Legendre};
use radiosity_core::jacobi::Weight;

fn group<'a>(criterion: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group
}

fn size(n: usize) -> NonZeroUsize {
    NonZeroUsize::new(n).expect("at least one point")
}

fn legendre_in_time(criterion: &mut Criterion) {
    let mut group = group(criterion, "Gauss-Legendre, correctly rounded");
    for n in [5, 20, 64, 100, 1000] {
        let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
        group.bench_function(BenchmarkId::new("ours", n), |b| {
            b.iter(|| gauss::legendre(black_box(&mut x), &mut w));
        });
        group.bench_function(BenchmarkId::new("bilby", n), |b| {
            b.iter(|| bilby::GaussLegendre::new(black_box(n)));
        });
        group.bench_function(BenchmarkId::new("gauss-quad", n), |b| {
            b.iter(|| GaussLegendre::new(black_box(size(n))));
        });
    }
    group.bench_function("ours, const/20", |b| {
        b.iter(|| black_box((const { &Legendre::<20>::NODES }, const { &Legendre::<20>::WEIGHTS })));
    });
}

fn legendre_of_many_points(criterion: &mut Criterion) {
    let mut group = group(criterion, "Gauss-Legendre, asymptotic");
    for n in [101, 1000, 100_000] {
        let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
        group.bench_function(BenchmarkId::new("ours", n), |b| {
            b.iter(|| gauss::legendre_asymptotic(black_box(&mut x), &mut w));
        });
        group.bench_function(BenchmarkId::new("bilby", n), |b| {
            b.iter(|| bilby::GaussLegendre::new(black_box(n)));
        });
        group.bench_function(BenchmarkId::new("gauss-quad", n), |b| {
            b.iter(|| GaussLegendre::new(black_box(size(n))));
        });
    }
}

fn jacobi_in_time(criterion: &mut Criterion) {
    let exponent = |v| FiniteAboveNegOneF64::new(v).expect("above −1");
    for (alpha, beta) in [(0.0, 2.0), (2.0, 2.0), (0.3, -0.6)] {
        let weight = Weight::new(alpha, beta).expect("above −1");
        let mut group = group(criterion, &format!("Gauss-Jacobi ({alpha}, {beta})"));
        for n in [5, 20, 100, 1000] {
            let (mut x, mut w) = (vec![0.0; n], vec![0.0; n]);
            group.bench_function(BenchmarkId::new("ours", n), |b| {
                b.iter(|| gauss::jacobi(black_box(weight), &mut x, &mut w));
            });
            group.bench_function(BenchmarkId::new("bilby", n), |b| {
                b.iter(|| bilby::GaussJacobi::new(black_box(n), alpha, beta));
            });
            // Half a second a rule at n = 1000, and for odd n its middle node is wrong unless α = β.
            if n < 1000 {
                group.bench_function(BenchmarkId::new("gauss-quad", n), |b| {
                    b.iter(|| GaussJacobi::new(black_box(size(n)), exponent(alpha), exponent(beta)));
                });
            }
        }
    }
}

criterion_group!(benches, legendre_in_time, legendre_of_many_points, jacobi_in_time);
criterion_main!(benches);
