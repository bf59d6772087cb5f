//! Light of the first K reflections: powers of the reflectance in a furnace, and a series that rises to all
//! light.

use radiosity::Basis;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::solve::gather::Gather;
use radiosity::solve::gather::ray_gather::{Beyond, RayGather};
use radiosity::solve::gather::receiver::Receiver;
use radiosity::solve::{Direct, Options, Outcome};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{builtin, material};
use radiosity_test_support::solved::outcome_of;

/// 1 + ρ + … + ρᴷ.
fn series(reflectance: f64, bounces: usize) -> f64 {
    (0..=bounces).map(|k| reflectance.powi(k as i32)).sum()
}

#[test]
fn a_furnace_sums_powers_of_its_reflectance() {
    let cube = builtin("furnace-cube");
    for reflectance in [0.2, 0.5, 0.8] {
        let material = material(reflectance, 1.0);
        let scene = cube.with_material("wall", material).expect("walls are of it");
        for (basis, direct) in [
            (Basis::Legendre, Direct::Projected),
            (Basis::Legendre, Direct::Split),
            (Basis::Constant, Direct::Projected),
            (Basis::Linear, Direct::Auto),
            (Basis::Harmonic, Direct::Split),
        ] {
            for bounces in [0, 1, 2, 5] {
                let options = Options {
                    basis,
                    direct,
                    bounces: Some(bounces),
                    order: 1,
                    eps: 1e-6,
                    ..Options::default()
                };
                let outcome = outcome_of(&scene, &options);
                let expected = series(reflectance, bounces);
                for surface in 0..scene.surfaces.len() {
                    let found = outcome.solution.mean_irradiance(0, surface);
                    assert!((found / expected - 1.0).abs() < 3e-3, "{basis:?} {direct:?} {bounces}: {found}");
                }
                // What is left out next, over what is known: the emission, and direct light reflected once if
                // it is split off.
                let known = if direct == Direct::Split { 1.0 + reflectance } else { 1.0 };
                let next = reflectance.powi(bounces as i32 + 2) / known;
                assert!((outcome.residual / next - 1.0).abs() < 2e-2, "{}", outcome.residual);
            }
        }
    }
}

#[test]
fn gathered_light_counts_the_same_reflections() {
    let scene = builtin("furnace-cube");
    for bounces in 0..4 {
        let options = Options { bounces: Some(bounces), order: 1, eps: 1e-6, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        let visibility = options.visibility(&scene);
        let middle = ReceiverPoint::free(DVec3::new(0.4, 0.5, 0.6), DVec3::Z);
        let expected = series(0.5, bounces);
        for gather in [Gather::new, Gather::twice] {
            let found = gather(&outcome.solution, &visibility, 1e-3).at(&middle)[0];
            assert!((found / expected - 1.0).abs() < 3e-3, "{bounces}: {found} {expected}");
        }
        let rays = RayGather::new(&outcome.solution, &visibility, 3e-3, Beyond::Gathered);
        let found = rays.read(&Receiver::Point(middle)).irradiance[0];
        assert!((found / expected - 1.0).abs() < 2e-2, "{bounces}: {found} {expected}");
    }
}

#[test]
fn light_rises_with_its_reflections_to_all_light() {
    for name in ["cornell-box", "two-boxes"] {
        let scene = builtin(name);
        for basis in [Basis::Legendre, Basis::Linear] {
            let options = |bounces| Options { basis, bounces, order: 1, eps: 1e-2, ..Options::default() };
            let means = |outcome: &Outcome| -> Vec<f64> {
                let surfaces = 0..scene.surfaces.len();
                surfaces.map(|surface| outcome.solution.mean_irradiance(0, surface)).collect()
            };
            let all = means(&outcome_of(&scene, &Options { tolerance: 1e-12, ..options(None) }));
            let mut before = vec![0.0; all.len()];
            let mut residual = f64::INFINITY;
            for bounces in [0, 1, 2, 4, 8, 16, 32, 64] {
                let outcome = outcome_of(&scene, &options(Some(bounces)));
                let own = means(&outcome);
                let tiny = 1e-9 * all.iter().copied().fold(0.0, f64::max);
                assert!(
                    own.iter().zip(&before).all(|(own, before)| own + tiny >= *before),
                    "{name} {bounces}"
                );
                assert!(own.iter().zip(&all).all(|(own, all)| *own <= all + tiny), "{name} {bounces}");
                assert!(outcome.residual < residual);
                (before, residual) = (own, outcome.residual);
            }
            let largest = all.iter().copied().fold(0.0, f64::max);
            let left = all.iter().zip(&before).map(|(all, own)| all - own).fold(0.0, f64::max);
            assert!(left < 1e-4 * largest, "{name}: {left}");
        }
    }
}
